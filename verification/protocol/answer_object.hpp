// SPDX-License-Identifier: Apache-2.0
// One JSON object on one line, as `stream` and `--format json` write it:
//
//   {"id": "p1", "film": 3.42e-8, "friction": null, "undefined": {"friction": "the film …"}}
//
// Numbers read back to the same double; what is undefined is null and has its reason at the end.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "protocol/output_stream.hpp"
#include "protocol/output_values.hpp"

namespace tribo::protocol {

// A JSON text with its quotes; bytes that are not UTF-8 become U+FFFD.
void append_json_text(Text& to, std::string_view text);

// The shortest decimal that reads back to the same double; finite numbers only.
void append_number(Text& to, double number);

class AnswerObject {
 public:
  // Without an id: null.
  AnswerObject(Text& to, std::optional<std::string_view> id);

  // Members in the order of the calls. Names and reasons must outlive the object.
  void number(std::string_view name, double value);  // undefined where it is not finite
  void word(std::string_view name, std::string_view value);
  void undefined(std::string_view name, std::string_view reason);
  void value(std::string_view name, const OutputValue& value);
  void error(std::string_view field, std::string_view message);

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

}  // namespace tribo::protocol
