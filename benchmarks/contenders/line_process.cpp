// SPDX-License-Identifier: Apache-2.0
#include "contenders/line_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace tribo::benchmarks {

LineProcess::LineProcess(const std::vector<std::string>& command) {
  std::array<int, 2> input{};
  std::array<int, 2> output{};
  if (::pipe2(input.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  if (::pipe2(output.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  posix_spawn_file_actions_t actions{};
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, input[0], STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
  ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<std::string> words = command;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const int code = ::posix_spawnp(&child_, argv[0], &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(input[0]);
  ::close(output[1]);
  to_ = ::fdopen(input[1], "w");
  from_ = ::fdopen(output[0], "r");
  if (code != 0) child_ = -1;
}

LineProcess::~LineProcess() {
  std::fclose(to_);
  std::fclose(from_);
  if (child_ > 0) ::waitpid(child_, nullptr, 0);
}

void LineProcess::write_line(const std::string& line) {
  if (std::fputs((line + "\n").c_str(), to_) < 0 || std::fflush(to_) != 0)
    throw std::runtime_error("the process has gone");
}

std::string LineProcess::read_line() {
  char* text = nullptr;
  std::size_t room = 0;
  const ssize_t length = ::getline(&text, &room, from_);
  const std::string line = length > 0 ? std::string(text, static_cast<std::size_t>(length)) : "";
  std::free(text);
  if (line.empty()) throw std::runtime_error("the process has gone");
  return line;
}

}  // namespace tribo::benchmarks
