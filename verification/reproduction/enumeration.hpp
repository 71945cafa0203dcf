// SPDX-License-Identifier: Apache-2.0
// All readings, each judged by every item. Readings share the stages of the computation, so that no
// stage is computed twice from the same choices: flooded films once for each film formula and rough
// contact, starved films once for each flooded film and inlet, friction once for each starved film
// and pair of laws.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reproduction/evaluation.hpp"

namespace tribo::reproduction {

// Bit i is of item i (or claim i): it is reproduced, refined or undecided.
using ItemMask = std::uint32_t;

struct Enumeration {
  std::vector<ItemMask> items;   // of every reading, by index_of()
  std::vector<ItemMask> claims;  // of every reading, by index_of()
  std::size_t films;             // the numbers of curves computed in the three stages
  std::size_t inlets;
  std::size_t friction_curves;
  // Both lists have every reading. The grid of speeds left refined items open: they were computed
  // between its speeds as well. The margin of undecided items is below the numerical error even
  // then.
  std::vector<ItemMask> refined;
  std::vector<ItemMask> undecided;
};

Enumeration enumerate(const PaperScenes& scenes, const std::vector<Item>& items);

// Sets the bit of each claim whose items are all set. Claims are in the order of claim_names().
ItemMask claims_of(ItemMask items_reproduced, const std::vector<Item>& items);

// ranking.cpp: statistics of the enumeration. They say how readings rank, how many tie, and which
// choice of a switch each item identifies.

// Readings that reproduce the same claims.
struct RankedGroup {
  ItemMask claims;
  int score;               // how many claims that is
  std::size_t ties;        // how many readings
  Reading representative;  // of those that reproduce the most items, the one with the fewest
                           // departures from the corrected reading
  std::string fixed;       // "offset_planes=2 …": departures that all these readings share
  std::string free;        // "viscosity, criterion": switches in which they differ
};

struct Ranking {
  std::vector<std::size_t> histogram;  // readings by the number of claims they reproduce
  double mean_score;                   // of all readings
  double score_sd;
  std::size_t best_ties;          // readings that reproduce the most claims of all
  std::vector<RankedGroup> best;  // `groups` of them, the highest scores first
};
Ranking rank(const Enumeration& enumeration, const std::vector<Item>& items, std::size_t groups);

// The numbers of readings that reproduce more claims than a score, and exactly as many.
struct ReadingRank {
  std::size_t above, equal;
};
ReadingRank standing(const Ranking& ranking, int score);

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
  std::vector<Identification> identified;  // switches with a choice that 95 % or more share
};
// In the order of the items. If all readings reproduce an item, or no reading does, the item
// identifies no switch.
std::vector<ItemStatistics> item_statistics(const Enumeration& enumeration,
                                            const std::vector<Item>& items);
// The part of all readings that reproduces each claim, in the order of claim_names().
std::vector<double> claim_parts(const Enumeration& enumeration, const std::vector<Item>& items);

}  // namespace tribo::reproduction
