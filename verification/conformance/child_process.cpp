// SPDX-License-Identifier: Apache-2.0
#include "conformance/child_process.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

namespace tribo::conformance {
namespace {

constexpr int cannot_start = 127;  // exit code, as a shell's
constexpr int milliseconds_to_end = 2000;

// --- In the program's process, until it becomes the program.

void lead(int from, int to, int mode) {
  ::dup2(from >= 0 ? from : ::open("/dev/null", mode | O_CLOEXEC), to);
}

[[noreturn]] void become(char* const* command, const ChildStreams& streams, const sigset_t& mask,
                         int failure) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // if somebody kills the guard
  lead(streams.input, STDIN_FILENO, O_RDONLY);
  lead(streams.output, STDOUT_FILENO, O_WRONLY);
  lead(streams.errors, STDERR_FILENO, O_WRONLY);
  std::signal(SIGPIPE, SIG_DFL);  // ignored here, but other programs expect the default
  ::pthread_sigmask(SIG_SETMASK, &mask, nullptr);
  ::execvp(command[0], command);
  const int error = errno;
  [[maybe_unused]] const ssize_t written = ::write(failure, &error, sizeof error);
  ::_exit(cannot_start);
}

// --- In the guard, which has one thread and never returns.

// The parent that a line of /proc/<pid>/stat names: 7 in "12 (a name) S 7 …".
pid_t parent_of(const char* pid) {
  std::array<char, 512> text{};
  const int file = ::open((std::string("/proc/") + pid + "/stat").c_str(), O_RDONLY | O_CLOEXEC);
  const ssize_t count = file < 0 ? 0 : ::read(file, text.data(), text.size());
  if (file >= 0) ::close(file);
  const std::string_view read(text.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  const std::size_t name_end = read.rfind(')');
  pid_t parent = -1;
  if (name_end != std::string_view::npos && name_end + 4 < read.size())
    std::from_chars(read.data() + name_end + 4, read.data() + read.size(), parent);
  return parent;
}

void kill_children() {
  DIR* const processes = ::opendir("/proc");
  if (processes == nullptr) return;
  while (const dirent* const one = ::readdir(processes))
    if (one->d_name[0] >= '1' && one->d_name[0] <= '9' && parent_of(one->d_name) == ::getpid())
      ::kill(static_cast<pid_t>(std::stol(one->d_name)), SIGKILL);
  ::closedir(processes);
}

// When a process dies, its children become the guard's. So the guard kills its children again and
// again, until it has none.
void end_all(pid_t program) {
  for (int i = 0; i < milliseconds_to_end; ++i) {
    pid_t ended = 0;
    do ended = ::waitpid(-1, nullptr, WNOHANG);
    while (ended > 0);
    if (ended < 0) return;
    ::kill(-program, SIGKILL);
    kill_children();
    ::usleep(1000);
  }
}

// The guard ends as the program ended, so that the guard's status tells the program's.
[[noreturn]] void end_as(int status) {
  if (WIFSIGNALED(status)) {
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    std::signal(WTERMSIG(status), SIG_DFL);
    sigset_t one;
    ::sigemptyset(&one);
    ::sigaddset(&one, WTERMSIG(status));
    ::raise(WTERMSIG(status));
    ::pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
  }
  ::_exit(WEXITSTATUS(status));
}

// The signals that the guard waits for; all are blocked. Signals that this process was told to
// ignore, as by nohup, are ignored by the guard too.
sigset_t awaited_signals() {
  sigset_t awaited;
  ::sigemptyset(&awaited);
  for (const int usual : {SIGCHLD, SIGTERM}) {
    std::signal(usual, SIG_DFL);
    ::sigaddset(&awaited, usual);
  }
  for (const int other : {SIGINT, SIGHUP, SIGQUIT}) {
    struct sigaction set {};
    ::sigaction(other, nullptr, &set);
    if (set.sa_handler != SIG_IGN) ::sigaddset(&awaited, other);
  }
  return awaited;
}

[[noreturn]] void guard(pid_t owner, char* const* command, const ChildStreams& streams,
                        const sigset_t& mask, int failure) {
  const sigset_t awaited = awaited_signals();
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != owner) ::_exit(0);
  const pid_t program = ::fork();
  if (program == 0) become(command, streams, mask, failure);
  if (program < 0) {
    const int error = errno;
    [[maybe_unused]] const ssize_t written = ::write(failure, &error, sizeof error);
    ::_exit(cannot_start);
  }
  ::setpgid(program, program);
  ::closefrom(0);  // no pipe may stay open here when the program or its starter ends
  while (true) {
    const int came = ::sigwaitinfo(&awaited, nullptr);
    if (came < 0) continue;
    int status = 0;
    pid_t ended = 0;
    do ended = ::waitpid(-1, &status, WNOHANG);
    while (ended > 0 && ended != program);
    if (came == SIGCHLD && ended != program) continue;
    end_all(program);
    if (ended == program) end_as(status);
    ::_exit(0);
  }
}

// --- Pipes.

constexpr std::size_t kept_errors = 16384;

struct Ends {
  int reading = -1, writing = -1;
};
Ends make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "no pipe");
  return {ends[0], ends[1]};
}

void close_end(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

void close_ends(Ends& pipe) {
  close_end(pipe.reading);
  close_end(pipe.writing);
}

// Appends what can be read now to `to`. Closes the pipe at its end or at an error.
void read_more(int& descriptor, std::string& to) {
  std::array<char, 65536> block{};
  const ssize_t count = ::read(descriptor, block.data(), block.size());
  if (count > 0)
    to.append(block.data(), static_cast<std::size_t>(count));
  else if (count == 0 || (errno != EAGAIN && errno != EINTR))
    close_end(descriptor);
}

void never_wait(int descriptor) {
  if (descriptor >= 0) ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) | O_NONBLOCK);
}

}  // namespace

GuardedChild::GuardedChild(std::vector<std::string> command, const ChildStreams& streams) {
  std::vector<char*> words;
  words.reserve(command.size() + 1);
  for (std::string& word : command) words.push_back(word.data());
  words.push_back(nullptr);
  const auto refuse = [&](int error) {
    throw std::system_error(error, std::generic_category(), command[0] + " cannot be started");
  };
  std::array<int, 2> failure{};  // a pipe that brings an errno if the start fails
  if (::pipe2(failure.data(), O_CLOEXEC) != 0) refuse(errno);
  sigset_t all, mask;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &mask);  // no handler of ours may run in the guard
  const pid_t self = ::getpid();
  guard_ = ::fork();
  if (guard_ == 0) guard(self, words.data(), streams, mask, failure[1]);
  int error = errno;
  ::pthread_sigmask(SIG_SETMASK, &mask, nullptr);
  ::close(failure[1]);
  ssize_t count = 0;
  if (guard_ > 0) {
    do count = ::read(failure[0], &error, sizeof error);
    while (count < 0 && errno == EINTR);
  }
  ::close(failure[0]);
  if (guard_ > 0 && count <= 0) return;
  end();
  refuse(error);
}

// An ended guard stays a zombie until end(), so that no other process gets its process id.
bool GuardedChild::ended(int options) {
  if (has_ended_ || guard_ < 0) return true;
  siginfo_t info{};
  if (::waitid(P_PID, static_cast<id_t>(guard_), &info, WEXITED | WNOWAIT | options) != 0 ||
      info.si_pid != guard_)
    return false;
  has_ended_ = true;
  exited_ = info.si_code == CLD_EXITED;
  status_ = info.si_status;
  return true;
}

void GuardedChild::wait() {
  while (!ended(0) && errno == EINTR) {
  }
}

void GuardedChild::end() {
  if (guard_ < 0) return;
  has_ended();
  ::kill(guard_, SIGTERM);
  rusage used{};  // by the guard and by all children that it has waited for
  for (int i = 0; ::wait4(guard_, nullptr, WNOHANG, &used) == 0; ++i) {
    if (i == milliseconds_to_end + 1000) ::kill(guard_, SIGKILL);  // the guard itself was stopped
    ::usleep(1000);
  }
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  cpu_seconds_ = seconds(used.ru_utime) + seconds(used.ru_stime);
  guard_ = -1;
}

// --- The program's lines.

ChildProcess::ChildProcess(std::vector<std::string> command, Pipes pipes) {
  Ends in, out, err;
  ChildStreams streams{-1, -1, STDERR_FILENO};
  try {
    out = make_pipe();
    streams.output = out.writing;
    if (pipes == Pipes::all) {
      in = make_pipe();
      err = make_pipe();
      streams = {in.reading, out.writing, err.writing};
    }
    child_.emplace(std::move(command), streams);
  } catch (const std::system_error&) {
    for (Ends* const one : {&in, &out, &err}) close_ends(*one);
    throw;
  }
  for (int* const one : {&in.reading, &out.writing, &err.writing}) close_end(*one);
  input_ = in.writing;
  output_ = out.reading;
  error_ = err.reading;
  for (const int descriptor : {input_, output_, error_}) never_wait(descriptor);
}

ChildProcess::~ChildProcess() {
  kill();
  close_end(input_);
  close_end(output_);
  close_end(error_);
}

void ChildProcess::send(std::string_view line) {
  if (refuses_input_ || input_ < 0) return;
  to_write_ += line;
  to_write_ += '\n';
}

std::size_t ChildProcess::unread() const {
  int in_pipe = 0;
  if (input_ >= 0) ::ioctl(input_, FIONREAD, &in_pipe);
  return to_write_.size() + static_cast<std::size_t>(in_pipe);
}

std::size_t ChildProcess::lines_at_hand() const {
  return static_cast<std::size_t>(std::count(received_.begin(), received_.end(), '\n'));
}

void ChildProcess::close_input() {
  close_when_written_ = true;
  if (to_write_.empty()) close_end(input_);
}

void ChildProcess::refuse_input() {
  refuses_input_ = true;
  to_write_.clear();
  close_end(input_);
}

void ChildProcess::write_input() {
  const ssize_t count = ::write(input_, to_write_.data(), to_write_.size());
  if (count > 0)
    to_write_.erase(0, static_cast<std::size_t>(count));
  else if (count < 0 && errno != EAGAIN && errno != EINTR)
    refuse_input();
  if (to_write_.empty() && close_when_written_) close_end(input_);
}

void ChildProcess::read_errors() {
  read_more(error_, errors_);
  if (errors_.size() > kept_errors) errors_.erase(0, errors_.size() - kept_errors);
}

void ChildProcess::pump(int milliseconds) {
  std::array<pollfd, 3> wanted{{{output_, POLLIN, 0},
                                {error_, POLLIN, 0},
                                {input_, static_cast<short>(to_write_.empty() ? 0 : POLLOUT), 0}}};
  if (::poll(wanted.data(), wanted.size(), milliseconds) <= 0) return;
  if (wanted[0].revents != 0) read_more(output_, received_);
  if (wanted[1].revents != 0) read_errors();
  if ((wanted[2].revents & POLLERR) != 0)
    refuse_input();  // nobody reads it any more
  else if (wanted[2].revents != 0)
    write_input();
}

bool ChildProcess::take_line(std::string& line) {
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

ChildProcess::Event ChildProcess::next_line(std::string& line, Time longest) {
  const std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::now() + longest;
  while (true) {
    if (take_line(line)) return line.size() > longest_line ? Event::too_long_line : Event::line;
    if (received_.size() > longest_line) return Event::too_long_line;
    if (output_ < 0) return Event::end_of_output;
    // Once the child has ended, the output that is there is read without waiting for more.
    const bool was_gone = has_ended();
    const auto left = std::chrono::ceil<Time>(deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0 && !was_gone) return Event::nothing;
    const std::size_t before = received_.size();
    pump(was_gone ? 0 : static_cast<int>(std::min<long long>(left.count(), 50)));
    if (was_gone && output_ >= 0 && received_.size() == before) close_end(output_);
  }
}

std::optional<std::string> ChildProcess::rest_of_output(Time limit) {
  const auto deadline = std::chrono::steady_clock::now() + limit;
  while (output_ >= 0 || !has_ended()) {
    if (limit.count() > 0 && std::chrono::steady_clock::now() >= deadline) return std::nullopt;
    if (output_ >= 0)
      pump(50);
    else
      ::usleep(1000);
  }
  return std::exchange(received_, {});
}

void ChildProcess::kill() {
  child_->end();
  if (error_ >= 0) read_errors();
}

std::string ChildProcess::end_text() {
  if (!has_ended()) return "is still running";
  const auto killed_by = [](int signal) {
    const char* const name = ::sigabbrev_np(signal);  // without "SIG"; null: it has no name
    return fmt::format("is killed by signal {} ({}{})", signal,
                       name == nullptr ? "" : fmt::format("SIG{}, ", name), ::strsignal(signal));
  };
  if (child_->signal() != 0) return killed_by(child_->signal());
  // A shell whose command is killed by a signal exits with 128 and the signal's number.
  const int code = exit_code(), told = code - 128;
  if (told > 0 && ::sigabbrev_np(told) != nullptr)
    return fmt::format("{}, as its exit code {} says", killed_by(told), code);
  return fmt::format("exits with code {}", code);
}

// --- A program to its end.

ChildEnd run_child(std::vector<std::string> command, ChildProcess::Time limit) {
  ChildEnd end;
  try {
    ChildProcess child(std::move(command), ChildProcess::Pipes::output);
    std::optional<std::string> text = child.rest_of_output(limit);
    end.is_late = !text;
    if (end.is_late) child.kill();
    if (text) end.text = std::move(*text);
    end.exit_code = child.exit_code();
    end.signal = child.signal();
  } catch (const std::system_error& error) {
    end.start_error = error.code().value();
  }
  return end;
}

}  // namespace tribo::conformance
