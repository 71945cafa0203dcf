// SPDX-License-Identifier: Apache-2.0
// Was this process started by MPI? The variables that the starters of Open MPI and MPICH set tell
// it, so that other processes need not start MPI, which takes time.
#pragma once

#include <cstdlib>

namespace tribo::sweep {

// How many processes mpirun started; 0 if it did not start this one, or does not tell.
inline int ranks_by_mpirun() {
  for (const char* const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* const text = std::getenv(name)) return std::atoi(text);
  return 0;
}

inline bool started_by_mpi() {
  return ranks_by_mpirun() > 0 || std::getenv("PMIX_RANK") != nullptr;  // srun --mpi=pmix
}

}  // namespace tribo::sweep
