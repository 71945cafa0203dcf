// SPDX-License-Identifier: Apache-2.0
#include "protocol/output_stream.hpp"

#include <cerrno>

#include "protocol/descriptors.hpp"

namespace tribo::protocol {

void OutputStream::flush() {
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
