// SPDX-License-Identifier: Apache-2.0
#include "conformance/conformance_baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "protocol/bounded_json.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;

constexpr double ratchet = 4;
constexpr int schema = 1;

// The order of what a status is worth; failed is least.
int worth(const std::string& status) {
  for (int i = 0; i < 5; ++i)
    if (name(std::array{Status::failed, Status::not_offered, Status::held_physically,
                        Status::partly_held, Status::held}[static_cast<std::size_t>(i)]) == status)
      return i;
  throw std::runtime_error(fmt::format("{} is no status", status));
}

json row_of(const QuantityVerdict& one) {
  return {{"status", name(one.status)},
          {"asked", one.asked},
          {"held", one.held},
          {"failed", one.failed},
          {"skipped", one.skipped},
          {"worst_relative_error", one.status == Status::held || one.status == Status::partly_held
                                       ? json(one.worst_relative)
                                       : json(nullptr)}};
}

enum class Change : std::uint8_t { none, better, worse };

struct Compared {
  Change change;
  std::string line;
};

Compared compare_one(const QuantityVerdict& now, const json& before) {
  const std::string was(before.at("status").get<std::string>()), is(name(now.status));
  if (worth(is) != worth(was))
    return {worth(is) < worth(was) ? Change::worse : Change::better,
            fmt::format("{}: was {}, is {}{}", now.quantity, was, is,
                        now.first_reason.empty() ? "" : " (" + now.first_reason + ")")};
  const auto failed = before.at("failed").get<std::size_t>();
  const auto skipped = before.at("skipped").get<std::size_t>();
  if (now.failed != failed)
    return {now.failed > failed ? Change::worse : Change::better,
            fmt::format("{}: {} cases failed, {} fail", now.quantity, failed, now.failed)};
  if (now.skipped != skipped)
    return {now.skipped > skipped ? Change::worse : Change::better,
            fmt::format("{}: {} cases were skipped, {} are", now.quantity, skipped, now.skipped)};
  const json& error = before.at("worst_relative_error");
  if (!error.is_number() || now.failed > 0) return {Change::none, {}};
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double allowed = ratchet * std::max(epsilon, error.get<double>());
  if (now.worst_relative > allowed)
    return {Change::worse,
            fmt::format("{}: the worst error was {:.3g}, is {:.3g} (case {}); more than {} times",
                        now.quantity, error.get<double>(), now.worst_relative, now.worst_case,
                        ratchet)};
  if (now.worst_relative < error.get<double>() / ratchet)
    return {Change::better, fmt::format("{}: the worst error was {:.3g}, is {:.3g}", now.quantity,
                                        error.get<double>(), now.worst_relative)};
  return {Change::none, {}};
}

const json& quantities_of(const json& baseline) {
  if (!baseline.is_object() || !baseline.contains("quantities") ||
      baseline.value("schema", 0) != schema)
    throw std::runtime_error(fmt::format("no baseline of `tribocheck verify`, schema {}", schema));
  return baseline.at("quantities");
}

}  // namespace

json baseline_of(const ConformanceResult& result, const json& before) {
  json rows = before.is_null() ? json::object() : quantities_of(before);
  for (const QuantityVerdict& one : result.quantities)
    if (!rows.contains(one.quantity) ||
        compare_one(one, rows.at(one.quantity)).change == Change::better)
      rows[one.quantity] = row_of(one);
  return {{"schema", schema},
          {"tolerance", result.tolerance},
          {"subject", result.subject},
          {"quantities", std::move(rows)}};
}

BaselineChanges compare(const ConformanceResult& result, const json& baseline) {
  BaselineChanges changes;
  const json& rows = quantities_of(baseline);
  if (baseline.value("tolerance", "") != result.tolerance)
    throw std::runtime_error(fmt::format("it was made with --tolerance {}, this is {}",
                                         baseline.value("tolerance", "?"), result.tolerance));
  for (const QuantityVerdict& one : result.quantities) {
    if (!rows.contains(one.quantity)) {
      if (one.status == Status::failed)
        changes.worse.push_back({one.quantity, fmt::format("{}: is new, and fails", one.quantity)});
      else
        changes.better.push_back(
            {one.quantity, fmt::format("{}: is new, {}", one.quantity, name(one.status))});
      continue;
    }
    const Compared compared = compare_one(one, rows.at(one.quantity));
    if (compared.change == Change::worse) changes.worse.push_back({one.quantity, compared.line});
    if (compared.change == Change::better) changes.better.push_back({one.quantity, compared.line});
    if (one.status == Status::failed && compared.change != Change::worse)
      changes.failed_already.push_back(one.quantity);
  }
  for (const auto& row : rows.items())
    if (std::none_of(result.quantities.begin(), result.quantities.end(),
                     [&](const QuantityVerdict& one) { return one.quantity == row.key(); }))
      changes.worse.push_back({row.key(), fmt::format("{}: is no longer asked", row.key())});
  if (result.violation_count > 0)
    changes.worse.push_back(
        {"protocol", fmt::format("the protocol was broken {} times", result.violation_count)});
  return changes;
}

json read_conformance_baseline(const std::string& path) {
  if (!std::filesystem::exists(path)) return nullptr;
  std::ifstream file(path);
  json content;
  try {
    content = protocol::read_bounded_json(file);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", path, error.what()));
  }
  if (content.is_discarded()) throw std::runtime_error(fmt::format("{}: no JSON", path));
  return content;
}

}  // namespace tribo::conformance
