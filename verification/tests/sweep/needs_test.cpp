// SPDX-License-Identifier: Apache-2.0
#include "sweep/needs.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sweep/needs_text.hpp"
#include "sweep/plan_reader.hpp"

namespace tribo::verification {
namespace {

using sweep::Needs;
using sweep::SweepPlan;

// The paper's smooth surface, with this speed and viscosity and these lines in [sweep].
SweepPlan plan_of(const std::string& speed, const std::string& viscosity,
                  const std::string& settings) {
  const auto reading = sweep::parse_sweep("load = 50\nspeed = " + speed + R"(
[surface]
summit_density = 2e11
summit_radius = 1e-5
summit_height_sd = 2.5e-8
[bodies]
effective_modulus = 107.9e9
reduced_radius = 9.5e-3
[lubricant]
pressure_viscosity = 2e-8
viscosity = )" + viscosity + "\n[sweep]\n" + settings,
                                          "needs.toml");
  if (!reading.sweep) throw std::runtime_error(reading.errors.front().line());
  return sweep::make_plan({*reading.sweep});
}

// Where a sweep fits by the quick bound, its needs are not estimated more closely. So the quick
// bound has to be an upper one.
TEST(Needs, AreNeverMoreThanTheQuickBound) {
  const std::string narrow = "{ distribution = \"uniform\", from = 0.02, to = 0.03 }";
  const std::string wide = "{ distribution = \"log_uniform\", from = 1e-9, to = 1e3 }";
  const std::string many = "{ from = 1e-3, to = 3, count = 300 }";
  const std::string summaries = "keep = \"summaries\"\n";
  const SweepPlan plans[] = {
      plan_of("0.1", narrow, "draws = 1000"),
      plan_of("0.1", wide, "draws = 1000000"),
      plan_of("0.1", wide, summaries + "draws = 1000000"),
      plan_of("[0.1, 1.0]", wide, summaries + "draws = 10000000"),
      plan_of(many, narrow, "draws = 10000"),
      plan_of(many, wide, summaries + "draws = 10000"),
      plan_of("[0.1, 1.0]", wide, "draws = 20000\nsensitivity = true"),
      plan_of("{ from = 1e-3, to = 3, count = 20000 }", narrow, "draws = 3"),
  };
  for (const SweepPlan& plan : plans)
    for (const int threads : {1, 4}) {
      const Needs least = needs_of(plan, threads), most = most_needs(plan, threads);
      const double draws = static_cast<double>(plan.scenes.front().draws);
      EXPECT_LE(least.memory, most.memory) << draws;
      EXPECT_LE(least.file, most.file) << draws;
      EXPECT_LE(least.parts, most.parts) << draws;
    }
}

TEST(NeedsText, HasNoExponents) {
  constexpr double minute = 60, hour = 3600, day = 86400;
  constexpr std::pair<double, const char*> times[]{
      {0.0123, "0.012 s"},        {99.4, "99 s"},
      {99.7, "1.7 min"},          {99.4 * minute, "99 min"},
      {99.6 * minute, "1.7 h"},   {55 * hour, "55 h"},
      {60 * hour, "2.5 days"},    {999.4 * day, "999 days"},
      {1234.5 * day, "1234 days"}};
  for (const auto& [seconds, expected] : times) EXPECT_EQ(sweep::time_text(seconds), expected);
  for (const auto& [bytes, expected] : std::vector<std::pair<double, const char*>>{
           {1234, "1.23 kB"}, {999.7e3, "1000 kB"}, {1e6, "1 MB"}, {2.5e12, "2500 GB"}})
    EXPECT_EQ(sweep::bytes_text(bytes), expected);
}

}  // namespace
}  // namespace tribo::verification
