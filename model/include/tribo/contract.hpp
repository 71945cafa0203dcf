// SPDX-License-Identifier: Apache-2.0
// The bound that a function promises for the error of its value in double. The error is the
// difference from the exact value at the same inputs:
//
//   |error| ≤ max(ulp · ulp(value), ulp_per_condition · condition · ulp(value)),
//
// where `condition` is the sum of |∂ ln value/∂ ln input| over the inputs, at least 1. Each
// contract stands beside its function, and the verification reads it there.
#pragma once

namespace tribo {

struct Contract {
  double ulp;
  double ulp_per_condition;  // 0: the bound does not depend on the condition
};

}  // namespace tribo
