// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "contenders/dense_line_film.hpp"
#include "contenders/line_film_ways.hpp"
#include "ehl/film_kernel.hpp"
#include "ehl/jacobian.hpp"
#include "ehl/line_contact.hpp"
#include "ehl/reynolds.hpp"
#include "work_precision/measures.hpp"

namespace tribo::benchmarks {
namespace {

constexpr int least_cells = 128, most_cells = 16384, most_dense_cells = 4096;
constexpr int fitted_from = 512;

// The state at which a step is made: a coarse film on the grid's nodes.
struct StepState {
  ehl::Numbers x;
  Eigen::VectorXd pressure;
  double separation;
};

StepState state_on(const ehl::CoarseFilm& coarse, int cells) {
  StepState state{coarse.density.nodes(cells), {}, coarse.film.separation};
  const ehl::Numbers pressure = ehl::interpolated(
      coarse.film.x, {coarse.film.pressure.data(), coarse.film.x.size()}, state.x);
  state.pressure = Eigen::Map<const Eigen::VectorXd>(pressure.data(),
                                                     static_cast<Eigen::Index>(pressure.size()));
  return state;
}

// Solves a step's linear equations with our matrices. Returns their bytes, not the solution.
std::size_t hierarchical_step(const ehl::LineContact& contact, const StepState& state,
                              const ehl::FilmKernel& kernel) {
  Eigen::VectorXd film = kernel * state.pressure;
  for (std::size_t i = 0; i < state.x.size(); ++i)
    film[static_cast<Eigen::Index>(i)] += state.x[i] * state.x[i] / 2 + state.separation;
  const ehl::Balance balance = ehl::balance_of(contact, state.x, state.pressure, film);
  std::vector<char> is_free(state.x.size(), 0);
  for (std::size_t i = 0; i < is_free.size(); ++i)
    is_free[i] = state.pressure[static_cast<Eigen::Index>(i)] > 0 ? 1 : 0;
  const ehl::Jacobian jacobian(kernel, balance.slopes, is_free);
  Eigen::MatrixXd sides(film.size(), 2);
  sides.col(0) = balance.surplus;
  sides.col(1).setOnes();
  sides = jacobian.solve(std::move(sides));
  return kernel.bytes() + jacobian.bytes();
}

struct Growth {
  const char* solver;
  int cells;
  double kernel_seconds, step_seconds;
  std::size_t bytes;
};

nlohmann::ordered_json row_of(const Growth& one) {
  return {{"solver", one.solver},
          {"cells", one.cells},
          {"kernel_ns", four_digits(1e9 * one.kernel_seconds)},
          {"step_ns", four_digits(1e9 * one.step_seconds)},
          {"bytes", one.bytes}};
}

}  // namespace

Rows line_film_growth(const Effort& effort) {
  const ehl::LineContact contact = ehl::barus_contact(10, 5);
  const ehl::CoarseFilm coarse = coarse_film(contact);
  const int rounds = std::min(effort.rounds, 3);
  const auto seconds = [&](auto&& work) {
    return median_seconds({{work}}, rounds, effort.least_seconds).front();
  };
  Rows rows;
  for (int cells = least_cells; cells <= most_cells; cells *= 2) {
    const StepState state = state_on(coarse, cells);
    std::optional<ehl::FilmKernel> kernel;
    Growth one{"tribocheck: hierarchical", cells, seconds([&] { kernel.emplace(state.x); }), 0, 0};
    one.step_seconds = seconds([&] { one.bytes = hierarchical_step(contact, state, *kernel); });
    rows.push_back(row_of(one));
  }
  for (int cells = least_cells; cells <= most_dense_cells; cells *= 2) {
    const ehl::Numbers x = coarse.density.nodes(cells);
    std::optional<DenseNewton> newton;
    Growth one{"textbook: dense LU", cells, seconds([&] { newton.emplace(contact, x); }), 0, 0};
    one.step_seconds = seconds([&] {
      newton->start_from(coarse.film);
      newton->step();
    });
    one.bytes = newton->bytes();
    rows.push_back(row_of(one));
  }
  return rows;
}

Rows film_exponents(const Rows& growth) {
  std::vector<std::string> solvers;
  for (const auto& row : growth)
    if (std::find(solvers.begin(), solvers.end(), row.at("solver")) == solvers.end())
      solvers.push_back(row.at("solver"));
  Rows rows;
  for (const std::string& solver : solvers)
    for (const char* const quantity : {"kernel_ns", "step_ns", "bytes"}) {
      std::vector<double> x, y;
      for (const auto& row : growth) {
        if (row.at("solver") != solver || row.at("cells") < fitted_from) continue;
        x.push_back(std::log(row.at("cells").get<double>()));
        y.push_back(std::log(row.at(quantity).get<double>()));
      }
      const auto count = static_cast<Eigen::Index>(x.size());
      Eigen::MatrixXd design(count, 2);
      design.col(0).setOnes();
      design.col(1) = Eigen::Map<const Eigen::VectorXd>(x.data(), count);
      const Eigen::Map<const Eigen::VectorXd> logs(y.data(), count);
      const Eigen::VectorXd fit = design.colPivHouseholderQr().solve(logs);
      const double rest = (logs - design * fit).squaredNorm() / static_cast<double>(count - 2);
      const double spread = (design.col(1).array() - design.col(1).mean()).matrix().squaredNorm();
      rows.push_back({{"solver", solver},
                      {"quantity", quantity},
                      {"exponent", four_digits(fit[1])},
                      {"uncertainty", four_digits(std::sqrt(rest / spread))},
                      {"from_cells", fitted_from},
                      {"to_cells", std::lround(std::exp(x.back()))}});
    }
  return rows;
}

}  // namespace tribo::benchmarks
