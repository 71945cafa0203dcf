// SPDX-License-Identifier: Apache-2.0
// Work on several threads, or on fewer where the system does not allow so many.
#pragma once

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace tribo {

// The number of threads that `threads` asks for; 0 asks for one on each processor that this process
// may run on, as taskset or a batch system allows.
inline int thread_count(int threads) {
  if (threads > 0) return threads;
  cpu_set_t allowed;
  if (::sched_getaffinity(0, sizeof allowed, &allowed) == 0) return CPU_COUNT(&allowed);
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

// Calls work() once on each of `count` threads, of which the calling one is the first, and waits
// for all. Returns the number of threads, which is smaller where the system starts fewer: they have
// to share all the work. Throws the first exception of any thread.
template <class Work>
int on_threads(int count, const Work& work) {
  std::mutex mutex;
  std::exception_ptr failure;
  const auto guarded = [&] {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (failure == nullptr) failure = std::current_exception();
    }
  };
  int started = 1;
  {
    std::vector<std::jthread> threads;
    threads.reserve(static_cast<std::size_t>(count));
    try {
      for (; started < count; ++started) threads.emplace_back(guarded);
    } catch (const std::system_error&) {  // a limit is reached: `ulimit -u`, or a container's
    }
    guarded();
  }
  if (failure != nullptr) std::rethrow_exception(failure);
  return started;
}

// Calls use(i) for each i below `count`, on at most `threads` threads.
template <class Use>
void each_on_threads(int threads, std::size_t count, const Use& use) {
  std::atomic<std::size_t> next = 0;
  const auto most = static_cast<int>(std::min<std::size_t>(
      static_cast<std::size_t>(thread_count(threads)), std::max<std::size_t>(count, 1)));
  on_threads(most, [&] {
    for (std::size_t i = next++; i < count; i = next++) use(i);
  });
}

}  // namespace tribo
