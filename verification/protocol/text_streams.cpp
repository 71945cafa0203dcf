// SPDX-License-Identifier: Apache-2.0
#include "protocol/text_streams.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "tribo/scene_reader.hpp"

namespace tribo::protocol {
namespace {

// May a failed call be tried again? Waits until the descriptor is ready for it.
bool try_again(int descriptor, short event) {
  if (errno == EINTR) return true;
  if (errno != EAGAIN) return false;
  pollfd ready{descriptor, event, 0};
  ::poll(&ready, 1, -1);
  return true;
}

constexpr std::size_t block_bytes = std::size_t{1} << 16, most_of_pipe = std::size_t{1} << 20;

// Is all text printable ASCII, line ends and tabs? The loop has no branch: each block is checked.
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

ssize_t read_some(int descriptor, char* to, std::size_t most) {
  ssize_t count = 0;
  do {
    count = ::read(descriptor, to, most);
  } while (count < 0 && try_again(descriptor, POLLIN));
  return count;
}

ssize_t write_some(int descriptor, const char* from, std::size_t count) {
  ssize_t written = 0;
  do {
    written = ::write(descriptor, from, count);
  } while (written < 0 && try_again(descriptor, POLLOUT));
  return written;
}

std::string system_message(int code) { return std::generic_category().message(code); }

// The buffer has room for the longest line with its "\r\n", and for one more block.
LineReader::LineReader(int descriptor, std::size_t longest)
    : descriptor_(descriptor), longest_(longest), buffer_(longest + 2 + block_bytes) {
  // A pipe gets room for 1 MiB, if the system allows it, so that one read gives many lines.
  ::fcntl(descriptor, F_SETPIPE_SZ, static_cast<int>(most_of_pipe));
}

bool LineReader::line_waiting() {
  const void* found = std::memchr(buffer_.data() + searched_, '\n', end_ - searched_);
  searched_ = found == nullptr
                  ? end_
                  : static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data());
  return found != nullptr;
}

Line LineReader::next() {
  for (;;) {
    if (line_waiting()) return line_of(searched_ - begin_, searched_ - begin_ + 1);
    if (end_ - begin_ > longest_ + 1) return skip_to_line_end();
    if (read_more()) continue;
    if (begin_ == end_) return {Line::Kind::end_of_input, {}};
    return line_of(end_ - begin_, end_ - begin_);
  }
}

Line LineReader::line_of(std::size_t length, std::size_t with_line_end) {
  std::string_view text(buffer_.data() + begin_, length);
  begin_ += with_line_end;
  searched_ = begin_;
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  if (text.size() > longest_) return {Line::Kind::too_long, {}};
  return {Line::Kind::whole, text};
}

Line LineReader::skip_to_line_end() {
  do {
    begin_ = end_ = searched_ = 0;
  } while (read_more() && !line_waiting());
  begin_ = end_ == 0 ? 0 : searched_ + 1;
  searched_ = begin_;
  return {Line::Kind::too_long, {}};
}

bool LineReader::read_more() {
  if (begin_ == end_) begin_ = end_ = searched_ = 0;
  if (buffer_.size() - end_ < block_bytes) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    searched_ -= begin_;
    end_ -= begin_;
    begin_ = 0;
  }
  const ssize_t count = read_some(descriptor_, buffer_.data() + end_, buffer_.size() - end_);
  if (count < 0) throw InputFailed("-: cannot be read: " + system_message(errno));
  end_ += static_cast<std::size_t>(count);
  return count > 0;
}

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
