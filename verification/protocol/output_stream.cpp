// SPDX-License-Identifier: Apache-2.0
#include "protocol/output_stream.hpp"

#include <cerrno>
#include <string>

#include "protocol/descriptors.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::protocol {

namespace {

// Without a branch, as it is asked of each block.
bool is_plain(const Text& text) {
  unsigned odd = 0;
  for (const char sign : text) {
    const auto c = static_cast<unsigned char>(sign);
    odd |= static_cast<unsigned>((c < 0x20) & (c != '\n') & (c != '\t')) |
           static_cast<unsigned>(c >= 0x7F);
  }
  return odd == 0;
}

}  // namespace

void OutputStream::flush() {
  if (!is_plain(text_)) {
    const std::string safe = without_controls({text_.data(), text_.size()});
    text_.clear();
    append(text_, safe);
  }
  std::size_t done = 0;
  while (done < text_.size()) {
    const ssize_t written = write_some(descriptor_, text_.data() + done, text_.size() - done);
    if (written < 0) {
      if (errno == EPIPE) throw OutputClosed();
      throw OutputFailed("cannot write the results: " + system_message(errno));
    }
    done += static_cast<std::size_t>(written);
  }
  text_.clear();
}

}  // namespace tribo::protocol
