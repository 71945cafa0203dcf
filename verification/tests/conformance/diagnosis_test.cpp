// SPDX-License-Identifier: Apache-2.0
// Diagnoses of wrong solvers. The solvers' formulas are written here anew and share nothing with
// the mistakes that the diagnosis knows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <random>

#include "conformance/answers.hpp"
#include "conformance/question.hpp"
#include "support/threshold.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;

using Formula = std::function<json(const json& inputs)>;

// All sentences of the diagnosis of a solver that has these functions.
std::string said_of(const std::map<std::string, Formula>& functions) {
  const auto answer = [&](const TestCase& one) {
    const auto found = functions.find(one.function);
    return found == functions.end() ? json() : found->second(one.inputs);
  };
  return all_said(answer);
}

std::string said_of(const std::string& function, const Formula& formula) {
  return said_of({{function, formula}});
}

void expect_all(const std::string& said, const std::vector<std::string>& words) {
  for (const std::string& one : words) expect_said(said, one);
}

struct Law {
  double constant = 2.69, a = 0.67, b = 0.53, c = -0.067, leakage = 0.61, decay = 0.73;
};
// A film formula that takes its input `changed` wrongly.
Formula film(const Law& law, const std::string& changed = "load", double times = 1,
             double modulus = 2) {
  return [=](const json& inputs) {
    const auto of = [&](const std::string& name) {
      return inputs.value(name, 1.0) * (name == changed ? times : 1);
    };
    const double E = modulus * of("effective_modulus"), R = of("reduced_radius");
    const double U = of("viscosity") * of("speed") / (E * R);
    const double G = of("pressure_viscosity") * E, W = of("load") / (E * R * R);
    return json{
        {"value", R * law.constant * std::pow(U, law.a) * std::pow(G, law.b) * std::pow(W, law.c) *
                      (1 - law.leakage * std::exp(-law.decay * of("ellipticity")))}};
  };
}

json hertz(const json& inputs, double modulus = 1) {
  const double F = inputs.at("load"), E = modulus * inputs.at("effective_modulus").get<double>();
  const double R = inputs.at("reduced_radius");
  const double a = std::cbrt(3 * F * R / (4 * E)), mean = F / (std::numbers::pi * a * a);
  return {{"radius", a},
          {"mean_pressure", mean},
          {"peak_pressure", 1.5 * mean},
          {"approach", a * a / R}};
}

double rounded_moment(double order, double d) {  // for whole orders, in double
  const double tail = (1 - std::erf(d / std::sqrt(2.0))) / 2;
  const double density = std::exp(-d * d / 2) / std::sqrt(2 * std::numbers::pi);
  if (order == 0) return tail;
  return order == 1 ? density - d * tail : (1 + d * d) * tail - d * density;
}

// Points that leave this word out are answered as if they had another word.
TEST(Said, OfAWordsDefaultIsWhereItIsLeftOut) {
  const auto said_with = [](const char* word, void (*change)(Scene&, std::size_t count)) {
    std::size_t count = 0;
    return said_of("operating_point", [=](const json& inputs) mutable {
      Scene scene = *parse_scene_json(inputs.dump(), "case", SceneUse::one_speed).scene;
      if (!inputs.contains(json::json_pointer(word))) change(scene, count++);
      const auto numbers = numbers_of(MixedContact<double>(scene).solve(scene.speeds[0]));
      json fields;
      for (std::size_t i = 0; i < numbers.size(); ++i)
        if (!output_infos[i].is_of_smooth_contact)
          fields[std::string(output_infos[i].name)] =
              std::isfinite(numbers[i]) ? json(numbers[i]) : json();
      return fields;
    });
  };
  const std::string words = " where it is left out";
  expect_all(said_with("/closures/starvation",
                       [](Scene& scene, std::size_t) {
                         scene.closures.starvation = StarvationClosure::starved_inlet;
                       }),
             {"`closures.starvation` = starved_inlet" + words});
  expect_all(said_with("/closures/asperity",
                       [](Scene& scene, std::size_t) {
                         scene.closures.asperity = AsperityModel::greenwood_williamson;
                       }),
             {"`closures.asperity` = greenwood_williamson" + words});
  expect_all(said_with("/friction/viscosity",
                       [](Scene& scene, std::size_t) {
                         scene.friction.viscosity = ViscosityLaw::ambient;
                       }),
             {"`friction.viscosity` = ambient" + words});
  // Only some of these points are answered with another word.
  const std::string some = said_with("/friction/viscosity", [](Scene& scene, std::size_t count) {
    if (count % 2 == 0) scene.friction.viscosity = ViscosityLaw::ambient;
  });
  expect_said(some, words, false);
}

TEST(Said, OfTwoMistakesAreBoth) {
  expect_all(said_of("hamrock_dowson_central", film({.constant = 1.9, .leakage = 0}, "load", 1, 1)),
             {"two mistakes", "the rounded constant 1.9", "E* in place of 2E* in U, G and W"});
  expect_all(
      said_of(
          "hamrock_dowson_central",
          film({.constant = 3.63, .a = 0.68, .b = 0.49, .c = -0.073, .leakage = 1, .decay = 0.68},
               "reduced_radius", 0.5, 1)),
      {"three mistakes", "R/2 in place of R", "E* in place of 2E* in U, G and W",
       "the minimum film"});
}

// The half-width alone would also be right with a mistake that leaves the pressures as they are.
TEST(Said, OfTwoMistakesIsOfAllResults) {
  const std::string said = said_of("hertz_line", [](const json& inputs) {
    const double per_length = inputs.at("load_per_length"), E = inputs.at("effective_modulus");
    const double b = std::sqrt(8 * per_length * inputs.at("reduced_radius").get<double>() /
                               (std::numbers::pi * E));
    const double mean = per_length / (2 * b);
    return json{{"half_width", b},
                {"mean_pressure", mean},
                {"peak_pressure", 1.5 * mean},
                {"peak_shear", 0.300283 * 1.5 * mean}};
  });
  expect_all(said, {"two mistakes", "8 in place of 4", "160 of 160 that are wrong"});
  expect_said(said, "with the pressures right", false);
}

// The mistake in all results of a point is told even if one result is also wrong for another
// reason. That result is told by the error that is left.
TEST(Said, OfAPointIsNotHiddenByAResultThatIsWrongInAnotherWay) {
  const auto answer = [](const TestCase& one) {
    json fields;
    if (one.function != "operating_point") return fields;
    Question question = question_of(one);
    question.scene->surface.offset_planes = 1;
    const Numbers numbers = right_numbers(question);
    for (const Expected& expected : one.expected)
      if (expected.place && *expected.place < numbers.size() &&
          std::isfinite(numbers[*expected.place]))
        fields[expected.field] =
            (expected.field == "summit_count" ? 0.31 : 1.0) * numbers[*expected.place];
    return fields;
  };
  const std::string said = all_said(answer);
  expect_all(said, {"These are the numbers that this gives: one offset plane, whatever",
                    "operating_point.summit_count is 3.226 times too small in "});
}

TEST(Said, OfOtherExponentsAreTheExponents) {
  expect_all(said_of("hamrock_dowson_central", film({.a = 0.7, .b = 0, .c = 0.49})),
             {"It goes as F^+0.49; the law has F^-0.067.",
              "It does not depend on α; the law has α^+0.53.", "U^+0.7 G^+0 W^+0.49"});
  expect_all(said_of("hamrock_dowson_central", film({.b = 0, .c = 0.49})),
             {"with G^0 in place of G^0.53, and W^0.49 in place of W^-0.067 ("});
}

TEST(Said, OfAnotherLawsExponentsIsThatLaw) {
  expect_all(
      said_of(
          "hamrock_dowson_central",
          film({.constant = 5, .a = 0.68, .b = 0.49, .c = -0.073, .leakage = 1, .decay = 0.68})),
      {"u^+0.68", "α^+0.49", "the minimum film", "Its constant is 1.37741 times"});
}

TEST(Said, OfAnotherApproachIsItsFormulaOrItsExponents) {
  const auto approach = [](double part) {
    return [part](const json& inputs) {
      json results = hertz(inputs);
      results["approach"] = std::pow(results["radius"].get<double>(), 3) * part /
                            inputs.at("reduced_radius").get<double>();
      return results;
    };
  };
  expect_all(said_of("hertz_point", approach(1.0 / 3)), {"a³/(3R) in place of the approach a²/R"});
  expect_all(said_of("hertz_point", approach(0.2)),
             {"F^+1 E*^-1", "a³/(3R)", "Its constant is 0.6 times"});
}

// This solver gives E′ = 2E* as the effective modulus, and its other functions take it as such.
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
               {"hertz_point", [](const json& in) { return hertz(in, 0.5); }},
               {"hamrock_dowson_central", film({}, "load", 1, 1)}});
  expect_all(said,
             {"2E* in place of E* (E′ of the film formulas is 2E*)",
              "hertz_point.radius is 26 % high everywhere. This goes with effective_modulus, which "
              "is off alike: E*/2 in place of E* (",
              "This function is given the right input, so mend both. The same explains the answers "
              "of hamrock_dowson_central."});
  EXPECT_EQ(said.find("E*/2"), said.rfind("E*/2")) << said;
}

std::map<std::string, double> right_moments() {
  std::map<std::string, double> right;
  for (const TestCase& one : cases_of("gaussian_moment"))
    right[one.inputs.dump()] = one.expected[0].high;
  return right;
}

// Order 3/2 has the other sign, order 1 loses its digits, the others are not offered.
TEST(Said, OfBranchesIsSaidOfEachAlone) {
  const std::map<std::string, double> right = right_moments();
  const std::string said = said_of("gaussian_moment", [&](const json& inputs) {
    const double order = inputs.at("order");
    if (order == 1.5) return json{{"value", -right.at(inputs.dump())}};
    if (order != 1) return json{{"value", right.at(inputs.dump())}};
    return json{{"value", rounded_moment(order, inputs.at("argument"))}};
  });
  expect_all(said, {"For order 1.5: ", "−1 times the right value", "another sign convention",
                    "order 1: ", "right up to d = ", "as of digits that cancel"});
}

TEST(Said, OfATailThatIsWrongIsWhereItBegins) {
  const std::map<std::string, double> right = right_moments();
  expect_all(said_of("gaussian_moment",
                     [&](const json& inputs) {
                       const double value = right.at(inputs.dump());
                       const double d = inputs.at("argument");
                       const bool is_off = inputs.at("order") == 0.5 && (d < -21 || d > 5.1);
                       return json{{"value", is_off ? value * (1 + d * d) : value}};
                     }),
             {"order 0.5: ", "right from d = -21", " to 5, wrong below and beyond"});
}

TEST(Said, OfAWrongFormulaWithAnotherNumberInsideIsBoth) {
  const auto chart = [](double offset, auto scale, double noise) {
    return [=](const json& in) {
      const auto number = [&](const char* name) { return in.at(name).get<double>(); };
      const auto log_log = [&](const char* name) {
        return std::log(std::log(1e6 * number(name) + offset));
      };
      const double first = scale(number("first_temperature"));
      const double part =
          (scale(number("temperature")) - first) / (scale(number("second_temperature")) - first);
      const double height =
          log_log("first_viscosity") * (1 - part) + log_log("second_viscosity") * part;
      const double found = 1e-6 * (std::exp(std::exp(height)) - offset);
      return json{{"value", found * (1 + noise * std::sin(1e9 * found))}};
    };
  };
  const auto plain = [](double t) { return t; };
  const auto celsius = [](double t) { return std::log(t - 273.15); };
  const std::string number = "and 0.8 in place of 0.7";
  expect_all(said_of("astm_d341_viscosity", chart(0.8, plain, 0)),
             {"a straight line over T in place of log T, " + number});
  expect_all(said_of("astm_d341_viscosity", chart(0.8, celsius, 0)),
             {"temperatures in °C in place of K, " + number});
  expect_said(said_of("astm_d341_viscosity", chart(0.8, plain, 0.01)), number, false);
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
  expect_all(said_of("gaussian_moment", trapezoids), {"as of a quadrature"});
}

// --- Limits, with cases and mistakes made here: films that differ in their speed alone, 1 + i.

using Times = std::function<double(std::size_t)>;

// The diagnoses of `count` films. The answer to film i is its right value times times(i). With
// `single_but_for` all answers but that film's are in single precision.
std::vector<Diagnosis> told_of(std::size_t count, const Times& times,
                               const std::vector<Mistake>& mistakes = {},
                               const Tolerance& tolerance = engineering_tolerance(),
                               std::optional<std::size_t> single_but_for = {}) {
  static const TestCase usual = cases_of("hamrock_dowson_central").front();
  std::vector<TestCase> cases(count, usual);
  Conversation conversation;
  for (std::size_t i = 0; i < count; ++i) {
    cases[i].id = std::to_string(i);
    cases[i].inputs["speed"] = 1 + static_cast<double>(i);
    const double right = right_numbers(question_of(cases[i]))[0];
    Expected& expected = cases[i].expected.front();
    expected.high = right;
    expected.low = 0;
    expected.condition = 1;
    double got = right * times(i);
    if (single_but_for && i != *single_but_for) got = static_cast<float>(got);
    conversation.answers.push_back({Outcome::answered, {{"value", got}}, {}});
  }
  return diagnose(cases, conversation, tolerance, mistakes);
}
std::vector<std::string> named_of(std::size_t count, const Times& times,
                                  const std::vector<Mistake>& mistakes) {
  std::vector<std::string> names;
  for (const Diagnosis& one : told_of(count, times, mistakes))
    names.insert(names.end(), one.mistakes.begin(), one.mistakes.end());
  return names;
}
bool says(const std::vector<Diagnosis>& told, const std::string& words) {
  return std::any_of(told.begin(), told.end(), [&](const Diagnosis& one) {
    return one.text.find(words) != std::string::npos;
  });
}

// A mistake that gives `times` the right value for the films from number `first` to `end`.
Mistake times_of(double times, std::size_t first, std::size_t end, const std::string& name = "m") {
  const auto applies = [=](const Question& question) {
    const double i = question.arguments[0] - 1;
    return i >= static_cast<double>(first) && i < static_cast<double>(end);
  };
  return {.function = "hamrock_dowson_central",
          .name = name,
          .text = name,
          .touches = {},
          .applies = applies,
          .after = [=](const Question&, Numbers& numbers) { numbers[0] *= times; }};
}
// The first films have twice the right value. The next ones are wrong, each in another way that no
// mistake explains. The rest are right.
Times twice_then_odd(std::size_t twice, std::size_t odd_to) {
  return [=](std::size_t i) {
    return i < twice ? 2 : i < odd_to ? 1.3 + 0.01 * static_cast<double>(i * i % 89) : 1;
  };
}

TEST(Limits, OfCountsAreWhereTheyArePromised) {
  // A mistake is named where at least 98 in 100, and at least three, of the answers that it changes
  // are as it gives them.
  const auto with_met = [](std::size_t changed, std::size_t met) {
    return named_of(changed + 20, twice_then_odd(met, changed), {times_of(2, 0, changed)}).size();
  };
  // A mistake has to explain a tenth of the wrong answers.
  const auto beside = [](std::size_t explained, std::size_t others) {
    return named_of(400, twice_then_odd(explained, explained + others), {times_of(2, 0, explained)})
        .size();
  };
  for (const std::size_t i : {1U, 2U, 3U}) {
    EXPECT_EQ(with_met(100 * i, 98 * i), 1U);
    EXPECT_EQ(with_met(100 * i, 98 * i - 1), 0U);
    EXPECT_EQ(with_met(i, i), i < 3 ? 0U : 1U);
    EXPECT_EQ(beside(10 * i, 90 * i), 1U);
    EXPECT_EQ(beside(10 * i, 90 * i + 1), 0U);
  }
  // After a named mistake, up to 3 in 100 other wrong answers are not told.
  for (const std::size_t rest : {6U, 7U})
    EXPECT_EQ(says(told_of(300, twice_then_odd(200, 200 + rest), {times_of(2, 0, 200)}),
                   "None of the known mistakes gives these others"),
              rest == 7);
  // Three causes are told, and three choices of each.
  std::vector<Mistake> causes, choices;
  for (std::size_t k = 0; k < 5; ++k) {
    causes.push_back(times_of(2 + static_cast<double>(k), 20 * k, 20 * k + 20, std::to_string(k)));
    choices.push_back(times_of(2, 0, 20, std::to_string(k)));
  }
  const std::vector<std::string> three{"0", "1", "2"};
  const Times of_causes = [](std::size_t i) { return 2 + static_cast<double>(i / 20); };
  EXPECT_EQ(named_of(100, of_causes, causes), three);
  EXPECT_EQ(named_of(40, twice_then_odd(20, 20), choices), three);
  // The place of the wrong answers is told from eight cases on, three of them right. Two in a
  // hundred, and a tenth of the fewer side, may lie beyond the border.
  const auto is_place_told = [](std::size_t count, std::size_t right, std::size_t strays) {
    const Times times = [=](std::size_t i) {
      const bool is_stray = i % 10 == 4 && i / 10 < strays;
      return i < right && !is_stray ? 1 : twice_then_odd(0, count)(i);
    };
    return says(told_of(count, times), "right up to u = ");
  };
  EXPECT_TRUE(is_place_told(100, 50, 2) && is_place_told(100, 22, 2) && is_place_told(8, 3, 0));
  EXPECT_FALSE(is_place_told(100, 50, 3) || is_place_told(100, 21, 2));
  EXPECT_FALSE(is_place_told(7, 3, 0) || is_place_told(9, 2, 0));
}

TEST(Limits, OfNumbersAreWhereTheyArePromised) {
  using enum verification::True;
  constexpr std::size_t count = 24;
  const auto all = [](double times) { return [=](std::size_t) { return times; }; };
  std::vector<verification::Threshold> limits;
  // Factors are named within a millionth.
  const auto add_factor = [&](double value, const std::string& sentence) {
    const auto is_named = [=](double x) {
      return says(told_of(count, all(value * (1 + x))), sentence);
    };
    limits.push_back({sentence, 1e-6, below, is_named, 2e-8});
    limits.push_back({sentence, -1e-6, above, is_named, 2e-8});
  };
  const double pi = std::numbers::pi;
  const std::vector<std::pair<double, std::string>> factors{
      {2, "2."},
      {pi, "π."},
      {std::sqrt(2), "√2."},
      {1.5, "3/2."},
      {3, "3, as a 3 that is lost, or √3 and 1/√3 exchanged."},
      {4.0 / 3, "4/3, as a 4/3 that is lost, or 2 and 3/2 exchanged."},
      {std::sqrt(2 * pi), "√(2π)."},
      {std::sqrt(pi), "√π."},
      {1e3, "1000, as between m and mm, or Pa and kPa."},
      {1e6, "10⁶, as between m and µm, or Pa and MPa."},
      {1e9, "10⁹, as between m and nm, or Pa and GPa."},
      {100, "100, as with percent."},
      {4, "4, as a 4 that is lost, or 2 and 1/2 exchanged."},
      {2 * pi, "2π."}};
  for (const auto& [factor, name] : factors) {
    add_factor(factor, "too large by a factor of " + name);
    add_factor(1 / factor, "too small by a factor of " + name);
  }
  add_factor(-1, "another sign convention");
  // A factor, or a pattern, is named where all answers have it.
  const auto half_off = [&](double by, const char* words) {
    return [=](double x) {
      return says(told_of(count, [=](std::size_t i) { return i % 2 == 0 ? 2 : 2 + by * x; }),
                  words);
    };
  };
  limits.push_back({"one factor", 1e-9, below, half_off(2, "by a factor of 2."), 1e-6});
  limits.push_back(
      {"one pattern", (2e-3 + 1e-9) / (1 - 2e-3), above, half_off(1, ", between "), 1e-11});
  const auto words = [&](const char* said) {
    return [=](double times) { return says(told_of(count, all(times)), said); };
  };
  limits.push_back({"times too large", 3, above, words("times too large"), 1e-15});
  limits.push_back({"times too small", 1.0 / 3, below, words("times too small"), 1e-15});
  // Rounding in double, which only the strict tolerance finds, and in single precision.
  limits.push_back({"rounding", 1e-12, below,
                    [&](double x) {
                      return says(told_of(count, all(1 + x), {}, strict_tolerance()),
                                  "rounding, and no wrong formula");
                    },
                    1e-3});
  const auto few_digits = [&](double x, std::size_t but_for) {
    return says(told_of(count, all(1 + x), {}, engineering_tolerance(), but_for),
                "in single precision");
  };
  limits.push_back(
      {"single precision", 1e-5, below, [&](double x) { return few_digits(x, count); }, 2e-2});
  // Answers meet a mistake to 1/500 of its change, and two together to 1e-5 of it. A change of less
  // than five times the allowed error is too small to tell.
  const auto is_met = [&](double of_one, double of_two) {
    return [=](double x) {
      return !named_of(count, all(of_one * of_two * (1 + x)),
                       {times_of(of_one, 0, count), times_of(of_two, 0, count)})
                  .empty();
    };
  };
  limits.push_back({"closeness of one", 1e-3, up_to, is_met(2, 1), 1e-10});
  limits.push_back({"closeness of two", 5e-5 / 6, up_to, is_met(2, 3), 1e-9});
  limits.push_back(
      {"change", 5e-6, above,
       [&](double x) { return !named_of(count, all(1 + x), {times_of(1 + x, 0, count)}).empty(); },
       1e-9});
  for (const auto& one : limits) EXPECT_TRUE(changes_at_its_limit(one));
  EXPECT_FALSE(few_digits(3e-6, 7));
}

// Right solvers with noise up to 1e-9, with other units or other formulas inside.
TEST(Said, OfRightSolversIsNothingInAThousandTries) {
  std::mt19937_64 random(20261123);
  std::uniform_real_distribution<double> noise(-1e-9, 1e-9), exponent(-9, 9);
  const auto films = cases_of("hamrock_dowson_central"), contacts = cases_of("hertz_point");
  const std::vector<TestCase>& others = usual_cases();
  for (int i = 0; i < 1000; ++i) {
    std::vector<TestCase> cases;
    Conversation conversation;
    const auto add = [&](const TestCase& asked, json fields) {
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
      const double bracket = 1 - 0.61 * std::exp(-0.73 * in.value("ellipticity", 1.0));
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
      json results = hertz(in);
      for (const char* const length : {"radius", "approach"})
        results[length] = results[length].get<double>() / metre;
      for (const char* const pressure : {"mean_pressure", "peak_pressure"})
        results[pressure] = results[pressure].get<double>() * metre * metre / newton;
      add(contacts[k], std::move(results));
    }
    for (std::size_t k = static_cast<std::size_t>(i) % 97; k < others.size(); k += 97) {
      if (others[k].function == "hamrock_dowson_central" || others[k].function == "hertz_point")
        continue;
      add(others[k], right_answer(others[k]));
    }
    const auto found = diagnose(cases, conversation, engineering_tolerance(), all_mistakes());
    EXPECT_TRUE(found.empty()) << "try " << i << ": " << found.front().text;
    EXPECT_EQ(judge("", cases, conversation, engineering_tolerance()).overall, Overall::complete);
  }
}

}  // namespace
}  // namespace tribo::conformance
