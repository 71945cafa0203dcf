// SPDX-License-Identifier: Apache-2.0
// Files that appear whole or not at all: written beside their place, then renamed into it.
#pragma once

#include <filesystem>
#include <string_view>

namespace tribo::report {

class PendingFile {
 public:
  explicit PendingFile(std::filesystem::path target);
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile();  // removes what was not committed

  const std::filesystem::path& temporary() const { return temporary_; }
  void commit();  // throws protocol::OutputFailed

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
};

// Both throw protocol::OutputFailed.
void write_file(const std::filesystem::path& target, std::string_view content);
void make_folder(const std::filesystem::path& folder);

}  // namespace tribo::report
