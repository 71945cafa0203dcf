// SPDX-License-Identifier: Apache-2.0
#include "conformance/diagnosis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "conformance/description.hpp"
#include "conformance/mistake_search.hpp"

namespace tribo::conformance {
namespace {

constexpr int most_causes = 3;     // told one after the other
constexpr double few_ulp = 1e-12;  // relative errors that are rounding

// The functions from which a function's numbers are computed.
std::vector<std::string> rests_on(const std::string& function) {
  if (function == "load_sharing") return {"gaussian_moment"};
  if (is_operating_point(function)) {
    // A point of the usual kind needs only the first film law and the circle.
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
    for (int i = 0; i < most_causes && any_left(); ++i) {
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
  static bool has_left(const AnsweredCase& one) {
    return std::any_of(one.numbers.begin(), one.numbers.end(),
                       [](const AnsweredNumber& number) { return number.is_left(); });
  }
  bool any_left() const { return std::any_of(cases_.begin(), cases_.end(), has_left); }

  // The result that most of these numbers are of, with them as its wrong ones.
  Part shown(const std::vector<AnsweredNumber*>& explained) const {
    std::map<std::size_t, Part> parts;
    for (const AnsweredCase& one : cases_)
      for (const AnsweredNumber& number : one.numbers) {
        Part& part = parts[number.place];
        part.place = number.place;
        part.all.push_back({&one, &number});
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
    Diagnosis one{part.quantity(), {function_}, {}, cause.explains.size(), wrong_, {}};
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
    if (branches.empty()) one.cause = causes;
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
        together == 1 && before != named_before_.end()) {
      one.cause = "follows from " + before->second;
      one.text = fmt::format(
          "{} is {}. This follows from {}: its answers are taken here as it gives them ({} of {} "
          "answers that this would change).",
          one.quantity, pattern(part), before->second, cause.met, cause.changed);
    } else if (one.mistakes.size() > 1)
      one.text += " The numbers do not tell these apart.";
    for (AnsweredNumber* const explained : cause.explains) explained->is_explained = true;
    found_.push_back(std::move(one));
  }

  // --- Wrong answers that no known mistakes give

  // "… is off by at most 1e-13 of its value …": errors that are no wrong formula. Empty where they
  // are larger.
  std::string precision_text(const std::string& quantity, const Part& part) const {
    double greatest = 0;  // relative error
    for (const AnsweredCase& one : cases_)
      for (const AnsweredNumber& number : one.numbers)
        if (number.is_wrong)
          greatest = std::max(greatest, std::abs(number.error() / number.expected->high));
    const std::string text =
        fmt::format("{} is off by at most {:.2g} of its value in {} of {} cases", quantity,
                    greatest, part.wrong.size(), part.all.size());
    if (greatest < few_ulp) return text + ": rounding, and no wrong formula.";
    if (greatest < rounding && is_single_precision(cases_))
      return text +
             ". All answers have at most nine digits: they are computed, or written, in single "
             "precision.";
    return {};
  }

  // The wrong answers of one result over all branches, if functions that it needs are wrong too.
  std::string rests_text(const std::string& quantity, std::size_t place,
                         const std::vector<Part>& parts) const {
    if (wrong_below_.empty()) return {};
    Part whole{place};
    for (const Part& part : parts)
      if (part.place == place) {
        whole.all.insert(whole.all.end(), part.all.begin(), part.all.end());
        whole.wrong.insert(whole.wrong.end(), part.wrong.begin(), part.wrong.end());
      }
    return fmt::format("{} is {}. It rests on {}, wrong too: mend that first.", quantity,
                       pattern(whole), wrong_below_);
  }

  // Branches that are off in the same way are told at once.
  std::string described_by_branch(const std::string& quantity, std::size_t place,
                                  const std::vector<Part>& parts) const {
    std::vector<std::pair<std::string, std::vector<std::string>>> told;  // sentence, branches
    bool has_causes = true;
    for (const Part& part : parts) {
      if (part.place != place) continue;
      const Description description = described(part, mistakes_);
      has_causes = has_causes && description.is_cause;
      const auto same = std::find_if(told.begin(), told.end(), [&](const auto& sentence) {
        return sentence.first == description.text;
      });
      if (same == told.end())
        told.push_back({description.text, {part.branch}});
      else
        same->second.push_back(part.branch);
    }
    std::string text;
    for (auto& [sentence, branches] : told) {
      std::sort(branches.begin(), branches.end());
      if (branches.front().empty())
        text += fmt::format("{} is {}", quantity, sentence);
      else
        text += fmt::format("{}{}: {}", text.empty() ? quantity + ", " : " For ",
                            fmt::join(branches, ", "), sentence);
    }
    if (has_causes) return text;
    return text + (found_.empty() ? " None of the known mistakes gives these numbers."
                                  : " None of the known mistakes gives these others.");
  }

  void describe_rest() {
    std::vector<Part> parts = parts_left(cases_);
    if (parts.empty()) return;
    // The part with most wrong answers first.
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.wrong.size() > b.wrong.size(); });
    const std::size_t first = parts.front().place;
    Diagnosis one{parts.front().quantity(), {function_}, {}, 0, wrong_, {}};
    one.text = precision_text(one.quantity, parts.front());
    if (one.text.empty()) one.text = rests_text(one.quantity, first, parts);
    if (one.text.empty()) one.text = described_by_branch(one.quantity, first, parts);
    found_.push_back(std::move(one));
  }

  std::string function_;
  std::vector<AnsweredCase> cases_;
  const std::vector<Mistake>& mistakes_;
  std::string wrong_below_;  // functions that this one needs and that are wrong
  const std::map<std::string, std::string>& named_before_;  // mistakes, with their functions
  std::size_t wrong_ = 0;
  std::vector<Diagnosis> found_;
};

// Adds a diagnosis to the one of the same cause in other functions, if there is one.
void add(std::vector<Diagnosis>& found, Diagnosis&& one) {
  const auto same = std::find_if(found.begin(), found.end(), [&](const Diagnosis& other) {
    return !one.cause.empty() && other.cause == one.cause;
  });
  if (same == found.end()) return found.push_back(std::move(one));
  same->functions.push_back(one.functions.front());
  same->explained += one.explained;
  same->wrong += one.wrong;
  for (std::string& mistake : one.mistakes)
    if (std::find(same->mistakes.begin(), same->mistakes.end(), mistake) == same->mistakes.end())
      same->mistakes.push_back(std::move(mistake));
}

// Where the cause is found in several functions, as they share a helper.
std::string shared_text(const Diagnosis& one) {
  if (one.functions.size() == 1) return {};
  const std::vector<std::string> others(one.functions.begin() + 1, one.functions.end());
  return fmt::format(" The same explains the answers of {}.", fmt::join(others, ", "));
}

}  // namespace

std::vector<Diagnosis> diagnose(const std::vector<TestCase>& cases,
                                const Conversation& conversation, const Tolerance& tolerance,
                                const std::vector<Mistake>& all) {
  std::vector<std::string> functions;
  for (const TestCase& one : cases)
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
      add(found, std::move(one));
    }
  }
  for (Diagnosis& one : found) one.text += shared_text(one);
  return found;
}

}  // namespace tribo::conformance
