// SPDX-License-Identifier: Apache-2.0
#include "page/write_file.hpp"

#include <fmt/format.h>

#include <exception>
#include <string>
#include <system_error>

#include "protocol/text_streams.hpp"
#include "sweep/output_file.hpp"

namespace tribo::report {
namespace {

protocol::OutputFailed cannot_write(const std::filesystem::path& path, const std::string& why) {
  const std::string start = fmt::format("cannot write {}: ", path.string());
  return protocol::OutputFailed(why.starts_with(start) ? why : start + why);
}

}  // namespace

void write_file(const std::filesystem::path& target, std::string_view content,
                const sweep::Replaceable& replaceable) {
  try {
    sweep::PartFile file(sweep::output_behind_links(target.string()));
    file.write(content);
    file.keep(replaceable);
  } catch (const std::exception& error) {
    throw cannot_write(target, error.what());
  }
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw cannot_write(folder, error.message());
}

}  // namespace tribo::report
