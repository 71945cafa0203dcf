// SPDX-License-Identifier: Apache-2.0
#include "conformance/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace tribo::conformance {
namespace {

constexpr double consistent = 0.98;  // of the answers that a mistake changes
constexpr std::size_t fewest = 3;    // of them
constexpr double closeness = 2e-3;   // of the change: other quadrature, rounded constants
constexpr double few = 0.03;         // of the wrong answers
constexpr int most_mistakes = 3;     // told one after the other

// A number that was answered.
struct Entry {
  const Case* asked;
  const Expected* expected;
  double got;
  double allowed;
  bool is_wrong;
  bool is_explained = false;
};

std::vector<Entry> entries_of(const std::string& function, const std::vector<Case>& cases,
                              const Conversation& conversation, const Tolerance& tolerance) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (cases[i].function != function || conversation.answers[i].outcome != Outcome::answered)
      continue;
    for (const Expected& expected : cases[i].expected) {
      if (!expected.word.empty() || expected.is_undefined) continue;
      const auto value = conversation.answers[i].fields.find(expected.field);
      if (value == conversation.answers[i].fields.end() || !value->is_number()) continue;
      const double got = value->get<double>();
      if (!std::isfinite(got)) continue;
      const double allowed = allowed_error(cases[i], expected, tolerance);
      entries.push_back({&cases[i], &expected, got, allowed,
                         std::abs((got - expected.high) - expected.low) > allowed});
    }
  }
  return entries;
}

// The group of a case, as one group of a function's cases may be wrong alone: an order of the
// moments, a closure or an asperity model. Empty: the function has no groups.
std::string group_of(const Case& asked) {
  if (asked.function == "gaussian_moment")
    return fmt::format("order {}", asked.inputs.at("order").get<double>());
  const char* const word = asked.function == "starvation_ratio" ? "closure"
                           : asked.function == "load_sharing"   ? "asperity"
                                                                : nullptr;
  return word == nullptr ? std::string() : asked.inputs.at(word).get<std::string>();
}

struct Fit {
  const Mistake* mistake;
  std::size_t changed = 0;            // answers that it changes
  std::size_t met = 0;                // of those, answers that are as it gives them
  std::vector<std::size_t> explains;  // entries that were wrong, and unexplained

  bool is_consistent() const {
    return changed >= fewest &&
           static_cast<double>(met) >= consistent * static_cast<double>(changed);
  }
};

// Over all entries, or one group of them.
Fit fit(const Mistake& mistake, const std::vector<Entry>& entries, const std::string& group) {
  Fit made{&mistake, 0, 0, {}};
  // The loop ends early if the mistake is clearly not consistent.
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Entry& one = entries[i];
    if (!group.empty() && group_of(*one.asked) != group) continue;
    const std::optional<double> given = mistake.value(one.asked->inputs, one.expected->field);
    if (!given || !std::isfinite(*given)) continue;
    const double change = std::abs((*given - one.expected->high) - one.expected->low);
    const bool is_met = std::abs(one.got - *given) <= std::max(one.allowed, closeness * change);
    if (is_met && one.is_wrong && !one.is_explained) made.explains.push_back(i);
    if (!(change > 5 * one.allowed)) continue;  // too little to tell
    ++made.changed;
    made.met += is_met ? 1 : 0;
    if (made.changed - made.met > 20 && made.met < 10 * (made.changed - made.met)) break;
  }
  return made;
}

// "27.5 % low", "1000 times too large".
std::string in_words(double ratio) {
  if (ratio <= 0) return "of the wrong sign or 0";
  if (ratio > 3) return fmt::format("{:.4g} times too large", ratio);
  if (ratio < 1.0 / 3) return fmt::format("{:.4g} times too small", 1 / ratio);
  return fmt::format("{:.3g} % {}", 100 * std::abs(ratio - 1), ratio < 1 ? "low" : "high");
}

// How the wrong numbers of one quantity are off.
std::string pattern(const std::string& quantity, const std::vector<const Entry*>& wrong,
                    std::size_t answered) {
  std::vector<double> ratios;
  for (const Entry* one : wrong)
    if (one->expected->high != 0) ratios.push_back(one->got / one->expected->high);
  if (ratios.empty()) return fmt::format("{} is wrong where it should be 0", quantity);
  std::sort(ratios.begin(), ratios.end());
  const double least = ratios.front(), greatest = ratios.back(), middle = ratios[ratios.size() / 2];
  const std::string where = wrong.size() == answered
                                ? "everywhere"
                                : fmt::format("in {} of {} cases", wrong.size(), answered);
  if (greatest - least <= 2e-3 * std::abs(middle - 1) + 1e-9)
    return fmt::format("{} is {} {}", quantity, in_words(middle), where);
  return fmt::format("{} is off {}, between {} and {}, in the middle {}", quantity, where,
                     in_words(least), in_words(greatest), in_words(middle));
}

// The quantity with most of the entries, and how it is off.
struct Shown {
  std::string quantity, text;
};
Shown shown(const std::vector<Entry>& entries, const std::vector<std::size_t>& which) {
  std::map<std::string, std::vector<const Entry*>> wrong;
  std::map<std::string, std::size_t> answered;
  for (const Entry& one : entries) ++answered[quantity_name(*one.asked, *one.expected)];
  for (const std::size_t i : which)
    wrong[quantity_name(*entries[i].asked, *entries[i].expected)].push_back(&entries[i]);
  const auto most = std::max_element(wrong.begin(), wrong.end(), [](const auto& a, const auto& b) {
    return a.second.size() < b.second.size();
  });
  return {most->first, pattern(most->first, most->second, answered[most->first])};
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
  for (const Factor& one : factors) {
    if (std::abs(ratio / one.value - 1) < 1e-6)
      return fmt::format("It is too large by {}.", one.name);
    if (std::abs(ratio * one.value - 1) < 1e-6)
      return fmt::format("It is too small by {}.", one.name);
  }
  return {};
}

// The functions that a function's numbers rest on.
std::vector<std::string> rests_on(const std::string& function) {
  if (function == "load_sharing") return {"gaussian_moment"};
  if (function == "operating_point")
    return {"hertz_point", "hamrock_dowson_central", "gaussian_moment", "load_sharing",
            "starvation_ratio"};
  return {};
}

class Diagnoser {
 public:
  Diagnoser(std::vector<Entry> entries, const std::vector<Mistake>& mistakes,
            std::string wrong_below)
      : entries_(std::move(entries)), mistakes_(mistakes), wrong_below_(std::move(wrong_below)) {
    for (const Entry& one : entries_) wrong_ += one.is_wrong ? 1 : 0;
  }

  std::vector<Diagnosis> run() {
    for (int i = 0; i < most_mistakes && left() > 0; ++i)
      if (!name_one({})) break;
    std::set<std::string> groups;
    for (const Entry& one : entries_)
      if (one.is_wrong && !one.is_explained) groups.insert(group_of(*one.asked));
    for (const std::string& group : groups)
      if (!group.empty()) name_one(group);
    describe_rest();
    return std::move(found_);
  }

 private:
  std::size_t left() const {
    return static_cast<std::size_t>(
        std::count_if(entries_.begin(), entries_.end(),
                      [](const Entry& one) { return one.is_wrong && !one.is_explained; }));
  }

  // Of all entries, or of one group of them.
  bool name_one(const std::string& group) {
    std::vector<Fit> fits;
    for (const Mistake& mistake : mistakes_) {
      Fit made = fit(mistake, entries_, group);
      if (made.is_consistent() && !made.explains.empty()) fits.push_back(std::move(made));
    }
    if (fits.empty()) return false;
    std::stable_sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) {
      return a.explains.size() > b.explains.size();
    });
    // Others that explain the same are as good.
    const Fit& best = fits.front();
    Diagnosis one{{}, {}, best.explains.size(), wrong_, {}};
    std::string causes;
    for (const Fit& other : fits) {
      if (other.explains != best.explains || one.mistakes.size() == 3) continue;
      one.mistakes.push_back(other.mistake->name);
      causes += (causes.empty() ? "" : "; or ") + other.mistake->text;
    }
    const Shown off = shown(entries_, best.explains);
    one.quantity = off.quantity;
    one.text = fmt::format(
        "{}{}. These are the numbers that this gives: {} ({} of {} answers that it would "
        "change, {} of {} that are wrong).",
        group.empty() ? "" : fmt::format("For {}: ", group), off.text, causes, best.met,
        best.changed, best.explains.size(), wrong_);
    if (one.mistakes.size() > 1) one.text += " The numbers do not tell these apart.";
    for (const std::size_t i : best.explains) entries_[i].is_explained = true;
    found_.push_back(std::move(one));
    return true;
  }

  // What no known mistake gives: how it is off.
  void describe_rest() {
    std::vector<std::size_t> rest;
    for (std::size_t i = 0; i < entries_.size(); ++i)
      if (entries_[i].is_wrong && !entries_[i].is_explained) rest.push_back(i);
    // After a named mistake, a few other wrong answers, such as near a border, are no news.
    if (rest.empty() ||
        (!found_.empty() && static_cast<double>(rest.size()) <= few * static_cast<double>(wrong_)))
      return;
    const Shown off = shown(entries_, rest);
    Diagnosis one{off.quantity, {}, 0, wrong_, off.text + "."};
    double least = INFINITY, greatest = -INFINITY;
    for (const std::size_t i : rest) {
      const Entry& entry = entries_[i];
      if (quantity_name(*entry.asked, *entry.expected) != off.quantity || entry.expected->high == 0)
        continue;
      least = std::min(least, entry.got / entry.expected->high);
      greatest = std::max(greatest, entry.got / entry.expected->high);
    }
    const std::string factor =
        greatest - least < 1e-9 * std::abs(greatest) ? known_factor(least) : "";
    if (!factor.empty())
      one.text += ' ' + factor;
    else if (!wrong_below_.empty())
      one.text += fmt::format(" It rests on {}, wrong too: that first.", wrong_below_);
    else
      one.text += found_.empty() ? " None of the known mistakes gives these numbers."
                                 : " None of the known mistakes gives these others.";
    found_.push_back(std::move(one));
  }

  std::vector<Entry> entries_;
  const std::vector<Mistake>& mistakes_;
  std::string wrong_below_;  // functions that this one rests on and that are wrong
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
  for (const std::string& function : functions) {
    std::vector<Mistake> mistakes;
    for (const Mistake& one : all)
      if (one.function == function) mistakes.push_back(one);
    std::string below;
    for (const std::string& other : rests_on(function))
      if (wrong.contains(other)) below += (below.empty() ? "" : ", ") + other;
    for (Diagnosis& one :
         Diagnoser(entries_of(function, cases, conversation, tolerance), mistakes, below).run()) {
      wrong.insert(function);
      found.push_back(std::move(one));
    }
  }
  return found;
}

}  // namespace tribo::conformance
