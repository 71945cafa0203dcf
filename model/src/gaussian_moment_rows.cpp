// SPDX-License-Identifier: Apache-2.0
#include "gaussian_moment_rows.hpp"

namespace tribo {
namespace {

#include "gaussian_moment_rows.inc"

}  // namespace

const double* vector_rows(Order n) { return rows[twice(n)][0][0]; }

}  // namespace tribo
