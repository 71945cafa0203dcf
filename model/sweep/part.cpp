// SPDX-License-Identifier: Apache-2.0
#include "sweep/part.hpp"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>
#include <set>
#include <stdexcept>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "sweep/apart.hpp"
#include "sweep/hdf5_handles.hpp"
#include "tribo/batch.hpp"

namespace tribo::sweep {
namespace {

using hdf5::checked;
using hdf5::Handle;
using hdf5::write_attribute;

constexpr std::string_view part_format = "tribocheck sweep part 1";

std::uint64_t checksum_of(std::span<const std::byte> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

// --- Writing.

constexpr std::size_t index_width = 3;  // number, end, checksum

Handle make_array(hid_t file, const std::string& name, hid_t type, std::span<const hsize_t> extents,
                  Handle& space) {
  space = Handle(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr));
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE));
  checked(H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER));
  return hdf5::make_dataset(file, name, type, space, creation);
}

void write_header(hid_t file, const PartHeader& header) {
  write_attribute(file, "format", part_format);
  write_attribute(file, "tribocheck_version", header.version);
  write_attribute(file, "numbers", header.numbers);
  write_attribute(file, "digest", header.digest);
  write_attribute(file, "arithmetic", header.arithmetic);
  write_attribute(file, "replaces", header.replaces);
  std::vector<std::string> names, texts;
  for (const auto& [name, text] : header.files) {
    names.push_back(name);
    texts.push_back(text);
  }
  write_attribute(file, "file_names", names);
  write_attribute(file, "file_texts", texts);
}

void write_chunks(hid_t file, const PartContent& content) {
  const hsize_t size = content.bytes;
  Handle space;
  const Handle chunks = make_array(file, "chunks", H5T_STD_U8LE, std::span(&size, 1), space);
  std::vector<std::uint64_t> index;
  hsize_t end = 0;
  for (const std::uint64_t chunk : content.chunks) {
    const Bytes bytes = content.read(chunk);
    const hsize_t start = end, count = bytes.size();
    end += count;
    if (end > size) throw std::runtime_error("chunks are longer than they were");
    index.insert(index.end(), {chunk, end, checksum_of(bytes)});
    if (bytes.empty()) continue;
    checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, &start, nullptr, &count, nullptr));
    const Handle memory(H5Screate_simple(1, &count, nullptr));
    checked(H5Dwrite(chunks, H5T_NATIVE_UINT8, memory, space, H5P_DEFAULT, bytes.data()));
  }
  const std::array<hsize_t, 2> extents{content.chunks.size(), index_width};
  const Handle table = make_array(file, "index", H5T_STD_U64LE, extents, space);
  checked(H5Dwrite(table, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, index.data()));
}

void write_part_content(const std::string& path, const PartHeader& header,
                        const PartContent& content) {
  static std::mutex one_at_a_time;  // HDF5 is not made for several threads
  const std::lock_guard lock(one_at_a_time);
  const hdf5::QuietErrors quiet;
  Handle file = hdf5::create_file(path);
  write_header(file, header);
  checked(H5Fflush(file, H5F_SCOPE_GLOBAL));  // the file now has our mark: is_start_of_part()
  write_chunks(file, content);
  checked(H5Fflush(file, H5F_SCOPE_GLOBAL));
  file.close();
  if (const auto failed = hdf5::take_failed_close()) throw hdf5::Error(*failed);
}

// --- Reading.

// An array that lies in one piece in the file, as write_chunks() makes it: extents and place.
struct Array {
  std::vector<hsize_t> extents;
  std::uint64_t offset = 0;
};
Array array_in(hid_t file, const char* name, std::size_t dimensions, std::size_t element_size) {
  H5L_info_t link;
  checked(H5Lget_info(file, name, &link, H5P_DEFAULT));
  if (link.type != H5L_TYPE_HARD) throw hdf5::Error(std::string(name) + " is a link");
  const Handle dataset(H5Dopen2(file, name, H5P_DEFAULT));
  const Handle creation(H5Dget_create_plist(dataset)), space(H5Dget_space(dataset));
  const Handle type(H5Dget_type(dataset));
  const bool is_ours = H5Pget_layout(creation) == H5D_CONTIGUOUS &&
                       H5Pget_external_count(creation) == 0 &&
                       H5Sget_simple_extent_type(space) == H5S_SIMPLE &&
                       H5Sget_simple_extent_ndims(space) == static_cast<int>(dimensions) &&
                       H5Tget_size(type) == element_size;
  if (!is_ours) throw hdf5::Error(std::string(name) + " is not stored as tribocheck stores it");
  Array array{std::vector<hsize_t>(dimensions), 0};
  checked(H5Sget_simple_extent_dims(space, array.extents.data(), nullptr));
  const haddr_t offset = H5Dget_offset(dataset);
  if (offset != HADDR_UNDEF) array.offset = offset;
  return array;
}

// The header, the sizes of both arrays and their places in the file, as bytes.
Bytes read_head(const std::string& path) {
  const hdf5::QuietErrors quiet;
  const Handle file = hdf5::open_file(path);
  if (hdf5::read_text(file, "format") != part_format) throw hdf5::Error("it is of another format");
  PartHeader header{hdf5::read_text(file, "tribocheck_version"),
                    hdf5::read_count(file, "numbers"),
                    hdf5::read_text(file, "digest"),
                    hdf5::read_text(file, "arithmetic"),
                    {},
                    hdf5::read_text(file, "replaces")};
  const std::vector<std::string> names = hdf5::read_texts(file, "file_names");
  const std::vector<std::string> texts = hdf5::read_texts(file, "file_texts");
  if (names.size() != texts.size()) throw hdf5::Error("its files have not each a name");
  for (std::size_t i = 0; i < names.size(); ++i) header.files.emplace_back(names[i], texts[i]);
  const Array chunks = array_in(file, "chunks", 1, 1), index = array_in(file, "index", 2, 8);
  if (index.extents[1] != index_width) throw hdf5::Error("its index has another width");
  Bytes head;
  Sender{head}(header, std::uint64_t{chunks.extents[0]}, chunks.offset,
               std::uint64_t{index.extents[0]}, index.offset);
  return head;
}

// Throws std::runtime_error where chunks do not ascend, or do not fill exactly `size` bytes.
std::vector<Part::Record> records_of(std::span<const std::uint64_t> index, std::uint64_t offset,
                                     std::uint64_t size) {
  std::vector<Part::Record> records;
  std::uint64_t end = 0;
  for (std::size_t i = 0; i < index.size(); i += index_width) {
    const bool ascends = records.empty() || records.back().chunk < index[i];
    if (!ascends || index[i + 1] < end || index[i + 1] > size)
      throw std::runtime_error("its index is damaged");
    records.push_back({index[i], offset + end, index[i + 1] - end, index[i + 2]});
    end = index[i + 1];
  }
  if (end != size) throw std::runtime_error("its index is damaged");
  return records;
}

// Reads bytes of an open file of `file_size` bytes.
Bytes bytes_at(int file, std::uint64_t offset, std::uint64_t size, std::uint64_t file_size) {
  if (size > file_size || offset > file_size - size)
    throw std::runtime_error("its index is damaged");
  Bytes bytes(static_cast<std::size_t>(size));
  bytes.resize(read_at(file, offset, bytes, "cannot read it"));
  return bytes;
}

// Is it a journal, the file in which older versions of tribocheck kept chunks?
bool is_journal(int file, const std::string& path) {
  constexpr std::array<unsigned char, 8> mark{0x93, 'T', 'B', 'S', 'J', '1', '\r', '\n'};
  std::array<std::byte, 8> start{};
  read_at(file, 0, start, "cannot read " + path);
  return std::memcmp(start.data(), mark.data(), mark.size()) == 0;
}

std::string cannot_read(const std::string& path) { return "cannot read " + path; }

}  // namespace

PartHeader header_of(const SweepPlan& plan) {
  PartHeader header{plan.version, numbers_version, plan.digest, std::string(arithmetic()), {}};
  for (const SceneSweep& scene : plan.scenes) header.files.emplace_back(scene.file, scene.text);
  return header;
}

bool is_start_of_part(std::span<const std::byte> start) {
  return hdf5::is_start_of(start, part_format);
}

PartContent content_of(const ChunksInMemory& chunks) {
  PartContent content;
  for (const auto& [chunk, bytes] : chunks) {
    content.chunks.push_back(chunk);
    content.bytes += bytes.size();
  }
  content.read = [&chunks](std::uint64_t chunk) { return chunks.at(chunk); };
  return content;
}

void write_part(const std::string& path, PartFile& file, const PartHeader& header,
                const PartContent& content, const Replaceable& replaceable) {
  try {
    write_part_content(file.open_path(), header, content);
    seal(file.file());
    file.keep(replaceable);
  } catch (const Stopped&) {
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error("cannot write " + path + ": " + error.what());
  }
}

Part::Part(const std::string& path, const std::function<bool()>& stopped) : path_(path) {
  const Descriptor file = open_file(path, O_RDONLY, cannot_read(path));
  if (is_journal(file, path))
    throw std::runtime_error(path +
                             " is a shard or journal of an older tribocheck, and this one "
                             "does not read it; allowed: shards of this one");
  if (const std::string why = broken_seal(file, path, "part", stopped); !why.empty())
    throw std::runtime_error(path + ' ' + why);
  try {
    const std::uint64_t size = sweep::size_of(file, "cannot read it");
    const Bytes head = apart(size, [&] { return read_head(open_path_of(file)); });
    std::uint64_t chunks_size = 0, chunks_offset = 0, count = 0, index_offset = 0;
    Receiver{head}(header_, chunks_size, chunks_offset, count, index_offset);
    if (count > size) throw std::runtime_error("its index is damaged");
    const Bytes bytes = bytes_at(file, index_offset, 8 * index_width * count, size);
    std::vector<std::uint64_t> index(bytes.size() / 8);
    if (!index.empty()) std::memcpy(index.data(), bytes.data(), bytes.size());
    if (chunks_size > size || chunks_offset > size - chunks_size)
      throw std::runtime_error("it ends before its last chunk");
    records_ = records_of(index, chunks_offset, chunks_size);
  } catch (const std::system_error&) {  // such an error says nothing about the file
    throw;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + " is no part of a sweep: " + error.what());
  }
}

Part::Part(PartHeader header, ChunksInMemory chunks)
    : header_(std::move(header)), in_memory_(std::move(chunks)) {
  for (const auto& [chunk, bytes] : in_memory_) records_.push_back({chunk, 0, bytes.size(), 0});
}

Bytes Part::read(const Record& record) const {
  if (path_.empty()) return in_memory_.at(record.chunk);
  const Descriptor file = open_file(path_, O_RDONLY, cannot_read(path_));
  Bytes bytes(static_cast<std::size_t>(record.size));
  const bool is_there = read_at(file, record.offset, bytes, cannot_read(path_)) == bytes.size();
  if (!is_there || checksum_of(bytes) != record.checksum)
    throw std::runtime_error(path_ + " has changed since it was looked at: chunk " +
                             std::to_string(record.chunk) + " is damaged");
  return bytes;
}

PartSet::PartSet(std::vector<Part> parts, std::uint64_t chunks, bool mixed_fma)
    : parts_(std::move(parts)), places_(static_cast<std::size_t>(chunks)) {
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const Part& part = parts_[p];
    const Part& first = parts_.front();
    const PartHeader &header = part.header(), &ours = first.header();
    if (header.numbers != ours.numbers)
      throw std::runtime_error(part.path() + " was computed by tribocheck " + header.version +
                               ", " + first.path() + " by " + ours.version +
                               ", and their numbers differ");
    if (header.digest != ours.digest)
      throw std::runtime_error(part.path() + " is of another sweep than " + first.path() +
                               " (digest " + header.digest + ", not " + ours.digest + ")");
    if (!mixed_fma && header.arithmetic != ours.arithmetic)
      throw std::runtime_error(part.path() + " was computed with " + header.arithmetic + ", " +
                               first.path() + " with " + ours.arithmetic);
    for (std::size_t i = 0; i < part.records().size(); ++i) {
      const std::uint64_t chunk = part.records()[i].chunk;
      if (chunk >= chunks)
        throw std::runtime_error(part.path() + " has chunk " + std::to_string(chunk) +
                                 " of a sweep that has " + std::to_string(chunks) + " chunks");
      Place& place = places_[static_cast<std::size_t>(chunk)];
      if (place.part != none) continue;
      place = {static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(i)};
      ++count_;
    }
  }
}

const Part::Record& PartSet::record(std::uint64_t chunk) const {
  const Place& place = places_[static_cast<std::size_t>(chunk)];
  if (place.part == none)
    throw std::runtime_error("chunk " + std::to_string(chunk) + " is in no part");
  return parts_[place.part].records()[place.record];
}

Bytes PartSet::read(std::uint64_t chunk) const {
  const Part::Record& found = record(chunk);
  return parts_[places_[static_cast<std::size_t>(chunk)].part].read(found);
}

std::string PartSet::arithmetics() const {
  constexpr std::string_view between = "; ";
  std::set<std::string> sets;
  for (const Place& place : places_) {
    if (place.part == none) continue;
    // The header of a shard has the arithmetics of all parts that it was made of.
    std::string_view left = parts_[place.part].header().arithmetic;
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
