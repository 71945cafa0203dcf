// SPDX-License-Identifier: Apache-2.0
// Hertz' elliptical contact at 1024 ratios of its radii.
#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "accuracy/reference_table.hpp"
#include "cases/jobs.hpp"

namespace tribo::benchmarks {
namespace {

constexpr double greatest_ratio = 1e4;

struct Certified {
  double high, low, condition;
};
struct CertifiedEllipses {
  std::vector<EllipseCase> cases;
  std::vector<std::array<Certified, 2>> values;  // a_x and the peak pressure
};

const CertifiedEllipses& certified_ellipses() {
  static const CertifiedEllipses all = [] {
    CertifiedEllipses found;
    for (const auto& row :
         verification::read_reference_table(TRIBOCHECK_REFERENCE "/exact/hertz_ellipse.csv")) {
      const EllipseCase one{row.number("load"), row.number("effective_modulus"),
                            row.number("radius_x"), row.number("radius_y")};
      const double ratio = one.radius_y / one.radius_x;
      if (row.text("region") != "ordinary" || ratio < 1 || ratio > greatest_ratio) continue;
      const Certified value{row.number("high"), row.number("low"), row.number("condition")};
      if (row.text("output") == "semi_axis_x") {
        found.cases.push_back(one);
        found.values.push_back({value, {}});
      } else if (row.text("output") == "peak_pressure") {
        found.values.back()[1] = value;
      }
    }
    return found;
  }();
  return all;
}

}  // namespace

std::vector<EllipseCase> random_ellipses(std::size_t count) {
  std::mt19937_64 generator(4);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<EllipseCase> cases(count);
  for (EllipseCase& one : cases)
    one = {50, 107.9e9, 9.5e-3, 9.5e-3 * std::pow(greatest_ratio, unit(generator))};
  return cases;
}

Errors judge(const EllipseContender& contender) {
  const CertifiedEllipses& all = certified_ellipses();
  std::vector<EllipseAnswer> answers(all.cases.size());
  contender.run(all.cases, answers);
  ErrorTally tally;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const auto& [axis, peak] = all.values[i];
    tally.add(answers[i].semi_axis_x, axis.high, axis.low, axis.condition);
    tally.add(answers[i].peak_pressure, peak.high, peak.low, peak.condition);
  }
  return tally.errors();
}

std::vector<Measured> jobs_of(const std::vector<EllipseContender>& contenders) {
  constexpr std::size_t count = 1024;
  const auto cases = std::make_shared<const std::vector<EllipseCase>>(random_ellipses(count));
  const auto answers = std::make_shared<std::vector<EllipseAnswer>>(count);
  std::vector<Measured> all;
  for (const EllipseContender& contender : contenders) {
    Measured measured{"hertz_ellipse",
                      contender.family,
                      contender.name,
                      count,
                      [=] { contender.run(*cases, *answers); },
                      [=] { return judge(contender); }};
    if (contender.counted)
      measured.evaluations = [=] {
        return evaluations_of([&] { contender.counted(*cases, *answers); }) /
               static_cast<double>(count);
      };
    all.push_back(std::move(measured));
  }
  return all;
}

}  // namespace tribo::benchmarks
