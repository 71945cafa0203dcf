// SPDX-License-Identifier: Apache-2.0
#include "cases/moment_cases.hpp"

#include <algorithm>
#include <random>

#include "accuracy/reference_table.hpp"

namespace tribo::benchmarks {
namespace {

struct Row {
  Order order;
  double d, high, low, condition;
};

const std::vector<Row>& certified_rows() {
  static const std::vector<Row> rows = [] {
    std::vector<Row> all;
    for (const auto& row :
         verification::read_reference_table(TRIBOCHECK_REFERENCE "/exact/gaussian_moment.csv"))
      all.push_back({static_cast<Order>(static_cast<int>(2 * row.number("order"))),
                     row.number("argument"), row.number("high"), row.number("low"),
                     row.number("condition")});
    return all;
  }();
  return rows;
}

}  // namespace

std::vector<double> moment_arguments(std::size_t count) {
  std::vector<double> d(count);
  for (std::size_t i = 0; i < count; ++i)
    d[i] = 6 * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
  std::shuffle(d.begin(), d.end(), std::mt19937_64(1));
  return d;
}

Errors judge(const MomentContender& contender, double from, double to) {
  std::vector<const Row*> rows;
  std::vector<double> d;
  for (const Row& row : certified_rows())
    if (row.order == contender.order && from < row.d && row.d < to &&
        contender.claimed.contains(row.d)) {
      rows.push_back(&row);
      d.push_back(row.d);
    }
  std::vector<double> moments(d.size());
  if (!d.empty()) contender.run(d, moments);
  ErrorTally tally;
  for (std::size_t i = 0; i < rows.size(); ++i)
    tally.add(moments[i], rows[i]->high, rows[i]->low, rows[i]->condition);
  return tally.errors();
}

}  // namespace tribo::benchmarks
