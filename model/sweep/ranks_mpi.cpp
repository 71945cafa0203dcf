// SPDX-License-Identifier: Apache-2.0
// Many processes, with MPI. A rank that has no chunks left asks rank 0 with one message of three
// numbers, and gets a list of chunks: as many as it computes in a quarter of a second, but no more
// than an equal share of half of the chunks that are left (at least one). At the end the rank says
// that it leaves.
#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include "sweep/mpirun.hpp"
#include "sweep/ranks.hpp"
#include "sweep/worker_thread.hpp"

namespace tribo::sweep {
namespace {

constexpr int request_tag = 1, answer_tag = 2;
constexpr std::size_t most_handed_out = 4096;
constexpr auto lease = std::chrono::milliseconds(250);

enum Leaving : std::uint64_t { stays, leaves, leaves_failed };
struct Request {
  std::uint64_t wanted = 1;
  std::uint64_t computed = 0;  // since the last request
  std::uint64_t leaving = stays;
};
static_assert(sizeof(Request) == 3 * sizeof(std::uint64_t));

// MPI's own waiting keeps a core busy, which another rank may need.
void wait_for(MPI_Request request) {
  int done = 0;
  for (MPI_Test(&request, &done, MPI_STATUS_IGNORE); done == 0;
       MPI_Test(&request, &done, MPI_STATUS_IGNORE))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

// The chunks of a rank that is not the first. All threads of a rank ask one after the other, so
// that MPI sees one thread at a time.
class Lease {
 public:
  std::optional<std::uint64_t> next() {
    const std::lock_guard lock(mutex_);
    if (next_ == chunks_.size()) renew();
    if (next_ == chunks_.size()) return std::nullopt;
    return chunks_[next_++];
  }
  void leave(bool failed) {
    const std::lock_guard lock(mutex_);
    send({0, chunks_.size(), failed ? leaves_failed : leaves});
  }
  void stop() { stopped_ = true; }

 private:
  using Clock = std::chrono::steady_clock;

  void renew() {
    const std::uint64_t computed = chunks_.size();
    chunks_.clear();
    next_ = 0;
    if (stopped_ || ended_) return;
    const double seconds = std::chrono::duration<double>(Clock::now() - since_).count();
    const double rate = static_cast<double>(computed) / std::max(seconds, 1e-6);
    const double wanted = rate * std::chrono::duration<double>(lease).count();
    send({static_cast<std::uint64_t>(std::clamp(wanted, 1.0, double{most_handed_out})), computed,
          stays});
    chunks_.resize(most_handed_out);
    MPI_Status status;
    MPI_Recv(chunks_.data(), static_cast<int>(most_handed_out), MPI_UINT64_T, 0, answer_tag,
             MPI_COMM_WORLD, &status);
    int count = 0;
    MPI_Get_count(&status, MPI_UINT64_T, &count);
    chunks_.resize(static_cast<std::size_t>(count));
    ended_ = chunks_.empty();
    since_ = Clock::now();
  }

  static void send(const Request& request) {
    MPI_Send(&request, 3, MPI_UINT64_T, 0, request_tag, MPI_COMM_WORLD);
  }

  std::mutex mutex_;
  std::vector<std::uint64_t> chunks_;
  std::size_t next_ = 0;
  Clock::time_point since_ = Clock::now();
  std::atomic<bool> stopped_ = false;
  bool ended_ = false;
};

// Rank 0 answers the others.
class Dispatcher {
 public:
  Dispatcher(ChunkQueue& queue, int ranks) : queue_(queue), ranks_(ranks), here_(ranks - 1) {}

  bool all_left() const { return here_ == 0; }
  bool any_failed() const { return failed_; }
  std::uint64_t computed() const { return computed_; }

  // Answers whoever is waiting; false: nobody was.
  bool answer_some() {
    int waiting = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, request_tag, MPI_COMM_WORLD, &waiting, &status);
    if (waiting == 0) return false;
    Request request;
    MPI_Recv(&request, 3, MPI_UINT64_T, status.MPI_SOURCE, request_tag, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    computed_ += request.computed;
    if (request.leaving == stays) {
      const std::size_t share =
          std::max<std::size_t>(1, queue_.left() / (2 * static_cast<std::size_t>(ranks_)));
      const auto chunks = queue_.take(std::min<std::size_t>(request.wanted, share));
      MPI_Send(chunks.data(), static_cast<int>(chunks.size()), MPI_UINT64_T, status.MPI_SOURCE,
               answer_tag, MPI_COMM_WORLD);
    } else {
      --here_;
      if (request.leaving == leaves_failed) {
        failed_ = true;
        queue_.stop();
      }
    }
    return true;
  }

 private:
  ChunkQueue& queue_;
  int ranks_;
  int here_;
  bool failed_ = false;
  std::uint64_t computed_ = 0;
};

}  // namespace

Ranks::Ranks() {
  if (!started_by_mpi()) return;
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

bool Ranks::has_mpi() { return true; }

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

bool Ranks::share(ChunkQueue& queue, const std::function<void(const NextChunk&)>& compute,
                  const std::function<void(std::uint64_t)>& tick,
                  const std::function<bool()>& stopped) const {
  if (count_ == 1) {
    share_alone(queue, compute, tick, stopped);
    return true;
  }
  bool good = true;
  if (rank_ == 0) {
    Dispatcher dispatcher(queue, count_);
    WorkerThread worker([&] {
      try {
        compute(chunks_of(queue));
      } catch (...) {
        queue.stop();  // the others need not go on
        throw;
      }
    });
    bool computing = true;
    auto next_tick = std::chrono::steady_clock::now();
    while (computing || !dispatcher.all_left()) {
      while (dispatcher.answer_some()) {
      }
      computing = computing && !worker.wait(std::chrono::microseconds(computing ? 200 : 0));
      if (!computing) std::this_thread::sleep_for(std::chrono::microseconds(200));
      if (stopped()) queue.stop();
      if (std::chrono::steady_clock::now() < next_tick) continue;
      next_tick = std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
      tick(dispatcher.computed());
    }
    good = !dispatcher.any_failed();
    worker.rethrow();
    return good;
  }
  Lease chunks;
  WorkerThread worker([&] { compute([&chunks] { return chunks.next(); }); });
  while (!worker.wait()) {
    if (stopped()) chunks.stop();
    tick(0);
  }
  try {
    worker.rethrow();
  } catch (...) {
    chunks.leave(true);
    throw;
  }
  chunks.leave(false);
  return good;
}

}  // namespace tribo::sweep
