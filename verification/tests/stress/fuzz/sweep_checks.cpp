// SPDX-License-Identifier: Apache-2.0
// The reader of sweeps on any text: each case of a sweep that it accepts is a legal scene.
#include <algorithm>
#include <cmath>
#include <vector>

#include "stress/fuzz/checks.hpp"
#include "sweep/case_solver.hpp"
#include "sweep/cases.hpp"
#include "sweep/plan_reader.hpp"

namespace tribo::fuzz {
namespace {

using namespace sweep;

void check_case(const SceneSweep& sweep, const double* values) {
  for (std::size_t v = 0; v < sweep.variables.size(); ++v) {
    const Variable& variable = sweep.variables[v];
    const auto fields = scene_fields();
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const FieldInfo& info) {
      return info.path == variable.path;
    });
    require(field != fields.end(), "a variable is a field", variable.path);
    require(std::isfinite(values[v]), "a drawn value is finite", variable.text);
    if (!variable.words.empty()) {
      require(values[v] >= 0 && values[v] < static_cast<double>(variable.words.size()),
              "a drawn word is in its list", variable.path);
      continue;
    }
    const bool low =
        field->exclusive_minimum ? values[v] <= field->minimum : values[v] < field->minimum;
    require(!low && !(field->maximum && values[v] > *field->maximum),
            "a drawn value is in the field's range", variable.path + ": " + variable.text);
  }
}

// Checks the cases and the results of a sweep's first and last groups.
void check_cases(const SceneSweep& sweep) {
  const std::size_t rows = sweep.cases_per_group(), variables = sweep.variables.size();
  CaseGenerator generator(sweep);
  CaseSolver solver(sweep);
  std::vector<double> values(rows * variables), results(rows * sweep.width());
  for (const std::uint64_t group : {std::uint64_t{0}, sweep.groups - 1}) {
    generator.groups(group, values);
    for (std::size_t row = 0; row < rows; ++row) check_case(sweep, &values[row * variables]);
    if (results.size() < 10'000) solver.solve(values, results);
  }
}

}  // namespace

void check_sweep(std::string_view text) {
  const SweepReading reading = parse_sweep(text, "fuzz");
  require(reading.sweep.has_value() == reading.errors.empty(), "a sweep, or errors", text);
  for (const auto* const problems : {&reading.errors, &reading.warnings})
    for (const InputProblem& problem : *problems) {
      const std::string line = problem.line();
      require(!problem.message().empty() && line.size() < 4000, "a problem is said, and short",
              line);
      require(line.find('\n') == std::string::npos, "a problem is one line", line);
    }
  if (!reading.sweep) return;
  const SceneSweep& sweep = *reading.sweep;
  require(!sweep.variables.empty() && !sweep.columns.empty(), "something varies, and is asked",
          text);
  require(sweep.chunks >= 1 && sweep.chunk_groups >= 1 && sweep.chunks <= sweep.groups,
          "a sweep has chunks, and they have cases", text);
  require((sweep.chunks - 1) * sweep.chunk_groups < sweep.groups, "no chunk is empty", text);
  check_cases(sweep);
}

}  // namespace tribo::fuzz
