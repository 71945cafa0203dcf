// SPDX-License-Identifier: Apache-2.0
// Files on a disk: opened only if they are regular files, read at any place, and closed once.
#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace tribo::sweep {

// Owns an open file.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  operator int() const { return number_; }  // NOLINT(google-explicit-constructor)

 private:
  int number_ = -1;
};

inline std::string error_text(int code) { return std::generic_category().message(code); }

// Opens a regular file, and refuses a FIFO without waiting. A failure is thrown as
// std::runtime_error, whose text begins with `what`: "cannot read sweep.h5".
inline Descriptor open_file(const std::string& path, int flags, const std::string& what) {
  Descriptor file(::open(path.c_str(), flags | O_NONBLOCK | O_CLOEXEC, 0666));
  if (file < 0) throw std::runtime_error(what + ": " + error_text(errno));
  struct stat status {};
  if (::fstat(file, &status) != 0) throw std::runtime_error(what + ": " + error_text(errno));
  if (!S_ISREG(status.st_mode)) throw std::runtime_error(what + ": it is no regular file");
  return file;
}

// size_of() gives the size of an open file. read_at() reads from `offset` until `room` is full or
// the file ends, and returns the number of bytes. Both throw as open_file() does.
inline std::uint64_t size_of(int file, const std::string& what) {
  struct stat status {};
  if (::fstat(file, &status) != 0) throw std::runtime_error(what + ": " + error_text(errno));
  return static_cast<std::uint64_t>(status.st_size);
}
inline std::size_t read_at(int file, std::uint64_t offset, std::span<std::byte> room,
                           const std::string& what) {
  std::size_t have = 0;
  while (have < room.size()) {
    const ssize_t got =
        ::pread(file, room.data() + have, room.size() - have, static_cast<off_t>(offset + have));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw std::runtime_error(what + ": " + error_text(errno));
    if (got == 0) break;
    have += static_cast<std::size_t>(got);
  }
  return have;
}

// Writes a whole text at the file's position. Throws std::runtime_error with the reason alone.
inline void write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw std::runtime_error(error_text(written < 0 ? errno : ENOSPC));
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

// Takes the lock of a file for this process alone. Some network file systems know no locks; a sweep
// runs there all the same.
enum class Locking : std::uint8_t { locked, taken_by_another, without_locks };
inline Locking lock_file(int file, const std::string& path) {
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) return Locking::locked;
  if (errno == EWOULDBLOCK) return Locking::taken_by_another;
  if (errno != ENOSYS && errno != ENOTSUP && errno != ENOLCK)
    throw std::runtime_error("cannot lock " + path + ": " + error_text(errno));
  return Locking::without_locks;
}

inline std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == path.npos ? "." : path.substr(0, slash + 1);
}

// A path that opens an open file again, whatever its name leads to by then.
inline std::string open_path_of(int file) { return "/proc/self/fd/" + std::to_string(file); }

}  // namespace tribo::sweep
