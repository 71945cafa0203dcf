// SPDX-License-Identifier: Apache-2.0
// The thread that computes, beside the one that hands out chunks and shows progress.
#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "sweep/ranks.hpp"

namespace tribo::sweep {

class WorkerThread {
 public:
  // Throws std::runtime_error where the system starts no thread.
  explicit WorkerThread(std::function<void()> work) try
      : done_(std::async(std::launch::async, std::move(work))) {
  } catch (const std::system_error& error) {
    throw std::runtime_error("the system starts no thread (" + error.code().message() +
                             "); allowed: a higher limit of processes, as by ulimit -u");
  }

  // Waits a moment; true once the work has ended.
  bool wait(std::chrono::microseconds moment = std::chrono::milliseconds(50)) {
    return done_.wait_for(moment) == std::future_status::ready;
  }
  // Only after wait() said so.
  void rethrow() { done_.get(); }

 private:
  std::future<void> done_;
};

// One at a time from a queue of this process.
inline NextChunk chunks_of(ChunkQueue& queue) {
  return [&queue]() -> std::optional<std::uint64_t> {
    const auto taken = queue.take(1);
    return taken.empty() ? std::nullopt : std::optional(taken.front());
  };
}

// Ranks::share() of a process that is alone.
inline void share_alone(ChunkQueue& queue, const std::function<void(const NextChunk&)>& compute,
                        const std::function<void(std::uint64_t)>& tick,
                        const std::function<bool()>& stopped) {
  WorkerThread worker([&] { compute(chunks_of(queue)); });
  while (!worker.wait()) {
    if (stopped()) queue.stop();
    tick(0);
  }
  worker.rethrow();
}

}  // namespace tribo::sweep
