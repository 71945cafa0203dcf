// SPDX-License-Identifier: Apache-2.0
// All methods for the root. Those of this project work point by point or in batches.
#include <utility>
#include <vector>

#include "contenders/root_contender.hpp"
#include "tribo/batch.hpp"
#include "tribo/load_sharing.hpp"

namespace tribo::benchmarks {
namespace {

constexpr AsperityModel model = AsperityModel::greenwood_tripp;

LoadSharing<double> sharing_of(const RootCase& c) { return {model, c.stiffness, c.offset}; }

// The number of steps to all roots. Each step is one evaluation of F with its derivative.
double steps(const RootCases& cases) {
  double sum = 0;
  for (std::size_t i = 0; i < cases.size(); ++i)
    sum += sharing_of(cases[i]).root(cases[i].flooded).iterations;
  return sum;
}
double steps_of_all(const RootCases& cases) {
  std::vector<double> film(cases.size());
  return static_cast<double>(
      film_parameter(model, cases.stiffness, cases.offset, cases.flooded, film).steps);
}
double steps_of_one_surface(const RootCases& cases) {
  std::vector<double> film(cases.size());
  return static_cast<double>(film_parameter(sharing_of(cases[0]), cases.flooded, film).steps);
}

RootRun prepared_with_set(std::string_view set, RootRun run) {
  return [set, run = std::move(run)](const RootCases& cases, std::span<double> film) {
    const std::string_view usual = instruction_set();
    use_instruction_set(set);
    run(cases, film);
    use_instruction_set(usual);
  };
}

std::vector<RootContender> own_wide_roots() {
  std::vector<RootContender> all{{"tribocheck", "scalar",
                                  [](const RootCases&) -> RootRun {
                                    return [](const RootCases& cases, std::span<double> film) {
                                      for (std::size_t i = 0; i < cases.size(); ++i)
                                        film[i] = film_parameter(model, cases.stiffness[i],
                                                                 cases.offset[i], cases.flooded[i]);
                                    };
                                  },
                                  steps}};
  for (const std::string_view set : instruction_sets())
    all.push_back(
        {"tribocheck", "batch, all inputs vary, " + std::string(set),
         [set](const RootCases&) {
           return prepared_with_set(set, [](const RootCases& cases, std::span<double> film) {
             film_parameter(model, cases.stiffness, cases.offset, cases.flooded, film);
           });
         },
         steps_of_all});
  return all;
}

std::vector<RootContender> own_one_surface_roots() {
  std::vector<RootContender> all{{"tribocheck", "scalar",
                                  [](const RootCases& surface) -> RootRun {
                                    return [sharing = sharing_of(surface[0])](
                                               const RootCases& cases, std::span<double> film) {
                                      for (std::size_t i = 0; i < cases.size(); ++i)
                                        film[i] = sharing.film_parameter(cases.flooded[i]);
                                    };
                                  },
                                  steps}};
  for (const std::string_view set : instruction_sets())
    all.push_back({"tribocheck", "batch, one surface, " + std::string(set),
                   [set](const RootCases& surface) {
                     return prepared_with_set(
                         set, [sharing = sharing_of(surface[0])](const RootCases& cases,
                                                                 std::span<double> film) {
                           film_parameter(sharing, cases.flooded, film);
                         });
                   },
                   steps_of_one_surface});
  return all;
}

}  // namespace

std::vector<RootContender> wide_root_contenders(Settings settings) {
  return joined<RootContender>({bracketing_roots(settings), derivative_roots(settings),
                                textbook_roots(settings), scipy_roots(), own_wide_roots()});
}

std::vector<RootContender> one_surface_root_contenders(Settings settings) {
  return joined<RootContender>({bracketing_roots(settings), derivative_roots(settings),
                                textbook_roots(settings), inverse_tables(settings), scipy_roots(),
                                own_one_surface_roots()});
}

}  // namespace tribo::benchmarks
