// SPDX-License-Identifier: Apache-2.0
#include "page/sweep_picture_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "page/sweep_values.hpp"

namespace tribo::report::sweep_picture {
namespace {

constexpr std::array<std::uint32_t, 8> okabe_ito{0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7,
                                                 0xE69F00, 0x56B4E9, 0x8C6D00, 0x000000};

// As colour() of style.gp.
std::optional<std::uint32_t> colour_of_surface(const std::string& id) {
  return id == "rough"    ? std::optional(0xD55E00U)
         : id == "medium" ? std::optional(0x009E73U)
         : id == "smooth" ? std::optional(0x0072B2U)
                          : std::nullopt;
}

}  // namespace

std::vector<std::uint32_t> colours(const sweep::SweepResult& result) {
  std::vector<std::uint32_t> free(okabe_ito.begin(), okabe_ito.end());
  for (const sweep::SceneResult& scene : result.scenes)
    if (const auto own = colour_of_surface(scene.id))
      free.erase(std::remove(free.begin(), free.end(), *own), free.end());
  std::vector<std::uint32_t> list;
  std::size_t next = 0;
  for (const sweep::SceneResult& scene : result.scenes) {
    const auto own = colour_of_surface(scene.id);
    list.push_back(own ? *own : free[next++ % free.size()]);
  }
  return list;
}

std::uint32_t pale(std::uint32_t colour) {
  std::uint32_t mixed = 0;
  for (const int shift : {16, 8, 0}) {
    const std::uint32_t part = (colour >> shift) & 0xFFU;
    mixed |= (part + (0xFFU - part) * 11 / 20) << shift;
  }
  return mixed;
}

std::string cell(std::string_view text, std::size_t longest) {
  std::string kept;
  std::size_t signs = 0;
  for (const char byte : text) {
    const auto code = static_cast<unsigned char>(byte);
    const bool begins = (code & 0xC0U) != 0x80U;
    if (begins && ++signs > longest) return kept + "…";
    kept += code < 0x20 || code == 0x7F ? ' ' : byte == '"' ? '\'' : byte;
  }
  // gnuplot takes an empty cell for that of the row before.
  return kept.find_first_not_of(' ') == std::string::npos ? "–" : kept;
}

std::string plain_words(std::string_view text) {
  constexpr std::string_view signs = "\\_^{}@&~";
  std::string words;
  for (const char sign : text) {
    if (signs.find(sign) != std::string_view::npos) words += '\\';
    words += sign;
  }
  return words;
}

std::string in_words(std::string_view name) {
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string column_words(std::string_view column) {
  const auto [onset, quantity] = split_name(column);
  if (onset.empty()) return in_words(column);
  const std::string criterion = in_words(split_name(onset).second);
  if (quantity == "speed") return fmt::format("onset speed ({})", criterion);
  return fmt::format("{} at the onset ({})", in_words(quantity), criterion);
}

std::string with_capital(std::string words) {
  if (!words.empty() && words.front() >= 'a' && words.front() <= 'z')
    words.front() = static_cast<char>(words.front() - 'a' + 'A');
  return words;
}

Range with_room(Range range, double part) {
  const double factor = range.high > range.low ? std::pow(range.high / range.low, part) : 1.1;
  return {range.low / factor, range.high * factor};
}

SweepPicture make(const std::string& stem, const std::string& script, std::string heading,
                  std::string caption, std::string alternative, std::string subtitle, int height,
                  std::string blocks) {
  const std::string path = fmt::format("{}/{}.blocks.tsv", data_folder, stem);
  std::string title = plain_words(heading);
  return {{stem,
           {},
           std::move(heading),
           std::move(caption),
           std::move(alternative),
           {path},
           {"sweep.gp", script, data_folder, stem, std::move(title), std::move(subtitle), height}},
          {path, std::move(blocks)}};
}

}  // namespace tribo::report::sweep_picture
