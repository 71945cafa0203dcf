// SPDX-License-Identifier: Apache-2.0
#include "protocol/line_reader.hpp"

#include <cerrno>
#include <cstring>

#include "protocol/descriptors.hpp"

namespace tribo::protocol {
namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 16;

}  // namespace

// Room for the longest line with its "\r\n", and a block more.
LineReader::LineReader(int descriptor, std::size_t longest)
    : descriptor_(descriptor), longest_(longest), buffer_(longest + 2 + block_bytes) {}

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

}  // namespace tribo::protocol
