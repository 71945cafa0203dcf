// SPDX-License-Identifier: Apache-2.0
// The mistakes of reference/mistakes.toml: each changes answers. An entry that has no meaning is
// refused with its name.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

#include "conformance/answers.hpp"
#include "support/temporary_folder.hpp"

namespace tribo::conformance {
namespace {

TEST(Mistakes, ChangeAtLeastThreeAnswersEachAndHaveNamesOfTheirOwn) {
  std::set<std::pair<std::string, std::string>> names;
  for (const Mistake& mistake : all_mistakes()) {
    EXPECT_TRUE(names.emplace(mistake.function, mistake.name).second) << mistake.name;
    std::size_t changed = 0;
    for (const TestCase& asked : usual_cases()) {
      const bool is_of_points =
          is_operating_point(asked.function) && mistake.function == "operating_point";
      if (asked.function != mistake.function && !is_of_points) continue;
      const Question question = question_of(asked);
      const Mistake* const one = &mistake;
      const std::optional<Numbers> given = numbers_with({&one, 1}, question);
      for (const Expected& expected : asked.expected) {
        if (!given || !expected.word.empty()) continue;
        if (std::abs((*given)[expected.place.value()] - expected.high) >
            1e-6 * std::abs(expected.high))
          ++changed;
      }
      if (changed >= 3) break;
    }
    EXPECT_GE(changed, 3U) << mistake.function << ' ' << mistake.name;
  }
  EXPECT_GE(names.size(), 120U);
}

// Calls `look` for each operating point with the numbers of each mistake that `is_asked` takes.
void for_each_answer(const std::function<bool(const Mistake&)>& is_asked,
                     const std::function<void(const TestCase&, const Question&,
                                              const std::optional<Numbers>&)>& look) {
  for (const Mistake& mistake : all_mistakes()) {
    if (mistake.function != "operating_point" || !is_asked(mistake)) continue;
    const Mistake* const one = &mistake;
    for (const TestCase& asked : usual_cases()) {
      if (!is_operating_point(asked.function)) continue;
      const Question question = question_of(asked);
      look(asked, question, numbers_with({&one, 1}, question));
    }
  }
}

TEST(Mistakes, InFrictionAreSaidOfEveryShape) {
  std::set<ContactShape> shapes;
  for_each_answer(
      [](const Mistake& one) { return one.name.starts_with("friction-"); },
      [&](const TestCase& asked, const Question& question, const std::optional<Numbers>& given) {
        for (const Expected& expected : asked.expected) {
          if (expected.field != "friction") continue;
          ASSERT_TRUE(given);
          EXPECT_EQ(std::isfinite(given->at(static_cast<std::size_t>(Output::friction))), true)
              << asked.id;
          shapes.insert(question.scene->bodies.shape());
        }
      });
  EXPECT_EQ(shapes.size(), 3U);
}

// The function load_sharing has the exponent of the default film law.
TEST(Mistakes, InLoadSharingAreSaidOfFilmsOfItsExponentAlone) {
  std::set<std::string> names;
  for (const Mistake& mistake : all_mistakes())
    if (mistake.function == "load_sharing") names.insert(mistake.name);
  std::size_t said = 0, unsaid_of = 0;
  for_each_answer(
      [&](const Mistake& one) { return names.contains(one.name); },
      [&](const TestCase& asked, const Question& question, const std::optional<Numbers>& given) {
        const bool is_other = film_law(question.scene->closures.film).sharing_power.value !=
                              hamrock_dowson_central_law.sharing_power.value;
        EXPECT_EQ(is_other && given.has_value(), false) << asked.id;
        ++(given ? said : unsaid_of);
      });
  EXPECT_GT(said, 0U);
  EXPECT_GT(unsaid_of, 0U);
}

// The message on a file with this text; empty: the file is read.
std::string refusal_of(const std::string& text) {
  const TemporaryFolder folder;
  const std::string path = folder.file("mistakes.toml");
  std::ofstream(path) << text;
  try {
    read_mistakes(path);
  } catch (const std::runtime_error& error) {
    const std::string said = error.what();
    return said.starts_with(path) ? said.substr(path.size()) : "does not name the file: " + said;
  }
  return "";
}

std::string entry(const std::string& rest, const std::string& function = "hertz_point") {
  return "[[mistake]]\nname = \"one\"\ntext = \"a text\"\nfunction = \"" + function + "\"\n" + rest;
}

TEST(Mistakes, OfAnEntryThatMeansNothingAreRefusedByItsName) {
  const std::pair<std::string, std::string> refused[] = {
      {"", ": no [[mistake]] is there"},
      {"[[mistake]", ":1:11: not TOML"},
      {"[[mistake]]\nname = \"one\"\n", ": mistake \"one\": function, name and text are needed"},
      {"colour = 1\n" + entry("input.load = { times = 2 }"), ": unknown name colour"},
      {entry("", "no_such"), ": mistake \"one\": nothing is changed"},
      {entry("input.load = { times = 2 }", "no_such"), ": mistake \"one\": no function no_such"},
      {entry("colour = 1"), ": mistake \"one\": unknown field colour"},
      {entry("input.colour = { times = 2 }"), ": mistake \"one\": the function has no colour"},
      {entry("input.load = { doubled = true }"), ": mistake \"one\": unknown field doubled"},
      {entry("input.load = { times = \"two\" }"), ": mistake \"one\": times: \"two\" is not"},
      {entry("input.load = { is = \"heavy\" }"), ": mistake \"one\": load: \"heavy\" is not"},
      {entry("result.force = { times = 2 }"), ": mistake \"one\": the function has no force"},
      {entry("law = { constant = 2 }"), ": mistake \"one\": law: only of film laws"},
      {entry("law = { colour = 2 }", "hamrock_dowson_central"), ": mistake \"one\": law: colour"},
      {entry("formula = { name = \"no_such\" }"), ": mistake \"one\": no formula no_such"},
      {entry("input.load = { by = \"load\" }"), ": mistake \"one\": load: by and over are for"},
      {entry("input.load = 2"), ": mistake \"one\": "},
      {entry("where = 2"), ": mistake \"one\": where: 2.0 is not allowed"},
      {entry("where.load = 2"), ": mistake \"one\": load: 2.0 is not allowed"},
      {entry("law = { constant = 1.2345678 }", "hamrock_dowson_central"),
       ": mistake \"one\": law: 1.2345678 is not allowed"},
      {entry("law = { constant = 2 }\nformula = { name = \"minimum\" }", "hamrock_dowson_central"),
       ": mistake \"one\": these changes cannot stand together"},
      {entry("law = \"another\"\nwhere.radius_x = [1]", "hamrock_dowson_central"),
       ": mistake \"one\": these changes cannot stand together"},
      {entry("law = \"another\"\nsharing.exponent = 2", "hamrock_dowson_central"),
       ": mistake \"one\": these changes cannot stand together"},
      {entry("input.load = { times = 2, is = 3 }"), ": mistake \"one\": a number that is another"},
      {entry("result.radius = { is = \"wide\" }"), ": mistake \"one\": result.radius: is takes"},
      {entry("area = \"two\"", "operating_point"), ": mistake \"one\": area: \"two\" is not"},
      {entry("area = [2]", "operating_point"), ": mistake \"one\": area: two numbers"},
      {entry("stiffness = [2]", "operating_point"), ": mistake \"one\": stiffness: two numbers"},
      {entry("area = [2, 2]\nstiffness = [2, 2]", "operating_point"),
       ": mistake \"one\": these changes cannot stand together"},
      {entry("area = [2, 2]"),
       ": mistake \"one\": scene, area, stiffness, friction and left_out are for"},
      {entry("", "operating_point"), ": mistake \"one\": nothing is changed"},
      {entry("scene.bodies.colour = { times = 2 }", "operating_point"),
       ": mistake \"one\": a scene has no number or word bodies.colour"},
      {entry("input.load = { times = 2 }", "operating_point"),
       ": mistake \"one\": where, input, result, law and sharing are for single"},
  };
  for (const auto& [text, said] : refused)
    EXPECT_EQ(refusal_of(text).substr(0, said.size()), said) << text;
  EXPECT_EQ(refusal_of(entry("input.load = { times = 2 }")), "");
}

}  // namespace
}  // namespace tribo::conformance
