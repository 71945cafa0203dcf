// SPDX-License-Identifier: Apache-2.0
#include "sweep/result_seal.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "sweep/bytes.hpp"
#include "sweep/disk.hpp"

namespace tribo::sweep {
namespace {

struct Seal {
  std::array<unsigned char, 8> mark{0x93, 'T', 'B', 'S', 'R', '1', '\r', '\n'};
  std::uint64_t size = 0;
  std::uint64_t checksum = 0;
};
using SealBytes = std::array<std::byte, 24>;
static_assert(sizeof(Seal) == sizeof(SealBytes));

// What `read` of the system leaves out where it is interrupted or short, read too.
std::size_t read_at(int file, std::uint64_t offset, std::byte* to, std::size_t size) {
  std::size_t have = 0;
  while (have < size) {
    const ssize_t got = ::pread(file, to + have, size - have, static_cast<off_t>(offset + have));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw std::runtime_error(error_text(errno));
    if (got == 0) break;
    have += static_cast<std::size_t>(got);
  }
  return have;
}

std::uint64_t checksum_of(int file, std::uint64_t size) {
  XXH3_state_t state{};
  XXH3_64bits_reset(&state);
  Bytes buffer(std::size_t{1} << 20);
  for (std::uint64_t done = 0; done < size;) {
    const auto some = static_cast<std::size_t>(std::min<std::uint64_t>(size - done, buffer.size()));
    if (read_at(file, done, buffer.data(), some) < some)
      throw std::runtime_error("it became shorter while it was read");
    XXH3_64bits_update(&state, buffer.data(), some);
    done += some;
  }
  return XXH3_64bits_digest(&state);
}

std::uint64_t size_of(int file) {
  struct stat status {};
  if (::fstat(file, &status) != 0) throw std::runtime_error(error_text(errno));
  return static_cast<std::uint64_t>(status.st_size);
}

}  // namespace

void seal(const std::string& path) {
  const Descriptor file = open_file(path, O_RDWR, "cannot open " + path);
  Seal seal;
  seal.size = size_of(file);
  seal.checksum = checksum_of(file, seal.size);
  SealBytes bytes;
  std::memcpy(bytes.data(), &seal, bytes.size());
  const ssize_t written = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(seal.size));
  if (written < 0) throw std::runtime_error(error_text(errno));
  if (written != static_cast<ssize_t>(bytes.size())) throw std::runtime_error(error_text(ENOSPC));
}

std::string broken_seal(const std::string& path) {
  const Descriptor file = open_file(path, O_RDONLY, path + " cannot be read");
  try {
    const std::uint64_t size = size_of(file);
    Seal seal;
    SealBytes bytes{};
    if (size >= bytes.size()) read_at(file, size - bytes.size(), bytes.data(), bytes.size());
    if (std::memcmp(bytes.data(), seal.mark.data(), seal.mark.size()) != 0)
      return "is no whole result of tribocheck sweep: it does not end in the checksum of one; it "
             "may be another file, have been cut off, or been changed by another program";
    std::memcpy(&seal, bytes.data(), bytes.size());
    if (seal.size != size - bytes.size() || seal.checksum != checksum_of(file, seal.size))
      return "is damaged, or was changed by another program: its checksum does not hold";
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + " cannot be read: " + error.what());
  }
  return {};
}

}  // namespace tribo::sweep
