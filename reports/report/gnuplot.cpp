// SPDX-License-Identifier: Apache-2.0
#include "report/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace tribo::report {
namespace {

std::string reason(int code) { return std::generic_category().message(code); }

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

  // All that comes until the other side closes; of much, the last few kilobytes.
  std::string read_to_end() const {
    std::string text;
    std::array<char, 4096> block{};
    while (true) {
      const ssize_t count = ::read(ends_[0], block.data(), block.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return text;
      text.append(block.data(), static_cast<std::size_t>(count));
      if (text.size() > block.size()) text.erase(0, text.size() - block.size());
    }
  }

 private:
  void close(std::size_t end) {
    if (ends_[end] >= 0) ::close(ends_[end]);
    ends_[end] = -1;
  }
  std::array<int, 2> ends_{-1, -1};
};

// No input, no output, and what it says into the pipe.
class Redirections {
 public:
  explicit Redirections(int errors_to) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, errors_to, STDERR_FILENO);
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

// The end of what gnuplot said, on one line: it repeats the whole command before the reason.
std::string reason_in(const std::string& said) {
  constexpr std::size_t longest = 300;
  std::string line;
  for (const char sign : said) {
    const bool blank = sign == '\n' || sign == '\t' || sign == ' ';
    if (!blank)
      line += sign;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  if (line.size() <= longest) return line;
  const std::size_t word = line.find(' ', line.size() - longest);
  return "…" + line.substr(word == std::string::npos ? line.size() - longest : word);
}

GnuplotRun end_of(int status, const std::string& said) {
  if (status != -1 && WIFEXITED(status) && WEXITSTATUS(status) == 0) return {GnuplotEnd::drawn, {}};
  if (status != -1 && WIFSIGNALED(status))
    return {GnuplotEnd::failed, fmt::format("gnuplot ended by signal {}", WTERMSIG(status))};
  return {GnuplotEnd::failed, "gnuplot: " + reason_in(said)};
}

}  // namespace

GnuplotRun run_gnuplot(const std::filesystem::path& script,
                       const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"gnuplot", "-d", "-c", script.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  Pipe errors;
  if (!errors.is_open()) return {GnuplotEnd::failed, "gnuplot: no pipe: " + reason(errno)};
  const Redirections redirections(errors.writing_end());
  pid_t child = 0;
  const int code =
      ::posix_spawnp(&child, "gnuplot", redirections.get(), nullptr, argv.data(), environ);
  errors.close_writing_end();
  if (code == ENOENT || code == EACCES || code == ENOTDIR)
    return {GnuplotEnd::not_found, "gnuplot was not found in PATH"};
  if (code != 0) return {GnuplotEnd::failed, "gnuplot cannot be started: " + reason(code)};
  const std::string said = errors.read_to_end();
  return end_of(wait_for(child), said);
}

}  // namespace tribo::report
