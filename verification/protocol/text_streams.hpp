// SPDX-License-Identifier: Apache-2.0
// Text that comes from a descriptor line by line, and text that goes to one in large blocks.
#pragma once

#include <fmt/format.h>
#include <sys/types.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tribo::protocol {

// read(2) and write(2), repeated after interruptions and on non-blocking descriptors. At any other
// error they return −1 and set errno.
ssize_t read_some(int descriptor, char* to, std::size_t most);
ssize_t write_some(int descriptor, const char* from, std::size_t count);

// The text of errno, thread-safe.
std::string system_message(int code);

struct InputFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Line {
  enum class Kind : std::uint8_t { whole, too_long, end_of_input };
  Kind kind = Kind::whole;
  // Without its line end, "\n" or "\r\n"; valid until next() is called with no line waiting.
  std::string_view text;
};

// Reads lines in bounded memory: a line that is too long is skipped and not stored.
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
  std::size_t begin_ = 0;  // [begin_, end_): text that was not handed out yet
  std::size_t end_ = 0;
  std::size_t searched_ = 0;  // no line end in [begin_, searched_)
};

using Text = fmt::memory_buffer;

inline void append(Text& text, std::string_view part) {
  const std::size_t before = text.size();
  text.resize(before + part.size());
  std::copy(part.begin(), part.end(), text.data() + before);
}

// Thrown if the program that reads the output has ended (`| head -1`), which is no error. The
// caller has to ignore SIGPIPE.
struct OutputClosed {};

// Thrown if a write fails for another reason, such as a full disk.
struct OutputFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Collects text and writes it in blocks. Control characters, which would steer a terminal, are
// written as escapes such as \u001b, which JSON reads as the character itself.
class OutputStream {
 public:
  explicit OutputStream(int descriptor) : descriptor_(descriptor) {}
  OutputStream() = default;  // keeps all text in memory
  OutputStream(const OutputStream&) = delete;
  OutputStream& operator=(const OutputStream&) = delete;

  // A caller appends a row to this text, then calls end_row().
  Text& text() { return text_; }

  // Writes the text once a block is full.
  void end_row() {
    if (text_.size() >= block_bytes && descriptor_ >= 0) flush();
  }

  // Throws OutputClosed or OutputFailed. Text that was not flushed is lost with the object.
  void flush();

 private:
  static constexpr std::size_t block_bytes = std::size_t{1} << 16;

  int descriptor_ = -1;
  Text text_;
};

}  // namespace tribo::protocol
