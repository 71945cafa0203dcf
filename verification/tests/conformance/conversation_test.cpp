// SPDX-License-Identifier: Apache-2.0
// The lines that are taken for answers to cases, and the messages on lines that are no answers.
#include "conformance/conversation.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "conformance/child_process.hpp"
#include "support/temporary_folder.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;

TestCase case_of(const std::string& id) {
  return {id, "film", {{"load", 1}}, Contract{}, {}, false};
}

// The conversation about these cases with a program that prints the lines at its start.
Conversation said(const std::vector<std::string>& ids, const std::string& lines) {
  std::vector<TestCase> cases;
  for (const std::string& id : ids) cases.push_back(case_of(id));
  return ask("printf '" + lines + "'; cat > /dev/null", cases, {}, [](std::size_t) {});
}

TEST(AnswerLine, OfNumbersThatJsonDoesNotHaveIsReadWithTextsInTheirPlace) {
  for (const std::string word : {"NaN", "nan", "-nan", "Infinity", "-inf", "1e999", "-1e999"}) {
    const json answer = read_answer_line(R"({"id": "a NaN", "x": )" + word + R"(, "y": [1, 2.5]})");
    ASSERT_TRUE(answer.is_object()) << word;
    EXPECT_EQ(answer["id"], "a NaN");
    EXPECT_EQ(answer["x"], word);
    EXPECT_EQ(answer["y"][1], 2.5);
  }
  for (const char* const line :
       {"{\"x\": nano}", "{\"x\": 1.2.3}", "no", "{\"x\": \"NaN}", "{", ""})
    EXPECT_TRUE(read_answer_line(line).is_discarded()) << line;
}

TEST(AnswerLine, ThatIsNoJsonIsQuotedWhereItStopsToBe) {
  EXPECT_EQ(why_no_json("{'id': 1}"), "no JSON at character 2, between `{` and `'id': 1}`");
  EXPECT_EQ(why_no_json("{\"id\": 1,}"), "no JSON at character 10, between `{\"id\": 1,` and `}`");
  EXPECT_EQ(why_no_json("{\"id\": 1"), "no JSON: the line ends too early, after `{\"id\": 1`");
  EXPECT_EQ(why_no_json("12"), "a JSON number, no object: 12");
}

TEST(Conversation, TakesAnIdThatIsANumberForTheTextThatItReadsAs) {
  const Conversation made = said({"17", "18"}, R"({"id": 17, "value": 1}\n{"id": "18"}\n)");
  EXPECT_EQ(made.answers[0].outcome, Outcome::answered);
  EXPECT_EQ(made.answers[0].fields["value"], 1);
  EXPECT_EQ(made.answers[1].outcome, Outcome::answered);
  EXPECT_EQ(made.violation_count, 0U);
}

TEST(Conversation, CountsLinesBetweenTheAnswersEvenWhereTheyNameACase) {
  const Conversation made =
      said({"a", "b"}, R"(hello\nasked "a"\n{"id": "a"}\n{"id": "b", broken\n{"id": "b"}\n)");
  EXPECT_EQ(made.answers[0].outcome, Outcome::answered);
  EXPECT_EQ(made.answers[1].outcome, Outcome::answered);
  EXPECT_EQ(made.print_count, 3U);
  EXPECT_EQ(made.first_print, "hello");
  EXPECT_EQ(made.violation_count, 0U);
  EXPECT_EQ(made.never_answered, "");
}

TEST(Conversation, TakesABrokenLineForTheAnswerWhereTheNextCaseIsAnsweredAfterIt) {
  const Conversation made = said({"a", "b"}, R"({"id": "a", broken}\n{"id": "b"}\n)");
  EXPECT_EQ(made.answers[0].outcome, Outcome::garbage);
  EXPECT_TRUE(made.answers[0].reason.starts_with("no JSON at character 13"))
      << made.answers[0].reason;
  EXPECT_EQ(made.answers[1].outcome, Outcome::answered);
}

TEST(Conversation, TellsAnswersWithoutAnIdFromThoseWithAnotherId) {
  for (const std::string answer : {"{\"x\": 1}", "{\"id\": [1]}", "{\"id\": null}"})
    EXPECT_EQ(said({"a"}, answer + "\\n").violations,
              std::vector<std::string>{"an answer without an id: " + answer});
  for (const std::string answer : {"{\"id\": \"b\"}", "{\"id\": 7}"})
    EXPECT_EQ(said({"a"}, answer + "\\n").violations,
              std::vector<std::string>{"an id that was not asked: " + answer});
}

TEST(Conversation, SaysWhyNoCaseHasAnAnswer) {
  const auto why = [](const std::string& command) {
    return ask(command, {case_of("a")}, {}, [](std::size_t) {}).never_answered;
  };
  EXPECT_EQ(why("exit 3"), "it exits with code 3");
  EXPECT_EQ(why("kill -9 $$"), "it is killed by signal 9 (SIGKILL, Killed)");
  EXPECT_EQ(why("exit 139"),
            "it is killed by signal 11 (SIGSEGV, Segmentation fault), as its exit code 139 says");
  EXPECT_EQ(why("exit 128"), "it exits with code 128");
  EXPECT_EQ(why("exit 255"), "it exits with code 255");
  EXPECT_EQ(why("echo '{\"id\": \"a\"}'; cat > /dev/null"), "");
}

// A solver that answers with the number of the question and that of its process.
constexpr const char* counter =
    R"(n=0; while read -r line; do n=$((n+1)); id=${line##*'"id":"'}; id=${id%%'"'*};
       echo "{\"id\":\"$id\",\"n\":$n,\"process\":$$}"; done)";

Conversation counted(std::size_t count, const Manner& manner) {
  std::vector<TestCase> cases;
  for (std::size_t i = 0; i < count; ++i) cases.push_back(case_of("c" + std::to_string(i)));
  return ask(
      counter, cases, {}, [](std::size_t) {}, manner);
}

TEST(Conversation, AsksAgainAtTheEndInTheOppositeOrder) {
  const Conversation made = counted(3, {1, {0, 2}});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(made.answers[i].fields["n"], i + 1);
  EXPECT_EQ(made.again, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(made.second_answers[1].fields["n"], 4);
  EXPECT_EQ(made.second_answers[0].fields["n"], 5);
}

TEST(Conversation, WithSeveralProcessesAsksEachCaseOfOneAndGreetsTheOthersWithACase) {
  const Conversation made = counted(100, {3, {0, 99}});
  std::map<int, int> most, count;
  for (const Reply& one : made.answers) {
    ASSERT_EQ(one.outcome, Outcome::answered);
    const int process = one.fields["process"], n = one.fields["n"];
    ++count[process];
    most[process] = std::max(most[process], n);
  }
  ASSERT_EQ(count.size(), 3U);
  const int first = made.answers[0].fields["process"];
  for (const auto& [process, n] : count) EXPECT_EQ(most[process], process == first ? n : n + 1);
  EXPECT_EQ(made.second_answers[0].fields["process"], first);
  EXPECT_EQ(made.second_answers[1].fields["process"], made.answers[99].fields["process"]);
  EXPECT_EQ(made.starts, 1);
}

// A long line keeps the fields that were asked for, and a long text in it its beginning.
TEST(Conversation, KeepsOfAnAnswerBeyond4096CharactersWhatWasAskedFor) {
  TestCase asked = case_of("a");
  asked.expected.push_back({.field = "x"});
  const auto kept = [&](const std::string& line) {
    return ask("printf '%s\\n' '" + line + "'; cat > /dev/null", {asked}, {}, [](std::size_t) {})
        .answers[0]
        .fields;
  };
  for (const std::size_t size : {4095U, 4096U, 4097U}) {
    const std::string head = R"({"id":"a","x":1,"y":")", end = R"("})";
    const json whole = kept(head + std::string(size - head.size() - end.size(), 'y') + end);
    EXPECT_EQ(whole["x"], 1);
    EXPECT_EQ(whole.contains("y"), size <= 4096) << size;
    const std::string text(size - 2, 'x');  // `size` characters with its quotes
    const json part = kept(R"({"id":"a","x":")" + text + R"(","y":2})");
    EXPECT_FALSE(part.contains("y"));
    EXPECT_EQ(part["x"] == text, size <= 4096) << size;
    EXPECT_TRUE(part["x"].get<std::string>().starts_with("\"xxx") || size <= 4096);
  }
}

// --- The processes themselves.

using std::chrono::milliseconds;

std::vector<std::string> shell(const std::string& script) { return {"sh", "-c", script}; }

TEST(ChildProcess, TellsHowItEndsAndThatItHasNot) {
  struct End {
    std::string script;
    int exit_code, signal;
    std::string text;
  };
  for (const End& one :
       {End{"exit 0", 0, 0, "exits with code 0"},
        {"exit 3", 3, 0, "exits with code 3"},
        {"kill -11 $$", -1, 11, "is killed by signal 11 (SIGSEGV, Segmentation fault)"},
        {"cat > /dev/null", -1, 0, "is still running"}}) {
    ChildProcess child(shell(one.script), ChildProcess::Pipes::all);
    const bool runs = one.text == "is still running";
    for (int i = 0; i < 2000 && !runs && !child.has_ended(); ++i) ::usleep(5000);
    EXPECT_EQ(child.has_ended(), !runs) << one.script;
    EXPECT_EQ(child.exit_code(), one.exit_code) << one.script;
    EXPECT_EQ(child.signal(), one.signal) << one.script;
    EXPECT_EQ(child.end_text(), one.text);
  }
}

TEST(ChildProcess, ThatClosesItsInputHasNothingUnread) {
  ChildProcess child(shell("read -r first; exec 0<&-; echo closed; cat /dev/zero > /dev/null"),
                     ChildProcess::Pipes::all);
  for (const char* const line : {"first", "second"}) child.send(line);
  EXPECT_EQ(child.unread(), 13U);
  std::string line;
  while (child.next_line(line, milliseconds(20000)) != ChildProcess::Event::line)
    ASSERT_FALSE(child.has_ended());
  EXPECT_EQ(line, "closed");
  EXPECT_FALSE(child.has_ended());
  for (int i = 0; i < 1000 && !child.refuses_input(); ++i) child.next_line(line, milliseconds(20));
  EXPECT_TRUE(child.refuses_input());
  EXPECT_EQ(child.unread(), 0U);
  child.send("third");
  EXPECT_EQ(child.unread(), 0U);
}

// Errors are read as they come. Otherwise a full pipe would stop the program before its answer.
TEST(ChildProcess, MayWriteMoreErrorsThanAPipeHoldsBeforeItAnswers) {
  ChildProcess child(shell("head -c 1000000 /dev/zero >&2; echo last words >&2; echo answer; cat"),
                     ChildProcess::Pipes::all);
  std::string line;
  ASSERT_EQ(child.next_line(line, milliseconds(20000)), ChildProcess::Event::line);
  EXPECT_EQ(line, "answer");
  EXPECT_TRUE(child.last_errors().ends_with("last words\n"));
  EXPECT_LT(child.last_errors().size(), 1000000U);
}

// A program without our streams reads nothing from them and writes nothing into them.
TEST(GuardedChild, HasNoneOfOurStreams) {
  const TemporaryFolder folder;
  const std::string path = folder.written("stdin", "ours");
  const int before = ::dup(STDIN_FILENO), file = ::open(path.c_str(), O_RDWR);
  ASSERT_EQ(::dup2(file, STDIN_FILENO), STDIN_FILENO);
  GuardedChild child(shell("echo out; echo error >&2; test -z \"$(cat)\""), {});
  child.wait();
  ::dup2(before, STDIN_FILENO);
  for (const int one : {before, file}) ::close(one);
  EXPECT_EQ(child.exit_code(), 0);
  EXPECT_EQ(content_of(path), "ours");
}

}  // namespace
}  // namespace tribo::conformance
