// SPDX-License-Identifier: Apache-2.0
#include "sweep/output_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <utility>

namespace tribo::sweep {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t start_size = 8192;

bool is_same(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

// Only these errors say that a file is not there. A server that does not answer gives others.
bool is_gone(int code) { return code == ENOENT || code == ENOTDIR; }

// EINVAL comes from a file system on which fsync() has nothing to do.
int sync_error(int file) { return ::fsync(file) == 0 || errno == EINVAL ? 0 : errno; }

// Why a file is not ours; empty if it is.
std::string why_not_ours(const struct stat& status) {
  if (S_ISLNK(status.st_mode)) return "is a symbolic link";
  if (S_ISDIR(status.st_mode)) return "is a directory";
  if (!S_ISREG(status.st_mode)) return "is no regular file";
  if (status.st_uid != ::geteuid()) return "is of another user, who may be writing now";
  if (status.st_nlink > 1) return "is a file that has another name too";
  return {};
}

bool carries(Mark mark, int file, const struct stat& status, const std::string& what) {
  if (status.st_size == 0) return true;
  std::array<std::byte, start_size> start;
  return mark(std::span(start).first(read_at(file, 0, start, what)));
}

// The first bytes of a lock's file that holds a note.
constexpr std::string_view lock_start = "tribocheck sweep lock 1\n";

bool is_lock(std::span<const std::byte> start) {
  const auto mark = std::as_bytes(std::span(lock_start));
  return start.size() >= mark.size() && std::equal(mark.begin(), mark.end(), start.begin());
}

// Makes a file in the target's folder: a later rename must stay within one file system.
FilePlace unused_place(const std::string& target, Descriptor& file) {
  for (int number = 0;; ++number) {
    FilePlace place(target, '.' + std::to_string(::getpid()) + '-' + std::to_string(number), ".");
    if (auto made = place.create()) {
      file = std::move(*made);
      return place;
    }
    if (number == 1000)
      throw std::runtime_error(place.path() + " and 1000 names before it are taken");
  }
}

}  // namespace

std::string FileIdentity::text() const {
  return std::to_string(inode) + ':' + std::to_string(size) + ':' + std::to_string(seconds) + ':' +
         std::to_string(nanoseconds);
}

FilePlace::FilePlace(const std::string& output, std::string_view ending, std::string_view beginning)
    : output_(output),
      path_(output + std::string(ending)),
      name_(std::string(beginning) + path_.substr(path_.rfind('/') + 1)),
      folder_(::open(folder_of(path_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (folder_ < 0) fail(errno);
  if (!beginning.empty()) path_ = path_.substr(0, path_.rfind('/') + 1) + name_;
}

void FilePlace::fail(int code) const {
  throw std::runtime_error("cannot write " + output_ + ": " + error_text(code));
}

std::optional<struct stat> FilePlace::status() const {
  struct stat status {};
  if (::fstatat(folder_, name_.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0) return status;
  if (errno != ENOENT) fail(errno);
  return std::nullopt;
}

std::optional<FileIdentity> FilePlace::identity() const {
  const auto found = status();
  if (!found) return std::nullopt;
  return FileIdentity{found->st_ino, static_cast<std::uint64_t>(found->st_size),
                      found->st_mtim.tv_sec, found->st_mtim.tv_nsec};
}

bool FilePlace::leads_to(int file) const {
  struct stat ours {
  }, named{};
  if (::fstat(file, &ours) != 0) return false;
  if (::fstatat(folder_, name_.c_str(), &named, AT_SYMLINK_NOFOLLOW) != 0) return !is_gone(errno);
  return is_same(ours, named);
}

bool FilePlace::is_folder_at_its_path() const {
  struct stat ours {
  }, named{};
  if (::fstat(folder_, &ours) != 0) return false;
  if (::stat(folder_of(path_).c_str(), &named) != 0) return !is_gone(errno);
  return is_same(ours, named);
}

std::optional<Descriptor> FilePlace::create() const {
  Descriptor file(
      ::openat(folder_, name_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (file >= 0) return file;
  if (errno != EEXIST) fail(errno);
  return std::nullopt;
}

std::optional<Descriptor> FilePlace::open_ours(Mark mark) const {
  for (;;) {
    const auto refuse = [this](const std::string& why) {
      throw RunRefused(path_ + ' ' + why +
                       ", and is left as it is; move it away, or give another output");
    };
    const auto found = status();
    if (!found) return std::nullopt;
    if (const std::string why = why_not_ours(*found); !why.empty()) refuse(why);
    Descriptor file(::openat(folder_, name_.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (file < 0 && errno == ENOENT) continue;
    if (file < 0) fail(errno);
    struct stat opened {};
    if (::fstat(file, &opened) != 0) fail(errno);
    if (opened.st_nlink == 0) continue;  // it was removed meanwhile
    if (const std::string why = why_not_ours(opened); !why.empty()) refuse(why);
    if (!carries(mark, file, opened, "cannot read " + path_))
      refuse("is no file that tribocheck has left");
    return file;
  }
}

void FilePlace::remove_ours(Mark mark) const {
  const auto file = open_ours(mark);
  if (file && ::unlinkat(folder_, name_.c_str(), 0) != 0 && errno != ENOENT) fail(errno);
}

void FilePlace::remove() const noexcept { ::unlinkat(folder_, name_.c_str(), 0); }

void FilePlace::rename_to(const FilePlace& target, int file, const Replaceable& replaceable) const {
  const auto there = target.status();
  if (replaceable.any && there && !S_ISREG(there->st_mode) && !S_ISLNK(there->st_mode))
    throw std::runtime_error(target.path_ +
                             (S_ISDIR(there->st_mode) ? " is a directory" : " is no regular file") +
                             ", and is left as it is");
  const auto taken = [&] {
    throw std::runtime_error(target.path_ +
                             " was put there by another process meanwhile, and is not replaced");
  };
  if (!replaceable.any && there && target.identity() != replaceable.only) taken();
  if (!leads_to(file)) throw std::runtime_error(path_ + " was replaced by another process");
  const unsigned flags = replaceable.any || there ? 0 : RENAME_NOREPLACE;
  const char* const from = name_.c_str();
  const char* const to = target.name_.c_str();
  int code = ::renameat2(folder_, from, target.folder_, to, flags) == 0 ? 0 : errno;
  if (code == EINVAL || code == ENOSYS)  // a file system or kernel without RENAME_NOREPLACE
    code = ::renameat(folder_, from, target.folder_, to) == 0 ? 0 : errno;
  if (code == EEXIST) taken();
  if (code != 0) throw std::runtime_error(error_text(code));
  if (!target.leads_to(file))
    throw std::runtime_error(target.path_ + " was replaced by another process");
  // The new name outlasts a power failure only if the folder, too, is written to the disk.
  if (const int failed = sync_error(target.folder_)) throw std::runtime_error(error_text(failed));
}

PartFile::PartFile(const std::string& target, Mark mark)
    : target_(target), place_(target, ".part") {
  place_.remove_ours(mark);
  auto made = place_.create();
  if (!made) throw std::runtime_error(place_.path() + " was put there by another process");
  file_ = std::move(*made);
}

PartFile::PartFile(const std::string& target)
    : target_(target), place_(unused_place(target, file_)) {}

PartFile::~PartFile() {
  if (!is_kept_ && place_.leads_to(file_)) place_.remove();
}

void PartFile::write(std::string_view content) const { write_all(file_, content); }

void PartFile::keep(const Replaceable& replaceable) {
  if (const int code = sync_error(file_)) throw std::runtime_error(error_text(code));
  place_.rename_to(target_, file_, replaceable);
  is_kept_ = true;
}

void check_place(const std::string& target, Mark mark) {
  static_cast<void>(FilePlace(target, ".part").open_ours(mark));
  const FilePlace place(target);
  const auto there = place.status();
  struct stat folder {};
  if (::fstat(place.folder_, &folder) != 0) place.fail(errno);
  const uid_t user = ::geteuid();
  const bool is_bound = (folder.st_mode & S_ISVTX) != 0 && user != 0 && folder.st_uid != user;
  if (there && is_bound && there->st_uid != user)
    throw RunRefused(target + " is of another user, and its folder lets nobody else replace it; " +
                     "allowed: another output");
}

// A process that holds the lock removes the lock's file before it releases the lock. A process that
// then locks this file without a name excludes nobody, and begins again.
OutputLock::OutputLock(const std::string& output, std::string_view ending)
    : output_(output), place_(output, ending) {
  do {
    std::optional<Descriptor> file = place_.open_ours(is_lock);
    if (!file && (file = place_.create())) check_owner(*file);
    if (!file) continue;
    locking_ = lock_file(*file, place_.path());
    if (locking_ == Locking::taken_by_another) return;
    file_ = std::move(*file);
  } while (!leads_to_it());
}

// Refuses a file system that gives all files to another user: no kept file could be used again.
void OutputLock::check_owner(int made) const {
  struct stat status {};
  if (::fstat(made, &status) != 0 || status.st_uid == ::geteuid()) return;
  place_.remove();
  throw RunRefused("files that this user makes in the folder of " + output_ +
                   " belong to another user, so that nothing can be kept there; allowed: an output "
                   "in another folder");
}

void OutputLock::note(std::span<const std::byte> bytes) const {
  const auto mark = std::as_bytes(std::span(lock_start));
  Bytes content(mark.begin(), mark.end());
  content.insert(content.end(), bytes.begin(), bytes.end());
  const bool is_empty = ::ftruncate(file_, 0) == 0;
  const ssize_t written = is_empty ? ::pwrite(file_, content.data(), content.size(), 0) : -1;
  if (written != static_cast<ssize_t>(content.size()))
    throw std::runtime_error("cannot write " + place_.path() + ": " +
                             error_text(written < 0 ? errno : ENOSPC));
}

Bytes OutputLock::noted(const std::string& output) {
  const FilePlace place(output, ".lock");
  const auto file = place.open_ours(is_lock);
  Bytes bytes(start_size);
  if (file) bytes.resize(read_at(*file, 0, bytes, "cannot read " + place.path()));
  if (!file || bytes.size() < lock_start.size()) return {};
  bytes.erase(bytes.begin(), bytes.begin() + lock_start.size());
  return bytes;
}

OutputLock::OutputLock(const std::string& output) : OutputLock(output, ".lock") {
  if (locking_ == Locking::taken_by_another)
    throw RunRefused(output + " is being written by another process, which holds " + place_.path() +
                     "; wait until it has ended, or give another output");
}

std::optional<OutputLock> OutputLock::take(const std::string& output, std::string_view ending) {
  OutputLock lock(output, ending);
  if (lock.locking_ == Locking::taken_by_another) return std::nullopt;
  return lock;
}

OutputLock::~OutputLock() {
  if (place_.leads_to(file_)) place_.remove();
}

bool OutputLock::leads_to_it() const {
  return locking_ == Locking::without_locks || place_.leads_to(file_);
}

void OutputLock::check() const {
  if (!place_.is_folder_at_its_path())
    throw std::runtime_error("the folder of " + output_ +
                             " was removed or moved while this process computed; nothing can be "
                             "written there, and what was removed has to be computed anew");
  if (!leads_to_it())
    throw std::runtime_error(place_.path() + " was removed while this process held it, so that " +
                             "another one may write the same output; nothing is put in its place");
}

std::string output_behind_links(const std::string& path) {
  fs::path behind(path);
  constexpr int most_links = 40;  // as many as Linux follows
  std::error_code none;
  for (int links = 0; fs::is_symlink(behind, none); ++links) {
    if (links == most_links) throw RunRefused(path + " is a symbolic link that leads in a circle");
    struct stat link {};
    const bool is_known = ::lstat(behind.c_str(), &link) == 0;
    if (is_known && link.st_uid != ::geteuid() && link.st_uid != 0)
      throw RunRefused(behind.string() +
                       " is a symbolic link of another user, and is not followed; allowed: the "
                       "file itself");
    behind = behind.parent_path() / fs::read_symlink(behind, none);
  }
  if (fs::exists(behind, none) && !fs::is_regular_file(behind, none))
    throw RunRefused(path + " is " +
                     (fs::is_directory(behind, none) ? "a directory" : "no regular file") +
                     "; allowed: a file, or none yet");
  return behind.string();
}

}  // namespace tribo::sweep
