// SPDX-License-Identifier: Apache-2.0
// The judge of the model, on certified tables that are made wrong: a value that is off by a little
// more than the contract allows is found, and a value off by a little less is not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "accuracy/accuracy.hpp"
#include "accuracy/reference_table.hpp"
#include "catalogue/catalogue.hpp"
#include "support/judge.hpp"
#include "support/temporary_folder.hpp"
#include "tribo/load_sharing.hpp"

namespace tribo::verification {
namespace {

namespace fs = std::filesystem;

const fs::path exact = fs::path(TRIBOCHECK_SOURCE_DIR) / "reference/exact";

// The message about a table that cannot be read. It is empty where the table can be read.
template <class Read>
std::string refusal(Read&& read) {
  try {
    read();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(ReferenceRow, ErrorCountsBothHalvesOfTheValueInUnitsOfItsLastPlace) {
  const TemporaryFolder folder;
  const auto error = [&](const char* high, const char* low, double got) {
    const std::string path =
        folder.written("halves.csv", fmt::format("id,high,low\na,{},{}\n", high, low));
    return read_reference_table(path).front().error_in_ulp(got);
  };
  EXPECT_EQ(error("0x1p+0", "0x1p-54", 1), 0.25);
  EXPECT_EQ(error("0x1p+0", "0x1p-54", 1 + 0x1p-52), 0.75);
  EXPECT_EQ(error("0x1p+0", "-0x1p-54", 1 + 0x1p-52), 1.25);
  EXPECT_EQ(error("-0x1p+3", "0x0p+0", -8 - 0x1p-49), 1);
  EXPECT_EQ(error("0x0p+0", "0x0p+0", std::numeric_limits<double>::denorm_min()), 1);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double no_number : {std::nan(""), infinity, -infinity})
    EXPECT_EQ(error("0x1p+0", "0x0p+0", no_number), infinity);
}

TEST(ReferenceTable, ThatIsCutOrEmptyIsRefusedByName) {
  const TemporaryFolder folder;
  for (const char* const text :
       {"", "# nothing\n", "id,high\n", "id,high\na\n", "id,high\na,1,2\n"}) {
    const std::string path = folder.written("cut.csv", text);
    EXPECT_EQ(refusal([&] { read_reference_table(path); }).starts_with(path + ": "), true) << text;
  }
  for (const char* const cell : {"", "x", "1x", "0x1p", "1 2"}) {
    const auto row =
        read_reference_table(folder.written("cell.csv", fmt::format("id,high\na,{}\n", cell)))
            .front();
    EXPECT_NE(refusal([&] { row.number("high"); }), "") << cell;
  }
}

TEST(QuantityResult, HasPassedOnlyWithCasesAllWithinTheirBound) {
  const auto passed = [](std::size_t cases, double part) {
    QuantityResult result;
    result.cases = cases;
    result.worst_part_of_bound = part;
    return result.passed();
  };
  EXPECT_EQ(passed(1, 0), true);
  EXPECT_EQ(passed(1, 1), true);
  EXPECT_EQ(passed(1, 1 + 0x1p-52), false);
  EXPECT_EQ(passed(1, std::nan("")), false);
  EXPECT_EQ(passed(0, 0), false);
}

// The figures of each function are counted anew, row by row.
TEST(QuantityResult, HasTheWorstOfAllRowsOfItsTable) {
  for (const QuantityResult& got : check_accuracy(exact.string())) {
    const catalogue::Function* const function = catalogue::function_named(got.quantity);
    if (function == nullptr) continue;
    std::vector<double> errors, per_condition, parts;
    const auto rows = read_reference_table((exact / (got.quantity + ".csv")).string());
    for (const ReferenceRow& row : rows) {
      catalogue::Arguments arguments{};
      catalogue::Results results{};
      for (std::size_t i = 0; i < function->parameters.size(); ++i) {
        const catalogue::Parameter& one = function->parameters[i];
        arguments[i] = one.words.empty() ? row.number(one.name)
                                         : catalogue::place_of(row.text(one.name), one).value();
      }
      function->value(arguments, results);
      std::size_t place = 0;
      while (function->results.size() > 1 && function->results[place].name != row.text("output"))
        ++place;
      const double condition = std::max(1.0, row.number("condition"));
      const Contract& contract = function->contract;
      errors.push_back(row.error_in_ulp(results[place]));
      per_condition.push_back(errors.back() / condition);
      parts.push_back(errors.back() /
                      std::max(contract.ulp, contract.ulp_per_condition * condition));
    }
    const auto worst = std::max_element(parts.begin(), parts.end());
    EXPECT_EQ(got.cases, rows.size()) << got.quantity;
    EXPECT_EQ(got.worst_ulp, *std::max_element(errors.begin(), errors.end())) << got.quantity;
    EXPECT_EQ(got.worst_ulp_per_condition,
              *std::max_element(per_condition.begin(), per_condition.end()))
        << got.quantity;
    EXPECT_EQ(got.worst_part_of_bound, *worst) << got.quantity;
    EXPECT_EQ(got.worst_row, rows[static_cast<std::size_t>(worst - parts.begin())].text("id"));
  }
}

// The certified tables with one of them changed.
class ChangedTables : public testing::Test {
 protected:
  void SetUp() override { fs::copy(exact, folder.path(), fs::copy_options::recursive); }

  void change(const std::string& table, const std::string& from, const std::string& to) const {
    folder.written(table, replaced(content_of(exact / table), from, to));
  }
  QuantityResult of(const std::string& quantity) const {
    const std::vector<QuantityResult> results = check_accuracy(folder.path().string());
    return *std::find_if(results.begin(), results.end(),
                         [&](const auto& one) { return one.quantity == quantity; });
  }

  const TemporaryFolder folder;
};

// A root's certified value is moved by multiples of its bound, up and down, because the model's own
// error has a sign.
TEST_F(ChangedTables, AValueBeyondTheContractIsFoundAndOneWithinIsNot) {
  for (const char* const id : {"r0162", "r0160"}) {  // conditions of 1.35 and of 14.9
    const std::vector<ReferenceRow> rows =
        read_reference_table((exact / "load_sharing.csv").string());
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const auto& one) { return one.text("id") == id; });
    ASSERT_NE(row, rows.end());
    const double high = row->number("high");
    const double bound =
        std::max(load_sharing_contract.ulp,
                 load_sharing_contract.ulp_per_condition * row->number("condition")) *
        std::ldexp(1.0, std::ilogb(high) - 52);
    const auto passed = [&](double part) {
      change("load_sharing.csv", row->text("high") + ',' + row->text("low"),
             fmt::format("{:a},{}", high + part * bound, row->text("low")));
      const QuantityResult result = of("load_sharing");
      EXPECT_EQ(result.passed() || result.worst_row == id, true) << result.worst_row;
      return result.passed();
    };
    EXPECT_EQ(passed(1.15) && passed(-1.15), false) << id;
    EXPECT_EQ(passed(0.85) || passed(-0.85), true) << id;
  }
}

// An input that is no number gives an answer that is no number.
TEST_F(ChangedTables, AnAnswerThatIsNoNumberFails) {
  change("gaussian_moment.csv", "\nm0399,0x0p+0,0x1.286acd28p+3,", "\nm0399,0x0p+0,nan,");
  const QuantityResult result = of("gaussian_moment");
  EXPECT_EQ(result.passed(), false);
  EXPECT_EQ(result.worst_row, "m0399");
}

TEST_F(ChangedTables, ANumberWhereTheValueIsUndefinedIsAnError) {
  const std::vector<ReferenceRow> rows =
      read_reference_table((exact / "operating_point.csv").string());
  const auto row = std::find_if(rows.begin(), rows.end(), [](const ReferenceRow& one) {
    return one.text("output") == "friction" && one.is_defined();
  });
  ASSERT_NE(row, rows.end());
  change("operating_point.csv", ',' + row->text("value") + ',', ",,");
  const std::string said = refusal([&] { check_accuracy(folder.path().string()); });
  EXPECT_NE(said.find(row->text("id")), std::string::npos) << said;
}

}  // namespace
}  // namespace tribo::verification
