// SPDX-License-Identifier: Apache-2.0
#include "conformance/diagnosis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "conformance/mistake_search.hpp"
#include "conformance/power_law.hpp"
#include "conformance/where_wrong.hpp"

namespace tribo::conformance {
namespace {

constexpr double few = 0.03;       // of the wrong answers
constexpr int most_causes = 3;     // told one after the other
constexpr double few_ulp = 1e-12;  // relative errors that are rounding
constexpr double rounding = 1e-5;  // of logarithms: single precision too

// "27.5 % low", "1000 times too large".
std::string in_words(double ratio) {
  if (std::abs(ratio + 1) < 1e-6) return "−1 times the right value";
  if (ratio < 0) return fmt::format("{:.4g} times the right value, of the wrong sign", ratio);
  if (ratio > 3) return fmt::format("{:.4g} times too large", ratio);
  if (ratio < 1.0 / 3) return fmt::format("{:.4g} times too small", 1 / ratio);
  return fmt::format("{:.3g} % {}", 100 * std::abs(ratio - 1), ratio < 1 ? "low" : "high");
}

// A factor that people lose or gain.
std::string known_factor(double ratio) {
  struct Factor {
    double value;
    const char* name;
  };
  constexpr Factor factors[] = {{2, "2"},
                                {3.14159265358979, "π"},
                                {1.4142135623731, "√2"},
                                {1.5, "3/2"},
                                {1.33333333333333, "4/3"},
                                {2.506628274631, "√(2π)"},
                                {1.772453850905516, "√π"},
                                {1e3, "1000, as between m and mm"},
                                {1e6, "10⁶, as between m and µm"},
                                {1e9, "10⁹, as between m and nm"},
                                {100, "100, as with percent"},
                                {4, "4"},
                                {6.283185307179586, "2π"}};
  if (std::abs(ratio + 1) < 1e-6) return "It has another sign convention.";
  for (const Factor& one : factors) {
    if (std::abs(ratio / one.value - 1) < 1e-6)
      return fmt::format("It is too large by a factor of {}.", one.name);
    if (std::abs(ratio * one.value - 1) < 1e-6)
      return fmt::format("It is too small by a factor of {}.", one.name);
  }
  return {};
}

// The functions that a function's numbers rest on.
std::vector<std::string> rests_on(const std::string& function) {
  if (function == "load_sharing") return {"gaussian_moment"};
  if (is_operating_point(function)) {
    // A point of the usual kind rests on the first law and on the circle alone.
    if (function == operating_point_functions[0])
      return {"hertz_point", std::string(film_formula_words[0]), "gaussian_moment", "load_sharing",
              "starvation_ratio"};
    std::vector<std::string> below{"hertz_point",     "hertz_ellipse", "hertz_line",
                                   "gaussian_moment", "load_sharing",  "starvation_ratio"};
    below.insert(below.end(), film_formula_words.begin(), film_formula_words.end());
    return below;
  }
  return {};
}

// The numbers of one result in one branch of the function.
struct Part {
  std::size_t place;
  std::string branch;
  std::vector<const AnsweredNumber*> wrong;  // and unexplained
  std::size_t answered = 0;
};

// How the wrong numbers are off: "27.5 % low everywhere".
std::string pattern(const Part& part) {
  std::vector<double> ratios;
  for (const AnsweredNumber* const one : part.wrong)
    if (one->expected->high != 0) ratios.push_back(one->got / one->expected->high);
  if (ratios.empty()) return "wrong where it should be 0";
  std::sort(ratios.begin(), ratios.end());
  const double least = ratios.front(), greatest = ratios.back(), middle = ratios[ratios.size() / 2];
  const std::string where =
      part.wrong.size() == part.answered
          ? "everywhere"
          : fmt::format("in {} of {} cases", part.wrong.size(), part.answered);
  if (least == 0 && greatest == 0) return "answered as 0 " + where;
  if (greatest - least <= 2e-3 * std::abs(middle - 1) + 1e-9)
    return fmt::format("{} {}", in_words(middle), where);
  return fmt::format("off {}, between {} and {}, in the middle {}", where, in_words(least),
                     in_words(greatest), in_words(middle));
}

class Diagnoser {
 public:
  Diagnoser(std::string function, std::vector<AnsweredCase> cases,
            const std::vector<Mistake>& mistakes, std::string wrong_below,
            const std::map<std::string, std::string>& named_before)
      : function_(std::move(function)),
        cases_(std::move(cases)),
        mistakes_(mistakes),
        wrong_below_(std::move(wrong_below)),
        named_before_(named_before) {
    for (const AnsweredCase& one : cases_)
      for (const AnsweredNumber& number : one.numbers) wrong_ += number.is_wrong ? 1 : 0;
  }

  std::vector<Diagnosis> run() {
    for (int i = 0; i < most_causes && left() > 0; ++i) {
      Cause cause = find_cause(cases_, mistakes_, {});
      if (cause.explains.empty()) break;
      tell(std::move(cause), {});
    }
    // Then each branch alone; those with the same cause are told together.
    std::set<std::string> branches;
    for (const AnsweredCase& one : cases_)
      if (has_left(one)) branches.insert(one.branch);
    std::vector<std::pair<Cause, std::vector<std::string>>> causes;
    for (const std::string& branch : branches) {
      if (branch.empty()) continue;
      Cause cause = find_cause(cases_, mistakes_, branch);
      if (cause.explains.empty()) continue;
      const auto same = std::find_if(causes.begin(), causes.end(), [&](const auto& one) {
        return one.first.choices == cause.choices;
      });
      if (same == causes.end()) {
        causes.push_back({std::move(cause), {branch}});
        continue;
      }
      same->first.changed += cause.changed;
      same->first.met += cause.met;
      same->first.explains.insert(same->first.explains.end(), cause.explains.begin(),
                                  cause.explains.end());
      same->second.push_back(branch);
    }
    for (auto& [cause, of_branches] : causes) tell(std::move(cause), of_branches);
    describe_rest();
    return std::move(found_);
  }

 private:
  static bool is_left(const AnsweredNumber& one) { return one.is_wrong && !one.is_explained; }
  static bool has_left(const AnsweredCase& one) {
    return std::any_of(one.numbers.begin(), one.numbers.end(), is_left);
  }
  std::size_t left() const {
    std::size_t count = 0;
    for (const AnsweredCase& one : cases_)
      count +=
          static_cast<std::size_t>(std::count_if(one.numbers.begin(), one.numbers.end(), is_left));
    return count;
  }

  std::string quantity(std::size_t place) const {
    for (const AnsweredCase& one : cases_)
      for (const AnsweredNumber& number : one.numbers)
        if (number.place == place) return quantity_name(*one.question.asked, *number.expected);
    return function_;
  }

  // The result that most of these numbers are of, with them as its wrong ones.
  Part shown(const std::vector<AnsweredNumber*>& explained) const {
    std::map<std::size_t, Part> parts;
    for (const AnsweredCase& one : cases_)
      for (const AnsweredNumber& number : one.numbers) {
        Part& part = parts[number.place];
        part.place = number.place;
        ++part.answered;
      }
    for (const AnsweredNumber* const one : explained) parts[one->place].wrong.push_back(one);
    return std::max_element(parts.begin(), parts.end(),
                            [](const auto& a, const auto& b) {
                              return a.second.wrong.size() < b.second.wrong.size();
                            })
        ->second;
  }

  // Adds the diagnosis of a cause that was found for all cases, or for these branches.
  void tell(Cause cause, const std::vector<std::string>& branches) {
    const Part part = shown(cause.explains);
    Diagnosis one{quantity(part.place), {}, cause.explains.size(), wrong_, {}};
    std::string causes;
    for (const Mistakes& choice : cause.choices) {
      std::string name, text;
      for (const Mistake* const mistake : choice) {
        name += (name.empty() ? "" : " + ") + mistake->name;
        text += (text.empty() ? "" : ", and ") + mistake->text;
      }
      one.mistakes.push_back(name);
      causes += (causes.empty() ? "" : "; or ") + text;
    }
    const std::size_t together = cause.choices.front().size();
    one.text = fmt::format(
        "{}{} is {}. These are the numbers that {}: {} ({} of {} answers of {} that {} would "
        "change, {} of {} that are wrong).",
        branches.empty() ? "" : fmt::format("For {}: ", fmt::join(branches, ", ")), one.quantity,
        pattern(part),
        together == 1   ? "this gives"
        : together == 2 ? "two mistakes give together"
                        : "three mistakes give together",
        causes, cause.met, cause.changed, function_, together == 1 ? "it" : "they",
        cause.explains.size(), wrong_);
    if (const auto before = named_before_.find(cause.choices.front().front()->follows);
        together == 1 && before != named_before_.end())
      one.text = fmt::format(
          "{} is {}. This follows from {}: its answers are taken here as it gives them ({} of {} "
          "answers that this would change).",
          one.quantity, pattern(part), before->second, cause.met, cause.changed);
    else if (one.mistakes.size() > 1)
      one.text += " The numbers do not tell these apart.";
    for (AnsweredNumber* const explained : cause.explains) explained->is_explained = true;
    found_.push_back(std::move(one));
  }

  // --- Wrong answers that no known mistakes give

  std::vector<Part> parts_left() const {
    std::map<std::pair<std::size_t, std::string>, Part> parts;
    for (const AnsweredCase& one : cases_)
      for (const AnsweredNumber& number : one.numbers) {
        Part& part = parts[{number.place, one.branch}];
        part.place = number.place;
        part.branch = one.branch;
        ++part.answered;
        if (is_left(number)) part.wrong.push_back(&number);
      }
    // After a named mistake, a few other wrong answers, such as near a border, are no news.
    std::map<std::string, std::pair<std::size_t, std::size_t>> counts;  // explained, left
    for (const AnsweredCase& one : cases_)
      for (const AnsweredNumber& number : one.numbers) {
        counts[one.branch].first += number.is_wrong && number.is_explained ? 1 : 0;
        counts[one.branch].second += is_left(number) ? 1 : 0;
      }
    std::vector<Part> all;
    for (auto& [key, part] : parts) {
      const auto [explained, rest] = counts[part.branch];
      const bool is_news = static_cast<double>(rest) > few * static_cast<double>(explained);
      if (!part.wrong.empty() && is_news) all.push_back(std::move(part));
    }
    return all;
  }

  // The exponents in a sentence: "It goes as F^+0.49; the law has F^-0.067."
  std::string exponents_in_words(const Part& part) const {
    const auto fitted = [&](const NumberOf& number_of) {
      return fit_power_law(cases_, part.branch, part.place, number_of, rounding);
    };
    const auto got = fitted([](const AnsweredCase&, const AnsweredNumber& one) { return one.got; });
    const auto law =
        fitted([](const AnsweredCase&, const AnsweredNumber& one) { return one.expected->high; });
    if (!got || !law) return {};
    const catalogue::Function& function = *cases_.front().question.function;
    std::vector<double> extra(got->exponents.size());
    for (std::size_t i = 0; i < extra.size(); ++i) extra[i] = got->exponents[i] - law->exponents[i];
    if (powers_in_words(function, extra).empty()) return {};
    std::string text = same_exponents(part, *got);
    if (!text.empty()) return text;
    const std::string in_groups = film_in_groups(function, *got);
    for (std::size_t i = 0; i < extra.size(); ++i) {
      if (std::abs(extra[i]) <= 1e-4) continue;
      const catalogue::Parameter& input = function.parameters[i];
      // Those of E* and R follow from those of U, G and W.
      if (!in_groups.empty() && (input.name == "effective_modulus" || input.unit == "m")) continue;
      const std::string symbol = symbol_of(input);
      if (std::abs(got->exponents[i]) <= 1e-4)
        text += fmt::format(" It does not depend on {}; the law has {}.", symbol,
                            power_in_words(input, law->exponents[i]));
      else if (std::abs(law->exponents[i]) <= 1e-4)
        text += fmt::format(" It goes as {}; the law does not depend on {}.",
                            power_in_words(input, got->exponents[i]), symbol);
      else
        text +=
            fmt::format(" It goes as {}; the law has {}.", power_in_words(input, got->exponents[i]),
                        power_in_words(input, law->exponents[i]));
    }
    if (!in_groups.empty()) return text + in_groups;
    return text + fmt::format(" In all an extra factor {}, times {:.6g}.",
                              powers_in_words(function, extra), got->constant / law->constant);
  }

  // " It is h/R = 1.9 U^+0.67 …" of a film that is a law in U, G and W with E′ = 2E*.
  static std::string film_in_groups(const catalogue::Function& function, const PowerLaw& got) {
    if (function.film_law == nullptr) return {};
    // of u, η₀, α (not of soft bodies), F or F/L, E*, R
    const std::vector<double>& e = got.exponents;
    const bool is_soft = function.parameters[2].name != "pressure_viscosity";
    const std::size_t load = is_soft ? 2 : 3;
    const double a = e[0], b = is_soft ? 0 : e[2], c = e[load];
    const double by_radius = function.film_law->is_of_lines ? 1 - a - c : 1 - a - 2 * c;
    const auto is = [](double x, double y) { return std::abs(x - y) <= 1e-4; };
    if (!is(e[1], a) || !is(e[load + 1], b - a - c) || !is(e[load + 2], by_radius)) return {};
    return fmt::format(" {} h/R = {:.6g} U^{:+.4g} G^{:+.4g} W^{:+.4g}.",
                       got.held.empty() ? "It is" : fmt::format("Where {}, it is", got.held),
                       got.constant * std::pow(2, a - b + c), a, std::round(b * 1e5) / 1e5 + 0.0,
                       c);
  }

  // A known mistake whose exponents these are, with another constant.
  std::string same_exponents(const Part& part, const PowerLaw& got) const {
    for (const Mistake& mistake : mistakes_) {
      const Mistake* const one = &mistake;
      const auto its = fit_power_law(
          cases_, part.branch, part.place,
          [&](const AnsweredCase& asked, const AnsweredNumber& number) {
            const std::optional<Numbers> given = numbers_with({&one, 1}, asked.question);
            return given ? (*given)[number.place] : unsaid;
          },
          rounding);
      if (!its) continue;
      bool is_same = true;
      for (std::size_t i = 0; i < got.exponents.size(); ++i)
        is_same = is_same && std::abs(its->exponents[i] - got.exponents[i]) <= 1e-4;
      if (!is_same) continue;
      return fmt::format(
          " Its exponents, {}, are those of this: {}. Its constant is {:.6g} times the one there.",
          powers_in_words(*cases_.front().question.function, got.exponents), mistake.text,
          got.constant / its->constant);
    }
    return {};
  }

  std::string constant_factor(const Part& part) const {
    double least = INFINITY, greatest = -INFINITY;
    for (const AnsweredNumber* const one : part.wrong) {
      if (one->expected->high == 0) return {};
      least = std::min(least, one->got / one->expected->high);
      greatest = std::max(greatest, one->got / one->expected->high);
    }
    return greatest - least < 1e-9 * std::abs(greatest) ? known_factor(least) : "";
  }

  struct Description {
    std::string text;
    bool is_cause;  // it says what the numbers are, not only where and how far they are off
  };
  Description described(const Part& part) const {
    std::string text = pattern(part);
    if (part.wrong.size() < part.answered)
      if (const std::string where = where_wrong(cases_, part.branch, part.place); !where.empty())
        text += ": " + where;
    text += '.';
    const std::string factor = constant_factor(part);
    if (!factor.empty()) return {text + ' ' + factor, true};
    const std::string powers = exponents_in_words(part);
    if (!powers.empty()) return {text + powers, true};
    if (std::string manner = manner_of_errors(cases_, part.branch, part.place); !manner.empty()) {
      manner[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(manner[0])));
      text += ' ' + manner + '.';
    }
    return {text, false};
  }

  // The greatest relative error of all answers.
  double greatest_error() const {
    double greatest = 0;
    for (const AnsweredCase& one : cases_)
      for (const AnsweredNumber& number : one.numbers)
        if (number.is_wrong)
          greatest = std::max(greatest, std::abs(number.error() / number.expected->high));
    return greatest;
  }

  void describe_rest() {
    // Branches that are off in the same way are told at once; the part with most wrong answers
    // first.
    std::vector<Part> parts = parts_left();
    if (parts.empty()) return;
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.wrong.size() > b.wrong.size(); });
    const std::size_t first = parts.front().place;
    Diagnosis one{quantity(first), {}, 0, wrong_, {}};
    if (greatest_error() < few_ulp) {
      one.text = fmt::format(
          "{} is off by at most {:.2g} of its value in {} of {} cases: rounding, and no wrong "
          "formula.",
          one.quantity, greatest_error(), parts.front().wrong.size(), parts.front().answered);
      found_.push_back(std::move(one));
      return;
    }
    if (greatest_error() < rounding && is_single_precision(cases_)) {
      one.text = fmt::format(
          "{} is off by at most {:.2g} of its value in {} of {} cases. All answers have at most "
          "nine digits: they are computed, or written, in single precision.",
          one.quantity, greatest_error(), parts.front().wrong.size(), parts.front().answered);
      found_.push_back(std::move(one));
      return;
    }
    if (!wrong_below_.empty()) {
      Part whole{first, {}, {}, 0};
      for (const Part& part : parts)
        if (part.place == first) {
          whole.answered += part.answered;
          whole.wrong.insert(whole.wrong.end(), part.wrong.begin(), part.wrong.end());
        }
      one.text = fmt::format("{} is {}. It rests on {}, wrong too: mend that first.", one.quantity,
                             pattern(whole), wrong_below_);
      found_.push_back(std::move(one));
      return;
    }
    std::vector<std::pair<std::string, std::vector<std::string>>> told;  // sentence, branches
    bool has_causes = true;
    for (const Part& part : parts) {
      if (part.place != first) continue;
      const Description description = described(part);
      const std::string& sentence = description.text;
      has_causes = has_causes && description.is_cause;
      const auto same = std::find_if(told.begin(), told.end(),
                                     [&](const auto& one) { return one.first == sentence; });
      if (same == told.end())
        told.push_back({sentence, {part.branch}});
      else
        same->second.push_back(part.branch);
    }
    for (auto& [sentence, branches] : told) {
      std::sort(branches.begin(), branches.end());
      if (branches.front().empty())
        one.text += fmt::format("{} is {}", one.quantity, sentence);
      else
        one.text += fmt::format("{}{}: {}", one.text.empty() ? one.quantity + ", " : " For ",
                                fmt::join(branches, ", "), sentence);
    }
    if (!has_causes)
      one.text += found_.empty() ? " None of the known mistakes gives these numbers."
                                 : " None of the known mistakes gives these others.";
    found_.push_back(std::move(one));
  }

  std::string function_;
  std::vector<AnsweredCase> cases_;
  const std::vector<Mistake>& mistakes_;
  std::string wrong_below_;  // functions that this one rests on and that are wrong
  const std::map<std::string, std::string>& named_before_;  // mistakes, with their functions
  std::size_t wrong_ = 0;
  std::vector<Diagnosis> found_;
};

}  // namespace

std::vector<Diagnosis> diagnose(const std::vector<Case>& cases, const Conversation& conversation,
                                const Tolerance& tolerance, const std::vector<Mistake>& all) {
  std::vector<std::string> functions;
  for (const Case& one : cases)
    if (std::find(functions.begin(), functions.end(), one.function) == functions.end())
      functions.push_back(one.function);
  std::vector<Diagnosis> found;
  std::set<std::string> wrong;
  std::map<std::string, std::string> named;
  for (const std::string& function : functions) {
    std::vector<Mistake> mistakes;
    for (const Mistake& one : all)
      if (one.function == (is_operating_point(function) ? "operating_point" : function))
        mistakes.push_back(one);
    std::string below;
    for (const std::string& other : rests_on(function))
      if (wrong.contains(other)) below += (below.empty() ? "" : ", ") + other;
    for (Diagnosis& one :
         Diagnoser(function, answered_cases(function, cases, conversation, tolerance), mistakes,
                   below, named)
             .run()) {
      wrong.insert(function);
      for (const std::string& mistake : one.mistakes) named[mistake] = function;
      found.push_back(std::move(one));
    }
  }
  return found;
}

}  // namespace tribo::conformance
