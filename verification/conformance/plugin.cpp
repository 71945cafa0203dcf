// SPDX-License-Identifier: Apache-2.0
#include "conformance/plugin.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/plugin_scene.hpp"

namespace tribo::conformance {
namespace {

namespace fs = std::filesystem;

void* open_library(const std::string& path) {
  const std::string file = fs::absolute(path).string();
  void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library != nullptr) return library;
  std::string reason = ::dlerror();
  if (reason.starts_with(file + ": ")) reason.erase(0, file.size() + 2);
  throw PluginRefused(path + ": cannot be loaded: " + reason);
}

// Null where the library has no such function.
template <class Function>
void find(void* library, const char* name, Function*& function) {
  function = reinterpret_cast<Function*>(::dlsym(library, name));
}

std::string stem_of(const std::string& path) {
  std::string stem = fs::path(path).stem().string();
  if (stem.starts_with("lib") && stem.size() > 3) stem.erase(0, 3);
  return stem;
}

// At most 60 bytes, without control characters and slashes, for names in tables.
std::string cleaned(std::string_view text) {
  std::string result;
  for (const char c : text.substr(0, 60)) {
    const auto code = static_cast<unsigned char>(c);
    result += code < 0x20 || code == 0x7F || c == '/' ? ' ' : c;
  }
  return result;
}

void check_version(void* library, const std::string& path) {
  decltype(&tribocheck_plugin_version) version = nullptr;
  find(library, "tribocheck_plugin_version", version);
  if (version == nullptr) throw PluginRefused(path + ": exports no tribocheck_plugin_version()");
  const int found = version();
  if (found == TRIBOCHECK_PLUGIN_VERSION) return;
  throw PluginRefused(path + ": made for version " + std::to_string(found) +
                      " of tribocheck_plugin.h; this program knows version " +
                      std::to_string(TRIBOCHECK_PLUGIN_VERSION));
}

std::string name_of(void* library, const std::string& path) {
  decltype(&tribocheck_plugin_name) name = nullptr;
  find(library, "tribocheck_plugin_name", name);
  const char* const given = name == nullptr ? nullptr : name();
  return cleaned(given == nullptr || *given == '\0' ? stem_of(path) : std::string(given));
}

constexpr int unset = -1;  // a status that the plug-in has not written

template <class Result>
Answer<Result> answer_of(int status, Result result) {
  switch (status) {
    case TRIBOCHECK_DONE:
      return result;
    case TRIBOCHECK_NOT_OFFERED:
      return skip("the plug-in does not offer this case");
    case TRIBOCHECK_UNDEFINED:
      return undefined("the plug-in says that there is none");
    case TRIBOCHECK_FAILED:
      return failed("the plug-in says that it failed");
    case unset:
      return failed("the plug-in wrote no status");
    default:
      return failed("the plug-in wrote the status " + std::to_string(status) +
                    ", which means nothing");
  }
}

template <class Result>
void set_places(std::span<Answer<Result>> answers) {
  for (std::size_t i = 0; i < answers.size(); ++i) {
    answers[i].place = i + 1;
    answers[i].of = answers.size();
  }
}

// A function of the catalogue, by its name.
FunctionBatch function_batch(decltype(&tribocheck_function) function,
                             const catalogue::Function& asked) {
  return [function, &asked](std::span<const catalogue::Arguments> cases,
                            std::span<Answer<catalogue::Results>> answers) {
    const std::size_t count = cases.size();
    std::vector<std::vector<double>> arguments, results;
    std::vector<const double*> argument_columns;
    std::vector<double*> result_columns;
    for (std::size_t k = 0; k < asked.parameters.size(); ++k) {
      arguments.emplace_back(count);
      for (std::size_t i = 0; i < count; ++i) arguments[k][i] = cases[i][k];
      argument_columns.push_back(arguments[k].data());
    }
    for (std::size_t k = 0; k < asked.results.size(); ++k)
      result_columns.push_back(results.emplace_back(count, not_offered).data());
    std::vector<int> status(count, unset);
    // The names of the catalogue are literals: they end with 0.
    if (function(asked.name.data(), count, argument_columns.data(), result_columns.data(),
                 status.data()) == 0) {
      std::fill(answers.begin(), answers.end(), skip("no " + std::string(asked.name)));
      return;
    }
    for (std::size_t i = 0; i < count; ++i) {
      catalogue::Results found{};
      for (std::size_t k = 0; k < results.size(); ++k) found[k] = results[k][i];
      answers[i] = answer_of(status[i], found);
    }
    set_places(answers);
  };
}

// Reads a code as the place of a word. False: the code means nothing.
template <class Word>
bool read_word(int code, std::span<const std::string_view> words, WordResult<Word>& to) {
  using Kind = typename WordResult<Word>::Kind;
  if (code == TRIBOCHECK_NO_CODE) return true;
  if (code == TRIBOCHECK_UNDEFINED_CODE) {
    to.kind = Kind::undefined;
    return true;
  }
  if (code < 0 || code >= static_cast<int>(words.size())) return false;
  to = static_cast<Word>(code);
  return true;
}

Answer<PointResult> point_answer(int status, const tribocheck_point& point) {
  PointResult result;
  for (std::size_t i = 0; i < number_count; ++i) result.numbers[i] = point.*plugin_numbers[i];
  const bool codes_are_known = read_word(point.regime, regime_words, result.regime) &&
                               read_word(point.inlet, inlet_words, result.inlet);
  if (status == TRIBOCHECK_DONE && !codes_are_known)
    return failed("the plug-in wrote a code of regime or inlet that means nothing");
  return answer_of(status, result);
}

// The bytes of a scene, by which scenes with NaN can be equal.
auto bytes_of(const tribocheck_scene& scene) {
  static_assert(sizeof(tribocheck_scene) == 15 * sizeof(double) + 6 * sizeof(int), "no padding");
  return std::bit_cast<std::array<std::byte, sizeof(tribocheck_scene)>>(scene);
}

// Adjacent questions with the same scene go to the plug-in together.
Batch<Scene, PointResult> operating_point(decltype(&tribocheck_operating_point) function) {
  if (function == nullptr) return {};
  return [=](std::span<const Scene> scenes, std::span<Answer<PointResult>> answers) {
    std::vector<double> speeds;
    for (std::size_t first = 0; first < scenes.size(); first += speeds.size()) {
      speeds.clear();
      // The plug-in's header has only circles with the default film law.
      const auto is_of_header = [](const Scene& scene) {
        return scene.closures.film == FilmFormula::hamrock_dowson_central &&
               scene.bodies.shape() == ContactShape::circle;
      };
      if (!is_of_header(scenes[first])) {
        speeds.push_back(scenes[first].speeds[0]);
        answers[first] = point_answer(TRIBOCHECK_NOT_OFFERED, empty_point());
        continue;
      }
      const tribocheck_scene scene = plugin_scene(scenes[first]);
      for (std::size_t i = first; i < scenes.size(); ++i) {
        if (!is_of_header(scenes[i]) || bytes_of(plugin_scene(scenes[i])) != bytes_of(scene)) break;
        speeds.push_back(scenes[i].speeds[0]);
      }
      std::vector<tribocheck_point> points(speeds.size(), empty_point());
      std::vector<int> status(speeds.size(), unset);
      function(&scene, speeds.size(), speeds.data(), points.data(), status.data());
      for (std::size_t i = 0; i < points.size(); ++i)
        answers[first + i] = point_answer(status[i], points[i]);
      set_places(answers.subspan(first, points.size()));
    }
  };
}

}  // namespace

Plugin load_plugin(const std::string& path) {
  void* const library = open_library(path);
  check_version(library, path);
  Plugin plugin;
  plugin.name = name_of(library, path);
  PluginFunctions& functions = plugin.functions;
  find(library, "tribocheck_function", functions.function);
  find(library, "tribocheck_operating_point", functions.operating_point);
  return plugin;
}

Solver plugin_solver(const PluginFunctions& functions) {
  Solver solver;
  if (functions.function != nullptr)
    for (const catalogue::Function& function : catalogue::functions())
      solver.offer_batch(function.name, function_batch(functions.function, function));
  solver.operating_point = operating_point(functions.operating_point);
  return solver;
}

int host_plugin(const std::string& path, bool tells_places) {
  const int answers = take_stdout();
  const Plugin plugin = load_plugin(path);
  return serve(plugin_solver(plugin.functions), answers, tells_places);
}

}  // namespace tribo::conformance
