// SPDX-License-Identifier: Apache-2.0
// How a journal's records lie in the file, one behind the other:
//
//   magic     8 bytes
//   number    8 bytes; of the chunk, or header_number
//   size      8 bytes; of what follows the checksum
//   checksum  8 bytes; XXH3 of number, size and the rest, with the seed of the journal
//   the bytes
//
// The header is written twice, as the first two records, so that one damaged place cannot make a
// journal unreadable; the seed of these two records is 0. The seed of the other records is the
// header's checksum, so that records of another sweep do not count as records of this journal.
// After damage the next whole record is found by its magic.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

#include "sweep/bytes.hpp"
#include "sweep/journal.hpp"

// All of it in each source that uses it, so that nothing has to be linked.
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace tribo::sweep::journal_record {

inline constexpr std::array<unsigned char, 8> magic{0x93, 'T', 'B', 'S', 'J', '1', '\r', '\n'};
inline constexpr std::uint64_t header_number = std::numeric_limits<std::uint64_t>::max();

struct Head {
  std::uint64_t number = 0;
  std::uint64_t size = 0;
  std::uint64_t checksum = 0;
};
inline constexpr std::size_t head_size = magic.size() + 3 * sizeof(std::uint64_t);
using HeadBytes = std::array<std::byte, head_size>;

inline HeadBytes to_bytes(const Head& head) {
  HeadBytes bytes;
  std::memcpy(bytes.data(), magic.data(), magic.size());
  std::memcpy(bytes.data() + 8, &head.number, 8);
  std::memcpy(bytes.data() + 16, &head.size, 8);
  std::memcpy(bytes.data() + 24, &head.checksum, 8);
  return bytes;
}

inline bool has_magic(std::span<const std::byte, head_size> bytes) {
  return std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

inline Head head_from(std::span<const std::byte, head_size> bytes) {
  Head head;
  std::memcpy(&head.number, bytes.data() + 8, 8);
  std::memcpy(&head.size, bytes.data() + 16, 8);
  std::memcpy(&head.checksum, bytes.data() + 24, 8);
  return head;
}

// The checksum of a record whose bytes come in pieces.
class Checksum {
 public:
  Checksum(const Head& head, std::uint64_t seed) {
    XXH3_64bits_reset_withSeed(&state_, seed);
    XXH3_64bits_update(&state_, &head.number, sizeof head.number);
    XXH3_64bits_update(&state_, &head.size, sizeof head.size);
  }
  void add(std::span<const std::byte> bytes) {
    XXH3_64bits_update(&state_, bytes.data(), bytes.size());
  }
  std::uint64_t value() const { return XXH3_64bits_digest(&state_); }

 private:
  XXH3_state_t state_{};
};

inline std::uint64_t checksum(const Head& head, std::span<const std::byte> bytes,
                              std::uint64_t seed) {
  Checksum sum(head, seed);
  sum.add(bytes);
  return sum.value();
}

// The findings of one pass through a file.
struct Found {
  JournalHeader header;
  std::uint64_t seed = 0;
  std::vector<JournalReader::Record> records;
  std::uint64_t end = 0;         // of the last whole record
  std::uint64_t lost_bytes = 0;  // in no whole record
};
// Throws std::runtime_error where the file cannot be read or has no header, Stopped once stopped()
// is true.
Found find_records(int descriptor, const std::string& path,
                   const std::function<bool()>& stopped = {});

}  // namespace tribo::sweep::journal_record
