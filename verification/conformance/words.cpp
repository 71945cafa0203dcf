// SPDX-License-Identifier: Apache-2.0
#include "conformance/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "conformance/misread.hpp"
#include "conformance/question.hpp"

namespace tribo::conformance {
namespace {

struct AnsweredWord {
  std::string asked, got;  // the right word, and the answer
  Numbers point;           // the right numbers of the point
};

constexpr std::size_t fewest_words = 8;  // points with the word, and points without it
// Rounding may put points next to a limit on the wrong side, if they are few of those beyond it.
constexpr double next_to_limit = 1e-12, few_next_to_limit = 0.1;
constexpr double few_points = 0.1;  // of a limit: points farther apart than this do not fix it

// A number of a point that may decide on a word.
struct Deciding {
  std::string_view name;
  double (*of)(const Numbers& point);
};
template <Output output>
double number_of(const Numbers& point) {
  return point[static_cast<std::size_t>(output)];
}
template <Output output>
constexpr Deciding deciding_by() {
  return {info(output).name, number_of<output>};
}
constexpr std::array deciding{
    deciding_by<Output::asperity_load_share>(), deciding_by<Output::fluid_load_share>(),
    deciding_by<Output::film_parameter>(), deciding_by<Output::real_area_ratio>(),
    Deciding{"film/film_flooded", [](const Numbers& point) {
               return number_of<Output::film>(point) / number_of<Output::film_flooded>(point);
             }}};

// The number with the fewest digits between two others.
double roundest_between(double low, double high) {
  for (int digits = 0; digits < 15; ++digits) {
    const double unit =
        std::pow(10, std::floor(std::log10(std::max(std::abs(low), std::abs(high)))) - digits);
    const double found = std::ceil(low / unit) * unit;
    if (found <= high) return of_digits(found, digits + 2);
  }
  return high;
}

// A word that is answered where a number is above a limit, or below it.
struct WordLimit {
  bool is_above;
  double low, high;  // the limit lies between these
};

std::optional<WordLimit> limit_of(const std::vector<AnsweredWord>& answers, const Deciding& number,
                                  const std::string& word, std::string AnsweredWord::*which) {
  constexpr double far = std::numeric_limits<double>::infinity();
  double least_with = far, most_with = -far, least_without = far, most_without = -far;
  std::vector<double> with, without;
  for (const AnsweredWord& one : answers) {
    const double value = number.of(one.point);
    if (!std::isfinite(value)) continue;
    const bool has = one.*which == word;
    (has ? with : without).push_back(value);
    double &least = has ? least_with : least_without, &most = has ? most_with : most_without;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (with.size() < fewest_words || without.size() < fewest_words) return std::nullopt;
  const auto is_between = [](const std::vector<double>& below, double most, double least) {
    if (most < least) return true;
    const auto beyond =
        std::count_if(below.begin(), below.end(), [&](double one) { return one >= least; });
    return most - least <= next_to_limit * std::abs(least) &&
           static_cast<double>(beyond) <= few_next_to_limit * static_cast<double>(below.size());
  };
  if (is_between(without, most_without, least_with))
    return WordLimit{true, std::min(most_without, least_with), least_with};
  if (is_between(with, most_with, least_without))
    return WordLimit{false, std::min(most_with, least_without), least_without};
  return std::nullopt;
}

// "The word `boundary` is answered from … on", with the first number that decides on the word.
// Empty: no number decides, or the limit of the answers may be the right one.
std::string told(const std::vector<AnsweredWord>& answers, const std::string& word) {
  // The limit may be anywhere between two neighbouring points, which may be far apart.
  const auto place_in_words = [](const WordLimit& limit, const Deciding& number) {
    const std::string border = limit.high - limit.low > few_points * limit.high
                                   ? fmt::format("between {:.3g} and {:.3g}", limit.low, limit.high)
                                   : fmt::format("= {:g}", roundest_between(limit.low, limit.high));
    return limit.is_above ? fmt::format("from {} {} on", number.name, border)
                          : fmt::format("below {} {}", number.name, border);
  };
  std::string right;
  for (const Deciding& number : deciding)
    if (auto limit = limit_of(answers, number, word, &AnsweredWord::asked);
        limit && right.empty()) {
      for (const double border : {0.01, 0.95, 0.99})  // in the words' definitions
        if (limit->low <= border && border <= limit->high) limit->low = limit->high = border;
      right = place_in_words(*limit, number);
    }
  for (const Deciding& number : deciding) {
    const auto got = limit_of(answers, number, word, &AnsweredWord::got);
    if (!got) continue;
    const auto asked = limit_of(answers, number, word, &AnsweredWord::asked);
    if (asked && asked->is_above == got->is_above && asked->low < got->high &&
        got->low < asked->high)
      return {};
    std::string text =
        fmt::format(" The word `{}` is answered {}", word, place_in_words(*got, number));
    if (!right.empty()) text += fmt::format("; it is right {}", right);
    return text + '.';
  }
  return {};
}

}  // namespace

std::vector<Diagnosis> diagnose_words(const std::string& function,
                                      const std::vector<TestCase>& cases,
                                      const Conversation& conversation,
                                      const std::set<const TestCase*>& with_wrong_numbers) {
  if (!is_operating_point(function)) return {};
  std::map<std::string, std::vector<AnsweredWord>> fields;
  std::map<std::string, std::string> quantities;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Reply& answer = conversation.answers[i];
    if (cases[i].function != function || answer.outcome != Outcome::answered ||
        with_wrong_numbers.contains(&cases[i]))
      continue;
    std::optional<Numbers> point;  // it is solved once
    for (const Expected& expected : cases[i].expected) {
      const auto value = answer.fields.find(expected.field);
      if (expected.word.empty() || value == answer.fields.end() || !value->is_string()) continue;
      if (!point) point = right_numbers(question_of(cases[i]));
      fields[expected.field].push_back({expected.word, value->get<std::string>(), *point});
      quantities[expected.field] = expected.quantity;
    }
  }
  std::vector<Diagnosis> found;
  for (const auto& [field, answers] : fields) {
    std::set<std::string> words;  // of wrong answers
    std::size_t wrong = 0;
    for (const AnsweredWord& one : answers) {
      if (one.asked == one.got) continue;
      ++wrong;
      words.insert({one.asked, one.got});
    }
    std::string text;
    for (const std::string& word : words) text += told(answers, word);
    if (text.empty()) continue;
    const std::string quantity = quantities[field];
    found.push_back({quantity,
                     {function},
                     {},
                     0,
                     wrong,
                     fmt::format("{} is another word in {} of {} cases.{}", quantity, wrong,
                                 answers.size(), text),
                     text});
  }
  return found;
}

}  // namespace tribo::conformance
