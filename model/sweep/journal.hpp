// SPDX-License-Identifier: Apache-2.0
// The journal of a sweep: a file to which each chunk is appended as soon as it is computed. A
// record carries its length and a checksum (XXH3), so that what a crash left half-written is known
// for what it is. The first record says which sweep it is and on what it was computed.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sweep/bytes.hpp"
#include "sweep/disk.hpp"

namespace tribo::sweep {

// The origin of the chunks of a journal. Chunks of two journals go together if version, digest and
// arithmetic are the same.
struct JournalHeader {
  std::string version;     // of tribocheck
  std::string digest;      // of the plan
  std::string arithmetic;  // "FMA" or "no FMA"
  // The files that the plan was made of: names and texts, so that a journal is enough to make the
  // result.
  std::vector<std::pair<std::string, std::string>> files;
  // Which file (FileIdentity) at the output --force has allowed this sweep to replace; empty: none.
  std::string replaces = {};

  friend bool operator==(const JournalHeader&, const JournalHeader&) = default;
};

// The work was to end early.
struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped") {}
};

// The mark of journals and shards (output_file.hpp).
bool is_start_of_journal(std::span<const std::byte> start);

// A journal, open for appending. One process at a time has it: a lock (flock) sees to that. Writes
// go to the system at once, so that a killed process loses nothing, and to the disk every few
// seconds and in sync(). All errors are thrown as std::runtime_error, with a text that names the
// file; a record that could not be written whole is taken back (the file is cut to where it was).
class Journal {
 public:
  // Makes a new one; fails if there is a file already.
  static Journal create(const std::string& path, const JournalHeader& header);
  // Begins one in a new open file of this name.
  static Journal begin(Descriptor file, const std::string& path, const JournalHeader& header);
  // Opens a journal to go on behind its last whole record. The bytes behind that record are cut
  // off. Damage before it is left as it is, so that no whole record behind the damage is lost.
  static Journal resume(const std::string& path);

  // Any thread may call.
  void append(std::uint64_t chunk, std::span<const std::byte> bytes);
  void sync();
  // False once its name leads to another file, or to none.
  bool is_there() const;

 private:
  Journal(Descriptor file, std::string path);
  void write_record(std::uint64_t number, std::span<const std::byte> bytes);

  Descriptor file_;
  std::string path_;
  std::uint64_t seed_ = 0;  // of the checksums
  std::uint64_t end_ = 0;   // where the next record goes
  std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();
  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();
};

// The records of one journal, found and checked by one pass through the file.
class JournalReader {
 public:
  // Throws std::runtime_error, with a text that names the file, where it cannot be read or its
  // header is none; Stopped once stopped() is true.
  explicit JournalReader(const std::string& path, const std::function<bool()>& stopped = {});

  const std::string& path() const { return path_; }
  const JournalHeader& header() const { return header_; }
  struct Record {
    std::uint64_t chunk;
    std::uint64_t offset;  // of its bytes in the file
    std::uint64_t size;
  };
  std::span<const Record> records() const { return records_; }
  // Bytes that belong to no whole record: half a record at the end, or damage anywhere, behind
  // which the pass goes on. 0: none.
  std::uint64_t lost_bytes() const { return lost_bytes_; }
  // Reads a record again and checks it again.
  Bytes read(const Record& record) const;

 private:
  Descriptor file_;
  std::string path_;
  JournalHeader header_;
  std::uint64_t seed_ = 0;  // of the checksums
  std::vector<Record> records_;
  std::uint64_t lost_bytes_ = 0;
};

// All chunks of some journals of one sweep, by number.
class JournalSet {
 public:
  // Throws std::runtime_error where the journals do not go together: the text says which and why.
  // With `mixed_fma` their arithmetics may differ.
  JournalSet(std::vector<JournalReader> readers, std::uint64_t chunks, bool mixed_fma);

  const JournalHeader& header() const { return readers_.front().header(); }
  bool has(std::uint64_t chunk) const { return places_[chunk].reader != none; }
  std::uint64_t count() const { return count_; }
  std::uint64_t chunks() const { return places_.size(); }
  Bytes read(std::uint64_t chunk) const;
  // The arithmetics with which the chunks were computed: each once, in the alphabet's order. There
  // are several only where the user has allowed it.
  std::string arithmetics() const;

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  struct Place {
    std::uint32_t reader = none;
    std::uint32_t record = 0;
  };

  std::vector<JournalReader> readers_;
  std::vector<Place> places_;
  std::uint64_t count_ = 0;
};

}  // namespace tribo::sweep
