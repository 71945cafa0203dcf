// SPDX-License-Identifier: Apache-2.0
#include "conformance/cpu_time.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <sstream>
#include <string>
#include <unordered_map>
#include <vector>

namespace tribo::conformance {
namespace {

struct Process {
  pid_t id = 0, parent = 0;
  double of_ended = 0;  // seconds of its children that it has waited for
};

double seconds_on(clockid_t clock) {
  timespec time{};
  if (::clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The start of a file. Empty if it cannot be read, as when a process has just ended.
std::string content_of(const std::string& path) {
  std::array<char, 1024> text{};
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return {};
  const ssize_t count = ::read(file, text.data(), text.size());
  ::close(file);
  return {text.data(), count > 0 ? static_cast<std::size_t>(count) : 0};
}

// Reads the line of /proc/<id>/stat: "12 (a name) S 7 …". If the process is gone, all members of
// the result are 0.
Process read_process(const std::string& id) {
  const std::string text = content_of("/proc/" + id + "/stat");
  Process found;
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return found;
  std::istringstream fields(text.substr(name_end + 1));
  std::string field;
  for (int number = 3; number <= 17 && fields >> field; ++number) {
    if (number == 4) found.parent = static_cast<pid_t>(std::atol(field.c_str()));
    if (number == 16 || number == 17)
      found.of_ended += std::atof(field.c_str()) / static_cast<double>(::sysconf(_SC_CLK_TCK));
  }
  found.id = static_cast<pid_t>(std::atol(id.c_str()));
  return found;
}

std::vector<Process> all_processes() {
  std::vector<Process> all;
  DIR* const folder = ::opendir("/proc");
  if (folder == nullptr) return all;
  while (const dirent* const one = ::readdir(folder))
    if (one->d_name[0] >= '1' && one->d_name[0] <= '9') all.push_back(read_process(one->d_name));
  ::closedir(folder);
  return all;
}

double seconds_of(const Process& process) {
  clockid_t clock{};
  const bool is_there = ::clock_getcpuclockid(process.id, &clock) == 0;
  return process.of_ended + (is_there ? seconds_on(clock) : 0);
}

void exponentials() {
  static const std::array<double, 1024> arguments = [] {
    std::array<double, 1024> made{};
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = -static_cast<double>(i) / 64;
    return made;
  }();
  double sum = 0;
  for (const double x : arguments) sum += std::exp(x);
  [[maybe_unused]] volatile double kept = sum;
}

void texts() {
  std::unordered_map<std::string, double> numbers;
  std::array<char, 40> text{};
  double x = 0.1, sum = 0;
  for (int i = 0; i < 1024; ++i) {
    x = 3.9 * x * (1 - x);
    std::snprintf(text.data(), text.size(), "%.16e", x);
    numbers[text.data()] = std::strtod(text.data(), nullptr);
    std::snprintf(text.data(), text.size(), "%.1e", x);
    const auto found = numbers.find(text.data());
    sum += found == numbers.end() ? 1 : found->second;
  }
  [[maybe_unused]] volatile double kept = sum;
}

constexpr double units = 1024;  // of work in one pass

}  // namespace

double cpu_seconds_of_tree(pid_t top) {
  const std::vector<Process> all = all_processes();
  double sum = 0;
  std::vector<pid_t> waiting{top};
  while (!waiting.empty()) {
    const pid_t one = waiting.back();
    waiting.pop_back();
    for (const Process& process : all) {
      if (process.id == one) sum += seconds_of(process);
      if (process.id != 0 && process.parent == one) waiting.push_back(process.id);
    }
  }
  return sum;
}

double own_cpu_seconds() { return seconds_on(CLOCK_PROCESS_CPUTIME_ID); }

const char* name_of(Control control) {
  return control == Control::exponentials ? "exponentials/1" : "texts/1";
}

double control_seconds(Control control) {
  const auto pass = control == Control::exponentials ? exponentials : texts;
  constexpr double enough = 2e-3;
  int passes = 0;
  const double start = own_cpu_seconds();
  double spent = 0;
  do {
    pass();
    ++passes;
    spent = own_cpu_seconds() - start;
  } while (spent < enough);
  return spent / (passes * units);
}

}  // namespace tribo::conformance
