// SPDX-License-Identifier: Apache-2.0
// main of every test program. GoogleTest passes a test that compares nothing, so each test's held
// comparisons are counted (the linker sends testing::AssertionSuccess() through here, see
// verification/tests/CMakeLists.txt) and printed. EXPECT_TRUE of a plain bool is not counted.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/case_count.hpp"

namespace {

using tribo::verification::case_count;

class CaseCountPrinter : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override { case_count = {}; }
  void OnTestEnd(const testing::TestInfo&) override {
    fmt::print("Ran {} cases, the nearest at {:.3g} of its bound\n", case_count.held,
               case_count.greatest_part_of_bound);
  }
};

}  // namespace

testing::AssertionResult assertion_success() __asm__("__real__ZN7testing16AssertionSuccessEv");
testing::AssertionResult counted_assertion_success() __asm__(
    "__wrap__ZN7testing16AssertionSuccessEv");

testing::AssertionResult counted_assertion_success() {
  ++case_count.held;
  return assertion_success();
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(new CaseCountPrinter);  // the list owns it
  return RUN_ALL_TESTS();
}
