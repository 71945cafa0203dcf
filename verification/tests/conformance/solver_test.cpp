// SPDX-License-Identifier: Apache-2.0
// How a solver in C++ registers what it has (conformance/serve.hpp).
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>

#include "conformance/serve.hpp"

namespace tribo::conformance {
namespace {

// The answer of the function's batch to one set of arguments.
Answer<catalogue::Results> asked_of(const Solver& solver, std::string_view name,
                                    const catalogue::Arguments& arguments) {
  const FunctionBatch& batch = solver.batch(*catalogue::function_named(name));
  std::array<Answer<catalogue::Results>, 1> answers;
  batch({&arguments, 1}, answers);
  return answers[0];
}

template <class Function>
std::string refusal_of(std::string_view name, Function function) {
  try {
    Solver().offer(name, function);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Solver, HandsArgumentsOnInTheOrderOfTheCatalogueAndWordsAsTheirEnumeration) {
  Solver solver;
  solver.offer("starvation_ratio", [](StarvationClosure closure, double ratio, double exponent) {
    return (closure == StarvationClosure::damiens ? 100 : 0) + 10 * ratio + exponent;
  });
  EXPECT_EQ(asked_of(solver, "starvation_ratio", {3, 0.5, 2}).result[0], 107);
  EXPECT_EQ(asked_of(solver, "starvation_ratio", {0, 0.5, 2}).result[0], 7);
}

TEST(Solver, FewerResultsThanTheFunctionHasAreNotOffered) {
  Solver solver;
  solver.offer("hertz_point", [](double load, double, double) { return std::array{load, 2.0}; });
  const catalogue::Results results = asked_of(solver, "hertz_point", {5, 1, 1}).result;
  EXPECT_EQ(results[0], 5);
  EXPECT_EQ(results[1], 2);
  EXPECT_NE(results[2], results[2]);  // NaN
}

TEST(Solver, AThrownExceptionIsAFailureWithItsMessage) {
  Solver solver;
  solver.offer("gaussian_moment",
               [](double, double) -> double { throw std::runtime_error("no convergence"); });
  const Answer<catalogue::Results> answer = asked_of(solver, "gaussian_moment", {0, 0});
  EXPECT_EQ(answer.status, Status::failed);
  EXPECT_EQ(answer.reason, "no convergence");
}

TEST(Solver, RefusesAFunctionThatIsNotInTheCatalogueOrTakesOtherArguments) {
  EXPECT_EQ(refusal_of("hertz", [](double, double, double) { return 1.0; }),
            "no function is called hertz; `tribocheck functions` lists all");
  EXPECT_EQ(refusal_of("hertz_point", [](double, double) { return 1.0; }),
            "hertz_point takes load, effective_modulus, reduced_radius: 3 arguments, not 2");
}

}  // namespace
}  // namespace tribo::conformance
