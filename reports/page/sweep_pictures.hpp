// SPDX-License-Identifier: Apache-2.0
// Pictures of a sweep's result, drawn by render/sweep_pictures.py, which says which there are.
#pragma once

#include <string>

#include "page/rendering.hpp"
#include "sweep/result_file.hpp"

namespace tribo::report {

// Draws them as SVG and PNG into a folder, with their data beside them; makes the folder if it is
// missing. `source`: the result, from which kept points are read where a picture needs them.
Rendering draw_sweep_pictures(const sweep::SweepResult& result, const sweep::ResultFile& source,
                              const std::string& folder);

}  // namespace tribo::report
