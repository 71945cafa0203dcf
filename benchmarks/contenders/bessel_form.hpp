// SPDX-License-Identifier: Apache-2.0
// F_{5/2}(d) = Γ(7/2)/√2π e^{−d²/4} U(3, d), with Weber's U(0, d) and U(1, d) in Bessel functions
// of d²/4 (DLMF 12.7.10 and on) and two steps of the recurrence in its first argument.
#pragma once

namespace tribo::benchmarks {

double bessel_moment(double d);

}  // namespace tribo::benchmarks
