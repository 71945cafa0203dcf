// SPDX-License-Identifier: Apache-2.0
// The chunks that are still to be computed. Any thread may ask.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

namespace tribo::sweep {

class ChunkQueue {
 public:
  explicit ChunkQueue(std::vector<std::uint64_t> pending) : pending_(std::move(pending)) {}

  // The next chunks, at most `most`; none where all chunks are taken, or after stop().
  std::vector<std::uint64_t> take(std::size_t most) {
    const std::lock_guard lock(mutex_);
    const std::size_t some = stopped_ ? 0 : std::min(most, pending_.size() - next_);
    const auto first = pending_.begin() + static_cast<std::ptrdiff_t>(next_);
    next_ += some;
    return {first, first + static_cast<std::ptrdiff_t>(some)};
  }
  std::size_t left() const {
    const std::lock_guard lock(mutex_);
    return pending_.size() - next_;
  }
  void stop() {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::uint64_t> pending_;
  std::size_t next_ = 0;
  bool stopped_ = false;
};

}  // namespace tribo::sweep
