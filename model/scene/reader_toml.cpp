// SPDX-License-Identifier: Apache-2.0
// TOML to entries, by toml++ 3.3, which gets to see screened text only (toml_screen.hpp).
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#define TOML_MAX_NESTED_VALUES 32
#include <toml++/impl/forward_declarations.h>
// Two macros of toml++ are replaced before it uses them:
// - toml++ assumes properties of characters that it checks only later: "[=]" trips an assertion in
//   a debug build and is undefined behaviour with clang's __builtin_assume. Without the assumptions
//   toml++ reports an error;
// - its tests for non-ASCII blanks call every other character "unreachable", as the é of a=+"é".
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT_ASSUME(expr) static_assert(true)
#undef TOML_UNREACHABLE
#define TOML_UNREACHABLE return false
#include <toml++/impl/unicode.h>
#undef TOML_UNREACHABLE
#define TOML_UNREACHABLE __builtin_unreachable()
#include <toml++/toml.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "scene/entries.hpp"
#include "scene/schema.hpp"
#include "scene/text.hpp"
#include "scene/toml_screen.hpp"

namespace tribo {
namespace scene_detail {
namespace {

class TomlCollector {
 public:
  explicit TomlCollector(const std::vector<WideNumber>& wide_numbers)
      : wide_numbers_(wide_numbers) {}

  std::vector<Entry> collect(const toml::table& root) {
    for (const auto& [key, node] : root) {
      const std::string name = path_part(key.str());
      add(name, node);
      const toml::table* const table = node.as_table();
      if (table == nullptr || !is_section(name)) continue;
      for (const auto& [inner_key, inner_node] : *table)
        add(name + '.' + path_part(inner_key.str()), inner_node);
    }
    return std::move(entries_);
  }

 private:
  void add(std::string path, const toml::node& node) {
    const bool apart = is_section(path);  // its fields get entries of their own
    entries_.push_back(entry_of(std::move(path), node, apart ? 0 : inner_depth));
  }

  // The entry of a node. Lists and tables in it go to `inner`, down to `levels` levels.
  Entry entry_of(std::string path, const toml::node& node, int levels) const {
    Entry entry{std::move(path), value_of(node), {}};
    if (const toml::array* const list = node.as_array()) {
      entry.elements.reserve(list->size());
      for (const toml::node& element : *list) {
        entry.elements.push_back(value_of(element));
        if (levels > 0 && (element.is_array() || element.is_table()))
          entry.inner.push_back(
              entry_of('[' + std::to_string(entry.elements.size() - 1) + ']', element, levels - 1));
      }
    }
    const toml::table* const table = node.as_table();
    if (levels > 0 && table != nullptr)
      for (const auto& [key, inner] : *table)
        entry.inner.push_back(entry_of(path_part(key.str()), inner, levels - 1));
    return entry;
  }

  Value value_of(const toml::node& node) const {
    switch (node.type()) {
      case toml::node_type::integer:
        return {.kind = ValueKind::number,
                .number = static_cast<double>(node.as_integer()->get()),
                .text = {}};
      case toml::node_type::floating_point:
        return float_of(node);
      case toml::node_type::string:
        return {.kind = ValueKind::text, .text = node.as_string()->get()};
      case toml::node_type::boolean:
        return {
            .kind = ValueKind::boolean, .number = node.as_boolean()->get() ? 1.0 : 0.0, .text = {}};
      case toml::node_type::array:
        return {.kind = ValueKind::list, .text = {}};
      case toml::node_type::table:
        return {.kind = ValueKind::table, .text = {}};
      default:
        return {.kind = ValueKind::date_time, .text = {}};
    }
  }

  Value float_of(const toml::node& node) const {
    const toml::source_position where = node.source().begin;
    const auto found =
        std::lower_bound(wide_numbers_.begin(), wide_numbers_.end(), where,
                         [](const WideNumber& number, const toml::source_position& place) {
                           return std::tuple<std::size_t, std::size_t>(number.row, number.column) <
                                  std::tuple<std::size_t, std::size_t>(place.line, place.column);
                         });
    if (found != wide_numbers_.end() && found->row == where.line && found->column == where.column)
      return found->value;
    return {.kind = ValueKind::number, .number = node.as_floating_point()->get(), .text = {}};
  }

  // Enough for sweep.correlation, a list of lists in a table, and for a mistake in a solver
  // (reference/mistakes.toml): a table in a list, with tables in tables.
  static constexpr int inner_depth = 5;

  const std::vector<WideNumber>& wide_numbers_;
  std::vector<Entry> entries_;
};

// The name at the end of "cannot redefine existing floating-point 'viscosity'", after the name of
// the table in which the row stands; empty for other errors.
std::string redefined_field(const std::string& description, std::size_t row,
                            const std::vector<TableHeader>& headers) {
  const std::size_t start = description.find("cannot redefine existing");
  if (start == std::string::npos) return {};
  const std::size_t open = description.find('\'', start);
  const std::size_t close = description.rfind('\'');
  if (open == std::string::npos || close <= open) return {};
  std::string name = description.substr(open + 1, close - open - 1);
  while (!name.empty() && name.back() == ' ') name.pop_back();
  const TableHeader* header = nullptr;
  for (const TableHeader& candidate : headers)
    if (candidate.row <= row) header = &candidate;
  if (header == nullptr || header->row == row) return name;
  return std::string(header->name) + '.' + name;
}

// Is this a table of a sweep? Such a table says how a field varies, or how the sweep is made.
bool is_of_sweep(const Entry& entry) {
  if (entry.value.kind != ValueKind::table) return false;
  return entry.path == "sweep" ||
         std::any_of(entry.inner.begin(), entry.inner.end(), [&entry](const Entry& inner) {
           return inner.path == "distribution" || inner.path == "printed" ||
                  (inner.path == "count" && entry.path != "speed");
         });
}

// Did the parser stop at a letter, for example at a unit after a number?
bool stops_at_letter(std::string_view description) {
  if (description.size() < 3 || !description.ends_with('\'')) return false;
  const char sign = description[description.size() - 2];
  return (sign >= 'a' && sign <= 'z') || (sign >= 'A' && sign <= 'Z');
}

void report(const toml::parse_error& error, const TomlScreen& screen, Problems& problems) {
  const toml::source_position where = error.source().begin;
  std::string description(error.description());
  const std::string field = redefined_field(description, where.line, screen.headers);
  if (!field.empty())
    return problems.error_at(where.line, where.column, field, {.rule = Fault::once});
  if (description.starts_with("Error while")) description.erase(0, 6);
  if (stops_at_letter(description))
    description += "; a number with a unit stands in quotes, as \"46 kN\"";
  problems.error_at(where.line, where.column, "", {.what = "not TOML: " + description});
}

}  // namespace

std::optional<std::vector<Entry>> toml_entries(std::string_view text, Problems& problems,
                                               std::size_t most_fields) {
  if (const std::string refusal = too_large_text(text.size()); !refusal.empty()) {
    problems.error("", {.what = refusal});
    return std::nullopt;
  }
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  std::string screened(text);
  const TomlScreen screen = screen_toml(screened, most_fields);
  if (!screen.complaint.empty()) {
    problems.error_at(screen.row, screen.column, "", {.what = screen.complaint});
    return std::nullopt;
  }
  const toml::parse_result result = toml::parse(std::string_view(screened));
  if (!result) {
    report(result.error(), screen, problems);
    return std::nullopt;
  }
  return TomlCollector(screen.wide_numbers).collect(result.table());
}

}  // namespace scene_detail

SceneReading parse_scene_toml(std::string_view text, std::string_view source, SceneUse use,
                              std::span<const std::string_view> outputs) {
  SceneReading reading;
  scene_detail::Problems problems(reading, source);
  auto entries = scene_detail::toml_entries(text, problems);
  if (!entries) return reading;
  scene_detail::put_outputs(outputs, *entries);
  if (std::any_of(entries->begin(), entries->end(), scene_detail::is_of_sweep))
    problems.error("", {.what = "this is a sweep: use `tribocheck sweep`"});
  else
    scene_detail::bind_scene(*entries, use, problems, reading);
  return reading;
}

}  // namespace tribo
