// SPDX-License-Identifier: Apache-2.0
#include "scene/toml_screen.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include "scene/text.hpp"

namespace tribo::scene_detail {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_word_sign(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '+' ||
         c == '-' || c == '.';
}

bool ends_value(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ',' || c == ']' || c == '}' ||
         c == '#';
}

// A decimal number of TOML's grammar, without its underscores, in its parts.
struct Decimal {
  std::string text;  // sign (− only), digits, '.', digits, 'e', exponent
  std::string whole, fraction, exponent;
  bool negative = false;
  bool integer = true;
};

class DecimalReader {
 public:
  explicit DecimalReader(std::string_view word) : word_(word) {}

  std::optional<Decimal> read() {
    Decimal number;
    if (at('+') || at('-')) number.negative = word_[place_++] == '-';
    if (!digits(number.whole) || (number.whole.size() > 1 && number.whole[0] == '0'))
      return std::nullopt;
    number.text = (number.negative ? "-" : "") + number.whole;
    if (at('.')) {
      ++place_;
      number.integer = false;
      if (!digits(number.fraction)) return std::nullopt;
      number.text += '.' + number.fraction;
    }
    if (at('e') || at('E')) {
      ++place_;
      number.integer = false;
      if (at('-')) number.exponent = "-";
      if (at('+') || at('-')) ++place_;
      if (!digits(number.exponent)) return std::nullopt;
      number.text += 'e' + number.exponent;
    }
    if (place_ != word_.size()) return std::nullopt;
    return number;
  }

 private:
  bool at(char c) const { return place_ < word_.size() && word_[place_] == c; }

  // One digit or more; single underscores may stand between them.
  bool digits(std::string& into) {
    bool after_digit = false;
    while (place_ < word_.size() && (is_digit(word_[place_]) || (after_digit && at('_')))) {
      after_digit = is_digit(word_[place_]);
      if (after_digit) into += word_[place_];
      ++place_;
    }
    return after_digit;
  }

  std::string_view word_;
  std::size_t place_ = 0;
};

// Is a number beyond the range of double too large rather than too small?
bool is_large(const Decimal& number) {
  long exponent = 0;
  const char* const end = number.exponent.data() + number.exponent.size();
  if (std::from_chars(number.exponent.data(), end, exponent).ec == std::errc::result_out_of_range)
    return number.exponent[0] != '-';
  if (number.whole != "0") return exponent + static_cast<long>(number.whole.size()) > 0;
  const std::size_t zeros =
      std::min(number.fraction.find_first_not_of('0'), number.fraction.size());
  return exponent - static_cast<long>(zeros) > 0;
}

bool is_zero(const Decimal& number) {
  return number.whole == "0" && number.fraction.find_first_not_of('0') == std::string::npos;
}

// The value of a number that toml++ refuses or, with some libraries, reads as 0 or ∞; else nothing.
std::optional<Value> wide_value(std::string_view word) {
  constexpr std::size_t longest = 100;      // toml++ takes up to 127 signs
  constexpr std::size_t safe_integer = 18;  // digits that surely fit int64
  const std::optional<Decimal> number = DecimalReader(word).read();
  if (!number) return std::nullopt;
  Value value{.kind = ValueKind::number, .text = {}};
  const char* const end = number->text.data() + number->text.size();
  const std::errc fault = std::from_chars(number->text.data(), end, value.number).ec;
  const bool vanished = value.number == 0 && !is_zero(*number);
  if (fault != std::errc() || !std::isfinite(value.number) || vanished) {
    value.fault = is_large(*number) ? NumberFault::overflow : NumberFault::underflow;
    value.text = word;
    return value;
  }
  if (word.size() > longest || (number->integer && number->whole.size() > safe_integer))
    return value;
  return std::nullopt;
}

class Screener {
 public:
  Screener(std::string& text, std::size_t most_fields) : text_(text), most_fields_(most_fields) {}

  TomlScreen run() {
    while (at_ < text_.size() && screen_.complaint.empty()) {
      const char c = text_[at_];
      if (c == '#')
        skip_comment();
      else if (c == '"' || c == '\'')
        skip_string(c);
      else
        pass_sign(c);
    }
    return std::move(screen_);
  }

 private:
  void complain(std::string text) {
    screen_.complaint = std::move(text);
    screen_.row = row_;
    screen_.column = column_;
  }

  // Goes on by one character, which outside of strings and comments is ASCII.
  void step() {
    const std::size_t length = utf8_length(text_, at_);
    const char c = text_[at_];
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    if (length == 0) return complain("not UTF-8: " + printable(text_.substr(at_, 1)));
    if (control && c != '\t' && c != '\n' && c != '\r')
      return complain("control character " + printable(text_.substr(at_, 1)));
    at_ += length;
    ++column_;
    if (c == '\n') {
      ++row_;
      column_ = 1;
    }
  }

  bool going() const { return at_ < text_.size() && screen_.complaint.empty(); }
  bool at(std::string_view what) const { return text_.compare(at_, what.size(), what) == 0; }

  void skip_comment() {
    while (going() && text_[at_] != '\n') step();
  }

  void skip_string(char quote) {
    line_start_ = false;
    value_expected_ = false;
    const std::string three(3, quote);
    if (at(three)) return skip_long_string(quote, three);
    step();
    while (going() && text_[at_] != quote && text_[at_] != '\n') step_in_string(quote);
    if (going() && text_[at_] == quote) step();
  }

  // The end of a long string may have two quotes before it that belong to the string.
  void skip_long_string(char quote, const std::string& three) {
    for (int i = 0; i < 3; ++i) step();
    while (going() && !at(three)) step_in_string(quote);
    for (int i = 0; i < 5 && going() && text_[at_] == quote; ++i) step();
  }

  void step_in_string(char quote) {
    const bool escape = quote == '"' && text_[at_] == '\\';
    step();
    if (escape && going() && text_[at_] != '\n') step();
  }

  void pass_sign(char c) {
    if (static_cast<unsigned char>(c) >= 0x80)
      return complain(
          "non-ASCII sign outside of strings and comments; a number with a unit stands in quotes, "
          "as "
          "\"10 µm\"");
    if (is_word_sign(c)) return pass_word();
    const bool header = line_start_ && open_.empty() && c == '[';
    if (c != ' ' && c != '\t' && c != '\n' && c != '\r') line_start_ = false;
    if (header)
      start_header();
    else if (!in_header_ || c == '\n')
      pass_structure(c);
    if (screen_.complaint.empty()) step();
  }

  void pass_structure(char c) {
    switch (c) {
      case '\n':
        if (open_.empty()) start_line();
        return;
      case '=':
        return expect_value_of_field();
      case ',':
        return expect_next_element();
      case '[':
      case '{':
        return open(c);
      case ']':
      case '}':
        return close();
      default:
        return;
    }
  }

  void start_line() {
    line_start_ = true;
    in_header_ = false;
    value_expected_ = false;
    dots_ = 0;
  }

  void start_header() {
    in_header_ = true;
    std::size_t end = std::min(text_.find('\n', at_), text_.size());
    end = std::min(end, text_.find(']', at_));
    std::string_view name = std::string_view(text_).substr(at_, end - at_);
    while (!name.empty() && (name.front() == '[' || name.front() == ' ')) name.remove_prefix(1);
    while (!name.empty() && name.back() == ' ') name.remove_suffix(1);
    screen_.headers.push_back({row_, name});
    count_field();
  }

  void count_field() {
    if (++fields_ > most_fields_) complain(std::string(too_many_fields_text));
  }

  void expect_value_of_field() {
    value_expected_ = true;
    dots_ = 0;
    count_field();
  }

  void expect_next_element() {
    value_expected_ = !open_.empty() && open_.back() == '[';
    dots_ = 0;
  }

  void open(char c) {
    open_ += c;
    value_expected_ = c == '[';
    dots_ = 0;
    if (open_.size() > max_depth) complain(std::string(too_deep_text));
  }

  void close() {
    if (!open_.empty()) open_.pop_back();
    value_expected_ = false;
  }

  // Passes a word, which has no blanks: a bare key, a number, true …
  void pass_word() {
    line_start_ = false;
    const std::size_t start = at_;
    const std::size_t start_column = column_;
    while (going() && is_word_sign(text_[at_])) {
      if (text_[at_] == '.' && ++dots_ > max_depth) return complain(std::string(too_deep_text));
      step();
    }
    if (!value_expected_) return;
    value_expected_ = false;
    if (at_ < text_.size() && !ends_value(text_[at_])) return;
    mend_number(start, start_column);
  }

  void mend_number(std::size_t start, std::size_t start_column) {
    auto value = wide_value(std::string_view(text_).substr(start, at_ - start));
    if (!value) return;
    screen_.wide_numbers.push_back({row_, start_column, *std::move(value)});
    std::fill(text_.begin() + static_cast<std::ptrdiff_t>(start),
              text_.begin() + static_cast<std::ptrdiff_t>(at_), ' ');
    text_.replace(start, 3, "inf");
  }

  std::string& text_;
  TomlScreen screen_;
  std::size_t at_ = 0, row_ = 1, column_ = 1;
  std::string open_;             // the brackets not yet closed
  bool line_start_ = true;       // only blanks so far in this line
  bool in_header_ = false;       // in a line like [surface]
  bool value_expected_ = false;  // after '=' or in a list
  std::size_t dots_ = 0;         // of the key so far
  std::size_t most_fields_;
  std::size_t fields_ = 0;  // '=' and headers
};

}  // namespace

TomlScreen screen_toml(std::string& text, std::size_t most_fields) {
  return Screener(text, most_fields).run();
}

}  // namespace tribo::scene_detail
