// SPDX-License-Identifier: Apache-2.0
// F_{5/2} and F_2 at 2048 arguments in (0, 6).
#include <algorithm>
#include <memory>
#include <random>

#include "accuracy/reference_table.hpp"
#include "cases/jobs.hpp"

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

constexpr std::size_t timed_arguments = 2048;

double evaluations_a_point(const MomentContender& contender, const std::vector<double>& d) {
  std::vector<double> moments(d.size());
  return evaluations_of([&] { contender.counted(d, moments); }) / static_cast<double>(d.size());
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

std::vector<Measured> jobs_of(const std::vector<MomentContender>& contenders) {
  std::vector<Measured> all;
  const auto d = std::make_shared<const std::vector<double>>(moment_arguments(timed_arguments));
  const auto moments = std::make_shared<std::vector<double>>(timed_arguments);
  for (const MomentContender& contender : contenders) {
    Measured measured{contender.order == Order::two ? "moment_2" : "moment_5_2",
                      contender.family,
                      contender.name,
                      timed_arguments,
                      [=] { contender.run(*d, *moments); },
                      [=] { return judge(contender); },
                      {},
                      contender.own_seconds};
    if (contender.counted)
      measured.evaluations = [=] { return evaluations_a_point(contender, *d); };
    all.push_back(std::move(measured));
  }
  return all;
}

}  // namespace tribo::benchmarks
