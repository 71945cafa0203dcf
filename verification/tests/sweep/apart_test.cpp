// SPDX-License-Identifier: Apache-2.0
// A crash, a hang or too much memory in the child process becomes one line in this process.
#include "sweep/apart.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <csignal>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

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

// The child asks for addresses that it does not touch. With a sanitizer, whose shadow takes
// terabytes of addresses, it has no limit.
TEST(Apart, GivesTheChildTwoGigabytesAndNoMore) {
  const auto has_room_for = [](std::size_t bytes) {
    const Bytes answer = apart(0, [bytes] {
      void* const room = ::mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
      return Bytes(room == MAP_FAILED ? 0 : 1);
    });
    return !answer.empty();
  };
  constexpr std::size_t most = std::size_t{2} << 30, little = std::size_t{1} << 20;
  EXPECT_EQ(has_room_for(most - little), true);
  EXPECT_EQ(has_room_for(most + little), has_sanitizer);
}

TEST(Apart, GivesTheChildFourSecondsAndMoreForALargerFile) {
  for (const auto& [file_size, seconds] :
       {std::pair{0U, 4U}, {19'999'999U, 4U}, {20'000'000U, 5U}, {200'000'000U, 14U}}) {
    const Bytes limit = apart(file_size, [] {
      rlimit now{};
      ::getrlimit(RLIMIT_CPU, &now);
      return Bytes(now.rlim_cur);
    });
    EXPECT_EQ(limit.size(), seconds);
  }
}

}  // namespace
}  // namespace tribo::sweep
