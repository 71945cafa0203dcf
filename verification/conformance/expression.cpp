// SPDX-License-Identifier: Apache-2.0
#include "conformance/expression.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

#include "conformance/misread.hpp"

namespace tribo::conformance {
namespace {

using Op = Expression::Op;
using Call = Expression::Call;
using Operand = Expression::Operand;
constexpr std::size_t most_nodes = 96;

struct Called {
  const char* before;
  const char* after;
  double (*of)(double);
};
// In the order of Call.
constexpr std::array calls{
    Called{"e^(", ")", [](double x) { return std::exp(x); }},
    Called{"10^(", ")", [](double x) { return std::pow(10, x); }},
    Called{"ln(", ")", [](double x) { return std::log(x); }},
    Called{"log₁₀(", ")", [](double x) { return std::log10(x); }},
    Called{"atan(", ")", [](double x) { return std::atan(x); }},
    Called{"atan(1/(", "))", [](double x) { return std::atan(1 / x); }},
    Called{"atan in degrees (", ")",
           [](double x) { return std::atan(x) * 180 / std::numbers::pi; }},
    Called{"tan(", ")", [](double x) { return std::tan(x); }},
    Called{"erf(", ")", [](double x) { return std::erf(x); }},
    Called{"erfc(", ")", [](double x) { return std::erfc(x); }},
    Called{"tanh(", ")", [](double x) { return std::tanh(x); }},
    Called{"|", "|", [](double x) { return std::abs(x); }},
    Called{"(", ")", [](double x) { return x; }},
    Called{"", " rounded to {:.0f} decimals", nullptr},
    Called{"", " rounded to {:.0f} digits", nullptr},
    Called{"the whole part of ", "", [](double x) { return std::trunc(x); }}};
const Called& call_of(Call call) { return calls[static_cast<std::size_t>(call)]; }

// The functions that people write in place of this one.
std::vector<Call> others_than(Call call) {
  switch (call) {
    case Call::exponential:
      return {Call::power_of_ten, Call::itself};
    case Call::logarithm:
      return {Call::decimal_logarithm, Call::itself};
    case Call::arc:
      return {Call::arc_of_inverse, Call::arc_in_degrees, Call::tangent, Call::itself};
    case Call::error:
      return {Call::error_complement, Call::hyperbolic_tangent, Call::itself};
    default:
      return {Call::itself};
  }
}

class Evaluation {
 public:
  Evaluation(const Expression& law, const catalogue::Arguments& arguments)
      : law_(law), arguments_(arguments) {
    known_.fill(false);
  }
  double of(std::size_t place) {
    if (known_[place]) return values_[place];
    known_[place] = true;
    return values_[place] = computed(law_.nodes[place]);
  }
  // Forgets the values of these nodes, because a number of the law has changed.
  void compute_anew(const std::vector<std::size_t>& places) {
    for (const std::size_t place : places) known_[place] = false;
  }

 private:
  double computed(const Expression::Node& node) {
    double value = node.number;
    switch (node.kind) {
      case Op::given:
        return node.get(arguments_);
      case Op::sum:
        for (const auto& [part, times] : node.parts)
          if (times != 0) value += times * of(part);
        return value;
      case Op::product:
        for (const auto& [part, exponent] : node.parts) value *= raised(part, exponent);
        return value;
      case Op::power:
        return std::pow(of(node.parts[0].of), of(node.parts[1].of));
      case Op::call:
        return called(node, of(node.parts[0].of));
      default:
        return of(node.parts[static_cast<std::size_t>(node.get(arguments_))].of);
    }
  }
  static double called(const Expression::Node& node, double x) {
    if (node.called == Call::to_digits) return of_digits(x, static_cast<int>(node.number));
    if (node.called != Call::to_decimals) return call_of(node.called).of(x);
    const double whole = std::pow(10, node.number);
    return std::nearbyint(x * whole) / whole;
  }
  double raised(std::size_t part, double exponent) {
    if (exponent == 0) return 1;
    const double x = of(part);
    if (exponent == 0.5) return std::sqrt(std::max(x, 0.0));  // as a solver guards its root
    return exponent == 1    ? x
           : exponent == -1 ? 1 / x
           : exponent == 2  ? x * x
                            : std::pow(x, exponent);
  }

  const Expression& law_;
  const catalogue::Arguments& arguments_;
  std::array<double, most_nodes> values_;
  std::array<bool, most_nodes> known_;
};

// --- Edits

// One change of a node: of its number, of the number or the node of a part, or of its function.
struct Edit {
  std::size_t node;
  int slot;  // of the part; −1: the node's own number or function
  std::optional<double> number = {};
  std::optional<std::size_t> part = {};
  std::optional<Call> called = {};
  std::vector<Expression::Node> whole = {};  // the node's replacement, then nodes to add
  std::size_t added_at = 0;                  // the place of the first added node

  void apply(Expression& law) const {
    Expression::Node& of = law.nodes[node];
    const auto at = static_cast<std::size_t>(slot);
    if (!whole.empty()) {
      std::string name = std::move(of.name);
      of = whole.front();
      of.name = std::move(name);
      const std::size_t moved = law.nodes.size() - added_at;
      law.nodes.insert(law.nodes.end(), whole.begin() + 1, whole.end());
      for (std::size_t i = added_at + moved; moved > 0 && i <= law.nodes.size(); ++i)
        for (Operand& operand : law.nodes[i == law.nodes.size() ? node : i].parts)
          if (operand.of >= added_at) operand.of += moved;
    } else if (called)
      of.called = *called;
    else if (part)
      of.parts[at].of = *part;
    else
      law.number_at({node, slot}) = *number;
  }
};

std::string change_in_words(const Expression& law, const Expression& changed, const Edit& one) {
  const Expression::Node &node = law.nodes[one.node], &now = changed.nodes[one.node];
  const bool is_sum = node.kind == Op::sum;
  const std::string whole = law.in_words(one.node, true);
  std::string text;
  if (one.whole.size() == 1 && one.whole[0].kind == Op::sum && one.whole[0].parts.empty())
    return fmt::format("{} in place of {}", number_in_words(one.whole[0].number), node.name);
  if (!one.whole.empty() && one.whole[0].kind == Op::call &&
      one.whole[0].called >= Call::to_decimals) {
    const Called& call = call_of(one.whole[0].called);
    return fmt::format("{}{}{}", call.before, node.name,
                       fmt::format(fmt::runtime(call.after), one.whole[0].number));
  }
  if (!one.whole.empty() || one.called || node.kind == Op::power)
    text = fmt::format("{} in place of {}", changed.in_words(one.node, true), whole);
  else if (one.slot < 0) {
    const std::string old = number_in_words(node.number);
    const bool is_gone = now.number == (is_sum ? 0 : 1);
    text = is_gone ? fmt::format("no {} {}", is_sum ? "term" : "factor", old)
                   : fmt::format("{} in place of {}", number_in_words(now.number), old);
  } else {
    const Operand &before = node.parts[static_cast<std::size_t>(one.slot)],
                  &after = now.parts[static_cast<std::size_t>(one.slot)];
    const std::string old = is_sum ? law.term_in_words(before) : law.factor_in_words(before);
    text = after.number == 0
               ? fmt::format("no {} {}", is_sum ? "term" : "factor", old)
               : fmt::format("{} in place of {}",
                             is_sum ? changed.term_in_words(after) : changed.factor_in_words(after),
                             old);
  }
  constexpr std::size_t longest = 60;
  if (!one.whole.empty() || one.called) return text;
  if (!node.name.empty()) return text + ", in " + node.name;
  return whole.size() <= longest ? text + ", in " + whole : text;
}

class Edits {
 public:
  explicit Edits(const Expression& law) : law_(law) {
    for (std::size_t i = 0; i < law.nodes.size(); ++i) {
      const Expression::Node& node = law.nodes[i];
      if (node.kind == Op::sum) of_sum(i, node);
      if (node.kind == Op::product) of_product(i, node);
      if (node.kind == Op::call) of_call(i, node);
      if (node.kind == Op::power) of_power(i, node);
      if (node.kind != Op::choice && node.kind != Op::given) of_parts(i, node);
    }
  }
  std::vector<Edit> take() { return std::move(all_); }
  // The same change in two nodes of one form, such as (1 − ν²)/E of both bodies.
  std::vector<std::pair<Edit, Edit>> pairs_alike() const {
    std::map<std::size_t, std::vector<Edit>> by_node;
    std::map<std::string, std::vector<std::size_t>> alike;
    for (const Edit& one : all_)
      if (!one.part) by_node[one.node].push_back(one);
    for (const auto& one : by_node) alike[shape_of(one.first)].push_back(one.first);
    std::vector<std::pair<Edit, Edit>> pairs;
    for (const auto& [shape, places] : alike)
      for (std::size_t i = 0; places.size() == 2 && i < by_node[places[0]].size(); ++i)
        if (by_node[places[0]].size() == by_node[places[1]].size())
          pairs.emplace_back(by_node[places[0]][i], by_node[places[1]][i]);
    return pairs;
  }

 private:
  // How a node is written, without the marks of bodies and axes.
  std::string shape_of(std::size_t place) const {
    std::string text = law_.in_words(place, true);
    for (const std::string_view mark : {"₁", "₂", "x", "y"})
      for (std::size_t at = 0; (at = text.find(mark)) != std::string::npos;)
        text.erase(at, mark.size());
    return text;
  }
  void set(std::size_t node, std::size_t slot, double number) {
    all_.push_back({.node = node, .slot = static_cast<int>(slot), .number = number});
  }
  void set_own(std::size_t node, double number) {
    if (number != law_.nodes[node].number)
      all_.push_back({.node = node, .slot = -1, .number = number});
  }
  void put(std::size_t place, std::vector<Expression::Node> whole) {
    all_.push_back(
        {.node = place, .slot = -1, .whole = std::move(whole), .added_at = law_.nodes.size()});
  }
  // f(a b) as f(a) b, and f(a + b) as f(a) + b.
  void of_call(std::size_t place, const Expression::Node& node) {
    for (const Call other : others_than(node.called))
      all_.push_back({.node = place, .slot = -1, .called = other});
    const Expression::Node& inner = law_.nodes[node.parts[0].of];
    if (inner.kind != Op::product && inner.kind != Op::sum) return;
    const std::size_t called = law_.nodes.size();
    const double nothing = inner.kind == Op::product ? 1 : 0;
    // One part, or the number, goes outside alone, or stays inside alone.
    for (std::size_t i = 0; i <= inner.parts.size(); ++i)
      for (const bool is_outside : {true, false}) {
        Expression::Node outside{inner.kind, nothing}, inside{inner.kind, nothing};
        for (std::size_t k = 0; k < inner.parts.size(); ++k)
          ((k == i) == is_outside ? outside : inside).parts.push_back(inner.parts[k]);
        ((i == inner.parts.size()) == is_outside ? outside : inside).number = inner.number;
        if ((inside.parts.empty() && inside.number == nothing) ||
            (outside.parts.empty() && outside.number == nothing))
          continue;
        outside.parts.push_back({called, 1});
        Expression::Node call = node;
        call.name.clear();
        call.parts = {{called + 1, 1}};
        put(place, {std::move(outside), std::move(call), std::move(inside)});
      }
  }
  // (a b)^g as a b^g, and (a + b)^g as a + b^g.
  void of_power(std::size_t place, const Expression::Node& node) {
    const Expression::Node& base = law_.nodes[node.parts[0].of];
    if (base.kind != Op::product && base.kind != Op::sum) return;
    for (std::size_t i = 0; i < base.parts.size(); ++i) {
      Expression::Node left = base, raised = node;
      left.name.clear();
      raised.name.clear();
      raised.parts[0].of = base.parts[i].of;
      left.parts[i].of = law_.nodes.size();
      put(place, {std::move(left), std::move(raised)});
    }
  }
  // a + b as √(a² + b²), and the other way round.
  void as_norm(std::size_t place, const Expression::Node& node) {
    if (node.parts.size() != 2 || node.number != 0) return;
    std::vector<Expression::Node> added;
    Expression::Node squares{Op::sum};
    for (const auto& [of, times] : node.parts) {
      squares.parts.push_back({law_.nodes.size() + 1 + added.size(), times * times});
      added.push_back({Op::product, 1, {{of, 2}}});
    }
    added.insert(added.begin(), std::move(squares));
    added.insert(added.begin(), {Op::product, 1, {{law_.nodes.size(), 0.5}}});
    put(place, std::move(added));
  }
  void without_norm(std::size_t place, const Expression::Node& node) {
    if (node.parts.size() != 1 || node.parts[0].number != 0.5) return;
    const Expression::Node& squares = law_.nodes[node.parts[0].of];
    Expression::Node bare{Op::sum};
    for (const auto& [of, times] : squares.parts) {
      const Expression::Node& square = law_.nodes[of];
      const bool is_square = square.kind == Op::product && square.parts.size() == 1 &&
                             square.parts[0].number == 2 && square.number == 1;
      if (squares.kind != Op::sum || squares.number != 0 || !is_square || times != 1) return;
      bare.parts.push_back({square.parts[0].of, 1});
    }
    put(place, {std::move(bare)});
  }
  void of_sum(std::size_t place, const Expression::Node& node) {
    as_norm(place, node);
    if (node.number != 0 && std::abs(node.number) != 1) {
      Expression::Node over_number = node;  // c (1 + x) without c
      over_number.number = 1;
      for (Operand& part : over_number.parts) part.number /= node.number;
      put(place, {std::move(over_number)});
    }
    // a + b^n as (a + b)^n, and a + f(b) as f(a + b).
    for (std::size_t i = 0; i < node.parts.size() && node.parts.size() < 3; ++i) {
      const Expression::Node& inner = law_.nodes[node.parts[i].of];
      const bool is_power =
          inner.kind == Op::product && inner.parts.size() == 1 && inner.parts[0].number != 1;
      if ((!is_power && inner.kind != Op::call) || node.parts.size() + (node.number != 0) < 2)
        continue;
      Expression::Node bare = node, outer{Op::product, 1};
      bare.name.clear();
      bare.parts[i].of = inner.parts[0].of;
      if (is_power)
        outer.parts = {{law_.nodes.size(), inner.parts[0].number}};
      else
        outer = {Op::call, 0, {{law_.nodes.size(), 1}}, {}, inner.called};
      put(place, {std::move(outer), std::move(bare)});
    }
    if (node.number != 0)
      for (const double times : {-1.0, 0.0, 2.0, 0.5}) set_own(place, times * node.number);
    for (std::size_t i = 0; i < node.parts.size(); ++i)
      for (const double times : {-1.0, 0.0, 2.0, 0.5}) set(place, i, times * node.parts[i].number);
  }
  void of_product(std::size_t place, const Expression::Node& node) {
    without_norm(place, node);
    set_own(place, std::copysign(1, node.number));
    set_own(place, 1 / node.number);
    if (node.number != 1) set_own(place, -node.number);
    set_own(place, 2 * node.number);
    set_own(place, node.number / 2);
    if (node.parts.size() == 1 && node.parts[0].number == 1 && std::abs(node.number) != 1)
      put(place, {{Op::product,  // c x as x^c
                   std::copysign(1, node.number),
                   {{node.parts[0].of, std::abs(node.number)}}}});
    // The inverse of the product, wherever the node is used.
    Expression::Node inverted = node;
    inverted.number = 1 / node.number;
    for (Operand& part : inverted.parts) part.number *= -1;
    if (node.parts.size() > 1) put(place, {std::move(inverted)});
    for (std::size_t i = 0; i < node.parts.size(); ++i) {
      const double exponent = node.parts[i].number;
      std::vector<double> others{0, -exponent, 2 * exponent, exponent / 2};
      for (const double one : {1.0, 1 / exponent})
        if (std::abs(one) != std::abs(exponent)) others.push_back(one);
      for (std::size_t k = 0; k < i; ++k) {  // exponents exchanged
        Expression::Node exchanged = node;
        std::swap(exchanged.parts[i].number, exchanged.parts[k].number);
        if (exponent != node.parts[k].number) put(place, {std::move(exchanged)});
      }
      for (const double one : others) set(place, i, one);
      const Expression::Node& inner = law_.nodes[node.parts[i].of];
      if (inner.kind == Op::sum && std::abs(exponent) == 1) without_parentheses(place, i);
      without_number_of(place, i);
      if (inner.kind == Op::product && exponent != 1 && inner.parts.size() > 1)
        power_of_one(place, i);
    }
  }
  // a (b + c) as a b + c, and (a + b) c as a + b c.
  void without_parentheses(std::size_t place, std::size_t slot) {
    const Expression::Node& node = law_.nodes[place];
    const std::size_t sum_place = node.parts[slot].of;
    const Expression::Node& sum = law_.nodes[sum_place];
    if (node.parts.size() < 2 && node.number == 1) return;
    struct Of {
      double number;
      std::optional<std::size_t> part;
    };
    std::vector<Of> terms;
    if (sum.number != 0) terms.push_back({sum.number, {}});
    for (const Operand& part : sum.parts) terms.push_back({part.number, part.of});
    // Terms may stand in any order, so each may be the one that is multiplied.
    for (std::size_t i = 0; terms.size() > 1 && i < terms.size(); ++i) {
      Expression::Node beside{Op::product, node.number}, left{Op::sum};
      for (std::size_t k = 0; k < node.parts.size(); ++k)
        if (k != slot) beside.parts.push_back(node.parts[k]);
      beside.number *= std::pow(terms[i].number, node.parts[slot].number);
      if (terms[i].part) beside.parts.push_back({*terms[i].part, node.parts[slot].number});
      left.parts.push_back({law_.nodes.size(), 1});
      for (std::size_t k = 0; k < terms.size(); ++k)
        if (k != i && terms[k].part)
          left.parts.push_back({*terms[k].part, terms[k].number});
        else if (k != i)
          left.number += terms[k].number;
      put(place, {std::move(left), std::move(beside)});
    }
  }
  // U in place of 2U, in this product alone.
  void without_number_of(std::size_t place, std::size_t slot) {
    const Expression::Node& inner = law_.nodes[law_.nodes[place].parts[slot].of];
    if (inner.kind != Op::product || inner.name.empty() || inner.name[0] != '2') return;
    Expression::Node changed = law_.nodes[place], bare = inner;
    bare.number /= 2;
    bare.name.erase(0, 1);
    changed.parts[slot].of = law_.nodes.size();
    put(place, {std::move(changed), std::move(bare)});
  }
  // (a b)^n as a b^n.
  void power_of_one(std::size_t place, std::size_t slot) {
    const Expression::Node& inner = law_.nodes[law_.nodes[place].parts[slot].of];
    for (const std::size_t of : {std::size_t{0}, inner.parts.size() - 1}) {
      Expression::Node changed = law_.nodes[place];
      changed.parts.erase(changed.parts.begin() + static_cast<std::ptrdiff_t>(slot));
      changed.number *= inner.number;
      for (std::size_t k = 0; k < inner.parts.size(); ++k)
        changed.parts.push_back(
            {inner.parts[k].of,
             inner.parts[k].number * (k == of ? law_.nodes[place].parts[slot].number : 1)});
      put(place, {std::move(changed)});
    }
  }
  // Another named node of the same unit in place of a named part.
  void of_parts(std::size_t place, const Expression::Node& node) {
    const std::vector<std::size_t> dependent = law_.dependent_on(place);
    for (std::size_t i = 0; i < node.parts.size(); ++i) {
      const Expression::Node& own = law_.nodes[node.parts[i].of];
      for (std::size_t k = 0; k < law_.nodes.size() && !own.name.empty(); ++k) {
        const Expression::Node& other = law_.nodes[k];
        if (other.name.empty() || other.name == own.name || other.unit != own.unit ||
            std::find(dependent.begin(), dependent.end(), k) != dependent.end())
          continue;
        all_.push_back({.node = place, .slot = static_cast<int>(i), .part = k});
      }
    }
  }

  const Expression& law_;
  std::vector<Edit> all_;
};

}  // namespace

std::string number_in_words(double number) {
  struct Known {
    double value;
    const char* name;
  };
  constexpr std::array known{Known{std::numbers::pi, "π"},
                             Known{0.75, "3/4"},
                             Known{1.5, "3/2"},
                             Known{1.0 / 3, "1/3"},
                             Known{2.0 / 3, "2/3"},
                             Known{4.0 / 3, "4/3"},
                             Known{std::numbers::sqrt2, "√2"},
                             Known{std::numbers::ln10, "ln 10"},
                             Known{7.0 / 3, "7/3"},
                             Known{2 * std::numbers::pi, "2π"},
                             Known{1 / std::numbers::pi, "1/π"},
                             Known{3 * std::numbers::pi, "3π"},
                             Known{4 / std::numbers::pi, "4/π"},
                             Known{6 * std::numbers::pi, "6π"}};
  for (const auto& [value, name] : known)
    if (std::abs(number / value - 1) < 1e-10) return name;
  const double of_pi = std::abs(number) / std::numbers::pi;
  const bool is_of_pi =
      std::abs(of_digits(of_pi, 4) / of_pi - 1) < 1e-10 && !is_of_few_digits(number);
  return fmt::format("{}{:.6g}{}", number < 0 ? "−" : "", is_of_pi ? of_pi : std::abs(number),
                     is_of_pi ? " π" : "");
}

std::vector<Expression::Place> Expression::places_of_numbers() const {
  std::vector<Place> places;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    if (node.kind != Op::product && node.kind != Op::sum) continue;
    if (node.number != 0 && (node.kind == Op::sum || std::abs(node.number) != 1))
      places.push_back({i, -1});
    for (std::size_t k = 0; k < node.parts.size(); ++k)
      if (node.parts[k].number != 0) places.push_back({i, static_cast<int>(k)});
  }
  return places;
}

double& Expression::number_at(const Place& place) {
  Node& node = nodes[place.node];
  return place.slot < 0 ? node.number : node.parts[static_cast<std::size_t>(place.slot)].number;
}

double Expression::value(std::size_t place, const catalogue::Arguments& arguments) const {
  return nodes.size() > most_nodes ? unsaid : Evaluation(*this, arguments).of(place);
}

std::string Expression::factor_in_words(const Operand& part) const {
  const Node& of = nodes[part.of];
  const double exponent = std::abs(part.number);
  std::string text = in_words(part.of);
  const bool is_written_out = of.name.empty();
  if (is_written_out && (of.kind == Op::sum || of.kind == Op::product || exponent != 1) &&
      !(of.kind == Op::call && exponent == 1))
    text = '(' + text + ')';
  if (exponent == 2)
    text += "²";
  else if (exponent == 3)
    text += "³";
  else if (exponent == 0.5)
    text = "√" + text;
  else if (exponent != 1) {
    const std::string number = number_in_words(exponent);
    text += number.find('/') == std::string::npos ? '^' + number : "^(" + number + ')';
  }
  return part.number < 0 ? "1/" + text : text;
}

std::string Expression::term_in_words(const Operand& part) const {
  const double times = std::abs(part.number);
  const bool is_sum = nodes[part.of].kind == Op::sum && nodes[part.of].name.empty();
  std::string text = in_words(part.of);
  if (is_sum && times != 1) text = '(' + text + ')';
  return fmt::format("{} {}{}", part.number < 0 ? "−" : "+",
                     times == 1 ? "" : number_in_words(times) + ' ', text);
}

std::string Expression::in_words(std::size_t place, bool is_inside) const {
  const Node& node = nodes[place];
  if (!node.name.empty() && !is_inside) return node.name;
  std::string text;
  switch (node.kind) {
    case Op::given:
      return node.name;
    case Op::sum:
      if (node.number != 0 || node.parts.empty()) text = number_in_words(node.number);
      for (const Operand& part : node.parts) {
        if (part.number == 0) continue;
        const std::string term = term_in_words(part);
        text += text.empty() ? (part.number < 0 ? "−" : "") + term.substr(term.find(' ') + 1)
                             : ' ' + term;
      }
      return text;
    case Op::product: {
      std::vector<std::string> over, under;
      if (std::abs(node.number) != 1) over.push_back(number_in_words(node.number));
      for (const Operand& part : node.parts)
        if (part.number != 0)
          (part.number < 0 ? under : over)
              .push_back(factor_in_words({part.of, std::abs(part.number)}));
      text = fmt::format("{}", fmt::join(over, " "));
      if (text.empty()) text = "1";
      if (node.number == -1) text = "−" + text;
      if (under.empty()) return text;
      return text +
             (under.size() > 1 ? fmt::format("/({})", fmt::join(under, " ")) : '/' + under[0]);
    }
    case Op::power:
      return fmt::format("({})^({})", in_words(node.parts[0].of), in_words(node.parts[1].of));
    case Op::call:
      return call_of(node.called).before + in_words(node.parts[0].of) + call_of(node.called).after;
    default:
      return in_words(node.parts[0].of);
  }
}

std::vector<std::size_t> Expression::dependent_on(std::size_t place) const {
  std::vector<std::size_t> found{place};
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t user = 0; user < nodes.size(); ++user)
      if (std::any_of(nodes[user].parts.begin(), nodes[user].parts.end(),
                      [&](const Operand& part) { return part.of == found[i]; }) &&
          std::find(found.begin(), found.end(), user) == found.end())
        found.push_back(user);
  return found;
}

namespace {

constexpr double of_one_change = 1e-4, of_two_changes = 1e-6;
constexpr double farthest_number = 5,
                 first_step_of_number = 0.02;  // of ln(number)
constexpr std::size_t fewest_of_two = 8, most_of_wholes = 600, most_probed = 6, most_told = 3;

bool is_changed(const Part::Number& one, double given) {
  return !(std::abs(given - one.answered->expected->high) <= one.answered->allowed);
}

// Whether both edits can be made together. Two edits that both replace an operand might make the
// law refer to itself.
bool can_stand_beside(const Edit& one, const Edit& other) {
  const bool is_same = one.node == other.node &&
                       (one.slot == other.slot || !one.whole.empty() || !other.whole.empty());
  return !is_same && !(one.part && other.part);
}

// Relative tolerances of is_printed(). If all answers are off by one factor, nearly every number of
// the law gives it, and one in a hundred has four digits to 1e-6 by chance.
constexpr double closeness_of_numbers = 1e-6, closeness_of_factors = 1e-10;

// Whether the answer is wrong and is `given`, the value of the changed law.
bool is_of_changed_law(const Part::Number& one, double given, double closeness) {
  const AnsweredNumber& answered = *one.answered;
  const double change = std::abs(given - answered.expected->high);
  const double own = std::min(change, std::abs(given));
  return std::isfinite(given) && change > answered.allowed &&
         std::abs(answered.got - given) <= std::max(closeness * own, answered.allowed_of(given));
}

// Whether a source may print the number: it has few digits, or a multiple of it (by 3, 7, π or 1/π)
// or its square (also over π) has. `closeness` is the relative tolerance.
bool is_printed(double number, double closeness) {
  const auto is_of = [&](double x, int digits) {
    return std::abs(of_digits(x, digits) / x - 1) < closeness;
  };
  const double square = number * number;
  if (closeness <= closeness_of_factors && is_of(number / std::numbers::pi, 4)) return true;
  return is_of(square, 2) || is_of(square / std::numbers::pi, 2) ||
         is_of(number * std::numbers::pi, 2) || is_of(number / std::numbers::pi, 2) ||
         is_of(number, 4) || is_of(3 * number, 4) || is_of(7 * number, 4);
}

// Changes of one number each, to one that a source may print, with which the law gives the answer.
std::vector<Edit> solved_numbers(const Expression& law, const Part::Number& one, std::size_t place,
                                 const std::vector<Expression::Place>& places,
                                 double closeness = closeness_of_numbers) {
  std::vector<Edit> found;
  if (law.nodes.size() > most_nodes) return found;
  Expression changed = law;
  const std::size_t result = law.results[place];
  Evaluation evaluation(changed, one.of->question.arguments);
  const double at_first = evaluation.of(result) - one.answered->got;
  if (!std::isfinite(at_first)) return found;
  std::vector<std::size_t> dependent;  // the first one is the node
  for (const Expression::Place& at_place : places) {
    double& number = changed.number_at(at_place);
    const double right = number;
    // The other nodes keep their values while this number is sought.
    if (dependent.empty() || dependent.front() != at_place.node)
      dependent = changed.dependent_on(at_place.node);
    if (std::find(dependent.begin(), dependent.end(), result) == dependent.end()) continue;
    const auto off = [&](double logarithm) {
      number = right * std::exp(logarithm);
      evaluation.compute_anew(dependent);
      return evaluation.of(result) - one.answered->got;
    };
    for (const double side : {1.0, -1.0}) {
      double before = 0, off_before = at_first;
      for (double step = first_step_of_number; step < 2 * farthest_number; step *= 2) {
        const double at = side * std::min(step, farthest_number), now = off(at);
        if (!std::isfinite(now) || (now == off_before && step > first_step_of_number)) break;
        if ((now < 0) != (off_before < 0)) {
          std::uintmax_t steps = 60;
          const bool is_up = side > 0;
          const auto [low, high] = boost::math::tools::toms748_solve(
              off, is_up ? before : at, is_up ? at : before, is_up ? off_before : now,
              is_up ? now : off_before, boost::math::tools::eps_tolerance<double>(46), steps);
          const double other = right * std::exp((low + high) / 2);
          if (is_printed(other, closeness))
            found.push_back({.node = at_place.node,
                             .slot = at_place.slot,
                             .number = is_of_few_digits(other) ? round_number(other) : other});
          break;
        }
        before = at;
        off_before = now;
      }
    }
    number = right;
    evaluation.compute_anew(dependent);
  }
  return found;
}

// Changes that put a constant in place of a named number that the law computes: "0.6 in place of
// z".
std::vector<Edit> solved_constants(const Expression& law, const Part::Number& one,
                                   std::size_t place) {
  std::vector<Edit> found;
  for (std::size_t i = 0; i < law.nodes.size(); ++i) {
    const Expression::Node& node = law.nodes[i];
    if (node.name.empty() || node.kind == Op::given) continue;
    Expression changed = law;
    const double own = law.value(i, one.of->question.arguments);
    changed.nodes[i] = {Op::sum, own};
    for (const Edit& solved : solved_numbers(changed, one, place, {{i, -1}}))
      found.push_back({.node = i,
                       .slot = -1,
                       .whole = {{Op::sum, *solved.number}},
                       .added_at = law.nodes.size()});
  }
  return found;
}

// The changes by which a number with a name that the law computes is rounded.
std::vector<Edit> rounded_numbers(const Expression& law) {
  std::vector<Edit> found;
  for (std::size_t i = 0; i < law.nodes.size(); ++i) {
    Expression::Node bare = law.nodes[i];
    if (bare.name.empty() || bare.kind == Op::given) continue;
    bare.name.clear();
    const auto add = [&](Call called, int number) {
      Expression::Node rounded{Op::call, static_cast<double>(number), {{law.nodes.size(), 1}}};
      rounded.called = called;
      found.push_back(
          {.node = i, .slot = -1, .whole = {rounded, bare}, .added_at = law.nodes.size()});
    };
    add(Call::whole_part, 0);
    for (int number = 0; number <= 6; ++number) {
      add(Call::to_decimals, number);
      if (number > 0) add(Call::to_digits, number);
    }
  }
  return found;
}

// The changes that alter the law's value in the case of at least one of these answers.
std::vector<Edit> shown_by(const std::vector<Part::Number>& probes, std::size_t place,
                           const Expression& law, const std::vector<Edit>& all) {
  std::vector<Edit> shown;
  for (const Edit& one : all) {
    Expression changed = law;
    one.apply(changed);
    if (std::any_of(probes.begin(), probes.end(), [&](const Part::Number& probe) {
          return is_changed(probe,
                            changed.value(changed.results[place], probe.of->question.arguments));
        }))
      shown.push_back(one);
  }
  return shown;
}

}  // namespace

std::vector<LawWithChange> laws_with_one_change(const Part& part) {
  std::vector<LawWithChange> found;
  const auto law = part.function() == nullptr ? std::nullopt : law_expression(*part.function());
  if (!law || part.place >= law->results.size()) return found;
  for (const Edit& one :
       shown_by(far_apart(wrong_of(part), most_probed), part.place, *law, Edits(*law).take())) {
    LawWithChange changed{*law, {}};
    one.apply(changed.law);
    changed.text = change_in_words(*law, changed.law, one);
    found.push_back(std::move(changed));
  }
  return found;
}

std::vector<ChangedExpression> changed_expressions(const Part& part, std::size_t changes,
                                                   bool is_one_factor) {
  std::vector<ChangedExpression> found;
  const auto law = part.function() == nullptr ? std::nullopt : law_expression(*part.function());
  if (!law || part.place >= law->results.size()) return found;
  const std::vector<Part::Number> all_wrong = wrong_of(part);
  const std::vector<Part::Number> probes = far_apart(all_wrong, most_probed);
  const auto value_of = [&](const Expression& changed, const Part::Number& one) {
    return changed.value(changed.results[part.place], one.of->question.arguments);
  };
  const auto gives = [&](const Expression& changed, double closeness) {
    return std::all_of(probes.begin(), probes.end(), [&](const auto& one) {
      return is_of_changed_law(one, value_of(changed, one), closeness);
    });
  };
  // Whether right results of the same case stay right. Changes that spoil such results are dropped,
  // unless all changes do.
  const auto leaves_right = [&](const Expression& changed) {
    return std::all_of(probes.begin(), probes.end(), [&](const Part::Number& one) {
      const auto& numbers = one.of->numbers;
      return std::all_of(numbers.begin(), numbers.end(), [&](const AnsweredNumber& other) {
        return other.is_wrong || other.place >= changed.results.size() ||
               std::abs(changed.value(changed.results[other.place], one.of->question.arguments) -
                        other.got) <= 2 * other.allowed;
      });
    });
  };
  std::vector<bool> is_left_right;
  const auto tell = [&](Expression changed, std::size_t count, std::string text) {
    is_left_right.push_back(leaves_right(changed));
    found.push_back({count, std::move(text),
                     [changed = std::move(changed)](const Question& asked, std::size_t place) {
                       return place < changed.results.size()
                                  ? changed.value(changed.results[place], asked.arguments)
                                  : unsaid;
                     }});
  };
  const auto drop_those_that_spoil = [&] {
    if (std::find(is_left_right.begin(), is_left_right.end(), true) == is_left_right.end()) return;
    for (std::size_t i = found.size(); i-- > 0;)
      if (!is_left_right[i]) found.erase(found.begin() + static_cast<std::ptrdiff_t>(i));
  };
  Edits edits(*law);
  const auto alike = edits.pairs_alike();
  const std::vector<Edit> all = edits.take();
  if (changes == 1) {
    std::vector<Edit> singles = all;
    for (const Part::Number& one : probes)
      for (Edit& edit :
           solved_numbers(*law, one, part.place, law->places_of_numbers(),
                          is_one_factor ? closeness_of_factors : closeness_of_numbers)) {
        const bool is_known = std::any_of(singles.begin(), singles.end(), [&](const Edit& other) {
          return other.node == edit.node && other.slot == edit.slot && other.number == edit.number;
        });
        if (!is_known) singles.push_back(std::move(edit));
      }
    for (Edit& edit : solved_constants(*law, probes[probes.size() / 2], part.place))
      singles.push_back(std::move(edit));
    for (Edit& edit : rounded_numbers(*law)) singles.push_back(std::move(edit));
    for (const Edit& one : singles) {
      Expression changed = *law;
      one.apply(changed);
      if (gives(changed, of_one_change)) {
        std::string text = change_in_words(*law, changed, one);
        tell(std::move(changed), 1, std::move(text));
      }
    }
    for (const auto& [one, other] : alike) {
      Expression changed = *law;
      one.apply(changed);
      other.apply(changed);
      if (!gives(changed, of_one_change)) continue;
      std::string text = change_in_words(*law, changed, one) + ", and the same of the other one";
      tell(std::move(changed), 1, std::move(text));
    }
    drop_those_that_spoil();
    return found;
  }
  if (all_wrong.size() < fewest_of_two) return found;
  // Two changes: both of those in `shown`, or one of them and a number that is solved for.
  const std::vector<Edit> shown = shown_by(probes, part.place, *law, all);
  const auto tell_both = [&](const Expression& changed, const Edit& one, const Edit& other) {
    if (gives(changed, of_two_changes) && found.size() < most_told)
      tell(changed, 2,
           change_in_words(*law, changed, one) + ", and " + change_in_words(*law, changed, other));
  };
  for (std::size_t i = 0; i < shown.size() && found.size() < most_told; ++i) {
    Expression first = *law;
    shown[i].apply(first);
    const bool is_whole = !shown[i].whole.empty();
    for (std::size_t k = is_whole ? 0 : i + 1; k < shown.size(); ++k) {
      if (!can_stand_beside(shown[i], shown[k])) continue;
      if (!shown[k].whole.empty()) {
        if (!is_whole || k < i || shown.size() > most_of_wholes) continue;
        Expression both = first;
        shown[k].apply(both);
        tell_both(both, shown[i], shown[k]);
        continue;
      }
      const Expression::Node before = first.nodes[shown[k].node];
      shown[k].apply(first);
      tell_both(first, shown[i], shown[k]);
      first.nodes[shown[k].node] = before;
    }
  }
  for (std::size_t i = 0; i < shown.size() && found.empty() && !is_one_factor; ++i) {
    Expression first = *law;
    shown[i].apply(first);
    // The answer that is farthest off after the first change determines the number best, unless a
    // guarded root is 0 there. So the median answer is tried, too.
    std::vector<std::pair<double, const Part::Number*>> left;
    for (const Part::Number& one : probes) {
      const double by = std::abs(std::log(std::abs(value_of(first, one) / one.answered->got)));
      left.emplace_back(std::isfinite(by) ? by : 0, &one);
    }
    std::sort(left.begin(), left.end());
    for (const Part::Number* const one : {left.back().second, left[left.size() / 2].second}) {
      std::vector<Edit> numbers =
          solved_numbers(first, *one, part.place, first.places_of_numbers());
      for (Edit& constant : solved_constants(first, *one, part.place))
        numbers.push_back(std::move(constant));
      for (const Edit& number : numbers) {
        const double value = number.whole.empty() ? *number.number : number.whole[0].number;
        if (number.node >= law->nodes.size() || !can_stand_beside(shown[i], number) ||
            !is_of_few_digits(value))
          continue;
        Expression both = first;
        number.apply(both);
        tell_both(both, shown[i], number);
      }
      if (!found.empty()) break;
    }
  }
  drop_those_that_spoil();
  return found;
}

}  // namespace tribo::conformance
