// SPDX-License-Identifier: Apache-2.0
// libtribocheck.so: the functions of tribocheck.h except those about scenes (scenes.cpp).
#include <dlfcn.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "catalogue/columns.hpp"
#include "conformance/given_answers.hpp"
#include "page/texts.hpp"
#include "program/functions_json.hpp"
#include "program/verify_subject.hpp"
#include "scene/units.hpp"
#include "telling.hpp"
#include "tribo/version.hpp"
#include "tribocheck.h"

namespace {

using namespace tribo;
using namespace tribo::bindings;
using namespace tribo::conformance;
namespace fs = std::filesystem;

static_assert(catalogue::point_done == TRIBOCHECK_DONE);
static_assert(catalogue::point_refused == TRIBOCHECK_FAILED);

// The function of this name. Null if there is none, or if `name` is null.
const catalogue::Function* function_or_null(const char* name) {
  return name == nullptr ? nullptr : catalogue::function_named(name);
}

const catalogue::Function& function_called(const char* name) {
  const catalogue::Function* const function = function_or_null(name);
  if (function == nullptr)
    throw std::invalid_argument("no function is called \"" +
                                std::string(name == nullptr ? "" : name) + '"');
  return *function;
}

// The nearest folder above this library with certified tables: beside it in a package of Python, in
// share/tribocheck of a prefix, or in the project's sources.
fs::path reference_folder() {
  Dl_info library{};
  if (::dladdr(reinterpret_cast<const void*>(&tribocheck_version), &library) != 0)
    // Debian's loader names the library under /lib, which is a link to /usr/lib.
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

// The mistakes in a file. It is read once, as this takes longer than the rest of a verdict.
std::vector<Mistake> mistakes_of(const std::string& path) {
  static std::mutex mutex;
  static std::map<std::string, std::vector<Mistake>> kept;
  const std::lock_guard lock(mutex);
  const auto found = kept.find(path);
  return found != kept.end() ? found->second
                             : kept.emplace(path, read_mistakes(path)).first->second;
}

std::string verdict_text(const char* request, const char* answers, int& code) {
  Request asked(request);
  Conversation conversation = conversation_of(asked.cases, answers);
  put_back(asked.by.ways, asked.cases, conversation);
  asked.by.mistakes = mistakes_of(asked.mistakes);
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
  const catalogue::Function* const function = function_or_null(name);
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
    const std::string_view text = decimal ? std::string_view(*decimal) : std::string_view();
    if (std::from_chars(text.data(), text.data() + text.size(), *number).ec != std::errc())
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
