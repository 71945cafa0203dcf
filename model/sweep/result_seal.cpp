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
#include "sweep/plan.hpp"

namespace tribo::sweep {
namespace {

struct Seal {
  std::array<unsigned char, 8> mark{0x93, 'T', 'B', 'S', 'R', '1', '\r', '\n'};
  std::uint64_t size = 0;
  std::uint64_t checksum = 0;
};
using SealBytes = std::array<std::byte, 24>;
static_assert(sizeof(Seal) == sizeof(SealBytes));

std::uint64_t checksum_of(int file, std::uint64_t size, const std::string& what,
                          const std::function<bool()>& stopped = {}) {
  XXH3_state_t state{};
  XXH3_64bits_reset(&state);
  Bytes buffer(std::size_t{1} << 20);
  for (std::uint64_t done = 0; done < size;) {
    const auto most = static_cast<std::size_t>(std::min<std::uint64_t>(size - done, buffer.size()));
    if (stopped && stopped()) throw Stopped();
    if (read_at(file, done, std::span(buffer).first(most), what) < most)
      throw std::runtime_error(what + ": it became shorter while it was read");
    XXH3_64bits_update(&state, buffer.data(), most);
    done += most;
  }
  return XXH3_64bits_digest(&state);
}

}  // namespace

void seal(int file) {
  const std::string what = "cannot seal it";
  Seal seal;
  seal.size = size_of(file, what);
  seal.checksum = checksum_of(file, seal.size, what);
  SealBytes bytes;
  std::memcpy(bytes.data(), &seal, bytes.size());
  const ssize_t written = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(seal.size));
  if (written != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error(what + ": " + error_text(written < 0 ? errno : ENOSPC));
}

std::string broken_seal(int file, const std::string& path, std::string_view kind,
                        const std::function<bool()>& stopped) {
  const std::string what = path + " cannot be read";
  const std::uint64_t size = size_of(file, what);
  Seal seal;
  SealBytes bytes{};
  if (size >= bytes.size()) read_at(file, size - bytes.size(), bytes, what);
  if (std::memcmp(bytes.data(), seal.mark.data(), seal.mark.size()) != 0)
    return "is no whole " + std::string(kind) +
           " of tribocheck sweep: it does not end in the checksum of one; it may be another file, "
           "have been cut off, or been changed by another program";
  std::memcpy(&seal, bytes.data(), bytes.size());
  if (seal.size != size - bytes.size() ||
      seal.checksum != checksum_of(file, seal.size, what, stopped))
    return "is damaged, or was changed by another program: its checksum does not hold";
  return {};
}

}  // namespace tribo::sweep
