// SPDX-License-Identifier: Apache-2.0
// What is said of wrong solvers. Their formulas are written here anew: nothing is shared with the
// mistakes that the diagnosis knows.
#include "conformance/diagnosis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>

namespace tribo::conformance {
namespace {

using nlohmann::json;

const std::string reference = TRIBOCHECK_SOURCE_DIR "/reference";

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases = cases_for(
      read_cases({reference + "/exact", reference + "/published"}), engineering_tolerance());
  return cases;
}
const std::vector<Mistake>& all_mistakes() {
  static const std::vector<Mistake> mistakes = read_mistakes(reference + "/mistakes.toml");
  return mistakes;
}
std::vector<Case> cases_of(const std::string& function) {
  std::vector<Case> cases = all_cases();
  std::erase_if(cases, [&](const Case& one) { return one.function != function; });
  return cases;
}

using Formula = std::function<json(const json& inputs)>;

// What is said of a solver that has these functions: all its sentences.
std::string said_of(const std::map<std::string, Formula>& functions) {
  std::vector<Case> cases;
  Conversation conversation;
  for (const Case& one : all_cases())
    if (const auto found = functions.find(one.function); found != functions.end()) {
      cases.push_back(one);
      conversation.answers.push_back({Outcome::answered, found->second(one.inputs), {}});
    }
  std::string said;
  for (const Diagnosis& one :
       diagnose(cases, conversation, engineering_tolerance(), all_mistakes()))
    said += one.text + '\n';
  return said;
}

std::string said_of(const std::string& function, const Formula& formula) {
  return said_of({{function, formula}});
}

void expect_said(const std::string& said, const std::vector<std::string>& words) {
  for (const std::string& one : words) {
    EXPECT_NE(said.find(one), std::string::npos) << "not said: " << one << "\nsaid: " << said;
  }
}

struct Law {
  double constant = 2.69, a = 0.67, b = 0.53, c = -0.067, leakage = 0.61, decay = 0.73;
};
// A film whose input `changed` was misread.
Formula film(const Law& law, const std::string& changed = "load", double times = 1,
             double modulus = 2) {
  return [=](const json& inputs) {
    const auto of = [&](const std::string& name) {
      return inputs.at(name).get<double>() * (name == changed ? times : 1);
    };
    const double E = modulus * of("effective_modulus"), R = of("reduced_radius");
    const double U = of("viscosity") * of("speed") / (E * R);
    const double G = of("pressure_viscosity") * E, W = of("load") / (E * R * R);
    return json{
        {"value", R * law.constant * std::pow(U, law.a) * std::pow(G, law.b) * std::pow(W, law.c) *
                      (1 - law.leakage * std::exp(-law.decay * of("ellipticity")))}};
  };
}

json hertz(const json& inputs, double modulus, double approach_modulus) {
  const double F = inputs.at("load"), E = inputs.at("effective_modulus");
  const double R = inputs.at("reduced_radius");
  const auto radius = [&](double times) { return std::cbrt(3 * F * R / (4 * times * E)); };
  const double a = radius(modulus), mean = F / (std::numbers::pi * a * a);
  return {{"radius", a},
          {"mean_pressure", mean},
          {"peak_pressure", 1.5 * mean},
          {"approach", std::pow(radius(approach_modulus), 2) / R}};
}

double rounded_moment(double order, double d) {  // of whole orders, in double
  const double tail = (1 - std::erf(d / std::sqrt(2.0))) / 2;
  const double density = std::exp(-d * d / 2) / std::sqrt(2 * std::numbers::pi);
  if (order == 0) return tail;
  return order == 1 ? density - d * tail : (1 + d * d) * tail - d * density;
}

TEST(Said, OfAnEllipticityOf103IsItsFormula) {
  const std::string what = "an ellipticity fitted as 1.03 (R_y/R_x)^0.64";
  expect_said(said_of("hamrock_dowson_central", film({}, "ellipticity", 1.03)), {what});
}

TEST(Said, OfTwoMistakesAreBoth) {
  expect_said(said_of("hamrock_dowson_central",
                      [](const json& inputs) {
                        json misread = inputs;
                        misread["speed"] = inputs.at("speed").get<double>() / 2;
                        return film({}, "ellipticity", 1.03)(misread);
                      }),
              {"two mistakes", "half of the entrainment speed", "1.03 (R_y/R_x)^0.64"});
  expect_said(
      said_of("hamrock_dowson_central", film({.constant = 1.9, .leakage = 0}, "load", 1, 1)),
      {"two mistakes", "the rounded constant 1.9", "E* in place of 2E* in U, G and W"});
  expect_said(
      said_of(
          "hamrock_dowson_central",
          film({.constant = 3.63, .a = 0.68, .b = 0.49, .c = -0.073, .leakage = 1, .decay = 0.68},
               "reduced_radius", 0.5, 1)),
      {"three mistakes", "R/2 in place of R", "E* in place of 2E* in U, G and W",
       "the minimum film"});
}

TEST(Said, OfOtherExponentsAreTheExponents) {
  expect_said(said_of("hamrock_dowson_central", film({.b = 0, .c = 0.49})),
              {"It goes as F^+0.49; the law has F^-0.067.",
               "It does not depend on α; the law has α^+0.53.", "U^+0.67 G^+0 W^+0.49"});
}

TEST(Said, OfAnotherLawsExponentsIsThatLaw) {
  expect_said(
      said_of(
          "hamrock_dowson_central",
          film({.constant = 5, .a = 0.68, .b = 0.49, .c = -0.073, .leakage = 1, .decay = 0.68})),
      {"u^+0.68", "α^+0.49", "the minimum film", "Its constant is 1.37741 times"});
}

TEST(Said, OfAnotherApproachIsItsFormulaOrItsExponents) {
  const auto approach = [](double part) {
    return [part](const json& inputs) {
      json results = hertz(inputs, 1, 1);
      results["approach"] = std::pow(results["radius"].get<double>(), 3) * part /
                            inputs.at("reduced_radius").get<double>();
      return results;
    };
  };
  expect_said(said_of("hertz_point", approach(1.0 / 3)), {"a³/(3R) in place of the approach a²/R"});
  expect_said(said_of("hertz_point", approach(0.2)),
              {"F^+1 E*^-1", "a³/(3R)", "Its constant is 0.6 times"});
}

TEST(Said, OfAnotherModulusInTheApproachIsBoth) {
  expect_said(said_of("hertz_point", [](const json& inputs) { return hertz(inputs, 1, 2); }),
              {"2E* in place of E* in the approach alone"});
  expect_said(said_of("hertz_point", [](const json& inputs) { return hertz(inputs, 2, 1); }),
              {"2E* in place of E* in the radius and the pressures, not in the approach"});
}

// E′ = 2E* is what this solver means by an effective modulus, and takes it as such.
TEST(Said, OfAConventionIsSaidOnce) {
  const std::string said =
      said_of({{"effective_modulus",
                [](const json& in) {
                  const auto of = [&](const char* name) { return in.at(name).get<double>(); };
                  const double first =
                      (1 - std::pow(of("first_poisson_ratio"), 2)) / of("first_modulus");
                  return json{{"value", 2 / (first + (1 - std::pow(of("second_poisson_ratio"), 2)) /
                                                         of("second_modulus"))}};
                }},
               {"hertz_point", [](const json& in) { return hertz(in, 0.5, 0.5); }},
               {"hamrock_dowson_central", film({}, "load", 1, 1)}});
  expect_said(said,
              {"2E* in place of E* (E′ of the film formulas is 2E*)",
               "hertz_point.radius is 26 % high everywhere. This follows from effective_modulus",
               "hamrock_dowson_central is 5.19 % high everywhere. This follows from"});
  EXPECT_EQ(said.find("E*/2 in place of E*"), std::string::npos) << said;
}

// Order 3/2 has the other sign, order 1 loses its digits, the others are not offered.
TEST(Said, OfBranchesIsSaidOfEachAlone) {
  std::map<std::string, double> right;
  for (const Case& one : cases_of("gaussian_moment"))
    right[one.inputs.dump()] = one.expected[0].high;
  const std::string said = said_of("gaussian_moment", [&](const json& inputs) {
    const double order = inputs.at("order");
    if (order == 1.5) return json{{"value", -right.at(inputs.dump())}};
    if (order != 1) return json{{"value", right.at(inputs.dump())}};
    return json{{"value", rounded_moment(order, inputs.at("argument"))}};
  });
  expect_said(said, {"For order 1.5: ", "−1 times the right value", "another sign convention",
                     "order 1: ", "right up to d = ", "digits cancel there"});
}

TEST(Said, OfATailThatIsWrongIsWhereItBegins) {
  std::map<std::string, double> right;
  for (const Case& one : cases_of("gaussian_moment"))
    right[one.inputs.dump()] = one.expected[0].high;
  expect_said(said_of("gaussian_moment",
                      [&](const json& inputs) {
                        const double value = right.at(inputs.dump());
                        const double d = inputs.at("argument");
                        const bool is_off = inputs.at("order") == 0.5 && (d < -21 || d > 5.1);
                        return json{{"value", is_off ? value * (1 + d * d) : value}};
                      }),
              {"order 0.5: ", "right from d = -21", " to 5, wrong below and beyond"});
}

TEST(Said, OfAQuadratureOfTooFewPointsIsItsPattern) {
  const auto trapezoids = [](const json& inputs) {
    const double order = inputs.at("order"), d = inputs.at("argument");
    constexpr int count = 300;
    const double h = (12 + std::max(0.0, -d)) / count;
    double sum = order == 0 ? std::exp(-d * d / 2) / 2 : 0;
    for (int i = 1; i < count; ++i)
      sum += std::pow(i * h, order) * std::exp(-(d + i * h) * (d + i * h) / 2);
    return json{{"value", sum * h / std::sqrt(2 * std::numbers::pi)}};
  };
  expect_said(said_of("gaussian_moment", trapezoids), {"as of a quadrature"});
}

TEST(Said, OfSinglePrecisionIsThat) {
  expect_said(
      said_of("hertz_point",
              [](const json& inputs) {
                json results = hertz(inputs, 1, 1);
                for (json& one : results)
                  one = static_cast<double>(static_cast<float>(one.get<double>() * (1 + 3e-6)));
                return results;
              }),
      {"in single precision"});
}

// Right answers with noise up to 1e-9, in other units and by other formulas inside.
TEST(Said, OfRightSolversIsNothingInAThousandTries) {
  std::mt19937_64 random(20261123);
  std::uniform_real_distribution<double> noise(-1e-9, 1e-9), exponent(-9, 9);
  const auto films = cases_of("hamrock_dowson_central"), contacts = cases_of("hertz_point");
  const std::vector<Case>& others = all_cases();
  for (int i = 0; i < 1000; ++i) {
    std::vector<Case> cases;
    Conversation conversation;
    const auto add = [&](const Case& asked, json fields) {
      for (json& one : fields)
        if (one.is_number()) one = one.get<double>() * (1 + noise(random));
      cases.push_back(asked);
      conversation.answers.push_back({Outcome::answered, std::move(fields), {}});
    };
    // Films from logarithms, contacts in other units of length and force.
    const double metre = std::pow(10, exponent(random)), newton = std::pow(10, exponent(random));
    for (std::size_t k = static_cast<std::size_t>(i) % 5; k < films.size(); k += 5) {
      const json& in = films[k].inputs;
      const auto log_of = [&](const char* name) { return std::log(in.at(name).get<double>()); };
      const double modulus = std::log(2.0) + log_of("effective_modulus");
      const double radius = log_of("reduced_radius");
      const double bracket = 1 - 0.61 * std::exp(-0.73 * in.at("ellipticity").get<double>());
      add(films[k],
          {{"value",
            std::exp(std::log(2.69 * bracket) + 0.67 * (log_of("viscosity") + log_of("speed")) +
                     0.53 * log_of("pressure_viscosity") - 0.067 * log_of("load") +
                     (0.53 - 0.67 + 0.067) * modulus + (1 - 0.67 + 0.134) * radius)}});
    }
    for (std::size_t k = static_cast<std::size_t>(i) % 4; k < contacts.size(); k += 4) {
      json in = contacts[k].inputs;
      in["load"] = in["load"].get<double>() * newton;
      in["reduced_radius"] = in["reduced_radius"].get<double>() * metre;
      in["effective_modulus"] = in["effective_modulus"].get<double>() * newton / metre / metre;
      json results = hertz(in, 1, 1);
      for (const char* const length : {"radius", "approach"})
        results[length] = results[length].get<double>() / metre;
      for (const char* const pressure : {"mean_pressure", "peak_pressure"})
        results[pressure] = results[pressure].get<double>() * metre * metre / newton;
      add(contacts[k], std::move(results));
    }
    for (std::size_t k = static_cast<std::size_t>(i) % 97; k < others.size(); k += 97) {
      if (others[k].function == "hamrock_dowson_central" || others[k].function == "hertz_point")
        continue;
      json fields;
      for (const Expected& one : others[k].expected)
        fields[one.field] = one.is_undefined    ? json(nullptr)
                            : !one.word.empty() ? json(one.word)
                                                : json(one.high);
      add(others[k], std::move(fields));
    }
    const auto found = diagnose(cases, conversation, engineering_tolerance(), all_mistakes());
    EXPECT_TRUE(found.empty()) << "try " << i << ": " << found.front().text;
    EXPECT_EQ(judge("", cases, conversation, engineering_tolerance()).overall, Overall::complete);
  }
}

}  // namespace
}  // namespace tribo::conformance
