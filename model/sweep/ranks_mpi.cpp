// SPDX-License-Identifier: Apache-2.0
// Many processes, with MPI.
#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>

#include "sweep/ranks.hpp"

namespace tribo::sweep {
namespace {

// Sleeps between tests. MPI_Wait() would keep a core busy that another rank may need.
void wait_for(MPI_Request request) {
  int done = 0;
  for (MPI_Test(&request, &done, MPI_STATUS_IGNORE); done == 0;
       MPI_Test(&request, &done, MPI_STATUS_IGNORE))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace

Ranks::Ranks() {
  // A process that MPI did not start does not initialise MPI, because that takes time.
  const bool is_by_srun = std::getenv("PMIX_RANK") != nullptr;  // srun --mpi=pmix
  if (ranks_by_mpirun() == 0 && !is_by_srun) return;
  int given = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &given);
  if (given < MPI_THREAD_SERIALIZED)
    throw std::runtime_error("this MPI does not allow its use by several threads in turn");
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
  joined_ = true;
}

Ranks::~Ranks() {
  if (!joined_) return;
  everywhere(true);
  MPI_Finalize();
}

std::string Ranks::from_first(std::string text) const {
  if (count_ == 1) return text;
  std::uint64_t size = text.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  text.resize(size);
  MPI_Bcast(text.data(), static_cast<int>(size), MPI_CHAR, 0, MPI_COMM_WORLD);
  return text;
}

bool Ranks::everywhere(bool mine) const {
  if (count_ == 1) return mine;
  int all = mine ? 1 : 0;
  MPI_Request request;
  MPI_Iallreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_LAND, MPI_COMM_WORLD, &request);
  wait_for(request);  // NOLINT(clang-analyzer-optin.mpi.MPI-Checker): it tests until it is done
  return all != 0;
}

void Ranks::end_all() const {
  MPI_Abort(MPI_COMM_WORLD, 1);
  std::_Exit(1);
}

}  // namespace tribo::sweep
