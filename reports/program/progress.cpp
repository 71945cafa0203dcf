// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "messages.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::cli {
namespace {

std::string span_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 100 * 60) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

// Is stderr a file, or anything else that is read later?
bool is_log() {
  struct stat status {};
  return ::fstat(STDERR_FILENO, &status) != 0 ||
         !(S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode));
}

}  // namespace

StepLine::StepLine(std::chrono::milliseconds first, std::chrono::milliseconds between)
    : watched_(::isatty(STDERR_FILENO) != 0), between_(between), next_(Clock::now() + first) {}

void StepLine::show(std::string_view step) {
  if (!is_due()) return;
  next_ = Clock::now() + between_;
  shown_ = true;
  const std::string line = fmt::format("\r{}\033[K", printable(step, std::string::npos));
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void StepLine::wipe() {
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

Progress::Progress(std::size_t total, const ProgressStyle& style)
    : style_(style),
      total_(total),
      watched_(style.results_come_at_end || ::isatty(STDOUT_FILENO) == 0) {}

void Progress::show() {
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  line_.show(fmt::format("{} of {} {}, {:.0f} %, {:.3g} a second", done_, total_, style_.what,
                         100 * static_cast<double>(done_) / static_cast<double>(total_),
                         static_cast<double>(done_) / seconds));
}

void Forecast::step() {
  constexpr double waited = 3, long_time = 10;  // s
  constexpr std::size_t enough = 20;            // answers
  if (is_told_) return;
  if (++done_ == 1) first_ = Clock::now();
  if (done_ < enough) return;
  const double seconds = std::chrono::duration<double>(Clock::now() - first_).count();
  if (seconds < waited) return;
  is_told_ = true;
  const double all = seconds / static_cast<double>(done_ - 1) * static_cast<double>(total_);
  if (all > long_time)
    complain(fmt::format("the {} cases will take some {}{}", total_, span_text(all), advice_));
}

bool SweepProgress::is_due() {
  if (line_.is_watched()) return line_.is_due();
  if (Clock::now() < next_logged_ || !is_log()) return false;
  next_logged_ = Clock::now() + std::chrono::minutes(1);
  return true;
}

void SweepProgress::show(const sweep::RunProgress& progress) {
  if (progress.chunks == 0) return;
  const Clock::time_point now = Clock::now();
  if (progress.phase != phase_) {
    phase_ = progress.phase;
    start_ = now;
  }
  if (!is_due()) return;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const auto done = static_cast<double>(progress.done), all = static_cast<double>(progress.chunks);
  const bool computing = phase_ == sweep::RunProgress::Phase::computing;
  std::string line =
      fmt::format("{} {:.1f} %", computing ? "computed" : "written", 100 * done / all);
  if (computing)
    line += fmt::format(", {:.3g} of {:.3g} points, {:.3g} a second", done * points_a_chunk_,
                        all * points_a_chunk_, done * points_a_chunk_ / seconds);
  if (done > 0) line += ", " + span_text(seconds * (all - done) / done) + " left";
  if (line_.is_watched())
    line_.show(line);
  else
    complain(line);
}

}  // namespace tribo::cli
