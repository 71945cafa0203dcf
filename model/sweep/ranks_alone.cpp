// SPDX-License-Identifier: Apache-2.0
// One process, without MPI.
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "sweep/ranks.hpp"

namespace tribo::sweep {

Ranks::Ranks() {
  if (ranks_by_mpirun() > 1)
    throw std::invalid_argument(
        "mpirun started " + std::to_string(ranks_by_mpirun()) +
        " ranks, but this tribocheck was built without MPI; use --shard, or "
        "build it where libopenmpi-dev is installed");
}
Ranks::~Ranks() = default;

std::string Ranks::from_first(std::string text) const { return text; }
bool Ranks::everywhere(bool mine) const { return mine; }
void Ranks::end_all() const { std::_Exit(1); }

}  // namespace tribo::sweep
