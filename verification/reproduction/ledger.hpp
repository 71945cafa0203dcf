// SPDX-License-Identifier: Apache-2.0
// The ledger: every claim and erratum of the paper, under every reading, and what stands behind it.
#pragma once

#include <string>
#include <vector>

#include "reproduction/arguments.hpp"
#include "reproduction/errata.hpp"
#include "reproduction/independent.hpp"
#include "reproduction/ranking.hpp"
#include "reproduction/requirements.hpp"
#include "reproduction/uncertainty.hpp"

namespace tribo::reproduction {

// One column of the ledger.
struct NamedReading {
  std::string name;  // "corrected", "literal", "best 1", or the switches that were asked for
  Reading reading;
  std::vector<ItemResult> results;  // in the order of the items
  std::vector<Verdict> verdicts;    // in the order of the claims
  int score;                        // claims reproduced
};

struct Ledger {
  PaperScenes scenes;
  std::vector<Item> items;
  std::vector<std::string> claims;
  std::vector<std::string> statements;  // in the order of the claims
  std::vector<NamedReading> readings;   // corrected, literal, the best few, those asked for
  Ranking ranking;
  std::vector<ItemStatistics> item_statistics;
  std::vector<double> claim_parts;
  Enumeration work;  // its counts; the masks are dropped
  std::vector<Argument> arguments;
  std::vector<Requirement> requirements;  // of the corrected reading
  CommonDeparture departure;
  std::vector<Uncertainty> uncertainty;  // print, plausible
  std::vector<Erratum> errata;
  std::vector<IndependentNumber> independent;
};

struct LedgerOptions {
  std::string published;       // the folder of claims.tsv and the scenes
  std::vector<Reading> asked;  // further columns
  std::size_t best = 3;        // how many sets of claims to show of the best
  std::size_t draws = 10000;   // of each uncertainty
};

// Throws std::runtime_error with one line: file, and what is wrong with it.
Ledger make_ledger(const LedgerOptions& options);

// One column of the ledger, for callers that need no more.
NamedReading named_reading(const PaperScenes& scenes, const std::vector<Item>& items,
                           std::string name, const Reading& reading);

}  // namespace tribo::reproduction
