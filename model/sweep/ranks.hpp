// SPDX-License-Identifier: Apache-2.0
// The processes that share a sweep: one, or as many as mpirun started. They share the work by files
// (parts_in_hand.hpp). MPI only passes on what rank 0 has found, and how each rank ended. The class
// is in ranks_mpi.cpp where MPI was found, else in ranks_alone.cpp.
#pragma once

#include <cstdlib>
#include <string>

namespace tribo::sweep {

// The number of processes that mpirun started, from the variables that Open MPI and MPICH set; 0 if
// mpirun did not start this process, or sets none of them.
inline int ranks_by_mpirun() {
  for (const char* const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* const text = std::getenv(name)) return std::atoi(text);
  return 0;
}

class Ranks {
 public:
  // Joins the other processes if mpirun started this process. Throws std::invalid_argument if
  // mpirun started several and this program was built without MPI. A process may have one Ranks at
  // a time. Under MPI it may make only one in all.
  Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  ~Ranks();  // waits for the others

  int rank() const { return rank_; }
  int count() const { return count_; }

  // Rank 0's text, on all ranks.
  std::string from_first(std::string text) const;
  // Is `mine` true on every rank? Waits for all.
  bool everywhere(bool mine) const;
  // Ends the processes of all ranks, where this one has failed and the others would wait for it.
  [[noreturn]] void end_all() const;

 private:
  int rank_ = 0;
  int count_ = 1;
  [[maybe_unused]] bool joined_ = false;  // the destructor has to end MPI
};

}  // namespace tribo::sweep
