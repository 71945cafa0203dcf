// SPDX-License-Identifier: Apache-2.0
// Checks that have to hold for any bytes at all. libFuzzer calls them on bytes that it makes up
// (fuzzer.cpp), corpus_replay_test.cpp on the inputs in corpus/.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace tribo::fuzz {

// Says which property does not hold, and of what.
struct PropertyBroken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void require(bool holds, std::string_view property, std::string_view of = "") {
  if (!holds) throw PropertyBroken(std::string(property) + ": " + std::string(of));
}

// The text as a scene, for each use: either one whose every field is in its range, the same after
// it is written as TOML or JSON and read again; or errors that are single lines of printable UTF-8.
void check_toml_scene(std::string_view text);
void check_json_scene(std::string_view text);

// The text as the input of `tribocheck stream`: a line of JSON for each line but blank ones,
// whichever way the bytes arrive, with an error or with outputs that are in their ranges.
void check_stream(std::string_view text);

// The text as a line of a stream: the same scene and the same messages by the reader of any JSON,
// and by the one of ordinary lines if it takes this one.
void check_ordinary_scene(std::string_view line);

// The text as a sweep: one whose cases are in their fields' ranges, or errors as above.
void check_sweep(std::string_view text);

using Check = void (*)(std::string_view);

// The checks of each way in.
inline constexpr Check toml_checks[] = {check_toml_scene, check_sweep};
inline constexpr Check json_checks[] = {check_json_scene, check_ordinary_scene};
inline constexpr Check stream_checks[] = {check_stream};

// Empty where the check holds; else what it throws.
inline std::string broken_property(Check check, std::string_view text) {
  try {
    check(text);
  } catch (const std::exception& broken) {
    return broken.what();
  }
  return {};
}

}  // namespace tribo::fuzz
