// SPDX-License-Identifier: Apache-2.0
// The rules that judge another solver: errors that a tolerance allows, verdicts on a quantity, what
// counts as worse than a baseline, and when a known mistake is named.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "conformance/answers.hpp"
#include "conformance/conformance_baseline.hpp"
#include "conformance/question.hpp"
#include "conformance/readings.hpp"
#include "conformance/viscosity_index_table.hpp"
#include "sampling/sampler.hpp"
#include "scene/schema.hpp"
#include "support/judge.hpp"
#include "support/temporary_folder.hpp"
#include "support/threshold.hpp"
#include "tribo/viscosity_index.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;
using verification::changes_at_its_limit;
using verification::is_close;
using verification::True;

constexpr Contract contract{4, 0.5};  // 4 ulp, or half an ulp times the condition

TestCase asked_for(std::vector<Expected> expected, std::string id = "a") {
  for (Expected& one : expected) one.quantity = "film";
  return {std::move(id), "film", json::object(), contract, std::move(expected), false};
}
Expected number(double high, double condition = 1) {
  return {.field = "value", .high = high, .condition = condition, .quantity = "film"};
}

Tolerance own_tolerance() {
  Tolerance tolerance = engineering_tolerance();
  tolerance.quantity["film"] = 1e-3;
  return tolerance;
}

// --- Allowed errors.

TEST(AllowedError, IsThePartOfTheValueTimesItsCondition) {
  for (const double condition : {1.0, 10.0, 1e4}) {
    const Expected expected = number(-8, condition);
    const TestCase asked = asked_for({expected});
    EXPECT_TRUE(is_close(allowed_error(asked, expected, engineering_tolerance()), 8e-6 * condition,
                         1e-15, {{"condition", condition}}));
    EXPECT_TRUE(is_close(allowed_error(asked, expected, own_tolerance()), 8e-3 * condition, 1e-15,
                         {{"condition", condition}}));
  }
}

TEST(AllowedError, OfTheStrictToleranceIsTheContract) {
  const double ulp = 0x1p-49;  // of 8
  const auto allowed = [](double condition) {
    const Expected expected = number(8, condition);
    return allowed_error(asked_for({expected}), expected, strict_tolerance());
  };
  EXPECT_EQ(allowed(1), 4 * ulp);
  EXPECT_EQ(allowed(8), 4 * ulp);
  EXPECT_EQ(allowed(16), 8 * ulp);
  EXPECT_EQ(allowed(1600), 800 * ulp);
  const Expected nothing = number(0);
  EXPECT_EQ(allowed_error(asked_for({nothing}), nothing, strict_tolerance()),
            4 * std::numeric_limits<double>::denorm_min());
}

// --- Verdicts on a quantity from its answers.

Reply with(json fields) { return {Outcome::answered, std::move(fields), {}}; }
Reply without(Outcome outcome) { return {outcome, {}, "why"}; }

ConformanceResult judged(const std::vector<TestCase>& cases, std::vector<Reply> answers) {
  Conversation conversation;
  conversation.answers = std::move(answers);
  return judge("subject", cases, conversation, engineering_tolerance());
}
QuantityVerdict verdict_on(const Expected& expected, Reply answer) {
  return judged({asked_for({expected})}, {std::move(answer)}).quantities.at(0);
}
Verdict status_of(const Expected& expected, json value) {
  return verdict_on(expected, with({{"value", std::move(value)}})).status;
}

TEST(JudgedAnswer, IsHeldUpToItsBoundOnBothSides) {
  const Expected expected = number(2, 10);  // 2e-5 is allowed
  const auto holds = [](const Expected& of, double got) {
    return status_of(of, got) == Verdict::held;
  };
  for (const double side : {-1.0, 1.0})
    EXPECT_TRUE(
        changes_at_its_limit({"of a number", 2e-5, True::up_to,
                              [&](double x) { return holds(expected, 2 + side * x); }, 1e-10}));
  // Numbers that are 0, or so small that they do not matter in engineering.
  EXPECT_TRUE(changes_at_its_limit(
      {"of nothing", 1e-30, True::up_to, [&](double x) { return holds(number(0), x); }}));
  EXPECT_TRUE(
      changes_at_its_limit({"of a tiny number", 1e-30, True::up_to,
                            [&](double x) { return holds(number(1e-27), 1e-27 + x); }, 1e-12}));
  const auto plays_a_part = [](double value) {
    return verdict_on(number(value), with({{"value", value * (1 + 1e-7)}})).held_cases[0].error > 0;
  };
  EXPECT_TRUE(changes_at_its_limit({"of a part", 1e-24, True::above, plays_a_part, 1e-15}));
  const QuantityVerdict verdict = verdict_on(expected, with({{"value", 2 + 1e-5}}));
  EXPECT_TRUE(is_close(verdict.worst.part_of_bound, 0.5, 1e-9, {}));
  EXPECT_TRUE(is_close(verdict.worst_relative, 5e-6, 1e-9, {}));
}

// The expected number has more digits than a double.
TEST(JudgedAnswer, IsComparedWithBothPartsOfTheValue) {
  const Expected expected{"value", 1, 3e-6, 1, {}};
  EXPECT_EQ(status_of(expected, 1.0), Verdict::failed);
  EXPECT_EQ(status_of(expected, 1.0000025), Verdict::held);
}

TEST(JudgedAnswer, OfAWordIsJustThatWord) {
  const Expected word{"value", 0, 0, 1, "mixed"};
  EXPECT_EQ(status_of(word, "mixed"), Verdict::held);
  EXPECT_EQ(status_of(word, "boundary"), Verdict::failed);
  EXPECT_EQ(status_of(word, nullptr), Verdict::failed);
}

TEST(JudgedAnswer, ThatDoesNotComeFailsAndOneThatIsSkippedDoesNot) {
  for (const Outcome outcome : {Outcome::refused, Outcome::garbage, Outcome::missing, Outcome::late,
                                Outcome::died, Outcome::not_asked}) {
    const QuantityVerdict verdict = verdict_on(number(2), without(outcome));
    EXPECT_EQ(verdict.status, Verdict::failed) << static_cast<int>(outcome);
    EXPECT_EQ(verdict.failed_cases.at(0).how, Failure::no_answer) << static_cast<int>(outcome);
  }
  EXPECT_EQ(verdict_on(number(2), without(Outcome::skipped)).status, Verdict::not_offered);
}

TEST(JudgedAnswer, WithoutAFieldThatOthersHaveFails) {
  const std::vector<TestCase> cases{asked_for({number(2)}, "a"), asked_for({number(2)}, "b")};
  EXPECT_EQ(judged(cases, {with({{"value", 2}}), with(json::object())}).quantities[0].failed, 1U);
  EXPECT_EQ(judged(cases, {with(json::object()), with(json::object())}).quantities[0].status,
            Verdict::not_offered);
}

TEST(JudgedQuantity, CountsEachOfItsCases) {
  const std::vector<TestCase> cases{asked_for({number(2)}, "a"), asked_for({number(2)}, "b"),
                                    asked_for({number(2)}, "c"), asked_for({number(2)}, "d")};
  const Reply right = with({{"value", 2}}), wrong = with({{"value", 3}}),
              skipped = without(Outcome::skipped);
  const QuantityVerdict all = judged(cases, {skipped, right, wrong, right}).quantities.at(0);
  EXPECT_EQ(all.asked, 4U);
  EXPECT_EQ(all.held, 2U);
  EXPECT_EQ(all.failed, 1U);
  EXPECT_EQ(all.skipped, 1U);
  EXPECT_EQ(all.status, Verdict::failed);
  EXPECT_EQ(all.worst.id, "c");
  EXPECT_TRUE(all.first_reason.starts_with("c: ")) << all.first_reason;
  const QuantityVerdict part = judged(cases, {right, right, skipped, right}).quantities[0];
  EXPECT_EQ(part.status, Verdict::partly_held);
  EXPECT_EQ(part.first_reason, "why");
  EXPECT_EQ(judged(cases, {right, right, right, right}).quantities[0].status, Verdict::held);
}

// A solver keeps its answers, but ignores `input` when it looks for one: it repeats an old answer
// if the other inputs are the same. With `forgets_soon` it keeps only the answer to the case
// before. Returns whether an ordinary case shows that.
bool is_shown(std::string_view function, const std::string& input, bool forgets_soon) {
  std::map<std::string, const TestCase*> kept;
  for (const TestCase& one : all_cases()) {
    if (one.function != function || one.is_extreme) continue;
    json others = one.inputs.flatten();
    others.erase(input);
    const auto found = kept.find(others.dump());
    const TestCase& before = found == kept.end() ? one : *found->second;
    for (const Expected& now : one.expected)
      for (const Expected& then : before.expected)
        if (now.field == then.field && now.is_physical &&
            (now.word != then.word || std::abs(now.high - then.high) > 1e-4 * std::abs(now.high)))
          return true;
    if (forgets_soon) kept.clear();
    kept.insert_or_assign(others.dump(), &one);
  }
  return false;
}

TEST(Cases, ShowASolverThatForgetsOneInput) {
  std::map<std::string, std::set<std::string>> inputs;
  for (const TestCase& one : all_cases()) {
    const json flat = one.inputs.flatten();
    for (const auto& [input, value] : flat.items())
      if (input != "/function") inputs[one.function].insert(input);
  }
  for (const auto& [function, names] : inputs)
    for (const std::string& input : names)
      for (const bool forgets_soon : {false, true})
        // Cases of moments are sorted by order. Neighbours do not differ in the order alone.
        EXPECT_EQ(is_shown(function, input, forgets_soon), !forgets_soon || input != "/order")
            << function << " without " << input << (forgets_soon ? ", from the case before" : "");
}

// For each default, a case that leaves the input out shows a solver with another default.
TEST(Cases, LeaveOutEachDefault) {
  for (const catalogue::Function& function : catalogue::functions())
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
      const catalogue::Parameter& parameter = function.parameters[i];
      if (!parameter.default_value) continue;
      std::size_t shown = 0;
      for (const TestCase& one : all_cases()) {
        if (one.in_catalogue != &function || one.inputs.contains(parameter.name)) continue;
        catalogue::Arguments x = question_of(one).arguments;
        EXPECT_EQ(x[i], *parameter.default_value) << one.id;
        x[i] = parameter.words.empty() ? 1.5 * x[i] : x[i] == 0 ? 1 : 0;
        catalogue::Results results{};
        function.value(x, results);
        const Expected& expected = one.expected.at(0);
        shown += std::abs(results[0] - expected.high) >
                 allowed_error(one, expected, engineering_tolerance());
      }
      EXPECT_GE(shown, 1U) << function.name << ' ' << parameter.name;
    }
  // For scenes: each field that a point of the kind may leave out.
  std::map<std::string, std::map<std::string, std::set<bool>>> given;
  for (const TestCase& one : all_cases())
    if (is_operating_point(one.function))
      for (const FieldInfo& field : scene_fields()) {
        std::string pointer = '/' + std::string(field.path);
        std::replace(pointer.begin(), pointer.end(), '.', '/');
        if (!field.default_text.empty())
          given[one.function][std::string(field.path)].insert(
              one.inputs.contains(json::json_pointer(pointer)));
      }
  for (const auto& [function, fields] : given)
    for (const auto& [field, both] : fields) {
      const bool is_what_the_kind_is = field == "closures.film" && function != "operating_point" &&
                                       function != "operating_point_of_ellipse";
      EXPECT_EQ(both.contains(false), !is_what_the_kind_is)
          << function << ": " << field << " is always given";
    }
}

// These cases show a solver that keeps an input of the question before in place of its default.
TEST(Cases, StandBehindThoseThatGiveWhatTheyLeaveOutOtherwise) {
  std::map<std::string, std::size_t> kept;  // by function and path of what is left out
  const std::vector<TestCase>& cases = all_cases();
  for (std::size_t i = 1; i < cases.size(); ++i) {
    if (cases[i].before.is_null()) continue;
    EXPECT_EQ(cases[i].before, cases[i - 1].inputs) << cases[i].id;
    EXPECT_EQ(cases[i].function, cases[i - 1].function) << cases[i].id;
    const json left = cases[i].inputs.flatten(), before = cases[i].before.flatten();
    for (const auto& [path, value] : before.items())
      if (!left.contains(path)) ++kept[cases[i].function + path];
  }
  for (const catalogue::Function& function : catalogue::functions())
    for (const catalogue::Parameter& parameter : function.parameters)
      if (parameter.default_value) {
        EXPECT_GE(kept[fmt::format("{}/{}", function.name, parameter.name)], 1U)
            << function.name << ' ' << parameter.name;
      }
  for (const FieldInfo& field : scene_fields()) {
    std::string path = '/' + std::string(field.path);
    std::replace(path.begin(), path.end(), '.', '/');
    const bool is_given = std::any_of(cases.begin(), cases.end(), [&](const TestCase& one) {
      return one.function == "operating_point" && one.inputs.contains(json::json_pointer(path));
    });
    if (!field.default_text.empty() && is_given && field.path != "closures.film") {
      EXPECT_GE(kept["operating_point" + path], 1U) << field.path;
    }
  }
}

// The conversation with a solver whose answers are all computed by `value`.
Conversation answered_by(const std::vector<TestCase>& cases, double (*value)(const Question&)) {
  Conversation conversation;
  for (const TestCase& one : cases)
    conversation.answers.push_back(with({{one.expected.at(0).field, value(question_of(one))}}));
  return conversation;
}
double roelands(const Question& asked, double pole) {
  const auto [viscosity, alpha, pressure] =
      std::array{asked.arguments[0], asked.arguments[1], asked.arguments[2]};
  const double scale = std::log(viscosity / pole), z = alpha * 1.96e8 / scale;
  return viscosity * std::exp(scale * std::expm1(z * std::log1p(pressure / 1.96e8)));
}
double walther(const Question& asked) {
  using Real = long double;  // the strict tolerance is only a few ulp
  const auto z = [](Real nu) {
    nu *= 1e6L;
    return std::log(std::log(nu + 0.7L + std::exp(-1.47L - 1.84L * nu - 0.51L * nu * nu)));
  };
  const catalogue::Arguments& x = asked.arguments;
  const Real slope = (z(x[3]) - z(x[1])) / std::log(Real(x[2]) / x[0]);
  const Real t = std::exp(std::exp(z(x[1]) + slope * std::log(Real(x[4]) / x[0]))) - 0.7L;
  const Real less = std::exp(-0.7487L - 3.295L * t + 0.6119L * t * t - 0.3193L * t * t * t);
  return static_cast<double>((t - less) / 1e6L);
}

// The index by the standard's table 1: linear between its rows, or constant if `is_held`.
double index_of_table(const Question& asked, bool is_held) {
  const double u = 1e6 * asked.arguments[0], y = 1e6 * asked.arguments[1];
  double zero = 0.8353 * y * y + 14.67 * y - 216, hundred = 0.1684 * y * y + 11.85 * y - 97;
  for (std::size_t row = 1; row < index_table.size(); ++row) {
    const double from = index_table_tenths(row - 1) / 10.0, to = index_table_tenths(row) / 10.0;
    if (y < from || y > to) continue;
    const double part = is_held ? 0 : (y - from) / (to - from);
    zero = std::lerp(index_table[row - 1].zero, index_table[row].zero, part);
    hundred = std::lerp(index_table[row - 1].hundred, index_table[row].hundred, part);
    break;
  }
  if (u >= hundred) return 100 * (zero - u) / (zero - hundred);
  return 100 + std::expm1(std::log(hundred / u) / std::log10(y)) / 0.00715;
}

// Table 1 and the equations of table X2.1 give the same oils within 0.12 %.
TEST(Readings, ViscosityIndexTableAgreesWithTheEquationsOfItsStandard) {
  for (std::size_t row = 0; row < index_table.size(); ++row) {
    const auto equations = detail::index_oils(index_table_tenths(row) * 1e-7);
    EXPECT_NEAR(index_table[row].zero / equations.zero, 1, 1.2e-3) << "row " << row;
    EXPECT_NEAR(index_table[row].hundred / equations.hundred, 1, 1.2e-3) << "row " << row;
  }
  EXPECT_EQ(index_table_tenths(0), 20);
  EXPECT_EQ(index_table_tenths(index_table.size() - 1), 700);
}

TEST(Readings, OfOneLawAreEachHeldWhereAllAnswersFollowThem) {
  struct Solver {
    const char* function;
    double (*value)(const Question&);
    const char* note;  // empty: the certified reading
    bool is_seen;      // by the engineering tolerance, too
    bool is_right;
  };
  for (const auto& [function, value, note, is_seen, is_right] :
       {Solver{"roelands_viscosity", [](const Question& x) { return roelands(x, std::exp(-9.67)); },
               "", false, true},
        {"roelands_viscosity", [](const Question& x) { return roelands(x, 6.31e-5); },
         "the constant 6.31e-5 Pa·s", true, true},
        {"roelands_viscosity", [](const Question& x) { return roelands(x, 6.315e-5); },
         "the constant 6.315e-5 Pa·s", false, true},
        {"roelands_viscosity", [](const Question& x) { return roelands(x, 6.3e-5); }, "", true,
         false},
        {"roelands_viscosity",
         [](const Question& x) { return roelands(x, x.arguments[0] < 0.1 ? 6.31e-5 : 6.32e-5); },
         "the constant 6.31", true, false},
        {"astm_d341_viscosity", walther, "the exponential terms", false, true},
        {"viscosity_index", [](const Question& x) { return index_of_table(x, false); },
         "the standard's table 1", true, true},
        {"viscosity_index", [](const Question& x) { return index_of_table(x, true); }, "", true,
         false}}) {
    for (const Tolerance& tolerance : {engineering_tolerance(), strict_tolerance()}) {
      std::vector<TestCase> cases = cases_for(cases_of(function, all_cases()), tolerance);
      Conversation conversation = answered_by(cases, value);
      const std::vector<std::string> notes = take_readings(cases, conversation, tolerance, {});
      const bool has_note = *note != '\0' && (is_seen || tolerance.is_strict);
      EXPECT_TRUE(notes.empty() != has_note || !is_right) << function << ' ' << note;
      for (const std::string& one : notes)
        EXPECT_TRUE(!is_right || one.find(note) != std::string::npos) << one;
      const ConformanceResult result = judge("", cases, std::move(conversation), tolerance);
      EXPECT_EQ(result.quantities.at(0).failed == 0, is_right)
          << function << ' ' << note << ' ' << result.quantities[0].first_reason;
    }
  }
}

// The strict tolerance asks all cases, the others all but the extreme ones. Their order stays.
TEST(Cases, AreAllWhereTheToleranceIsStrict) {
  const std::vector<TestCase>& all = all_cases();
  const auto ids = [](const std::vector<TestCase>& cases) {
    std::vector<std::string> made;
    for (const TestCase& one : cases) made.push_back(one.id);
    return made;
  };
  std::vector<TestCase> usual;
  for (const TestCase& one : all)
    if (!one.is_extreme) usual.push_back(one);
  EXPECT_GT(usual.size(), all.size() / 2);
  EXPECT_LT(usual.size(), all.size());
  EXPECT_EQ(ids(cases_for(all, strict_tolerance())), ids(all));
  EXPECT_EQ(ids(cases_for(all, engineering_tolerance())), ids(usual));
  EXPECT_EQ(ids(cases_for(all, own_tolerance())), ids(usual));
}

TEST(Cases, NameEachQuantityWithItsUnitAndItsPlaceAmongTheNumbers) {
  std::map<std::string, const Expected*> known;
  for (const TestCase& one : all_cases())
    for (const Expected& of : one.expected) known[of.quantity] = &of;
  for (const auto& [quantity, field, unit, place] :
       {std::tuple{"gaussian_moment", "value", "", 0U},
        {"hertz_point.radius", "radius", "m", 0U},
        {"hertz_point.approach", "approach", "m", 3U},
        {"operating_point.film", "film", "m", 1U},
        {"operating_point_of_line.friction", "friction", "", 8U}}) {
    ASSERT_TRUE(known.contains(quantity)) << quantity;
    EXPECT_EQ(known[quantity]->field, field);
    EXPECT_EQ(known[quantity]->unit, unit) << quantity;
    EXPECT_EQ(known[quantity]->place, place) << quantity;
  }
}

TEST(Names, OfAFunctionOrAQuantityAreKnownAndNoOthers) {
  const std::vector<TestCase>& cases = all_cases();
  EXPECT_EQ(unknown_of({"hertz_point", "hertz_point.radius", "gaussian_moment"}, cases),
            std::nullopt);
  EXPECT_EQ(unknown_of({}, cases), std::nullopt);
  for (const char* const name : {"hertz", "hertz_point.", "hertz_point.friction", "radius", ""})
    EXPECT_EQ(unknown_of({"hertz_point", name}, cases), name);
}

TEST(ToleranceFile, HasEachNumberAtItsQuantityAndRefusesOtherLines) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& text) {
    return tolerance_of(folder.written("own.txt", text), all_cases());
  };
  const Tolerance own = read("# of the rig\nhertz_point.radius 1e-3  # mm\n\ndefault 2e-4\n");
  EXPECT_EQ(own.quantity, (std::map<std::string, double>{{"hertz_point.radius", 1e-3}}));
  EXPECT_EQ(own.relative, 2e-4);
  EXPECT_FALSE(own.is_strict);
  for (const char* const line :
       {"hertz_point.load 1e-3", "hertz_point.radius 0", "hertz_point.radius 1",
        "hertz_point.radius", "hertz_point.radius 1e-3 m", "hertz_point.approach 1e-3"})
    try {
      read("hertz_point.approach 1e-3\n" + std::string(line));
      ADD_FAILURE() << line << " is taken";
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("own.txt:2: hertz_point."), std::string::npos)
          << error.what();
    }
}

// Points are asked for their regime and inlet, except next to the border between two words. The
// regime is not asked where nothing balances the load.
TEST(Cases, OfPointsAskForEachWordAwayFromItsBorder) {
  std::size_t points = 0;
  for (const TestCase& one : all_cases()) {
    if (!is_operating_point(one.function)) continue;
    std::map<std::string, double> value;
    std::map<std::string, std::string> word;
    for (const Expected& of : one.expected)
      if (of.word.empty())
        value[of.field] = of.high;
      else
        word[of.field] = of.word;
    const auto is_at = [](double x, double border) { return std::abs(x / border - 1) < 1e-6; };
    const double asperity = value["asperity_load_share"], fluid = value["fluid_load_share"];
    const double kept = value["film"] / value["film_flooded"];
    EXPECT_EQ(word["regime"], asperity + fluid == 0 || is_at(asperity, 0.01) || is_at(fluid, 0.01)
                                  ? ""
                              : fluid < 0.01    ? "boundary"
                              : asperity < 0.01 ? "elastohydrodynamic"
                                                : "mixed")
        << one.id;
    EXPECT_EQ(word["inlet"], is_at(kept, 0.95) ? ""
                             : kept == 0       ? "collapsed"
                             : kept > 0.95     ? "flooded"
                                               : "starved")
        << one.id;
    ++points;
  }
  EXPECT_GT(points, 400U);
}

TEST(Cases, OfASampleAreSoManyOfEachFunctionTheFirstAlways) {
  std::vector<TestCase> all;
  std::map<std::string, std::size_t> sizes{{"a", 1}, {"b", 10}, {"c", 23}, {"d", 100}};
  for (std::size_t i = 0; i < 100; ++i)
    for (const auto& [function, size] : sizes)
      if (i < size) {
        all.push_back(asked_for({}, std::to_string(i)));
        all.back().function = function;
      }
  for (const std::size_t most : {1U, 2U, 7U, 10U, 22U, 23U, 99U, 100U, 1000U}) {
    std::map<std::string, std::vector<std::size_t>> kept;
    for (const TestCase& one : cases_for(all, strict_tolerance(), most))
      kept[one.function].push_back(std::stoul(one.id));
    for (const auto& [function, size] : sizes) {
      const std::vector<std::size_t>& ids = kept[function];
      ASSERT_EQ(ids.size(), std::min(size, most)) << function << ' ' << most;
      EXPECT_EQ(ids.front(), 0U);
      for (std::size_t i = 1; i < ids.size(); ++i) {  // evenly
        EXPECT_GE(ids[i] - ids[i - 1], size / ids.size());
        EXPECT_LE(ids[i] - ids[i - 1], (size + ids.size() - 1) / ids.size());
      }
    }
  }
}

TEST(JudgedSubject, IsCompleteOnlyWhereAllOfItIsHeldAndNoRuleBroken) {
  const TestCase film = asked_for({number(2)});
  TestCase radius = asked_for({number(2)}, "b");
  radius.function = radius.expected[0].quantity = "hertz";
  const Reply right = with({{"value", 2}}), wrong = with({{"value", 3}}),
              skipped = without(Outcome::skipped);
  EXPECT_EQ(judged({film, radius}, {right, right}).overall, Overall::complete);
  EXPECT_EQ(judged({film, radius}, {right, skipped}).overall, Overall::partial);
  EXPECT_EQ(judged({film, radius}, {right, wrong}).overall, Overall::failed);
  EXPECT_EQ(judged({film, radius}, {skipped, skipped}).overall, Overall::nothing);
  Conversation broken;
  broken.answers = {right};
  broken.violation_count = 1;
  EXPECT_EQ(judge("", {film}, broken, engineering_tolerance()).overall, Overall::failed);
}

// --- The physical range

TestCase case_of(double value, bool is_physical) {
  TestCase one = asked_for({number(value)});
  one.expected[0].is_physical = is_physical;
  return one;
}

TEST(Verdict, TellsAFailureBeyondThePhysicalRangeApart) {
  const Reply right = with({{"value", 2.0}}), wrong = with({{"value", 3.0}});
  const TestCase inside = case_of(2, true), beyond = case_of(2, false);
  const auto status = [&](const std::vector<TestCase>& cases, const std::vector<Reply>& answers) {
    return judged(cases, answers).quantities[0].status;
  };
  EXPECT_EQ(status({inside, beyond}, {right, right}), Verdict::held);
  EXPECT_EQ(status({inside, beyond}, {right, wrong}), Verdict::held_physically);
  EXPECT_EQ(status({inside, beyond}, {wrong, right}), Verdict::failed);
  EXPECT_EQ(status({beyond}, {wrong}), Verdict::failed);  // nothing was right in the physical range
  EXPECT_EQ(judged({inside, beyond}, {right, wrong}).overall, Overall::physical);
  EXPECT_EQ(judged({inside, beyond}, {wrong, wrong}).overall, Overall::failed);
}

// --- Results that became worse than a baseline.

// A row with these numbers of cases; each failed case is off by a tenth.
QuantityVerdict row(Verdict status, std::size_t held, std::size_t failed, std::size_t skipped,
                    double worst_held = 1e-10) {
  QuantityVerdict one;
  one.quantity = "film";
  one.status = status;
  one.asked = held + failed + skipped;
  one.held = held;
  one.failed = failed;
  one.skipped = skipped;
  for (std::size_t i = 0; i < held; ++i)
    one.held_cases.push_back({"h" + std::to_string(i), i == 0 ? worst_held : 0});
  for (std::size_t i = 0; i < failed; ++i)
    one.failed_cases.push_back({"f" + std::to_string(i), Failure::number, 0.1});
  return one;
}
QuantityVerdict held_radius(std::size_t held) {
  QuantityVerdict one = row(Verdict::held, held, 0, 0);
  one.quantity = "radius";
  return one;
}
QuantityVerdict failing(std::vector<FailedCase> cases) {
  QuantityVerdict one = row(Verdict::failed, 5, cases.size(), 0);
  one.failed_cases = std::move(cases);
  return one;
}
ConformanceResult result_of(std::vector<QuantityVerdict> quantities) {
  ConformanceResult result;
  result.tolerance = engineering_tolerance();
  result.quantities = std::move(quantities);
  return result;
}

BaselineChanges changes_of(const QuantityVerdict& before, const QuantityVerdict& now) {
  return compare(result_of({now}), baseline_of(result_of({before}), nullptr));
}

enum class Way : std::uint8_t { same, better, worse };
Way change(const QuantityVerdict& before, const QuantityVerdict& now) {
  const BaselineChanges changes = changes_of(before, now);
  std::size_t of_film = 0;
  for (const auto& list : {changes.worse, changes.better})
    for (const BaselineChange& one : list) of_film += one.quantity == "film" ? 1 : 0;
  EXPECT_LE(of_film, 1U);
  return !changes.worse.empty() ? Way::worse : !changes.better.empty() ? Way::better : Way::same;
}
// A change that is worse from `before` to `now` is better in the other direction.
void expect_worse(const QuantityVerdict& before, const QuantityVerdict& now) {
  EXPECT_EQ(change(before, now), Way::worse);
  EXPECT_EQ(change(now, before), Way::better);
  EXPECT_EQ(change(now, now), Way::same);
}

TEST(Baseline, KnowsWhatIsWorse) {
  expect_worse(row(Verdict::held, 10, 0, 0), row(Verdict::partly_held, 9, 0, 1));
  expect_worse(row(Verdict::partly_held, 9, 0, 1), row(Verdict::held_physically, 9, 1, 0));
  expect_worse(row(Verdict::failed, 9, 1, 0), row(Verdict::failed, 8, 2, 0));
  expect_worse(row(Verdict::partly_held, 9, 0, 1), row(Verdict::partly_held, 8, 0, 2));
  expect_worse(row(Verdict::failed, 8, 1, 1), row(Verdict::failed, 7, 1, 2));
  expect_worse(row(Verdict::failed, 8, 1, 1), row(Verdict::failed, 8, 2, 0));
}

// A missing answer is better than a wrong one, but a case that held must keep its answer.
TEST(Baseline, MissesWhatHeldEvenWhereNothingFailsAnyMore) {
  const QuantityVerdict none = row(Verdict::not_offered, 0, 0, 10, 0);
  const QuantityVerdict other = held_radius(10);
  const auto changes_to_none = [&](const QuantityVerdict& before) {
    return compare(result_of({none, other}), baseline_of(result_of({before, other}), nullptr));
  };
  for (const QuantityVerdict& before :
       {row(Verdict::held_physically, 9, 1, 0), row(Verdict::failed, 9, 1, 0)}) {
    ASSERT_EQ(changes_to_none(before).worse.size(), 1U);
    EXPECT_EQ(changes_to_none(before).worse[0].quantity, "film");
  }
  EXPECT_EQ(changes_to_none(row(Verdict::failed, 0, 10, 0)).worse.size(), 0U);
  EXPECT_EQ(changes_to_none(row(Verdict::failed, 0, 10, 0)).better.size(), 1U);
  EXPECT_EQ(change(row(Verdict::failed, 5, 5, 0), row(Verdict::partly_held, 5, 0, 5)), Way::better);
}

const double epsilon = std::numeric_limits<double>::epsilon();
double above(double x) { return std::nextafter(x, 2 * x); }

TEST(Baseline, HoldsErrorsToFourTimesWhatTheyWere) {
  const auto held = [](double error) { return row(Verdict::held, 10, 0, 0, error); };
  for (const double error : {1e-15, 1e-10, 3e-7}) {
    EXPECT_EQ(change(held(error), held(4 * error)), Way::same);
    expect_worse(held(error), held(above(4 * error)));
    EXPECT_EQ(change(held(4 * error), held(error)), Way::same);
  }
  // An error below 4ε counts as 4ε, so that a formula may be rewritten.
  for (const double error : {0.0, 1e-20, epsilon, 4 * epsilon}) {
    EXPECT_EQ(change(held(error), held(16 * epsilon)), Way::same);
    EXPECT_EQ(change(held(error), held(above(16 * epsilon))), Way::worse);
  }
}

// At another place of an array the answer to the same question may be rounded differently.
TEST(Baseline, TakesAChangeOfAnAnswerAskedAgainForALossBeyondRoundingAlone) {
  const auto asked_again = [](double change) {
    QuantityVerdict one = row(Verdict::held, 10, 0, 0);
    one.change_asked_again = one.change_of_function = change;
    return one;
  };
  for (const double before : {0.0, epsilon, 16 * epsilon}) {
    for (const double now : {0.0, epsilon / 2, 16 * epsilon})
      EXPECT_EQ(change(asked_again(before), asked_again(now)), Way::same);
    for (const double now : {above(16 * epsilon), 1e-9, std::numeric_limits<double>::infinity()})
      EXPECT_EQ(change(asked_again(before), asked_again(now)), Way::worse) << now;
  }
  EXPECT_EQ(change(asked_again(1e-13), asked_again(1e-9)), Way::same);
}

// The condition says how much a rounding changes an answer.
TEST(Unsteady, IsMeasuredOverTheConditionToo) {
  const std::vector<TestCase> cases{asked_for({number(2, 100)}, "a"), asked_for({number(2)}, "b")};
  Conversation conversation;
  conversation.answers = {with({{"value", 2}}), with({{"value", 2}})};
  conversation.again = {0, 1};
  conversation.second_answers = {with({{"value", 2 + 2e-12}}), with({{"value", 2 + 2e-13}})};
  const ConformanceResult result = judge("subject", cases, conversation, engineering_tolerance());
  EXPECT_TRUE(is_close(result.unsteady.at(0).apart, 1e-12, 1e-3, {}));
  EXPECT_EQ(result.unsteady[0].id, "a");
  EXPECT_TRUE(is_close(result.quantities[0].change_asked_again, 1e-13, 1e-2, {}));
  EXPECT_EQ(result.quantities[0].change_of_function, result.quantities[0].change_asked_again);
}

// --- Cases that failed must not fail worse.

TEST(Baseline, HoldsEachCaseThatFailedToFourTimesItsOwnError) {
  const auto off_by = [](double first, double second) {
    return failing({{"a", Failure::number, first}, {"b", Failure::number, second}});
  };
  for (const double error : {1e-5, 7e-3, 0.25, 3.0, 1e100}) {
    EXPECT_EQ(change(off_by(error, 1e-3), off_by(4 * error, 1e-3)), Way::same);
    expect_worse(off_by(error, 1e-3), off_by(above(4 * error), 1e-3));
    // A case that became worse is not made good by another case that became better.
    EXPECT_EQ(change(off_by(error, 1e-3), off_by(above(4 * error), 1e-9)), Way::worse);
  }
}

TEST(Baseline, HasALineForEachCaseThatFailed) {
  const std::string text =
      baseline_text(baseline_of(result_of({failing({{"a", Failure::number, 0.5},
                                                    {"b", Failure::wrong, 0},
                                                    {"c", Failure::no_answer, 0}})}),
                                nullptr),
                    "f85dc47", "2026-11-26");
  for (const std::string line : {"\"a\": 0.5,\n", "\"b\": \"wrong\",\n", "\"c\": \"no answer\"\n"})
    EXPECT_NE(text.find(line), std::string::npos) << text;
}

TEST(Baseline, IsNotMadeWorseStepByStepByWhatIsBetter) {
  const json first = baseline_of(result_of({failing({{"a", Failure::number, 0.1},
                                                     {"b", Failure::number, 0.1},
                                                     {"c", Failure::no_answer, 0}})}),
                                 nullptr);
  QuantityVerdict better = failing({{"a", Failure::number, 0.3}, {"c", Failure::wrong, 0}});
  better.held = 6;
  better.held_cases.push_back({"b", 1e-7});
  better.held_cases[0].error = 3e-10;  // three times what it was
  const json after = baseline_of(result_of({better}), first).at("quantities").at("film");
  EXPECT_EQ(after.at("failed"), json({{"a", 0.1}, {"c", "wrong"}}));
  EXPECT_EQ(after.at("held"), 6);
  EXPECT_EQ(after.at("worst_error"), 1e-7);
  better.held_cases.back().error = 1e-12;
  EXPECT_EQ(baseline_of(result_of({better}), first).at("quantities").at("film").at("worst_error"),
            1e-10);
}

// A case that failed and now holds may have the greatest error of all that hold: that is no loss.
TEST(Baseline, ComparesTheErrorsOfWhatHeldBeforeAlone) {
  const QuantityVerdict before = failing({{"a", Failure::number, 0.1}});
  QuantityVerdict mended = row(Verdict::held, 6, 0, 0);
  mended.held_cases.back() = {"a", 9e-7};
  EXPECT_EQ(change(before, mended), Way::better);
  mended.held_cases[1].error = 4.01e-10;
  EXPECT_EQ(change(before, mended), Way::worse);
}

// A failed case is told with its error, or as wrong if the answer has no finite error.
TEST(JudgedCase, ThatFailedIsToldWithItsError) {
  const auto how = [](const Expected& expected, Reply answer) {
    return verdict_on(expected, std::move(answer)).failed_cases.at(0);
  };
  const Expected two = number(2), zero = number(0), word{"value", 0, 0, 1, "mixed"};
  EXPECT_EQ(how(two, with({{"value", 3}})).how, Failure::number);
  EXPECT_EQ(how(two, with({{"value", 3}})).error, 0.5);
  EXPECT_EQ(how(zero, with({{"value", -0.25}})).error, 0.25);
  for (const json& value : {json("NaN"), json("2"), json(nullptr), json(true), json::array({2}),
                            json(std::numeric_limits<double>::infinity()), json(std::nan(""))})
    EXPECT_EQ(how(two, with({{"value", value}})).how, Failure::wrong) << value.dump();
  EXPECT_EQ(how(number(1e-300), with({{"value", 1e300}})).how, Failure::wrong);  // error: inf
  EXPECT_EQ(how(word, with({{"value", "boundary"}})).how, Failure::wrong);
}

TEST(JudgedQuantity, TellsTheErrorsOfWhatHeldOverTheCondition) {
  const std::vector<TestCase> cases{asked_for({number(2, 100)}, "a"), asked_for({number(2)}, "b"),
                                    asked_for({number(2)}, "c"), asked_for({number(1e-40)}, "d")};
  const QuantityVerdict verdict =
      judged(cases, {with({{"value", 2 + 2e-6}}), with({{"value", 2 + 4e-7}}), with({{"value", 3}}),
                     with({{"value", 2e-40}})})
          .quantities.at(0);
  ASSERT_EQ(verdict.held_cases.size(), 3U);
  EXPECT_TRUE(is_close(verdict.held_cases[0].error, 1e-8, 1e-8, {}));
  EXPECT_EQ(verdict.held_cases[1].id, "b");
  EXPECT_TRUE(is_close(verdict.held_cases[1].error, 2e-7, 1e-8, {}));
  EXPECT_EQ(verdict.held_cases[2].error, 0);
}

TEST(Baseline, MissesAQuantityThatIsNoLongerAsked) {
  const QuantityVerdict other = held_radius(10);
  const json baseline = baseline_of(result_of({row(Verdict::held, 10, 0, 0), other}), nullptr);
  const BaselineChanges changes = compare(result_of({other}), baseline);
  ASSERT_EQ(changes.worse.size(), 1U);
  EXPECT_EQ(changes.worse[0].quantity, "film");
  EXPECT_EQ(changes.better.size(), 0U);
}

TEST(Baseline, TakesANewQuantityUnlessItFails) {
  const QuantityVerdict other = held_radius(9);
  json baseline = baseline_of(result_of({other}), nullptr);
  baseline["version"] = "0.0.1";
  EXPECT_EQ(compare(result_of({other, row(Verdict::failed, 9, 1, 0)}), baseline).worse.size(), 1U);
  const BaselineChanges good = compare(result_of({other, row(Verdict::held, 9, 0, 0)}), baseline);
  EXPECT_EQ(good.fresh.size(), 1U);
  EXPECT_EQ(good.worse.size() + good.better.size(), 0U);
  // An update does not add a quantity that fails, which would be allowed to fail from then on.
  const json kept = baseline_of(result_of({other, row(Verdict::failed, 9, 1, 0)}), baseline);
  EXPECT_EQ(hold_the_same(kept, baseline), true);
  EXPECT_TRUE(baseline_of(result_of({other, row(Verdict::held, 9, 0, 0)}), baseline)
                  .at("quantities")
                  .contains("film"));
}

// A version writes a row for each quantity that it asks. If one is missing, it was lost by hand or
// in a merge, and what it said is not known.
TEST(Baseline, OfThisVersionIsMissedAnyRow) {
  const QuantityVerdict other = held_radius(9);
  const json baseline = baseline_of(result_of({other}), nullptr);
  const auto missed = [&](const QuantityVerdict& film) {
    const ConformanceResult result = result_of({other, film});
    const BaselineChanges changes = compare(result, baseline);
    EXPECT_EQ(changes.fresh.size(), 0U);
    EXPECT_TRUE(hold_the_same(baseline_of(result, baseline), baseline));  // only --force adds it
    return changes.worse.size() == 1 ? changes.worse[0].text : "";
  };
  EXPECT_EQ(missed(row(Verdict::held, 9, 0, 0)), "film: is missing in the file, held");
  EXPECT_EQ(missed(row(Verdict::not_offered, 0, 0, 9)),
            "film: is missing in the file, not offered");
  EXPECT_EQ(missed(row(Verdict::failed, 9, 1, 0)), "film: is missing in the file, and fails");
  json older = baseline;
  older["schema"] = 2;
  older.erase("version");  // a file of that schema does not tell its version
  EXPECT_EQ(compare(result_of({other, row(Verdict::held, 9, 0, 0)}), older).fresh.size(), 1U);
}

TEST(Baseline, OfAnotherVersionMayHaveQuantitiesThatAreNoLongerAsked) {
  const QuantityVerdict other = held_radius(10);
  json baseline = baseline_of(result_of({row(Verdict::held, 10, 0, 0), other}), nullptr);
  baseline["version"] = "0.0.1";
  const BaselineChanges changes = compare(result_of({other}), baseline);
  EXPECT_EQ(changes.worse.size(), 0U);
  ASSERT_EQ(changes.gone.size(), 1U);
  EXPECT_EQ(changes.gone[0].quantity, "film");
  EXPECT_FALSE(baseline_of(result_of({other}), baseline).at("quantities").contains("film"));
}

TEST(Baseline, IsReadInItsOlderSchemaAndRefusedInOthers) {
  const ConformanceResult result = result_of({failing({{"a", Failure::number, 0.1}})});
  json file = json::parse(baseline_text(baseline_of(result, nullptr), "f85dc47", "2026-11-26"));
  EXPECT_EQ(file.at("schema"), "verify-baseline/3");
  const auto is_read = [&](const json& schema) {
    file["schema"] = schema;
    try {
      return compare(result, file).worse.empty();
    } catch (const std::runtime_error&) {
      return false;
    }
  };
  EXPECT_TRUE(is_read("verify-baseline/3"));
  for (const json& schema : {json(1), json(4), json("verify-baseline/4"), json("bench-baseline/3"),
                             json("verify-baseline/"), json(nullptr), json("3")})
    EXPECT_FALSE(is_read(schema)) << schema.dump();
  for (const char* member : {"version", "commit", "date", "losses"}) file.erase(member);
  EXPECT_TRUE(is_read(2));
}

TEST(Baseline, WithoutOneAnswerComparesNothing) {
  const QuantityVerdict now = row(Verdict::held, 10, 0, 0);
  EXPECT_EQ(change(row(Verdict::not_offered, 0, 0, 10), now), Way::worse);
  EXPECT_EQ(change(row(Verdict::partly_held, 1, 0, 9), now), Way::better);
  EXPECT_EQ(change(row(Verdict::failed, 0, 1, 9), now), Way::better);
}

TEST(Baseline, TellsTheNumbersOfEachChange) {
  const QuantityVerdict before = failing(
      {{"a", Failure::number, 0.1}, {"b", Failure::wrong, 0}, {"c", Failure::no_answer, 0}});
  const QuantityVerdict now = failing(
      {{"a", Failure::number, 0.5}, {"b", Failure::number, 0.2}, {"d", Failure::no_answer, 0}});
  const BaselineChanges changes = changes_of(before, now);
  ASSERT_EQ(changes.worse.size(), 1U);
  const std::vector<CaseChange>& cases = changes.worse[0].cases;
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_EQ(cases[0].before, 0.1);
  EXPECT_EQ(cases[0].after, 0.5);
  EXPECT_EQ(cases[1].id, "d");
  EXPECT_EQ(cases[1].before, nullptr);
  EXPECT_EQ(cases[1].after, "no answer");
  const BaselineChanges better = changes_of(
      failing({{"a", Failure::number, 0.5}, {"b", Failure::number, 0.2}, {"c", Failure::wrong, 0}}),
      failing({{"a", Failure::number, 0.1}, {"b", Failure::number, 0.2}}));
  ASSERT_EQ(better.better.size(), 1U);
  const std::vector<CaseChange>& mended = better.better[0].cases;
  ASSERT_EQ(mended.size(), 2U);
  EXPECT_EQ(mended[0].before, 0.5);
  EXPECT_EQ(mended[0].after, 0.1);
  EXPECT_EQ(mended[1].id, "c");
  EXPECT_EQ(mended[1].after, nullptr);
  const BaselineChanges fewer =
      changes_of(row(Verdict::held, 10, 0, 0), row(Verdict::held, 9, 0, 1));
  ASSERT_EQ(fewer.worse.size(), 1U);
  EXPECT_EQ(fewer.worse[0].fact, "held");
  EXPECT_EQ(fewer.worse[0].before, 10);
  EXPECT_EQ(fewer.worse[0].after, 9);
}

// --- A subject that ends, or is silent, in the middle.

Reply lost_reply(Outcome outcome) { return {outcome, {}, "it is killed by signal 11"}; }

TEST(Losses, CostNothingOfWhatIsNeverOffered) {
  const Expected film{.field = "film", .high = 2, .quantity = "p.film"},
      other{.field = "friction", .high = 2, .quantity = "p.friction"};
  const auto point = [&](const char* id) {
    return TestCase{id, "p", json::object(), contract, {film, other}, false};
  };
  const std::vector<TestCase> points{point("a"), point("b")};
  const Reply right = with({{"film", 2}});
  for (const Outcome outcome : {Outcome::died, Outcome::late, Outcome::garbage, Outcome::missing}) {
    const ConformanceResult result = judged(points, {right, lost_reply(outcome)});
    EXPECT_EQ(result.quantities[0].status, Verdict::failed);
    EXPECT_EQ(result.quantities[1].status, Verdict::not_offered);
    EXPECT_EQ(result.overall, Overall::failed);
  }
  // A function that is skipped is not offered; the subject has failed nevertheless.
  const ConformanceResult skipped =
      judged(points, {without(Outcome::skipped), lost_reply(Outcome::died)});
  EXPECT_EQ(skipped.quantities[0].status, Verdict::not_offered);
  EXPECT_EQ(skipped.overall, Overall::failed);
  EXPECT_EQ(skipped.losses.size(), 1U);
  // A refused question is a failure of the function itself. So is a function without any answer.
  EXPECT_EQ(
      judged(points, {without(Outcome::skipped), without(Outcome::refused)}).quantities[0].status,
      Verdict::failed);
  EXPECT_EQ(
      judged(points, {lost_reply(Outcome::died), without(Outcome::not_asked)}).quantities[1].status,
      Verdict::failed);
}

TEST(Losses, AreOneChangeWhateverTheyCost) {
  std::vector<TestCase> cases;
  for (const char* quantity : {"film", "radius", "area"})
    for (const char* id : {"1", "2", "3"}) {
      cases.push_back(asked_for({number(2)}, quantity + std::string(id)));
      cases.back().function = cases.back().expected[0].quantity = quantity;
    }
  const Reply right = with({{"value", 2}}), lost = lost_reply(Outcome::died);
  const auto result = [&](std::vector<std::size_t> lost_cases, Reply first) {
    std::vector<Reply> answers(cases.size(), right);
    answers[0] = std::move(first);
    for (const std::size_t i : lost_cases) answers[i] = lost;
    return judged(cases, answers);
  };
  const json baseline = baseline_of(result({}, right), nullptr);
  const BaselineChanges changes = compare(result({1, 4}, right), baseline);
  ASSERT_EQ(changes.worse.size(), 1U);
  EXPECT_EQ(changes.worse[0].text,
            "subject: at case film2 (film) and at 1 more: it is killed by signal 11; lost by this: "
            "film, radius; --show film2 asks it alone");
  EXPECT_EQ(changes.lost, (std::vector<std::string>{"film", "radius"}));
  // A wrong answer is told beside the loss.
  const BaselineChanges both = compare(result({1, 4}, with({{"value", 3}})), baseline);
  ASSERT_EQ(both.worse.size(), 2U);
  EXPECT_EQ(both.worse[0].quantity, "film");
  const ConformanceResult later = judged({cases[0], cases[1]}, {lost, with({{"value", 3}})});
  EXPECT_TRUE(later.quantities[0].first_reason.starts_with("film2: 3, not 2"));
  EXPECT_EQ(later.quantities[0].worst.id, "film2");
  EXPECT_EQ(both.lost, std::vector<std::string>{"radius"});
  // A loss that the baseline has is no change. One at another case is worse. Fewer are better.
  const json with_loss = baseline_of(result({1}, right), nullptr);
  EXPECT_EQ(compare(result({1}, right), with_loss).worse.size(), 0U);
  EXPECT_EQ(compare(result({4}, right), with_loss).worse.size(), 1U);
  EXPECT_EQ(compare(result({}, right), with_loss).better.size(), 2U);
  EXPECT_EQ(baseline_of(result({}, right), with_loss), baseline);
  EXPECT_EQ(baseline_of(result({1, 4}, right), with_loss).at("losses"), json{"film2"});
}

// --- An update never makes a baseline looser.

// How a case of a quantity went. Cases 9 to 11 are beyond the physical range.
struct Went {
  enum class Way : std::uint8_t { held, skipped, number, wrong, no_answer };
  Way way = Way::held;
  double error = 0;
};
using AskedRun = std::array<Went, 12>;

QuantityVerdict verdict_of(const std::string& quantity, const AskedRun& run) {
  QuantityVerdict made;
  made.quantity = quantity;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const std::string id = "c" + std::to_string(i);
    const std::size_t physical = i < 9 ? 1 : 0;
    ++made.asked;
    if (run[i].way == Went::Way::held) {
      ++made.held;
      made.held_physical += physical;
      made.held_cases.push_back({id, run[i].error});
    } else if (run[i].way == Went::Way::skipped) {
      ++made.skipped;
    } else {
      ++made.failed;
      made.failed_physical += physical;
      const bool is_number = run[i].way == Went::Way::number;
      made.failed_cases.push_back({id,
                                   is_number                        ? Failure::number
                                   : run[i].way == Went::Way::wrong ? Failure::wrong
                                                                    : Failure::no_answer,
                                   is_number ? run[i].error : 0});
    }
  }
  made.status = made.failed > 0     ? made.failed_physical > 0 || made.held_physical == 0
                                          ? Verdict::failed
                                          : Verdict::held_physically
                : made.held == 0    ? Verdict::not_offered
                : made.skipped == 0 ? Verdict::held
                                    : Verdict::partly_held;
  return made;
}

Went any_case(verification::Sampler& draw) {
  using Way = Went::Way;
  const Way way = draw.pick({Way::held, Way::held, Way::held, Way::held, Way::skipped, Way::number,
                             Way::wrong, Way::no_answer});
  return {way, way == Way::held ? draw.log_uniform(1e-17, 1e-7) : draw.log_uniform(1e-5, 1e3)};
}

AskedRun changed(AskedRun run, verification::Sampler& draw) {
  const double share = draw.pick({0.0, draw.uniform(0, 0.5)}), most = draw.pick({3.9, 10.0});
  for (Went& one : run)
    if (draw.uniform(0, 1) < share)
      one = any_case(draw);
    else
      one.error *= draw.log_uniform(0.1, most);
  return run;
}

// The run with some cases worse. In half of the runs one case at most, which no other can hide.
AskedRun as_it_was_or_worse(AskedRun run, verification::Sampler& draw) {
  using Way = Went::Way;
  const double share = draw.uniform(0, 0.5);
  const auto only = static_cast<std::size_t>(draw.uniform(0, 2) * static_cast<double>(run.size()));
  for (Went& one : run) {
    if (only < run.size() ? &one != &run[only] : draw.uniform(0, 1) > share) continue;
    const bool was_held = one.way == Way::held;
    one.error *= draw.log_uniform(1, 10);
    if (draw.uniform(0, 1) < 0.5) continue;
    if (was_held && draw.uniform(0, 1) < 0.3)
      one.way = Way::skipped;
    else if (was_held || one.way == Way::skipped)
      one = {Way::number, draw.log_uniform(1e-5, 1e3)};
    else
      one.way = one.way == Way::number ? Way::wrong : Way::no_answer;
  }
  return run;
}

// Each case as it went in the better of the two runs.
AskedRun best_of(AskedRun run, const AskedRun& other) {
  const auto rank = [](const Went& one) {
    return std::pair(one.way == Went::Way::skipped ? 9 : static_cast<int>(one.way), one.error);
  };
  for (std::size_t i = 0; i < run.size(); ++i)
    if (rank(other[i]) < rank(run[i])) run[i] = other[i];
  return run;
}

TEST(Baseline, IsNeverMadeLooserByAnUpdate) {
  verification::Sampler draw(20261126);
  const auto result = [](const AskedRun& run) { return result_of({verdict_of("film", run)}); };
  const auto is_red = [](const ConformanceResult& one, const json& baseline) {
    return !compare(one, baseline).worse.empty();
  };
  std::size_t red = 0, updated = 0;
  for (int tries = 0; tries < 12000; ++tries) {
    AskedRun run{};
    for (Went& one : run) one = any_case(draw);
    const json first = baseline_of(result(run), nullptr);
    json after = first;
    AskedRun best = run;
    for (int step = 0; step < 2; ++step) {
      const AskedRun changes = changed(run, draw);
      const ConformanceResult now = result(changes);
      const json next = baseline_of(now, after);
      if (is_red(now, after))
        ASSERT_TRUE(hold_the_same(next, after)) << after.dump(1) << next.dump(1);
      else
        ASSERT_FALSE(is_red(now, next)) << after.dump(1) << next.dump(1);
      if (!is_red(now, after)) best = best_of(best, changes);
      after = next;
    }
    updated += hold_the_same(first, after) ? 0 : 1;
    const ConformanceResult worse = result(as_it_was_or_worse(draw.pick({run, best}), draw));
    if (!is_red(worse, first)) continue;
    ++red;
    ASSERT_TRUE(is_red(worse, after)) << first.dump(1) << after.dump(1);
  }
  EXPECT_GT(red, 6000U);
  EXPECT_GT(updated, 3000U);
}

}  // namespace
}  // namespace tribo::conformance
