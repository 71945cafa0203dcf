// SPDX-License-Identifier: Apache-2.0
// Reads JSON of other origin into a tree: a baseline, an answer, a program's output.
#pragma once

#include <istream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "scene/entries.hpp"

namespace tribo::protocol {

// Returns the text as a tree. Its is_discarded() is true if the text is no JSON. Throws
// std::runtime_error if the text is nested too deep.
template <class Json = nlohmann::json>
Json parse_bounded_json(std::string_view text) {
  if (scene_detail::nests_too_deep(text))
    throw std::runtime_error(std::string(scene_detail::too_deep_text));
  return Json::parse(text, nullptr, false);
}

// The same for the rest of a stream.
template <class Json = nlohmann::json>
Json read_bounded_json(std::istream& stream) {
  return parse_bounded_json<Json>(
      std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()));
}

}  // namespace tribo::protocol
