// SPDX-License-Identifier: Apache-2.0
#include "conformance/conversation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "conformance/asker.hpp"
#include "scene/entries.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;

// The line with quotes around each NaN, -inf, 1e999 … that stands outside of texts.
std::string with_quoted_non_numbers(const std::string& line) {
  std::string made;
  for (std::size_t i = 0; i < line.size();) {
    const auto is_of_word = [&](std::size_t k) {
      const char c = line[k];
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
    };
    std::size_t end = i + 1;
    if (line[i] == '"') {
      while (end < line.size() && line[end] != '"') end += line[end] == '\\' ? 2 : 1;
      end = std::min(end + 1, line.size());
      made.append(line, i, end - i);
    } else if (is_of_word(i)) {
      while (end < line.size() && is_of_word(end)) ++end;
      const std::string word = line.substr(i, end - i);
      char* rest = nullptr;
      const double number = std::strtod(word.c_str(), &rest);
      const bool is_non_number = *rest == '\0' && !std::isfinite(number);
      made += is_non_number ? '"' + word + '"' : word;
    } else {
      made += line[i];
    }
    i = end;
  }
  return made;
}

// --- Several askers.

constexpr std::size_t most_error_lines = 20;

// So many neighbouring cases are dealt to one asker. Each asker then notices a function that never
// answers, and all askers share a slow one.
constexpr std::size_t dealt_together = 8;

std::vector<std::vector<std::size_t>> dealt(const std::vector<std::size_t>& cases, int askers) {
  std::vector<std::vector<std::size_t>> shares(static_cast<std::size_t>(askers));
  // The first asker has cases already.
  for (std::size_t i = 0; i < cases.size(); ++i)
    shares[(1 + i / dealt_together) % shares.size()].push_back(cases[i]);
  return shares;
}

// The askers beside the first one. Each has a thread of its own, which its processes need.
class Helpers {
 public:
  explicit Helpers(Questions& questions) : questions_(questions) {}

  void start(const std::vector<std::size_t>& share) {
    std::deque<std::size_t> to_ask(share.begin(), share.end());
    for (const std::size_t i : questions_.repeats_of(share)) to_ask.push_back(i);
    Helper& helper = helpers_.emplace_back(to_ask, questions_);
    try {
      helper.thread = std::jthread([&helper] {
        try {
          helper.has_run = helper.asker->run(true);
        } catch (const std::system_error&) {  // the system refuses more processes
        }
      });
    } catch (const std::system_error&) {  // the system refuses more threads
    }
  }

  // Waits for all helpers. If a helper could not start, or its process did not answer the greeting,
  // perhaps because another process was running, its share is asked now, with no other process.
  std::vector<Account> accounts() {
    for (Helper& one : helpers_)
      if (one.thread.joinable()) one.thread.join();
    std::vector<Account> made;
    for (Helper& one : helpers_) {
      if (!one.has_run) {
        one.asker = std::make_unique<Asker>(questions_, one.to_ask);
        one.asker->run(false);
      }
      made.push_back(std::move(one.asker->account));
    }
    return made;
  }

 private:
  struct Helper {
    Helper(std::deque<std::size_t> share, Questions& questions)
        : to_ask(std::move(share)), asker(std::make_unique<Asker>(questions, to_ask)) {}

    std::deque<std::size_t> to_ask;
    std::unique_ptr<Asker> asker;
    bool has_run = false;
    std::jthread thread;
  };

  Questions& questions_;
  std::deque<Helper> helpers_;  // a deque, because threads keep their addresses
};

// --- One conversation of all accounts.

// Applies the limits of patience as if one process at a time were asked everything in order. Each
// asker saw only a part of the failures, and may have asked more than that process would be asked.
// Replies to such questions are dropped. Returns the number of starts. Only the failures that count
// stay in `breakdowns`.
int settle_in_order(Questions& questions, std::map<std::size_t, Breakdown>& breakdowns,
                    bool is_shared) {
  std::vector<std::size_t> order(questions.greeting());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return questions.places[a] < questions.places[b];
  });
  Patience patience;
  std::map<std::string, std::string> given_up;  // groups, and why
  int starts = 1;
  bool has_process = true, has_answered = true;
  for (const std::size_t question : order) {
    Reply& reply = questions.reply(question);
    if (questions.is_moot(question)) {
      reply = {};
      continue;
    }
    const std::string group = questions.group(question);
    if (!has_process && patience.is_over()) {
      given_up[patience.group()] = patience.reason();
      patience.note_answer();
    }
    const bool is_over = !has_process && starts >= most_starts;
    if (is_over || given_up.contains(group)) {
      reply = {Outcome::not_asked, {}, is_over ? too_many_starts() : given_up[group]};
      breakdowns.erase(question);
      continue;
    }
    if (reply.outcome == Outcome::not_asked) continue;
    if (!has_process) {
      ++starts;
      has_process = true;
      has_answered = false;
    }
    const auto breakdown = breakdowns.find(question);
    if (breakdown != breakdowns.end()) {
      patience.note_failure(questions, question, breakdown->second.end);
      if (is_shared && reply.outcome == Outcome::late)
        reply.reason =
            late_text(questions.limits, has_answered,
                      reply.reason.substr(std::min(reply.reason.find(';'), reply.reason.size())));
      has_process = false;
    } else if (reply.outcome != Outcome::missing && reply.outcome != Outcome::garbage) {
      patience.note_answer();
      has_answered = true;
    }
  }
  return starts;
}

std::vector<std::string> error_lines(const Conversation& conversation) {
  std::vector<std::string> lines;
  std::istringstream text(conversation.last_errors);
  std::vector<KindLine> written;
  for (std::string line; std::getline(text, line);) written.push_back({line, line, {}});
  lines = without_repeats(written);
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  const auto has_failed = [](const Reply& one) {
    return one.outcome != Outcome::answered && one.outcome != Outcome::skipped;
  };
  const bool has_failures =
      std::any_of(conversation.answers.begin(), conversation.answers.end(), has_failed);
  const std::size_t kept = std::min(lines.size(), has_failures ? most_error_lines : 1);
  lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(kept));
  return lines;
}

bool is_before(const Heard& one, const Heard& other) { return one.place < other.place; }

// The first account is of the asker that found out whether the subject answers at all.
Conversation told(Questions& questions, const std::vector<Account>& accounts) {
  const Account& first = accounts.front();
  Conversation made;
  made.answers_at_end_of_input = first.answers_at_end_of_input;
  made.never_answered = first.never_answered;
  made.exit_code_without_answer = first.exit_code_without_answer;
  std::map<std::size_t, Breakdown> breakdowns;
  std::vector<Heard> violations;
  std::optional<Heard> first_print;
  std::string bad_end;
  for (const Account& one : accounts) {
    breakdowns.insert(one.breakdowns.begin(), one.breakdowns.end());
    violations.insert(violations.end(), one.violations.begin(), one.violations.end());
    made.violation_count += one.violation_count;
    made.print_count += one.print_count;
    if (one.first_print && (!first_print || is_before(*one.first_print, *first_print)))
      first_print = one.first_print;
    if (bad_end.empty()) bad_end = one.bad_end;
    made.stays |= one.stays;
    made.seconds.cpu += one.cpu_seconds;
    for (const auto& [function, seconds] : one.seconds) made.seconds.functions[function] += seconds;
    if (made.last_errors.empty()) made.last_errors = one.final_errors;
  }
  if (made.never_answered.empty())
    made.starts = settle_in_order(questions, breakdowns, accounts.size() > 1);
  // The errors are those of the first asker's last process, or else of the last one that failed.
  if (first.final_errors.empty()) {
    std::size_t latest = 0;
    for (const auto& [question, breakdown] : breakdowns)
      if (!breakdown.errors.empty() && questions.places[question] >= latest) {
        latest = questions.places[question];
        made.last_errors = breakdown.errors;
      }
  }
  std::stable_sort(violations.begin(), violations.end(), is_before);
  if (violations.size() > most_violations) violations.resize(most_violations);
  for (Heard& one : violations) made.violations.push_back(std::move(one.text));
  if (!bad_end.empty()) {
    ++made.violation_count;
    if (made.violations.size() < most_violations) made.violations.push_back(bad_end);
  }
  if (first_print) made.first_print = first_print->text;
  made.answers = std::move(questions.answers);
  made.again = questions.again;
  made.second_answers = std::move(questions.second_answers);
  made.error_lines = error_lines(made);
  return made;
}

}  // namespace

json read_answer_line(const std::string& line) {
  if (scene_detail::nests_too_deep(line)) return json(json::value_t::discarded);
  const json answer = json::parse(line, nullptr, false);
  return answer.is_discarded() ? json::parse(with_quoted_non_numbers(line), nullptr, false)
                               : answer;
}

std::string why_no_json(const std::string& line) {
  if (scene_detail::nests_too_deep(line))
    return fmt::format("{}: {}", scene_detail::too_deep_text, start_of(line));
  try {
    const json whole = json::parse(line);
    return fmt::format("a JSON {}, no object: {}", whole.type_name(), start_of(line));
  } catch (const json::parse_error& error) {
    constexpr std::size_t around = 40;
    const std::size_t at = std::min(error.byte - std::min<std::size_t>(error.byte, 1), line.size());
    const std::size_t from = at - std::min(at, around);
    const std::string before = (from > 0 ? "…" : "") + printable(line.substr(from, at - from));
    if (at == line.size())
      return fmt::format("no JSON: the line ends too early, after `{}`", before);
    return fmt::format("no JSON at character {}, between `{}` and `{}`", at + 1, before,
                       printable(std::string_view(line).substr(at), around));
  } catch (const json::exception&) {
  }
  return "no JSON object: " + start_of(line);
}

std::string line_of(const json& value) {
  return value.dump(-1, ' ', true, json::error_handler_t::replace);
}

std::string start_of(const std::string& text) { return printable(text, 80); }

Reply reply_of(json answer) {
  const auto reason = [](const json& what) {
    std::string text = what.is_string() ? what.get<std::string>() : line_of(what);
    return text.size() <= longest_kept_answer ? text : printable(text, longest_kept_answer);
  };
  if (answer.contains("skip")) return {Outcome::skipped, {}, reason(answer["skip"])};
  if (!answer.contains("error")) return {Outcome::answered, std::move(answer)};
  const json& error = answer["error"];
  const bool has_message = error.is_object() && error.contains("message");
  return {Outcome::refused, {}, reason(has_message ? error["message"] : error)};
}

std::vector<std::string> without_repeats(const std::vector<KindLine>& lines) {
  constexpr std::size_t most_alike = 3;
  std::vector<std::string> made;
  for (std::size_t first = 0, end = 0; first < lines.size(); first = end) {
    while (end < lines.size() && lines[end].kind == lines[first].kind) ++end;
    if (end - first <= most_alike) {
      for (std::size_t i = first; i < end; ++i) made.push_back(lines[i].text);
      continue;
    }
    std::string names;
    for (std::size_t i = first + 1; i < end; ++i)
      if (!lines[i].name.empty()) names += (names.empty() ? ": " : ", ") + lines[i].name;
    made.push_back(lines[first].text);
    made.push_back(fmt::format("  and {} more like it{}", end - first - 1, names));
  }
  return made;
}

std::string last_line(std::string errors) {
  while (errors.ends_with('\n')) errors.pop_back();
  errors.erase(0, errors.rfind('\n') + 1);
  const std::string own_prefix = "tribocheck: ";
  if (errors.starts_with(own_prefix)) errors.erase(0, own_prefix.size());
  return errors;
}

Conversation ask(const std::string& command, const std::vector<TestCase>& cases,
                 const Limits& limits, const std::function<void(std::size_t)>& progress,
                 const Manner& manner) {
  const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  std::mutex mutex;
  std::size_t settled = 0;
  Questions questions(command, cases, limits, manner.again, [&] {
    const std::lock_guard lock(mutex);
    progress(++settled);
  });
  Helpers helpers(questions);
  const auto share = [&](std::deque<std::size_t>& to_ask) {
    if (manner.processes == 1) return;
    std::vector<std::size_t> left;
    for (const std::size_t i : to_ask)
      if (!questions.is_repeat(i)) left.push_back(i);
    const std::vector<std::vector<std::size_t>> shares = dealt(left, manner.processes);
    for (std::size_t k = 1; k < shares.size(); ++k) {
      if (shares[k].empty()) continue;
      helpers.start(shares[k]);
      const std::set<std::size_t> taken(shares[k].begin(), shares[k].end());
      std::erase_if(to_ask, [&](std::size_t i) { return taken.contains(questions.case_of(i)); });
    }
  };
  std::deque<std::size_t> all(cases.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (std::size_t i = manner.again.size(); i-- > 0;) all.push_back(cases.size() + i);
  Asker first(questions, std::move(all), share);
  first.run(false);
  std::vector<Account> accounts = helpers.accounts();
  accounts.insert(accounts.begin(), std::move(first.account));
  Conversation made = told(questions, accounts);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  made.seconds.run = taken.count();
  return made;
}

std::vector<std::size_t> cases_to_repeat(const std::vector<TestCase>& cases) {
  constexpr std::size_t one_of = 24;
  std::map<std::string, std::size_t> seen;
  std::vector<std::size_t> made;
  for (std::size_t i = 0; i < cases.size(); ++i)
    // The points of a scene of the paper have ids such as "rough@0.01".
    if (const std::size_t at = cases[i].id.find('@'), scene = at == std::string::npos ? 0 : at;
        seen[cases[i].function + cases[i].id.substr(0, scene)]++ % one_of == 0)
      made.push_back(i);
  return made;
}

}  // namespace tribo::conformance
