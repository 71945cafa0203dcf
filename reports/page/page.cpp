// SPDX-License-Identifier: Apache-2.0
#include "page/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "page/markup.hpp"

namespace tribo::report {

std::vector<PlacedVerdict> verdicts(const Page& page) {
  std::vector<PlacedVerdict> all;
  for (const Section& section : page.sections)
    for (const Verdict& verdict : section.verdicts) all.push_back({verdict, section.id});
  std::stable_partition(all.begin(), all.end(), [](const PlacedVerdict& one) {
    return one.verdict.standing == Standing::fails;
  });
  return all;
}

namespace {

std::size_t count_of(const std::vector<PlacedVerdict>& all, Standing wanted) {
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [wanted](const auto& one) {
    return one.verdict.standing == wanted;
  }));
}

}  // namespace

std::string_view standing_word(Standing standing) {
  switch (standing) {
    case Standing::holds:
      return "holds";
    case Standing::differs:
      return "differs";
    case Standing::fails:
      return "FAILS";
    case Standing::measured:
      return "measured";
    case Standing::absent:
      return "not run";
  }
  return "";
}

std::string standing_summary(const Page& page) {
  constexpr std::pair<Standing, std::string_view> kinds[] = {
      {Standing::holds, "hold"},
      {Standing::differs, "differ from the paper"},
      {Standing::fails, "fail"},
      {Standing::measured, "are measured, neither good nor bad"},
      {Standing::absent, "did not run or have no data"},
  };
  const std::vector<PlacedVerdict> all = verdicts(page);
  std::string text = fmt::format("Of {} findings", all.size());
  for (const auto& [standing, words] : kinds) {
    text += fmt::format("{} {} {}", standing == Standing::holds ? "" : ",", count_of(all, standing),
                        words);
  }
  return text +
         ". What holds agrees within the bound that is declared for it, or to the last digit that "
         "the "
         "paper prints.";
}

std::string verdict_in_short(const Page& page) {
  const std::vector<PlacedVerdict> all = verdicts(page);
  std::string text;
  const auto of_claims =
      std::find_if(all.begin(), all.end(), [](const auto& one) { return one.section == "claims"; });
  if (of_claims != all.end()) text += "The paper: " + to_plain(of_claims->verdict.text) + '\n';
  text += fmt::format("This software: {} checks hold, {} fail, {} did not run.\n",
                      count_of(all, Standing::holds), count_of(all, Standing::fails),
                      count_of(all, Standing::absent));
  for (const auto& [verdict, section] : all)
    if (verdict.standing == Standing::fails || verdict.standing == Standing::absent)
      text += fmt::format("  {}: {}: {}\n", standing_word(verdict.standing),
                          to_plain(verdict.subject), to_plain(verdict.text));
  return text;
}

Section not_run_section(const std::vector<Section>& sections) {
  Section section{"not-run", "What did not run"};
  TextTable table{
      "Missing from this page", {"what", "why", "how to have it"}, {false, false, false}, {}, {}};
  for (const Section& one : sections)
    for (const NotRun& missing : one.not_run)
      table.rows.push_back({missing.what, missing.why, missing.how_to});
  section.paragraphs = {
      "For this page the paper's scenes were solved, the certified tables held, and the work "
      "counted. "
      "Slow targets were not run: their results stand here as they were left, with commit, machine "
      "and date, and the environment says how old they are."};
  if (table.rows.empty()) {
    section.paragraphs.emplace_back("Nothing else is missing.");
    section.verdicts = {
        {Standing::holds, section.title, "Nothing: every part of this page has its data."}};
    return section;
  }
  section.verdicts = {{Standing::absent, section.title,
                       fmt::format("{} {} of this page did not run or {} no data.",
                                   table.rows.size(), table.rows.size() == 1 ? "part" : "parts",
                                   table.rows.size() == 1 ? "has" : "have")}};
  section.tables = {std::move(table)};
  return section;
}

std::vector<std::string> data_paths(const Page& page) {
  std::vector<std::string> paths;
  for (const Section& section : page.sections)
    for (const DataFile& file : section.data) paths.push_back(file.path);
  return paths;
}

}  // namespace tribo::report
