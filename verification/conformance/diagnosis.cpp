// SPDX-License-Identifier: Apache-2.0
#include "conformance/diagnosis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "conformance/description.hpp"
#include "conformance/expression.hpp"
#include "conformance/follow.hpp"
#include "conformance/misread.hpp"
#include "conformance/mistake_search.hpp"
#include "conformance/solved_mistakes.hpp"
#include "conformance/words.hpp"
#include "tribo/hertz_ellipse.hpp"

namespace tribo::conformance {
namespace {

// The end of a text without a cause.
constexpr const char* unknown = " None of the known mistakes gives these ";
constexpr int most_causes = 3;     // reported one after the other
constexpr double few_ulp = 1e-12;  // relative errors that are rounding
constexpr std::size_t fewest_followed = 3;
constexpr double closeness_of_misread = 1e-4;
// Points in which only other results are wrong are described by themselves if there are at least so
// many, and at least this part of the points in which the result that is computed first is wrong.
constexpr std::size_t fewest_others = 3;
constexpr double part_of_others = 0.25;

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
    for (const std::string_view word : film_formula_words)
      if (is_film_of_points(word)) below.emplace_back(word);
    return below;
  }
  return {};
}

class Diagnoser {
 public:
  Diagnoser(std::string function, std::vector<AnsweredCase> cases,
            const std::vector<Mistake>& mistakes, std::vector<const WrongFunction*> below,
            const std::map<std::string, std::string>& named_before)
      : function_(std::move(function)),
        cases_(std::move(cases)),
        mistakes_(mistakes),
        below_(std::move(below)),
        named_before_(named_before) {
    for (const AnsweredCase& one : cases_)
      for (const AnsweredNumber& number : one.numbers) {
        wrong_ += number.is_wrong ? 1 : 0;
        if (number.is_wrong) with_wrong_numbers_.insert(one.question.asked);
      }
  }

  std::vector<Diagnosis> run() {
    follow_by_number();
    find_causes();
    follow_by_ellipticity();
    if (follow_by_use()) find_causes();
    describe_rest();
    return std::move(found_);
  }

  const std::set<const TestCase*>& cases_with_wrong_numbers() const { return with_wrong_numbers_; }

  // This function, for the diagnosis of functions that are computed from it.
  WrongFunction as_below() const {
    return {function_, as_answered_.empty() ? cases_ : as_answered_, named()};
  }
  std::vector<Mistake> named() const {
    std::vector<Mistake> named;
    for (const Mistake* const one : named_) named.push_back(*one);
    return named;
  }

  static bool has_left(const AnsweredCase& one) {
    return std::any_of(one.numbers.begin(), one.numbers.end(),
                       [](const AnsweredNumber& number) { return number.is_left(); });
  }

 private:
  void find_causes() {
    for (int i = 0; i < most_causes && any_left(); ++i) {
      Cause cause = find_cause(cases_, mistakes_, {});
      if (cause.explains.empty() || (cause.is_rough && is_another_read())) break;
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
  }

  // Whether a misread input or number gives all wrong answers. This says more than a mistake that
  // gives them only roughly.
  bool is_another_read() const {
    const std::vector<Part> parts = parts_left(cases_);
    return !is_operating_point(function_) &&
           std::all_of(parts.begin(), parts.end(), [&](const Part& part) {
             return misread_input(part, mistakes_).has_value();
           });
  }

  bool any_left() const { return std::any_of(cases_.begin(), cases_.end(), has_left); }

  // The part of the result that has most of these numbers. They become its `wrong`.
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

  // --- What follows from functions below

  // A wrong function from which an answer is computed, and the mistake that points have by it.
  // Null: the function is not known well enough there.
  struct Used {
    const WrongFunction* below;
    const Mistake* at_points;
  };

  std::vector<Used> used_by(const AnsweredCase& one, bool is_shared_alike = false) const {
    std::vector<Used> used;
    const std::vector<Question> inner = inner_questions(one.asked);
    for (const WrongFunction* const below : below_)
      for (const Question& question : inner)
        if (below->is_wrong_at(question)) {
          used.push_back({below, below->at_points(question, is_shared_alike)});
          break;
        }
    return used;
  }

  struct Followed {
    AnsweredCase* of;
    Question question;  // with the functions below as the subject has them
    Numbers numbers;    // the results that follow
    double closeness;   // how closely they are known
    std::vector<Used> from;
  };

  // Empty: one of these wrong functions is not known well enough.
  static std::optional<Followed> followed(AnsweredCase& one, std::vector<Used> used) {
    Mistakes together;
    Question question = one.question;
    double closeness = 0;
    for (const auto& [below, mistake] : used) {
      if (mistake == nullptr) return std::nullopt;
      together.push_back(mistake);
      if (mistake->before) mistake->before(question);
      closeness = std::max(closeness, below->closeness());
    }
    const std::optional<Numbers> numbers = numbers_with(together, one.question);
    if (!numbers) return std::nullopt;
    return Followed{&one, std::move(question), *numbers, closeness, std::move(used)};
  }

  static bool is_met(const AnsweredNumber& number, const Followed& followed) {
    const double given = followed.numbers[number.place];
    if (!std::isfinite(given)) return false;
    const double change = std::abs(given - number.expected->high);
    return std::abs(number.got - given) <=
           std::max(number.allowed, followed.closeness * std::min(change, std::abs(given)));
  }

  // Explains the answers of points that are right if the functions below are as the subject has
  // them. The other answers are then judged by the numbers that follow from these functions.
  void follow_by_number() {
    if (below_.empty() || !any_left()) return;
    FollowedPoints points = all_followed(false);
    if (points.met.size() < wrong_) {
      FollowedPoints alike = all_followed(true);
      if (alike.met.size() > points.met.size()) points = std::move(alike);
    }
    auto& [all, met, lost] = points;
    if (met.size() < fewest_followed || lost > met.size()) return;
    std::set<std::string> from;
    for (const Followed& one : all)
      for (const Used& used : one.from) from.insert(used.below->name());
    tell_followed(met, from);
    is_followed_ = true;
    for (Followed& one : all) {
      one.of->question = std::move(one.question);
      for (AnsweredNumber& number : one.of->numbers) shift(number, one);
    }
  }

  // The results of an ellipse whose axes have the ratio that is answered.
  static Numbers ellipse_of_ratio(const Question& asked, double answered) {
    const bool is_exchanged = asked.arguments[3] < asked.arguments[2];
    const double k = is_exchanged ? 1 / answered : answered;
    const auto [b, d] = detail::associated_integrals(k);
    Expression law = *law_expression(*asked.function);
    for (Expression::Node& node : law.nodes)
      for (const auto& [name, value] :
           {std::pair{"k", k}, std::pair{"K", b + d}, std::pair{"E", b + d / k / k}})
        if (node.kind == Expression::Op::given && node.name == name)
          node.get = [value = value](const catalogue::Arguments&) { return value; };
    Numbers numbers{};
    for (std::size_t i = 0; i < law.results.size(); ++i)
      numbers[i] = law.value(law.results[i], asked.arguments);
    return numbers;
  }
  // Explains the results of an ellipse that follow from its wrong ratio of axes. The other results
  // are then judged by this ratio, too.
  void follow_by_ellipticity() {
    constexpr std::size_t ratio = 2;
    if (function_ != "hertz_ellipse" || !any_left()) return;
    std::vector<Followed> all;
    std::vector<AnsweredNumber*> met;
    std::size_t unmet_axes = 0;
    for (AnsweredCase& one : cases_) {
      const auto answered =
          std::find_if(one.numbers.begin(), one.numbers.end(),
                       [](const AnsweredNumber& number) { return number.place == ratio; });
      if (answered == one.numbers.end() || !answered->is_left() || !(answered->got > 0)) continue;
      all.push_back({&one,
                     one.question,
                     ellipse_of_ratio(one.question, answered->got),
                     engineering_tolerance().relative,
                     {}});
      for (AnsweredNumber& number : one.numbers) {
        if (number.place == ratio || !number.is_left()) continue;
        if (is_met(number, all.back())) met.push_back(&number);
        unmet_axes += number.place < ratio && !is_met(number, all.back()) ? 1 : 0;
      }
    }
    if (met.size() < fewest_followed || unmet_axes > 0) return;
    as_answered_ = cases_;
    tell_followed(met, {"its ellipticity"});
    for (const Followed& one : all)
      for (AnsweredNumber& number : one.of->numbers)
        if (number.place != ratio) shift(number, one);
  }

  struct FollowedPoints {
    std::vector<Followed> all;
    std::vector<AnsweredNumber*> met;
    std::size_t lost = 0;  // right answers that would be wrong
  };
  FollowedPoints all_followed(bool is_shared_alike) {
    FollowedPoints points;
    auto& [all, met, lost] = points;
    for (AnsweredCase& one : cases_) {
      std::vector<Used> used = used_by(one, is_shared_alike);
      if (used.empty()) continue;
      std::optional<Followed> found = followed(one, std::move(used));
      if (!found) continue;
      for (AnsweredNumber& number : one.numbers) {
        if (number.is_wrong && is_met(number, *found)) met.push_back(&number);
        lost += !number.is_wrong && !is_met(number, *found) ? 1 : 0;
      }
      all.push_back(std::move(*found));
    }
    return points;
  }

  void tell_followed(const std::vector<AnsweredNumber*>& met, const std::set<std::string>& from) {
    const Part part = shown(met);
    found_.push_back({part.quantity(),
                      {function_},
                      {},
                      met.size(),
                      wrong_,
                      fmt::format("{} is {}. This follows from {}: with the answers that it gives "
                                  "there, {} of {} wrong answers of {} are right.",
                                  part.quantity(), pattern(part), fmt::join(from, ", "), met.size(),
                                  wrong_, function_)});
    for (AnsweredNumber* const one : met) one->is_explained = true;
  }

  // Judges a number by what follows from the wrong functions below, unless it is explained.
  void shift(AnsweredNumber& number, const Followed& followed) {
    const double given = followed.numbers[number.place];
    if (number.is_explained || !std::isfinite(given)) return;
    number.is_wrong = !is_met(number, followed);
    expect(number, given);
  }

  void expect(AnsweredNumber& number, double given) {
    shifted_.push_back(*number.expected);
    shifted_.back().high = given;
    shifted_.back().low = 0;
    number.expected = &shifted_.back();
  }

  // Whether a wrong function can change this result of a point.
  static bool reaches(const WrongFunction& below, const AnsweredNumber& number) {
    return below.name() != "starvation_ratio" || number.expected->field != "film_flooded";
  }

  // Reports the wrong answers left that use a function below where it is wrong, and removes their
  // cases. Returns whether there were some, and other wrong answers are left.
  bool follow_by_use() {
    if (below_.empty() || !any_left()) return false;
    std::map<std::size_t, Part> parts;
    std::set<std::string> from;
    std::vector<const AnsweredCase*> resting;
    for (const AnsweredCase& one : cases_) {
      if (!has_left(one)) continue;
      std::vector<Used> used = used_by(one);
      // A function with one or two wrong answers says too little of where it is wrong.
      std::erase_if(used, [&](const Used& wrong) {
        return (is_followed_ && wrong.at_points != nullptr) ||
               wrong.below->wrong_answers() < fewest_followed;
      });
      for (const AnsweredNumber& number : one.numbers) {
        if (!number.is_left()) continue;
        for (const Used& wrong : used)
          if (reaches(*wrong.below, number)) {
            from.insert(wrong.below->name());
            parts[number.place].wrong.push_back(&number);
            if (resting.empty() || resting.back() != &one) resting.push_back(&one);
            break;
          }
      }
    }
    if (resting.empty()) return false;
    for (const AnsweredCase& one : cases_)
      for (const AnsweredNumber& number : one.numbers)
        parts[number.place].all.push_back({&one, &number});
    const Part& part =
        std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
          return a.second.wrong.size() < b.second.wrong.size();
        })->second;
    found_.push_back({part.quantity(),
                      {function_},
                      {},
                      0,
                      wrong_,
                      fmt::format("{} is {}. It rests on {}, wrong too: mend that first.",
                                  part.quantity(), pattern(part), fmt::join(from, ", ")),
                      {}});
    std::erase_if(cases_, [&](const AnsweredCase& one) {
      return std::find(resting.begin(), resting.end(), &one) != resting.end();
    });
    return any_left();
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
          "{} is {}. This goes with {}, which is off alike: {} ({} of {} answers that it would "
          "change). This function is given the right input, so mend both.",
          one.quantity, pattern(part), before->second, causes, cause.met, cause.changed);
    } else if (one.mistakes.size() > 1)
      one.text += " The numbers do not tell these apart.";
    for (AnsweredNumber* const explained : cause.explains) explained->is_explained = true;
    if (cause.left_out && has_wrong(*cause.left_out))
      expect_with(cause.choices.front(), *cause.left_out);
    if (branches.empty()) misread_left(cause.choices.front());
    for (const Mistake* const mistake : cause.choices.front()) named_.push_back(mistake);
    found_.push_back(std::move(one));
  }

  // Whether an answer of this result is wrong.
  bool has_wrong(std::size_t place) const {
    return std::any_of(cases_.begin(), cases_.end(), [&](const AnsweredCase& one) {
      return std::any_of(one.numbers.begin(), one.numbers.end(), [&](const AnsweredNumber& number) {
        return number.place == place && number.is_wrong;
      });
    });
  }

  // Takes the points with wrong answers left as these mistakes misread them: what else is wrong
  // there stands beside them.
  void misread_left(const Mistakes& mistakes) {
    if (!is_operating_point(function_) ||
        std::any_of(mistakes.begin(), mistakes.end(),
                    [](const Mistake* one) { return one->instead || one->after || one->applies; }))
      return;
    for (AnsweredCase& one : cases_) {
      if (!has_left(one)) continue;
      Question question = one.question;
      for (const Mistake* const mistake : mistakes) mistake->before(question);
      const Followed misread{&one, question, right_numbers(question), closeness_of_misread, {}};
      for (AnsweredNumber& number : one.numbers) {
        const double given = misread.numbers[number.place];
        if (number.is_left())
          shift(number, misread);
        else if (number.is_explained && std::isfinite(given))
          expect(number, given);  // a further mistake does not change it by what these do
      }
      one.question = std::move(question);
    }
  }

  // Judges a result by what the mistakes give, because something else changes it as well.
  void expect_with(const Mistakes& mistakes, std::size_t place) {
    for (AnsweredCase& one : cases_)
      for (AnsweredNumber& number : one.numbers)
        if (number.place == place)
          if (const std::optional<Numbers> given = numbers_with(mistakes, one.question))
            shift(number, {&one, one.question, *given, closeness_of_misread, {}});
  }

  // --- Wrong answers that no known mistakes give

  // "… is off by at most 1e-13 of its value …": errors too small for a wrong formula. Empty if they
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
    const std::string digits = few_digits(cases_, greatest);
    return digits.empty() ? digits : text + ". " + digits;
  }

  // Branches that are off in the same way share a sentence.
  std::string described_by_branch(const std::string& quantity, std::size_t place,
                                  const std::vector<Part>& parts, Description& last) const {
    std::string& cause = last.cause;
    std::vector<std::pair<std::string, std::vector<std::string>>> told;  // sentence, branches
    bool has_causes = true, is_one_cause = true;
    for (const Part& part : parts) {
      if (part.place != place) continue;
      Description description = described(part, mistakes_, !below_.empty());
      has_causes = has_causes && description.is_cause;
      is_one_cause = is_one_cause && (told.empty() || description.cause == cause);
      last = description;
      if (!is_one_cause) cause.clear();
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
    return text + unknown + (found_.empty() ? "numbers." : "others.");
  }

  // Describes the result with most wrong answers, and other results that have another cause. If
  // enough points are wrong only in other results, it first describes the result that is computed
  // first, and then those points by themselves.
  void describe_rest() {
    std::vector<Part> parts = parts_left(cases_);
    if (parts.empty()) return;
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.wrong.size() > b.wrong.size(); });
    if (is_operating_point(function_)) {
      const auto first =
          std::min_element(parts.begin(), parts.end(),
                           [](const Part& a, const Part& b) { return a.place < b.place; });
      const std::size_t place = first->place;
      if (is_wrong_elsewhere(first->wrong.size())) {
        const Description told = describe(parts, place);
        explain_by(told.change, place);
        leave_out(place, told.is_in_place);
        if (is_wrong_elsewhere(0)) find_causes();
        if (is_wrong_elsewhere(0)) describe_rest();
        return;
      }
      // A wrong number inside of points shows first in the result that is computed first from it.
      std::sort(parts.begin(), parts.end(),
                [](const Part& a, const Part& b) { return a.place < b.place; });
      for (const Part& part : parts)
        if (tell_insides(part)) return describe_rest();
      std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
        return a.wrong.size() > b.wrong.size();
      });
    }
    explain_by(describe(parts, parts.front().place).change, parts.front().place);
    // Other results of the function have a line of their own if they have another cause.
    std::set<std::size_t> told{parts.front().place};
    for (const Part& part : parts)
      if (std::any_of(part.wrong.begin(), part.wrong.end(),
                      [](const AnsweredNumber* one) { return one->is_left(); }) &&
          told.insert(part.place).second) {
        describe(parts, part.place);
        const Diagnosis& last = found_.back();
        const bool is_old =
            std::any_of(found_.begin(), found_.end() - 1, [&](const Diagnosis& one) {
              return one.quantity != last.quantity && !one.cause.empty() && one.cause == last.cause;
            });
        if (is_old || last.text.find(unknown) != std::string::npos) found_.pop_back();
      }
  }

  // Whether enough points are wrong besides the `told` ones that are reported.
  bool is_wrong_elsewhere(std::size_t told) const {
    const auto wrong =
        static_cast<std::size_t>(std::count_if(cases_.begin(), cases_.end(), has_left));
    return wrong >= told + fewest_others &&
           static_cast<double>(wrong - told) >= part_of_others * static_cast<double>(told);
  }

  // Marks other results as explained if the same misreading gives them.
  void explain_by(const std::function<void(Question&)>& change, std::size_t place) {
    for (AnsweredCase& one : cases_) {
      if (!change || !has_left(one)) continue;
      Question misread = one.question;
      change(misread);
      const Followed followed{&one, misread, right_numbers(misread), closeness_of_misread, {}};
      for (AnsweredNumber& number : one.numbers)
        number.is_explained = number.is_explained || (number.is_left() && number.place != place &&
                                                      is_met(number, followed));
    }
  }

  // Removes points in which result `place` is wrong, and wrong points for which `is_in_place`
  // holds.
  void leave_out(std::size_t place, const std::function<bool(const Question&)>& is_in_place) {
    std::erase_if(cases_, [&](const AnsweredCase& one) {
      const bool is_told = std::any_of(
          one.numbers.begin(), one.numbers.end(),
          [&](const AnsweredNumber& number) { return number.place == place && number.is_left(); });
      return is_told || (has_left(one) && is_in_place && is_in_place(one.asked));
    });
  }

  Description describe(const std::vector<Part>& parts, std::size_t place) {
    const Part& part = *std::find_if(parts.begin(), parts.end(),
                                     [&](const Part& one) { return one.place == place; });
    Diagnosis one{part.quantity(), {function_}, {}, 0, wrong_, {}};
    one.text = precision_text(one.quantity, part);
    Description last{};
    if (one.text.empty()) one.text = described_by_branch(one.quantity, place, parts, last);
    one.cause = last.cause;
    if (last.is_cause || !tell_insides(part)) found_.push_back(std::move(one));
    return last;
  }

  // Reports wrong numbers inside of points, alone or beside a known mistake. False: there are none.
  bool tell_insides(const Part& part) {
    if (!is_operating_point(function_)) return false;
    const std::vector<Mistake> solved = solved_insides(part);
    if (solved.empty()) return false;
    std::vector<Mistake>& all = solved_.emplace_back();
    for (const Mistake& one : mistakes_) all.push_back(one);
    all.insert(all.end(), solved.begin(), solved.end());
    Cause cause = find_cause(cases_, all, {});
    if (cause.explains.empty()) return false;
    tell(std::move(cause), {});
    return true;
  }

  std::string function_;
  std::vector<AnsweredCase> cases_;
  std::vector<AnsweredCase> as_answered_;  // before follow_by_ellipticity() judged them
  const std::vector<Mistake>& mistakes_;
  std::vector<const WrongFunction*> below_;  // wrong functions that this one needs
  std::deque<Expected> shifted_;             // expected numbers that follow from them
  std::deque<std::vector<Mistake>> solved_;  // of numbers inside of points
  const std::map<std::string, std::string>& named_before_;  // names, and their functions
  std::size_t wrong_ = 0;
  std::set<const TestCase*> with_wrong_numbers_;
  bool is_followed_ = false;           // some answers follow from functions below
  std::vector<const Mistake*> named_;  // of the first choice of each cause
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

// The questions whose parts a solver may keep for this function: of points those of all kinds.
std::vector<Question> questions_in_order(const std::string& function,
                                         const std::vector<TestCase>& cases) {
  std::vector<Question> order;
  for (const TestCase& one : cases)
    if (one.function == function ||
        (is_operating_point(function) && is_operating_point(one.function)))
      order.push_back(question_of(one));
  return order;
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
  const auto is_rested_on = [&](const std::string& inner) {
    return std::any_of(functions.begin(), functions.end(), [&](const std::string& outer) {
      const std::vector<std::string> below = rests_on(outer);
      return std::find(below.begin(), below.end(), inner) != below.end();
    });
  };
  std::vector<Diagnosis> found;
  std::vector<WrongFunction> wrong;
  std::map<std::string, std::string> named;
  std::vector<Mistake> of_points;  // solved for; other kinds of points may have them, too
  for (const std::string& function : functions) {
    std::vector<Mistake> mistakes =
        is_operating_point(function) ? of_points : std::vector<Mistake>();
    for (const Mistake& one : all)
      if (one.function == (is_operating_point(function) ? "operating_point" : function))
        mistakes.push_back(one);
    std::vector<const WrongFunction*> below;
    for (const std::string& other : rests_on(function))
      for (const WrongFunction& one : wrong)
        if (one.name() == other) below.push_back(&one);
    std::vector<AnsweredCase> answered = answered_cases(function, cases, conversation, tolerance);
    std::vector<Mistake> solved = solved_mistakes(answered);
    if (std::any_of(answered.begin(), answered.end(), Diagnoser::has_left))
      for (Mistake& one : kept_parts(answered, questions_in_order(function, cases)))
        solved.push_back(std::move(one));
    for (Mistake& one : solved)
      if (std::none_of(mistakes.begin(), mistakes.end(),
                       [&](const Mistake& known) { return known.name == one.name; }))
        mistakes.push_back(std::move(one));
    Diagnoser diagnoser(function, std::move(answered), mistakes, std::move(below), named);
    std::vector<Diagnosis> of_function = diagnoser.run();
    if (!of_function.empty() && is_rested_on(function)) wrong.push_back(diagnoser.as_below());
    if (is_operating_point(function))
      for (Mistake& one : diagnoser.named())
        if (std::none_of(mistakes.begin(), mistakes.end(),
                         [&](const Mistake& known) { return known.name == one.name; }))
          of_points.push_back(std::move(one));
    for (Diagnosis& one : of_function) {
      for (const std::string& mistake : one.mistakes) named[mistake] = function;
      add(found, std::move(one));
    }
    for (Diagnosis& one :
         diagnose_words(function, cases, conversation, diagnoser.cases_with_wrong_numbers()))
      add(found, std::move(one));
  }
  for (Diagnosis& one : found) one.text += shared_text(one);
  return found;
}

}  // namespace tribo::conformance
