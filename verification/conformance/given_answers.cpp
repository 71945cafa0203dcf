// SPDX-License-Identifier: Apache-2.0
#include "conformance/given_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

namespace tribo::conformance {

std::string question_lines(const std::vector<TestCase>& cases) {
  std::string lines;
  for (const TestCase& one : cases) lines += one.line() + '\n';
  const std::vector<std::size_t> again = cases_to_repeat(cases);
  for (std::size_t i = again.size(); i-- > 0;) lines += cases[again[i]].line() + '\n';
  return lines;
}

Conversation conversation_of(const std::vector<TestCase>& cases, std::string_view lines) {
  Conversation made;
  const Reply none{Outcome::missing, {}, "no answer"};
  made.answers.assign(cases.size(), none);
  made.again = cases_to_repeat(cases);
  made.second_answers.assign(made.again.size(), Reply{});
  std::unordered_map<std::string, std::size_t> place;
  for (std::size_t i = 0; i < cases.size(); ++i) place[cases[i].id] = i;
  for (std::size_t number = 1; !lines.empty(); ++number) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    const std::string line(lines.substr(0, end));
    lines.remove_prefix(std::min(end + 1, lines.size()));
    if (line.empty()) continue;
    const auto refuse = [&](const std::string& why) {
      throw std::invalid_argument(fmt::format("line {} of the answers: {}", number, why));
    };
    nlohmann::json answer = read_answer_line(line);
    if (answer.is_discarded()) refuse(why_no_json(line));
    const auto id = answer.is_object() ? answer.find("id") : answer.end();
    if (id == answer.end() || !id->is_string())
      refuse("an answer without an id: " + start_of(line));
    const auto asked = place.find(id->get<std::string>());
    if (asked == place.end()) refuse("an id that was not asked: " + start_of(line));
    Reply* to = &made.answers[asked->second];
    if (to->outcome != Outcome::missing) {
      const auto again = std::lower_bound(made.again.begin(), made.again.end(), asked->second);
      if (again == made.again.end() || *again != asked->second)
        refuse("a second answer to a case that was asked once: " + start_of(line));
      to = &made.second_answers[static_cast<std::size_t>(again - made.again.begin())];
      if (to->outcome != Outcome::not_asked)
        refuse("a third answer to a case that was asked twice: " + start_of(line));
    }
    *to = reply_of(std::move(answer));
  }
  return made;
}

}  // namespace tribo::conformance
