// SPDX-License-Identifier: Apache-2.0
// Work on several threads, or on fewer where the system does not allow so many.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace tribo {

// The number of threads that `threads` asks for; 0 asks for as many as this process may run on.
inline int thread_count(int threads) {
  return threads > 0 ? threads
                     : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

// Calls work() on `count` threads at once, the calling one among them, and waits for all. Returns
// the number of threads: where the system starts fewer, these do all the work. Throws the first
// exception of any of them.
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
    } catch (const std::system_error&) {  // by `ulimit -u`, or the limit of a container
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
