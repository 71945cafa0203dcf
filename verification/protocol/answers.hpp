// SPDX-License-Identifier: Apache-2.0
// The model's answer to a line of JSON: a JSON object on one line, as `stream` and `--format json`
// write it:
//
//   {"id": "p1", "film": 3.42e-8, "friction": null, "undefined": {"friction": "the film …"}}
//
// Numbers read back to the same double. Undefined outputs are null; their reasons stand at the end.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "protocol/output_values.hpp"
#include "protocol/question.hpp"
#include "protocol/text_streams.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/operating_points.hpp"
#include "tribo/scene_reader.hpp"
#include "tribo/validity.hpp"

namespace tribo::protocol {

// Writes an output at the first `to.size()` points of a batch into `to`: a number as it is, a word
// as its place among the output's words, and NaN if value_of() gives a reason why it is undefined.
void put_values(const OperatingPoints& points, const SmoothContact* smooth, Output output,
                std::span<double> to);

// The outputs that value_of() needs: those that are asked, and the film if the least film, Λ or the
// inlet is asked (the inlet is undefined if the film overflows), if the film law is solved, or if
// outputs of summits are asked and Rq alone is known.
OutputSet needed_for(const Scene& scene);
OutputSet needed_for(const Scene& scene, OutputSet asked);  // `asked`, not the scene's own outputs

// Appends a JSON text with its quotes. Bytes that are not UTF-8 become U+FFFD.
void append_json_text(Text& to, std::string_view text);

// Appends the shortest decimal that reads back to the same double. The number must be finite.
void append_number(Text& to, double number);

// The id of a line, which its answer repeats. Without a text the answer has the id null.
struct LineId {
  std::optional<std::string_view> text;
  bool is_number = false;
};
// The id of a question, which is a SceneReading or a FunctionCall.
template <class Asked>
LineId id_of(const Asked& asked) {
  return {asked.id, asked.id_is_number};
}

class AnswerObject {
 public:
  AnswerObject(Text& to, LineId id);

  // Each call appends a member. Names and reasons must outlive the object.
  void number(std::string_view name, double value);  // undefined if it is not finite
  void word(std::string_view name, std::string_view value);
  void undefined(std::string_view name, std::string_view reason);
  void value(std::string_view name, const OutputValue& value);

  // Ends the object, without a line end.
  void close();

 private:
  void start_member(std::string_view name);

  struct Undefined {
    std::string_view name, reason;
  };
  Text& to_;
  std::array<Undefined, 16> undefined_;
  std::size_t undefined_count_ = 0;
};

// Appends the answer, always one whole line with its line end, whatever the input is. `number` is
// the number of the line. `passed` gets the limits that the line's scene goes beyond and does not
// list under `accept`.
void append_answer(Text& to, std::string_view line, std::size_t number,
                   std::vector<Validity>& passed);

// {"id": …, "error": {"field": …, "message": …}}
void append_error(Text& to, LineId id, std::string_view field, std::string_view message);

// The answer to a scene with errors. It names the first error only; if the text is not JSON, it
// also gives the column.
void append_first_error(Text& to, const SceneReading& reading);

// Does the work of `stream`, but opens nothing and writes nothing to stderr. Answers all lines that
// are not blank, in order, until the input ends. A program that waits for each answer gets it
// before it must ask again: the output is flushed whenever no complete line is waiting. Many lines
// that wait are answered on up to eight threads. `warn` is called, in order and on the calling
// thread, for each line whose scene goes beyond limits, with the line's number and these limits.
void answer_lines(LineReader& lines, OutputStream& output,
                  const std::function<void(std::size_t, const std::vector<Validity>&)>& warn);

}  // namespace tribo::protocol
