// SPDX-License-Identifier: Apache-2.0
// Lines from a descriptor, in bounded memory whatever comes: a line that is too long is skipped
// without being stored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace tribo::protocol {

struct InputFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Line {
  enum class Kind : std::uint8_t { whole, too_long, end_of_input };
  Kind kind = Kind::whole;
  std::string_view text;  // without its line end, "\n" or "\r\n"; good until the next call
};

class LineReader {
 public:
  LineReader(int descriptor, std::size_t longest);

  // Is there a complete line in memory, so that next() will not wait?
  bool line_waiting();

  // The last line needs no line end. Throws InputFailed if the descriptor cannot be read.
  Line next();

 private:
  Line line_of(std::size_t length, std::size_t with_line_end);
  Line skip_to_line_end();
  bool read_more();  // false at the end of the input

  int descriptor_;
  std::size_t longest_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  // what is held and not yet handed out: [begin_, end_)
  std::size_t end_ = 0;
  std::size_t searched_ = 0;  // no line end in [begin_, searched_)
};

}  // namespace tribo::protocol
