// SPDX-License-Identifier: Apache-2.0
// The functions of the catalogue whose laws are sums and products, as expressions.
#include <cmath>
#include <map>
#include <numbers>

#include "conformance/expression.hpp"
#include "conformance/variable.hpp"
#include "tribo/gaussian_moment.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/rough_faces.hpp"
#include "tribo/starvation.hpp"
#include "tribo/viscosity_index.hpp"

namespace tribo::conformance {
// Each function below that returns an Expression is named after its law.
namespace law_terms {
namespace {

using catalogue::Arguments;
using Op = Expression::Op;

// A node of the law that is being written.
struct Term {
  Expression* law;
  std::size_t place;

  const Expression::Node& node() const { return law->nodes[place]; }
  bool is_plain(Op kind) const { return node().kind == kind && node().name.empty(); }
};

Term add(Expression& law, Expression::Node node) {
  law.nodes.push_back(std::move(node));
  return {&law, law.nodes.size() - 1};
}

// Adds a term times `number` to a sum, or a factor to the power `number` to a product.
void add_to(Expression::Node& node, const Term& term, double number) {
  if (!term.is_plain(node.kind)) return node.parts.push_back({term.place, number});
  if (node.kind == Op::sum)
    node.number += number * term.node().number;
  else
    node.number *= std::pow(term.node().number, number);
  for (const auto& [of, own] : term.node().parts) node.parts.push_back({of, number * own});
}
Term product(const Term& a, const Term& b, double power) {
  Expression::Node node{Op::product, 1};
  add_to(node, a, 1);
  add_to(node, b, power);
  return add(*a.law, std::move(node));
}
Term sum(double number, const Term& a, double times, const Term* b = nullptr) {
  Expression::Node node{Op::sum, number};
  // The own number of a product becomes the coefficient of the term.
  const auto add_term = [&](const Term& term, double by) {
    if (!term.is_plain(Op::product)) return add_to(node, term, by);
    Expression::Node bare = term.node();
    by *= bare.number;
    bare.number = 1;
    if (bare.parts.size() == 1 && bare.parts[0].number == 1)
      return node.parts.push_back({bare.parts[0].of, by});
    node.parts.push_back({add(*term.law, std::move(bare)).place, by});
  };
  add_term(a, times);
  if (b != nullptr) add_term(*b, 1);
  return add(*a.law, std::move(node));
}

Term operator*(const Term& a, const Term& b) { return product(a, b, 1); }
Term operator/(const Term& a, const Term& b) { return product(a, b, -1); }
Term operator*(double number, const Term& a) {
  Expression::Node node{Op::product, number};
  add_to(node, a, 1);
  return add(*a.law, std::move(node));
}
Term operator/(double number, const Term& a) {
  Expression::Node node{Op::product, number};
  add_to(node, a, -1);
  return add(*a.law, std::move(node));
}
Term operator+(const Term& a, const Term& b) { return sum(0, a, 1, &b); }
Term operator-(const Term& a, const Term& b) { return a + -1.0 * b; }
Term operator+(double number, const Term& a) { return sum(number, a, 1); }
Term operator-(double number, const Term& a) { return sum(number, a, -1); }
Term operator+(const Term& a, double number) { return sum(number, a, 1); }
Term operator-(const Term& a, double number) { return sum(-number, a, 1); }
Term pow(const Term& a, double exponent) {
  return add(*a.law, {Op::product, 1, {{a.place, exponent}}});
}
Term pow(const Term& a, const Term& exponent) {
  return add(*a.law, {Op::power, 0, {{a.place}, {exponent.place}}});
}
Term sqrt(const Term& a) { return pow(a, 0.5); }

Term call(Expression::Call called, const Term& a) {
  return add(*a.law, {Op::call, 0, {{a.place}}, {}, called});
}
Term exp(const Term& a) { return call(Expression::Call::exponential, a); }
Term ln(const Term& a) { return call(Expression::Call::logarithm, a); }
Term atan(const Term& a) { return call(Expression::Call::arc, a); }

Term named(const Term& a, std::string name) {
  a.law->nodes[a.place].name = std::move(name);
  return a;
}

// Writes the law of one function.
class Writer {
 public:
  explicit Writer(const catalogue::Function& of) : function_(of) {
    for (std::size_t i = 0; i < of.parameters.size(); ++i)
      inputs_.push_back(add(law_, {Op::given,
                                   0,
                                   {},
                                   [i](const Arguments& a) { return a[i]; },
                                   {},
                                   symbol_of(of.parameters[i].meaning),
                                   of.parameters[i].unit})
                            .place);
  }
  Term operator[](std::size_t place) { return {&law_, inputs_[place]}; }
  Term given(const char* name, Expression::Get get) {
    return add(law_, {Op::given, 0, {}, get, {}, name});
  }
  Term pi() {
    return given("π", [](const Arguments&) { return std::numbers::pi; });
  }
  Term choice(const std::vector<Term>& of, Expression::Get get) {
    Expression::Node node{Op::choice, 0, {}, get};
    for (const Term& one : of) node.parts.push_back({one.place});
    return add(law_, std::move(node));
  }
  // A node with the model's own result, where the law is neither a sum nor a product.
  Term own() {
    return add(law_, {Op::given, 0, {}, [of = &function_](const Arguments& a) {
                        catalogue::Results results{};
                        of->value(a, results);
                        return results[0];
                      }});
  }
  Expression with(const std::vector<Term>& results) {
    for (const Term& one : results) law_.results.push_back(kept(one.place));
    law_.nodes = std::move(kept_);
    return std::move(law_);
  }

 private:
  // Copies a node that the law uses, and returns its new place. Merged nodes are not copied.
  std::size_t kept(std::size_t place) {
    const auto known = places_.find(place);
    if (known != places_.end()) return known->second;
    Expression::Node node = law_.nodes[place];
    for (Expression::Operand& part : node.parts) part.of = kept(part.of);
    kept_.push_back(std::move(node));
    return places_[place] = kept_.size() - 1;
  }

  const catalogue::Function& function_;
  Expression law_;
  std::vector<Expression::Node> kept_;
  std::map<std::size_t, std::size_t> places_;
  std::vector<std::size_t> inputs_;
};

Expression film(Writer x, const catalogue::Function& function) {
  const FilmLaw& law = *function.film_law;
  const auto number = [](const Fraction& one) { return static_cast<double>(one.p) / one.q; };
  const bool is_soft = function.parameters[2].name != "pressure_viscosity";
  const std::size_t load = is_soft ? 2 : 3;
  const Term modulus = 2 * x[load + 1], radius = x[load + 2];
  const Term u = named(x[0] * x[1] / (modulus * radius), "U");
  const Term w = named(x[load] / (modulus * (law.is_of_lines ? radius : pow(radius, 2))), "W");
  Term film = number(law.constant) * radius * pow(u, number(law.speed_exponent));
  if (!is_soft) film = film * pow(named(x[2] * modulus, "G"), number(law.material_exponent));
  film = film * pow(w, number(law.load_exponent));
  if (!law.is_of_lines)
    film = film * (1 - number(law.side_leakage) * exp(-number(law.side_decay) * x[load + 3]));
  return x.with({film});
}

Expression modulus(Writer x) {
  const auto compliance = [&](std::size_t i) { return (1 - pow(x[i + 1], 2)) / x[i]; };
  return x.with({1 / (compliance(0) + compliance(2))});
}
Expression radii(Writer x) {
  const Term along = named(1 / (1 / x[0] + 1 / x[1]), "R_x");
  const Term across = named(1 / (1 / x[2] + 1 / x[3]), "R_y");
  return x.with({along, across, 1 / (1 / along + 1 / across)});
}
Expression circle(Writer x) {
  const Term a = named(pow(0.75 * x[0] * x[2] / x[1], 1.0 / 3), "a");
  const Term mean = named(x[0] / (x.pi() * pow(a, 2)), "p̄");
  return x.with({a, mean, 1.5 * mean, pow(a, 2) / x[2]});
}
// The shape at the arguments of hertz_ellipse, whose axes are exchanged where R_y < R_x.
EllipseShape<double> shape_at(const Arguments& a) {
  return ellipse_shape(std::max(a[2], a[3]) / std::min(a[2], a[3]));
}
Expression ellipse(Writer x) {
  const auto exchanged = [](const Arguments& a) { return a[3] < a[2] ? 1.0 : 0.0; };
  const Term k = x.given("k", [](const Arguments& a) { return shape_at(a).ellipticity; });
  const Term first = x.given("K", [](const Arguments& a) { return shape_at(a).first_integral; });
  const Term second = x.given("E", [](const Arguments& a) { return shape_at(a).second_integral; });
  const Term radius = named(1 / (1 / x[2] + 1 / x[3]), "R");
  const Term minor =
      named(pow(3 * second * x[0] * radius / (x.pi() * k * x[1]), 1.0 / 3), "the minor axis");
  const Term major = named(k * minor, "the major axis");
  const Term mean = named(x[0] / (x.pi() * minor * major), "p̄");
  return x.with({x.choice({minor, major}, exchanged), x.choice({major, minor}, exchanged),
                 x.choice({k, 1 / k}, exchanged), mean, 1.5 * mean,
                 pow(minor, 2) * first / (2 * radius * second)});
}
Expression strip(Writer x) {
  const Term b = named(sqrt(4 * x[0] * x[2] / (x.pi() * x[1])), "b");
  const Term peak = named(2 * x[0] / (x.pi() * b), "p₀");
  return x.with({b, x[0] / (2 * b), peak, 0.3002831060007776 * peak});
}
Expression shear(Writer x) {
  const Term depth = named(x[2] / x[1], "ζ");
  const Term q = named(1 / (1 + pow(depth, 2)), "q");
  const Term arc = 1 - depth * atan(x[1] / x[2]);
  const Term radial = named(0.5 * q - (1 + x[3]) * arc, "σ_r"), axial = named(-1 * q, "σ_z");
  return x.with({0.5 * x[0] * call(Expression::Call::size, radial - axial)});
}
Expression jkr(Writer x) {
  const Term pull = named(x.pi() * x[1] * x[3], "πwR");
  const Term root = sqrt(6 * pull * x[0] + 9 * pow(pull, 2));
  return x.with({pow(0.75 * x[3] / x[2] * (x[0] + 3 * pull + root), 1.0 / 3)});
}
Expression pull_off(Writer x) {
  const Term pull = x.pi() * x[1] * x[2];
  return x.with({x.choice({1.5 * pull, 2 * pull}, [](const Arguments& a) { return a[0]; })});
}
// Orders 0, 1/2 … 5/2. Half orders are not such sums and are the model's own results.
Expression moments(Writer x) {
  const Term density = x.given("φ(d)", [](const Arguments& a) {
    return std::exp(-a[1] * a[1] / 2) / std::sqrt(2 * std::numbers::pi);
  });
  const Term tail =
      x.given("Q(d)", [](const Arguments& a) { return std::erfc(a[1] / std::numbers::sqrt2) / 2; });
  const Term own = x.own(), d = x[1];
  return x.with(
      {x.choice({tail, own, density - d * tail, own, (1 + pow(d, 2)) * tail - d * density, own},
                [](const Arguments& a) { return 2 * a[0]; })});
}

Expression moes_line(Writer x) {
  const Term modulus = 2 * x[4];
  const Term u = named(2 * x[0] * x[1] / (modulus * x[5]), "2U");
  const Term m = named(x[3] / (modulus * x[5]) * pow(u, -0.5), "M");
  const Term l = named(x[2] * modulus * pow(u, 0.25), "L");
  const Term ri = named(3 / m, "H_RI"), ei = named(2.621 * pow(m, -0.2), "H_EI");
  const Term rp = named(1.287 * pow(l, 2.0 / 3), "H_RP");
  const Term ep = named(1.311 * pow(m, -0.125) * pow(l, 0.75), "H_EP");
  const Term s = named(1.4 + 1.6 * exp(-2 * ei / ri), "s");
  const Term rigid = pow(pow(ri, 7.0 / 3) + pow(ei, 7.0 / 3), 3.0 / 7 * s);
  const Term thick = pow(pow(rp, -3.5) + pow(ep, -3.5), -2.0 / 7 * s);
  return x.with({pow(rigid + thick, 1 / s) * x[5] * sqrt(u)});
}
Expression moes_point(Writer x) {
  const Term modulus = 2 * x[4], d = named(x[5] / x[6], "D");
  const Term u = named(2 * x[0] * x[1] / (modulus * x[5]), "2U");
  const Term m = named(x[3] / (modulus * pow(x[5], 2)) * pow(u, -0.75), "M");
  const Term l = named(x[2] * modulus * pow(u, 0.25), "L");
  const Term q = named(1 + (0.006 * ln(d) + 0.63 * pow(d, 4.0 / 7)), "q");
  const Term ri =
      named(145 * pow(1 + 0.796 * pow(d, 14.0 / 15), -15.0 / 7) / d * pow(m, -2), "H_RI");
  const Term ei = named(3.18 * pow(q, -0.56) * pow(d, -1.0 / 15) * pow(m, -2.0 / 15), "H_EI");
  const Term rp = named(1.29 * pow(1 + 0.691 * d, -2.0 / 3) * pow(l, 2.0 / 3), "H_RP");
  const Term ep =
      named(1.48 * pow(q, -0.35) * pow(d, -1.0 / 24) * pow(m, -1.0 / 12) * pow(l, 0.75), "H_EP");
  const Term of_s = x.choice({ri, ep}, [](const Arguments& a) { return a[7]; });
  const Term s = named(1.5 + 1.5 * exp(-1.2 * ei / of_s), "s");
  const Term limit = named(1.8 / d, "1.8/D");
  const Term limited = named(pow(ei, -4) + pow(limit, -4), "H_EI^(−4) + (1.8/D)^(−4)");
  const Term inner = x.choice({pow(pow(ri, 1.5) + pow(limited, -0.375), 2.0 / 3 * s),
                               pow(pow(ri, 1.5 * s) + pow(limited, -0.375 * s), 2.0 / 3 / s)},
                              [](const Arguments& a) { return a[8]; });
  const Term thick = pow(pow(rp, -8) + pow(ep, -8), -0.125 * s);
  return x.with({pow(inner + thick, 1 / s) * x[5] * sqrt(u)});
}
Expression regimes(Writer x) {
  const auto side = [&](double decay, const Term& of) { return 1 - exp(-decay * of); };
  const Term phi = named(1 / (1 + 2.0 / 3 / x[3]), "φ");
  const Term arc = 0.131 * atan(0.5 * x[3]) + 1.683;
  return x.with({x.choice(
      {128 * x[3] * pow(phi, 2) * pow(arc, 2), 1.66 * pow(x[1], 2.0 / 3) * side(0.68, x[4]),
       141 * pow(x[1], 0.375) * side(0.0387, x[3]),
       8.70 * pow(x[2], 0.67) * (1 - 0.85 * exp(-0.31 * x[4])),
       3.42 * pow(x[1], 0.49) * pow(x[2], 0.17) * side(0.68, x[4])},
      [](const Arguments& a) { return a[0]; })});
}
Expression gupta(Writer x) {
  const Term l = named(x[3] * x[4] * pow(x[5], 2) / x[6], "L");
  return x.with({(1 - 13.2 * x[0] / (2 * x[1]) * pow(l, 0.42)) /
                 (1 + 0.213 * (1 + 2.23 * pow(x[2], 0.83)) * pow(l, 0.64))});
}
Expression murch(Writer x) {
  const Term l = named(x[0] * x[1] * pow(x[2], 2) / x[3], "L");
  return x.with({3.94 / (3.94 + pow(l, 0.62))});
}
Expression starvation(Writer x) {
  const Term damiens = pow(1 + pow(x[1], x[2]), -1 / x[2]);
  return x.with({x.choice({x.own(), damiens}, [](const Arguments& a) {
    return static_cast<StarvationClosure>(static_cast<int>(a[0])) == StarvationClosure::damiens
               ? 1.0
               : 0.0;
  })});
}

Expression roelands(Writer x) {
  const Term scale = named(ln(x[0]) + 9.67, "(ln η₀ + 9.67)");
  const Term z = named(1.96e8 * x[1] / scale, "z");
  return x.with({x[0] * exp(scale * (pow(1 + 1 / 1.96e8 * x[2], z) - 1))});
}
Expression carreau(Writer x) {
  const Term thinned = pow(1 + pow(x[2] * x[3], x[4]), (x[5] - 1) / x[4]);
  return x.with({x[1] + (x[0] - x[1]) * thinned});
}
Expression walther(Writer x) {
  const auto height = [&](std::size_t i) { return ln(ln(0.7 + 1e6 * x[i])); };
  const Term first = height(1), second = height(3);
  const Term part = (ln(x[4]) - ln(x[0])) / (ln(x[2]) - ln(x[0]));
  return x.with({1e-6 * (exp(exp(first + part * (second - first))) - 0.7)});
}
Expression index(Writer x) {
  const Term zero = x.given("L", [](const Arguments& a) { return detail::index_oils(a[1]).zero; });
  const Term hundred =
      x.given("H", [](const Arguments& a) { return detail::index_oils(a[1]).hundred; });
  const Term u = named(1e6 * x[0], "U"), y = named(1e6 * x[1], "Y");
  const Term n = named(ln(hundred / u) / ln(y), "N");
  const Term below = 100 * (zero - u) / (zero - hundred);
  const Term above = 100 + 1 / 0.00715 * (exp(std::numbers::ln10 * n) - 1);
  return x.with({x.choice({below, above}, [](const Arguments& a) {
    return 1e6 * a[0] < detail::index_oils(a[1]).hundred ? 1.0 : 0.0;
  })});
}
Expression summits(Writer x) {
  const Term bandwidth = named(x[0] * x[2] / pow(x[1], 2), "α");
  const Term excess = bandwidth - 0.8968;
  return x.with({bandwidth, x[2] / (6 * std::numbers::sqrt3 * (x.pi() * x[1])),
                 0.375 * sqrt(x.pi() / x[2]), sqrt((1 - 0.8968 / bandwidth) * x[0]),
                 4 * pow(x.pi() * excess, -0.5)});
}
Expression kogut(Writer x) {
  return x.with({x.choice(
      {pow(x[0], 1.5), 1.03 * pow(x[0], 1.425), 1.40 * pow(x[0], 1.263)}, [](const Arguments& a) {
        return a[0] < 1 ? 0.0 : a[0] < second_kogut_etsion_interference ? 1.0 : 2.0;
      })});
}
Expression roughness(Writer x) {
  const Term rough = named(sqrt(pow(x[1], 2) + pow(x[2], 2)), "Rq");
  return x.with({rough, x[0] / rough});
}

}  // namespace
}  // namespace law_terms

std::optional<Expression> law_expression(const catalogue::Function& function) {
  using namespace law_terms;
  Writer x(function);
  const auto is = [&](std::string_view name) { return function.name == name; };
  if (function.film_law != nullptr) return film(std::move(x), function);
  struct Written {
    std::string_view name;
    Expression (*law)(Writer);
  };
  constexpr Written laws[] = {
      {"effective_modulus", modulus},
      {"reduced_radius", radii},
      {"hertz_point", circle},
      {"hertz_ellipse", ellipse},
      {"hertz_line", strip},
      {"subsurface_shear", shear},
      {"jkr_radius", jkr},
      {"pull_off_force", pull_off},
      {"gaussian_moment", moments},
      {"moes_line", moes_line},
      {"nijenbanning_venner_moes", moes_point},
      {"regime_film", regimes},
      {"gupta_thermal_reduction", gupta},
      {"murch_wilson_thermal_reduction", murch},
      {"starvation_ratio", starvation},
      {"dowson_higginson_density",
       [](Writer w) { return w.with({(5.9e8 + 1.34 * w[0]) / (5.9e8 + w[0])}); }},
      {"barus_viscosity", [](Writer w) { return w.with({w[0] * exp(w[1] * w[2])}); }},
      {"roelands_viscosity", roelands},
      {"carreau_yasuda_viscosity", carreau},
      {"astm_d341_viscosity", walther},
      {"viscosity_index", index},
      {"summits_from_spectral_moments", summits},
      {"plasticity_index", [](Writer w) { return w.with({w[0] / w[1] * sqrt(w[2] / w[3])}); }},
      {"kogut_etsion_load", kogut},
      {"persson_contact_area",
       [](Writer w) {
         return w.with({call(Expression::Call::error, std::numbers::sqrt2 * w[0] / (w[1] * w[2]))});
       }},
      {"patir_cheng_pressure_flow", [](Writer w) { return w.with({1 - 0.9 * exp(-0.56 * w[0])}); }},
      {"lambda_ratio", roughness}};
  for (const Written& one : laws)
    if (is(one.name)) return one.law(std::move(x));
  return std::nullopt;
}

}  // namespace tribo::conformance
