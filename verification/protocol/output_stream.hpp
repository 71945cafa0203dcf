// SPDX-License-Identifier: Apache-2.0
// Results on their way to stdout: gathered into large blocks, every failed write noticed, and signs
// that would steer a terminal written as \u001b, which JSON reads as the sign itself.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <stdexcept>
#include <string_view>

namespace tribo::protocol {

using Text = fmt::memory_buffer;

inline void append(Text& text, std::string_view part) {
  text.append(part.data(), part.data() + part.size());
}

// The reader has gone (`| head -1`): no error, but nothing more to do. Needs SIGPIPE to be ignored.
struct OutputClosed {};

// Any other failed write, as on a full disk.
struct OutputFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class OutputStream {
 public:
  explicit OutputStream(int descriptor) : descriptor_(descriptor) {}
  OutputStream(const OutputStream&) = delete;
  OutputStream& operator=(const OutputStream&) = delete;

  // Append to this, then call end_row().
  Text& text() { return text_; }

  // Writes if a block is full.
  void end_row() {
    if (text_.size() >= block_bytes) flush();
  }

  // Throws OutputClosed or OutputFailed. Text that was not flushed is lost with the object.
  void flush();

 private:
  static constexpr std::size_t block_bytes = std::size_t{1} << 16;

  int descriptor_;
  Text text_;
};

}  // namespace tribo::protocol
