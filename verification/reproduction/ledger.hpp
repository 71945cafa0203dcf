// SPDX-License-Identifier: Apache-2.0
// The ledger: every claim and erratum of the paper under every reading, and the evidence for each
// verdict. Each part has its own source file, which its comment names.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reproduction/enumeration.hpp"

namespace tribo::reproduction {

// arguments.cpp: numbers of the paper that may identify a reading. The value of each candidate is
// compared with the number; both are intervals, by their print precision.
struct Candidate {
  std::string name;
  std::optional<double> value;  // empty: the candidate gives no number
  // The value's interval by the print precision of its inputs. Empty: no number at that end.
  std::optional<double> low, high;
  bool agrees;                       // this interval and the reported one overlap
  std::optional<Reading> reading{};  // that gives the value; empty: none of the enumerated ones
};

struct Argument {
  std::string question;
  std::string reported;  // "0.82/0.60 = 1.37"
  double low, high;      // by print precision
  std::vector<Candidate> candidates;
  std::string claim{};  // whose identified switches the candidates restrict; empty: no claim

  std::size_t agreeing() const;  // how many candidates agree; a single one is identified
};

std::vector<Argument> arguments(const PaperScenes& scenes, const std::vector<Item>& items,
                                const std::vector<Input>& inputs);

// Removes an identified switch from the items of an argument's claim if an agreeing candidate has
// another choice there: the print precision of the inputs leaves such a switch open.
void keep_what_print_precision_identifies(std::vector<ItemStatistics>& statistics,
                                          const std::vector<Item>& items,
                                          const std::vector<Argument>& arguments);

// errata.cpp: the paper's misprints, from reference/published/errata.tsv. A number computed by two
// forms, as a rule the printed and the right one, shows whether the misprint matters.
struct Erratum {
  std::string id, place, printed, right, settled_by, kind, switch_or_reason;
  std::string evidence;  // the quantity, and the two forms; empty where there is none
  std::optional<double> as_printed, as_corrected;
  std::string decided_by;  // the number of the paper, or the bound, that settles it
};

// Throws std::runtime_error if the file lists an erratum that the code does not know.
std::vector<Erratum> read_errata(const std::string& path, const PaperScenes& scenes);

// independent.cpp: film and Hertz contact compared with another library's numbers in
// reference/published/independent.tsv.
struct IndependentNumber {
  std::string case_name;  // "1 m/s, 20 N"
  std::string quantity, unit;
  double reported, computed;
  double digits;    // of the reported number
  bool reproduced;  // to half a unit of its last digit; films with the other library's constant
};
std::vector<IndependentNumber> independent_numbers(const std::string& path);

// requirements.cpp: the change of a single input that would make a failing item hold, and the
// effects of that change on other claims.
struct Requirement {
  std::size_t item;  // index
  Field field;
  std::optional<double> sensitivity{};     // d ln(number)/d ln(input) at the scene's inputs
  std::optional<double> by_sensitivity{};  // of rule number: the factor that this predicts
  // The factor on the input, between 1/30 and 30 and nearest to 1, at which the item holds (for a
  // number: prints as reported). Empty: there is none.
  std::optional<double> factor{};
  std::string surface;  // of the values below: the item's surface, or else rough
  std::string unit;     // of the values
  double paper_value;   // the input as the paper has it
  double value;         // the input at that factor
  double low, high;     // its plausible range
  bool plausible = false;
  bool at_limit = false;  // outside by at most a twentieth of the range, in logarithms
  std::vector<std::string> broken{}, mended{};  // claims that the change breaks or mends
};

// The requirements of every item that the reading does not reproduce, one for each input.
std::vector<Requirement> requirements(const PaperScenes& scenes, const Reading& reading,
                                      const std::vector<Item>& items,
                                      const std::vector<ItemResult>& results,
                                      const std::vector<Input>& inputs);

// Claim C1 if the onset is a film departure: the ε that gives each surface its reported speed, and
// the one common ε for which the greatest factor between computed and reported speeds is least.
struct CommonDeparture {
  std::array<std::optional<double>, surface_count> own;  // ε for rough, medium, smooth
  double best;                                           // ε for all
  std::array<double, surface_count> factor;              // computed/reported at that ε
};
CommonDeparture common_departure(const PaperScenes& scenes, const Reading& reading,
                                 const std::array<double, surface_count>& reported);

// uncertainty.cpp: the uncertainty of the computed numbers under the corrected reading. The inputs
// vary within their print precision or within plausible ranges. Draws come from a counter (Philox),
// so that draw i is the same whatever was drawn before it.
enum class Spread : std::uint8_t {
  print,      // uniform within half a unit of the last printed digit
  plausible,  // log-uniform within the plausible range
};

struct Interval {
  double low, median, high;  // 2.5 %, 50 %, 97.5 % of the draws
  double least, greatest;
};

struct Uncertainty {
  Spread spread;
  std::size_t draws;
  std::array<Interval, surface_count> onset_speed;          // film_maximum
  std::array<Interval, surface_count> slow_asperity_share;  // at the lowest speed
  Interval medium_over_smooth, rough_over_medium;           // of the onset speeds
  Interval film_parameter;                                  // at the onset, rough surface
  std::size_t all_onsets_reported;  // draws in which all three speeds print as reported
};

// The reported onset speeds with the units of their last digits, for all_onsets_reported.
struct ReportedOnsets {
  std::array<double, surface_count> speed, last_digit;
};
Uncertainty uncertainty(const PaperScenes& scenes, const std::vector<Input>& inputs, Spread spread,
                        std::size_t draws, const ReportedOnsets& reported);

// One column of the ledger.
struct NamedReading {
  // "corrected", "m = 2", "equal faces", "literal", "best 1", or the switches that were asked for
  std::string name;
  Reading reading;
  std::vector<ItemResult> results;  // in the order of the items
  std::vector<Verdict> verdicts;    // in the order of the claims
  int score;                        // claims reproduced
};

// How many claims the ledger's readings reproduce with all tolerances multiplied by a factor.
struct ToleranceScores {
  double factor;
  std::vector<int> scores;  // in the order of the readings
};

struct Ledger {
  PaperScenes scenes;
  std::vector<Item> items;
  std::vector<std::string> claims;
  std::vector<std::string> statements;  // in the order of the claims
  // corrected, with m = 2, with equal faces, literal, the best few, those asked for
  std::vector<NamedReading> readings;
  std::vector<ToleranceScores> tolerances;
  Ranking ranking;
  std::vector<ItemStatistics> item_statistics;
  std::vector<double> claim_parts;
  Enumeration work;  // only its counts: the masks are cleared
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
  std::size_t best = 3;        // how many of the best sets of claims to show
  std::size_t draws = 10000;   // of each uncertainty
  bool requirements = true;    // whether to compute them; they take a third of the time
};

// Throws std::runtime_error with one line: file, and what is wrong with it.
Ledger make_ledger(const LedgerOptions& options);

// One column of the ledger, for callers that need no more.
NamedReading named_reading(const PaperScenes& scenes, const std::vector<Item>& items,
                           std::string name, const Reading& reading);

// ledger_file.cpp: the ledger as comma-separated values. `tribocheck reproduce --format csv` writes
// them; they are committed as reference/baselines/ledger.csv.
std::string ledger_csv(const Ledger& ledger, const std::vector<NamedReading>& readings,
                       const std::vector<std::string>& claims);

struct LedgerChanges {
  std::vector<std::string> verdicts;  // one line for each change of verdict or switches or new item
  std::vector<std::string> numbers;   // if the verdict is the same: one line for a number or part
                                      // that moved by over 1e-6 of itself, or a changed `decided`
};
// The changes since the committed ledger, of the readings that both have. An item that the
// committed ledger lacks is a change, too. Throws std::runtime_error with one line.
LedgerChanges changes_since(const std::string& path, const Ledger& ledger,
                            const std::vector<NamedReading>& readings,
                            const std::vector<std::string>& claims);

}  // namespace tribo::reproduction
