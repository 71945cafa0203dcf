// SPDX-License-Identifier: Apache-2.0
#include "generators/line_collocation.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "generators/log_element.hpp"

namespace tribo::reference {
namespace {

using ehl::LineContact;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Ends = std::vector<double>;  // ends of elements, rising

constexpr int newton_steps = 25;
// Relative error of the films and of X_e with an inlet of length 100. It is inversely proportional
// to the fourth power of this length.
constexpr double inlet_error = 5e-8;
constexpr double first_fluidity = 1e-2, last_fluidity = 3e-6;

// A state: the elements, the pressure at their nodes, the separation H₀ and the flow c.
struct State {
  Ends ends;  // the last one is X_e
  VectorXd pressure;
  double separation, mass_flow;
};

struct Values {
  double central, minimum, at_greatest_pressure, spike_pressure, spike_place, outlet;
};

class Collocation {
 public:
  Collocation(const LineContact& contact, const LogElement& element, double fluidity)
      : contact_(contact), element_(element), fluidity_(fluidity), degree_(element.degree()) {}

  VectorXd nodes(const Ends& ends) const {
    VectorXd x(node_count(ends));
    for (std::size_t e = 0; e + 1 < ends.size(); ++e) {
      const auto nodes = element_.nodes().head(degree_).array();
      const double half = (ends[e + 1] - ends[e]) / 2;
      x.segment(first(e), degree_) = ends[e] + half * (1 + nodes);
    }
    x[x.size() - 1] = ends.back();
    return x;
  }

  // The pressure far upstream, where η̄ is 1, c is small beside H, and H is X²/2.
  double inlet_pressure(const Ends& ends) const {
    return contact_.theta() * 4 / 3 / std::pow(-ends.front(), 3);
  }

  // Solves for all unknowns by Newton's method: the pressures between the ends, c, H₀ and X_e.
  // Returns the number of steps, or 0 if the method did not converge.
  int solve(State& state) const {
    state.pressure[0] = inlet_pressure(state.ends);
    state.pressure[state.pressure.size() - 1] = 0;
    double before = 0;
    for (int step = 1; step <= newton_steps; ++step) {
      const double change = make_step(state);
      if (!(change < 1e6)) return 0;
      const bool is_rounding = change < 1e-7 && change > before / 2 && step > 1;
      if (change < 1e-9 || is_rounding) return step;
      before = change;
    }
    return 0;
  }

  Values values(const State& state) const {
    Values v{};
    v.outlet = state.ends.back();
    v.central = film_at(state, 0);
    const VectorXd x = nodes(state.ends);
    Index least;
    films(state, kernel(state.ends, x), x).minCoeff(&least);
    v.minimum =
        least_film(state, x[std::max<Index>(least - 1, 0)], x[std::min(least + 1, x.size() - 1)]);
    const std::vector<double> tops = pressure_maxima(state);
    v.spike_pressure = v.spike_place = std::numeric_limits<double>::quiet_NaN();
    for (const double top : tops) {
      const double p = pressure_at(state, top).value;
      if (top == tops.front() || v.spike_pressure > p) continue;
      v.spike_pressure = p;
      v.spike_place = top;
    }
    const double greatest = pressure_at(state, tops.front()).value;
    v.at_greatest_pressure = state.mass_flow / contact_.fluid.density(greatest);
    return v;
  }

  // The same pressure on finer elements: those for which is_halved holds are cut into halves.
  template <class Predicate>
  State halved(const State& state, const Predicate& is_halved) const {
    State finer{{}, {}, state.separation, state.mass_flow};
    std::vector<double> pressure;
    for (std::size_t e = 0; e + 1 < state.ends.size(); ++e) {
      const double length = state.ends[e + 1] - state.ends[e];
      const VectorXd c = coefficients(state, e);
      const int parts = is_halved(c) && length > 1e-9 ? 2 : 1;
      for (int part = 0; part < parts; ++part) {
        finer.ends.push_back(state.ends[e] + length * part / parts);
        for (int k = 0; k < degree_; ++k)
          pressure.push_back(series(c, -1 + (2 * part + 1 + element_.nodes()[k]) / parts));
      }
    }
    finer.ends.push_back(state.ends.back());
    pressure.push_back(0);
    finer.pressure = Eigen::Map<VectorXd>(pressure.data(), static_cast<Index>(pressure.size()));
    return finer;
  }

 private:
  struct Pressure {
    double value, slope;
  };

  Index node_count(const Ends& ends) const { return first(ends.size() - 1) + 1; }
  Index first(std::size_t e) const { return static_cast<Index>(e) * degree_; }

  static double series(const VectorXd& coefficients, double z) {
    double sum = 0;
    for (Index n = 0; n < coefficients.size(); ++n)
      sum += coefficients[n] * legendre(static_cast<int>(n), z);
    return sum;
  }
  VectorXd coefficients(const State& state, std::size_t e) const {
    return element_.to_legendre() * state.pressure.segment(first(e), degree_ + 1);
  }

  double fluidity(double p) const { return std::exp(-contact_.fluid.log_viscosity(p)) + fluidity_; }

  // The film at x is the sum of the pressures at the nodes times these weights, and of X²/2 + H₀.
  VectorXd film_weights(const Ends& ends, double x) const {
    VectorXd weights = VectorXd::Zero(node_count(ends));
    const LogElement::Weights integral = element_.integral();
    for (std::size_t e = 0; e + 1 < ends.size(); ++e) {
      const double half = (ends[e + 1] - ends[e]) / 2;
      weights.segment(first(e), degree_ + 1) -=
          half / std::numbers::pi *
          (element_.log_weights((x - ends[e]) / half - 1) + std::log(half) * integral);
    }
    return weights;
  }
  MatrixXd kernel(const Ends& ends, const VectorXd& x) const {
    MatrixXd transposed(x.size(), x.size());
    for (Index i = 0; i < x.size(); ++i) transposed.col(i) = film_weights(ends, x[i]);
    return transposed.transpose();
  }
  static VectorXd films(const State& state, const MatrixXd& kernel, const VectorXd& x) {
    return kernel * state.pressure + (x.array().square() / 2 + state.separation).matrix();
  }
  double film_at(const State& state, double x) const {
    return film_weights(state.ends, x).dot(state.pressure) + x * x / 2 + state.separation;
  }

  // The load is the sum of the pressures at the nodes times these weights, and of the load upstream
  // of the first node, upstream_load().
  VectorXd load_weights(const Ends& ends) const {
    VectorXd weights = VectorXd::Zero(node_count(ends));
    for (std::size_t e = 0; e + 1 < ends.size(); ++e)
      weights.segment(first(e), degree_ + 1) += (ends[e + 1] - ends[e]) / 2 * element_.integral();
    return weights;
  }
  double upstream_load(const Ends& ends) const { return -inlet_pressure(ends) * ends.front() / 2; }

  VectorXd pressure_slopes(const State& state) const {
    VectorXd slopes = VectorXd::Zero(state.pressure.size());
    for (std::size_t e = 0; e + 1 < state.ends.size(); ++e)
      slopes.segment(first(e), degree_) = 2 / (state.ends[e + 1] - state.ends[e]) *
                                          element_.slopes().topRows(degree_) *
                                          state.pressure.segment(first(e), degree_ + 1);
    return slopes;
  }

  // Residuals of Reynolds' equation at the nodes; the last residual is that of the load.
  VectorXd residual(const State& state, const VectorXd& film, const VectorXd& slopes) const {
    const Index count = film.size();
    VectorXd left(count + 1);
    for (Index i = 0; i < count; ++i) {
      const double p = state.pressure[i], density = contact_.fluid.density(p);
      left[i] = density * std::pow(film[i], 3) / contact_.theta() * fluidity(p) * slopes[i] -
                density * film[i] + state.mass_flow;
    }
    left[count] = load_weights(state.ends).dot(state.pressure) + upstream_load(state.ends) -
                  std::numbers::pi / 2;
    return left;
  }

  // The elements after the outlet has moved. All ends downstream of X = 0 move with it.
  static Ends stretched(Ends ends, double outlet) {
    const double factor = outlet / ends.back();
    for (double& end : ends)
      if (end > 0) end *= factor;
    return ends;
  }

  // The derivatives of the residuals with respect to the pressures between the ends, c, H₀ and X_e.
  MatrixXd jacobian(const State& state, const MatrixXd& kernel, const VectorXd& film,
                    const VectorXd& slopes) const {
    const Index count = film.size(), inner = count - 2;
    MatrixXd j = MatrixXd::Zero(count + 1, count + 1);
    for (Index i = 0; i < count; ++i) {
      const double p = state.pressure[i], own = fluidity(p);
      const double density = contact_.fluid.density(p);
      const double density_slope = contact_.fluid.density_slope(p);
      const double drive = density * std::pow(film[i], 3) / contact_.theta() * own;
      const double by_film = 3 * drive / film[i] * slopes[i] - density;
      j.row(i).head(inner) = by_film * kernel.row(i).segment(1, inner);
      j(i, inner) = 1;
      j(i, inner + 1) = by_film;
      if (i > 0 && i <= inner)
        j(i, i - 1) += drive * slopes[i] *
                           (density_slope / density -
                            contact_.fluid.log_viscosity_slope(p) * (1 - fluidity_ / own)) -
                       density_slope * film[i];
      if (i + 1 == count) continue;
      const auto e = static_cast<std::size_t>(i / degree_);
      const double per_length = 2 / (state.ends[e + 1] - state.ends[e]);
      for (Index k = 0; k <= degree_; ++k) {
        const Index node = first(e) + k;
        if (node > 0 && node <= inner)
          j(i, node - 1) += drive * element_.slopes()(i % degree_, k) * per_length;
      }
    }
    j.row(count).head(inner) = load_weights(state.ends).segment(1, inner);

    State moved = state;
    const double step = 1e-4 * (state.ends.back() - state.ends[state.ends.size() - 2]);
    moved.ends = stretched(state.ends, state.ends.back() + step);
    const VectorXd x = nodes(moved.ends);
    const VectorXd there =
        residual(moved, films(moved, this->kernel(moved.ends, x), x), pressure_slopes(moved));
    j.col(count) = (there - residual(state, film, slopes)) / step;
    return j;
  }

  // Makes a step of Newton's method, or a part of it: the part is halved until the least film is
  // more than 0.3 of what it was, or the part is at most 1e-4. Returns the greatest change of P, c
  // or X_e that the whole step would make. Returns infinity and makes no step if the equations have
  // no finite solution, or if the first part would be at most 1e-4.
  double make_step(State& state) const {
    const VectorXd x = nodes(state.ends);
    const MatrixXd kernel = this->kernel(state.ends, x);
    const VectorXd film = films(state, kernel, x), slopes = pressure_slopes(state);
    VectorXd left = residual(state, film, slopes);
    MatrixXd j = jacobian(state, kernel, film, slopes);
    const Index count = film.size(), inner = count - 2;
    for (Index i = 0; i < count; ++i) {
      j.row(i) /= film[i];
      left[i] /= film[i];
    }
    const VectorXd change = -j.partialPivLu().solve(left);
    if (!change.allFinite()) return std::numeric_limits<double>::infinity();
    const double of_pressure = change.head(inner).cwiseAbs().maxCoeff();
    const double of_outlet = std::fabs(change[count]);
    const double room = (state.ends.back() - state.ends[state.ends.size() * 19 / 20 - 1]) / 3;
    double part = std::min({1.0, 0.3 / of_pressure, room / of_outlet});
    if (!(part > 1e-4)) return std::numeric_limits<double>::infinity();  // the part is too small
    for (; part > 1e-4; part /= 2) {
      State next = state;
      next.pressure.segment(1, inner) += part * change.head(inner);
      next.mass_flow += part * change[inner];
      next.separation += part * change[inner + 1];
      next.ends = stretched(state.ends, state.ends.back() + part * change[count]);
      const VectorXd there = nodes(next.ends);
      if (films(next, this->kernel(next.ends, there), there).minCoeff() > 0.3 * film.minCoeff()) {
        state = std::move(next);
        return std::max({of_pressure, std::fabs(change[inner]), of_outlet});
      }
    }
    return std::numeric_limits<double>::infinity();  // no part of the step leaves a film
  }

  Pressure pressure_at(const State& state, double x) const {
    const auto after = std::upper_bound(state.ends.begin() + 1, state.ends.end() - 1, x);
    const auto e = static_cast<std::size_t>(after - state.ends.begin()) - 1;
    const double half = (state.ends[e + 1] - state.ends[e]) / 2;
    const double z = (x - state.ends[e]) / half - 1;
    const VectorXd c = coefficients(state, e);
    double slope = 0;  // P_n has the slope Σ (2k + 1) P_k, k = n − 1, n − 3, …
    for (Index n = 1; n < c.size(); ++n)
      for (Index k = n - 1; k >= 0; k -= 2)
        slope += c[n] * static_cast<double>(2 * k + 1) * legendre(static_cast<int>(k), z);
    return {series(c, z), slope / half};
  }

  std::vector<double> pressure_maxima(const State& state) const {
    std::vector<double> tops;
    double low = state.ends.front();
    bool is_rising = true;
    for (std::size_t e = 0; e + 1 < state.ends.size(); ++e)
      for (int k = 0; k < 8; ++k) {
        const double at = state.ends[e] + (state.ends[e + 1] - state.ends[e]) * (k + 0.5) / 8;
        const bool rises = pressure_at(state, at).slope > 0;
        if (is_rising && !rises) {
          double left = low, right = at;
          for (int i = 0; i < 50; ++i) {
            const double middle = (left + right) / 2;
            (pressure_at(state, middle).slope > 0 ? left : right) = middle;
          }
          tops.push_back((left + right) / 2);
        }
        is_rising = rises;
        low = at;
      }
    return tops;
  }

  // The least film between two places, by golden sections.
  double least_film(const State& state, double low, double high) const {
    constexpr double part = 2 - std::numbers::phi;
    for (int i = 0; i < 40; ++i) {
      const double a = low + part * (high - low), b = high - part * (high - low);
      if (film_at(state, a) < film_at(state, b))
        high = b;
      else
        low = a;
    }
    return film_at(state, (low + high) / 2);
  }

  const LineContact& contact_;
  const LogElement& element_;
  double fluidity_;
  int degree_;
};

// Ends of `count` elements that have equal shares of a density. The density has three parts: a half
// of it is proportional to the root of the pressure's curvature, a quarter to the slope of ln H,
// and a quarter to 1/(1 + |X|).
Ends first_ends(const FilmStart& start, double inlet, double outlet, int count) {
  const auto x = start.x, p = start.pressure;
  std::vector<double> bend(x.size(), 0.0);
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    const double left = (p[i] - p[i - 1]) / (x[i] - x[i - 1]);
    const double right = (p[i + 1] - p[i]) / (x[i + 1] - x[i]);
    bend[i] = std::fabs(2 * (right - left) / (x[i + 1] - x[i - 1]));
  }
  for (int times = 0; times < 8; ++times) {
    std::vector<double> smooth = bend;
    for (std::size_t i = 1; i + 1 < bend.size(); ++i)
      smooth[i] = (bend[i - 1] + 2 * bend[i] + bend[i + 1]) / 4;
    bend = std::move(smooth);
  }
  std::vector<double> place{inlet}, root, slope, distance;
  double of_root = 0, of_slope = 0, of_distance = 0;
  for (std::size_t i = 0; i + 1 < x.size() && place.back() < outlet; ++i) {
    if (x[i + 1] <= inlet) continue;
    const double end = std::min(x[i + 1], outlet), length = end - place.back();
    root.push_back(length * std::sqrt((bend[i] + bend[i + 1]) / 2));
    slope.push_back(length * std::fabs(std::log(start.film[i + 1] / start.film[i])) /
                    (x[i + 1] - x[i]));
    distance.push_back(length / (1 + std::fabs(end + place.back()) / 2));
    of_root += root.back();
    of_slope += slope.back();
    of_distance += distance.back();
    place.push_back(end);
  }
  place.back() = outlet;
  Ends ends{inlet};
  double below = 0;
  for (std::size_t i = 0; i < root.size(); ++i) {
    const double share =
        0.5 * root[i] / of_root + 0.25 * slope[i] / of_slope + 0.25 * distance[i] / of_distance;
    while (static_cast<int>(ends.size()) < count &&
           static_cast<double>(ends.size()) / count < below + share) {
      const double part = (static_cast<double>(ends.size()) / count - below) / share;
      ends.push_back(place[i] + part * (place[i + 1] - place[i]));
    }
    below += share;
  }
  ends.push_back(outlet);
  return ends;
}

State first_state(const FilmStart& start, const Ends& ends, const VectorXd& nodes) {
  State state{ends, VectorXd(nodes.size()), start.separation, start.mass_flow};
  std::size_t k = 0;
  for (Index i = 0; i < nodes.size(); ++i) {
    while (k + 2 < start.x.size() && start.x[k + 1] < nodes[i]) ++k;
    const double part = (nodes[i] - start.x[k]) / (start.x[k + 1] - start.x[k]);
    state.pressure[i] = start.pressure[k] + part * (start.pressure[k + 1] - start.pressure[k]);
  }
  return state;
}

// Solves, and halves elements, until P is resolved on all of them. If that is not possible, returns
// false and leaves the state as it was.
bool solve_resolved(const Collocation& way, const CollocationOptions& options, State& state,
                    int& steps) {
  const auto is_coarse = [&](const VectorXd& c) {
    const Index n = c.size() - 1;
    return std::fabs(c[n]) + 0.2 * std::fabs(c[n - 1]) > options.resolution;
  };
  State trial = state;
  for (;;) {
    const int made = way.solve(trial);
    steps += made;
    if (made == 0) return false;
    State finer = way.halved(trial, is_coarse);
    if (finer.ends.size() == trial.ends.size()) {
      state = std::move(trial);
      return true;
    }
    if (static_cast<int>(finer.ends.size()) > options.most_elements) return false;
    trial = std::move(finer);
  }
}

// The solution for one fluidity φ.
struct Level {
  double fluidity;
  Values values;
};

// Extrapolates the last two levels linearly to φ = 0. The error is the sum of all further changes
// of this value, if they shrink as √φ. √φ is assumed because they shrink more slowly than φ² near
// the spike.
CollocatedNumber without_fluidity(const std::vector<Level>& levels, double Values::*member) {
  const auto extrapolated = [&](std::size_t i) {
    const Level &coarse = levels[i - 1], &fine = levels[i];
    const double value = fine.values.*member;
    return value +
           (value - coarse.values.*member) * fine.fluidity / (coarse.fluidity - fine.fluidity);
  };
  const std::size_t last = levels.size() - 1;
  const double changed = std::fabs(extrapolated(last) - extrapolated(last - 1));
  const double root = std::sqrt(levels[last].fluidity / levels[last - 1].fluidity);
  return {extrapolated(last), changed * root / (1 - root)};
}

// Solves on a mesh that begins with options.elements elements.
CollocatedFilm collocate(const LineContact& contact, const FilmStart& start,
                         const CollocationOptions& options) {
  CollocatedFilm result;
  std::size_t last = 0;
  for (std::size_t i = 0; i < start.x.size(); ++i)
    if (start.pressure[i] > 0) last = i;
  if (last == 0) {
    result.reason = "there is no pressure to start from";
    return result;
  }
  const double outlet = (start.x[last] + start.x[last + 1]) / 2;
  const double inlet =
      std::max(-options.inlet * std::fmax(1, std::sqrt(2 * start.mass_flow)), start.x.front());
  const LogElement element(options.degree);
  const Ends ends = first_ends(start, inlet, outlet, options.elements);
  State state = first_state(start, ends, Collocation(contact, element, 0).nodes(ends));

  std::vector<Level> levels;
  const auto solve_level = [&](double fluidity) {
    const Collocation way(contact, element, fluidity);
    if (!solve_resolved(way, options, state, result.steps)) return false;
    levels.push_back({fluidity, way.values(state)});
    return true;
  };
  if (!solve_level(0)) {
    double fluidity = first_fluidity, factor = 0.4;
    while (fluidity > last_fluidity && factor < 0.8) {
      if (solve_level(fluidity))
        fluidity *= factor;
      else {
        fluidity /= factor;
        factor = std::sqrt(factor);
        fluidity *= factor;
      }
    }
    if (levels.size() < 3) {
      result.reason =
          "Newton's method did not converge, or the elements did not resolve the pressure, with "
          "viscosities of at most some thousand times that at the inlet";
      return result;
    }
  }

  result.least_fluidity = levels.back().fluidity;
  const Collocation way(contact, element, result.least_fluidity);
  State finest = way.halved(state, [](const VectorXd&) { return true; });
  result.elements = static_cast<int>(finest.ends.size()) - 1;
  const int made = way.solve(finest);
  result.steps += made;
  if (made == 0) {
    result.reason = "Newton's method did not converge on the halved elements";
    return result;
  }
  const Values finer = way.values(finest);
  const auto number = [&](double Values::*member) {
    const double coarse = levels.back().values.*member;
    CollocatedNumber n =
        levels.size() == 1 ? CollocatedNumber{coarse, 0} : without_fluidity(levels, member);
    n.value += finer.*member - coarse;
    n.error += std::fabs(finer.*member - coarse);
    return n;
  };
  const auto with_inlet = [&](double Values::*member) {
    CollocatedNumber n = number(member);
    n.error += inlet_error * std::pow(100 / options.inlet, 4) * n.value;
    return n;
  };
  result.central = with_inlet(&Values::central);
  result.minimum = with_inlet(&Values::minimum);
  result.at_greatest_pressure = with_inlet(&Values::at_greatest_pressure);
  result.outlet = with_inlet(&Values::outlet);
  if (levels.size() == 1) {
    result.spike_pressure = number(&Values::spike_pressure);
    result.spike_place = number(&Values::spike_place);
  }
  result.is_solved = true;
  return result;
}

}  // namespace

CollocatedFilm collocate_line_film(const LineContact& contact, const FilmStart& start,
                                   const CollocationOptions& options) {
  CollocationOptions with_more = options;
  CollocatedFilm film = collocate(contact, start, options);
  for (int attempt = 0; attempt < 2 && !film.is_solved; ++attempt) {
    with_more.elements = with_more.elements * 4 / 3;
    film = collocate(contact, start, with_more);
  }
  return film;
}

}  // namespace tribo::reference
