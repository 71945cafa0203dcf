// SPDX-License-Identifier: Apache-2.0
#include "conformance/guarded_child.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <string_view>
#include <system_error>

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
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // should somebody kill the guard
  lead(streams.input, STDIN_FILENO, O_RDONLY);
  lead(streams.output, STDOUT_FILENO, O_WRONLY);
  lead(streams.errors, STDERR_FILENO, O_WRONLY);
  std::signal(SIGPIPE, SIG_DFL);  // this program ignores it, others expect it
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

// The children of who dies become the guard's, which is why it kills until there are none.
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

// As the program ended, so that the guard's end tells of it.
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
  ::closefrom(0);  // who reads or writes a pipe shall notice the program's end, and ours
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

}  // namespace

// --- In this process.

GuardedChild::GuardedChild(std::vector<std::string> command, const ChildStreams& streams) {
  std::vector<char*> words;
  words.reserve(command.size() + 1);
  for (std::string& word : command) words.push_back(word.data());
  words.push_back(nullptr);
  const auto refuse = [&](int error) {
    throw std::system_error(error, std::generic_category(), command[0] + " cannot be started");
  };
  std::array<int, 2> failure{};  // through which an errno comes, or nothing where all is well
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

// The guard stays a zombie until end(): as long as it is one, no other process gets its number.
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
  for (int i = 0; ::waitpid(guard_, nullptr, WNOHANG) == 0; ++i) {
    if (i == milliseconds_to_end + 1000) ::kill(guard_, SIGKILL);  // somebody has stopped it
    ::usleep(1000);
  }
  guard_ = -1;
}

}  // namespace tribo::conformance
