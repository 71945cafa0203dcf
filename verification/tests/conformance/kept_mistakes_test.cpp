// SPDX-License-Identifier: Apache-2.0
// Compares the answers of each mistake with reference/baselines/mistakes.tsv. No other test notices
// that a wrong formula is no longer the one that its text describes. To write the file anew:
//
//   TRIBOCHECK_UPDATE_MISTAKES=1 build/release/verification/tests/kept_mistakes_test
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "conformance/answers.hpp"
#include "support/judge.hpp"

namespace tribo::conformance {
namespace {

const std::string kept_file = reference + "/baselines/mistakes.tsv";
constexpr std::size_t most_changed = 48;  // cases whose answers a mistake changes, at most

// The cases of each function, sorted by a hash of their ids (FNV-1a) and so without a pattern.
std::map<std::string, std::vector<TestCase>> mixed_cases() {
  const auto hash = [](const std::string& text) {
    std::uint64_t value = 0xcbf29ce484222325;
    for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return value;
  };
  std::map<std::string, std::vector<TestCase>> by_function;
  for (const TestCase& one : all_cases())
    if (!one.is_extreme)
      by_function[is_operating_point(one.function) ? "operating_point" : one.function].push_back(
          one);
  for (auto& [function, cases] : by_function)
    std::sort(cases.begin(), cases.end(), [&](const TestCase& a, const TestCase& b) {
      return std::pair(hash(a.id), a.id) < std::pair(hash(b.id), b.id);
    });
  return by_function;
}

struct Told {
  std::size_t asked = 0, unsaid = 0;  // cases; those for which the mistake has no answer
  double change = 0;  // weighted sum of arctangents of the answers' relative changes
};

Told told_of(const Mistake& mistake, const std::vector<TestCase>& cases) {
  Told told;
  const Mistake* const one = &mistake;
  std::size_t changed = 0;
  for (const TestCase& asked : cases) {
    if (changed == most_changed) break;
    const std::optional<Numbers> given = numbers_with({&one, 1}, question_of(asked));
    ++told.asked;
    told.unsaid += given ? 0U : 1U;
    bool is_changed = false;
    for (const Expected& expected : asked.expected) {
      if (!given || !expected.place || expected.high == 0) continue;
      const double change = (*given)[*expected.place] / expected.high - 1;
      const auto weight = static_cast<double>(1 + (7 * told.asked + 3 * *expected.place) % 11);
      told.change += weight * (std::isnan(change) ? 2 : std::atan(change));
      is_changed = is_changed || !(std::abs(change) <= 1e-6);
    }
    changed += is_changed ? 1U : 0U;
  }
  return told;
}

TEST(Mistakes, AnswerWhatIsKept) {
  const auto cases = mixed_cases();
  std::vector<std::pair<std::string, double>> rows;
  for (const Mistake& mistake : all_mistakes()) {
    const Told told = told_of(mistake, cases.at(mistake.function));
    rows.emplace_back(
        fmt::format("{}\t{}\t{}\t{}\t{}\t{}", mistake.function, mistake.name, mistake.follows,
                    fmt::join(mistake.touches, ";"), told.asked, told.unsaid),
        told.change);
  }
  if (std::getenv("TRIBOCHECK_UPDATE_MISTAKES") != nullptr) {
    std::ofstream file(kept_file);
    for (const auto& [row, change] : rows) file << fmt::format("{}\t{:.8f}\n", row, change);
  }
  std::map<std::string, double> kept;
  std::ifstream file(kept_file);
  for (std::string line; std::getline(file, line);)
    kept[line.substr(0, line.rfind('\t'))] = std::stod(line.substr(line.rfind('\t') + 1));
  EXPECT_EQ(rows.size(), kept.size()) << kept_file;
  for (const auto& [row, change] : rows) {
    const auto found = kept.find(row);
    const double before = found == kept.end() ? std::nan("") : found->second;
    EXPECT_TRUE(verification::is_within(change, before, 1e-7))
        << row << ": if that is meant, TRIBOCHECK_UPDATE_MISTAKES=1 writes it anew";
  }
}

}  // namespace
}  // namespace tribo::conformance
