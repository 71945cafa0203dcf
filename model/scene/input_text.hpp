// SPDX-License-Identifier: Apache-2.0
// The whole text of an input: a file or pipe of at most 1 MiB, or standard input.
#pragma once

#include <string>
#include <string_view>

namespace tribo::scene_detail {

// Fills `text`; returns "", or why `text` could not be filled. `what` names what the file should
// hold: "a scene".
std::string read_input_text(const std::string& path, std::string_view what, std::string& text);

// "scenes/rough.toml" → "rough"
std::string stem_of(std::string_view path);

}  // namespace tribo::scene_detail
