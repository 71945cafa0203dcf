// SPDX-License-Identifier: Apache-2.0
// One process, without MPI.
#include <stdexcept>

#include "sweep/mpirun.hpp"
#include "sweep/ranks.hpp"
#include "sweep/worker_thread.hpp"

namespace tribo::sweep {

Ranks::Ranks() {
  if (ranks_by_mpirun() > 1)
    throw std::invalid_argument(
        "mpirun started " + std::to_string(ranks_by_mpirun()) +
        " ranks, but this tribocheck was built without MPI; use --shard, or "
        "build it where libopenmpi-dev is installed");
}
Ranks::~Ranks() = default;

bool Ranks::has_mpi() { return false; }
std::string Ranks::from_first(std::string text) const { return text; }
bool Ranks::everywhere(bool mine) const { return mine; }

bool Ranks::share(ChunkQueue& queue, const std::function<void(const NextChunk&)>& compute,
                  const std::function<void(std::uint64_t)>& tick,
                  const std::function<bool()>& stopped) const {
  share_alone(queue, compute, tick, stopped);
  return true;
}

}  // namespace tribo::sweep
