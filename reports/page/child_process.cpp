// SPDX-License-Identifier: Apache-2.0
#include "page/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <system_error>
#include <utility>

#include "conformance/guarded_child.hpp"

namespace tribo::report {
namespace {

using Clock = std::chrono::steady_clock;

// Waits until something can be read. False: nothing has come before the deadline.
bool waits(int from, Clock::time_point deadline) {
  while (true) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count() + 1;
    const auto step = std::clamp<long long>(left, 0, 60'000);
    pollfd wanted{from, POLLIN, 0};
    if (::poll(&wanted, 1, static_cast<int>(step)) > 0) return true;
    if (left <= step) return false;
  }
}

// Adds what comes until the other side closes. False: it has not closed before the deadline.
bool read_to_end(int from, Clock::time_point deadline, std::string& text) {
  std::array<char, 4096> block{};
  while (waits(from, deadline)) {
    const ssize_t count = ::read(from, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return true;
    text.append(block.data(), static_cast<std::size_t>(count));
  }
  return false;
}

}  // namespace

ChildEnd run_child(std::vector<std::string> command, std::chrono::milliseconds limit, int input) {
  ChildEnd end;
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
    end.start_error = errno;
    return end;
  }
  std::optional<conformance::GuardedChild> child;
  try {
    child.emplace(std::move(command), conformance::ChildStreams{input, pipe[1], STDERR_FILENO});
  } catch (const std::system_error& error) {
    end.start_error = error.code().value();
  }
  ::close(pipe[1]);
  if (child) {
    const Clock::time_point deadline =
        limit.count() > 0 ? Clock::now() + limit : Clock::time_point::max();
    end.is_late = !read_to_end(pipe[0], deadline, end.text);
    while (!end.is_late && limit.count() > 0 && !child->has_ended()) {
      end.is_late = Clock::now() >= deadline;
      ::usleep(1000);
    }
    if (end.is_late)
      child->end();
    else
      child->wait();
    end.exit_code = child->exit_code();
    end.signal = child->signal();
  }
  ::close(pipe[0]);
  return end;
}

}  // namespace tribo::report
