// SPDX-License-Identifier: Apache-2.0
// One scene, compiled: each output as polynomials in pieces of the speed (proxy_pieces.hpp), for
// when some ten thousand points of it are asked.
#pragma once

#include <array>
#include <span>

#include "tribo/operating_points.hpp"
#include "tribo/proxy_pieces.hpp"

namespace tribo {

// The outputs of a set at speeds in [from, to] m/s, 0 < from < to. Building it solves some thousand
// points for each output. What no piece holds (next to a kink: the collapse, a floor reached), what
// lies outside the range, and a word within 1e-12 of its threshold come from solve(); so do numbers
// whose condition makes more than the bound of solve()'s own last digits, as a share next to a
// floor.
class CompiledScene {
 public:
  // Of each number, relative to what solve() gives, whose own error comes on top.
  static constexpr double error_bound = 1e-14;

  CompiledScene(const MixedContact<double>& contact, OutputSet outputs, double from, double to);

  // Like solve() of operating_points.hpp.
  void solve(std::span<const double> speeds, OperatingPoints& points, std::size_t first = 0) const;

  OutputSet outputs() const { return outputs_; }
  std::size_t piece_count() const;
  // Part of the cells of the range in which a point is left to solve().
  double left_out() const;

 private:
  static constexpr std::size_t number_count = 9;  // outputs that are numbers, the first of all

  void solve_block(std::span<const double> speeds, OperatingPoints& points,
                   std::size_t first) const;

  MixedContact<double> contact_;
  OutputSet outputs_;
  OutputSet compiled_;  // with what the words rest on
  std::array<ProxyPieces, number_count> proxies_;
};

}  // namespace tribo
