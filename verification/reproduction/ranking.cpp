// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "reproduction/enumeration.hpp"

namespace tribo::reproduction {
namespace {

constexpr double identified_from = 0.95;

int departure_count(const Reading& reading) {
  const Reading corrected = corrected_reading();
  int count = 0;
  for (std::size_t i = 0; i < switch_count; ++i)
    count += reading.choice[i] != corrected.choice[i] ? 1 : 0;
  return count;
}

using Counts = std::array<std::array<std::size_t, 8>, switch_count>;
void count_choices(Counts& counts, const Reading& reading) {
  for (std::size_t i = 0; i < switch_count; ++i) ++counts[i][reading.choice[i]];
}

// The readings seen so far that reproduce one set of claims, and their best representative.
struct Group {
  std::size_t ties = 0;
  int items = -1;
  int departures = 0;
  std::size_t index = 0;
  Counts choices{};
};

RankedGroup ranked(ItemMask claims, const Group& group) {
  RankedGroup made{claims, std::popcount(claims), group.ties, reading_at(group.index), {}, {}};
  const Reading corrected = corrected_reading();
  for (std::size_t i = 0; i < switch_count; ++i) {
    const SwitchInfo& one = info(static_cast<Switch>(i));
    const std::size_t choice = made.representative.choice[i];
    const auto add = [](std::string& to, std::string_view separator, const std::string& text) {
      to += (to.empty() ? "" : std::string(separator)) + text;
    };
    if (group.choices[i][choice] != group.ties)
      add(made.free, ", ", std::string(one.name));
    else if (choice != corrected.choice[i])
      add(made.fixed, " ", fmt::format("{}={}", one.name, one.choices[choice]));
  }
  return made;
}

}  // namespace

Ranking rank(const Enumeration& enumeration, const std::vector<Item>& items, std::size_t groups) {
  const std::size_t count = enumeration.claims.size();
  Ranking ranking{std::vector<std::size_t>(claim_names(items).size() + 1), 0, 0, 0, {}};
  std::map<ItemMask, Group> by_claims;
  double sum = 0, sum_of_squares = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const int score = std::popcount(enumeration.claims[i]);
    ++ranking.histogram[static_cast<std::size_t>(score)];
    sum += score;
    sum_of_squares += score * score;
    Group& group = by_claims[enumeration.claims[i]];
    const Reading reading = reading_at(i);
    ++group.ties;
    count_choices(group.choices, reading);
    const int held = std::popcount(enumeration.items[i]), departed = departure_count(reading);
    if (held > group.items || (held == group.items && departed < group.departures)) {
      group.items = held;
      group.departures = departed;
      group.index = i;
    }
  }
  const double n = static_cast<double>(count);
  ranking.mean_score = sum / n;
  ranking.score_sd = std::sqrt(sum_of_squares / n - ranking.mean_score * ranking.mean_score);
  for (const auto& [claims, group] : by_claims) ranking.best.push_back(ranked(claims, group));
  std::stable_sort(ranking.best.begin(), ranking.best.end(),
                   [&](const RankedGroup& a, const RankedGroup& b) {
                     if (a.score != b.score) return a.score > b.score;
                     return departure_count(a.representative) < departure_count(b.representative);
                   });
  for (const RankedGroup& group : ranking.best)
    if (group.score == ranking.best.front().score) ranking.best_ties += group.ties;
  if (ranking.best.size() > groups) ranking.best.resize(groups);
  return ranking;
}

ReadingRank standing(const Ranking& ranking, int score) {
  ReadingRank found{0, ranking.histogram[static_cast<std::size_t>(score)]};
  for (std::size_t s = static_cast<std::size_t>(score) + 1; s < ranking.histogram.size(); ++s)
    found.above += ranking.histogram[s];
  return found;
}

std::vector<ItemStatistics> item_statistics(const Enumeration& enumeration,
                                            const std::vector<Item>& items) {
  std::vector<Counts> counts(items.size());
  std::vector<std::size_t> met(items.size()), undecided(items.size());
  for (std::size_t i = 0; i < enumeration.items.size(); ++i) {
    const Reading reading = reading_at(i);
    for (std::size_t k = 0; k < items.size(); ++k) {
      undecided[k] += enumeration.undecided[i] >> k & 1U;
      if ((enumeration.items[i] >> k & 1U) == 0) continue;
      count_choices(counts[k], reading);
      ++met[k];
    }
  }
  std::vector<ItemStatistics> statistics;
  const auto all = static_cast<double>(enumeration.items.size());
  for (std::size_t k = 0; k < items.size(); ++k) {
    ItemStatistics one{met[k], static_cast<double>(met[k]) / all, undecided[k], {}};
    for (std::size_t i = 0; i < switch_count && met[k] > 0; ++i) {
      const auto best = std::max_element(counts[k][i].begin(), counts[k][i].end());
      const double share = static_cast<double>(*best) / static_cast<double>(met[k]);
      const auto which = static_cast<Switch>(i);
      if (share >= identified_from)
        one.identified.push_back({which, static_cast<std::uint8_t>(best - counts[k][i].begin()),
                                  share, 1.0 / static_cast<double>(info(which).choices.size())});
    }
    statistics.push_back(std::move(one));
  }
  return statistics;
}

std::vector<double> claim_parts(const Enumeration& enumeration, const std::vector<Item>& items) {
  std::vector<double> parts(claim_names(items).size());
  for (const ItemMask claims : enumeration.claims)
    for (std::size_t k = 0; k < parts.size(); ++k) parts[k] += claims >> k & 1U;
  for (double& part : parts) part /= static_cast<double>(enumeration.claims.size());
  return parts;
}

}  // namespace tribo::reproduction
