// SPDX-License-Identifier: Apache-2.0
// The paper's claims, from reference/published/claims.tsv: what is printed, and the rule that
// decides.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tribo::reproduction {

enum class PaperSurface : std::uint8_t { rough, medium, smooth };
inline constexpr std::size_t surface_count = 3;
std::string_view name(PaperSurface surface);

// The quantity of an item; observation.hpp computes its number. claims.tsv defines each quantity in
// words.
enum class Quantity : std::uint8_t {
  onset_speed,
  onset_film_parameter,
  onset_speed_order,
  slow_asperity_share,
  equal_share_speed_order,
  late_share_rise,
  area_gw_over_gt,
  slow_area_spread,
  area_rough_over_smooth,
  area_transition_gw_over_gt,
  slow_count_gt_over_gw,
  count_gw_over_gt,
  count_smoother_over_rougher,
  film_gw_over_gt,
  friction_gt_over_gw,
  onset_gw_over_gt,
  flooded_slope,
  starved_slope_range,
  film_constant,
};
inline constexpr std::size_t quantity_count = 19;
std::string_view name(Quantity quantity);  // observation.cpp, which has the quantities' table

enum class Rule : std::uint8_t { number, order, equal, at_least };
std::string_view name(Rule rule);

// One line of claims.tsv.
struct Item {
  std::string id;     // "C1.rough"
  std::string claim;  // "C1"
  Quantity quantity;
  PaperSurface surface;  // smooth if the item has none
  bool has_surface;
  std::string surface_text, model;
  Rule rule;
  std::string printed;  // as the paper prints it
  double reported;      // of rule number
  double last_digit;    // of rule number: the unit of the last printed digit
  double tolerance;     // of equal: the allowed factor less 1; of at_least: the threshold
  std::string unit, place, statement, computed_as;
  std::string label;  // what is computed, in few words
  // The item is decided by arithmetic with a printed formula alone, without any part of the model.
  bool is_arithmetic;
};

// A reading's result for an item.
struct Observed {
  std::optional<double> value;  // the deciding number: the worst of a comparison over speeds
  double other_end = 0;         // the best of a comparison over speeds; else the value
  double part = 1;              // the part of the speeds (ln u) or surfaces at which the item holds
  std::string_view none{};      // why there is no value
  // Absolute numerical errors: the exact number lies within them.
  double error = 0;                    // of value, other_end and middle
  std::optional<double> part_error{};  // of part; none where speeds are not compared
  // The median where only a few numbers are compared: at least half of them reach it.
  std::optional<double> middle{};
  // Contacts whose numbers lie beyond the collapse of their film; bit i: contact i (ContactName).
  std::uint8_t beyond_collapse = 0;
};

enum class Verdict : std::uint8_t {
  reproduced,          // within print precision, or as the rule asks everywhere
  within_ten_percent,  // a number, or a ratio that should be 1
  order_only,          // a number within a factor √10
  in_part,             // a comparison that holds over at least half of what is compared
  not_reproduced,
};
std::string_view name(Verdict verdict);
// The short scale for tables of many claims: yes, partly, no. “Partly” is each verdict between the
// first and the last one, including order_only.
std::string_view short_name(Verdict verdict);
inline constexpr std::string_view partly_words =
    "“Partly” is within 10 %, or to the order of magnitude (order only), or in part (at half or "
    "more of what is compared).";

// Does a number agree with the printed one, to half a unit of its last digit? 1.45 agrees with 1.4.
bool is_as_printed(double value, double reported, double last_digit);

Verdict judge(const Item& item, const Observed& observed);
// The same item with its tolerance multiplied by the factor: the print precision of `number`, the
// width of `equal`. The threshold of `at_least` is divided by it. `order` has no tolerance.
Item with_tolerance(Item item, double factor);

// The measure in which a verdict's distance from the nearest other verdict is given.
enum class MarginOf : std::uint8_t {
  number,  // |ln(number/threshold)|
  part,    // |p − 1/2|, where p is the part of the compared speeds at which the comparison holds
};
std::string_view name(MarginOf of);
struct Margin {
  double distance;  // of the deciding number to the nearest threshold; at least 0
  double error;     // the numerical error of the deciding number, in the same measure
  MarginOf of;

  bool is_decided() const { return distance > error; }
};
inline constexpr std::string_view undecided_words = "the margin is below the numerical error";

// The distance to the nearest threshold beyond which the verdict would change. If thresholds
// lie within the numerical error, it is the nearest of these. Empty without a number.
std::optional<Margin> margin_of_verdict(const Item& item, const Observed& observed);

// Is it sure, whatever the numerical error, whether the item is reproduced?
bool is_sure(const Item& item, const Observed& observed);

// The rule as continuous functions of the value, all above 0 where the rule is met. A number has
// two: ln(value/least) and ln(greatest/value), of the least and the greatest number that print as
// reported. The other rules have one, and the second is NaN. Both are NaN without a number above 0.
std::array<double, 2> threshold_margins(const Item& item, const Observed& observed);

// For the rule `number`: of the numbers that print as reported, the one nearest to the value.
double nearest_as_printed(const Item& item, double value);

// Reads claims.tsv. Throws std::runtime_error with one line.
std::vector<Item> read_claims(const std::string& path);

// A sentence on each of the claims, in their order, from statements.tsv. Throws std::runtime_error
// with one line.
std::vector<std::string> read_statements(const std::string& path,
                                         const std::vector<std::string>& claims);

// The claims of the items, each once, in their order: "C1", "C2", …
std::vector<std::string> claim_names(const std::vector<Item>& items);

// The verdict on a claim is the worst of its items' verdicts.
Verdict worst(Verdict a, Verdict b);

}  // namespace tribo::reproduction
