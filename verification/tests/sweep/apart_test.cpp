// SPDX-License-Identifier: Apache-2.0
// A crash, a hang or too much memory in the child process becomes one line in this process.
#include "sweep/apart.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>
#include <string>

#include "sweep/small_sweep.hpp"

namespace tribo::sweep {
namespace {

TEST(Apart, GivesTheBytesOrTheErrorOfTheChild) {
  const Bytes many(1'000'000, std::byte{7});
  EXPECT_EQ(apart(0, [&] { return many; }), many);
  EXPECT_EQ(apart(0, [] { return Bytes(); }), Bytes());
  EXPECT_EQ(
      error_of([] { apart(0, []() -> Bytes { throw std::runtime_error("no such thing"); }); }),
      "no such thing");
}

TEST(Apart, SaysThatTheChildCrashed) {
  for (const int signal : {SIGKILL, SIGABRT, SIGALRM}) {
    const auto crash = [signal]() -> Bytes {
      std::raise(signal);
      return {};
    };
    EXPECT_EQ(error_of([&] { apart(0, crash); }), "HDF5 crashes when it reads it");
  }
}

TEST(Apart, GoesOnWhenASignalStopsTheParentAlone) {
  const Bytes few(3, std::byte{7});
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto stopped = [&] {
      std::raise(signal);
      return few;
    };
    EXPECT_EQ(apart(0, stopped), few);
  }
}

TEST(Apart, EndsAChildThatDoesNotEnd) {
  const auto never = []() -> Bytes {
    for (volatile bool goes_on = true; goes_on;) {
    }
    return {};
  };
  EXPECT_EQ(error_of([&] { apart(0, never); }).find("reading it does not end"), 0U);
}

}  // namespace
}  // namespace tribo::sweep
