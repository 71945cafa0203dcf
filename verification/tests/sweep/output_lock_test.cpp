// SPDX-License-Identifier: Apache-2.0
// Only one process at a time works on an output, even while the lock's file comes and goes.
#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <thread>
#include <vector>

#include "sweep/output_file.hpp"
#include "sweep/small_sweep.hpp"

namespace tribo::sweep {
namespace {

TEST(OutputLock, IsHeldByOneAtATimeAndLeavesNoFile) {
  const TemporaryFolder folder;
  const std::string output = folder.file("out.h5");
  {
    const OutputLock first(output);
    EXPECT_THROW(OutputLock{output}, RunRefused);
    EXPECT_EQ(std::filesystem::exists(output + ".lock"), true);
    EXPECT_NO_THROW(OutputLock{folder.file("other.h5")});
  }
  EXPECT_EQ(std::filesystem::exists(output + ".lock"), false);
  EXPECT_NO_THROW(OutputLock{output});
}

TEST(OutputLock, KnowsThatItsFileWasRemoved) {
  const TemporaryFolder folder;
  const std::string output = folder.file("out.h5");
  std::optional<OutputLock> first(output);
  EXPECT_NO_THROW(first->check());
  std::filesystem::remove(output + ".lock");
  EXPECT_THROW(first->check(), std::runtime_error);
  const OutputLock second(output);
  EXPECT_THROW(first->check(), std::runtime_error);
  first.reset();  // leaves the file of the second alone
  EXPECT_EQ(std::filesystem::exists(output + ".lock"), true);
  EXPECT_NO_THROW(second.check());
}

TEST(OutputLock, TellsWhatItsOwnerHasNoted) {
  const TemporaryFolder folder;
  const std::string output = folder.file("out.h5");
  const Bytes first(26, std::byte{1}), second(5, std::byte{2});
  {
    OutputLock lock(output);
    EXPECT_EQ(OutputLock::noted(output), Bytes());
    for (const Bytes& note : {first, second}) {
      lock.note(note);
      EXPECT_EQ(OutputLock::noted(output), note);
    }
    lock.leave();
  }
  EXPECT_EQ(OutputLock::noted(output), second);
  { const OutputLock next(output); }  // takes up the file that was left
  EXPECT_EQ(OutputLock::noted(output), Bytes());
  write_content(output + ".lock", "of somebody");
  EXPECT_THROW(OutputLock::noted(output), RunRefused);
}

// Each open file has a flock() of its own, also within one process. There are more threads than
// processors, so that some are interrupted between opening the file and locking it.
TEST(OutputLock, IsNeverHeldByTwoHoweverOftenItIsTaken) {
  const TemporaryFolder folder;
  const std::string output = folder.file("out.h5");
  std::atomic<int> holders = 0, taken = 0, refused = 0, together = 0;
  const auto take_often = [&] {
    for (int i = 0; i < 4000; ++i) {
      try {
        const OutputLock lock(output);
        if (holders.fetch_add(1) != 0) ++together;
        if (++taken % 4 == 0) std::this_thread::yield();
        holders.fetch_sub(1);
      } catch (const RunRefused&) {
        ++refused;
      }
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) threads.emplace_back(take_often);
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(together, 0);
  EXPECT_EQ(taken + refused, 32000);
  EXPECT_GT(taken, 0);
  EXPECT_EQ(std::filesystem::exists(output + ".lock"), false);
}

TEST(OutputLock, IsOfTheFileBehindSymbolicLinks) {
  const TemporaryFolder folder;
  const std::string output = folder.file("out.h5"), link = folder.file("link.h5");
  std::filesystem::create_symlink("out.h5", link);
  EXPECT_EQ(output_behind_links(link), output);
  EXPECT_EQ(output_behind_links(output), output);
  std::filesystem::create_directory(output);
  EXPECT_THROW(output_behind_links(link), RunRefused);
}

}  // namespace
}  // namespace tribo::sweep
