// SPDX-License-Identifier: Apache-2.0
// Checks that have to hold for any bytes at all. libFuzzer calls them on bytes that it makes up
// (fuzzer.cpp), corpus_replay_test.cpp on the inputs in corpus/.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace tribo::fuzz {

// A property does not hold. what() names the property and the object that lacks it.
struct PropertyBroken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void require(bool holds, std::string_view property, std::string_view of = "") {
  if (!holds) throw PropertyBroken(std::string(property) + ": " + std::string(of));
}

// Reads the text as a scene, for each use. It gives a scene with every field in its range, which is
// equal when written as TOML or JSON and read again; or errors, each one line of printable UTF-8.
void check_toml_scene(std::string_view text);
void check_json_scene(std::string_view text);

// Takes the text as input of `tribocheck stream`, whole and in pieces. Each line that is not blank
// gets one line of JSON as its answer: an error, or outputs in their ranges.
void check_stream(std::string_view text);

// Takes the text as a line of a stream. If the reader of ordinary lines takes the line, its scene
// and messages are those of the reader of any JSON.
void check_ordinary_scene(std::string_view line);

// Reads the text as a sweep: its cases are in their fields' ranges, or it has errors as above.
void check_sweep(std::string_view text);

using Check = void (*)(std::string_view);

// The checks of each kind of input.
inline constexpr Check toml_checks[] = {check_toml_scene, check_sweep};
inline constexpr Check json_checks[] = {check_json_scene, check_ordinary_scene};
inline constexpr Check stream_checks[] = {check_stream};

// The text of the exception that the check throws; empty where it throws none.
inline std::string broken_property(Check check, std::string_view text) {
  try {
    check(text);
  } catch (const std::exception& broken) {
    return broken.what();
  }
  return {};
}

}  // namespace tribo::fuzz
