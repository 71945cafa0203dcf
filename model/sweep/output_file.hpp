// SPDX-License-Identifier: Apache-2.0
// The one way in which the program makes, claims, replaces and removes files. A file is opened
// within its folder, which is held open; no symbolic link at its name is followed; and a file is
// taken up or removed only if it is ours: a regular file of this user without a second name, which
// is empty or carries our mark.
#pragma once

#include <sys/stat.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "sweep/bytes.hpp"
#include "sweep/disk.hpp"

namespace tribo::sweep {

// Files that are there do not fit the request: bad usage, not a failure.
struct RunRefused : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

// Do the first bytes of a file that is not empty, up to 8 kB of them, carry our mark?
using Mark = bool (*)(std::span<const std::byte> start);
inline bool any_mark(std::span<const std::byte>) { return true; }

// Tells a file and its state from others; stays the same when the machine starts anew.
struct FileIdentity {
  std::uint64_t inode = 0, size = 0;
  std::int64_t seconds = 0, nanoseconds = 0;  // of its last change

  std::string text() const;
  friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};

// The files that a file may replace when it takes its name: no file, one certain file, or any file.
struct Replaceable {
  bool any = false;
  std::optional<FileIdentity> only;
};

// A name in a folder that is held open: whatever the folder's path leads to later, what is done
// here is done in that folder. All errors are thrown as std::runtime_error with a text that names
// the file.
class FilePlace {
 public:
  // Opens the folder of the file OUTPUT + ENDING, which need not be there. `beginning` is put in
  // front of the file's name.
  explicit FilePlace(const std::string& output, std::string_view ending = "",
                     std::string_view beginning = "");

  const std::string& path() const { return path_; }
  // The status of the file of that name, a symbolic link not followed; nullopt: there is no file.
  std::optional<struct stat> status() const;
  std::optional<FileIdentity> identity() const;
  bool leads_to(int file) const;
  bool is_folder_at_its_path() const;

  // Makes a new file; nothing where there is one already.
  std::optional<Descriptor> create() const;
  // Opens our file for reading and writing; nothing where there is none. Throws RunRefused where
  // something else is there.
  std::optional<Descriptor> open_ours(Mark mark) const;
  // Removes our file, if there is one. Throws RunRefused where something else is there.
  void remove_ours(Mark mark) const;
  void remove() const noexcept;

  // Gives the open file, which this name leads to, the name `target` in the same folder, and sees
  // to it that this name is on the disk. Throws where the target is there and may not be replaced,
  // and where another process has put another file at one of these names.
  void rename_to(const FilePlace& target, int file, const Replaceable& replaceable) const;

 private:
  friend void check_place(const std::string& target, Mark mark);
  [[noreturn]] void fail(int code) const;

  std::string output_, path_, name_;
  Descriptor folder_;
};

// A file that is written beside its target and takes its name when it is whole. One that is not
// kept is removed.
class PartFile {
 public:
  // Writes at TARGET.part. A file that a killed process left there, known by its mark, is taken up.
  PartFile(const std::string& target, Mark mark);
  // Writes at a name that no other process uses.
  explicit PartFile(const std::string& target);
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile();

  int file() const { return file_; }
  // A path by which a library or a child process opens this very file, whatever its name leads to.
  std::string open_path() const { return open_path_of(file_); }
  const std::string& path() const { return place_.path(); }
  void write(std::string_view content) const;
  void keep(const Replaceable& replaceable);
  // The file itself, open, once it is kept.
  Descriptor release() { return std::move(file_); }

 private:
  FilePlace target_;
  Descriptor file_;
  FilePlace place_;
  bool is_kept_ = false;
};

// Throws RunRefused where something that is not ours stands where PartFile(target, mark) writes, or
// where the target is of another user, and its folder (sticky) lets nobody else replace it.
void check_place(const std::string& target, Mark mark);

// --- Locks that end with the process that holds them. One process at a time owns an output: it
// looks at what is there, and gives the result its name under the lock OUTPUT.lock. A part that is
// computed is claimed by a lock of its own (parts_in_hand.hpp).

// A lock (flock) on a small file of its own. Its owner may note in the file what it works on. The
// file is there only while a process holds the lock, after such a process was killed, or where it
// was left for its note. On a file system that has no locks each process gets the lock.
class OutputLock {
 public:
  // Throws RunRefused where another process has OUTPUT.lock, where that is a file that is not ours,
  // or where files that are made there belong to another user; std::runtime_error where it cannot
  // be made.
  explicit OutputLock(const std::string& output);
  // The lock OUTPUT + ENDING; nothing where another process has it. Throws as the constructor does.
  static std::optional<OutputLock> take(const std::string& output, std::string_view ending);
  OutputLock(OutputLock&&) = default;
  OutputLock& operator=(OutputLock&&) = default;
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;
  ~OutputLock();

  // False on a file system without locks.
  bool is_exclusive() const { return locking_ == Locking::locked; }
  // Replaces the note by some bytes. Throws std::runtime_error where that fails.
  void note(std::span<const std::byte> bytes) const;
  // The note in OUTPUT.lock, of the process that holds it or was killed; empty where there is none.
  static Bytes noted(const std::string& output);
  // Leaves the file there with its note, as if this process were killed.
  void leave() { file_ = Descriptor(); }

  // False if somebody has removed the lock's file or its folder: another process may have the lock
  // by now.
  bool holds() const { return leads_to_it() && place_.is_folder_at_its_path(); }
  // Throws std::runtime_error, with a text that says why, if it does not hold.
  void check() const;

 private:
  OutputLock(const std::string& output, std::string_view ending);
  void check_owner(int made) const;
  // Without locks, any process that ends removes the file.
  bool leads_to_it() const;

  std::string output_;
  Locking locking_ = Locking::locked;
  FilePlace place_;
  Descriptor file_;
};

// The file that a path leads to, behind symbolic links; this file need not be there yet. Throws
// RunRefused where it is there and is no regular file, and where a link is of another user, who
// would choose which file is replaced.
std::string output_behind_links(const std::string& path);

}  // namespace tribo::sweep
