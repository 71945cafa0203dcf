// SPDX-License-Identifier: Apache-2.0
// All functions by which the program makes, claims, replaces and removes files. The folder of a
// file is held open, and a symbolic link at the file's name is not followed. A file is reused or
// removed only if it is ours: a regular file of this user with a single name, which is empty or
// carries our mark.
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

// The request does not fit the files or the machine that it meets: bad usage, not a failure.
struct RunRefused : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

// Tells whether a file carries our mark, by its first bytes: at least one, and at most 8192.
using Mark = bool (*)(std::span<const std::byte> start);
inline bool any_mark(std::span<const std::byte>) { return true; }

// Identifies a file and its state. It stays the same after a restart of the machine.
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

// A name in a folder that is held open. All functions act in this folder, even if its path leads to
// another folder later. They throw the system's errors as std::runtime_error with a text that names
// the file.
class FilePlace {
 public:
  // Opens the folder of the file OUTPUT + ENDING; the file need not exist. `beginning` is put in
  // front of the file's name.
  explicit FilePlace(const std::string& output, std::string_view ending = "",
                     std::string_view beginning = "");

  const std::string& path() const { return path_; }
  // The status of the file of that name, or of a symbolic link itself; nullopt: there is no file.
  std::optional<struct stat> status() const;
  std::optional<FileIdentity> identity() const;
  bool leads_to(int file) const;
  bool is_folder_at_its_path() const;

  // Makes a new file; nullopt: the name is taken.
  std::optional<Descriptor> create() const;
  // Opens our file for reading and writing; nullopt: there is none. Throws RunRefused where
  // something else is there.
  std::optional<Descriptor> open_ours(Mark mark) const;
  // Removes our file, if there is one. Throws RunRefused where something else is there.
  void remove_ours(Mark mark) const;
  void remove() const noexcept;

  // Renames the file of this name, which is open as `file`, to `target` in the same folder, and
  // writes the folder to the disk. Throws where an existing target may not be replaced, or where
  // another process has put another file at one of the two names.
  void rename_to(const FilePlace& target, int file, const Replaceable& replaceable) const;

 private:
  friend void check_place(const std::string& target, Mark mark);
  [[noreturn]] void fail(int code) const;

  std::string output_, path_, name_;
  Descriptor folder_;
};

// A file that is written beside its target. keep() renames it to the target. The destructor removes
// a file that was not kept.
class PartFile {
 public:
  // Writes at TARGET.part. A file with this mark that a killed process left there is removed first.
  PartFile(const std::string& target, Mark mark);
  // Writes at a name that no other process uses.
  explicit PartFile(const std::string& target);
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile();

  int file() const { return file_; }
  // A path by which a library or a child process opens this file, even if its name leads elsewhere.
  std::string open_path() const { return open_path_of(file_); }
  const std::string& path() const { return place_.path(); }
  void write(std::string_view content) const;
  void keep(const Replaceable& replaceable);
  // Gives the open file away. To be called after keep().
  Descriptor release() { return std::move(file_); }

 private:
  FilePlace target_;
  Descriptor file_;
  FilePlace place_;
  bool is_kept_ = false;
};

// Throws RunRefused where PartFile(target, mark) would find a file that is not ours, or where only
// another user may replace the target (a file of that user in a sticky folder).
void check_place(const std::string& target, Mark mark);

// --- Locks that end with the process that holds them. The process that holds OUTPUT.lock owns the
// output: it alone checks the files that are there, and gives the result its name. A process claims
// each part that it computes by a lock of that part (parts_in_hand.hpp).

// A lock (flock) on a small file of its own. Its owner may note in the file what it works on. The
// file is there only while a process holds the lock, after such a process was killed, or after
// leave(). On a file system that has no locks each process gets the lock.
class OutputLock {
 public:
  // Throws RunRefused where another process has OUTPUT.lock, where that file is not ours, or where
  // new files in its folder are another user's; std::runtime_error where it cannot be made.
  explicit OutputLock(const std::string& output);
  // Takes the lock OUTPUT + ENDING; nullopt: another process has it. Throws like the constructor.
  static std::optional<OutputLock> take(const std::string& output, std::string_view ending);
  OutputLock(OutputLock&&) = default;
  OutputLock& operator=(OutputLock&&) = default;
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;
  ~OutputLock();

  // False on a file system without locks.
  bool is_exclusive() const { return locking_ == Locking::locked; }
  // Replaces the note by `bytes`. Throws std::runtime_error where that fails.
  void note(std::span<const std::byte> bytes) const;
  // The note in OUTPUT.lock by its owner, which may have been killed; empty where there is none.
  static Bytes noted(const std::string& output);
  // Releases the lock, but leaves its file with the note, as if this process were killed.
  void leave() { file_ = Descriptor(); }

  // False if somebody has removed the lock's file or its folder: another process may then have the
  // lock.
  bool holds() const { return leads_to_it() && place_.is_folder_at_its_path(); }
  // Throws std::runtime_error, with a text that says why, where holds() is false.
  void check() const;

 private:
  OutputLock(const std::string& output, std::string_view ending);
  void check_owner(int made) const;
  // True on a file system without locks, where any process that ends removes the file.
  bool leads_to_it() const;

  std::string output_;
  Locking locking_ = Locking::locked;
  FilePlace place_;
  Descriptor file_;
};

// The path of the file to which `path` leads through symbolic links; the file need not exist yet.
// Throws RunRefused where it exists and is no regular file, where links lead in a circle, or where
// a link is another user's (not root's), who could choose which file is replaced.
std::string output_behind_links(const std::string& path);

}  // namespace tribo::sweep
