// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sweep/journal.hpp"
#include "sweep/journal_record.hpp"

namespace tribo::sweep {
namespace {

using journal_record::Checksum;
using journal_record::Found;
using journal_record::Head;
using journal_record::head_size;
using journal_record::HeadBytes;
using journal_record::header_number;
using journal_record::magic;

JournalHeader header_from(std::span<const std::byte> bytes) {
  ByteReader from(bytes);
  JournalHeader header;
  header.version = from.take_text();
  header.digest = from.take_text();
  header.arithmetic = from.take_text();
  const auto files = from.take<std::uint64_t>();
  for (std::uint64_t i = 0; i < files; ++i) {
    std::string name = from.take_text();
    header.files.emplace_back(std::move(name), from.take_text());
  }
  if (!from.empty()) header.replaces = from.take_text();
  return header;
}

// One file, read from any place.
class File {
 public:
  File(int descriptor, const std::string& path, const std::function<bool()>& stopped = {})
      : descriptor_(descriptor),
        what_("cannot read " + path),
        size_(size_of(descriptor, what_)),
        stopped_(stopped) {}

  std::uint64_t size() const { return size_; }

  // As many bytes as there are, up to the room.
  std::span<std::byte> read(std::uint64_t offset, std::span<std::byte> room) const {
    if (stopped_ && stopped_()) throw Stopped();
    return room.first(read_at(descriptor_, offset, room, what_));
  }

 private:
  int descriptor_;
  std::string what_;
  std::uint64_t size_;
  std::function<bool()> stopped_;
};

class Search {
 public:
  explicit Search(const File& file) : file_(file), buffer_(std::size_t{1} << 20) {}

  // The head of the record at an offset, if there is a whole one.
  std::optional<Head> whole_record(std::uint64_t offset, std::uint64_t seed) {
    HeadBytes bytes;
    if (file_.read(offset, bytes).size() < bytes.size()) return std::nullopt;
    if (!journal_record::has_magic(bytes)) return std::nullopt;
    const Head head = journal_record::head_from(bytes);
    if (head.size > file_.size() - std::min(file_.size(), offset + head_size)) return std::nullopt;
    Checksum sum(head, head.number == header_number ? 0 : seed);
    for (std::uint64_t done = 0; done < head.size;) {
      const auto most = std::min<std::uint64_t>(head.size - done, buffer_.size());
      const auto some = file_.read(offset + head_size + done,
                                   std::span(buffer_).first(static_cast<std::size_t>(most)));
      if (some.size() < most) return std::nullopt;
      sum.add(some);
      done += most;
    }
    if (sum.value() != head.checksum) return std::nullopt;
    return head;
  }

  // Where the magic stands next, from an offset on.
  std::optional<std::uint64_t> next_magic(std::uint64_t offset) {
    const auto* const first = reinterpret_cast<const std::byte*>(magic.data());
    for (;;) {
      const auto some = file_.read(offset, buffer_);
      if (some.size() < magic.size()) return std::nullopt;
      const auto found = std::search(some.begin(), some.end(), first, first + magic.size());
      if (found != some.end()) return offset + static_cast<std::uint64_t>(found - some.begin());
      offset += some.size() - (magic.size() - 1);
    }
  }

  Bytes bytes(std::uint64_t offset, std::uint64_t size) const {
    Bytes bytes(static_cast<std::size_t>(size));
    bytes.resize(file_.read(offset, bytes).size());
    return bytes;
  }

 private:
  const File& file_;
  Bytes buffer_;
};

}  // namespace

namespace journal_record {

Found find_records(int descriptor, const std::string& path, const std::function<bool()>& stopped) {
  const File file(descriptor, path, stopped);
  Search search(file);
  Found found;
  bool has_header = false;
  std::uint64_t in_whole_records = 0;
  for (std::uint64_t offset = 0; offset < file.size();) {
    const std::optional<Head> head = search.whole_record(offset, found.seed);
    if (!head || (!has_header && head->number != header_number)) {
      offset = search.next_magic(offset + 1).value_or(file.size());
      continue;
    }
    const std::uint64_t first = offset + head_size;
    if (head->number != header_number) {
      found.records.push_back({head->number, first, head->size});
    } else if (!has_header) {
      found.header = header_from(search.bytes(first, head->size));
      found.seed = head->checksum;
      has_header = true;
    }
    offset = found.end = first + head->size;
    in_whole_records += head_size + head->size;
  }
  if (!has_header)
    throw std::runtime_error(path + " is no journal of a sweep, or its head is lost");
  found.lost_bytes = file.size() - in_whole_records;
  return found;
}

}  // namespace journal_record

bool is_start_of_journal(std::span<const std::byte> start) {
  return start.size() >= magic.size() && std::memcmp(start.data(), magic.data(), magic.size()) == 0;
}

JournalReader::JournalReader(const std::string& path, const std::function<bool()>& stopped)
    : file_(open_file(path, O_RDONLY, "cannot read " + path)), path_(path) {
  Found found = journal_record::find_records(file_, path, stopped);
  header_ = std::move(found.header);
  seed_ = found.seed;
  records_ = std::move(found.records);
  lost_bytes_ = found.lost_bytes;
}

Bytes JournalReader::read(const Record& record) const {
  const File file(file_, path_);
  HeadBytes head_bytes;
  Bytes bytes(static_cast<std::size_t>(record.size));
  const bool is_there =
      file.read(record.offset - head_size, head_bytes).size() == head_bytes.size() &&
      file.read(record.offset, bytes).size() == bytes.size();
  const Head head = journal_record::head_from(head_bytes);
  if (!is_there || head.number != record.chunk || head.size != record.size ||
      journal_record::checksum(head, bytes, seed_) != head.checksum)
    throw std::runtime_error(path_ + " has changed since it was opened: chunk " +
                             std::to_string(record.chunk) + " is damaged");
  return bytes;
}

JournalSet::JournalSet(std::vector<JournalReader> readers, std::uint64_t chunks, bool mixed_fma)
    : readers_(std::move(readers)) {
  if (readers_.empty()) throw std::runtime_error("no journal is given");
  const JournalReader& first = readers_.front();
  const JournalHeader& ours = first.header();
  for (const JournalReader& reader : readers_) {
    const JournalHeader& header = reader.header();
    if (header.version != ours.version)
      throw std::runtime_error(reader.path() + " was computed by tribocheck " + header.version +
                               ", " + first.path() + " by " + ours.version);
    if (header.digest != ours.digest)
      throw std::runtime_error(reader.path() + " is of another sweep than " + first.path() +
                               " (digest " + header.digest + ", not " + ours.digest + ")");
    if (!mixed_fma && header.arithmetic != ours.arithmetic)
      throw std::runtime_error(reader.path() + " was computed with " + header.arithmetic + ", " +
                               first.path() + " with " + ours.arithmetic);
    for (const JournalReader::Record& record : reader.records())
      if (record.chunk >= chunks)
        throw std::runtime_error(reader.path() + " has chunk " + std::to_string(record.chunk) +
                                 " of a sweep that has " + std::to_string(chunks) + " chunks");
  }
  places_.resize(static_cast<std::size_t>(chunks));
  for (std::size_t r = 0; r < readers_.size(); ++r) {
    const std::span<const JournalReader::Record> records = readers_[r].records();
    for (std::size_t i = 0; i < records.size(); ++i) {
      Place& place = places_[static_cast<std::size_t>(records[i].chunk)];
      if (place.reader != none) continue;
      place = {static_cast<std::uint32_t>(r), static_cast<std::uint32_t>(i)};
      ++count_;
    }
  }
}

Bytes JournalSet::read(std::uint64_t chunk) const {
  const Place& place = places_[static_cast<std::size_t>(chunk)];
  if (place.reader == none)
    throw std::runtime_error("chunk " + std::to_string(chunk) + " is in no journal");
  const JournalReader& reader = readers_[place.reader];
  return reader.read(reader.records()[place.record]);
}

std::string JournalSet::arithmetics() const {
  constexpr std::string_view between = "; ";
  std::set<std::string> sets;
  for (const Place& place : places_) {
    if (place.reader == none) continue;
    // A shard has those of all journals that it was made of.
    std::string_view left = readers_[place.reader].header().arithmetic;
    for (std::size_t end = 0; end != left.npos;) {
      end = left.find(between);
      sets.emplace(left.substr(0, end));
      if (end != left.npos) left.remove_prefix(end + between.size());
    }
  }
  std::string list;
  for (const std::string& one : sets) list.append(list.empty() ? "" : between).append(one);
  return list;
}

}  // namespace tribo::sweep
