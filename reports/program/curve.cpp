// SPDX-License-Identifier: Apache-2.0
// `tribocheck curve` prints the Stribeck curve of a scene: at points over its range of speeds that
// are evenly spaced in the logarithm, or at the speeds of its list.
#include <fmt/format.h>

#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command.hpp"
#include "curve_picture.hpp"
#include "measured_data.hpp"
#include "messages.hpp"
#include "picture.hpp"
#include "point_writers.hpp"
#include "prepared_scenes.hpp"
#include "progress.hpp"
#include "protocol/answers.hpp"
#include "scene_arguments.hpp"
#include "tribo/onset.hpp"

namespace tribo::cli {
namespace {

struct CurveArguments : SceneArguments {
  std::string data;     // the file of measured points; empty without one
  std::string picture;  // the file to draw; empty without one
};

void write_curves(const CurveArguments& arguments, const LoadedScenes& loaded,
                  OutputStream& output) {
  const std::vector<Scene>& scenes = loaded.scenes;
  std::size_t total = 0;
  for (const Scene& scene : scenes) total += scene.speeds.size();
  Progress progress(total);
  PointWriter writer(arguments.format, output, scenes);
  for (const Scene& scene : scenes) write_points(scene, 1, writer, progress);
  writer.finish({{"warnings", loaded.warnings.json()}});
}

// Compares the scene with the measured points. Their speeds may lie outside of the scene's own.
std::vector<Comparison> compared(const Scene& scene,
                                 const std::vector<MeasuredNumber>& measurements) {
  const MixedContact<double> contact(scene);
  const SmoothContact smooth(contact);
  const detail::SpeedSpan span = detail::speed_span(scene.speeds);
  std::vector<Comparison> comparisons;
  for (const MeasuredNumber& one : measurements) {
    const protocol::OutputValue computed =
        protocol::value_of(contact.solve(one.speed), &smooth, one.output);
    const bool has_both = computed.undefined.empty() && one.value > 0;
    comparisons.push_back({one, computed,
                           has_both ? 100 * (computed.number / one.value - 1)
                                    : std::numeric_limits<double>::quiet_NaN(),
                           one.speed < span.low || one.speed > span.high});
  }
  return comparisons;
}

// The reason why these scenes cannot be drawn or compared with measured points; empty if there is
// none.
std::string fault_of(const CurveArguments& arguments, const std::vector<Scene>& scenes) {
  if (!arguments.data.empty() && scenes.size() > 1)
    return fmt::format("--data is compared with one scene, and these are {}; allowed: one scene",
                       scenes.size());
  if (arguments.picture.empty()) return {};
  if (scenes.size() > most_drawn_scenes)
    return fmt::format("--picture draws at most {} scenes, and these are {}", most_drawn_scenes,
                       scenes.size());
  if (arguments.data.empty() && drawn_outputs(scenes, {}).empty())
    return "--picture draws friction, film and asperity_load_share, and the `outputs` of the "
           "scenes have none of them";
  return {};
}

int curve(const CurveArguments& arguments, OutputStream& output) {
  const LoadedScenes loaded = load_scenes(arguments.paths, SceneUse::speeds, prepare_curve);
  if (loaded.scenes.empty()) return exit_bad;
  if (const std::string fault = fault_of(arguments, loaded.scenes); !fault.empty())
    return fail(exit_bad, fault);
  std::vector<Comparison> comparisons;
  if (arguments.data.empty()) {
    write_curves(arguments, loaded, output);
  } else {
    const Scene& scene = loaded.scenes.front();
    const MeasuredPoints measured = read_measured(arguments.data, scene);
    for (const std::string& one : measured.contradictions)
      complain(fmt::format("{}: {}", arguments.data, one));
    if (!measured.ignored.empty())
      complain(fmt::format("{}: columns that are not compared: {}", arguments.data,
                           fmt::join(measured.ignored, ", ")));
    comparisons = compared(scene, measured.numbers);
    write_comparisons(arguments.format, scene.id, arguments.data, comparisons,
                      loaded.warnings.json(), output);
  }
  output.flush();
  const bool is_drawn =
      arguments.picture.empty() ||
      draw_picture("curve_picture.py", curve_picture(loaded.scenes, comparisons).dump(),
                   arguments.picture);
  const int code = loaded.exit_code(arguments);
  return code == exit_done && !is_drawn ? exit_failed : code;
}

constexpr const char* curve_footer =
    R"(The curve spans the scene's range of speeds with as many points as it has, spaced evenly in the
logarithm of speed, also where the range is spaced otherwise. A list of speeds is answered at these
speeds, the least first. Columns and formats are those of `tribocheck solve`.

--picture draws friction, film and the asperities' share of the load against speed, as far as the
scenes ask for them, from the least to the greatest speed, and marks the film's maximum
(film_maximum) and the last point before the film collapses.

--data compares one scene with what was measured. Each line of the file is a point, and its first
line names the columns with their units, separated by commas, semicolons or tabs:
  speed [m/s],film [nm],friction
  0.01,7.4,0.049
  0.1,,0.046
Columns beside the speed are those `outputs` of the scene that are numbers, in units as a scene takes
them: nm, GPa, and so on; numbers without a unit also in %. A unit stands in [ ], in ( ) or behind
a /, as in v / (mm/s). Usual names will do as well: rolling, entrainment or mean speed or velocity,
u, ue, v; film thickness, h, hc, h_cen; CoF, μ, mu, friction or traction coefficient, traction; λ of
film_parameter, Λ or Lambda of lambda_ratio; and a name with its symbol, as "Rolling Speed U". A
column of the load, of the slide-roll ratio (SRR) or of the oil's temperature is compared with the
scene's, and one line tells how many rows have another, which are marked as "other". Other columns
are named in one line and not read. A cell may stand in quotes, as "run 1, dirty". An empty cell was
not measured, a line that begins with # is not read. Between semicolons or tabs a number may have a
decimal comma. In place of the curve each number is printed in its unit with the model's at that
speed, and with their deviation, (computed − measured)/measured, where more than 0 was measured; a
speed outside of the curve is marked. Below, or in the lines "median" of CSV, is the median of each
column; and where points are outside, other, or where the film has collapsed, that of the points on
the curve, which are all but these, in the lines "median on the curve".
With --picture the points are drawn over the curve, those off the curve as open squares.

Exit code 0: done; 1: the picture is missing; 2: bad usage or input.

Example:
  tribocheck curve reference/published/rough.toml --format csv > curve.csv
  tribocheck curve reference/published/rough.toml --picture rough.png
  tribocheck curve reference/published/rough.toml --data measured.csv --picture measured.png)";

}  // namespace

Command add_curve(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("curve", "the Stribeck curve over a scene's range of speeds");
  app->footer(footer_with_scenes(curve_footer));
  const auto arguments = std::make_shared<CurveArguments>();
  add_scene_arguments(*app, *arguments);
  app->add_option(
      "--data", arguments->data,
      "compare one scene with the measured points in this file of comma-separated values");
  add_picture_option(*app, arguments->picture,
                     "friction, film and load share against speed, with the measured points");
  return {app, [arguments](OutputStream& output) { return curve(*arguments, output); }};
}

}  // namespace tribo::cli
