// SPDX-License-Identifier: Apache-2.0
#include "sweep/variable_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "scene/fault_text.hpp"
#include "scene/schema.hpp"
#include "scene/text.hpp"
#include "scene/units.hpp"
#include "sweep/table_reader.hpp"

namespace tribo::sweep {
namespace {

using scene_detail::Entry;
using scene_detail::Measure;
using scene_detail::number_text;
using scene_detail::Problems;
using scene_detail::Value;
using scene_detail::ValueKind;
using scene_detail::wrong_kind;

constexpr std::size_t most_grid_values = 1'000'000;

constexpr const char* varying =
    "a list of values, {from, to, count, spacing}, {distribution, …} or {printed}";

struct Printed {
  double value, half_digit;
};

// The number that a decimal text stands for. The result is std::nullopt if the text is no number or
// goes on after it.
std::optional<double> decimal_number(const std::string& text) {
  const char* const end = text.data() + text.size();
  double number = 0;
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

// The text "2.0e-8" gives the value 2e-8, and half a unit of its last digit, 0.5e-9. A text with a
// unit, such as "62 km/h" or "75 °C", gives both in SI. The half unit is that of the digit that was
// written, not of a digit that the conversion makes.
std::optional<Printed> read_printed(const std::string& text, std::string_view unit) {
  const auto half = scene_detail::half_last_digit(text);
  if (!half) return std::nullopt;
  const auto in_si = [&](const std::string& one, Measure measure) {
    return decimal_number(scene_detail::si_decimal(one, unit, measure).value_or(one));
  };
  const auto value = in_si(text, Measure::value), half_digit = in_si(*half, Measure::distance);
  return value && half_digit ? std::optional<Printed>({*value, *half_digit}) : std::nullopt;
}

class VariableReader {
 public:
  VariableReader(const Entry& entry, const FieldInfo& field, Problems& problems)
      : entry_(entry), field_(field), problems_(problems) {
    variable_.path = field.path;
    variable_.unit = field.unit;
    variable_.meaning = field.meaning;
    written_unit_ = scene_detail::written_unit(field);
    variable_.store = scene_detail::store_of(scene_detail::field_at(field.path));
  }

  std::optional<Variable> read() {
    if (entry_.value.kind == ValueKind::list)
      read_list();
    else
      read_table();
    if (problem_) return std::nullopt;
    return variable_;
  }

 private:
  void refuse(Fault fault) {
    problems_.error(field_.path, std::move(fault));
    problem_ = true;
  }

  bool takes_numbers() const {
    return field_.type == FieldType::number || field_.type == FieldType::integer ||
           field_.type == FieldType::speeds;
  }

  void read_list() {
    if (entry_.elements.empty())
      return refuse({Fault::emptiness, "", "", "values that the field may have"});
    if (field_.type == FieldType::choice)
      variable_.words.assign(field_.choices.begin(), field_.choices.end());
    for (std::size_t i = 0; i < entry_.elements.size(); ++i) read_element(i);
    std::vector<double> sorted = variable_.grid;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
      refuse({Fault::repetition, "a value", "", "each once"});
    variable_.text = field_.type == FieldType::choice ? "each of" : "the values";
    for (std::size_t i = 0; i < std::min<std::size_t>(variable_.grid.size(), 10); ++i)
      variable_.text += (i > 0 ? ", " : " ") + text_of(variable_.grid[i]);
    if (variable_.grid.size() > 10) variable_.text += ", …";
    set_nominal();
  }

  std::string text_of(double value) const {
    return variable_.words.empty() ? number_text(value)
                                   : variable_.words[static_cast<std::size_t>(value)];
  }

  void set_nominal() {
    if (!variable_.grid.empty()) variable_.nominal = variable_.grid[variable_.grid.size() / 2];
  }

  void read_element(std::size_t i) {
    const Value value = scene_detail::in_si(entry_.elements[i], written_unit_);
    const std::string name = std::string(field_.path) + '[' + std::to_string(i) + ']';
    if (takes_numbers()) {
      if (value.kind == ValueKind::number && value.fault == scene_detail::NumberFault::none)
        return variable_.grid.push_back(value.number);
    } else {
      const auto word = std::find(variable_.words.begin(), variable_.words.end(), value.text);
      if (value.kind == ValueKind::text && word != variable_.words.end())
        return variable_.grid.push_back(static_cast<double>(word - variable_.words.begin()));
    }
    problems_.error(
        name, scene_detail::no_number(value, written_unit_, scene_detail::allowed_text(field_)));
    problem_ = true;
  }

  void read_table() {
    if (!takes_numbers())
      return refuse(wrong_kind(entry_.value, "one of its words, or a list of them"));
    constexpr auto names =
        std::to_array<std::string_view>({"distribution", "printed", "from", "to", "count",
                                         "spacing", "mean", "median", "sd", "log_sd"});
    TableReader table(std::string(field_.path), entry_.inner, names, problems_);
    if (!table.good())
      problem_ = true;
    else if (table.has("distribution"))
      read_distribution(table);
    else if (table.has("printed"))
      read_printed_number(table);
    else if (table.has("from") || table.has("to") || table.has("count"))
      read_range(table);
    else
      refuse({Fault::other, "", "this table does not say how the field varies", varying});
    problem_ = problem_ || !table.good();
  }

  // Refuses fields of the table that this kind of variation does not have.
  bool only(TableReader& table, std::initializer_list<std::string_view> names) {
    for (const Entry& entry : entry_.inner) {
      if (std::find(names.begin(), names.end(), entry.path) != names.end()) continue;
      table.refuse(entry.path, {Fault::other, "", "not a field of this kind",
                                scene_detail::joined({names.begin(), names.size()}, ", ")});
    }
    return table.good();
  }

  void read_range(TableReader& table) {
    if (!only(table, {"from", "to", "count", "spacing"})) return;
    const auto spacing =
        table.has("spacing") ? table.word("spacing", spacing_words) : std::optional<std::size_t>(0);
    const auto from = table.needed_number("from", "a number", written_unit_);
    const auto to = table.needed_number("to", "a number above from", written_unit_);
    const std::string count_text = "a whole number from 2 to " + std::to_string(most_grid_values);
    if (!table.has("count")) table.refuse("count", {Fault::presence, "", "", count_text});
    const auto count = table.whole("count", 2, most_grid_values, count_text);
    if (!from || !to || !count || !spacing) return;
    if (*to <= *from) return refuse_to(table, *from, *to);
    const Spacing steps = *spacing == 0 ? Spacing::log : Spacing::lin;
    if (steps == Spacing::log && *from <= 0)
      return table.refuse("from", {Fault::other, "", number_text(*from) + " has no logarithm",
                                   "a number above 0, or spacing = \"lin\""});
    const Speeds range{{}, *from, *to, static_cast<std::size_t>(*count), steps};
    for (std::size_t i = 0; i < range.size(); ++i) variable_.grid.push_back(range[i]);
    variable_.text = std::to_string(*count) + " values from " + number_text(*from) + " to " +
                     number_text(*to) + ", " + std::string(spacing_words[*spacing]);
    set_nominal();
  }

  static void refuse_to(TableReader& table, double from, double to) {
    table.refuse("to",
                 {Fault::other, "", number_text(to) + " is not above from, " + number_text(from),
                  "a number above from"});
  }

  // Numbers are not drawn for a field of whole numbers.
  bool is_drawn() {
    if (field_.type != FieldType::integer) return true;
    refuse({Fault::other, "", "a whole number is not drawn", "a whole number, or a list of them"});
    return false;
  }

  void read_printed_number(TableReader& table) {
    if (!is_drawn() || !only(table, {"printed"})) return;
    const std::string_view units = scene_detail::usual_units(written_unit_);
    const std::string allowed = "a number as it is printed, as a text: \"0.0202\"" +
                                (units.empty() ? "" : ", or in " + std::string(units));
    const auto text = table.text("printed", allowed);
    if (!text) return;
    const auto printed = read_printed(*text, written_unit_);
    if (!printed)
      return table.refuse("printed",
                          {Fault::other, "", '"' + printable(*text) + "\" is no number", allowed});
    variable_.distribution = Distribution::uniform(printed->value - printed->half_digit,
                                                   printed->value + printed->half_digit);
    variable_.nominal = printed->value;
    variable_.text = "printed as " + *text + ": ± " + number_text(printed->half_digit) +
                     (variable_.unit.empty() ? "" : " " + variable_.unit);
  }

  void read_distribution(TableReader& table) {
    if (!is_drawn()) return;
    const auto kind = table.word("distribution", distribution_names);
    if (!kind) return;
    const auto is = [&](DistributionKind one) {
      return static_cast<DistributionKind>(*kind) == one;
    };
    if (is(DistributionKind::uniform) || is(DistributionKind::log_uniform))
      read_uniform(table, is(DistributionKind::log_uniform));
    else
      read_normal(table, is(DistributionKind::log_normal));
    if (!table.good()) return;
    variable_.nominal = variable_.distribution.median();
    variable_.text = variable_.distribution.text();
  }

  struct Range {
    double from, to;
  };
  // Reads the ends, which must have from < to. An end that is missing is refused if `needed`, and
  // is infinite otherwise.
  std::optional<Range> read_ends(TableReader& table, bool needed) {
    constexpr std::string_view below = "a number below to", above = "a number above from";
    const auto end = [&](std::string_view name, std::string_view allowed) {
      return needed ? table.needed_number(name, allowed, written_unit_)
                    : table.number(name, allowed, written_unit_);
    };
    const auto from = end("from", below);
    const auto to = end("to", above);
    if (!table.good()) return std::nullopt;
    const Range range{from.value_or(-infinity), to.value_or(infinity)};
    if (range.from < range.to) return range;
    refuse_to(table, range.from, range.to);
    return std::nullopt;
  }

  void read_uniform(TableReader& table, bool logarithmic) {
    if (!only(table, {"distribution", "from", "to"})) return;
    const auto range = read_ends(table, true);
    if (!range) return;
    if (logarithmic && range->from <= 0)
      return table.refuse("from", {Fault::other, "", number_text(range->from) + " has no logarithm",
                                   "a number above 0"});
    if (!logarithmic && !std::isfinite(range->to - range->from))
      return table.refuse("to", {Fault::other, "",
                                 "the distance from " + number_text(range->from) + " to " +
                                     number_text(range->to) + " is no finite number",
                                 "a range of at most 1.7e308"});
    variable_.distribution = logarithmic ? Distribution::log_uniform(range->from, range->to)
                                         : Distribution::uniform(range->from, range->to);
  }

  void read_normal(TableReader& table, bool logarithmic) {
    const std::string_view middle_name = logarithmic ? "median" : "mean";
    const std::string_view sd_name = logarithmic ? "log_sd" : "sd";
    if (!only(table, {"distribution", middle_name, sd_name, "from", "to"})) return;
    const auto middle = logarithmic ? positive(table, middle_name, written_unit_)
                                    : table.needed_number(middle_name, "a number", written_unit_);
    const auto sd = logarithmic ? positive(table, sd_name, "%")
                                : positive(table, sd_name, written_unit_, Measure::distance);
    const auto range = read_ends(table, false);
    if (!middle || !sd || !range) return;
    const double from = logarithmic ? std::max(range->from, 0.0) : range->from;
    // Almost nothing of a distribution is more than 30 standard deviations from its middle.
    const auto place = [&](double x) { return logarithmic ? std::log(std::max(x, 0.0)) : x; };
    const double below = (place(from) - place(*middle)) / *sd;
    const double above = (place(*middle) - place(range->to)) / *sd;
    if (!(below < 30 && above < 30))
      return table.refuse(
          "from", {Fault::other, "", "all between from and to is more than 30 sd from the middle",
                   "a range that holds some of the distribution"});
    variable_.distribution = logarithmic ? Distribution::log_normal(*middle, *sd, from, range->to)
                                         : Distribution::normal(*middle, *sd, from, range->to);
  }

  static std::optional<double> positive(TableReader& table, std::string_view name,
                                        std::string_view unit, Measure measure = Measure::value) {
    const bool may_be_part = measure == Measure::distance && unit != "%";
    const std::string allowed =
        std::string("a number above 0") +
        (may_be_part ? " (a spread in % is log_sd of a log_normal distribution)" : "");
    const auto value = table.needed_number(name, allowed, unit, measure);
    if (!value || *value > 0) return value;
    table.refuse(name, {Fault::range, number_text(*value), "", allowed});
    return std::nullopt;
  }

  const Entry& entry_;
  const FieldInfo& field_;
  Problems& problems_;
  std::string_view written_unit_;
  Variable variable_;
  bool problem_ = false;
};

}  // namespace

bool varies(const Entry& entry) {
  if (entry.path == "outputs") return false;
  if (entry.value.kind != ValueKind::list) return entry.value.kind == ValueKind::table;
  const auto field = scene_detail::find_field(entry.path);
  return !field || !scene_fields()[*field].takes_both_faces;  // a list has one number a face
}

std::optional<Variable> read_variable(const Entry& entry, const FieldInfo& field,
                                      Problems& problems) {
  return VariableReader(entry, field, problems).read();
}

Value value_for(const Variable& variable, double value) {
  if (variable.words.empty()) return {.kind = ValueKind::number, .number = value, .text = {}};
  return {.kind = ValueKind::text, .text = variable.words[static_cast<std::size_t>(value)]};
}

}  // namespace tribo::sweep
