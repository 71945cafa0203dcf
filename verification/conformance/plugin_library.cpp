// SPDX-License-Identifier: Apache-2.0
#include "conformance/plugin_library.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <string_view>

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

// One line of text: it becomes part of the names in tables.
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

}  // namespace tribo::conformance
