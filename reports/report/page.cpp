// SPDX-License-Identifier: Apache-2.0
#include "report/page.hpp"

#include <fmt/format.h>

#include <utility>

#include "tribo/version.hpp"

namespace tribo::report {
namespace {

std::string scene_list(const Findings& findings) {
  std::string text;
  for (const SolvedCase& one : findings.solved)
    text += fmt::format("{}`{}`", text.empty() ? "" : ", ", one.source.file);
  return text;
}

std::vector<std::string> introduction(const Findings& findings) {
  return {
      "D. Gasni (“Pengaruh kekasaran permukaan terhadap fenomena starvation pada point contact”, "
      "Universitas Andalas) computed film, load shares and friction of a starved, rough contact "
      "for "
      "three surfaces, with the asperity models of Greenwood and Tripp (GT) and of Greenwood and "
      "Williamson (GW). This page solves the same three surfaces with the same models, the "
      "paper's misprints mended, draws its Figures 4 and 7 to 12 again, and sets what it reports "
      "beside what comes out.",
      fmt::format("Computed by tribocheck {} from {}; the paper's own numbers from `{}`. C1 to C17 "
                  "number the paper's claims. Every computed number here comes out of these "
                  "files anew.",
                  version, scene_list(findings), findings.reported.file()),
  };
}

}  // namespace

Page make_page(const Findings& findings, const std::vector<ComparisonTable>& comparisons,
               std::vector<Figure> figures, std::vector<TextTable> verification,
               std::vector<TextTable> performance, std::vector<std::string> data_files) {
  Page page{"Starvation and roughness in a point contact: the paper's figures, recomputed",
            introduction(findings),
            inputs_table(findings.solved),
            {},
            std::move(figures),
            std::move(verification),
            std::move(performance),
            std::move(data_files)};
  for (const ComparisonTable& comparison : comparisons)
    page.comparisons.push_back(text_table(comparison));
  return page;
}

}  // namespace tribo::report
