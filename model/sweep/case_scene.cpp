// SPDX-License-Identifier: Apache-2.0
#include "sweep/case_scene.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "scene/entries.hpp"
#include "scene/text.hpp"
#include "sweep/cases.hpp"
#include "sweep/variable_reader.hpp"

namespace tribo::sweep {
namespace {

using scene_detail::Entry;
using scene_detail::Value;
using scene_detail::ValueKind;

std::string quoted(std::string_view text) {
  constexpr std::string_view hex = "0123456789ABCDEF";
  std::string result = "\"";
  for (const char sign : text) {
    const auto code = static_cast<unsigned char>(sign);
    if (code < 0x20 || code == 0x7F)
      result += std::string("\\u00") + hex[code >> 4] + hex[code & 15];
    else
      result += (sign == '"' || sign == '\\' ? "\\" : "") + std::string(1, sign);
  }
  return result + '"';
}

std::string value_text(const Value& value) {
  return value.kind == ValueKind::number ? scene_detail::number_text(value.number)
                                         : quoted(value.text);
}

std::string list_text(const Entry& entry) {
  std::string text;
  for (std::size_t i = 0; i < entry.elements.size(); ++i) {
    const std::string name = '[' + std::to_string(i) + ']';
    const auto inner = std::ranges::find(entry.inner, name, &Entry::path);
    text += (i > 0 ? ", " : "") +
            (inner == entry.inner.end() ? value_text(entry.elements[i]) : list_text(*inner));
  }
  return '[' + text + ']';
}

}  // namespace

std::string case_scene(const SceneSweep& sweep, std::uint64_t number) {
  const std::size_t variables = sweep.variables.size();
  std::vector<double> values(sweep.cases_per_group() * variables);
  CaseGenerator(sweep).groups(number / sweep.cases_kept_per_group(), values);
  const std::size_t first = number % sweep.cases_kept_per_group() * variables;
  std::string text = "id = " + quoted(sweep.scene.id + ", case " + std::to_string(number)) + '\n';
  for (std::size_t v = 0; v < variables; ++v)
    text += sweep.variables[v].path + " = " +
            value_text(value_for(sweep.variables[v], values[first + v])) + '\n';
  SceneReading reading;
  scene_detail::Problems problems(reading, sweep.file);
  const auto varies_at = [&](std::string_view path) {
    return std::ranges::any_of(sweep.variables, [path](const Variable& variable) {
      return path == variable.path || path.starts_with(variable.path + '.');
    });
  };
  const auto entries = scene_detail::toml_entries(sweep.text, problems);
  for (const Entry& entry : entries.value()) {
    if (entry.path == "id" || entry.path == "sweep" || entry.value.kind == ValueKind::table ||
        varies_at(entry.path))
      continue;
    text += entry.path + " = " +
            (entry.value.kind == ValueKind::list ? list_text(entry) : value_text(entry.value)) +
            '\n';
  }
  return text;
}

}  // namespace tribo::sweep
