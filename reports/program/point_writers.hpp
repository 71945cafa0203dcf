// SPDX-License-Identifier: Apache-2.0
// Operating points as a table for people, or as CSV or JSON for machines, row by row: memory does
// not grow with their number.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "messages.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/scene.hpp"

namespace tribo::cli {

class PointWriter {
 public:
  virtual ~PointWriter() = default;
  // Called once before the points of each scene; `scene` must live until the next call.
  virtual void begin_scene(const Scene& scene) = 0;
  virtual void add(const OperatingPoint<double>& point) = 0;
  virtual void finish() = 0;
};

// format: "table", "csv" or "json". `scenes` are all that will be written: CSV has one header.
std::unique_ptr<PointWriter> make_point_writer(std::string_view format, OutputStream& output,
                                               const std::vector<Scene>& scenes);

}  // namespace tribo::cli
