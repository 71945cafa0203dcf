// SPDX-License-Identifier: Apache-2.0
#include "stream_answers.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "json_answers.hpp"

namespace tribo::cli {
namespace {

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

}  // namespace

void answer_lines(LineReader& lines, OutputStream& output,
                  const std::function<void(const InputProblem&)>& warn) {
  std::vector<InputProblem> warnings;
  for (std::size_t number = 1;; ++number) {
    if (!lines.line_waiting()) output.flush();
    const Line line = lines.next();
    if (line.kind == Line::Kind::end_of_input) return;
    if (line.kind == Line::Kind::too_long)
      append_error(output.text(), std::nullopt, "", "the line is over 1 MiB");
    else if (!is_blank(line.text))
      append_answer(output.text(), line.text, number, warnings);
    for (const InputProblem& warning : warnings) warn(warning);
    warnings.clear();
    output.end_row();
  }
}

}  // namespace tribo::cli
