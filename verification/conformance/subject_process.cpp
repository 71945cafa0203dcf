// SPDX-License-Identifier: Apache-2.0
#include "conformance/subject_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <system_error>

namespace tribo::conformance {
namespace {

constexpr std::size_t kept_errors = 16384;

struct Ends {
  int reading, writing;
};
Ends make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::runtime_error("no pipe: " + std::generic_category().message(errno));
  return {ends[0], ends[1]};
}

void close_end(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

void never_wait(int descriptor) {
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) | O_NONBLOCK);
}

// A group of its own, and the signals as a program expects them: this one ignores SIGPIPE.
class SpawnAttributes {
 public:
  SpawnAttributes() {
    ::posix_spawnattr_init(&attributes_);
    sigset_t usual;
    ::sigemptyset(&usual);
    ::sigaddset(&usual, SIGPIPE);
    ::posix_spawnattr_setsigdefault(&attributes_, &usual);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  }
  SpawnAttributes(const SpawnAttributes&) = delete;
  SpawnAttributes& operator=(const SpawnAttributes&) = delete;
  ~SpawnAttributes() { ::posix_spawnattr_destroy(&attributes_); }
  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

}  // namespace

SubjectProcess::SubjectProcess(const std::string& command) {
  Ends in = make_pipe(), out = make_pipe(), err = make_pipe();
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, in.reading, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, out.writing, STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, err.writing, STDERR_FILENO);
  std::string shell = "/bin/sh", option = "-c", text = command;
  const std::array<char*, 4> argv{shell.data(), option.data(), text.data(), nullptr};
  const SpawnAttributes attributes;
  const int error =
      ::posix_spawn(&child_, shell.c_str(), &actions, attributes.get(), argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  close_end(in.reading);
  close_end(out.writing);
  close_end(err.writing);
  input_ = in.writing;
  output_ = out.reading;
  error_ = err.reading;
  if (error != 0) {
    child_ = -1;
    close_end(input_);
    close_end(output_);
    close_end(error_);
    throw std::runtime_error("/bin/sh cannot be started: " +
                             std::generic_category().message(error));
  }
  for (const int descriptor : {input_, output_, error_}) never_wait(descriptor);
}

SubjectProcess::~SubjectProcess() {
  kill();
  close_end(input_);
  close_end(output_);
  close_end(error_);
}

void SubjectProcess::send(std::string_view line) {
  if (refuses_input_ || input_ < 0) return;
  to_write_ += line;
  to_write_ += '\n';
}

std::size_t SubjectProcess::unread() const {
  int in_pipe = 0;
  if (input_ >= 0) ::ioctl(input_, FIONREAD, &in_pipe);
  return to_write_.size() + static_cast<std::size_t>(in_pipe);
}

std::size_t SubjectProcess::lines_at_hand() const {
  return static_cast<std::size_t>(std::count(received_.begin(), received_.end(), '\n'));
}

void SubjectProcess::close_input() {
  close_when_written_ = true;
  if (to_write_.empty()) close_end(input_);
}

void SubjectProcess::refuse_input() {
  refuses_input_ = true;
  to_write_.clear();
  close_end(input_);
}

void SubjectProcess::write_input() {
  const ssize_t count = ::write(input_, to_write_.data(), to_write_.size());
  if (count > 0)
    to_write_.erase(0, static_cast<std::size_t>(count));
  else if (count < 0 && errno != EAGAIN && errno != EINTR)
    refuse_input();
  if (to_write_.empty() && close_when_written_) close_end(input_);
}

void SubjectProcess::read_output() {
  std::array<char, 65536> block{};
  const ssize_t count = ::read(output_, block.data(), block.size());
  if (count > 0)
    received_.append(block.data(), static_cast<std::size_t>(count));
  else if (count == 0 || (errno != EAGAIN && errno != EINTR))
    close_end(output_);
}

void SubjectProcess::read_errors() {
  std::array<char, 65536> block{};
  const ssize_t count = ::read(error_, block.data(), block.size());
  if (count > 0) {
    errors_.append(block.data(), static_cast<std::size_t>(count));
    if (errors_.size() > kept_errors) errors_.erase(0, errors_.size() - kept_errors);
  } else if (count == 0 || (errno != EAGAIN && errno != EINTR)) {
    close_end(error_);
  }
}

void SubjectProcess::pump(int milliseconds) {
  std::array<pollfd, 3> wanted{{{output_, POLLIN, 0},
                                {error_, POLLIN, 0},
                                {input_, static_cast<short>(to_write_.empty() ? 0 : POLLOUT), 0}}};
  if (::poll(wanted.data(), wanted.size(), milliseconds) <= 0) return;
  if (wanted[0].revents != 0) read_output();
  if (wanted[1].revents != 0) read_errors();
  if ((wanted[2].revents & POLLERR) != 0)
    refuse_input();  // nobody reads it any more
  else if (wanted[2].revents != 0)
    write_input();
}

bool SubjectProcess::take_line(std::string& line) {
  const std::size_t end = received_.find('\n', searched_);
  if (end == std::string::npos) {
    searched_ = received_.size();
    return false;
  }
  line.assign(received_, 0, end);
  if (line.ends_with('\r')) line.pop_back();
  received_.erase(0, end + 1);
  searched_ = 0;
  return true;
}

SubjectProcess::Event SubjectProcess::next_line(std::string& line,
                                                std::chrono::milliseconds longest) {
  const std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::now() + longest;
  while (true) {
    if (take_line(line)) return line.size() > longest_line ? Event::too_long_line : Event::line;
    if (received_.size() > longest_line) return Event::too_long_line;
    if (output_ < 0) return Event::end_of_output;
    // A grandchild may keep the stdout of the ended child open: the output that is there is read,
    // but no more is waited for.
    const bool was_gone = has_ended();
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0 && !was_gone) return Event::nothing;
    const std::size_t before = received_.size();
    pump(was_gone ? 0 : static_cast<int>(std::min<long long>(left.count(), 50)));
    if (was_gone && output_ >= 0 && received_.size() == before) close_end(output_);
  }
}

// The zombie stays until kill(): as long as it is there, no other group gets its number.
bool SubjectProcess::has_ended() {
  if (has_ended_ || child_ < 0) return true;
  siginfo_t info{};
  if (::waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
      info.si_pid != child_)
    return false;
  has_ended_ = true;
  exited_ = info.si_code == CLD_EXITED;
  status_ = info.si_status;
  return true;
}

void SubjectProcess::kill() {
  if (child_ < 0 || is_reaped_) return;
  has_ended();
  ::kill(-child_, SIGKILL);  // what is left of the group, also where the child itself has ended
  int ignored = 0;
  while (::waitpid(child_, &ignored, 0) < 0 && errno == EINTR) {
  }
  is_reaped_ = true;
  if (error_ >= 0) read_errors();
}

int SubjectProcess::exit_code() { return has_ended() && exited_ ? status_ : -1; }

std::string SubjectProcess::end_text() {
  if (!has_ended()) return "is still running";
  if (exited_) return fmt::format("exits with code {}", status_);
  return fmt::format("is killed by signal {} ({})", status_, ::strsignal(status_));
}

}  // namespace tribo::conformance
