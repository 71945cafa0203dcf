// SPDX-License-Identifier: Apache-2.0
#include "sweep_progress.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "messages.hpp"

namespace tribo::cli {
namespace {

constexpr auto first_line = std::chrono::seconds(1);
constexpr auto between_lines = std::chrono::milliseconds(200);
constexpr auto between_logged = std::chrono::minutes(1);

std::string span_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 100 * 60) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

SweepProgress::SweepProgress(double points_a_chunk) : points_a_chunk_(points_a_chunk) {
  next_ = start_ + (kind_ == Kind::log ? Clock::duration(between_logged) : first_line);
}

SweepProgress::Kind SweepProgress::kind_of_stderr() {
  if (::isatty(STDERR_FILENO) != 0) return Kind::terminal;
  struct stat status {};
  const bool known = ::fstat(STDERR_FILENO, &status) == 0;
  const bool is_pipe = known && (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode));
  return is_pipe ? Kind::pipe : Kind::log;
}

void SweepProgress::show(const sweep::RunProgress& progress) {
  if (kind_ == Kind::pipe || progress.chunks == 0) return;
  const Clock::time_point now = Clock::now();
  if (progress.phase != phase_) {
    phase_ = progress.phase;
    start_ = now;
  }
  if (now < next_) return;
  next_ = now + (kind_ == Kind::log ? Clock::duration(between_logged) : between_lines);
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const auto done = static_cast<double>(progress.done), all = static_cast<double>(progress.chunks);
  const bool computing = phase_ == sweep::RunProgress::Phase::computing;
  std::string line =
      fmt::format("{} {:.1f} %", computing ? "computed" : "written", 100 * done / all);
  if (computing)
    line += fmt::format(", {:.3g} of {:.3g} points, {:.3g} a second", done * points_a_chunk_,
                        all * points_a_chunk_, done * points_a_chunk_ / seconds);
  if (done > 0) line += ", " + span_text(seconds * (all - done) / done) + " left";
  if (kind_ == Kind::log) return complain(line);
  shown_ = true;
  std::fputs(("\r" + line + "\033[K").c_str(), stderr);
}

void SweepProgress::wipe() {
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

}  // namespace tribo::cli
