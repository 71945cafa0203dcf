// SPDX-License-Identifier: Apache-2.0
#include "sweep/apart.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

#include "sweep/disk.hpp"

namespace tribo::sweep {
namespace {

constexpr std::uint64_t least_seconds = 4, bytes_a_second = 20'000'000;
constexpr rlim_t more_memory = rlim_t{2} << 30;
constexpr std::byte good{'+'}, bad{'-'};  // the first byte of what a child sends

void limit(int resource, rlim_t most) {
  rlimit now{};
  if (::getrlimit(static_cast<__rlimit_resource_t>(resource), &now) != 0) return;
  now.rlim_cur = std::min(most, now.rlim_max);
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &now);
}

// The size of this process's address space in bytes; 0: not known.
rlim_t memory_in_use() {
  std::FILE* const file = std::fopen("/proc/self/statm", "re");
  if (file == nullptr) return 0;
  unsigned long long pages = 0;
  const bool is_read = std::fscanf(file, "%llu", &pages) == 1;
  std::fclose(file);
  return is_read ? static_cast<rlim_t>(pages) * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

void send(int pipe, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(pipe, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) ::_exit(1);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

[[noreturn]] void run_child(int pipe, pid_t parent, std::uint64_t seconds,
                            const std::function<Bytes()>& work) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, seconds);
  if (const rlim_t now = memory_in_use(); now > 0 && !has_sanitizer)
    limit(RLIMIT_AS, now + more_memory);
  if (!has_sanitizer) {  // a user need not see what a library prints before it aborts
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
  }
  try {
    const Bytes bytes = work();
    send(pipe, std::span(&good, 1));
    send(pipe, bytes);
  } catch (const std::exception& failure) {
    send(pipe, std::span(&bad, 1));
    send(pipe, std::as_bytes(std::span(std::string_view(failure.what()))));
  }
  ::_exit(0);
}

struct Received {
  Bytes bytes;
  bool in_time = true;
};

Received receive(int pipe, std::chrono::steady_clock::time_point end) {
  Received received;
  std::array<std::byte, std::size_t{1} << 16> block;
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        end - std::chrono::steady_clock::now());
    pollfd waited{pipe, POLLIN, 0};
    const int ready = ::poll(&waited, 1, static_cast<int>(std::max<long>(left.count(), 0)));
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0) {
      received.in_time = false;
      return received;
    }
    const ssize_t count = ::read(pipe, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return received;
    received.bytes.insert(received.bytes.end(), block.begin(), block.begin() + count);
  }
}

}  // namespace

Bytes apart(std::uint64_t file_size, const std::function<Bytes()>& work) {
  const std::uint64_t seconds = least_seconds + file_size / bytes_a_second;
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot make a pipe");
  const Descriptor from(ends[0]);
  Descriptor to(ends[1]);
  const pid_t parent = ::getpid(), child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "cannot start a process");
  if (child == 0) run_child(to, parent, seconds, work);
  to = Descriptor();
  Received received =
      receive(from, std::chrono::steady_clock::now() + std::chrono::seconds(2 * seconds));
  if (!received.in_time) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!received.in_time || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU))
    throw std::runtime_error("reading it does not end within " + std::to_string(seconds) +
                             " s of work");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || received.bytes.empty())
    throw std::runtime_error("HDF5 crashes when it reads it");
  const std::span<const std::byte> sent = std::span(received.bytes).subspan(1);
  if (received.bytes.front() == bad)
    throw std::runtime_error(std::string(reinterpret_cast<const char*>(sent.data()), sent.size()));
  received.bytes.erase(received.bytes.begin());
  return std::move(received.bytes);
}

}  // namespace tribo::sweep
