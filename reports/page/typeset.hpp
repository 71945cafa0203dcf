// SPDX-License-Identifier: Apache-2.0
// The plain texts of reference/published as markup: σ_s becomes σ~s~, e^−0.73 becomes e^−0.73^.
#pragma once

#include <string>
#include <string_view>

namespace tribo::report {

std::string typeset(std::string_view text);

}  // namespace tribo::report
