// SPDX-License-Identifier: Apache-2.0
// A part of a sweep: some of its chunks, in one HDF5 file that is whole or not there. A shard is
// such a file, too. A result is put together from such files.
//
//   /        attributes: format, tribocheck_version, numbers (numbers_version), digest (of the
//            plan), arithmetic, replaces, file_names and file_texts (of the sweep's files)
//     chunks [bytes] the chunks (chunk.hpp), one behind the other
//     index  [chunks, 3] a row for each chunk, by ascending number: the number, the end of its
//            bytes in `chunks`, and their checksum (XXH3)
//
// The file ends in a checksum of the whole file (result_seal.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sweep/bytes.hpp"
#include "sweep/output_file.hpp"
#include "sweep/plan.hpp"
#include "sweep/result_seal.hpp"

namespace tribo::sweep {

// The origin of the chunks of a part. Two parts fit together if numbers, digest and arithmetic are
// the same.
struct PartHeader {
  std::string version;        // of tribocheck, for messages
  std::uint64_t numbers = 0;  // numbers_version
  std::string digest;         // of the plan
  std::string arithmetic;     // "FMA", "no FMA"; of a shard "FMA; no FMA" where it has both
  // Names and texts of the files that the plan was made of: the parts alone are enough for a
  // result.
  std::vector<std::pair<std::string, std::string>> files;
  // The file at the output (FileIdentity) that --force lets this sweep replace; empty: none.
  std::string replaces = {};

  template <class To, class Header>
  static void fields(To& to, Header& of) {
    to(of.version, of.numbers, of.digest, of.arithmetic, of.replaces, of.files);
  }
  friend bool operator==(const PartHeader&, const PartHeader&) = default;
};
PartHeader header_of(const SweepPlan& plan);

// Chunks in memory, as bytes, by their numbers.
using ChunksInMemory = std::map<std::uint64_t, Bytes>;

class Part {
 public:
  struct Record {
    std::uint64_t chunk;
    std::uint64_t offset;  // of its bytes in the file
    std::uint64_t size;
    std::uint64_t checksum;
  };

  // Reads a part from its file, after a check of the file's checksum. HDF5 runs in a process of its
  // own (apart.hpp), because the file may be forged. Throws std::runtime_error, with a text that
  // names the file, where it is no whole part, and Stopped once stopped() is true.
  explicit Part(const std::string& path, const std::function<bool()>& stopped = {});
  // A part in memory: a short sweep writes no files of parts.
  Part(PartHeader header, ChunksInMemory chunks);

  const std::string& path() const { return path_; }  // empty: in memory
  const PartHeader& header() const { return header_; }
  std::span<const Record> records() const { return records_; }
  // The bytes of a chunk, after a check of their checksum. The file is opened again each time,
  // because a sweep may have more parts than a process may have open files.
  Bytes read(const Record& record) const;

 private:
  std::string path_;
  PartHeader header_;
  std::vector<Record> records_;
  ChunksInMemory in_memory_;
};

// All chunks of some parts of one sweep, by number.
class PartSet {
 public:
  // Throws std::runtime_error where the parts do not fit together; its text says which and why.
  // With `mixed_fma` their arithmetics may differ.
  PartSet(std::vector<Part> parts, std::uint64_t chunks, bool mixed_fma);

  bool has(std::uint64_t chunk) const { return places_[chunk].part != none; }
  std::uint64_t count() const { return count_; }
  std::uint64_t chunks() const { return places_.size(); }
  Bytes read(std::uint64_t chunk) const;
  std::uint64_t size_of(std::uint64_t chunk) const { return record(chunk).size; }
  // The arithmetics of the chunks, each once, in alphabetical order, joined by "; ". There are
  // several only where the user has allowed it.
  std::string arithmetics() const;

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  struct Place {
    std::uint32_t part = none;
    std::uint32_t record = 0;
  };
  const Part::Record& record(std::uint64_t chunk) const;

  std::vector<Part> parts_;
  std::vector<Place> places_;
  std::uint64_t count_ = 0;
};

// The chunks of a part to be written: their ascending numbers, the size of all of them, and a
// function that gives the bytes of one. It is called in the order of the numbers.
struct PartContent {
  std::vector<std::uint64_t> chunks;
  std::uint64_t bytes = 0;
  std::function<Bytes(std::uint64_t chunk)> read;
};
PartContent content_of(const ChunksInMemory& chunks);

// Writes a part into `file` and to the disk, and gives it its name. Any thread may call it. Throws
// std::runtime_error with a text that names the file `path`. A Stopped that content.read() throws
// passes through.
void write_part(const std::string& path, PartFile& file, const PartHeader& header,
                const PartContent& content, const Replaceable& replaceable);

// The mark of parts and shards (output_file.hpp).
bool is_start_of_part(std::span<const std::byte> start);

}  // namespace tribo::sweep
