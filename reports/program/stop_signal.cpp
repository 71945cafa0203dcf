// SPDX-License-Identifier: Apache-2.0
#include "stop_signal.hpp"

#include <atomic>
#include <csignal>

namespace tribo::cli {
namespace {

std::atomic<int> noted_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void on_stop_signal(int signal) {
  noted_signal = signal;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void watch_for_stop() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, on_stop_signal);
  std::signal(SIGXFSZ, SIG_IGN);
}

void stop_at_once() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
}

int stop_signal() { return noted_signal; }

}  // namespace tribo::cli
