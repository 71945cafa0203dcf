// SPDX-License-Identifier: Apache-2.0
// No right solver is called wrong. Thousands of equivalent ways to write the same formulas are
// drawn at random: other units, powers, roots, series, quadratures and conventions. Each answers
// all cases of its function.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include "conformance/answers.hpp"
#include "conformance/question.hpp"
#include "conformance/readings.hpp"
#include "support/judge.hpp"
#include "tribo/starvation.hpp"
#include "tribo/viscosity_index.hpp"

namespace tribo::conformance {
namespace {

using catalogue::Arguments;
using Answers = std::vector<double>;  // in the order of the function's results
using Formula = std::function<Answers(const Arguments&)>;

constexpr double pi = std::numbers::pi;

// The choices that are drawn anew for each way of writing.
struct Draw {
  std::mt19937_64 random;

  int any(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }
  // A unit: a power of ten with which an input is multiplied, and a result divided.
  double unit() { return std::pow(10.0, any(13) - 6); }

  // xⁿ by a power, by a logarithm of some base, or by a power of 1/x.
  std::function<double(double, double)> power() {
    const double base = between(1.5, 12);
    switch (any(4)) {
      case 0:
        return [](double x, double n) { return std::pow(x, n); };
      case 1:
        return [](double x, double n) { return std::exp(n * std::log(x)); };
      case 2:
        return [=](double x, double n) { return std::pow(base, n * std::log(x) / std::log(base)); };
      default:
        return [](double x, double n) { return 1 / std::pow(1 / x, n); };
    }
  }
  // An integral over [from, to] by Gauss' rule on strips, or by Simpson's.
  std::function<double(const std::function<double(double)>&, double, double)> integral(
      int fewest_strips) {
    const int strips = fewest_strips + any(fewest_strips), kind = any(2);
    return [=](const std::function<double(double)>& of, double from, double to) {
      const double h = (to - from) / strips;
      double sum = 0;
      for (int i = 0; i < strips; ++i) {
        const double low = from + i * h;
        if (kind == 0) {
          sum += boost::math::quadrature::gauss<double, 15>::integrate(of, low, low + h);
          continue;
        }
        constexpr int parts = 32;
        for (int k = 0; k <= parts; ++k) {
          const double weight = k == 0 || k == parts ? 1 : k % 2 == 1 ? 4 : 2;
          sum += weight * of(low + k * h / parts) * h / parts / 3;
        }
      }
      return sum;
    };
  }
  // The root of a function that rises from below 0 at `low` to above 0 at `high`: by dividing
  // the bracket, or by TOMS 748.
  std::function<double(const std::function<double(double)>&, double, double)> root() {
    const bool is_of_parts = any(2) == 0;
    const double part = between(0.3, 0.7);
    return [=](const std::function<double(double)>& of, double low, double high) {
      if (!is_of_parts) {
        std::uintmax_t steps = 200;
        const auto found = boost::math::tools::toms748_solve(
            of, low, high, boost::math::tools::eps_tolerance<double>(46), steps);
        return (found.first + found.second) / 2;
      }
      while (high - low > 1e-13 * std::abs(high)) {
        const double middle = low + part * (high - low);
        (of(middle) < 0 ? low : high) = middle;
      }
      return (low + high) / 2;
    };
  }
};

Formula reduced_radius(Draw& draw) {
  const double unit = draw.unit();
  const bool by_diameters = draw.any(2) == 0;
  return [=](const Arguments& a) -> Answers {
    const auto gap = [&](double one, double other) {
      if (!by_diameters) return 1 / (unit / one + unit / other) * unit;
      return 0.5 / (1 / (2 * one) + 1 / (2 * other));
    };
    const double x = gap(a[0], a[1]), y = gap(a[2], a[3]);
    return {x, y, 1 / (1 / x + 1 / y)};
  };
}

// K and E of k by Legendre's form, Carlson's form, or the arithmetic-geometric mean.
Formula hertz_ellipse(Draw& draw) {
  const int way = draw.any(3);
  const auto root = draw.root();
  const auto power = draw.power();
  return [=](const Arguments& a) -> Answers {
    const bool is_exchanged = a[3] < a[2];
    const double ratio = std::max(a[2], a[3]) / std::min(a[2], a[3]);
    const auto integrals = [way](double k) -> std::pair<double, double> {
      const double modulus2 = (k - 1) * (k + 1) / (k * k), complement = 1 / (k * k);
      if (way == 0)
        return {boost::math::ellint_1(std::sqrt(modulus2)),
                boost::math::ellint_2(std::sqrt(modulus2))};
      if (way == 1) {
        const double first = boost::math::ellint_rf(0.0, complement, 1.0);
        return {first, first - modulus2 / 3 * boost::math::ellint_rd(0.0, complement, 1.0)};
      }
      double one = 1, other = 1 / k, sum = modulus2 / 2;
      for (double weight = 1; std::abs(one - other) > 1e-15 * one; weight *= 2) {
        const double difference = (one - other) / 2, mean = (one + other) / 2;
        other = std::sqrt(one * other);
        one = mean;
        sum += weight * difference * difference;
      }
      return {pi / (2 * one), pi / (2 * one) * (1 - sum)};
    };
    // Near a circle the equation loses its digits, and k is (R_y/R_x)^(2/3).
    const double k = ratio < 1 + 1e-5
                         ? std::pow(ratio, 2.0 / 3)
                         : root(
                               [&](double trial) {
                                 const auto [first, second] = integrals(trial);
                                 return trial * trial * second - first - ratio * (first - second);
                               },
                               std::sqrt(ratio), std::pow(ratio, 0.8));
    const auto [first, second] = integrals(k);
    const double reduced = 1 / (1 / a[2] + 1 / a[3]);
    const double minor = power(3 * second * a[0] * reduced / (pi * k * a[1]), 1.0 / 3),
                 major = k * minor;
    const double mean = a[0] / (pi * minor * major);
    return {is_exchanged ? major : minor,
            is_exchanged ? minor : major,
            is_exchanged ? 1 / k : k,
            mean,
            1.5 * mean,
            minor * minor * first / (2 * reduced * second)};
  };
}

Formula subsurface_shear(Draw& draw) {
  const bool by_stresses = draw.any(2) == 0;
  const double unit = draw.unit();
  return [=](const Arguments& a) -> Answers {
    const double depth = a[2] / unit / (a[1] / unit), q = 1 / (1 + depth * depth);
    const double arc = depth > 0 ? std::atan(1 / depth) : pi / 2;
    const double radial = -(1 + a[3]) * (1 - depth * arc) + q / 2, axial = -q;
    if (by_stresses) return {a[0] * std::abs(radial - axial) / 2};
    return {a[0] * std::abs(0.75 * q - (1 + a[3]) / 2 * (1 - depth * arc))};
  };
}

Formula moes_line(Draw& draw) {
  const auto power = draw.power();
  return [=](const Arguments& x) -> Answers {
    const double modulus = 2 * x[4], u2 = 2 * x[0] * x[1] / (modulus * x[5]);
    const double m = x[3] / (modulus * x[5]) / std::sqrt(u2), l = x[2] * modulus * power(u2, 0.25);
    const double ri = 3 / m, ei = 2.621 * power(m, -0.2), rp = 1.287 * power(l, 2.0 / 3),
                 ep = 1.311 * power(m, -0.125) * power(l, 0.75);
    const double s = 1.4 + 1.6 * std::exp(-2 * ei / ri);
    const double rigid = power(power(ri, 7.0 / 3) + power(ei, 7.0 / 3), 3 * s / 7);
    const double thick = power(power(rp, -3.5) + power(ep, -3.5), -2 * s / 7);
    return {power(rigid + thick, 1 / s) * x[5] * std::sqrt(u2)};
  };
}

Formula moes_point(Draw& draw) {
  const auto power = draw.power();
  return [=](const Arguments& x) -> Answers {
    const double modulus = 2 * x[4], u2 = 2 * x[0] * x[1] / (modulus * x[5]), d = x[5] / x[6];
    const double m = x[3] / (modulus * x[5] * x[5]) / power(u2, 0.75),
                 l = x[2] * modulus * power(u2, 0.25);
    const double q = 1 + 0.006 * std::log(d) + 0.63 * power(d, 4.0 / 7);
    const double ri = 145 / (power(1 + 0.796 * power(d, 14.0 / 15), 15.0 / 7) * d * m * m),
                 ei = 3.18 / (power(q, 0.56) * power(d, 1.0 / 15) * power(m, 2.0 / 15)),
                 rp = 1.29 * power(l / (1 + 0.691 * d), 2.0 / 3),
                 ep = 1.48 * power(l, 0.75) / (power(q, 0.35) * power(d * m * m, 1.0 / 24));
    const double s = 1.5 + 1.5 * std::exp(-1.2 * ei / (x[7] == 0 ? ri : ep));
    const double limited = power(ei, -4) + power(d / 1.8, 4);
    const double rigid = x[8] == 0
                             ? power(power(ri, 1.5) + power(limited, -0.375), 2 * s / 3)
                             : power(power(ri, 1.5 * s) + power(limited, -0.375 * s), 2 / (3 * s));
    const double thick = power(power(rp, -8) + power(ep, -8), -s / 8);
    return {power(rigid + thick, 1 / s) * x[5] * std::sqrt(u2)};
  };
}

Formula regime_film(Draw& draw) {
  const auto power = draw.power();
  return [=](const Arguments& x) -> Answers {
    switch (static_cast<int>(x[0])) {
      case 0: {
        const double phi = 3 * x[3] / (3 * x[3] + 2);
        return {128 * x[3] * power(phi * (0.131 * std::atan2(x[3], 2.0) + 1.683), 2)};
      }
      case 1:
        return {1.66 * power(x[1], 2.0 / 3) * -std::expm1(-0.68 * x[4])};
      case 2:
        return {141 * power(x[1], 0.375) * -std::expm1(-0.0387 * x[3])};
      case 3:
        return {8.7 * power(x[2], 0.67) * (1 - 0.85 * power(std::numbers::e, -0.31 * x[4]))};
      default:
        return {3.42 * power(x[1], 0.49) * power(x[2], 0.17) * -std::expm1(-0.68 * x[4])};
    }
  };
}

Formula starvation(Draw& draw) {
  const auto root = draw.root();
  const auto power = draw.power();
  return [=](const Arguments& x) -> Answers {
    const auto closure = static_cast<StarvationClosure>(static_cast<int>(x[0]));
    if (closure == StarvationClosure::damiens) {
      const double r = x[1], g = x[2];
      return {r <= 1 ? power(1 + power(r, g), -1 / g) : power(1 + power(1 / r, g), -1 / g) / r};
    }
    if (closure == StarvationClosure::flooded_inlet && x[1] >= 1) return {0};
    // The unknown is ln ψ, from which y = (2/π) atan(2.7ψ) follows.
    const auto excess = [&](double log_psi) {
      const double psi = std::exp(log_psi), y = 2 / pi * std::atan(2.7 * psi);
      const double crook = power(psi, 1.5) * 4 * std::numbers::sqrt2 / 3;
      const double other = closure == StarvationClosure::flooded_inlet ? 1 : y;
      return std::log(
          x[1] * (other + (closure == StarvationClosure::printed_exponents ? crook * power(y, -1.25)
                                                                           : crook)));
    };
    return {2 / pi * std::atan(2.7 * std::exp(root(excess, -200, 100)))};
  };
}

double moment(
    double order, double d,
    const std::function<double(const std::function<double(double)>&, double, double)>& integral) {
  if (order == 0) return std::erfc(d / std::numbers::sqrt2) / 2;
  // With t² = s − d, so that half orders are smooth.
  const double begin = std::sqrt(std::max(0.0, -9 - d));
  const double end = std::sqrt(std::max(0.0, -d) + 40 / (std::max(d, 0.0) + 4));
  return integral(
      [=](double t) {
        const double s = d + t * t;
        return 2 * std::pow(t, 2 * order + 1) * std::exp(-s * s / 2) / std::sqrt(2 * pi);
      },
      begin, end);
}
Formula gaussian_moment(Draw& draw) {
  const auto integral = draw.integral(10);
  return [=](const Arguments& x) -> Answers { return {moment(x[0], x[1], integral)}; };
}

Formula roelands(Draw& draw) {
  const int constant = draw.any(3), way = draw.any(2);
  const double pole =
      std::array{9.67, -std::log(6.31e-5), -std::log(6.315e-5)}[static_cast<std::size_t>(constant)];
  const double base = draw.between(2, 20);
  return [=](const Arguments& x) -> Answers {
    const double scale = std::log(x[0]) + pole, z = x[1] * 1.96e8 / scale;
    const double rise = std::pow(1 + x[2] / 1.96e8, z);
    if (way == 0) return {std::pow(base, (std::log(x[0]) + scale * (rise - 1)) / std::log(base))};
    return {std::exp(-pole) * std::exp(scale * rise)};
  };
}
Formula astm_d341(Draw& draw) {
  const double base = draw.between(2, 20), inner = draw.between(2, 20);
  return [=](const Arguments& x) -> Answers {
    const auto log_to = [](double number, double to) { return std::log(number) / std::log(to); };
    const auto z = [&](double viscosity) {
      return log_to(log_to(1e6 * viscosity + 0.7, inner), base);
    };
    const double slope = (z(x[1]) - z(x[3])) / (log_to(x[2], base) - log_to(x[0], base));
    const double height = z(x[1]) - slope * (log_to(x[4], base) - log_to(x[0], base));
    return {(std::pow(inner, std::pow(base, height)) - 0.7) / 1e6};
  };
}
Formula viscosity_index(Draw& draw) {
  const double base = draw.between(2, 20);
  return [=](const Arguments& x) -> Answers {
    const auto oils = detail::index_oils(x[1]);
    const double u = 1e6 * x[0];
    if (u >= oils.hundred) return {100 * (1 - (u - oils.hundred) / (oils.zero - oils.hundred))};
    const double n = (std::log(oils.hundred) - std::log(u)) / std::log(1e6 * x[1]);
    return {100 + (std::pow(base, n * std::log(10) / std::log(base)) - 1) / 0.00715};
  };
}
Formula kogut_etsion(Draw& draw) {
  const auto power = draw.power();
  return [=](const Arguments& x) -> Answers {
    const double w = x[0];
    return {w < 1 ? power(w, 1.5) : w < 6 ? 1.03 * power(w, 1.425) : 1.4 * power(w, 1.263)};
  };
}
Formula persson(Draw& draw) {
  const double unit = draw.unit();
  return [=](const Arguments& x) -> Answers {
    const double p = x[0] * unit / (x[1] * unit * x[2]);
    return {std::erf(2 * p / std::numbers::sqrt2)};
  };
}
Formula load_sharing(Draw& draw) {
  const auto integral = draw.integral(5);
  const auto root = draw.root();
  return [=](const Arguments& x) -> Answers {
    const double order = x[0] == 0 ? 2.5 : 1.5, q = x[0] == 0 ? 0.5 : 1;
    const auto share = [&](double lambda) {
      return std::pow(x[2] * moment(order, lambda - x[3], integral), q);
    };
    const auto excess = [&](double lambda) {
      const double a = share(lambda);
      return a >= 1 ? -1000 - a / (1 + a) : std::log(lambda / x[1]) + 0.14 * std::log1p(-a);
    };
    return {root(excess, x[1] * (1 - 1e-12), x[1] + x[3] + 60)};
  };
}

// --- Single expressions, rearranged by machine

enum class Op { number, input, sum, product, power, exponential, logarithm };
struct Node;
struct Tree {
  std::shared_ptr<const Node> node;
  Tree(double number);  // implicit: numbers stand in expressions as they are
  explicit Tree(Node&& made);
};
struct Node {
  Op op;
  double number;  // its value, the place of an input, or the exponent of a power
  std::vector<Tree> of = {};
};
Tree::Tree(double number) : Tree(Node{Op::number, number}) {}
Tree::Tree(Node&& made) : node(std::make_shared<const Node>(std::move(made))) {}

Tree input(int place) { return Tree(Node{Op::input, static_cast<double>(place)}); }
Tree power(const Tree& x, double n) { return Tree(Node{Op::power, n, {x}}); }
Tree exponential(const Tree& x) { return Tree(Node{Op::exponential, 0, {x}}); }
Tree logarithm(const Tree& x) { return Tree(Node{Op::logarithm, 0, {x}}); }
Tree operator+(const Tree& a, const Tree& b) { return Tree(Node{Op::sum, 0, {a, b}}); }
Tree operator*(const Tree& a, const Tree& b) { return Tree(Node{Op::product, 0, {a, b}}); }
Tree operator-(const Tree& a, const Tree& b) { return a + Tree(-1) * b; }
Tree operator/(const Tree& a, const Tree& b) { return a * power(b, -1); }

double value(const Tree& tree, const Arguments& x) {
  const Node& node = *tree.node;
  const auto of = [&](std::size_t place) { return value(node.of[place], x); };
  switch (node.op) {
    case Op::number:
      return node.number;
    case Op::input:
      return x[static_cast<std::size_t>(node.number)];
    case Op::sum:
      return of(0) + of(1);
    case Op::product:
      return of(0) * of(1);
    case Op::power:
      return node.number == -1 ? 1 / of(0) : std::pow(of(0), node.number);
    case Op::exponential:
      return std::exp(of(0));
    default:
      return std::log(of(0));
  }
}

enum class Rule { commute, distribute, split_powers, invert, any };
constexpr std::array rules{Rule::commute, Rule::distribute, Rule::split_powers, Rule::invert,
                           Rule::any};

// The same expression, with the rule applied at about half of the places where it can be.
Tree rearranged(const Tree& tree, Rule rule, Draw& draw) {
  Node node = *tree.node;
  for (Tree& one : node.of) one = rearranged(one, rule, draw);
  if (rule == Rule::any) rule = rules[static_cast<std::size_t>(draw.any(4))];
  if (draw.any(2) == 0) return Tree(std::move(node));
  const bool is_sum = node.op == Op::sum, is_product = node.op == Op::product;
  if (rule == Rule::commute && (is_sum || is_product)) {
    std::swap(node.of[0], node.of[1]);  // c + (a + b) to a + (b + c)
    if (const Node& inner = *node.of[1].node; inner.op == node.op)
      return Tree(
          Node{node.op, 0, {inner.of[0], Tree(Node{node.op, 0, {inner.of[1], node.of[0]}})}});
  }
  if (rule == Rule::distribute && is_product)  // a (b + c)
    for (const std::size_t place : {0U, 1U})
      if (const Node& sum = *node.of[place].node; sum.op == Op::sum)
        return node.of[1 - place] * sum.of[0] + node.of[1 - place] * sum.of[1];
  const double part = draw.between(0.1, 0.9);
  if (rule == Rule::split_powers && node.op == Op::power) {  // x^n, (b c)^n
    const Tree x = node.of[0];
    if (x.node->op == Op::product && draw.any(2) == 0)
      return power(x.node->of[0], node.number) * power(x.node->of[1], node.number);
    return power(x, part * node.number) * power(x, node.number - part * node.number);
  }
  if (rule == Rule::split_powers && node.op == Op::exponential)  // e^x, by another base
    return power(exponential(part * node.of[0]), 1 / part);
  if (rule == Rule::invert && node.op == Op::power)  // 1/x^n, or (1/x)^n
    return draw.any(2) == 0 ? power(power(node.of[0], -node.number), -1)
                            : power(power(node.of[0], -1), -node.number);
  return Tree(std::move(node));
}

Tree film(const catalogue::Function& function) {
  const FilmLaw& law = *function.film_law;
  const auto number = [](const Fraction& one) { return static_cast<double>(one.p) / one.q; };
  const bool is_soft = function.parameters[2].name != "pressure_viscosity";
  const int load = is_soft ? 2 : 3;
  const Tree modulus = 2 * input(load + 1), radius = input(load + 2);
  const Tree u = input(0) * input(1) / (modulus * radius);
  const Tree w = input(load) / (modulus * (law.is_of_lines ? radius : radius * radius));
  const Tree g = is_soft ? Tree(1) : input(2) * modulus;
  const Tree side =
      law.is_of_lines
          ? Tree(1)
          : 1 - number(law.side_leakage) * exponential(-number(law.side_decay) * input(load + 3));
  return radius * number(law.constant) * power(u, number(law.speed_exponent)) *
         power(g, number(law.material_exponent)) * power(w, number(law.load_exponent)) * side;
}

// The expressions of each function's results.
std::map<std::string_view, std::vector<Tree>> expressions() {
  const auto x = input;
  const auto compliance = [&](int of) { return (1 - x(of + 1) * x(of + 1)) / x(of); };
  const Tree radius = power(0.75 * x(0) * x(2) / x(1), 1.0 / 3);
  const Tree mean = x(0) / (pi * radius * radius);
  const Tree heat = x(3) * x(4) * x(5) * x(5) / x(6);
  const Tree half = power(4 * x(0) * x(2) / (pi * x(1)), 0.5), line_peak = 2 * x(0) / (pi * half);
  const Tree pull = 3 * pi * x(1) * x(3);
  const Tree number = exponential(x(4) * logarithm(x(2) * x(3)));  // (λγ̇)^a, 0 at rest
  const Tree thinned = exponential((x(5) - 1) / x(4) * logarithm(1 + number));
  std::map<std::string_view, std::vector<Tree>> all{
      {"effective_modulus", {1 / (compliance(0) + compliance(2))}},
      {"hertz_point", {radius, mean, 1.5 * mean, radius * radius / x(2)}},
      {"hertz_line", {half, x(0) / (2 * half), line_peak, 0.30028310002449186 * line_peak}},
      {"jkr_radius",
       {power(0.75 * x(3) / x(2) * (x(0) + pull + power(pull * (2 * x(0) + pull), 0.5)), 1.0 / 3)}},
      {"pull_off_force", {(1.5 + 0.5 * x(0)) * pi * x(1) * x(2)}},  // JKR, then DMT
      {"carreau_yasuda_viscosity", {x(1) + (x(0) - x(1)) * thinned}},
      {"gupta_thermal_reduction",
       {(1 - 6.6 * x(0) / x(1) * power(heat, 0.42)) /
        (1 + 0.213 * (1 + 2.23 * power(x(2), 0.83)) * power(heat, 0.64))}},
      {"murch_wilson_thermal_reduction",
       {3.94 / (3.94 + power(x(0) * x(1) * x(2) * x(2) / x(3), 0.62))}},
      {"dowson_higginson_density", {(5.9e8 + 1.34 * x(0)) / (5.9e8 + x(0))}},
      {"barus_viscosity", {x(0) * exponential(x(1) * x(2))}},
      {"summits_from_spectral_moments",
       {x(0) * x(2) / (x(1) * x(1)), x(2) / (6 * pi * std::sqrt(3) * x(1)),
        0.375 * power(pi / x(2), 0.5), power(x(0) - 0.8968 * x(1) * x(1) / x(2), 0.5),
        4 / power(pi * (x(0) * x(2) / (x(1) * x(1)) - 0.8968), 0.5)}},
      {"plasticity_index", {x(0) / x(1) * power(x(2) / x(3), 0.5)}},
      {"patir_cheng_pressure_flow", {1 - 0.9 * exponential(-0.56 * x(0))}},
      {"lambda_ratio",
       {power(x(1) * x(1) + x(2) * x(2), 0.5), x(0) / power(x(1) * x(1) + x(2) * x(2), 0.5)}}};
  for (const catalogue::Function& function : catalogue::functions())
    if (function.film_law != nullptr) all.try_emplace(function.name, std::vector{film(function)});
  return all;
}

struct Kind {
  std::string_view function;
  Formula (*draw)(Draw&);
};
constexpr Kind kinds[] = {
    {"reduced_radius", reduced_radius},       {"hertz_ellipse", hertz_ellipse},
    {"subsurface_shear", subsurface_shear},   {"moes_line", moes_line},
    {"nijenbanning_venner_moes", moes_point}, {"regime_film", regime_film},
    {"starvation_ratio", starvation},         {"gaussian_moment", gaussian_moment},
    {"roelands_viscosity", roelands},         {"astm_d341_viscosity", astm_d341},
    {"viscosity_index", viscosity_index},     {"kogut_etsion_load", kogut_etsion},
    {"persson_contact_area", persson},        {"load_sharing", load_sharing}};

// The verdicts on a solver that offers this function alone, by the formula.
ConformanceResult verdict_on(const catalogue::Function& function, const Formula& formula) {
  std::vector<TestCase> cases;
  Conversation conversation;
  for (const TestCase& one : cases_of(function.name)) {
    const Answers answers = formula(question_of(one).arguments);
    nlohmann::json fields;
    for (std::size_t i = 0; i < function.results.size(); ++i)
      fields[std::string(function.results[i].name)] = answers.at(i);
    cases.push_back(one);
    conversation.answers.push_back({Outcome::answered, std::move(fields), {}});
  }
  take_readings(cases, conversation, engineering_tolerance(), {});
  return judge("reformulation", cases, std::move(conversation), engineering_tolerance());
}

void expect_held(const catalogue::Function& function, const Formula& formula, int number) {
  for (const QuantityVerdict& one : verdict_on(function, formula).quantities) {
    if (one.quantity.substr(0, one.quantity.find('.')) != function.name) continue;
    EXPECT_EQ(one.status, Verdict::held)
        << one.quantity << ", way " << number << ": " << one.worst.request.dump() << '\n'
        << expected_text(one.worst.expected, one.worst.allowed) << ", got " << got_text(one.worst);
    EXPECT_GT(one.judged(), 0U) << one.quantity;
  }
}

constexpr int ways_of_each = 110;

TEST(Reformulations, OfEachFunctionAreHeldInEachOfTheirWays) {
  for (const Kind& kind : kinds)
    for (int number = 0; number < ways_of_each && !HasFailure(); ++number) {
      Draw draw{std::mt19937_64(static_cast<unsigned>(number))};
      expect_held(*catalogue::function_named(kind.function), kind.draw(draw), number);
    }
}

Formula formula_of(const std::vector<Tree>& results, Rule rule, Draw& draw) {
  std::vector<Tree> trees;
  for (const Tree& one : results) trees.push_back(rearranged(one, rule, draw));
  return [trees](const Arguments& x) {
    Answers answers;
    for (const Tree& one : trees) answers.push_back(value(one, x));
    return answers;
  };
}

TEST(Reformulations, OfExpressionsRearrangedByMachineAreHeld) {
  constexpr std::size_t points = 14;
  std::map<Rule, std::set<Answers>> different;  // answers that differ in any digit
  for (const auto& [name, results] : expressions())
    for (const Rule rule : rules)
      for (int number = 0; number < ways_of_each && !HasFailure(); ++number) {
        Draw draw{std::mt19937_64(static_cast<unsigned>(number))};
        const catalogue::Function& function = *catalogue::function_named(name);
        const Formula formula = formula_of(results, rule, draw);
        Arguments x = function.example;
        for (std::size_t i = 0; i < points; ++i) {
          for (double& one : x) one *= 1.03;
          different[rule].insert(formula(x));
        }
        expect_held(function, formula, number);
      }
  // Without rearrangement there would be no more answers than the number on the right.
  for (const Rule rule : rules)
    EXPECT_GT(different[rule].size(), points * expressions().size()) << static_cast<int>(rule);
}

TEST(Reformulations, AreNotHeldWithAnErrorOfATenThousandth) {
  Draw draw{std::mt19937_64(1)};
  std::map<std::string_view, Formula> all;
  for (const auto& [name, results] : expressions())
    all[name] = formula_of(results, Rule::any, draw);
  for (const Kind& kind : kinds) all[kind.function] = kind.draw(draw);
  for (const auto& one : all) {
    const Formula& right = one.second;
    const auto result = verdict_on(*catalogue::function_named(one.first), [&](const Arguments& x) {
      Answers answers = right(x);
      for (double& answer : answers) answer *= 1 + 1e-4;
      return answers;
    });
    const auto accused =
        std::count_if(result.quantities.begin(), result.quantities.end(),
                      [](const QuantityVerdict& each) { return each.status == Verdict::failed; });
    EXPECT_GT(accused, 0) << one.first;
  }
}

TEST(Reformulations, CoverAllFunctions) {
  const auto all = expressions();
  for (const catalogue::Function& function : catalogue::functions()) {
    const auto ways = std::count_if(std::begin(kinds), std::end(kinds),
                                    [&](const Kind& one) { return one.function == function.name; });
    EXPECT_GE(static_cast<std::size_t>(ways) + all.count(function.name), 1U) << function.name;
  }
}

}  // namespace
}  // namespace tribo::conformance
