// SPDX-License-Identifier: Apache-2.0
#include "scene/input_text.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "scene/entries.hpp"

namespace tribo::scene_detail {
namespace {

bool is_standard_input(const std::string& path) { return path == "-" || path == "/dev/stdin"; }

// A file that is closed with this object; standard input stays open.
class InputFile {
 public:
  explicit InputFile(const std::string& path)
      : owned_(!is_standard_input(path)),
        descriptor_(owned_ ? ::open(path.c_str(), O_RDONLY | O_CLOEXEC) : STDIN_FILENO) {}
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile() {
    if (owned_ && descriptor_ >= 0) ::close(descriptor_);
  }
  int descriptor() const { return descriptor_; }

 private:
  bool owned_;
  int descriptor_;
};

std::string system_message(int code) { return std::generic_category().message(code); }

// Why a path must not be opened; empty if it is a file or a pipe.
std::string refusal_of(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return "cannot be read: " + system_message(errno);
  if (S_ISDIR(status.st_mode)) return "is a directory; allowed: a file or a pipe";
  if (!S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode))
    return "is neither a file nor a pipe; allowed: a file, a pipe, or - for standard input";
  return {};
}

// The message on a file whose first bytes show that it is HDF5, UTF-16 or UTF-32; empty for other
// files. `what` was expected.
std::string other_kind(std::string_view text, std::string_view what) {
  constexpr std::string_view hdf5 = "\x89HDF\r\n\x1a\n";
  constexpr std::string_view part = "tribocheck sweep part";  // model/sweep/part.cpp
  if (text.starts_with(hdf5) && text.substr(0, 8192).find(part) != text.npos)
    return "this is a shard or part of a sweep; allowed: " + std::string(what) +
           " (shards are put together by `tribocheck sweep merge`, parts are completed by "
           "`tribocheck sweep --resume`)";
  if (text.starts_with(hdf5))
    return "this is an HDF5 file; allowed: " + std::string(what) +
           " (the result of a sweep is read by `tribocheck sweep show`)";
  const auto nul_at = [&](std::size_t place) { return text[place] == '\0'; };
  if (text.size() < 4) return {};
  if (text.starts_with(std::string_view("\xFF\xFE\0\0", 4)) ||
      text.starts_with(std::string_view("\0\0\xFE\xFF", 4)))
    return "the file is UTF-32; save it as UTF-8";
  // In UTF-16 without a byte order mark, every other byte of ASCII signs is 0.
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
      (nul_at(0) == nul_at(2) && nul_at(1) == nul_at(3) && nul_at(0) != nul_at(1)))
    return "the file is UTF-16; save it as UTF-8";
  return {};
}

// Reads to the end, or until `text` is too large.
std::string read_up_to_limit(int descriptor, std::string& text) {
  std::array<char, 65536> block;
  while (text.size() <= max_scene_bytes) {
    const ssize_t count = ::read(descriptor, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return "cannot be read: " + system_message(errno);
    if (count == 0) break;
    text.append(block.data(), static_cast<std::size_t>(count));
  }
  return scene_detail::too_large_text(text.size());
}

}  // namespace

std::string read_input_text(const std::string& path, std::string_view what, std::string& text) {
  if (!is_standard_input(path))
    if (std::string refusal = refusal_of(path); !refusal.empty()) return refusal;
  const InputFile file(path);
  if (file.descriptor() < 0) return "cannot be read: " + system_message(errno);
  std::string refusal = read_up_to_limit(file.descriptor(), text);
  if (std::string kind = other_kind(text, what); !kind.empty()) return kind;
  if (!refusal.empty()) return refusal;
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    return "is empty; allowed: " + std::string(what);
  return {};
}

std::string stem_of(std::string_view path) {
  path.remove_prefix(path.rfind('/') + 1);
  const std::size_t dot = path.rfind('.');
  return printable(dot == 0 ? path : path.substr(0, dot), 255);
}

}  // namespace tribo::scene_detail
