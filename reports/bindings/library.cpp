// SPDX-License-Identifier: Apache-2.0
// libtribocheck.so: the functions of tribocheck.h.
#include <dlfcn.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/columns.hpp"
#include "conformance/given_answers.hpp"
#include "page/texts.hpp"
#include "program/functions_json.hpp"
#include "program/verify_subject.hpp"
#include "scene/units.hpp"
#include "tribo/version.hpp"
#include "tribocheck.h"

#define TRIBOCHECK_EXPORT __attribute__((visibility("default")))

namespace {

using namespace tribo;
using namespace tribo::conformance;
namespace fs = std::filesystem;

static_assert(catalogue::point_done == TRIBOCHECK_DONE);
static_assert(catalogue::point_refused == TRIBOCHECK_FAILED);

// Where a text goes that the caller is told.
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

// Tells the text that `make` gives, with the code that it sets, or why it threw.
template <class Make>
int tell(const Told& told, Make make) noexcept {
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

const catalogue::Function& function_called(const char* name) {
  const catalogue::Function* const function = catalogue::function_named(name);
  if (function == nullptr)
    throw std::invalid_argument("no function is called \"" + std::string(name) + '"');
  return *function;
}

// The nearest folder above this library with certified tables: beside it in a package of Python, in
// share/tribocheck of a prefix, or in the project's sources.
fs::path reference_folder() {
  Dl_info library{};
  if (::dladdr(reinterpret_cast<const void*>(&tribocheck_version), &library) != 0)
    // Debian's loader finds it under /lib, a link to /usr/lib.
    for (fs::path folder = fs::weakly_canonical(library.dli_fname).parent_path();;
         folder = folder.parent_path()) {
      for (const char* const name : {"reference", "share/tribocheck"})
        if (std::error_code none; fs::is_directory(folder / name / "exact", none))
          return folder / name;
      if (folder == folder.parent_path()) break;
    }
  throw std::runtime_error(
      "reference: the certified tables are not found above the library; give their folder");
}

// The members of a request, which are read once each; any other is refused.
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
      Value value = found->template get<Value>();
      all_.erase(found);
      return value;
    } catch (const nlohmann::json::exception&) {
      throw std::invalid_argument(std::string(name) + ": " + start_of(line_of(*found)) +
                                  " is not allowed");
    }
  }

  std::string take_one_of(const char* name, const std::vector<std::string>& allowed) {
    std::string value = take(name, allowed[0]);
    if (std::find(allowed.begin(), allowed.end(), value) != allowed.end()) return value;
    std::string list;
    for (const std::string& one : allowed) list += (list.empty() ? "" : ", ") + one;
    throw std::invalid_argument(std::string(name) + ": \"" + start_of(value) +
                                "\" is not known; allowed: " + list);
  }

  void refuse_others() const {
    if (!all_.empty())
      throw std::invalid_argument("the request has an unknown member " +
                                  start_of(all_.begin().key()));
  }

 private:
  nlohmann::json all_;
};

struct Request {
  explicit Request(const char* text) {
    Members members(text);
    const fs::path given = members.take<std::string>("reference", "");
    const fs::path folder = given.empty() ? reference_folder() : given;
    cases = read_cases({(folder / "exact").string(), (folder / "published").string()},
                       members.take<std::vector<std::string>>("functions", {}));
    by.tolerance = tolerance_of(members.take<std::string>("tolerance", "engineering"), cases);
    by.sample = members.take<std::size_t>("sample", 0);
    by.ways.modulus = members.take_one_of("modulus", {"E*", "E'", "bodies"});
    by.ways.ellipticity = members.take_one_of("ellipticity", {"k", "radii"});
    subject = members.take<std::string>("subject", "the solver");
    format = members.take_one_of("format", {"table", "json", "markdown"});
    members.refuse_others();
    mistakes = (folder / "mistakes.toml").string();
    cases = cases_for(std::move(cases), by.tolerance, by.sample);
  }

  std::vector<TestCase> cases;
  cli::JudgedBy by;
  std::string subject, format, mistakes;
};

std::string verdict_text(const char* request, const char* answers, int& code) {
  Request asked(request);
  Conversation conversation = conversation_of(asked.cases, answers);
  put_back(asked.by.ways, asked.cases, conversation);
  asked.by.mistakes = read_mistakes(asked.mistakes);
  const cli::SubjectVerdict verdict =
      verdict_on(asked.subject, asked.cases, std::move(conversation), asked.by);
  code = failures(verdict).empty() ? TRIBOCHECK_OK : TRIBOCHECK_WRONG;
  protocol::Text text;
  append_verdict(text, verdict, asked.format);
  return {text.data(), text.size()};
}

}  // namespace

TRIBOCHECK_EXPORT const char* tribocheck_version() { return version.data(); }

TRIBOCHECK_EXPORT int tribocheck_describe(char* text, size_t size, size_t* length) {
  return tell({text, size, length}, [](int&) { return cli::functions_document().dump(); });
}

TRIBOCHECK_EXPORT int tribocheck_call(const char* name, size_t count, const double* const* argument,
                                      const size_t* step, double* const* result, int* status) {
  const catalogue::Function* const function = catalogue::function_named(name);
  if (function == nullptr) return 0;
  return catalogue::values_at(*function, count, argument, step, result, status) == 0 ? 1 : 2;
}

TRIBOCHECK_EXPORT int tribocheck_fault(const char* name, const double* arguments, char* text,
                                       size_t size, size_t* length) {
  return tell({text, size, length}, [&](int& code) -> std::string {
    const catalogue::Function& function = function_called(name);
    catalogue::Arguments given{};
    std::copy_n(arguments, function.parameters.size(), given.begin());
    const auto fault = fault_in(function, given);
    if (!fault) return {};
    code = TRIBOCHECK_REFUSED;
    return std::string(fault->parameter) + ": " + fault->message;
  });
}

TRIBOCHECK_EXPORT int tribocheck_number(const char* with_unit, const char* unit, double* number) {
  return tell({nullptr, 0, nullptr}, [&](int& code) {
    const auto decimal = scene_detail::si_decimal(with_unit, unit);
    if (decimal)
      *number = std::stod(*decimal);
    else
      code = TRIBOCHECK_REFUSED;
    return std::string();
  });
}

TRIBOCHECK_EXPORT int tribocheck_cases(const char* request, char* text, size_t size,
                                       size_t* length) {
  return tell({text, size, length}, [&](int&) {
    const Request asked(request);
    return question_lines(asked_by(asked.by.ways, asked.cases));
  });
}

TRIBOCHECK_EXPORT int tribocheck_judge(const char* request, const char* answers, char* text,
                                       size_t size, size_t* length) {
  return tell({text, size, length},
              [&](int& code) { return verdict_text(request, answers, code); });
}
