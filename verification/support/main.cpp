// SPDX-License-Identifier: Apache-2.0
// main of every test program. A test that no longer compares anything passes for GoogleTest; so each
// test's comparisons that held are counted (the linker sends testing::AssertionSuccess() through
// here, see verification/CMakeLists.txt) and recorded as its property "cases", which
// gates/inventory.py holds against the manifest. EXPECT_TRUE of a plain bool is not counted.
#include <gtest/gtest.h>

#include <cstdint>

namespace {

std::uint64_t comparisons_held = 0;

class CaseCount : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override { comparisons_held = 0; }
  void OnTestEnd(const testing::TestInfo&) override {
    testing::Test::RecordProperty("cases", static_cast<std::int64_t>(comparisons_held));
  }
};

}  // namespace

testing::AssertionResult assertion_success() __asm__("__real__ZN7testing16AssertionSuccessEv");
testing::AssertionResult counted_assertion_success() __asm__(
    "__wrap__ZN7testing16AssertionSuccessEv");

testing::AssertionResult counted_assertion_success() {
  ++comparisons_held;
  return assertion_success();
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  // GoogleTest owns its listeners. Before the printers, which write what is recorded.
  testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
  listeners.Append(new CaseCount);
  return RUN_ALL_TESTS();
}
