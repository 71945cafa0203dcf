// SPDX-License-Identifier: Apache-2.0
// Functions for the files of tables. They make the rows on all cores, date and write them, read
// them again, and compare a sample of them with rows that are made anew.
#pragma once

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <openssl/sha.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "generators/sampler.hpp"

namespace tribo::reference {

// The last two comment lines of a file's header. They have the date and the rows' checksum.
inline std::string dated(const std::string& rows) {
  unsigned char digest[SHA256_DIGEST_LENGTH];
  SHA256(reinterpret_cast<const unsigned char*>(rows.data()), rows.size(), digest);
  std::string checksum;
  for (const unsigned char byte : digest) checksum += fmt::format("{:02x}", byte);
  return fmt::format("# date: {:%Y-%m-%d}\n# sha256 of the rows: {}\n",
                     fmt::gmtime(std::time(nullptr)), checksum);
}

// Writes the file in one step, so that it is never there in part. If `text` cannot be written, the
// program ends with exit code 1 and a line on stderr.
inline void write_whole(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path temporary = file.string() + ".part";
  std::ofstream out(temporary);
  out << text;
  out.close();
  if (!out) {
    std::cerr << "cannot write " << temporary.string() << ": is the disk full?\n";
    std::exit(1);
  }
  std::error_code failure;
  std::filesystem::rename(temporary, file, failure);
  if (failure) {
    std::cerr << "cannot write " << file.string() << ": " << failure.message() << '\n';
    std::exit(1);
  }
}

inline std::string joined(const std::vector<std::string>& rows) {
  std::string text;
  for (const std::string& row : rows) text += row + "\n";
  return text;
}

// The texts of make(0), …, make(count − 1), made on all cores. Each thread takes `block` successive
// numbers at a time and calls at_end() last. An error is written to stderr behind `prefix`; then
// the threads take no more blocks, and the program ends with exit code 1.
template <class Make, class AtEnd>
std::vector<std::string> made_on_all_cores(std::size_t count, std::size_t block,
                                           const std::string& prefix, Make&& make, AtEnd&& at_end) {
  std::vector<std::string> rows(count);
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  const auto work = [&] {
    for (std::size_t start; (start = block * next++) < count && !failed;)
      for (std::size_t i = start; i < std::min(start + block, count); ++i) try {
          rows[i] = make(i);
        } catch (const std::exception& error) {
          std::cerr << prefix + error.what() + "\n";
          failed = true;
        }
    at_end();
  };
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  if (failed) std::exit(1);
  return rows;
}

// The rows of a file, without its comments and without the line of the columns' names, which begins
// with `columns`.
inline std::vector<std::string> committed_rows(const std::filesystem::path& file,
                                               std::string_view columns) {
  std::ifstream in(file);
  std::vector<std::string> rows;
  for (std::string line; std::getline(in, line);)
    if (!line.starts_with("#") && !line.starts_with(columns)) rows.push_back(line);
  return rows;
}

// Makes a sample of a table's rows again; `seed` determines the sample. again(places) gives their
// texts. Prints the rows for which is_same(committed, again) is false, and returns their number.
// Returns 1 if the number of rows differs.
template <class Again, class IsSame>
int different_rows(const std::string& name, const std::vector<std::string>& committed,
                   std::size_t count_now, std::uint64_t seed, int count, Again&& again,
                   IsSame&& is_same) {
  if (committed.size() != count_now) {
    std::cout << fmt::format("{}: {} rows, the generator makes {}\n", name, committed.size(),
                             count_now);
    return 1;
  }
  Sampler sampler(seed);
  std::vector<std::size_t> places;
  for (int i = 0; i < count; ++i)
    places.push_back(std::min(count_now - 1, static_cast<std::size_t>(sampler.uniform(
                                                 0, static_cast<double>(committed.size())))));
  const std::vector<std::string> rows = again(places);
  int different = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (is_same(committed[places[i]], rows[i])) continue;
    ++different;
    std::cout << fmt::format("{}:\n  committed {}\n  again     {}\n", name, committed[places[i]],
                             rows[i]);
  }
  std::cout << fmt::format("{}: {} of {} rows made again\n", name, count, committed.size());
  return different;
}

}  // namespace tribo::reference
