// SPDX-License-Identifier: Apache-2.0
// How the functions of tribocheck.h read requests and write texts for the caller. No exception
// leaves tell().
#pragma once

#include <fmt/format.h>
#include <locale.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <exception>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "conformance/conversation.hpp"
#include "tribocheck.h"

#define TRIBOCHECK_EXPORT __attribute__((visibility("default")))

namespace tribo::bindings {

// The caller's memory for a text: `size` bytes at `text`. The whole length of the text goes to
// `length`, which may be null.
struct Told {
  char* text;
  std::size_t size;
  std::size_t* length;

  void write(std::string_view whole) const {
    if (length != nullptr) *length = whole.size();
    if (size == 0) return;
    const std::size_t copied = std::min(whole.size(), size - 1);
    std::memcpy(text, whole.data(), copied);
    text[copied] = '\0';
  }
};

// While it lives, this thread reads and writes numbers with a decimal point, whatever locale the
// host has set.
class DecimalPoint {
 public:
  DecimalPoint()
      : own_(::newlocale(LC_NUMERIC_MASK, "C", ::duplocale(::uselocale(nullptr)))),
        before_(::uselocale(own_)) {}
  DecimalPoint(const DecimalPoint&) = delete;
  DecimalPoint& operator=(const DecimalPoint&) = delete;
  ~DecimalPoint() {
    ::uselocale(before_);
    if (own_ != nullptr) ::freelocale(own_);
  }

 private:
  ::locale_t own_, before_;
};

// Writes the text that make(code) returns, and returns the code that `make` sets, at first
// TRIBOCHECK_OK. Where `make` throws, it writes the reason and returns TRIBOCHECK_REFUSED.
template <class Make>
int tell(const Told& told, Make make) noexcept {
  const DecimalPoint point;
  try {
    int code = TRIBOCHECK_OK;
    told.write(make(code));
    return code;
  } catch (const std::exception& error) {
    told.write(error.what());
  } catch (...) {
    told.write("an unknown fault");
  }
  return TRIBOCHECK_REFUSED;
}

// "speed: -1 is not allowed; allowed: a number above 0, in m/s".
inline std::string refusal(std::string_view name, double number, std::string_view allowed) {
  return fmt::format("{}: {} is not allowed; allowed: {}", name, number, allowed);
}

// The members of a JSON request. Each take function reads one member and removes it;
// refuse_others() then refuses those that are left. All throw std::invalid_argument with one line.
class Members {
 public:
  explicit Members(const char* text) : all_(nlohmann::json::parse(text, nullptr, false)) {
    if (!all_.is_object()) throw std::invalid_argument("the request is no JSON object");
  }

  template <class Value>
  Value take(const char* name, Value otherwise) {
    const auto found = all_.find(name);
    if (found == all_.end()) return otherwise;
    try {
      if (!std::is_same_v<Value, std::size_t> || found->is_number_unsigned()) {
        Value value = found->template get<Value>();
        all_.erase(found);
        return value;
      }
    } catch (const nlohmann::json::exception&) {  // it has another type
    }
    throw std::invalid_argument(fmt::format("{}: {} is not allowed; allowed: {}", name,
                                            conformance::start_of(conformance::line_of(*found)),
                                            kind_of(otherwise)));
  }

  // A number that `is_allowed` takes, or `otherwise` where none is given.
  double take_number(const char* name, double otherwise, bool (*is_allowed)(double),
                     std::string_view allowed) {
    if (!all_.contains(name)) return otherwise;
    const double number = take(name, otherwise);
    if (is_allowed(number)) return number;
    throw std::invalid_argument(refusal(name, number, allowed));
  }

  // One of the allowed words; the first one where the request has no such member. An empty word is
  // left out where an error lists the words.
  std::string take_one_of(const char* name, const std::vector<std::string>& allowed) {
    std::string value = take(name, allowed[0]);
    if (std::find(allowed.begin(), allowed.end(), value) != allowed.end()) return value;
    std::string list;
    for (const std::string& one : allowed)
      if (!one.empty()) list += (list.empty() ? "" : ", ") + one;
    throw std::invalid_argument(std::string(name) + ": \"" + conformance::start_of(value) +
                                "\" is not known; allowed: " + list);
  }

  void refuse_others() const {
    if (!all_.empty())
      throw std::invalid_argument("the request has an unknown member " +
                                  conformance::start_of(all_.begin().key()));
  }

 private:
  static const char* kind_of(const std::string&) { return "a text"; }
  static const char* kind_of(bool) { return "true or false"; }
  static const char* kind_of(double) { return "a number"; }
  static const char* kind_of(std::size_t) { return "0, or a whole number above it"; }
  static const char* kind_of(const std::vector<std::string>&) { return "a list of texts"; }

  nlohmann::json all_;
};

}  // namespace tribo::bindings
