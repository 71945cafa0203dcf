// SPDX-License-Identifier: Apache-2.0
#include "page/child_process.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <optional>
#include <system_error>
#include <utility>

#include "conformance/guarded_child.hpp"

namespace tribo::report {
namespace {

// What comes until the other side closes.
std::string read_to_end(int from) {
  std::string text;
  std::array<char, 4096> block{};
  while (true) {
    const ssize_t count = ::read(from, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(block.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

ChildEnd run_child(std::vector<std::string> command) {
  ChildEnd end;
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
    end.start_error = errno;
    return end;
  }
  std::optional<conformance::GuardedChild> child;
  try {
    child.emplace(std::move(command), conformance::ChildStreams{-1, pipe[1], STDERR_FILENO});
  } catch (const std::system_error& error) {
    end.start_error = error.code().value();
  }
  ::close(pipe[1]);
  if (child) {
    end.text = read_to_end(pipe[0]);
    child->wait();
    end.exit_code = child->exit_code();
    end.signal = child->signal();
  }
  ::close(pipe[0]);
  return end;
}

}  // namespace tribo::report
