// SPDX-License-Identifier: Apache-2.0
// All readings, each judged by every item. Readings share the stages of the computation: a root is
// found once for each film formula and rough contact, an inlet once for each film, friction once
// for each law of the rest, and so on. No stage is computed twice from the same choices.
#pragma once

#include <cstdint>
#include <vector>

#include "reproduction/evaluation.hpp"

namespace tribo::reproduction {

// Bit i: item i (or claim i) is reproduced.
using ItemMask = std::uint32_t;

struct Enumeration {
  std::vector<ItemMask> items;   // of every reading, by index_of()
  std::vector<ItemMask> claims;  // likewise
  std::size_t films;             // how many of each stage were computed
  std::size_t inlets;
  std::size_t friction_curves;
  // For every reading the items that the grid of speeds left open, and that were therefore computed
  // between its speeds as well; and those whose margin is below the numerical error even so.
  std::vector<ItemMask> refined;
  std::vector<ItemMask> undecided;
};

Enumeration enumerate(const PaperScenes& scenes, const std::vector<Item>& items);

// Bits of the claims of which all items are set, in the order of claim_names().
ItemMask claims_of(ItemMask items_reproduced, const std::vector<Item>& items);

}  // namespace tribo::reproduction
