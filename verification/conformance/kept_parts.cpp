// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "conformance/expression.hpp"
#include "conformance/insides.hpp"
#include "conformance/mistake_entry.hpp"
#include "conformance/solved_mistakes.hpp"
#include "scene/schema.hpp"

namespace tribo::conformance {
namespace {

constexpr std::size_t most_kept_probes = 12;   // wrong answers that are looked at
constexpr std::size_t most_alike = 12;         // questions before each, those most like it
constexpr std::size_t fewest_kept_probes = 3;  // two may meet a kept part by chance

// A part of an answer, and the answers with another value of it.
struct KeptPart {
  std::string symbol;
  Get get;
  std::function<Numbers(const Question&, double)> with;
};

// The inputs of a question as numbers; infinite: the question has no such input.
std::vector<double> inputs_of(const Question& question) {
  std::vector<double> all;
  if (question.function != nullptr)
    all.assign(question.arguments.begin(),
               question.arguments.begin() + std::ssize(question.function->parameters));
  for (std::size_t i = 0; i < scene_fields().size() && question.scene; ++i)
    all.push_back(scene_detail::value_in(*question.scene, i).value_or(INFINITY));
  return all;
}

std::size_t count_of_different(const std::vector<double>& a, const std::vector<double>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

// Whether the part depends on this input of the question.
bool depends(const KeptPart& part, Question question, std::size_t input) {
  const double given = inputs_of(question)[input];
  if (std::isinf(given)) return false;
  const double own = part.get(question);
  const std::size_t words = question.scene ? scene_fields()[input].choices.size()
                                           : question.function->parameters[input].words.size();
  const bool is_whole = given == std::floor(given) && std::abs(given) < 10;
  const double other = words > 0  ? std::fmod(given + 1, static_cast<double>(words))
                       : is_whole ? given + 1
                                  : given * 1.1;
  if (!question.scene)
    question.arguments[input] = other;
  else if (const auto store = scene_detail::store_of(input); store != nullptr)
    store(*question.scene, other);
  return part.get(question) != own;
}

std::vector<KeptPart> parts_of_points() {
  std::vector<KeptPart> all;
  const auto add = [&](std::string symbol, Get get, std::function<void(Question&, double)> set) {
    all.push_back({std::move(symbol), std::move(get),
                   [set = std::move(set)](const Question& asked, double value) {
                     Question changed = asked;
                     set(changed, value);
                     return right_numbers(changed);
                   }});
  };
  add("the film formula's h₀", smooth_film,
      [](Question& asked, double value) { scale_film(*asked.scene, value / smooth_film(asked)); });
  for (const Inside& inside : insides_of_points()) add(inside.symbol, inside.get, inside.set);
  return all;
}

// The numbers with names that a law computes from several inputs.
std::vector<KeptPart> parts_of(const catalogue::Function& function) {
  std::vector<KeptPart> all;
  const auto law = law_expression(function);
  for (std::size_t i = 0; law && i < law->nodes.size(); ++i) {
    if (law->nodes[i].name.empty() || law->nodes[i].kind == Expression::Op::given) continue;
    all.push_back({law->nodes[i].name,
                   [law = *law, i](const Question& asked) { return law.value(i, asked.arguments); },
                   [law = *law, i](const Question& asked, double value) mutable {
                     law.nodes[i] = {Expression::Op::sum, value};
                     Numbers numbers{};
                     for (std::size_t k = 0; k < law.results.size(); ++k)
                       numbers[k] = law.results[k] < law.nodes.size()
                                        ? law.value(law.results[k], asked.arguments)
                                        : unsaid;
                     return numbers;
                   }});
  }
  return all;
}

// Whether the finite ones of these numbers are what was answered.
bool are_answers(const AnsweredCase& one, const Numbers& given) {
  return std::all_of(one.numbers.begin(), one.numbers.end(), [&](const AnsweredNumber& number) {
    const double value = given[number.place];
    return !std::isfinite(value) || std::abs(number.got - value) <= number.allowed_of(value);
  });
}

bool tells_a_wrong_answer(const AnsweredCase& one, const Numbers& given) {
  return std::any_of(one.numbers.begin(), one.numbers.end(), [&](const AnsweredNumber& number) {
    return number.is_wrong && std::isfinite(given[number.place]);
  });
}

// The mistake of a solver that keeps the part of the first question with the same inputs of these
// places.
Mistake kept_by(const std::vector<std::size_t>& key, const KeptPart& part, std::string text,
                const std::vector<Question>& order) {
  const auto kept = std::make_shared<std::unordered_map<const TestCase*, double>>();
  std::map<std::vector<double>, double> known;
  for (const Question& one : order) {
    const double own = part.get(one);
    if (std::isnan(own)) continue;
    const std::vector<double> inputs = inputs_of(one);
    std::vector<double> looked_up;
    for (const std::size_t place : key) looked_up.push_back(inputs[place]);
    (*kept)[one.asked] = known.try_emplace(std::move(looked_up), own).first->second;
  }
  const catalogue::Function* const function = order.front().function;
  Mistake mistake{.function = std::string(function ? function->name : operating_point_functions[0]),
                  .name = text,
                  .text = text,
                  .touches = {function ? "formula" : part.symbol}};
  mistake.instead = [part, kept](const Question& asked) -> std::optional<Numbers> {
    const auto found = kept->find(asked.asked);
    if (found == kept->end() || found->second == part.get(asked)) return std::nullopt;
    return part.with(asked, found->second);
  };
  return mistake;
}

// A wrong answer with the questions before it that are most like it, and the first one.
struct Probe {
  const AnsweredCase* of;
  std::vector<const Question*> before;
};
std::vector<Probe> probes_of(const std::vector<AnsweredCase>& answered,
                             const std::vector<Question>& order) {
  std::vector<const AnsweredCase*> wrong;
  for (const AnsweredCase& one : answered)
    if (std::any_of(one.numbers.begin(), one.numbers.end(),
                    [](const AnsweredNumber& number) { return number.is_wrong; }))
      wrong.push_back(&one);
  std::vector<std::vector<double>> inputs;
  for (std::size_t k = 0; k < order.size() && !wrong.empty(); ++k)
    inputs.push_back(inputs_of(order[k]));
  std::vector<Probe> probes;
  const std::size_t count = std::min(most_kept_probes, wrong.size());
  for (std::size_t i = 0; i < count; ++i) {
    Probe probe{wrong[i * wrong.size() / count], {}};
    std::vector<std::pair<std::size_t, const Question*>> alike;
    const std::vector<double> own = inputs_of(probe.of->asked);
    for (std::size_t k = 0; k < order.size() && order[k].asked != probe.of->asked.asked; ++k)
      alike.emplace_back(count_of_different(own, inputs[k]), &order[k]);
    std::sort(alike.begin(), alike.end());
    alike.resize(std::min(most_alike, alike.size()));
    for (const auto& [apart, one] : alike) probe.before.push_back(one);
    probe.before.push_back(&order.front());
    probes.push_back(std::move(probe));
  }
  return probes;
}

// Empty: less than half of the wrong answers have this part of a question before.
std::optional<Mistake> kept(const KeptPart& part, const std::vector<Probe>& probes,
                            const std::vector<Question>& order) {
  std::set<std::size_t> lacking, needed;
  std::size_t met = 0, looked_at = 0;
  for (const Probe& probe : probes) {
    const AnsweredCase* const of = probe.of;
    const std::vector<const Question*>& before = probe.before;
    const double own = part.get(of->asked);
    if (!std::isfinite(own)) continue;
    const auto donor = std::find_if(before.begin(), before.end(), [&](const Question* one) {
      const double value = part.get(*one);
      if (!std::isfinite(value) || value == own) return false;
      const Numbers given = part.with(of->asked, value);
      return tells_a_wrong_answer(*of, given) && are_answers(*of, given);
    });
    if (++looked_at >= fewest_kept_probes && donor == before.end() && met == 0) return {};
    if (donor == before.end()) continue;
    ++met;
    const std::vector<double> asked = inputs_of(of->asked), given = inputs_of(**donor);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (!depends(part, of->asked, i)) continue;
      needed.insert(i);
      if (asked[i] != given[i]) lacking.insert(i);
    }
  }
  if (met < fewest_kept_probes || 2 * met < looked_at || lacking.empty()) return {};
  std::vector<std::size_t> key;
  std::set_difference(needed.begin(), needed.end(), lacking.begin(), lacking.end(),
                      std::back_inserter(key));
  if (key.empty())
    return kept_by({}, part, part.symbol + " of the first question in all later ones: it is kept",
                   order);
  std::vector<std::string> names;
  for (const std::size_t place : lacking)
    names.emplace_back(order.front().scene ? scene_fields()[place].path
                                           : order.front().function->parameters[place].name);
  return kept_by(key, part,
                 fmt::format("{} of an earlier question with another {}: the solver keeps it, as a "
                             "cache does, and looks for it without {}",
                             part.symbol, fmt::join(names, " or "), fmt::join(names, " and ")),
                 order);
}

// Options that a question leaves out and that are those of the last question that gave them. Empty:
// no wrong answer is so.
std::optional<Mistake> kept_options(const std::vector<AnsweredCase>& answered,
                                    const std::vector<Question>& order) {
  using Options = std::map<std::size_t, double>;  // by their fields
  std::unordered_map<const TestCase*, Options> options;
  Options last;
  for (const Question& one : order)
    for (std::size_t i = 0; i < scene_fields().size(); ++i) {
      const FieldInfo& field = scene_fields()[i];
      if (field.default_text.empty() || scene_detail::store_of(i) == nullptr) continue;
      const nlohmann::json given =
          one.asked->inputs.value(pointer_to(field.path), nlohmann::json());
      const auto word = std::find_if(
          field.choices.begin(), field.choices.end(),
          [&](std::string_view choice) { return given == nlohmann::json(std::string(choice)); });
      if (given.is_number())
        last[i] = given.get<double>();
      else if (word != field.choices.end())
        last[i] = static_cast<double>(word - field.choices.begin());
      else if (given.is_null() && last.contains(i))
        options[one.asked][i] = last[i];
    }
  const auto with = [options](Question& asked, const std::set<std::size_t>& fields) {
    if (const auto own = options.find(asked.asked); own != options.end() && asked.scene)
      for (const auto& [field, value] : own->second)
        if (fields.contains(field)) scene_detail::store_of(field)(*asked.scene, value);
  };
  const auto met = [&](const std::set<std::size_t>& fields) {
    return std::count_if(answered.begin(), answered.end(), [&](const AnsweredCase& one) {
      Question asked = one.question;
      with(asked, fields);
      return options.contains(asked.asked) && are_answers(one, right_numbers(asked));
    });
  };
  // Fields that are not kept are left out first, then those that change nothing.
  std::set<std::size_t> fields;
  for (const auto& [field, value] : last) fields.insert(field);
  auto most = met(fields);
  for (const int least_gain : {1, 0})
    for (const std::size_t field : std::set<std::size_t>(fields)) {
      std::set<std::size_t> fewer = fields;
      fewer.erase(field);
      if (const auto without = met(fewer); without >= most + least_gain) {
        most = without;
        fields = std::move(fewer);
      }
    }
  if (fields.empty()) return {};
  std::vector<std::string> names;
  for (const std::size_t field : fields)
    names.push_back(fmt::format("`{}`", scene_fields()[field].path));
  const std::string text =
      fmt::format("{} of the last question that gave it, where it is left out: it is kept",
                  fmt::join(names, ", "));
  return Mistake{.function = std::string(operating_point_functions[0]),
                 .name = text,
                 .text = text,
                 .touches = std::move(names),
                 .before = [with, fields](Question& asked) { with(asked, fields); }};
}

}  // namespace

std::vector<Mistake> kept_parts(const std::vector<AnsweredCase>& answered,
                                const std::vector<Question>& order) {
  const std::vector<Probe> probes = probes_of(answered, order);
  std::vector<Mistake> found;
  if (probes.size() < fewest_kept_probes) return found;
  const AnsweredCase& first = *probes.front().of;
  const auto has_same = [&](const AnsweredCase& other, const auto& of) {
    return std::equal(first.numbers.begin(), first.numbers.end(), other.numbers.begin(),
                      other.numbers.end(),
                      [&](const auto& a, const auto& b) { return of(a) == of(b); });
  };
  // A point may be asked again without its defaults: then the right answers are the same, too.
  const auto is_whole_answer_of = [&](const AnsweredCase& other) {
    return has_same(other, [](const AnsweredNumber& number) { return number.got; }) &&
           !has_same(other, [](const AnsweredNumber& number) { return number.expected->high; });
  };
  if (std::any_of(answered.begin(), answered.end(), is_whole_answer_of)) return found;
  const catalogue::Function* const function = order.front().function;
  for (const KeptPart& part : function == nullptr ? parts_of_points() : parts_of(*function))
    if (auto mistake = kept(part, probes, order)) found.push_back(std::move(*mistake));
  if (function == nullptr)
    if (auto mistake = kept_options(answered, order)) found.push_back(std::move(*mistake));
  return found;
}

}  // namespace tribo::conformance
