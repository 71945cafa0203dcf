// SPDX-License-Identifier: Apache-2.0
// Text that is not TOML, not JSON, or made to hurt a parser.
#include <random>

#include "scene/scene_text.hpp"
#include "scene/spoilt_text.hpp"

namespace tribo::scene_test {
namespace {

std::string repeated(std::string_view part, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i) text += part;
  return text;
}

testing::AssertionResult refused_at(Format format, const std::string& text, std::size_t row,
                                    std::size_t column, std::string_view part) {
  const SceneReading reading = read(format, text);
  const std::string place = "test:" + std::to_string(row) + ':' + std::to_string(column) + ": ";
  if (reading.errors.size() == 1 && reading.errors[0].line().starts_with(place) &&
      reading.errors[0].line().find(part) != std::string::npos)
    return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << "input: " << text << "\nwanted: " << place << "… " << part << "\nerrors:\n"
         << lines_of(reading.errors);
}

TEST(BrokenToml, IsReportedWithItsPlace) {
  EXPECT_TRUE(refused_at(Format::toml, "load = \n", 1, 8, "not TOML"));
  EXPECT_TRUE(refused_at(Format::toml, "load = 50\nload 60\n", 2, 6, "expected '='"));
  EXPECT_TRUE(refused_at(Format::toml, "[surface\n", 1, 9, "not TOML"));
  EXPECT_TRUE(refused_at(Format::toml, "id = \"a\n", 1, 8, "not TOML"));
  EXPECT_TRUE(refused_at(Format::toml, "[=]\n", 1, 2, "not TOML"));
  EXPECT_TRUE(refused_at(Format::toml, "load = 007\n", 1, 11, "leading zeroes"));
}

TEST(BrokenToml, NonAsciiOutsideStringsAndCommentsIsRefusedWithItsPlace) {
  EXPECT_TRUE(refused_at(Format::toml, "load = 5\nl\u00f6d = 3\n", 2, 2, "non-ASCII"));
  EXPECT_TRUE(refused_at(Format::toml, "load\u00a0= 5\n", 1, 5, "non-ASCII"));
  EXPECT_TRUE(refused_at(Format::toml, "id = \u201cx\u201d\n", 1, 6, "non-ASCII"));
  EXPECT_TRUE(refused_at(Format::toml, "id = \"\"\"a\n\"\"\" \u00b5\n", 2, 5, "non-ASCII"));
}

TEST(BrokenToml, NonAsciiInStringsAndCommentsIsFine) {
  const std::string rest = SceneText::good().remove("id").toml();
  for (const char* start : {"# µ é 漢\n", "id = \"µ 漢\"\n", "id = 'µ'  # µ\n",
                            "id = \"\"\"\nµ\"\"µ\"\"\"\"\"\n", "id = '''µ'µ'''\n"})
    EXPECT_TRUE(accepted(Format::toml, start + rest));
}

// toml++ reads beyond such a value, into the string that follows it. The é in this string led to
// code that toml++ takes to be unreachable.
TEST(BrokenToml, ValueRunningIntoAStringIsRefused) {
  for (const char* text : {"a=+\"é\"\n", "a=[1,1e400[\"é\"]]\n", "a=1979-05-27 0\"é\"\n",
                           "a=1:\"\u2003\"\n", "a=1e400\"\u3000\"\n"})
    EXPECT_TRUE(refused(Format::toml, text, "", "not TOML"));
}

TEST(BrokenText, ControlSignsAndInvalidUtf8AreRefused) {
  using std::string_literals::operator""s;
  for (const std::string& spoilt :
       {"id = \"a\0b\"\n"s, "\0"s, "# \x01\n"s, "id = \"\x7f\"\n"s, "id = \"\xff\"\n"s, "# \xc3\n"s,
        "id = \"\xed\xa0\x80\"\n"s, "id = \"\xc0\xaf\"\n"s, "id = \"\xf4\x90\x80\x80\""s})
    EXPECT_FALSE(read(Format::toml, spoilt).errors.empty()) << spoilt;
  EXPECT_TRUE(refused_at(Format::toml, "load = 1\nid = \"a\0\"\n"s, 2, 8, "control character"));
  EXPECT_TRUE(refused_at(Format::toml, "load = 1\nid = \"\xff\"\n"s, 2, 7, "not UTF-8: \\xff"));
  for (const std::string& spoilt : {"{\"id\": \"a\0b\"}"s, "{\"id\": \"\xff\"}"s, "\0"s, "{\xff}"s,
                                    "{\"id\": \"\xed\xa0\x80\"}"s, "{\"id\": \"\\ud800\"}"s})
    EXPECT_TRUE(refused(Format::json, spoilt, "", "not JSON")) << spoilt;
}

TEST(BrokenJson, IsReportedWithItsPlace) {
  EXPECT_TRUE(refused_at(Format::json, "{\"load\": 5,}", 1, 12, "not JSON"));
  EXPECT_TRUE(refused_at(Format::json, "{\"load\": 5,\n \"id\" 7}", 2, 7, "not JSON"));
  EXPECT_TRUE(refused_at(Format::json, "{\"load\": 05}", 1, 11, "not JSON"));
  EXPECT_TRUE(refused_at(Format::json, "{\"load\": 5", 1, 11, "unexpected end of input"));
  EXPECT_TRUE(refused_at(Format::json, "{\"id\": \"µµ\"}\n\n x", 3, 2, "end of input"));
}

TEST(BrokenJson, NanAndInfinityAreToldWhereverTheyBegin) {
  for (const char* word : {"NaN", "nan", "NAN", "Infinity", "-Infinity", "inf", "-INF"}) {
    for (const char* before :
         {"", " ", "{\"load\": ", "{\"load\":", "{\"speed\": [", "{\"speed\": [1, "}) {
      const SceneReading reading = read(Format::json, std::string(before) + word);
      ASSERT_FALSE(reading.errors.empty());
      EXPECT_NE(reading.errors[0].line().find("NaN and infinity are not JSON"), std::string::npos)
          << before << word << ": " << reading.errors[0].line();
    }
  }
}

TEST(BrokenJson, NothingMayFollowTheScene) {
  for (const char* garbage : {"x", "{}", ",", "1", "\n{}", "]", "}"})
    EXPECT_TRUE(refused(Format::json, SceneText::good().json() + garbage, "", "not JSON"));
  EXPECT_TRUE(accepted(Format::json, SceneText::good().json() + " \n\t\r\n"));
}

TEST(BrokenJson, OnlyAnObjectIsAScene) {
  for (const char* text : {"[]", "[{}]", "5", "null", "true", "\"load\"", "-1.5", "1e-400"})
    EXPECT_TRUE(refused(Format::json, text, "", "is an object"));
  EXPECT_FALSE(read(Format::json, "1e400").errors.empty());
  EXPECT_FALSE(read(Format::json, "").errors.empty());
  EXPECT_EQ(read(Format::json, "{}").errors.size(), 6u);
}

TEST(BrokenJson, ControlSignsOfAnIdAreKeptWhenEscaped) {
  const SceneReading reading =
      read(Format::json, SceneText::good().set("id", R"("a\u0000\n\u00e9")"));
  using std::string_literals::operator""s;
  EXPECT_EQ(reading.scene.value().id, "a\0\n\u00e9"s);
}

TEST(BrokenText, MessagesAreValidUtf8WhateverTheSourceIsCalled) {
  const struct {
    const char *name, *shown;
  } cases[] = {{"µ 漢 😀", "µ 漢 😀"},
               {"\xff\xc3", "\\xff\\xc3"},
               {"\xed\xa0\x80", "\\xed\\xa0\\x80"},
               {"\xe0\x9f\xbf", "\\xe0\\x9f\\xbf"},
               {"\xf0\x8f\xbf\xbf", "\\xf0\\x8f\\xbf\\xbf"},
               {"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"},
               {"\xc1\xbf", "\\xc1\\xbf"},
               {"\xe2\x82", "\\xe2\\x82"},
               {"\u009b\u202e\ufeff\x7f", "\\u009b\\u202e\\ufeff\\u007f"}};
  for (const auto& [name, shown] : cases)
    EXPECT_EQ(parse_scene_json("[]", name, SceneUse::speeds).errors.at(0).source, shown);
}

TEST(BrokenText, ByteOrderMarkIsSkipped) {
  for (const Format format : formats)
    EXPECT_TRUE(accepted(format, "\xEF\xBB\xBF" + SceneText::good().written(format)));
}

TEST(BrokenText, DuplicatesNameTheField) {
  EXPECT_TRUE(refused_at(Format::toml, "load = 1\nload = 2\n", 2, 8, "load: given twice"));
  EXPECT_TRUE(refused(Format::toml, "[lubricant]\nviscosity = 1\n\nviscosity = 2\n",
                      "lubricant.viscosity", "given twice"));
  EXPECT_TRUE(refused(Format::toml, "[bodies]\n[surface]\n[bodies]\n", "bodies", "given twice"));
  std::string json = SceneText::good().json();
  json.insert(1, R"("bodies": {}, )");
  EXPECT_TRUE(refused(Format::json, json, "bodies", "given twice"));
}

TEST(BrokenText, DepthBombsAreRefused) {
  constexpr std::size_t many = 500'000;
  for (const std::string& bomb :
       {"a = " + repeated("[", many), "a = " + repeated("{a=", many / 2),
        "a = " + repeated("[", many) + repeated("]", many), repeated("a.", many) + "a = 1",
        '[' + repeated("a.", many) + "a]", repeated("\"a\".", many / 3) + "a = 1",
        repeated("a . ", many / 3) + "a = 1", "a = {" + repeated("a.", many) + "a = 1}"})
    EXPECT_TRUE(refused(Format::toml, bomb, "", "more than 16 deep")) << bomb.substr(0, 20);
  for (const std::string& bomb : {R"({"a": )" + repeated("[", many), repeated(R"({"a":)", many / 5),
                                  R"({"a": )" + repeated("[", many) + repeated("]", many) + '}',
                                  R"({"load": )" + repeated(R"([{"a":)", many / 8)})
    EXPECT_TRUE(refused(Format::json, bomb, "", "more than 16 deep")) << bomb.substr(0, 20);
  EXPECT_FALSE(read(Format::toml, repeated("[", many)).errors.empty());
  EXPECT_FALSE(read(Format::json, repeated("[", many)).errors.empty());
}

TEST(BrokenText, FieldsWithoutEndAreRefused) {
  std::string toml, json = "{", headers, overflows = "{\"speed\": [1";
  for (int i = 0; i < 20'000; ++i) {
    const std::string number = std::to_string(i);
    toml += 'a' + number + ".b.c = 1\n";
    headers += "[a" + number + ".b]\n";
    json += "\"a" + number + "\": 1, ";
    overflows += ", 1e400";
  }
  EXPECT_TRUE(refused(Format::toml, toml, "", "more than 1000 fields"));
  EXPECT_TRUE(refused(Format::toml, headers, "", "more than 1000 fields"));
  EXPECT_TRUE(refused(Format::json, json + "\"b\": 1}", "", "more than 1000 fields"));
  EXPECT_FALSE(read(Format::json, overflows + "]}").errors.empty());
}

TEST(BrokenText, TooLargeTextIsRefused) {
  const std::string padding(max_scene_bytes, ' ');
  for (const Format format : formats) {
    const std::string text = SceneText::good().written(format);
    EXPECT_TRUE(refused(format, text + padding, "", "too large"));
    EXPECT_TRUE(accepted(format, text + padding.substr(text.size())));
  }
}

TEST(BrokenText, LongListsOfSpeedsAreRead) {
  const std::string list = "[1" + repeated(",1", 400'000) + ']';
  for (const Format format : formats)
    EXPECT_EQ(read(format, SceneText::good().set("speed", list)).scene.value().speeds.size(),
              400'001u);
}

TEST(WideNumbers, AreFoundWhereverAValueMayStand) {
  const std::string rest = SceneText::good().remove("load").remove("speed").toml();
  for (const char* start :
       {"load = 1e400 # 1e400\nspeed = 1\n", "id='é'\nload=-1e400\nspeed=1\n",
        "load =\t+1_0e4_0_0\r\nspeed=1\n", "speed = {from = 1, to = 2}\nload = 1e400\n",
        "speed = 1\nload = 1e400"}) {
    std::string text = start;
    const bool has_id = text.find("id=") != std::string::npos;
    text += '\n' +
            (has_id ? SceneText::good().remove("load").remove("speed").remove("id").toml() : rest);
    EXPECT_TRUE(refused(Format::toml, text, "load", "is beyond"));
  }
  EXPECT_TRUE(refused(Format::toml, "load = 1\nspeed = [\n 1, # a\n 1e400,\n]\n" + rest, "speed[1]",
                      "is beyond"));
  EXPECT_TRUE(refused(Format::toml, "load = 1\nspeed = {from = 1, to = 1e400}\n" + rest, "speed.to",
                      "is beyond"));
}

TEST(WideNumbers, AreFoundAfterALongStringThatEndsInQuotes) {
  const std::string text =
      SceneText::good().set("speed", R"(["""a"""", 1e400, '''a''''', 1e-400])").toml();
  EXPECT_TRUE(refused(Format::toml, text,
                      {{"speed[0]", "\"a\"\" is a text"},
                       {"speed[1]", "is beyond"},
                       {"speed[2]", "\"a''\" is a text"},
                       {"speed[3]", "underflows"}}));
}

// Up to two quotes after the three that begin a long string, or before the three that end it,
// belong to the string. A sixth quote at the end begins another string.
TEST(BrokenToml, LongStringsBeginAndEndWithAtMostFiveQuotes) {
  for (const char quote : {'"', '\''})
    for (const std::size_t opening : {3U, 4U, 5U})
      for (const std::size_t closing : {3U, 4U, 5U, 6U})
        EXPECT_TRUE(refused(Format::toml,
                            "id = " + std::string(opening, quote) + 'a' +
                                std::string(closing, quote) + "ä" + quote + '\n',
                            "", closing < 6 ? "non-ASCII" : "not TOML"))
            << quote << opening << closing;
}

TEST(WideNumbers, AreLeftAloneInKeysStringsAndComments) {
  const std::string rest = SceneText::good().remove("id").toml();
  EXPECT_EQ(read(Format::toml, "id = \"= 1e400\"\n" + rest).scene.value().id, "= 1e400");
  EXPECT_EQ(read(Format::toml, "id = '''\n[1e400]\n'''\n" + rest).scene.value().id, "[1e400]\n");
  EXPECT_TRUE(refused(Format::toml, rest + "1e400 = 1\n", "1e400", "unknown field"));
  EXPECT_TRUE(refused(Format::toml, rest + "[1e400]\n", "1e400", "unknown table"));
  EXPECT_TRUE(refused(Format::toml, "id = 1e400x\n" + rest, "", "not TOML"));
  EXPECT_TRUE(refused(Format::toml, "id = 01e400\n" + rest, "", "not TOML"));
}

TEST(WideNumbers, InUnknownFieldsNeverHideTheRest) {
  EXPECT_TRUE(refused(SceneText::good().set("lod", "1e400").set("load", "0"),
                      {{"lod", "1e400"}, {"load", "0 is not allowed"}}));
}

// A short random walk; the fuzz targets go further. With sanitizers this finds crashes.
TEST(BrokenText, RandomChangesNeverCrashAndNeverGiveBothSceneAndError) {
  std::mt19937_64 random(20240607);
  for (int round = 0; round < 4000; ++round) {
    const Format format = formats[random() % 2];
    std::string text = SceneText::good().set("speed", "[1, 2]").written(format);
    for (std::size_t change = random() % 6 + 1; change > 0; --change) spoil(text, random);
    const SceneReading reading = read(format, text, static_cast<SceneUse>(random() % 3));
    EXPECT_EQ(reading.scene.has_value(), reading.errors.empty()) << text;
    for (const InputProblem& problem : reading.errors)
      EXPECT_EQ(problem.line().find('\n'), std::string::npos) << text;
  }
}

// Characters are shown as they are, except those that move the cursor, hide, or turn text around.
TEST(Printable, IsEachSignButForTheRangesThatWouldHarm) {
  const auto utf8 = [](unsigned code) {
    std::string text;
    const auto add = [&](unsigned byte) { text += static_cast<char>(byte); };
    if (code >= 0x10000) add(0xF0 | code >> 18);
    if (code >= 0x800) add(code >= 0x10000 ? 0x80 | (code >> 12 & 63) : 0xE0 | code >> 12);
    add(code >= 0x800 ? 0x80 | (code >> 6 & 63) : 0xC0 | code >> 6);
    add(0x80 | (code & 63));
    return text;
  };
  const std::pair<unsigned, unsigned> harmful[] = {
      {0x80, 0x9F}, {0x200B, 0x200F}, {0x2028, 0x202E}, {0x2060, 0x206F}, {0xFEFF, 0xFEFF}};
  std::vector<unsigned> codes{0x7FF, 0x800, 0xD7FF, 0xE000, 0xFFFF, 0x10000, 0x10FFFF};
  for (const auto& [first, last] : harmful)
    for (const unsigned code : {first - 1, first, last, last + 1}) codes.push_back(code);
  for (unsigned code = 0xA0; code <= 0x10FFFF; code += 61) codes.push_back(code);
  for (const unsigned code : codes) {
    if (code < 0x80 || (code >= 0xD800 && code <= 0xDFFF)) continue;  // surrogates
    const bool harms = std::any_of(std::begin(harmful), std::end(harmful), [&](const auto& range) {
      return code >= range.first && code <= range.second;
    });
    EXPECT_EQ(printable(utf8(code)) == utf8(code), !harms) << code;
  }
}

}  // namespace
}  // namespace tribo::scene_test
