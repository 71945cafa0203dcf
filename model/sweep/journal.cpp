// SPDX-License-Identifier: Apache-2.0
#include "sweep/journal.hpp"

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <stdexcept>
#include <utility>

#include "sweep/journal_record.hpp"
#include "sweep/output_file.hpp"

namespace tribo::sweep {
namespace {

using journal_record::Head;
using journal_record::header_number;

constexpr std::chrono::seconds between_syncs{5};

[[noreturn]] void fail(const std::string& what, int code) {
  throw std::runtime_error(what + ": " + error_text(code));
}

Bytes to_bytes(const JournalHeader& header) {
  Bytes bytes;
  put_text(bytes, header.version);
  put_text(bytes, header.digest);
  put_text(bytes, header.arithmetic);
  put(bytes, static_cast<std::uint64_t>(header.files.size()));
  for (const auto& [name, text] : header.files) {
    put_text(bytes, name);
    put_text(bytes, text);
  }
  put_text(bytes, header.replaces);
  return bytes;
}

void lock_or_throw(int descriptor, const std::string& path) {
  if (!lock_file(descriptor, path))
    throw std::runtime_error(path + " is being written by another process");
}

// Writes all of two pieces; the error's number, 0: none.
int write_all(int descriptor, std::uint64_t offset, std::span<const std::byte> first,
              std::span<const std::byte> second) {
  while (!first.empty() || !second.empty()) {
    // writev() only reads from what it is given, but its type does not say so.
    const std::array<iovec, 2> pieces{{{const_cast<std::byte*>(first.data()), first.size()},
                                       {const_cast<std::byte*>(second.data()), second.size()}}};
    const ssize_t written = ::pwritev(descriptor, pieces.data(), 2, static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    if (written == 0) return ENOSPC;
    const auto count = static_cast<std::size_t>(written);
    offset += count;
    const std::size_t of_first = std::min(count, first.size());
    first = first.subspan(of_first);
    second = second.subspan(count - of_first);
  }
  return 0;
}

}  // namespace

Journal::Journal(Descriptor file, std::string path)
    : file_(std::move(file)), path_(std::move(path)) {}

// Under another name until its header is whole: a process killed on the way leaves no journal that
// is none.
Journal Journal::create(const std::string& path, const JournalHeader& header) {
  const FilePlace place(path), unfinished(path, ".new");
  if (place.status()) fail("cannot create " + path, EEXIST);
  unfinished.remove_ours(is_start_of_journal);
  auto file = unfinished.create();
  if (!file) fail("cannot create " + path, EEXIST);
  try {
    Journal journal = begin(std::move(*file), path, header);
    unfinished.rename_to(place, journal.file_, {});
    return journal;
  } catch (...) {
    unfinished.remove();
    throw;
  }
}

Journal Journal::begin(Descriptor file, const std::string& path, const JournalHeader& header) {
  Journal journal(std::move(file), path);
  lock_or_throw(journal.file_, path);
  const Bytes bytes = to_bytes(header);
  const Head head{header_number, bytes.size(), 0};
  for (int copy = 0; copy < 2; ++copy) journal.write_record(header_number, bytes);
  journal.seed_ = journal_record::checksum(head, bytes, 0);
  journal.sync();
  return journal;
}

Journal Journal::resume(const std::string& path) {
  auto file = FilePlace(path).open_ours(any_mark);
  if (!file) fail("cannot open " + path, ENOENT);
  Journal journal(std::move(*file), path);
  lock_or_throw(journal.file_, path);
  const journal_record::Found found = journal_record::find_records(journal.file_, path);
  journal.seed_ = found.seed;
  journal.end_ = found.end;
  if (::ftruncate(journal.file_, static_cast<off_t>(found.end)) != 0)
    fail("cannot write " + path, errno);
  return journal;
}

void Journal::append(std::uint64_t chunk, std::span<const std::byte> bytes) {
  bool is_due = false;
  {
    const std::lock_guard guard(*mutex_);
    write_record(chunk, bytes);
    const auto now = std::chrono::steady_clock::now();
    is_due = now - synced_ >= between_syncs;
    if (is_due) synced_ = now;
  }
  if (is_due) sync();  // the other threads go on writing meanwhile
}

void Journal::sync() {
  while (::fdatasync(file_) != 0)
    if (errno != EINTR) fail("cannot write " + path_ + " to the disk", errno);
}

bool Journal::is_there() const {
  struct stat ours {
  }, named{};
  if (::fstat(file_, &ours) != 0 || ::lstat(path_.c_str(), &named) != 0)
    return errno != ENOENT && errno != ENOTDIR;
  return ours.st_dev == named.st_dev && ours.st_ino == named.st_ino;
}

void Journal::write_record(std::uint64_t number, std::span<const std::byte> bytes) {
  Head head{number, bytes.size(), 0};
  head.checksum = journal_record::checksum(head, bytes, seed_);
  const journal_record::HeadBytes head_bytes = journal_record::to_bytes(head);
  if (const int code = write_all(file_, end_, head_bytes, bytes)) {
    // If this fails too, a reader knows that what is there is no record, and the next one is
    // written over it.
    [[maybe_unused]] const int ignored = ::ftruncate(file_, static_cast<off_t>(end_));
    fail("cannot write " + path_, code);
  }
  end_ += head_bytes.size() + bytes.size();
}

}  // namespace tribo::sweep
