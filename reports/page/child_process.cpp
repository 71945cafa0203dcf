// SPDX-License-Identifier: Apache-2.0
#include "page/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>

namespace tribo::report {
namespace {

using Clock = std::chrono::steady_clock;

// The ends of a pipe that a child does not inherit by accident.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) ends_ = {-1, -1};
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close(0);
    close(1);
  }
  bool is_open() const { return ends_[0] >= 0; }
  int writing_end() const { return ends_[1]; }
  void close_writing_end() { close(1); }

  // What comes until the other side closes, or until the deadline: all of it, or the last few
  // kilobytes.
  std::string read_to_end(bool only_last, Clock::time_point deadline) const {
    std::string text;
    std::array<char, 4096> block{};
    while (waits(deadline)) {
      const ssize_t count = ::read(ends_[0], block.data(), block.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return text;
      text.append(block.data(), static_cast<std::size_t>(count));
      if (only_last && text.size() > block.size()) text.erase(0, text.size() - block.size());
    }
    return text;
  }

 private:
  // False: nothing has come before the deadline.
  bool waits(Clock::time_point deadline) const {
    while (true) {
      const auto left =
          std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count() +
          1;
      const auto step = std::clamp<long long>(left, 0, 60'000);
      pollfd wanted{ends_[0], POLLIN, 0};
      if (::poll(&wanted, 1, static_cast<int>(step)) > 0) return true;
      if (left <= step) return false;
    }
  }
  void close(std::size_t end) {
    if (ends_[end] >= 0) ::close(ends_[end]);
    ends_[end] = -1;
  }
  std::array<int, 2> ends_{-1, -1};
};

// The child gets no input, and the stream that is heard is led into the pipe.
class Redirections {
 public:
  Redirections(Heard heard, int pipe) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (heard == Heard::output) {
      ::posix_spawn_file_actions_adddup2(&actions_, pipe, STDOUT_FILENO);
      return;
    }
    ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, pipe, STDERR_FILENO);
  }
  Redirections(const Redirections&) = delete;
  Redirections& operator=(const Redirections&) = delete;
  ~Redirections() { ::posix_spawn_file_actions_destroy(&actions_); }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return -1;
  return status;
}

// The zombie stays for wait_for().
bool has_ended_before(Clock::time_point deadline, pid_t child) {
  while (true) {
    siginfo_t info{};
    const bool is_last = Clock::now() >= deadline;
    if (::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
        info.si_pid == child)
      return true;
    if (is_last) return false;
    ::usleep(1000);
  }
}

}  // namespace

bool ChildEnd::succeeded() const { return exited_with(0); }
bool ChildEnd::exited_with(int code) const {
  return start_error == 0 && !is_late && status != -1 && WIFEXITED(status) &&
         WEXITSTATUS(status) == code;
}
int ChildEnd::signal() const {
  return start_error == 0 && !is_late && status != -1 && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

ChildEnd run_child(std::vector<std::string> command, Heard heard, std::chrono::milliseconds limit) {
  std::vector<char*> argv;
  argv.reserve(command.size() + 1);
  for (std::string& word : command) argv.push_back(word.data());
  argv.push_back(nullptr);

  ChildEnd end;
  Pipe pipe;
  if (!pipe.is_open()) {
    end.start_error = errno;
    return end;
  }
  const Redirections redirections(heard, pipe.writing_end());
  pid_t child = 0;
  end.start_error =
      ::posix_spawnp(&child, argv[0], redirections.get(), nullptr, argv.data(), environ);
  pipe.close_writing_end();
  if (end.start_error != 0) return end;
  const Clock::time_point deadline =
      limit.count() > 0 ? Clock::now() + limit : Clock::time_point::max();
  end.text = pipe.read_to_end(heard == Heard::last_errors, deadline);
  end.is_late = limit.count() > 0 && !has_ended_before(deadline, child);
  if (end.is_late) ::kill(child, SIGKILL);
  end.status = wait_for(child);
  return end;
}

}  // namespace tribo::report
