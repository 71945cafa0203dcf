// SPDX-License-Identifier: Apache-2.0
// Diagrams of error against work. Their captions are read off the baseline.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "page/number_text.hpp"
#include "page/work_precision.hpp"

namespace tribo::report {
namespace {

constexpr std::string_view gnuplot_signs = "\\_^{}@&~";

// The second line of each title: where and when it was measured.
std::string measured_on(const Json& baseline) {
  const Json& environment = baseline.at("environment");
  std::string text;
  for (const char sign :
       fmt::format("{}, {}, {}, commit {}, {}", environment.at("cpu").get<std::string>(),
                   environment.at("instruction_set").get<std::string>(),
                   environment.at("compiler").get<std::string>(),
                   short_commit(baseline.at("commit").get<std::string>()),
                   baseline.at("date").get<std::string>())) {
    if (gnuplot_signs.find(sign) != std::string_view::npos) text += '\\';
    text += sign;
  }
  return text;
}

// F~5/2~ as F_{5/2}.
std::string in_gnuplot(const std::string& markup) {
  std::string text;
  bool inside = false;
  for (const char sign : markup) {
    if (sign == '~')
      text += (inside = !inside) ? "_{" : "}";
    else if (sign != '`')
      text += sign;
  }
  return text;
}

std::string in_words(const Way& way) {
  return fmt::format("{} `{}` takes {} ns a point, greatest error {} ulp", way.family, way.name,
                     rounded(way.ns, 3), rounded(way.max_ulp, 3));
}

std::string time_caption(const Json& baseline, const std::string& job) {
  const std::vector<Way> ways = fastest_ways(baseline, job);
  const auto [ours, other] = contest(ways);
  std::string text =
      "Lower is more exact, further left is faster; a line joins the settings of one method from "
      "coarse to fine, and ours are the large orange signs. ";
  if (ours != nullptr) text += "Of ours that fail nowhere the fastest, " + in_words(*ours) + ". ";
  if (other != nullptr) text += "Of all others that fail nowhere the fastest, " + in_words(*other);
  if (ours != nullptr && other != nullptr)
    text += fmt::format(": {} times as long", rounded(other->ns / ours->ns, 3));
  return text + (other != nullptr ? "." : "");
}

std::string evaluations_caption(const Json& baseline, const std::string& job) {
  const std::vector<Way> ways = fastest_ways(baseline, job);
  std::string text =
      "The same errors against how often the integrand or the moment was evaluated, which no "
      "machine changes. Of the fastest way of each family:";
  const char* separator = " ";
  for (const Way& way : ways) {
    if (std::isnan(way.evaluations)) continue;
    text +=
        fmt::format("{}{} `{}` {}", separator, way.family, way.name, rounded(way.evaluations, 3));
    separator = ", ";
  }
  return text + " evaluations a point.";
}

// Of each series the fraction at the smallest and at the greatest factor.
std::string profile_caption(const Json& baseline) {
  std::map<std::string, std::pair<double, double>> ends;
  for (const Json& row : baseline.at("performance_profile")) {
    const auto fraction = row.at("fraction").get<double>();
    ends.try_emplace(row.at("solver").get<std::string>(), fraction, fraction).first->second.second =
        fraction;
  }
  const auto fastest = std::max_element(ends.begin(), ends.end(), [](const auto& a, const auto& b) {
    return a.second.first < b.second.first;
  });
  std::size_t complete = 0;
  for (const auto& [solver, fraction] : ends) complete += fraction.second >= 1 ? 1 : 0;
  std::string text =
      "Further up and further left is better: the fraction of cases that a solver settles within a "
      "factor τ of the best one. ";
  if (fastest != ends.end())
    text += fmt::format("`{}` is the fastest in {} % of the cases. ", fastest->first,
                        rounded(100 * fastest->second.first, 3));
  return text + fmt::format("{} of {} solvers settle all cases within the greatest τ.", complete,
                            ends.size());
}

// The greatest `key` of each kernel, in the order of the file.
std::string greatest_of_each(const Json& rows, const char* key, const char* unit) {
  std::vector<std::pair<std::string, double>> greatest;
  for (const Json& row : rows) {
    const auto kernel = row.at("kernel").get<std::string>();
    const double value = row.at(key).get<double>();
    const auto known = std::find_if(greatest.begin(), greatest.end(),
                                    [&](const auto& one) { return one.first == kernel; });
    if (known == greatest.end())
      greatest.emplace_back(kernel, value);
    else
      known->second = std::max(known->second, value);
  }
  std::string text;
  for (const auto& [kernel, value] : greatest)
    text += fmt::format("{}`{}` {}{}", text.empty() ? "" : ", ", kernel, rounded(value, 3), unit);
  return text;
}

struct Kind {
  std::string script;
  std::string data;  // name of its blocks
  std::string stem;
  std::string title;  // markup
  std::string caption;
  std::string alternative;
  int height = 640;
};

Figure figure(Kind&& kind, const std::string& where) {
  return {"work_" + kind.stem,
          {},
          kind.title,
          std::move(kind.caption),
          std::move(kind.alternative),
          {fmt::format("data/work_precision/{}.blocks.tsv", kind.data)},
          {"work.gp", std::move(kind.script), "data/work_precision", kind.data,
           in_gnuplot(kind.title), where, kind.height}};
}

// Are evaluations counted in this job for any family but ours?
bool has_evaluations(const Json& baseline, const std::string& job) {
  for (const Json& row : baseline.at("error_against_work"))
    if (row.at("job") == job && row.at("family") != "tribocheck" &&
        row.at("evaluations").is_number())
      return true;
  return false;
}

}  // namespace

std::vector<Figure> work_precision_figures(const Json& baseline) {
  const std::string where = measured_on(baseline);
  std::vector<Figure> figures;
  const auto add = [&](Kind&& kind) { figures.push_back(figure(std::move(kind), where)); };
  for (const std::string& job : jobs(baseline))
    add({"error_against_time.gp", job, job, "True error against time: " + job_name(job),
         time_caption(baseline, job),
         "True error in units in the last place against CPU time a point, both on logarithmic "
         "axes, "
         "one line for each way of doing the job."});
  for (const std::string& job : jobs(baseline))
    if (has_evaluations(baseline, job))
      add({"error_against_evaluations.gp", job, job + "_evaluations",
           "True error against evaluations: " + job_name(job), evaluations_caption(baseline, job),
           "True error in units in the last place, logarithmic, against evaluations a point, one "
           "line for each way of doing the job."});
  add({"performance_profile.gp", "profile", "profile", "Film parameter: performance profile",
       profile_caption(baseline),
       "Fraction of cases solved against the factor to the best solver's time, logarithmic, one "
       "line for each solver."});
  add({"throughput_by_size.gp", "by_size", "by_size", "Throughput of batches by their size",
       "Higher is better, and a plain copy is what memory allows. Greatest throughput: " +
           greatest_of_each(baseline.at("throughput_by_size"), "gigabytes_per_second", " GB/s") +
           ".",
       "Bytes read and written a second against the number of points in a batch, on logarithmic "
       "axes, one line for each kernel and one for a plain copy.",
       480});
  add({"throughput_by_threads.gp", "by_threads", "by_threads", "Speed-up by threads",
       "On the grey line a kernel is as many times as fast as it has threads. Greatest speed-up: " +
           greatest_of_each(baseline.at("throughput_by_threads"), "speedup", "") + ".",
       "Speed-up against threads, one line for each kernel.", 480});
  return figures;
}

}  // namespace tribo::report
