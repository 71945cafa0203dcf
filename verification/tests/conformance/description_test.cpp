// SPDX-License-Identifier: Apache-2.0
// The sentences about wrong answers that no known mistake gives: where they are wrong, what the
// error depends on, and what follows from another function.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "catalogue/ways_to_ask.hpp"
#include "conformance/answers.hpp"
#include "conformance/insides.hpp"
#include "conformance/law_numbers.hpp"
#include "conformance/mistake_entry.hpp"
#include "conformance/question.hpp"
#include "support/judge.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;
using namespace nlohmann::literals;
using namespace std::literals;

using Slip = std::function<void(const TestCase& asked, json& fields)>;

// All sentences about a solver that offers only the functions that have a slip.
std::string said_of(const std::map<std::string, Slip>& slips,
                    const std::vector<Mistake>& mistakes = {}) {
  const auto answer = [&](const TestCase& one) {
    const auto slip = slips.find(one.function);
    if (slip == slips.end()) return json();
    json fields = right_answer(one);
    slip->second(one, fields);
    return fields;
  };
  return all_said(answer, mistakes);
}
std::string said_of(const std::string& function, const Slip& slip) {
  return said_of({{function, slip}});
}

void expect_told(const std::string& function, const std::string& words, const Slip& slip) {
  expect_said(said_of(function, slip), words);
}
void expect_not_told(const std::string& function, const std::string& words, const Slip& slip) {
  expect_said(said_of(function, slip), words, false);
}

void multiply(json& field, double by) { field = field.get<double>() * by; }

double number(const json& inputs, const char* name) { return inputs.at(name).get<double>(); }

// Makes the answers of a field wrong, each by another factor, in the cases where `holds` is true.
Slip noise_where(const std::string& field, std::function<bool(const json& inputs)> holds) {
  return [=](const TestCase& asked, json& fields) {
    std::mt19937 random(static_cast<unsigned>(std::hash<std::string>()(asked.id)));
    if (holds(asked.inputs) && fields.contains(field) && fields[field].is_number())
      multiply(fields[field], std::uniform_real_distribution<double>(1.1, 1.9)(random));
  };
}
bool has_roelands(const json& inputs) {
  return inputs.value("/friction/viscosity"_json_pointer, std::string("barus")) == "roelands";
}

// Makes the value another one.
Slip value_as(std::function<double(const json& inputs, double right)> other) {
  return [=](const TestCase& asked, json& fields) {
    fields["value"] = other(asked.inputs, fields["value"].get<double>());
  };
}
Slip at_least(double least) {
  return value_as([=](const json&, double right) { return std::max(right, least); });
}
Slip times(const std::string& field, double factor) {
  return [=](const TestCase&, json& fields) { multiply(fields[field], factor); };
}

TEST(Factor, OfAPiWithFewDigitsIsNamedForEachResult) {
  const std::map<std::string, double> written_pis{
      {"3", 3}, {"3.14", 3.14}, {"3.1416", 3.1416}, {"22/7", 22.0 / 7}};
  for (const auto& one : written_pis) {
    const double factor = std::numbers::pi / one.second;
    const std::string said = said_of("hertz_point", [factor](const TestCase&, json& fields) {
      multiply(fields["mean_pressure"], factor);
      multiply(fields["peak_pressure"], factor);
    });
    const std::string words =
        ". It is off by one factor, as " + one.first + " in place of π makes it.";
    for (const char* const result :
         {"hertz_point.mean_pressure is ", "hertz_point.peak_pressure is "})
      expect_said(said, result);
    EXPECT_NE(said.find(words), said.rfind(words)) << said;
    expect_said(said, "None of the known mistakes", false);
  }
  expect_told("hertz_line", "as 3.14 in place of π makes it",
              times("half_width", std::sqrt(3.14 / std::numbers::pi)));
  for (const double other : {3.15, 3.1401})
    expect_not_told("hertz_point", "π", times("mean_pressure", other / std::numbers::pi));
}

TEST(Sum, OfAllAnswersIsToldBeforeAFactorThatDependsOnAnInput) {
  const auto plus = [](double sum) {
    return value_as([=](const json&, double right) { return right + sum; });
  };
  const std::string high = said_of("astm_d341_viscosity", plus(1e-7));
  expect_said(high, "too large by 1e-07 m²/s, large or small as they are: a sum is added.");
  expect_said(high, "The factor depends on", false);
  expect_told("astm_d341_viscosity", "too small by 2e-08 m²/s, ", plus(-2e-8));
  expect_not_told("astm_d341_viscosity", "a sum is added", value_as([](const json&, double right) {
                    return right + 1e-7 * std::pow(1e5 * right, 0.01);
                  }));
  expect_not_told("astm_d341_viscosity", "a sum is added", times("value", 1.01));
}

TEST(Place, IsAWordOrAnEqualityOrAnOrderWhereThatTellsAllWrongAnswers) {
  expect_told("effective_modulus", "cases where E₁ is not E₂",
              noise_where("value", [](const json& in) {
                return in.at("first_modulus") != in.at("second_modulus");
              }));
  expect_told("hertz_ellipse", "cases where R_y < R_x, right in all others",
              noise_where("approach", [](const json& in) {
                return number(in, "radius_y") < number(in, "radius_x");
              }));
  expect_told("operating_point",
              "cases where `friction.viscosity` is roelands, right in all others",
              noise_where("friction", has_roelands));
  const std::string model = said_of(
      "operating_point_of_line", noise_where("summit_count", [](const json& in) {
        return in.value("/closures/asperity"_json_pointer, "greenwood_tripp"s) != "greenwood_tripp";
      }));
  expect_said(model,
              "cases where `closures.asperity` is greenwood_williamson, right in all others");
  expect_said(model, "is not greenwood_tripp", false);
  expect_told("operating_point_of_line",
              "cases where `supply.inlet_film_ratio` is given, right in all others",
              noise_where("film", [](const json& in) {
                return in.contains("supply") && in.at("supply").contains("inlet_film_ratio");
              }));
}

TEST(Place, IsAConditionThatAllWrongAnswersNeed) {
  std::mt19937 random(7);
  expect_told("operating_point", "wrong only where `surface.offset_planes` is 2: in ",
              noise_where("film", [&](const json& in) {
                return in.at("surface").value("offset_planes", 1) == 2 && random() % 3 > 0;
              }));
}

TEST(Place, IsNoneWhereWrongAnswersAreAnywhere) {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    std::mt19937 random(seed);
    const auto sometimes = [&](const json&) { return random() % 3 == 0; };
    for (const char* const function : {"effective_modulus", "hertz_line", "moes_line"}) {
      const std::string field = function == std::string("hertz_line") ? "approach" : "value";
      const std::string said = said_of(function, noise_where(field, sometimes));
      for (const char* const words : {"wrong in all", "wrong only", "right up to", "right from"})
        expect_said(said, words, false);
    }
  }
}

TEST(Place, IsABorderOfAGroupWhereNoInputHasOne) {
  expect_told("barus_viscosity", "right up to αp = ", noise_where("value", [](const json& in) {
                return number(in, "pressure_viscosity") * number(in, "pressure") > 2;
              }));
  expect_told("pan_hamrock_central", "right up to W = ", noise_where("value", [](const json& in) {
                return number(in, "load_per_length") /
                           (2 * number(in, "effective_modulus") * number(in, "reduced_radius")) >
                       2e-5;
              }));
}

TEST(Place, OfOneOrTwoCasesIsThoseCases) {
  const std::string said = said_of("effective_modulus", noise_where("value", [](const json& in) {
                                     return in.at("first_poisson_ratio") == 0;
                                   }));
  expect_said(said, ", the only cases where ν₁ = 0");
  expect_said(said, "right below and beyond", false);
}

// The films are wrong by a factor that depends on k, on U, or on both.
TEST(Dependence, IsOnTheOneVariableThatDeterminesTheFactor) {
  const auto film = [](const std::string& function,
                       const std::function<double(double k, double U)>& factor) {
    return said_of(function, [=](const TestCase& asked, json& fields) {
      const json& in = asked.inputs;
      const double radius =
          in.contains("reduced_radius") ? number(in, "reduced_radius") : number(in, "radius_x");
      const double U = number(in, "viscosity") * number(in, "speed") /
                       (2 * number(in, "effective_modulus") * radius);
      multiply(fields["value"], factor(in.value("ellipticity", 1.0), U));
    });
  };
  for (const char* const function :
       {"hamrock_dowson_central", "hamrock_dowson_minimum", "hamrock_dowson_soft_minimum"}) {
    const auto of_k = film(function, [](double k, double) { return 1 - 0.4 * std::exp(-k / 2); });
    expect_said(of_k, "The factor depends on k alone: ");
    const auto of_both = film(function, [](double k, double U) {
      return 1 - 0.4 * std::exp(-k / 2) * std::pow(U, 0.05);
    });
    expect_said(of_both, "The factor depends on", false);
  }
  for (const char* const function : {"moes_line", "ertel_grubin"})
    expect_said(film(function, [](double, double U) { return 1 + std::pow(U * 1e11, 0.1) / 9; }),
                "The factor depends on U alone: ");
}

TEST(Dependence, IsNotSaidOfNoise) {
  for (const char* const function : {"hamrock_dowson_central", "moes_line", "barus_viscosity"})
    expect_not_told(function, "The factor depends on",
                    noise_where("value", [](const json&) { return true; }));
}

// Relative errors of both signs, up to a size that may depend on the question.
Slip scattered(std::function<double(const json& inputs)> size) {
  return [=](const TestCase& asked, json& fields) {
    std::mt19937 random(static_cast<unsigned>(std::hash<std::string>()(asked.id)));
    const double part = std::uniform_real_distribution<double>(-1, 1)(random);
    multiply(fields["value"], 1 + part * size(asked.inputs));
  };
}

TEST(Scatter, IsSaidOfErrorsInNoOrder) {
  for (const char* const function :
       {"moes_line", "hamrock_dowson_central", "pan_hamrock_minimum"}) {
    const auto small = said_of(function, scattered([](const json&) { return 1e-4; }));
    expect_said(small, "as of an iteration that stops too early");
    const auto growing = said_of(function, scattered([](const json& in) {
                                   return std::min(0.5, 1e-3 / number(in, "viscosity"));
                                 }));
    expect_said(growing, "and grow where η₀ is small");
    // No answer is right to all digits, so this is no cancellation of digits.
    expect_said(growing, "as of digits that cancel", false);
    const auto large = said_of(function, scattered([](const json&) { return 0.5; }));
    expect_said(large, "in no order", false);
    const auto smooth = said_of(function, [](const TestCase& asked, json& fields) {
      multiply(fields["value"],
               1 + 1e-4 / (1 + number(asked.inputs, "speed") + number(asked.inputs, "viscosity")));
    });
    expect_said(smooth, "in no order", false);
  }
}

TEST(Scatter, IsOfAFixedWidthWhereErrorsDoNotGrowWithTheAnswer) {
  const auto off_by = [](std::function<double(double value)> size) {
    return [=](const TestCase& asked, json& fields) {
      std::mt19937 random(static_cast<unsigned>(std::hash<std::string>()(asked.id)));
      const double value = fields["value"];
      fields["value"] = value + size(value) * std::uniform_real_distribution<double>(-1, 1)(random);
    };
  };
  const char* const words = "as of an iteration that stops at a fixed width";
  expect_told("load_sharing", words, off_by([](double) { return 5e-5; }));
  // Errors in proportion to the answer, or to its square root, have no fixed width.
  expect_not_told("load_sharing", words, off_by([](double value) { return 1e-4 * value; }));
  expect_not_told("load_sharing", words,
                  off_by([](double value) { return 1e-4 * std::sqrt(value); }));
}

TEST(Sum, IsSaidWhereAllAnswersAreOffByIt) {
  expect_told("persson_contact_area",
              "All answers are too large by 1e-09, large or small as they are: a sum is added.",
              value_as([](const json&, double right) { return right + 1e-9; }));
  expect_told("regime_film",
              "All answers are too small by 0.5, large or small as they are: a sum is missing.",
              value_as([](const json&, double right) { return right - 0.5; }));
  expect_told("moes_line", "All answers are too large by 0.25 times R, large or small as they are",
              value_as([](const json& in, double right) {
                return right + 0.25 * number(in, "reduced_radius");
              }));
  // A factor is no sum, nor is a sum in some answers alone, nor one that is not the same in all.
  for (const Slip& other :
       std::vector<Slip>{value_as([](const json&, double right) { return right + 0.17 * right; }),
                         value_as([](const json&in, double right) {
                           return right + (number(in, "speed") > 1 ? 1e-9 : 0);
                         }),
                         value_as([](const json&in, double right) {
                           return right + 1e-9 * (2 + std::sin(number(in, "speed")));
                         })})
    expect_not_told("moes_line", "All answers are too", other);
}

// Noise about another factor than 1. Each viscosity has its own noise, and the factor may grow with
// the viscosity.
TEST(Dependence, IsNotSaidOfNoiseAboutAnotherFactor) {
  for (const char* const function : {"hamrock_dowson_central", "moes_line", "ertel_grubin"})
    for (const double exponent : {0.0, 0.1}) {
      const auto noise = [=](const TestCase& asked, json& fields) {
        const double viscosity = number(asked.inputs, "viscosity");
        std::mt19937 random(static_cast<unsigned>(std::hash<double>()(viscosity)));
        multiply(fields["value"], 3 * std::pow(viscosity, exponent) *
                                      std::uniform_real_distribution<double>(0.94, 1.06)(random));
      };
      expect_not_told(function, "The factor depends on", noise);
    }
}

// An error that rises and falls again is not that of a quadrature with too few points.
TEST(Place, OfAHumpOfErrorsIsNotThatOfAQuadrature) {
  for (const double width : {0.5, 2.0, 4.0})
    expect_not_told("gaussian_moment", "as of a quadrature",
                    [=](const TestCase& asked, json& fields) {
                      const double d = (number(asked.inputs, "argument") - 1) / width;
                      multiply(fields["value"], 1 + 0.05 * std::exp(-d * d));
                    });
}

// Films of dowson_toyoda_central that are too thick by 30 %, also in points. One solver has twice
// the friction with Roelands' law, too.
void set_numbers(json& fields, const OperatingPoint<double>& point) {
  const auto numbers = numbers_of(point);
  for (std::size_t i = 0; i < output_infos.size(); ++i) {
    const std::string name(output_infos[i].name);
    if (i < numbers.size() && fields.contains(name) && fields[name].is_number() &&
        std::isfinite(numbers[i]))
      fields[name] = numbers[i];
  }
}
void thicken(const TestCase& asked, json& fields) {
  const Question question = question_of(asked);
  if (question.scene->closures.film != FilmFormula::dowson_toyoda_central) return;
  FilmLaw law = film_law(FilmFormula::dowson_toyoda_central);
  law.constant.p = law.constant.p * 13;
  law.constant.q = law.constant.q * 10;
  set_numbers(fields, MixedContact<double>(*question.scene, law).solve(question.scene->speeds[0]));
}
void thicken_film(const TestCase&, json& fields) { multiply(fields["value"], 1.3); }

TEST(Following, IsSaidOfPointsThatUseTheWrongFunctionAndOfNoOthers) {
  const std::string follows = "This follows from dowson_toyoda_central: ";
  const std::string said =
      said_of({{"dowson_toyoda_central", thicken_film}, {"operating_point_of_line", thicken}});
  expect_said(said, follows);
  expect_said(said, "None of the known mistakes gives these others", false);
  const std::string both =
      said_of({{"dowson_toyoda_central", thicken_film},
               {"operating_point_of_line", [](const TestCase& asked, json& fields) {
                  thicken(asked, fields);
                  if (has_roelands(asked.inputs)) multiply(fields["friction"], 2);
                }}});
  expect_said(both, follows);
  expect_said(both, "cases where `friction.viscosity` is roelands, right in all others");
  // Points of other film laws are wrong for another reason.
  const std::string others =
      said_of({{"dowson_toyoda_central", thicken_film},
               {"operating_point", noise_where("film", [](const json&) { return true; })}});
  expect_said(others, "follows from", false);
  expect_said(others, "It rests on", false);
}

// Points that are computed with the film ratio of(y) in place of y.
Slip with_film_ratio(std::function<double(double)> of) {
  return [of](const TestCase& asked, json& fields) {
    const Question question = question_of(asked);
    if (question.scene->supply.kind == SupplyKind::flooded) return;
    const MixedContact<long double> contact(*question.scene);
    const auto flooded = contact.flooded(question.scene->speeds[0]);
    auto inlet = contact.inlet(flooded);
    const double own = static_cast<double>(inlet.film_ratio), ratio = of(own);
    if (own == ratio) return;
    inlet.film_ratio = ratio;
    inlet.collapsed = ratio == 0;
    const auto shares = contact.starved_shares(flooded, inlet, 1 - inlet.film_ratio);
    set_numbers(fields,
                detail::in_double(contact.complete(flooded, inlet, shares, OutputSet::all())));
  };
}

// A wrong inlet thins films down to the floor of high summits. There the shares are wrong, too.
TEST(Following, IsOfAllResultsOfStarvedPoints) {
  const auto wrong_inlet = [](double y) { return y / (2 - y); };
  const std::string said = said_of({{"starvation_ratio",
                                     [&](const TestCase&, json& fields) {
                                       fields["value"] = wrong_inlet(fields["value"].get<double>());
                                     }},
                                    {"operating_point", with_film_ratio(wrong_inlet)}});
  expect_said(said, "This follows from starvation_ratio: with the answers that it gives there, ");
  expect_said(said, "wrong answers of operating_point are right.");
  expect_said(said, "None of the known mistakes gives these others", false);
}

TEST(Misread, IsAFloorOfTheFilmRatioInsideOfPoints) {
  const std::string floor = "the film over the flooded one in the inlet = 0.1 wherever it is less";
  expect_told("operating_point", floor, with_film_ratio([](double y) { return std::max(y, 0.1); }));
  expect_not_told("operating_point", "the film over the flooded one in the inlet =",
                  with_film_ratio([](double y) { return std::max(y, 0.05 + y / 2); }));
}

// The moments that greenwood_tripp's load uses are wrong in a way that has no law.
TEST(Following, IsByUseWhereTheWrongFunctionIsNotKnownWellEnough) {
  const auto moments = noise_where("value", [](const json& in) { return in.at("order") == 2.5; });
  const std::string said = said_of(
      {{"gaussian_moment", moments}, {"load_sharing", noise_where("value", [](const json& in) {
                                        return in.at("asperity") == "greenwood_williamson";
                                      })}});
  expect_said(said, "It rests on gaussian_moment", false);
  expect_said(said_of({{"gaussian_moment", moments},
                       {"load_sharing", noise_where("value",
                                                    [](const json& in) {
                                                      return in.at("asperity") == "greenwood_tripp";
                                                    })}}),
              "It rests on gaussian_moment, wrong too");
}

// A slip in the film and one in friction are each told; errors that follow from the first are not.
TEST(Point, IsToldByTheResultThatIsComputedFirstAndThenByOthers) {
  const auto film = [](const TestCase& asked, json& fields) {
    if (asked.inputs.at("surface").value("offset_planes", 1) != 2) return;
    std::mt19937 random(static_cast<unsigned>(std::hash<std::string>()(asked.id)));
    for (const char* const name : {"film_flooded", "film", "separation", "film_parameter"})
      multiply(fields[name], std::uniform_real_distribution<double>(1.1, 1.9)(random));
  };
  const std::string of_film = "film_flooded is off in ";
  const std::string planes = "cases where `surface.offset_planes` is 2, right in all others";
  const std::string one = said_of("operating_point", film);
  expect_said(one, of_film);
  expect_said(one, planes);
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 1) << one;
  const std::string both = said_of("operating_point", [&](const TestCase& asked, json& fields) {
    film(asked, fields);
    if (has_roelands(asked.inputs) && fields["friction"].is_number())
      multiply(fields["friction"], 2);
  });
  expect_said(both, of_film);
  expect_said(both, planes);
  expect_said(both, "cases where `friction.viscosity` is roelands, right in all others");
  EXPECT_EQ(std::count(both.begin(), both.end(), '\n'), 2) << both;
}

// The inputs in which a question differs from the one before.
std::set<std::string> changes(const json& inputs, const json& before) {
  std::set<std::string> changed;
  for (const auto& [name, value] : inputs.items())
    if (before.value(name, json()) != value) changed.insert(name);
  return changed;
}

// A solver that keeps a point's contact from the case before, unless the load is another one.
TEST(Cache, InsideOfAPointIsSaidWithTheInputThatItDoesNotLookAt) {
  json before = json::object();
  bool is_kept = false;
  const std::string said = said_of("operating_point", [&](const TestCase& asked, json& fields) {
    json inputs = asked.inputs.flatten();
    const auto changed = changes(inputs, before);
    if (changed.size() > 1 || changed.contains("/load"))
      is_kept = false;
    else if (changed.contains("/bodies/effective_modulus"))
      is_kept = true;
    if (is_kept) multiply(fields["friction"], 1.05);
    before = std::move(inputs);
  });
  expect_said(said, "begins where bodies.effective_modulus changes. The solver keeps something");
  // As many wrong answers in random cases are not those of a cache.
  std::mt19937 random(3);
  expect_not_told("operating_point", "as a cache does",
                  noise_where("friction", [&](const json&) { return random() % 20 == 0; }));
  // Wrong answers in such cases alone are no cache either, if as many such cases are right.
  json last = json::object();
  expect_not_told("operating_point", "as a cache does", [&](const TestCase& asked, json& fields) {
    json inputs = asked.inputs.flatten();
    if (changes(inputs, last).size() == 1 && random() % 2 == 0) multiply(fields["friction"], 1.05);
    last = std::move(inputs);
  });
}

// The right answer of the function to a question with other arguments.
Slip asked_as(std::function<void(Question&)> misread) {
  return [=](const TestCase& asked, json& fields) {
    Question question = question_of(asked);
    misread(question);
    const Numbers numbers = right_numbers(question);
    for (const Expected& one : asked.expected)
      if (one.place && fields[one.field].is_number()) fields[one.field] = numbers[*one.place];
  };
}
Slip scaled(std::size_t argument, double factor) {
  return asked_as([=](Question& question) { question.arguments[argument] *= factor; });
}

TEST(Misread, IsTheInputWithWhichTheRightFormulaGivesAllAnswers) {
  const auto expect = [](const char* function, const Slip& slip, const std::string& words) {
    expect_told(function, "are the right ones with " + words, slip);
  };
  expect("moes_line", scaled(2, 0.5), "α/2 in place of α (");
  expect("moes_line", scaled(3, std::sqrt(2)), "√2 F/L in place of F/L (");
  expect("dowson_higginson_density", scaled(0, 1e-6), "p/10⁶ in place of p (");
  expect("gupta_thermal_reduction", scaled(2, 1.25), "1.25 S in place of S (");
  expect("barus_viscosity",
         asked_as([](Question& one) { one.arguments[2] = std::min(one.arguments[2], 1e8); }),
         "p = 1e+08 wherever it is greater: it is cut off there (");
  expect("barus_viscosity", asked_as([](Question& one) {
           one.arguments[2] = std::min(one.arguments[2], 20 / one.arguments[1]);
         }),
         "αp = 20 wherever it is greater: it is cut off there (");
  expect("roelands_viscosity", asked_as([](Question& one) { one.arguments[1] = 2.2e-8; }),
         "α = 2.2e-08 always, whatever it is given as (");
  expect("effective_modulus", asked_as([](Question& one) { one.arguments[3] = one.arguments[1]; }),
         "ν₁ in place of ν₂ (");
  expect("hertz_ellipse", asked_as([](Question& one) { one.arguments[3] = one.arguments[2]; }),
         "R_x in place of R_y (");
  expect("astm_d341_viscosity", asked_as([](Question& one) {
           for (const std::size_t at : {0U, 2U, 4U}) one.arguments[at] += 273.15;
         }),
         "each of T₁, T₂, T + 273.15 in place of each of T₁, T₂, T (");
  expect(
      "hamrock_dowson_central",
      [](const TestCase& asked, json& fields) {
        if (asked.inputs.contains("ellipticity")) return;
        asked_as([](Question& one) { one.arguments[6] = 1.03; })(asked, fields);
      },
      "k = 1.03 where it is left out (");
  expect("operating_point",
         asked_as([](Question& one) { one.scene->friction.slide_roll_ratio = 0.3; }),
         "`friction.slide_roll_ratio` = 0.3 always, whatever it is given as (");
  for (const double more : {1e7, -1e7})
    expect("barus_viscosity", asked_as([more](Question& one) { one.arguments[2] += more; }),
           (more > 0 ? "p + 1e+07"s : "p − 1e+07"s) + " in place of p (");
  expect("operating_point", asked_as([](Question& one) {
           if (one.scene->supply.kind == SupplyKind::inlet_flow) one.scene->supply.value = 1e-8;
         }),
         "`supply.inlet_flow` = 1e-08 always, whatever it is given as (");
  expect("operating_point", asked_as([](Question& one) {
           if (one.scene->supply.kind == SupplyKind::inlet_flow) one.scene->supply.value /= 2;
         }),
         "`supply.inlet_flow`/2 in place of `supply.inlet_flow` (");
}

TEST(Following, IsOfPointsThatUseTheInputThatTheirFunctionMisreads) {
  const Slip function = asked_as([](Question& one) { one.arguments[2] = 2.5; });
  const std::string said =
      said_of({{"starvation_ratio", function}, {"operating_point", asked_as([](Question& one) {
                                                  one.scene->closures.damiens_exponent = 2.5;
                                                })}});
  expect_said(said, "are the right ones with γ = 2.5 always");
  expect_said(said, "This follows from starvation_ratio: with the answers that it gives there, ");
  expect_said(said, "None of the known mistakes gives these others", false);
}

std::vector<std::pair<std::string, LawOfNumbers>> all_laws() {
  std::vector<std::pair<std::string, LawOfNumbers>> laws;
  for (const catalogue::Function& function : catalogue::functions())
    if (auto law = law_of_numbers(function)) laws.emplace_back(function.name, std::move(*law));
  return laws;
}

TEST(LawNumbers, AreThoseWithWhichTheFormulaIsTheLaw) {
  std::map<std::string, std::size_t> answers;
  for (const auto& [function, law] : all_laws())
    for (const TestCase& one : cases_of(function)) {
      const auto given = law.formula(question_of(one).arguments, law.right);
      for (const Expected& expected : one.expected)
        if (given && expected.place) {
          ++answers[function];
          EXPECT_TRUE(verification::is_within(
              (*given)[*expected.place], expected.high,
              1e-11 * expected.condition * std::abs(expected.high) + 1e-300))
              << one.line();
        }
    }
  EXPECT_EQ(answers.size(), all_laws().size());
  for (const auto& [function, count] : answers) EXPECT_GE(count, 20U) << function;
}

// The law with other numbers at these places.
Slip with_numbers(const LawOfNumbers& law,
                  const std::vector<std::pair<std::size_t, double>>& others) {
  std::vector<double> numbers = law.right;
  for (const auto& [at, number] : others) numbers[at] = number;
  return [=](const TestCase& asked, json& fields) {
    const auto given = law.formula(question_of(asked).arguments, numbers);
    for (const Expected& one : asked.expected)
      if (given && one.place && fields[one.field].is_number() &&
          std::isfinite((*given)[*one.place]))
        fields[one.field] = (*given)[*one.place];
  };
}

// How many answers of the function become wrong.
std::size_t answers_changed(const std::string& function, const Slip& slip) {
  std::size_t changed = 0;
  for (const TestCase& one : cases_of(function)) {
    json fields = right_answer(one);
    slip(one, fields);
    for (const Expected& expected : one.expected)
      changed += expected.word.empty() && fields[expected.field].is_number() &&
                         std::abs(fields[expected.field].get<double>() - expected.high) >
                             allowed_error(one, expected, engineering_tolerance())
                     ? 1
                     : 0;
  }
  return changed;
}

// The number 8 % less or more, with at most three digits.
double miscopied(double right, double times) {
  return std::stod(fmt::format("{:.2e}", right * times));
}
std::string in_place(const LawOfNumbers& law, std::size_t at, double number) {
  return law.in_words(at, number) + " in place of " + law.in_words(at, law.right[at]);
}

TEST(LawNumbers, AreNamedEachWhereItIsMiscopied) {
  std::map<std::string, std::size_t> named;
  for (const auto& [function, law] : all_laws())
    for (std::size_t at = 0; at<law.right.size(); at += law.right.size()> 20 ? 7 : 1) {
      const double number = miscopied(law.right[at], 0.92);
      const Slip slip = with_numbers(law, {{at, number}});
      if (number == law.right[at] || answers_changed(function, slip) < 4) continue;
      ++named[function];
      expect_told(function, in_place(law, at, number), slip);
    }
  EXPECT_EQ(named.size(), all_laws().size());
}

TEST(LawNumbers, AreNamedTogetherWhereTwoAreMiscopied) {
  std::mt19937 random(20261127);
  std::size_t named = 0;
  for (const auto& [function, law] : all_laws())
    for (int i = 0; i < 2 && law.right.size() > 1; ++i) {
      std::uniform_int_distribution<std::size_t> any(0, law.right.size() - 1);
      const std::size_t one = any(random), other = any(random);
      const double first = miscopied(law.right[one], 0.92),
                   second = miscopied(law.right[other], 1.08);
      if (one == other || first == law.right[one] || second == law.right[other]) continue;
      // Answers of an inlet depend on one combination of its two constants alone.
      if (function == "starvation_ratio" && one + other == 1) continue;
      const bool both_matter = answers_changed(function, with_numbers(law, {{one, first}})) >= 4 &&
                               answers_changed(function, with_numbers(law, {{other, second}})) >= 4;
      if (!both_matter) continue;
      ++named;
      const std::string said =
          said_of(function, with_numbers(law, {{one, first}, {other, second}}));
      expect_said(said, in_place(law, one, first));
      expect_said(said, in_place(law, other, second));
    }
  EXPECT_GE(named, 15U);
  // Answers of the wrong sign, beyond a pole of the law.
  const LawOfNumbers index = *law_of_numbers(*catalogue::function_named("viscosity_index"));
  const auto at = [&](double number) {
    return static_cast<std::size_t>(std::find(index.right.begin(), index.right.end(), number) -
                                    index.right.begin());
  };
  const std::string both =
      said_of("viscosity_index", with_numbers(index, {{at(2.5), 2.3}, {at(-0.109), -0.118}}));
  expect_said(both, "-0.118 in place of -0.109");
  expect_said(both, "2.3 in place of 2.5");
}

TEST(Misread, IsNotSaidOfAnotherFormulaOrOfNoise) {
  const auto expect_not = [](const char* function, const Slip& slip) {
    expect_not_told(function, "the right ones with", slip);
  };
  expect_not("moes_line", noise_where("value", [](const json&) { return true; }));
  expect_not("barus_viscosity",
             noise_where("value", [](const json& in) { return number(in, "pressure") > 1e8; }));
  // A factor that a change of any input of a power law may give.
  expect_not("hamrock_dowson_soft_central", times("value", 1.17));
  expect_not("moes_line", value_as([](const json& in, double right) {
               return right * (1 + 1e7 * number(in, "viscosity"));
             }));
  expect_not("roelands_viscosity", value_as([](const json& in, double right) {
               return right * std::exp(-1e-18 * number(in, "pressure") * number(in, "pressure"));
             }));
}

// Answers on the straight line between the right ones at the two table entries beside the argument.
Slip by_table(std::size_t argument, double step) {
  return [=](const TestCase& asked, json& fields) {
    const double at = question_of(asked).arguments[argument] / step, below = std::floor(at);
    json low = fields, high = fields;
    asked_as([&](Question& one) { one.arguments[argument] = below * step; })(asked, low);
    asked_as([&](Question& one) { one.arguments[argument] = (below + 1) * step; })(asked, high);
    const double from = low["value"], to = high["value"];
    if (below != at) fields["value"] = from + (at - below) * (to - from);
  };
}

TEST(Misread, IsATableWithStraightLinesOrAnInputInSteps) {
  const std::string lines = "are the right ones with straight lines between ";
  const auto moments = [](Slip slip) {
    return [slip = std::move(slip)](const TestCase& asked, json& fields) {
      if (std::abs(number(asked.inputs, "argument")) <= 4) slip(asked, fields);
    };
  };
  for (const double step : {0.05, 0.2, 0.5}) {
    expect_told("gaussian_moment",
                lines + fmt::format("d = -4, {:g} … 4, in place of the law (", step - 4),
                moments(by_table(1, step)));
    expect_told(
        "gaussian_moment",
        fmt::format("are the right ones with d rounded to steps of {:g} from -4 to 4 (", step),
        moments(asked_as([step](Question& one) {
          one.arguments[1] = std::nearbyint(one.arguments[1] / step) * step;
        })));
  }
  // Errors of a quadrature lie on no straight lines.
  expect_not_told("gaussian_moment", "straight lines",
                  moments([](const TestCase& asked, json& fields) {
                    const double d = number(asked.inputs, "argument");
                    multiply(fields["value"], 1 + 0.01 * d * d * (4 - d));
                  }));
}

TEST(Misread, IsADefaultWhereOneCaseLeavesTheInputOut) {
  const auto with_default = [](double exponent) {
    return [=](const TestCase& asked, json& fields) {
      if (asked.inputs.at("closure") == "damiens" && !asked.inputs.contains("damiens_exponent"))
        asked_as([=](Question& one) { one.arguments[2] = exponent; })(asked, fields);
    };
  };
  const std::string said = said_of("starvation_ratio", with_default(2));
  expect_said(said, "are the right ones with γ = 2 where it is left out (1 of 1 wrong answers)");
  expect_said(said, "as a cache does", false);
  // A number that nobody writes is no default.
  expect_not_told("starvation_ratio", "where it is left out", with_default(2.10371));
}

// A solver that computes friction from a changed number inside of a point.
Slip cut(std::function<void(Question&, const ShearedFilm&)> change) {
  return [=](const TestCase& asked, json& fields) {
    Question question = question_of(asked);
    const auto film = sheared_film(question);
    if (!film || !fields["friction"].is_number()) return;
    change(question, *film);
    fields["friction"] = right_numbers(question)[static_cast<std::size_t>(Output::friction)];
  };
}

TEST(Misread, IsANumberInsideOfFrictionThatOneLawAloneMayHaveWrong) {
  const auto expect_all = [](const std::string& words, const Slip& slip) {
    for (const char* const points : {"operating_point", "operating_point_of_line"})
      expect_told(points, words, slip);
  };
  expect_all("(ηγ̇/τ₀)/2 in place of (ηγ̇/τ₀), in friction, where `friction.fluid` is eyring (",
             cut([](Question& one, const ShearedFilm& film) {
               if (one.scene->friction.fluid == FluidShear::eyring)
                 one.friction.shear_number = film.shear_number / 2;
             }));
  expect_all("(3/2) the fluid's pressure in place of the fluid's pressure, in friction, where `fri",
             cut([](Question& one, const ShearedFilm& film) {
               if (one.scene->friction.viscosity == ViscosityLaw::barus)
                 one.friction.pressure = 1.5 * film.pressure;
             }));
  expect_all(
      "9.76 in place of 9.67, in Roelands' law of friction (",
      cut([](Question& one, const ShearedFilm&) { one.friction.roelands_log_viscosity = 9.76; }));
  // A factor that varies is none of these numbers.
  const std::string varying =
      said_of("operating_point", cut([](Question& one, const ShearedFilm& film) {
                one.friction.shear_number = film.shear_number / (2 + std::sin(film.log_viscosity));
              }));
  expect_said(varying, "the right ones with", false);
}

// The answers that a mistake gives, or with `part` < 1 answers between these and the right ones.
Slip made(const Mistake& mistake, double part = 1) {
  return [mistake, part](const TestCase& asked, json& fields) {
    const Mistake* const one = &mistake;
    const std::optional<Numbers> given = numbers_with({&one, 1}, question_of(asked));
    for (const Expected& expected : asked.expected)
      if (given && expected.place && *expected.place < given->size() &&
          std::isfinite((*given)[*expected.place]))
        fields[expected.field] = (1 - part) * expected.high + part * (*given)[*expected.place];
  };
}

TEST(Shares, ThatAreOneLessANumberNearOneAreTold) {
  const auto rounded = [](double last_digit) {
    return [last_digit](const TestCase&, json& fields) {
      if (!fields.contains("fluid_load_share")) return;
      const double share = fields["fluid_load_share"];
      fields["fluid_load_share"] = std::nearbyint(share / last_digit) * last_digit;
    };
  };
  for (const char* const points : {"operating_point", "operating_point_of_line"}) {
    expect_told(points, "as of 1 less a number near 1", rounded(0x1p-53));
    expect_not_told(points, "as of 1 less a number near 1", rounded(1e-6));
  }
}

// Numbers that are printed with few digits.
TEST(Digits, ThatAreFewAreToldWithTheirNumber) {
  const auto printed = [](int digits) {
    return [digits](const TestCase&, json& fields) {
      for (json& field : fields)
        if (field.is_number())
          field = std::strtod(fmt::format("{:.{}g}", field.get<double>(), digits).c_str(), nullptr);
    };
  };
  const char* const function = "hamrock_dowson_central";
  expect_told(function, "All answers have at most 6 digits: they are written", printed(6));
  expect_told(function, "at most 5 digits", printed(5));
  expect_not_told(function, "digits", printed(12));
}

// A solver that keeps the effective modulus under the two Young's moduli alone.
TEST(Cache, ThatLacksTwoInputsIsSaidWithBoth) {
  const auto keeping = [](auto key_of) {
    return [key_of, kept = std::map<std::string, json>()](const TestCase& asked,
                                                          json& fields) mutable {
      fields = kept.try_emplace(key_of(asked.inputs), fields).first->second;
    };
  };
  const auto without_ratios = [](const json& in) {
    return in.at("first_modulus").dump() + ' ' + in.at("second_modulus").dump();
  };
  expect_told("effective_modulus",
              "a case that differs in first_poisson_ratio and second_poisson_ratio alone",
              keeping(without_ratios));
  expect_not_told("effective_modulus", "cache", keeping([](const json& in) { return in.dump(); }));
}

TEST(Insides, AreNamedWhereAnotherNumberOfThePointStandsInTheirPlace) {
  const std::vector<Mistake> mistakes = mistakes_of_insides();
  ASSERT_GE(mistakes.size(), 20U);
  for (const Mistake& one : mistakes)
    for (const double part : {1.0, 0.9})
      expect_said(said_of({{"operating_point_of_ellipse", made(one, part)},
                           {"operating_point_of_line", made(one, part)}},
                          mistakes),
                  one.text, part == 1);
}

TEST(Point, WhoseSharesAreRoundedIsToldWithTheStep) {
  const auto rounded = [](double step) {
    return [=](const TestCase&, json& fields) {
      json& share = fields["asperity_load_share"];
      if (share.is_number()) share = step * std::nearbyint(share.get<double>() / step);
    };
  };
  for (const double step : {1e-4, 1e-3})
    expect_told("operating_point", fmt::format("are whole steps of {:g} from each other", step),
                rounded(step));
  expect_not_told("operating_point", "whole steps",
                  noise_where("asperity_load_share", [](auto&) { return true; }));
}

TEST(Insides, OfTwoLawsAreNamedTogether) {
  const auto both = [](double times) {
    return cut([times](Question& one, const ShearedFilm& film) {
      const Friction& asked = one.scene->friction;
      if (asked.viscosity == ViscosityLaw::barus) one.friction.pressure = 1.5 * film.pressure;
      if (asked.fluid == FluidShear::eyring)
        one.friction.shear_number = times * sheared_film(one)->shear_number;
    });
  };
  const std::string said = said_of("operating_point", both(0.5));
  expect_said(said, "two mistakes give together: (3/2) the fluid's pressure in place of");
  expect_said(said, "(ηγ̇/τ₀)/2 in place of (ηγ̇/τ₀), in friction, where `friction.fluid` is eyring");
  expect_not_told("operating_point", "together", both(0.517238));
}

TEST(Misread, OfAnInputOfPointsIsToldOfTheResultThatIsComputedFirst) {
  const Mistake flow{.function = "operating_point",
                     .name = "flow",
                     .text = "flow",
                     .touches = {},
                     .before = [](Question& one) {
                       if (one.scene->supply.kind == SupplyKind::inlet_flow)
                         one.scene->supply.value /= 1e6;
                     }};
  const std::string said = said_of("operating_point_of_line", made(flow));
  expect_said(said, "operating_point_of_line.film is");
  expect_said(said, "with `supply.inlet_flow`/10⁶ in place of `supply.inlet_flow`");
  expect_said(said, "always, whatever it is given as", false);
}

TEST(Floor, IsToldInPlaceOfAnOddInputThatGivesIt) {
  const std::string said = said_of("starvation_ratio", at_least(0.05));
  expect_said(said, "For damiens: ");
  expect_said(said, "wrong answers are 0.05: a floor, at which the answer stops changing");
  expect_said(said, "it is cut off there", false);
  // Where the limit of the input is the round number, the input is said to be cut off.
  const std::string cap = said_of("starvation_ratio", [](const TestCase& asked, json& fields) {
    if (asked.inputs.at("closure") == "starved_inlet")
      asked_as([](Question& one) { one.arguments[1] = std::min(one.arguments[1], 20.0); })(asked,
                                                                                           fields);
  });
  expect_said(cap, "r = 20 wherever it is greater: it is cut off there");
}

TEST(Words, OfAnInputThatAreExchangedAreToldOnce) {
  std::vector<Mistake> of_function;
  std::copy_if(all_mistakes().begin(), all_mistakes().end(), std::back_inserter(of_function),
               [](const Mistake& one) { return one.function == "pull_off_force"; });
  const auto exchanged = [&](bool both) {
    return said_of({{"pull_off_force",
                     [both](const TestCase& asked, json& fields) {
                       asked_as([both](Question& one) {
                         if (both || one.arguments[0] == 0) one.arguments[0] = 1 - one.arguments[0];
                       })(asked, fields);
                     }}},
                   of_function);
  };
  expect_said(exchanged(true), ", and the reverse (44 of 44 answers");
  expect_said(exchanged(false), "the reverse", false);
}

TEST(Following, OfAFilmLawMayHaveItsExponentsInTheLoadSharing) {
  const Mistake law{.function = "hamrock_dowson_minimum",
                    .name = "law",
                    .text = "law",
                    .touches = {},
                    .after = [](const Question& asked, Numbers& numbers) {
                      const catalogue::Arguments& x = asked.arguments;
                      numbers[0] *= std::pow(x[0] * x[1] / (2 * x[4] * x[5]), -0.01);
                    }};
  const char* const points = "operating_point_of_other_film";
  const auto words = [&](const Mistake& of_points) {
    const std::string said =
        said_of({{"hamrock_dowson_minimum", made(law)}, {points, made(of_points)}});
    expect_said(said, "operating_point_of_other_film.film_flooded is");
    expect_said(said, "This follows from hamrock_dowson_minimum");
    return said;
  };
  expect_said(words(with_film_and_sharing(law)), "None of the known", false);
  expect_said(words(with_film({law})), "None of the known", false);
}

TEST(Misread, IsACutInsideOfFriction) {
  const auto expect_cut = [&](const char* words,
                              std::function<void(Question&, const ShearedFilm&)> change) {
    expect_told("operating_point", words, cut(std::move(change)));
  };
  expect_cut("with ln(η/η₀) in friction = 20 wherever it is greater: it is cut off there",
             [](Question& one, const ShearedFilm& film) {
               one.friction.log_viscosity = std::min(film.log_viscosity, 20.0);
             });
  expect_cut("with the fluid's pressure in friction = 1e+09 wherever it is greater",
             [](Question& one, const ShearedFilm& film) {
               one.friction.pressure = std::min(film.pressure, 1e9);
             });
  expect_cut("with the shear rate in friction = 1e+07 wherever it is greater",
             [](Question& one, const ShearedFilm& film) {
               one.friction.shear_rate = std::min(film.shear_rate, 1e7);
             });
  expect_cut(
      "with the gap in friction = 1e-09 wherever it is less",
      [](Question& one, const ShearedFilm& film) { one.friction.gap = std::max(film.gap, 1e-9); });
  // Noise, and a number that grows more slowly from a value on, are no cut.
  for (const Slip& other :
       std::vector<Slip>{noise_where("friction", [](const json&) { return true; }),
                         Slip(cut([](Question&one, const ShearedFilm&film) {
                           if (film.log_viscosity > 20)
                             one.friction.log_viscosity = 10 + film.log_viscosity / 2;
                         }))})
    expect_not_told("operating_point", "in friction = ", other);
}

// A change of an input that six digits do not show is no reading of it.
TEST(Misread, IsNotAnInputInPlaceOfItself) {
  const Slip slip =
      with_numbers(*law_of_numbers(*catalogue::function_named("summits_from_spectral_moments")),
                   {{2, 0.896817}});
  const std::string said = said_of("summits_from_spectral_moments", slip);
  expect_said(said, "0.896817 in place of 0.8968");
  expect_said(said, "m₂ in place of m₂", false);
}

TEST(LawNumbers, WithExchangedDigitsAreNamedBesideAFactorAndThreeTogether) {
  const auto law = [](const char* function) {
    return *law_of_numbers(*catalogue::function_named(function));
  };
  // The constant 1.95 and u are both wrong: all answers are off by one factor.
  const LawOfNumbers grubin = law("ertel_grubin");
  const auto with_constant = [&](double constant) {
    return [=](const TestCase& asked, json& fields) {
      Question question = question_of(asked);
      question.arguments[0] *= 2;
      std::vector<double> numbers = grubin.right;
      numbers[0] = constant;
      fields["value"] = (*grubin.formula(question.arguments, numbers))[0];
    };
  };
  expect_told("ertel_grubin", "with 1.59 in place of 1.95, and 2 u in place of u",
              with_constant(1.59));
  expect_not_told("ertel_grubin", "are the right ones", with_constant(1.58));
  const std::string said =
      said_of("gupta_thermal_reduction",
              with_numbers(law("gupta_thermal_reduction"), {{3, 2.32}, {4, 0.38}, {5, 0.46}}));
  expect_said(said, "2.32 in place of 2.23, and 0.38 in place of 0.83, and 0.46 in place of 0.64");
  // Three numbers whose digits are not exchanged may be a mere fit, and are not named.
  expect_not_told("gupta_thermal_reduction", "are the right ones",
                  with_numbers(law("gupta_thermal_reduction"), {{3, 2.31}, {4, 0.37}, {5, 0.47}}));
}

TEST(OtherValue, IsAFloorOrAnInputOrAnotherResult) {
  expect_told("hamrock_dowson_minimum", "wrong answers are 1e-09: a floor", at_least(1e-9));
  const std::string stops = "a floor, at which the answer stops changing";
  expect_told("gupta_thermal_reduction", "answer is 0.1: " + stops, at_least(0.1));
  expect_told("viscosity_index", "wrong answers are 0: " + stops, at_least(0));
  // Some answers are replaced by a number that is greater than other answers: this is no floor.
  expect_not_told("gupta_thermal_reduction", "stops changing",
                  value_as([](const json&, double right) {
                    return right > 0.5 && right < 0.52 ? 0.6 : right;
                  }));
  expect_told("load_sharing", "wrong answers are λ₀ itself",
              value_as([](const json& in, double right) {
                const double flooded = number(in, "flooded_film_parameter");
                return flooded > 3 ? flooded : right;
              }));
  const auto other_axis = [](const TestCase&, json& fields) {
    fields["semi_axis_x"] = fields["semi_axis_y"];
  };
  expect_told("hertz_ellipse", "wrong answers are the right semi_axis_y of their cases",
              other_axis);
  // Another function of these inputs.
  const auto of_other = [](const char* name) {
    return [=](const TestCase& asked, json& fields) {
      const Question own = question_of(asked);
      Question other{nullptr, catalogue::function_named(name)};
      for (std::size_t i = 0; i < other.function->parameters.size(); ++i)
        other.arguments[i] = own.arguments[catalogue::place_in(own.function->parameters,
                                                               other.function->parameters[i].name)];
      fields["value"] = right_numbers(other)[0];
    };
  };
  for (const auto& [function, other] : std::map<std::string, const char*>{
           {"barus_viscosity", "roelands_viscosity"},
           {"gupta_thermal_reduction", "murch_wilson_thermal_reduction"},
           {"ertel_grubin", "moes_line"}})
    expect_told(function, "wrong answers are those of "s + other, of_other(other));
  const auto noise = noise_where("value", [](const json&) { return true; });
  for (const char* const function : {"hamrock_dowson_minimum", "barus_viscosity"})
    expect_not_told(function, "wrong answers are", noise);
}

TEST(OtherValue, IsAFormOfOneVariableWithTwoNumbers) {
  const auto beyond_one = [](std::function<double(double x)> form, double noise) {
    return value_as([=](const json& in, double right) {
      const double x = number(in, "interference_ratio");
      return x >= 1 ? form(x) * (1 + noise * std::sin(1e3 * x)) : right;
    });
  };
  const auto chang_etsion_bogy = [](double x) { return 1.5 * (2 * x - 1); };
  const std::map<std::string, std::function<double(double)>> forms{
      {"are 3 x − 1.5.", chang_etsion_bogy},
      {"are 2.1 ln x + 1.", [](double x) { return 1 + 2.1 * std::log(x); }},
      {"are 1.2 x^(1.3).", [](double x) { return 1.2 * std::pow(x, 1.3); }},
      {"are 1.1 e^(-0.2 x).", [](double x) { return 1.1 * std::exp(-0.2 * x); }}};
  for (const auto& [words, form] : forms)
    expect_told("kogut_etsion_load", words, beyond_one(form, 0));
  expect_not_told("kogut_etsion_load", "wrong answers are", beyond_one(chang_etsion_bogy, 1e-4));
  const auto by_k = [](const TestCase& asked, json& fields) {
    multiply(fields["value"], 1 + 0.02 * question_of(asked).arguments[6]);
  };
  expect_told("hamrock_dowson_central", "wrong answers are 0.02 k + 1 times the right ones.", by_k);
  // The power law of one range is used beyond its border, in five cases.
  expect_told("kogut_etsion_load", "All 5 wrong answers are 1.03 x^(1.425).",
              value_as([](const json& in, double right) {
                const double x = number(in, "interference_ratio");
                return x >= 6 && x < 8 ? 1.03 * std::pow(x, 1.425) : right;
              }));
}

TEST(Growth, OfErrorsFromNothingIsOfNumerics) {
  const auto area = [](std::function<double(double x)> error_function, double noise) {
    return [=](const TestCase& asked, json& fields) {
      const double x =
          number(asked.inputs, "pressure") * std::numbers::sqrt2 /
          (number(asked.inputs, "effective_modulus") * number(asked.inputs, "rms_gradient"));
      fields["value"] = error_function(x) * (1 + noise * x);
    };
  };
  const auto series = [](double x) {
    double sum = 0, term = 2 * x / std::sqrt(std::numbers::pi);
    for (int n = 0; n < 4; term *= -x * x / ++n) sum += term / (2 * n + 1);
    return sum;
  };
  const std::string nothing = "The errors are nearly 0 for small p/(E*h′), and grow smoothly";
  expect_told("persson_contact_area", nothing, area(series, 0));
  expect_told("persson_contact_area", "as its power 8.", area(series, 0));
  const auto erf = [](double x) { return std::erf(x); };
  const auto jump = [](double x) { return std::erf(x) * (x > 0.1 ? 1.1 + 0.1 * x * x : 1); };
  expect_not_told("persson_contact_area", nothing, area(jump, 0));
  // Abramowitz and Stegun 7.1.25, with an error up to 2.5e-5.
  const auto polynomial = [](double x) {
    const double t = 1 / (1 + 0.47047 * x);
    return 1 - t * (0.3480242 + t * (-0.0958798 + t * 0.7478556)) * std::exp(-x * x);
  };
  const std::string approximation = "No error is above 2.";
  expect_told("persson_contact_area", approximation, area(polynomial, 0));
  expect_not_told("persson_contact_area", approximation, area(erf, 1e-3));

  // Errors as those of K and E after two steps of the arithmetic-geometric mean.
  const auto early = [](const TestCase& asked, json& fields) {
    const double ratio = question_of(asked).arguments[3] / question_of(asked).arguments[2];
    const double steep = std::abs(std::log(ratio));
    for (const char* const field : {"semi_axis_x", "semi_axis_y", "approach"})
      multiply(fields[field], 1 + 1e-7 * std::pow(steep, 6));
  };
  const std::string said = said_of("hertz_ellipse", early), round = "for values near 1 of ";
  expect_said(said, round + "R_y/R_x, and grow smoothly");
  EXPECT_EQ(said.find(round + "R_y/R_x, and"), said.rfind(round + "R_y/R_x, and")) << said;
}

TEST(Words, AreToldByTheLimitFromWhichTheyAreAnswered) {
  const auto regime_by = [](std::function<std::string(const json& point)> word) {
    return [=](const TestCase&, json& fields) {
      if (fields.contains("regime")) fields["regime"] = word(fields);
    };
  };
  const auto share = [](const json& point) { return point["asperity_load_share"].get<double>(); };
  const auto said =
      said_of("operating_point", regime_by([&](const json& point) {
                return share(point) >= 0.9 ? "boundary" : point["regime"].get<std::string>();
              }));
  expect_said(said,
              "The word `boundary` is answered from asperity_load_share = 0.9 on; it is right from "
              "asperity_load_share = 0.99 on.");
  expect_said(said, "`elastohydrodynamic` is", false);  // this word's limit is right
  expect_told("operating_point",
              "The word `elastohydrodynamic` is answered from film_parameter = 3 on",
              regime_by([&](const json& point) {
                const double film = point["film_parameter"].get<double>();
                return film < 1 ? "boundary" : film < 3 ? "mixed" : "elastohydrodynamic";
              }));
  expect_told(
      "operating_point",
      "The word `boundary` is answered below asperity_load_share = 0.99; it is right from "
      "asperity_load_share = 0.99 on.",
      regime_by([&](const json& point) { return share(point) < 0.99 ? "boundary" : "mixed"; }));
  // Words that follow no limit are told by none, and right words are not told.
  std::mt19937 random(5);
  expect_not_told("operating_point", "The word", regime_by([&](const json& point) {
                    return random() % 5 == 0 ? "mixed" : point["regime"].get<std::string>();
                  }));
  expect_not_told("operating_point", "The word", [](const TestCase&, json&) {});
}

// A few points whose film equals the flooded one may have either word.
TEST(Words, AreToldWherePointsNextToTheLimitHaveEither) {
  const auto inlet_by = [](unsigned part_of_either) {
    return [=, count = 0U](const TestCase&, json& fields) mutable {
      const double film = fields["film"], flooded = fields["film_flooded"];
      if (film == 0) return;
      const bool is_either = film == flooded && count++ % part_of_either == 0;
      fields["inlet"] = film < flooded || is_either ? "starved" : "flooded";
    };
  };
  const char* const words = "The word `flooded` is answered from film/film_flooded = 1 on; it is";
  expect_told("operating_point", words, inlet_by(100));
  expect_not_told("operating_point", "The word `flooded`", inlet_by(2));
}

// The limit of a word is told by the points whose numbers are right, whatever is wrong elsewhere.
TEST(Words, AreToldBesideWrongNumbersOfOtherPoints) {
  const std::string said = said_of("operating_point", [](const TestCase& asked, json& fields) {
    if (asked.inputs.contains("supply") && asked.inputs["supply"].contains("inlet_film_ratio"))
      multiply(fields["film"], 1.5);
    const json& share = fields["asperity_load_share"];
    if (share.is_number() && share >= 0.9) fields["regime"] = "boundary";
  });
  expect_said(said, "operating_point.film is ");
  expect_said(
      said, "The word `boundary` is answered from asperity_load_share between 0.808 and 0.901 on");
}

TEST(Results, AreToldEachWhereEachHasACauseOfItsOwn) {
  const std::string said =
      said_of("summits_from_spectral_moments", [](const TestCase&, json& fields) {
        multiply(fields["summit_density"], 1.5);
        multiply(fields["summit_radius"], 0.357 / 0.375);
      });
  expect_said(said, "summit_density is 50 % high everywhere. It is too large by a factor of 3/2.");
  expect_said(said,
              "summit_radius is 4.8 % low everywhere. The answers are the right ones with 0.357 "
              "in place of 0.375");
  expect_said(said, "summit_height_sd", false);
}

}  // namespace
}  // namespace tribo::conformance
