// SPDX-License-Identifier: Apache-2.0
// Statistics of the enumeration: how readings rank, how many tie, and which choice of a switch each
// item identifies.
#pragma once

#include <string>
#include <vector>

#include "reproduction/enumeration.hpp"

namespace tribo::reproduction {

// Readings that reproduce the same claims.
struct RankedGroup {
  ItemMask claims;
  int score;               // how many claims that is
  std::size_t ties;        // how many readings
  Reading representative;  // of those that reproduce most items, the one with the fewest departures
                           // from the corrected reading
  std::string fixed;       // "offset_planes=2 …": what all of them share, of what departs
  std::string free;        // "viscosity, criterion": in what they differ
};

struct Ranking {
  std::vector<std::size_t> histogram;  // readings by the number of claims they reproduce
  double mean_score;                   // of a reading drawn at random
  double score_sd;
  std::size_t best_ties;          // readings that reproduce the most claims of all
  std::vector<RankedGroup> best;  // `groups` of them, the highest scores first
};
Ranking rank(const Enumeration& enumeration, const std::vector<Item>& items, std::size_t groups);

// How many readings reproduce more claims than this score, and how many as many.
struct Standing {
  std::size_t above, equal;
};
Standing standing(const Ranking& ranking, int score);

// One choice of a switch: its share of the readings that reproduce an item, and of all readings.
struct Identification {
  Switch which;
  std::uint8_t choice;
  double share;   // of the readings that reproduce the item
  double chance;  // of all readings
};

struct ItemStatistics {
  std::size_t readings;                    // that reproduce the item
  double part;                             // of all
  std::size_t undecided;                   // readings whose margin is below the numerical error
  std::vector<Identification> identified;  // switches of which one choice has 95 % and more
};
// In the order of the items. If all readings reproduce an item, or no reading does, the item
// identifies no switch.
std::vector<ItemStatistics> item_statistics(const Enumeration& enumeration,
                                            const std::vector<Item>& items);
// The part of all readings that reproduces each claim, in the order of claim_names().
std::vector<double> claim_parts(const Enumeration& enumeration, const std::vector<Item>& items);

}  // namespace tribo::reproduction
