// SPDX-License-Identifier: Apache-2.0
#include "protocol/stream_answers.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "protocol/json_answers.hpp"
#include "protocol/question.hpp"

namespace tribo::protocol {

void answer_lines(LineReader& lines, OutputStream& output,
                  const std::function<void(const InputProblem&)>& warn) {
  std::vector<InputProblem> warnings;
  for (std::size_t number = 1;; ++number) {
    if (!lines.line_waiting()) output.flush();
    const Line line = lines.next();
    if (line.kind == Line::Kind::end_of_input) return;
    if (line.kind == Line::Kind::too_long)
      append_error(output.text(), std::nullopt, "", line_too_long);
    else if (!is_blank(line.text))
      append_answer(output.text(), line.text, number, warnings);
    for (const InputProblem& warning : warnings) warn(warning);
    warnings.clear();
    output.end_row();
  }
}

}  // namespace tribo::protocol
