// SPDX-License-Identifier: Apache-2.0
#include "page/pending_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "protocol/output_stream.hpp"

namespace tribo::report {
namespace {

// In the same folder, so that the rename stays within one file system; with the process in its
// name, so that two reports at once do not write into each other's.
std::filesystem::path temporary_name(const std::filesystem::path& target) {
  return target.parent_path() / fmt::format(".{}.{}", target.filename().string(), ::getpid());
}

protocol::OutputFailed cannot_write(const std::filesystem::path& path, int code) {
  return protocol::OutputFailed(
      fmt::format("cannot write {}: {}", path.string(), std::generic_category().message(code)));
}

bool write_all(const std::filesystem::path& path, std::string_view content) {
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  const bool written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  const int code = errno;
  const bool closed = std::fclose(file) == 0;
  if (!written) errno = code;
  return written && closed;
}

}  // namespace

PendingFile::PendingFile(std::filesystem::path target)
    : target_(std::move(target)), temporary_(temporary_name(target_)) {}

PendingFile::~PendingFile() {
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

void PendingFile::commit() {
  std::error_code error;
  std::filesystem::rename(temporary_, target_, error);
  if (error) throw cannot_write(target_, error.value());
  temporary_.clear();
}

void write_file(const std::filesystem::path& target, std::string_view content) {
  PendingFile file(target);
  if (!write_all(file.temporary(), content)) throw cannot_write(target, errno);
  file.commit();
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw cannot_write(folder, error.value());
}

}  // namespace tribo::report
