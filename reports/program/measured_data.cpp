// SPDX-License-Identifier: Apache-2.0
#include "measured_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "build_info.hpp"
#include "page/project_files.hpp"
#include "page/text_table.hpp"
#include "page/texts.hpp"
#include "scene/units.hpp"
#include "table.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::cli {
namespace {

using nlohmann::ordered_json;
using report::ReportError;

// --- Reading.

constexpr std::size_t most_bytes = std::size_t{1} << 22;
constexpr std::size_t most_faults = 20;  // lines that are printed

std::string units_for(std::string_view si) {
  return si.empty() ? "- or %, or no unit" : std::string(scene_detail::usual_units(si));
}

// A cell's number in SI units; std::nullopt if it is no number, or if the unit does not fit.
std::optional<double> number_in(std::string_view cell, std::string_view unit, std::string_view si) {
  const std::string_view written = si.empty() && unit == "%" ? unit : si;
  std::string text(cell);
  if (!written.empty()) {
    auto decimal = scene_detail::si_decimal(fmt::format("{} {}", cell, unit), written);
    if (!decimal) return std::nullopt;
    text = std::move(*decimal);
  } else if (!unit.empty() && unit != "-" && unit != "–") {
    return std::nullopt;
  }
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

// The line without the \r of Windows at its end. A tab there stays: behind it is an empty cell.
std::string_view without_return(std::string_view line) {
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

// The length of the cell that a text begins with, in quotes or not.
std::size_t length_of_cell(std::string_view text, char separator) {
  const std::size_t first = text.find_first_not_of(' ');
  const bool begins_quoted = first != std::string_view::npos && text[first] == '"';
  bool is_in_quotes = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (begins_quoted && text[i] == '"') is_in_quotes = !is_in_quotes;
    if (text[i] == separator && !is_in_quotes) return i;
  }
  return text.size();
}

// A cell without the quotes around it; "" inside them stands for one quote. The result is
// std::nullopt if the quotes do not end with the cell.
std::optional<std::string> unquoted(std::string_view cell) {
  if (!cell.starts_with('"')) return std::string(cell);
  std::string text;
  for (std::size_t i = 1; i < cell.size(); ++i) {
    if (cell[i] == '"' && i + 1 == cell.size()) return std::string(trimmed(text));
    if (cell[i] == '"' && cell[++i] != '"') return std::nullopt;
    text += cell[i];
  }
  return std::nullopt;
}

// The cells of a line of comma-separated values (RFC 4180). A cell may be in quotes, as in
// `"run 1, dirty",0.1`. The result is std::nullopt if quotes do not end with their cell.
std::optional<std::vector<std::string>> cells_in(std::string_view line, char separator) {
  std::vector<std::string> cells;
  while (true) {
    const std::size_t end = length_of_cell(line, separator);
    auto cell = unquoted(trimmed(line.substr(0, end)));
    if (!cell) return std::nullopt;
    cells.push_back(std::move(*cell));
    if (end == line.size()) return cells;
    line.remove_prefix(end + 1);
  }
}

// Names that people and test rigs give to the speed and to outputs, in small letters. An output's
// own name is known as well.
struct ColumnName {
  std::string_view name;
  std::optional<Output> output;  // none: the speed
};
constexpr auto column_names = std::to_array<ColumnName>({
    {"speed", std::nullopt},
    {"rolling speed", std::nullopt},
    {"entrainment speed", std::nullopt},
    {"mean speed", std::nullopt},
    {"mean entrainment speed", std::nullopt},
    {"u", std::nullopt},
    {"v", std::nullopt},
    {"ue", std::nullopt},
    {"u e", std::nullopt},
    {"um", std::nullopt},
    {"u m", std::nullopt},
    {"h", Output::film},
    {"hc", Output::film},
    {"h c", Output::film},
    {"hcen", Output::film},
    {"h cen", Output::film},
    {"h*", Output::film},
    {"hmin", Output::minimum_film},
    {"h min", Output::minimum_film},
    {"central film", Output::film},
    {"minimum film", Output::minimum_film},
    {"film thickness", Output::film},
    {"central film thickness", Output::film},
    {"minimum film thickness", Output::minimum_film},
    {"cof", Output::friction},
    {"mu", Output::friction},
    {"μ", Output::friction},
    {"friction coefficient", Output::friction},
    {"coefficient of friction", Output::friction},
    {"traction coefficient", Output::friction},
    {"traction coeff", Output::friction},
    {"friction coeff", Output::friction},
    {"traction", Output::friction},
    {"λ", Output::film_parameter},
    {"Λ", Output::lambda_ratio},
});

// Names that may mean several outputs, in small letters. A column of such a name is not read.
struct SharedName {
  std::string_view name, outputs;
};
constexpr auto shared_names = std::to_array<SharedName>({
    {"lambda", "film_parameter or lambda_ratio"},
    {"load share", "asperity_load_share or fluid_load_share"},
});

// The name in small letters, with blanks for underscores and hyphens, without commas and without a
// dot at the end. Velocity becomes speed, Lambda becomes Λ, the micro sign of keyboards μ.
std::string plain_name(std::string_view name) {
  if (name == "Lambda") return "Λ";
  std::string plain(name);
  for (char& letter : plain) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    if (letter == '_' || letter == '-') letter = ' ';
  }
  std::erase(plain, ',');
  if (plain.ends_with('.')) plain.pop_back();
  constexpr std::array<std::pair<std::string_view, std::string_view>, 2> same{
      {{"velocity", "speed"}, {"µ", "μ"}}};
  for (const auto& [other, usual] : same)
    if (const std::size_t at = plain.find(other); at != std::string::npos)
      plain.replace(at, other.size(), usual);
  return plain;
}

// The speed or the numeric output with this name; std::nullopt if the name is not known.
std::optional<ColumnName> column_named(std::string_view plain) {
  for (const ColumnName& known : column_names)
    if (known.name == plain) return known;
  for (const OutputInfo& output : output_infos)
    if (output.words.empty() && plain_name(output.name) == plain)
      return ColumnName{output.name, output.output};
  return std::nullopt;
}

// The same for a name that its symbol may follow, as in "rolling speed U".
std::optional<ColumnName> column_name(std::string_view plain) {
  constexpr std::size_t longest = 60;
  auto known = column_named(plain);
  if (plain.size() > longest) return known;
  for (std::size_t at = plain.find(' '); !known && at != plain.npos; at = plain.find(' ', at + 1)) {
    const auto name = column_named(plain.substr(0, at)),
               symbol = column_named(plain.substr(at + 1));
    if (name && symbol && name->output == symbol->output) known = name;
  }
  return known;
}

// A quantity that a rig holds constant. Each row should have the scene's number. The names are in
// small letters.
struct HeldColumn {
  std::string_view field, unit;
  std::span<const std::string_view> names;
  std::optional<double> (*value_of)(const Scene&);  // std::nullopt: the scene has none
  double tolerance;  // relative; of a temperature in K; where the scene has 0, of the number itself
};
constexpr auto load_names = std::to_array<std::string_view>(
    {"load", "normal load", "normal force", "applied load", "f", "fn", "f n", "w"});
constexpr auto ratio_names =
    std::to_array<std::string_view>({"srr", "slide roll ratio", "slide to roll ratio"});
constexpr auto temperature_names = std::to_array<std::string_view>(
    {"temperature", "oil temperature", "lubricant temperature", "temp", "t"});
// Rigs hold a load and a speed to some per cent, and a bath to a kelvin.
constexpr double tolerance_of_rigs = 0.02, tolerance_of_kelvins = 1;
constexpr auto held_columns = std::to_array<HeldColumn>({
    {"load", "N", load_names, [](const Scene& scene) { return std::optional(scene.load); },
     tolerance_of_rigs},
    {"friction.slide_roll_ratio", "", ratio_names,
     [](const Scene& scene) { return std::optional(scene.friction.slide_roll_ratio); },
     tolerance_of_rigs},
    {"lubricant.temperature", "K", temperature_names,
     [](const Scene& scene) {
       const Oil& oil = scene.lubricant.oil;
       return oil.is_given() ? std::optional(oil.temperature) : std::nullopt;
     },
     tolerance_of_kelvins},
});

// The column with this name, which its symbol may follow, as in "normal load F"; null if none.
const HeldColumn* held_column(std::string_view plain) {
  const auto is_of = [](const HeldColumn& held, std::string_view name) {
    return std::ranges::find(held.names, name) != held.names.end() ||
           plain_name(held.field.substr(held.field.find('.') + 1)) == name;
  };
  const std::size_t last = std::min(plain.rfind(' '), plain.size());
  for (const HeldColumn& held : held_columns)
    if (is_of(held, plain) ||
        (is_of(held, plain.substr(0, last)) && is_of(held, trimmed(plain.substr(last)))))
      return &held;
  return nullptr;
}

// A heading as "film [nm]", "film (nm)", "film / nm" or "v / (m/s)".
struct Heading {
  std::string_view name, unit;
  bool is_closed = true;  // false: a bracket is left open
};

Heading parts_of(std::string_view heading) {
  const std::size_t bracket = heading.find_first_of("[(");
  if (bracket == std::string_view::npos) {
    const std::size_t slash = std::min(heading.find('/'), heading.size());
    const std::string_view unit = heading.substr(std::min(slash + 1, heading.size()));
    return {trimmed(heading.substr(0, slash)), trimmed(unit)};
  }
  std::string_view name = trimmed(heading.substr(0, bracket));
  if (name.ends_with('/')) name = trimmed(name.substr(0, name.size() - 1));
  const std::string_view behind = heading.substr(bracket + 1);
  if (!behind.ends_with(heading[bracket] == '[' ? ']' : ')')) return {name, behind, false};
  return {name, trimmed(behind.substr(0, behind.size() - 1))};
}

struct DataColumn {
  std::string heading;
  bool is_known = true;          // else it is not read
  std::optional<Output> output;  // none: the speed
  std::string unit;
  const HeldColumn* held = nullptr;  // not null: it is not read but compared with the scene
  std::size_t held_rows = 0, other_rows = 0;
  double least = 0, greatest = 0;  // of the other rows, in SI units
  bool is_speed() const { return is_known && !output; }
  std::string_view si() const { return output ? info(*output).unit : "m/s"; }
};

// The other names of the speed or of an output, as messages list them.
std::string other_names(std::optional<Output> output) {
  std::string names;
  for (const ColumnName& known : column_names)
    if (known.output == output && known.name != "speed")
      names += (names.empty() ? "" : ", ") + std::string(known.name);
  return names;
}

// The outputs that are numbers and that the scene asks for.
std::string allowed_names(OutputSet asked) {
  std::string names;
  for (const OutputInfo& info : output_infos) {
    if (!info.words.empty() || !asked.contains(info.output)) continue;
    const std::string others = other_names(info.output);
    names += fmt::format("{}{}{}", names.empty() ? "" : ", ", info.name,
                         others.empty() ? "" : fmt::format(" (also {})", others));
  }
  return names;
}

class MeasuredReader {
 public:
  MeasuredReader(const std::string& path, const Scene& scene)
      : path_(path), scene_(scene), asked_(scene.outputs) {}

  void read(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      const std::string_view line = without_return(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
      ++line_;
      if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
      if (columns_.empty()) {
        read_head(line);
        if (!faults_.empty()) return;  // the columns are not known
      } else {
        read_row(line);
      }
    }
    if (columns_.empty())
      refuse("no columns", "a first line such as speed [m/s],film [nm],friction");
    else if (measurements_.empty() && faults_.empty())
      refuse("nothing was measured", "a line for each point, below the names of the columns");
  }

  MeasuredPoints finish() {
    if (faults_.size() > most_faults) {
      const std::size_t more = faults_.size() - most_faults;
      faults_.resize(most_faults);
      faults_.push_back(fmt::format("{}: {} more mistakes", path_, more));
    }
    if (!faults_.empty()) throw ReportError(std::move(faults_));
    MeasuredPoints points{std::move(measurements_), {}, {}};
    for (const DataColumn& column : columns_) {
      if (column.other_rows > 0) points.contradictions.push_back(contradiction(column));
      if (!column.is_known && column.held_rows == 0) points.ignored.push_back(ignored(column));
    }
    return points;
  }

 private:
  // The heading of a column that is not read, and the outputs that it may mean if there are some.
  static std::string ignored(const DataColumn& column) {
    const std::string plain = plain_name(parts_of(column.heading).name);
    const auto shared = std::ranges::find(shared_names, plain, &SharedName::name);
    return column.heading +
           (shared == shared_names.end() ? "" : fmt::format(" (name it {})", shared->outputs));
  }

  // The cells of this line. If its quotes are wrong, a fault is noted and no cell is returned.
  std::vector<std::string> cells_of(std::string_view line) {
    auto cells = cells_in(line, separator_);
    if (cells) return std::move(*cells);
    refuse("a cell begins with a quote and does not end with one",
           "quotes around the whole cell, on one line, and \"\" for a quote in it");
    return {};
  }

  void refuse(std::string_view what, std::string_view allowed) {
    faults_.push_back(fmt::format("{}: line {}: {}; allowed: {}", path_, line_, what, allowed));
  }

  // The same for column number `column`, counted from 0.
  void refuse(std::size_t column, std::string_view heading, std::string_view what,
              std::string_view allowed) {
    faults_.push_back(fmt::format("{}: line {}, column {} ({}): {}; allowed: {}", path_, line_,
                                  column + 1, printable(heading), what, allowed));
  }

  void read_head(std::string_view line) {
    const auto has = [line](char separator) {
      return length_of_cell(line, separator) < line.size();
    };
    separator_ = has('\t') ? '\t' : has(';') ? ';' : ',';
    for (const std::string& heading : cells_of(line)) add_column(heading);
    if (!faults_.empty()) return;
    const auto is_speed = [](const DataColumn& column) { return column.is_speed(); };
    const auto is_measured = [](const DataColumn& column) { return column.output.has_value(); };
    if (std::none_of(columns_.begin(), columns_.end(), is_speed))
      refuse("there is no column speed" + sliding_remark(),
             "speed (also velocity, " + other_names(std::nullopt) +
                 "), with its unit, as speed [mm/s] or v / (mm/s), beside what was measured");
    else if (std::none_of(columns_.begin(), columns_.end(), is_measured))
      refuse("there is no column of what was measured",
             allowed_names(asked_) + ", each with its unit, as film [nm]");
  }

  // A remark for a file that has a column for the sliding speed and none for the speed. It is empty
  // if there is no column for the sliding speed.
  std::string sliding_remark() const {
    const auto is_sliding = [](const DataColumn& column) {
      return plain_name(parts_of(column.heading).name).starts_with("sliding speed");
    };
    return std::ranges::any_of(columns_, is_sliding)
               ? ": the sliding speed is that of the faces against each other, slide_roll_ratio "
                 "times the mean speed of both faces"
               : "";
  }

  // Returns whether a cell has another number than the scene. A cell that is empty or a text is not
  // compared.
  bool is_other(DataColumn& column, std::string_view cell) const {
    auto number = number_in(with_point(cell), column.unit, column.held->unit);
    const double own = *column.held->value_of(scene_);
    if (!number) return false;
    if (column.held->unit.empty()) number = std::abs(*number);
    ++column.held_rows;
    const bool is_absolute = column.held->unit == "K" || own == 0;
    const double tolerance = column.held->tolerance * (is_absolute ? 1 : own);
    if (std::abs(*number - own) <= tolerance) return false;
    column.least = column.other_rows == 0 ? *number : std::min(column.least, *number);
    column.greatest = column.other_rows == 0 ? *number : std::max(column.greatest, *number);
    ++column.other_rows;
    return true;
  }

  std::string contradiction(const DataColumn& column) const {
    const auto text = [&](double number) {
      return column.held->unit == "K"    ? readable(number - 273.15) + " °C"
             : column.held->unit.empty() ? readable(number)
                                         : readable(number) + ' ' + std::string(column.held->unit);
    };
    return fmt::format(
        "column {}: {} of {} rows have {}, and the scene has {} = {}; these points are compared "
        "with the scene as it stands",
        column.heading, column.other_rows, column.held_rows,
        column.least == column.greatest
            ? text(column.least)
            : fmt::format("{} to {}", text(column.least), text(column.greatest)),
        column.held->field, text(*column.held->value_of(scene_)));
  }

  void add_column(std::string_view heading) {
    const std::size_t place = columns_.size();
    const Heading parts = parts_of(heading);
    const std::string plain = plain_name(parts.name);
    std::optional<ColumnName> known = column_name(plain);
    // A short name may mean something else, U a voltage and traction a force: the unit decides.
    const bool may_be_other =
        plain == "traction" || (plain.size() <= 2 && known && known->output != Output::friction);
    if (may_be_other && known && !parts.unit.empty() &&
        !number_in("1", parts.unit, known->output ? info(*known->output).unit : "m/s"))
      known.reset();
    const DataColumn column{std::string(heading), known.has_value(),
                            known ? known->output : std::nullopt, std::string(parts.unit),
                            known ? nullptr : held_here(plain, parts)};
    columns_.push_back(column);
    if (!column.is_known) return;
    if (column.output && !asked_.contains(*column.output))
      return refuse(
          place, heading,
          fmt::format("the scene's `outputs` do not ask for {}", info(*column.output).name),
          allowed_names(asked_));
    const bool is_double =
        std::any_of(columns_.begin(), columns_.end() - 1, [&column](const DataColumn& before) {
          return before.is_known && before.output == column.output;
        });
    if (is_double) return refuse(place, heading, "this column is there twice", "it once");
    if (column.unit.empty() && column.si().empty()) return;
    if (!parts.is_closed || !number_in("1", column.unit, column.si()))
      return refuse(place, heading,
                    column.unit.empty() ? "its unit is missing" : "this unit does not fit",
                    units_for(column.si()) + ", in brackets or after a / behind the name");
  }

  // The column of a held quantity; null if the unit does not fit, or the scene has no such number.
  const HeldColumn* held_here(std::string_view plain, const Heading& parts) const {
    const HeldColumn* const held = held_column(plain);
    const bool fits = held != nullptr && parts.is_closed &&
                      number_in("1", parts.unit, held->unit) && held->value_of(scene_);
    return fits ? held : nullptr;
  }

  void read_row(std::string_view line) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.empty()) return;
    if (cells.size() != columns_.size())
      return refuse(fmt::format("{} cells", cells.size()),
                    fmt::format("{}, as many as columns; points in numbers, and no commas but in "
                                "quotes",
                                columns_.size()));
    std::vector<MeasuredNumber> row;
    double speed = std::numeric_limits<double>::quiet_NaN();
    bool has_other_conditions = false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      DataColumn& column = columns_[i];
      if (column.held != nullptr && is_other(column, cells[i])) has_other_conditions = true;
      if (!column.is_known || (cells[i].empty() && column.output)) continue;
      const std::optional<double> number = number_at(cells[i], i);
      if (!number) continue;
      if (column.output)
        row.push_back({line_, 0, *column.output, *number, column.unit,
                       number_in("1", column.unit, column.si()).value_or(1)});
      else
        speed = *number;
    }
    for (MeasuredNumber& one : row) {
      one.speed = speed;
      one.has_other_conditions = has_other_conditions;
      measurements_.push_back(one);
    }
  }

  std::optional<double> number_at(std::string_view cell, std::size_t place) {
    const DataColumn& column = columns_[place];
    const auto number = number_in(with_point(cell), column.unit, column.si());
    const bool may_be_negative = column.output == Output::friction;  // a rig's zero is off a little
    if (number && (column.is_speed() ? *number > 0 : may_be_negative || *number >= 0))
      return number;
    const std::string sign = separator_ == ',' ? "with a decimal point" : "with a decimal sign";
    refuse(place, column.heading,
           cell.empty() ? "the cell is empty" : printable(cell) + " is not allowed",
           column.is_speed() ? "a number above 0, " + sign
           : may_be_negative ? "a number, " + sign + ", or an empty cell"
                             : "a number not below 0, " + sign + ", or an empty cell");
    return std::nullopt;
  }

  // The cell with a point in place of a decimal comma, unless the comma is the file's separator.
  std::string with_point(std::string_view cell) const {
    std::string text(cell);
    const std::size_t comma = text.find(',');
    const bool is_decimal =
        separator_ != ',' && comma != std::string::npos && text.find('.') == std::string::npos;
    if (is_decimal) text[comma] = '.';
    return text;
  }

  const std::string& path_;
  const Scene& scene_;
  OutputSet asked_;
  std::size_t line_ = 0;
  char separator_ = ',';
  std::vector<DataColumn> columns_;
  std::vector<MeasuredNumber> measurements_;
  std::vector<std::string> faults_;
};

// --- Writing.

// "film [nm]": in the unit of the file.
std::string quantity_text(const MeasuredNumber& measured) {
  return fmt::format("{} [{}]", info(measured.output).name,
                     measured.unit.empty() ? "-" : printable(measured.unit));
}

std::string per_cent(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:+.2f}", value);
}

// "median of 2 deviations"
std::string median_of(std::size_t count) {
  return fmt::format("median of {} deviation{}", count, count == 1 ? "" : "s");
}

void append_comparison_table(Text& to, std::string_view title,
                             const std::vector<Comparison>& comparisons) {
  std::size_t widest = 0;
  for (const Comparison& one : comparisons)
    widest = std::max(widest, report::width_of(quantity_text(one.measured)));
  const bool any_outside = std::ranges::any_of(comparisons, &Comparison::is_outside);
  const bool any_other = std::ranges::any_of(
      comparisons, [](const Comparison& one) { return one.measured.has_other_conditions; });
  std::vector<ColumnHead> heads{{"line", "", 4},
                                {"speed", "[m/s]", number_width},
                                {"quantity", "", widest},
                                {"measured", "", number_width},
                                {"computed", "", number_width},
                                {"deviation", "[%]", 9}};
  if (any_outside || any_other) heads.emplace_back("", "", 7);
  append_title(to, title);
  append_heads(to, heads);
  std::vector<std::string_view> reasons;
  for (const Comparison& one : comparisons) {
    const std::string_view why = one.computed.undefined;
    if (!why.empty() && std::find(reasons.begin(), reasons.end(), why) == reasons.end())
      reasons.push_back(why);
    std::vector<std::string> cells{
        std::to_string(one.measured.line),
        readable(one.measured.speed),
        quantity_text(one.measured),
        readable(one.measured.value / one.measured.unit_in_si),
        why.empty() ? readable(one.computed.number / one.measured.unit_in_si) : "-",
        per_cent(one.deviation_percent)};
    if (any_outside || any_other)
      cells.emplace_back(one.measured.has_other_conditions ? "other"
                         : one.is_outside                  ? "outside"
                                                           : "-");
    append_row(to, heads, cells);
  }
  for (const std::string_view why : reasons) append_line(to, fmt::format("  - computed: {}", why));
  bool any_off_curve = false;
  for (const DeviationSummary& one : summaries_of(comparisons)) {
    const std::string_view name = info(one.output).name;
    append_line(to, one.compared == 0
                        ? fmt::format("  - {}: no deviation", name)
                        : fmt::format("  - {}: {} {} %, the least {} %, the greatest {} %", name,
                                      median_of(one.compared), per_cent(one.median_percent),
                                      per_cent(one.least_percent), per_cent(one.greatest_percent)));
    if (one.on_curve == one.compared) continue;
    any_off_curve = true;
    append_line(to, fmt::format("  - {} on the curve: {}", name,
                                one.on_curve == 0 ? "no deviation"
                                                  : median_of(one.on_curve) + ' ' +
                                                        per_cent(one.on_curve_percent) + " %"));
  }
  append_line(to, "  - deviation: (computed − measured)/measured, each at the speed of its point");
  if (any_outside)
    append_line(to, "  - outside: the speed is not among those of the scene's curve");
  if (any_other)
    append_line(to,
                "  - other: measured at another load, slide-roll ratio or temperature than the "
                "scene's");
  if (any_off_curve)
    append_line(to, "  - on the curve: neither outside nor other, and where the model has a film");
}

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

double median(std::vector<double> numbers) {
  return numbers.empty() ? no_number : boost::math::statistics::median(numbers);
}

// Empty for NaN.
std::string csv_number(double value) { return std::isnan(value) ? "" : report::exact(value); }

void append_comparison_csv(Text& to, std::string_view scene_id,
                           const std::vector<Comparison>& comparisons) {
  const std::string id = report::csv_text(scene_id);
  append(to, "id,line,quantity,unit,speed,measured,computed,deviation_percent,outside,other\n");
  for (const Comparison& one : comparisons) {
    const OutputInfo& quantity = info(one.measured.output);
    append(to, fmt::format("{},{},{},{},{},{},{},{},{},{}\n", id, one.measured.line, quantity.name,
                           quantity.unit, report::exact(one.measured.speed),
                           report::exact(one.measured.value),
                           one.computed.undefined.empty() ? report::exact(one.computed.number) : "",
                           csv_number(one.deviation_percent), one.is_outside,
                           one.measured.has_other_conditions));
  }
  for (const DeviationSummary& one : summaries_of(comparisons)) {
    const auto add = [&](std::string_view line, double percent) {
      append(to, fmt::format("{},{},{},{},,,,{},,\n", id, line, info(one.output).name,
                             info(one.output).unit, csv_number(percent)));
    };
    add("median", one.median_percent);
    if (one.on_curve != one.compared) add("median on the curve", one.on_curve_percent);
  }
}

ordered_json json_number(double value) {
  return std::isnan(value) ? ordered_json(nullptr) : ordered_json(value);
}

ordered_json comparison_json(std::string_view scene_id, const std::string& path,
                             const std::vector<Comparison>& comparisons,
                             const ordered_json& warnings) {
  ordered_json points = ordered_json::array(), of_quantities = ordered_json::array();
  for (const Comparison& one : comparisons) {
    const bool is_defined = one.computed.undefined.empty();
    points.push_back({{"line", one.measured.line},
                      {"quantity", info(one.measured.output).name},
                      {"unit", info(one.measured.output).unit},
                      {"speed", one.measured.speed},
                      {"measured", one.measured.value},
                      {"computed", is_defined ? ordered_json(one.computed.number) : nullptr},
                      {"deviation_percent", json_number(one.deviation_percent)},
                      {"outside", one.is_outside},
                      {"other", one.measured.has_other_conditions}});
    if (!is_defined) points.back()["undefined"] = one.computed.undefined;
  }
  for (const DeviationSummary& one : summaries_of(comparisons))
    of_quantities.push_back({{"quantity", info(one.output).name},
                             {"points", one.points},
                             {"compared", one.compared},
                             {"median_deviation_percent", json_number(one.median_percent)},
                             {"least_deviation_percent", json_number(one.least_percent)},
                             {"greatest_deviation_percent", json_number(one.greatest_percent)},
                             {"on_curve", one.on_curve},
                             {"median_on_curve_percent", json_number(one.on_curve_percent)}});
  return document("curve-data/1", {{"id", scene_id},
                                   {"data", path},
                                   {"points", std::move(points)},
                                   {"quantities", std::move(of_quantities)},
                                   {"warnings", warnings}});
}

}  // namespace

MeasuredPoints read_measured(const std::string& path, const Scene& scene) {
  std::ifstream file(path, std::ios::binary);
  std::string text(most_bytes + 1, ' ');
  if (file.is_open()) file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file.is_open() || file.bad())
    throw ReportError(fmt::format("{}: the file cannot be read: {}", path,
                                  std::generic_category().message(errno)));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > most_bytes) throw ReportError(fmt::format("{}: the file is over 4 MiB", path));
  MeasuredReader reader(path, scene);
  reader.read(text);
  return reader.finish();
}

std::vector<DeviationSummary> summaries_of(const std::vector<Comparison>& comparisons) {
  std::vector<DeviationSummary> summaries;
  for (const OutputInfo& quantity : output_infos) {
    DeviationSummary summary{quantity.output};
    std::vector<double> all, on_curve;
    for (const Comparison& one : comparisons) {
      if (one.measured.output != quantity.output) continue;
      ++summary.points;
      if (std::isnan(one.deviation_percent)) continue;
      all.push_back(one.deviation_percent);
      if (one.is_on_curve()) on_curve.push_back(one.deviation_percent);
    }
    if (summary.points == 0) continue;
    std::sort(all.begin(), all.end());
    summary.compared = all.size();
    summary.on_curve = on_curve.size();
    summary.median_percent = median(all);
    summary.on_curve_percent = median(on_curve);
    summary.least_percent = all.empty() ? no_number : all.front();
    summary.greatest_percent = all.empty() ? no_number : all.back();
    summaries.push_back(summary);
  }
  return summaries;
}

void write_comparisons(std::string_view format, std::string_view scene_id, const std::string& path,
                       const std::vector<Comparison>& comparisons, const ordered_json& warnings,
                       OutputStream& output) {
  Text& text = output.text();
  if (format == "json")
    append(text, comparison_json(scene_id, path, comparisons, warnings)
                         .dump(1, ' ', false, ordered_json::error_handler_t::replace) +
                     '\n');
  else if (format == "csv")
    append_comparison_csv(text, scene_id, comparisons);
  else
    append_comparison_table(text, fmt::format("{}: {} beside the model", scene_id, path),
                            comparisons);
  output.flush();
}

}  // namespace tribo::cli
