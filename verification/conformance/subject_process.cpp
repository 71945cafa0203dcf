// SPDX-License-Identifier: Apache-2.0
#include "conformance/subject_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <vector>

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

}  // namespace

SubjectProcess::SubjectProcess(const std::string& command) {
  Ends in = make_pipe(), out = make_pipe(), err = make_pipe();
  input_ = in.writing;
  output_ = out.reading;
  error_ = err.reading;
  try {
    child_.emplace(std::vector<std::string>{"/bin/sh", "-c", command},
                   ChildStreams{in.reading, out.writing, err.writing});
  } catch (const std::system_error&) {
    for (int* const one : {&in.reading, &out.writing, &err.writing, &input_, &output_, &error_})
      close_end(*one);
    throw;
  }
  for (int* const one : {&in.reading, &out.writing, &err.writing}) close_end(*one);
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
    // Once it has ended, the output that is there is read, but no more is waited for.
    const bool was_gone = has_ended();
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0 && !was_gone) return Event::nothing;
    const std::size_t before = received_.size();
    pump(was_gone ? 0 : static_cast<int>(std::min<long long>(left.count(), 50)));
    if (was_gone && output_ >= 0 && received_.size() == before) close_end(output_);
  }
}

void SubjectProcess::kill() {
  child_->end();
  if (error_ >= 0) read_errors();
}

std::string SubjectProcess::end_text() {
  if (!has_ended()) return "is still running";
  const int signal = child_->signal();
  if (signal == 0) return fmt::format("exits with code {}", exit_code());
  return fmt::format("is killed by signal {} ({})", signal, ::strsignal(signal));
}

}  // namespace tribo::conformance
