// SPDX-License-Identifier: Apache-2.0
#include "conformance/mistake_search.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace tribo::conformance {
namespace {

constexpr double consistent = 0.98;  // of the answers that a cause changes
constexpr std::size_t fewest = 3;    // of them
constexpr double closeness_alone = 2e-3, closeness_together = 1e-5;  // of the change
constexpr std::size_t most_probes = 12;
constexpr std::size_t most_choices = 3;

struct Fit {
  Mistakes mistakes;
  std::size_t changed = 0, met = 0;
  std::size_t met_closely = 0;  // to the closeness that several mistakes need
  std::vector<AnsweredNumber*> explains;

  bool is_consistent() const { return is_enough(met); }
  bool is_close() const { return is_enough(met_closely); }

 private:
  bool is_enough(std::size_t count) const {
    return changed >= fewest &&
           static_cast<double>(count) >= consistent * static_cast<double>(changed);
  }
};

class Search {
 public:
  // `left_out`: a result that is not looked at, as it may have a mistake that nobody knows.
  Search(std::vector<AnsweredCase>& cases, const std::string& branch,
         std::optional<std::size_t> left_out)
      : left_out_(left_out) {
    std::vector<AnsweredCase*> wrong;
    for (AnsweredCase& one : cases) {
      if (!branch.empty() && one.branch != branch) continue;
      cases_.push_back(&one);
      if (std::any_of(one.numbers.begin(), one.numbers.end(),
                      [](const AnsweredNumber& number) { return number.is_left(); }))
        wrong.push_back(&one);
    }
    // Neighbours are alike: probes lie far from each other.
    const std::size_t count = std::min(most_probes, wrong.size());
    for (std::size_t i = 0; i < count; ++i) probes_.push_back(wrong[i * wrong.size() / count]);
    is_one_number_ = is_one_number(wrong);
  }

  bool has_wrong() const { return !probes_.empty(); }
  bool is_wrong_at(std::size_t place) const {
    return std::any_of(cases_.begin(), cases_.end(), [place](const AnsweredCase* const one) {
      return std::any_of(one->numbers.begin(), one->numbers.end(),
                         [place](const AnsweredNumber& number) {
                           return number.place == place && number.is_left();
                         });
    });
  }

  // Whether all wrong answers are one number, as a guard gives it. Such answers do not show several
  // mistakes.
  bool is_one_number() const { return is_one_number_; }

  // Whether the mistakes give the answers of all probes, or of all but one. These few evaluations
  // rule out nearly all causes.
  bool is_likely(const Mistakes& mistakes) const {
    std::size_t met = 0, unmet = 0;
    for (const AnsweredCase* const probe : probes_) {
      const std::optional<Numbers> given = numbers_with(mistakes, probe->question);
      if (!given) continue;
      const bool is_met =
          std::all_of(probe->numbers.begin(), probe->numbers.end(), [&](const AnsweredNumber& one) {
            return !std::isfinite((*given)[one.place]) || one.place == left_out_ ||
                   is_close(one, (*given)[one.place], mistakes.size());
          });
      ++(is_met ? met : unmet);
      if (unmet > 1) return false;
    }
    return met > 0;
  }

  // Whether one of the mistakes alone makes right numbers of the probes wrong. The other mistakes
  // then undo its effect there, and a factor in one result is a simpler cause.
  bool is_taken_back(const Mistakes& mistakes) const {
    return std::any_of(mistakes.begin(), mistakes.end(), [&](const Mistake* const mistake) {
      return std::any_of(probes_.begin(), probes_.end(), [&](const AnsweredCase* const probe) {
        const std::optional<Numbers> given = numbers_with(std::span(&mistake, 1), probe->question);
        return given && std::any_of(probe->numbers.begin(), probe->numbers.end(),
                                    [&](const AnsweredNumber& one) {
                                      const double value = (*given)[one.place];
                                      return !one.is_wrong && std::isfinite(value) &&
                                             change(one, value) > 5 * one.allowed;
                                    });
      });
    });
  }

  // Does the fit explain a tenth of the wrong answers of some result? A mistake that fits only on
  // one side of a border says little if answers on the other side are wrong, too.
  bool is_worth_telling(const Fit& made) const {
    std::map<std::size_t, std::size_t> explained, wrong;
    for (const AnsweredNumber* const one : made.explains) ++explained[one->place];
    for (const AnsweredCase* const one : cases_)
      for (const AnsweredNumber& number : one->numbers)
        wrong[number.place] += number.is_left() ? 1 : 0;
    return std::any_of(explained.begin(), explained.end(),
                       [&](const auto& one) { return 10 * one.second >= wrong[one.first]; });
  }

  // Ends early where the mistakes are clearly not consistent.
  Fit fit(const Mistakes& mistakes) const {
    Fit made;
    made.mistakes = mistakes;
    for (AnsweredCase* const one : cases_) {
      const std::optional<Numbers> given = numbers_with(mistakes, one->question);
      if (!given) continue;
      for (AnsweredNumber& number : one->numbers) {
        const double value = (*given)[number.place];
        if (!std::isfinite(value) || number.place == left_out_) continue;
        const bool is_met = is_close(number, value, mistakes.size());
        if (is_met && number.is_left()) made.explains.push_back(&number);
        if (!(change(number, value) > 5 * number.allowed)) continue;  // too little to tell
        ++made.changed;
        made.met += is_met ? 1 : 0;
        made.met_closely += is_close(number, value, 2) ? 1 : 0;
      }
      if (made.changed - made.met > 20 && made.met < 10 * (made.changed - made.met)) break;
    }
    return made;
  }

 private:
  static bool is_one_number(const std::vector<AnsweredCase*>& wrong) {
    std::optional<double> first;
    for (const AnsweredCase* const one : wrong)
      for (const AnsweredNumber& number : one->numbers) {
        if (!number.is_left()) continue;
        if (!first) first = number.got;
        if (number.got != *first) return false;
      }
    return true;
  }
  static double change(const AnsweredNumber& number, double given) {
    return std::abs((given - number.expected->high) - number.expected->low);
  }
  static bool is_close(const AnsweredNumber& number, double given, std::size_t mistakes) {
    const double off = std::abs(number.got - given), by = change(number, given);
    const double own = std::abs(given), allowed = number.allowed_of(given);
    if (mistakes == 1) return off <= std::max(allowed, closeness_alone * std::min(by, own));
    // There are thousands of sets: with a generous tolerance one would fit by chance.
    const Expected& expected = *number.expected;
    const double tight = engineering_tolerance().relative * expected.condition;
    return off <= std::max(std::min(allowed, tight * std::min(std::abs(expected.high), own)),
                           closeness_together * std::min(by, own));
  }

  std::optional<std::size_t> left_out_;
  std::vector<AnsweredCase*> cases_;
  std::vector<const AnsweredCase*> probes_;
  bool is_one_number_ = false;
};

// All sets of `count` mistakes that can be made together, in the order of the file.
template <class Visit>
void for_each_set(const std::vector<Mistake>& mistakes, std::size_t count, Mistakes& set,
                  std::size_t from, Visit&& visit) {
  if (set.size() == count) return visit(std::as_const(set));
  for (std::size_t i = from; i < mistakes.size(); ++i) {
    if (std::any_of(set.begin(), set.end(),
                    [&](const Mistake* one) { return !one->can_stand_beside(mistakes[i]); }))
      continue;
    set.push_back(&mistakes[i]);
    for_each_set(mistakes, count, set, i + 1, visit);
    set.pop_back();
  }
}

void sort_by_what_they_explain(std::vector<Fit>& fits) {
  std::stable_sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) {
    return a.explains.size() > b.explains.size();
  });
}

// The causes with the fewest mistakes, sorted by the number of answers that they explain, from most
// to least. `is_quick`: only causes that give the answers of nearly all probes are looked at.
std::vector<Fit> best_fits(const Search& search, const std::vector<Mistake>& mistakes,
                           std::size_t most, bool is_quick = false) {
  std::vector<Fit> best;
  if (search.is_one_number()) most = 1;
  for (std::size_t count = 1; count <= most; ++count) {
    std::vector<Fit> fits;
    Mistakes set;
    for_each_set(mistakes, count, set, 0, [&](const Mistakes& one) {
      if ((count > 1 || is_quick) && !search.is_likely(one)) return;
      if (count > 2 && search.is_taken_back(one)) return;
      Fit made = search.fit(one);
      if (made.is_consistent() && search.is_worth_telling(made)) fits.push_back(std::move(made));
    });
    if (fits.empty()) continue;
    sort_by_what_they_explain(fits);
    const bool is_close = fits.front().is_close();
    if (best.empty() || is_close) best = std::move(fits);
    // One mistake that is met roughly may be two that are met closely.
    if (is_close) break;
  }
  return best;
}

}  // namespace

Cause find_cause(std::vector<AnsweredCase>& cases, const std::vector<Mistake>& mistakes,
                 const std::string& branch) {
  Cause cause;
  const Search search(cases, branch, {});
  if (!search.has_wrong()) return cause;
  const catalogue::Function* const function = cases.front().question.function;
  // Three at once of an operating point's many mistakes would take seconds.
  std::vector<Fit> best = best_fits(search, mistakes, function == nullptr ? 2 : 3);
  // Each result is left out in turn: a mistake in it that nobody knows would hide the mistakes in
  // the others. A result without wrong answers may have a formula of its own. It then allows one
  // mistake elsewhere, not two.
  const bool is_point = function == nullptr;
  const std::size_t results = !is_point      ? function->results.size()
                              : best.empty() ? number_count
                                             : 0;
  for (std::size_t place = 0; results > 1 && place < results; ++place) {
    std::vector<Fit> fits = best_fits(Search(cases, branch, place), mistakes,
                                      is_point || !search.is_wrong_at(place) ? 1 : 2, is_point);
    // They may explain the result that was left out, too.
    for (Fit& one : fits)
      if (Fit whole = search.fit(one.mistakes); whole.is_consistent()) one = std::move(whole);
    sort_by_what_they_explain(fits);
    if (!fits.empty() &&
        (best.empty() || fits.front().explains.size() > best.front().explains.size())) {
      best = std::move(fits);
      cause.left_out = place;
    }
  }
  if (best.empty()) return cause;
  cause.changed = best.front().changed;
  cause.met = best.front().met;
  cause.is_rough = !best.front().is_close();
  cause.explains = best.front().explains;
  for (const Fit& other : best)
    if (other.explains == cause.explains && cause.choices.size() < most_choices)
      cause.choices.push_back(other.mistakes);
  return cause;
}

}  // namespace tribo::conformance
