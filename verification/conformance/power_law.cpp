// SPDX-License-Identifier: Apache-2.0
#include "conformance/power_law.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tribo::conformance {
namespace {

struct Sample {
  const AnsweredCase* one;
  double number;
};

// The inputs that a power can be of: numbers above zero.
std::vector<std::size_t> powers_of(const catalogue::Function& function) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < function.parameters.size(); ++i)
    if (function.parameters[i].words.empty() &&
        function.parameters[i].range == catalogue::Range::above_zero)
      places.push_back(i);
  return places;
}

std::optional<PowerLaw> fit(const std::vector<Sample>& samples, std::vector<std::size_t> places,
                            std::size_t parameters) {
  // An input that is the same everywhere says nothing.
  std::erase_if(places, [&](std::size_t place) {
    return std::all_of(samples.begin(), samples.end(), [&](const Sample& one) {
      return one.one->question.arguments[place] == samples.front().one->question.arguments[place];
    });
  });
  const auto rows = static_cast<Eigen::Index>(samples.size());
  const auto columns = static_cast<Eigen::Index>(places.size() + 1);
  if (rows < columns + 3) return std::nullopt;
  Eigen::MatrixXd inputs(rows, columns);
  Eigen::VectorXd logarithms(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Sample& sample = samples[static_cast<std::size_t>(i)];
    inputs(i, 0) = 1;
    for (Eigen::Index k = 1; k < columns; ++k)
      inputs(i, k) =
          std::log(sample.one->question.arguments[places[static_cast<std::size_t>(k - 1)]]);
    logarithms(i) = std::log(std::abs(sample.number));
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(inputs);
  if (solver.rank() < columns) return std::nullopt;
  const Eigen::VectorXd found = solver.solve(logarithms);
  PowerLaw law{std::vector<double>(parameters),
               std::copysign(std::exp(found(0)), samples[0].number),
               (inputs * found - logarithms).lpNorm<Eigen::Infinity>()};
  for (std::size_t k = 0; k < places.size(); ++k)
    law.exponents[places[k]] = found(static_cast<Eigen::Index>(k + 1));
  return law;
}

// The value of an argument that most samples have.
double commonest(const std::vector<Sample>& samples, std::size_t place) {
  std::map<double, std::size_t> counts;
  for (const Sample& one : samples) ++counts[one.one->question.arguments[place]];
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

}  // namespace

std::optional<PowerLaw> fit_power_law(const std::vector<AnsweredCase>& cases,
                                      const std::string& branch, std::size_t place,
                                      const NumberOf& number_of, double closeness) {
  if (cases.empty() || cases.front().question.function == nullptr) return std::nullopt;
  const catalogue::Function& function = *cases.front().question.function;
  std::vector<Sample> samples;
  for (const AnsweredCase& one : cases) {
    if (!branch.empty() && one.branch != branch) continue;
    for (const AnsweredNumber& number : one.numbers) {
      if (number.place != place) continue;
      const double value = number_of(one, number);
      if (!std::isfinite(value) || value == 0) return std::nullopt;
      if (!samples.empty() && std::signbit(value) != std::signbit(samples.front().number))
        return std::nullopt;
      samples.push_back({&one, value});
    }
  }
  if (samples.empty()) return std::nullopt;
  const std::vector<std::size_t> places = powers_of(function);
  const auto is_close = [&](const std::optional<PowerLaw>& law) {
    return law && law->residual <= closeness;
  };
  if (const auto law = fit(samples, places, function.parameters.size()); is_close(law)) return law;
  for (const std::size_t held : places) {
    const double value = commonest(samples, held);
    std::vector<Sample> of_value;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(of_value),
                 [&](const Sample& one) { return one.one->question.arguments[held] == value; });
    if (auto law = fit(of_value, places, function.parameters.size()); is_close(law)) {
      law->held = fmt::format("{} = {:.4g}", symbol_of(function.parameters[held]), value);
      return law;
    }
  }
  return std::nullopt;
}

std::string symbol_of(const catalogue::Parameter& parameter) {
  return std::string(parameter.meaning.substr(0, parameter.meaning.find_first_of(", ")));
}

std::string power_in_words(const catalogue::Parameter& parameter, double exponent) {
  for (const int denominator : {1, 2, 3, 4, 6}) {
    const double numerator = exponent * denominator;
    if (std::abs(numerator - std::round(numerator)) > 1e-6 * denominator) continue;
    return denominator == 1
               ? fmt::format("{}^{:+.0f}", symbol_of(parameter), numerator)
               : fmt::format("{}^({:+.0f}/{})", symbol_of(parameter), numerator, denominator);
  }
  return fmt::format("{}^{:+.4g}", symbol_of(parameter), std::round(exponent * 1e5) / 1e5);
}

std::string powers_in_words(const catalogue::Function& function,
                            const std::vector<double>& exponents) {
  std::string text;
  for (std::size_t i = 0; i < exponents.size(); ++i)
    if (std::abs(exponents[i]) > 1e-4)
      text += (text.empty() ? "" : " ") + power_in_words(function.parameters[i], exponents[i]);
  return text;
}

}  // namespace tribo::conformance
