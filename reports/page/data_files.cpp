// SPDX-License-Identifier: Apache-2.0
#include "page/data_files.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

#include "page/number_text.hpp"
#include "tribo/version.hpp"

namespace tribo::report {
namespace {

using Claims = std::vector<reproduction::Item>;

std::string header(std::string_view what, std::string_view made_from) {
  return fmt::format("# {}\n# tribocheck {}, from {}\n", what, version, made_from);
}

// The meanings of the columns; undefined numbers are NaN.
std::string notes() {
  std::string text = "# NaN: undefined\n";
  for (const OutputInfo& output : output_infos)
    text += fmt::format("# {}: {}\n", output.name, output.meaning);
  return text;
}

std::string point_columns() {
  std::string text = "speed [m/s]";
  for (const OutputInfo& output : output_infos)
    text += output.unit.empty() ? fmt::format("\t{}", output.name)
                                : fmt::format("\t{} [{}]", output.name, output.unit);
  return text;
}

// The columns of point_columns().
std::string cells(const Point& point) {
  std::string text = exact(point.speed);
  for (const double value : {point.film_flooded, point.film, point.separation, point.film_parameter,
                             point.asperity_load_share, point.fluid_load_share,
                             point.real_area_ratio, point.summit_count, point.friction})
    text += '\t' + exact(value);
  return fmt::format("{}\t{}\t{}", text, name(point.regime), name(point.inlet));
}

std::string curve_text(const std::vector<Point>& points) {
  std::string text = fmt::format("{}# {}\n", notes(), point_columns());
  for (const Point& point : points) text += cells(point) + '\n';
  return text;
}

DataFile case_file(const SolvedCase& solved) {
  return curve_file(fmt::format("data/curve_{}.tsv", solved.source.stem()), solved.source.file,
                    solved.curve);
}

DataFile slope_file(const SlopeCurve& curve, const TwoSlopes& slopes) {
  return {
      fmt::format("data/figure_04_{}.tsv", curve.name),
      header("Film against speed", fmt::format("{}: {}", slopes.base->source.file, curve.change)) +
          curve_text(curve.points)};
}

// gnuplot reads the blocks between pairs of blank lines by index.
DataFile guide_file(const TwoSlopes& slopes) {
  std::string text =
      header("Lines of constant slope beside the curves of Figure 4", slopes.base->source.file);
  text += "# speed [m/s]\tfilm [m]\tslope of ln film in ln speed\n";
  for (const GuideLine& line : slopes.guides) {
    for (std::size_t i = 0; i < line.speeds.size(); ++i)
      text += fmt::format("{}\t{}\t{}\n", exact(line.speeds[i]), exact(line.films[i]),
                          exact(line.slope));
    text += "\n\n";
  }
  return {"data/figure_04_guides.tsv", text};
}

// Film maxima of the curves of Figure 4 but the paper's own, which is in marks.tsv.
DataFile slope_marks_file(const TwoSlopes& slopes) {
  std::string text = header("Onset of starvation (film_maximum) on the curves of Figure 4",
                            slopes.base->source.file);
  text += fmt::format("# curve\t{}\n", point_columns());
  for (const SlopeCurve& curve : slopes.curves)
    if (curve.at_onset && curve.name != "paper")
      text += fmt::format("{}\t{}\n", curve.name, cells(*curve.at_onset));
  return {"data/figure_04_marks.tsv", text};
}

// Where neither film has collapsed.
DataFile ratio_file(const SolvedCase& gt, const SolvedCase& gw) {
  std::string text = header("Film with GW over film with GT, up to the collapse",
                            fmt::format("{} and {}", gw.source.file, gt.source.file));
  text += "# speed [m/s]\tfilm with GW/film with GT\n";
  for (const Point& point : gw.curve) {
    const Point other = gt.contact.solve(point.speed);
    if (point.inlet == Inlet::collapsed || other.inlet == Inlet::collapsed) break;
    text += fmt::format("{}\t{}\n", exact(point.speed), exact(point.film / other.film));
  }
  return {"data/figure_11_ratio.tsv", text};
}

std::string mark(std::string_view event, const SolvedCase& solved,
                 const std::optional<Point>& point) {
  if (!point) return {};
  return fmt::format("{}\t{}\t{}\t{}\n", event, solved.source.surface, solved.source.short_model(),
                     cells(*point));
}

std::optional<Point> at_reported_onset(const SolvedCase& solved, const Claims& claims) {
  const reproduction::Item* const row =
      reported(claims, reproduction::Quantity::onset_speed, solved.source);
  if (row == nullptr) return std::nullopt;
  return solved.contact.solve(row->reported);
}

// Past a collapse without a floor: the limits A(0) and 1 − A(0), which the paper draws as shares.
std::optional<Point> as_printed(const SolvedCase& solved, const std::optional<Point>& there) {
  if (!there || there->regime != Regime::collapsed) return there;
  Point point = *there;
  point.asperity_load_share = solved.contact.sharing().asperity_share(0);
  point.fluid_load_share = 1 - point.asperity_load_share;
  return point;
}

// The ends of the line that a curve as printed follows past its collapse.
std::string printed_ends(const SolvedCase& solved) {
  if (solved.curve.back().regime != Regime::collapsed) return {};
  return mark("printed", solved, as_printed(solved, solved.at_collapse)) +
         mark("printed", solved, as_printed(solved, solved.curve.back()));
}

DataFile marks_file(const std::vector<SolvedCase>& solved, const Claims& claims) {
  std::string text = header(
      "Points to mark: the lowest speed, the onset speed that the paper reports, the onset of "
      "starvation (film_maximum) and the collapse of the film where they lie within the speeds, "
      "and "
      "both ends of what the paper draws past a collapse; of these two the shares are the limits "
      "A(0) and 1 − A(0), which balance no load",
      "the scenes of the curves and claims.tsv");
  text += fmt::format("{}# event\tsurface\tmodel\t{}\n", notes(), point_columns());
  for (const SolvedCase& one : solved)
    text += mark("slowest", one, one.slowest) +
            mark("reported", one, at_reported_onset(one, claims)) +
            mark("onset", one, one.at_onset) +
            mark("collapse", one, as_printed(one, one.at_collapse)) + printed_ends(one);
  return {"data/marks.tsv", text};
}

std::string or_nan(const std::optional<double>& value) { return value ? exact(*value) : "NaN"; }

std::string comparison_line(const ComparisonRow& row) {
  const std::string_view verdict = !row.computed          ? row.none
                                   : row.claim == nullptr ? "no number in the paper"
                                                          : reproduction::name(*row.verdict());
  return fmt::format(
      "{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", reproduction::name(row.quantity), row.surface, row.model,
      row.criterion.empty() ? "-" : row.criterion, or_nan(row.computed),
      row.claim == nullptr ? "NaN" : exact(row.claim->reported), or_nan(row.factor()), verdict);
}

DataFile comparison_file(const std::vector<ComparisonRow>& rows) {
  std::string text = header(
      "Computed beside reported; speeds in m/s, film parameters and shares "
      "without a unit",
      "the scenes of the curves and claims.tsv");
  text += "# NaN: no such onset, or no number in the paper; the verdict says which\n";
  text += "# quantity\tsurface\tmodel\tcriterion\tcomputed\treported\tcomputed/reported\tverdict\n";
  for (const ComparisonRow& row : rows) text += comparison_line(row);
  return {"data/comparison.tsv", text};
}

}  // namespace

std::vector<DataFile> data_files(const std::vector<SolvedCase>& solved, const TwoSlopes& slopes,
                                 const Claims& claims, const std::vector<ComparisonRow>& rows) {
  std::vector<DataFile> files;
  for (const SolvedCase& one : solved) files.push_back(case_file(one));
  for (const SlopeCurve& curve : slopes.curves)
    if (curve.name != "paper") files.push_back(slope_file(curve, slopes));
  files.push_back(guide_file(slopes));
  files.push_back(slope_marks_file(slopes));
  files.push_back(ratio_file(find_solved(solved, "smooth", AsperityModel::greenwood_tripp),
                             find_solved(solved, "smooth", AsperityModel::greenwood_williamson)));
  files.push_back(marks_file(solved, claims));
  files.push_back(comparison_file(rows));
  return files;
}

DataFile curve_file(std::string_view path, std::string_view file, const std::vector<Point>& curve) {
  return {std::string(path), header("Stribeck curve", file) + curve_text(curve)};
}

DataFile points_file(std::string_view path, std::string_view what, std::string_view made_from,
                     const std::vector<NamedPoint>& points) {
  std::string text = header(what, made_from) + fmt::format("# name\t{}\n", point_columns());
  for (const NamedPoint& one : points)
    if (one.point) text += fmt::format("{}\t{}\n", one.name, cells(*one.point));
  return {std::string(path), std::move(text)};
}

}  // namespace tribo::report
