// SPDX-License-Identifier: Apache-2.0
// tribocheck sweep: many cases of a scene, on many threads and machines.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "build_info.hpp"
#include "command.hpp"
#include "messages.hpp"
#include "page/rendering.hpp"
#include "page/sweep_tables.hpp"
#include "progress.hpp"
#include "scene/schema.hpp"
#include "scene_arguments.hpp"
#include "stop_signal.hpp"
#include "sweep/case_limits.hpp"
#include "sweep/case_scene.hpp"
#include "sweep/needs.hpp"
#include "sweep/needs_text.hpp"
#include "sweep/on_threads.hpp"
#include "sweep/part.hpp"
#include "sweep/plan_reader.hpp"
#include "sweep/result_file.hpp"
#include "sweep/run.hpp"
#include "sweep_diff.hpp"
#include "table.hpp"
#include "tribo/batch.hpp"
#include "validity_writers.hpp"

namespace tribo::cli {
namespace {

struct SweepArguments {
  std::vector<std::string> files;  // sweeps; for `merge` shards, for `show` results
  sweep::RunSettings run;
  std::string shard, pictures;
  std::string format = "table";
  std::optional<std::uint64_t> one_case;
  bool without_fma = false, estimate = false, cases = false, is_strict = false;
};

// --- Reading.

// A sentence on how to see a case that goes beyond limits. It names the case that goes furthest, or
// "N" if only the ends of grids were looked at.
std::string where_of(const std::string& file, const sweep::SceneSweep& sweep,
                     const std::vector<Validity>& passed) {
  const auto counted =
      std::ranges::find_if(passed, [](const Validity& limit) { return limit.judged_cases > 0; });
  return fmt::format(
      "`tribocheck sweep {} --case {} | tribocheck {}` tells all limits of {}", file,
      counted == passed.end() ? "N" : std::to_string(counted->furthest_case),
      sweep.asks_at_speeds() && !sweep.outputs.empty() ? "solve - --explain" : "contact -",
      counted == passed.end() ? "case N" : "that case");
}

// The plan of the files; std::nullopt if one is bad. Adds the number of warnings to `warned`.
std::optional<sweep::SweepPlan> read_plan(const std::vector<std::string>& files, bool told,
                                          std::size_t& warned) {
  std::vector<sweep::SceneSweep> scenes;
  Warnings warnings;
  std::string where;
  bool good = true;
  for (const std::string& file : files) {
    sweep::SweepReading reading = sweep::read_sweep(file);
    if (told) {
      for (const InputProblem& warning : reading.warnings) complain("warning: " + warning.line());
      for (const InputProblem& error : reading.errors) complain(error.line());
    }
    good = good && reading.sweep;
    const std::vector<Validity> passed = sweep::limits_of_cases(reading);
    warned += reading.warnings.size() + passed.size();
    if (!reading.sweep) continue;
    warnings.add(file, reading.sweep->scene.id, passed);
    if (where.empty() && !passed.empty()) where = where_of(file, *reading.sweep, passed);
    scenes.push_back(std::move(*reading.sweep));
  }
  if (told) warnings.tell(where);
  if (!good) return std::nullopt;
  return sweep::make_plan(std::move(scenes));
}

sweep::Shard shard_of(const std::string& text) {
  sweep::Shard shard;
  const char* const end = text.data() + text.size();
  const auto part = std::from_chars(text.data(), end, shard.part);
  if (part.ec == std::errc() && part.ptr != end && *part.ptr == '/') {
    const auto parts = std::from_chars(part.ptr + 1, end, shard.parts);
    if (parts.ec == std::errc() && parts.ptr == end && shard.part >= 1 &&
        shard.part <= shard.parts && shard.parts <= 1'000'000)
      return shard;
  }
  throw sweep::RunRefused("--shard: " + text +
                          " is not allowed; allowed: I/N, as 2/8: the second of eight parts");
}

// --- Estimating time, memory and files, from the plan and a few chunks computed for that.

void append_estimate(Text& to, const sweep::SweepPlan& plan, int threads) {
  const sweep::Needs needs = sweep::needs_of(plan, threads);
  for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
    const sweep::SceneSweep& scene = plan.scenes[i];
    append_line(to,
                fmt::format("{}: {} cases in the result, {:.4g} points to compute, {:.3g} µs each",
                            scene.scene.id, scene.cases(), static_cast<double>(scene.points()),
                            1e6 * needs.point_seconds[i]));
  }
  const int count = thread_count(threads);
  append(to, fmt::format("points {:.4g}, chunks {}\n", static_cast<double>(plan.points()),
                         plan.chunks()));
  append(to, fmt::format("time   {} on {} {}\n", sweep::time_text(needs.seconds), count,
                         count == 1 ? "thread" : "threads"));
  append(to, fmt::format("memory {}\n", sweep::bytes_text(needs.memory)));
  append(to, fmt::format("file   {}, and parts of {} until it is done\n",
                         sweep::bytes_text(needs.file), sweep::bytes_text(needs.parts)));
}

// --- Telling the content of a result.

void write_cases(const sweep::SweepResult& result, const sweep::ResultFile& file,
                 const std::string& format, OutputStream& output) {
  const report::CaseFormat as = format == "json"  ? report::CaseFormat::json
                                : format == "csv" ? report::CaseFormat::csv
                                                  : report::CaseFormat::table;
  report::write_sweep_cases(result, file, as, [&](std::string_view lines) {
    append(output.text(), lines);
    output.end_row();
  });
}

// The warnings of a result, which holds the texts of its sweeps.
Warnings warnings_of(const sweep::SweepResult& result) {
  Warnings warnings;
  for (const sweep::SceneResult& scene : result.scenes)
    warnings.add(scene.file, scene.id,
                 sweep::limits_of_cases(sweep::parse_sweep(scene.text, scene.file)));
  return warnings;
}

void write_result(const sweep::SweepResult& result, const std::vector<report::SweepCells>& cells,
                  const std::string& format, Text& to) {
  if (format == "json") {
    nlohmann::ordered_json members = report::sweep_json(result, cells);
    members["warnings"] = warnings_of(result).json();
    return append(
        to,
        document("sweep/1", members).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) +
            '\n');
  }
  if (format == "csv") return append(to, report::sweep_csv(result, cells));
  bool first = true;
  for (const report::TextTable& table : report::sweep_tables(result, cells)) {
    if (!first) append(to, "\n");
    first = false;
    append(to, report::plain_table(table));
  }
}

bool is_shard_or_part(const std::string& path) {
  try {
    const sweep::Part part(path);
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

// Tells how many films could not be solved. Returns whether all were solved.
bool tell_of_films(const sweep::SweepResult& result) {
  std::uint64_t missing = 0, all = 0;
  for (const sweep::SceneResult& scene : result.scenes)
    if (const sweep::ColumnResult* const film = scene.column("solved_film.central"))
      for (const sweep::ColumnResult::Value& value : film->values) {
        missing += value.undefined;
        all += value.count + value.undefined;
      }
  if (missing > 0)
    complain(fmt::format(
        "{} of {} films were not solved: `sweep show --cases` marks them in solved_film.outcome, "
        "and `tribocheck film` says why it does not solve such a contact",
        missing, all));
  return missing == 0;
}

// Returns exit_failed where pictures are missing, or where a new result lacks films.
int show_result(const SweepArguments& arguments, const sweep::ResultFile& file, bool is_new,
                OutputStream& output) {
  const sweep::SweepResult result = file.read();
  std::vector<report::SweepCells> cells;
  if (!arguments.cases || !arguments.pictures.empty())
    for (const sweep::SceneResult& scene : result.scenes)
      cells.push_back(report::cells_of(scene, file));
  if (arguments.cases)
    write_cases(result, file, arguments.format, output);
  else
    write_result(result, cells, arguments.format, output.text());
  if (!arguments.cases && arguments.format == "table" && report::is_small_grid(result)) {
    append(output.text(), "\n");
    write_cases(result, file, arguments.format, output);
  }
  output.flush();
  const int code = tell_of_films(result) || !is_new ? exit_done : exit_failed;
  if (arguments.pictures.empty()) return code;
  const report::Rendering drawn =
      report::draw_sweep_pictures(result, cells, file, arguments.pictures);
  for (const std::string& picture : drawn.written) complain("drew " + picture);
  for (const std::string& why : drawn.undrawn) complain(why);
  if (drawn.written.empty() && drawn.undrawn.empty())
    complain(
        "nothing in this result can be drawn: it has no onset speeds, no output over several "
        "speeds, no "
        "sensitivities and no grid of films");
  return drawn.undrawn.empty() ? code : exit_failed;
}

// Shows the result at -o, which this process has written or has found there.
int show_written(const SweepArguments& arguments, std::optional<sweep::Descriptor> written,
                 OutputStream& output) {
  return show_result(arguments,
                     written ? sweep::ResultFile(arguments.run.result, std::move(*written))
                             : sweep::ResultFile(arguments.run.result),
                     true, output);
}

// --- The three commands.

// The output and the files beside it must not replace a file that is read. Returns the reason why
// they would; empty if they do not.
std::string own_input(const SweepArguments& arguments) {
  std::error_code none;
  for (const std::string& file : arguments.files)
    for (const char* const ending : {"", ".part", ".lock"})
      if (std::filesystem::equivalent(file, arguments.run.result + ending, none))
        return "-o " + arguments.run.result + ": " + file +
               " is read, and would be replaced; allowed: another file";
  return {};
}

sweep::RunSettings settings_of(const SweepArguments& arguments, SweepProgress& progress,
                               bool first_rank) {
  sweep::RunSettings settings = arguments.run;
  if (!arguments.shard.empty()) settings.shard = shard_of(arguments.shard);
  settings.progress = [&progress](const sweep::RunProgress& now) { progress.show(now); };
  settings.tell = [&progress, first_rank](std::string_view line) {
    progress.wipe();
    if (first_rank) complain(line);
  };
  settings.stopped = [] { return stop_signal() != 0; };
  return settings;
}

// Makes this process compute on the best instruction set without fused multiply-add.
void leave_out_fma() {
  for (const std::string_view one : instruction_sets())
    if (use_instruction_set(one) && !is_fused()) return;
}

// is_over is set once this rank has nothing more to tell the others.
int run_on_rank(const SweepArguments& arguments, const sweep::Ranks& ranks, OutputStream& output,
                bool& is_over) {
  const bool first = ranks.rank() == 0;
  if (arguments.without_fma) leave_out_fma();
  std::size_t warned = 0;
  const auto plan = read_plan(arguments.files, first, warned);
  const bool first_read = ranks.from_first(plan ? "read" : "") == "read";
  if (!ranks.everywhere(plan.has_value())) {
    if (!plan && !first && first_read) read_plan(arguments.files, true, warned);
    return exit_bad;
  }
  const int when_done = arguments.is_strict && warned > 0 ? exit_failed : exit_done;
  if (arguments.estimate) {
    if (first) append_estimate(output.text(), *plan, arguments.run.threads);
    return when_done;
  }
  std::string refusal = first ? own_input(arguments) : "";
  if (first && arguments.without_fma &&
      std::any_of(plan->scenes.begin(), plan->scenes.end(),
                  [](const sweep::SceneSweep& scene) { return scene.solves_film; }))
    refusal =
        "--without-fma: solved films use the C library's functions, which choose fused "
        "multiply-add by themselves; allowed: without solved_film";
  if (!refusal.empty()) complain(refusal);
  if (!ranks.everywhere(refusal.empty())) return exit_bad;
  SweepProgress progress(static_cast<double>(plan->points()) / static_cast<double>(plan->chunks()));
  sweep::RunSettings settings = settings_of(arguments, progress, first);
  int shown = exit_done;
  settings.finished = [&](std::optional<sweep::Descriptor> written) {
    is_over = true;
    progress.wipe();
    stop_at_once();
    if (!settings.shard) shown = show_written(arguments, std::move(written), output);
  };
  bool is_told = false;
  settings.failed = [&](std::string_view why) {
    progress.wipe();
    if (!std::exchange(is_told, true)) complain(why);
  };
  watch_for_stop();
  sweep::RunEnd end = sweep::RunEnd::stopped;
  try {
    end = sweep::run(*plan, settings, ranks);
  } catch (const std::exception& failure) {
    if (!is_told) throw;
    return dynamic_cast<const sweep::RunRefused*>(&failure) == nullptr ? exit_failed : exit_bad;
  }
  progress.wipe();
  if (stop_signal() != 0 && (end == sweep::RunEnd::stopped || !first)) return 128 + stop_signal();
  const int code = end == sweep::RunEnd::done ? shown : exit_failed;
  return code == exit_done ? when_done : code;
}

// Turns exceptions into exit codes: bad usage, or the failure of another rank, after which
// the sweep can be resumed.
template <class Step>
int told(Step&& step) {
  try {
    return step();
  } catch (const sweep::OtherRankFailed&) {
    return exit_failed;
  } catch (const std::invalid_argument& refused) {
    complain(refused.what());
    return exit_bad;
  }
}

// "sweep show" for `sweep shwo`, if there is no such file; empty if no subcommand is meant.
std::string subcommand_meant(const SweepArguments& arguments) {
  if (arguments.files.empty() || std::filesystem::exists(arguments.files.front())) return {};
  constexpr auto names = std::to_array<std::string_view>({"merge", "show", "diff"});
  const std::string_view meant = scene_detail::nearest_choice(arguments.files.front(), names);
  return meant.empty() ? "" : "sweep " + std::string(meant);
}

// Limits the threads: more are of no use, and each takes memory.
void cap_threads(int& threads, bool is_told) {
  const int most = 16 * thread_count(0);
  if (threads <= most) return;
  if (is_told)
    complain(fmt::format("warning: --threads {} is more than is of use here; {} are taken", threads,
                         most));
  threads = most;
}

// Prints one case as a scene.
int print_case(const SweepArguments& arguments, OutputStream& output) {
  if (arguments.files.size() != 1)
    return fail(exit_bad, "--case is of one sweep; allowed: one SWEEP.toml");
  const sweep::SweepReading reading = sweep::read_sweep(arguments.files.front());
  for (const InputProblem& error : reading.errors) complain(error.line());
  if (!reading.sweep) return exit_bad;
  const std::uint64_t cases = reading.sweep->cases();
  if (*arguments.one_case >= cases)
    return fail(exit_bad, fmt::format("--case {}: there is no such case; allowed: 0 to {}",
                                      *arguments.one_case, cases - 1));
  append(output.text(), sweep::case_scene(*reading.sweep, *arguments.one_case));
  output.flush();
  return exit_done;
}

int run_sweep(SweepArguments& arguments, OutputStream& output) {
  if (const std::string meant = subcommand_meant(arguments); !meant.empty()) {
    complain("unknown command \"sweep " + printable(arguments.files.front()) +
             "\", and there is no such file; did you mean " + meant + "?");
    return exit_bad;
  }
  if (arguments.one_case) return print_case(arguments, output);
  if (arguments.files.empty() || (arguments.run.result.empty() && !arguments.estimate)) {
    complain(arguments.files.empty()
                 ? "sweep: no SWEEP.toml is given (see --help)"
                 : fmt::format(
                       "sweep: -o is missing: the file for the result; type tribocheck sweep "
                       "{} -o {}.h5",
                       printable(arguments.files.front()),
                       printable(std::filesystem::path(arguments.files.front()).stem().string())));
    return exit_bad;
  }
  return told([&] {
    const sweep::Ranks ranks;
    cap_threads(arguments.run.threads, ranks.rank() == 0);
    bool is_over = false;
    try {
      return told([&] { return run_on_rank(arguments, ranks, output, is_over); });
    } catch (const std::exception& failure) {
      if (ranks.count() == 1 || is_over) throw;
      complain(failure.what());
      ranks.end_all();  // ranks that wait for this rank would wait for ever
    }
  });
}

int merge_shards(const SweepArguments& arguments, OutputStream& output) {
  return told([&] {
    if (const std::string refusal = own_input(arguments); !refusal.empty())
      throw sweep::RunRefused(refusal);
    watch_for_stop();
    SweepProgress progress(0);
    sweep::RunSettings settings = settings_of(arguments, progress, true);
    int shown = exit_done;
    settings.finished = [&](std::optional<sweep::Descriptor> written) {
      progress.wipe();
      stop_at_once();
      shown = show_written(arguments, std::move(written), output);
    };
    const sweep::RunEnd end = sweep::merge(arguments.files, settings);
    return end == sweep::RunEnd::stopped ? 128 + stop_signal() : shown;
  });
}

// Runs a step that reads results. A file that is no result is bad input.
template <class Step>
int told_of_results(const std::vector<std::string>& files, Step&& step) {
  return told([&] {
    try {
      return step();
    } catch (const OutputFailed&) {
      throw;
    } catch (const std::runtime_error& unreadable) {
      const auto part = std::find_if(files.begin(), files.end(), is_shard_or_part);
      if (part == files.end()) throw std::invalid_argument(unreadable.what());
      throw std::invalid_argument(
          *part +
          ": this is a shard or part of a sweep; make a result of it first: of all shards by "
          "`tribocheck sweep merge`, of parts by `tribocheck sweep --resume`");
    }
  });
}

int show_results(const SweepArguments& arguments, OutputStream& output) {
  return told_of_results(arguments.files, [&] {
    return show_result(arguments, sweep::ResultFile(arguments.files.front()), false, output);
  });
}

// --- The command line.

constexpr const char* footer_start =
    R"(A sweep is a scene in TOML with, in place of any number or word:
  [1e-8, 2e-8], ["eyring", "limiting"]                    a grid: each value with all others
  { from = 1e-8, to = 1e-7, count = 9, spacing = "lin" }  likewise; "log" unless told
  { distribution = "uniform", from = 0.01, to = 0.03 }    also "log_uniform"
  { distribution = "normal", mean = 0.02, sd = 0.001 }    with from and to: truncated
  { distribution = "log_normal", median = 0.02, log_sd = 0.1 }  likewise
  { printed = "0.0202" }                                  uniform, half a last digit to both sides
and, if anything is not as it should be, a table [sweep] with
)";
constexpr const char* footer_end =
    R"(A sweep of more than some seconds goes to OUT.part-F-L, part by part: after a crash or Ctrl-C --resume
goes on there, and ends in the same file to the bit. The same for any number of threads and ranks:
  mpirun -n 4 tribocheck sweep SWEEP.toml -o SWEEP.h5
without MPI, for any number of processes, begun on any machines that see the file at any time:
  tribocheck sweep SWEEP.toml -o SWEEP.h5 --join
and for shards, which any machine may compute, and which are then merged.
Exit code 0: done; 1: failed, or a film was not solved, and what is computed is kept; 2: bad usage or
input; 130: stopped by Ctrl-C.

Example:
  tribocheck sweep reference/published/sweeps/onset_smooth.toml -o smooth.h5 --pictures pictures
  tribocheck sweep reference/published/sweeps/film_map.toml --estimate
  tribocheck sweep reference/published/sweeps/film_map.toml --shard 1/2 -o first.shard
  tribocheck sweep reference/published/sweeps/film_map.toml --shard 2/2 -o second.shard
  tribocheck sweep merge first.shard second.shard -o film_map.h5
  tribocheck sweep reference/published/sweeps/film_map.toml --case 7 | tribocheck solve -)";

constexpr const char* merge_footer = R"(Example:
  tribocheck sweep reference/published/sweeps/film_map.toml --shard 1/2 -o first.shard
  tribocheck sweep reference/published/sweeps/film_map.toml --shard 2/2 -o second.shard
  tribocheck sweep merge first.shard second.shard -o film_map.h5)";

constexpr const char* show_footer = R"(Example:
  tribocheck sweep reference/published/sweeps/film_map.toml -o film_map.h5
  tribocheck sweep show film_map.h5 --format csv
  tribocheck sweep show film_map.h5 --cases --format csv > points.csv)";

constexpr const char* diff_footer =
    R"(Numbers differ where |a - b| exceeds the tolerance times the greater of |a| and |b|; with 0, where any bit
differs. A sensitivity index is a part of 1: its difference is |a - b|. An undefined number equals an
undefined one, and differs from all others, as words do. Where a result keeps no cases, the summaries are
compared. Exit code 0: no number differs; 1: some do; 2: the results cannot be compared, as they have other
scenes, columns or numbers of cases.

Example:
  tribocheck sweep reference/published/sweeps/onset_smooth.toml -o smooth.h5
  tribocheck sweep reference/published/sweeps/onset_smooth.toml -o without.h5 --without-fma
  tribocheck sweep diff smooth.h5 without.h5 --tolerance 1e-12)";

std::string footer() {
  std::string text = footer_start;
  for (const sweep::SweepField& field : sweep::sweep_fields())
    text += fmt::format("  {:<12} {}\n{:15}allowed: {}; default: {}\n", field.name, field.meaning,
                        "", field.allowed, field.default_text);
  return text + footer_end;
}

void add_output_options(CLI::App& app, SweepArguments& arguments) {
  app.add_option("--format", arguments.format, "of the summaries on stdout (default: table)")
      ->check(CLI::IsMember({"table", "csv", "json"}));
  app.add_option(
      "--pictures", arguments.pictures,
      "draw what there is to draw into this folder, as SVG and PNG (needs gnuplot and python3)");
}

}  // namespace

Command add_sweep(CLI::App& program) {
  CLI::App* app = program.add_subcommand("sweep", sweep_description);
  app->footer(footer_with_scenes(footer()));
  const auto arguments = std::make_shared<SweepArguments>();
  app->add_option("SWEEP", arguments->files, "sweep files in TOML; - is stdin");
  app->add_option("-o,--out", arguments->run.result,
                  "the result, an HDF5 file (with --shard a shard)");
  add_output_options(*app, *arguments);
  app->add_option("--threads", arguments->run.threads,
                  "threads of each process (default: all that it may run on; under mpirun 1)")
      ->check(CLI::Range(1, 4096));
  add_strict_option(*app, arguments->is_strict);
  app->add_flag("--estimate", arguments->estimate,
                "only say how many points, how long, how much memory and how large a file");
  app->add_option("--case", arguments->one_case,
                  "only print this case as a scene, by its number in `sweep show --cases`");
  CLI::Option* const resume =
      app->add_flag("--resume", arguments->run.resume, "go on with what a stopped run has left");
  CLI::Option* const force =
      app->add_flag("--force", arguments->run.force,
                    "throw away parts that are there, and replace a result by the new one")
          ->excludes(resume);
  app->add_flag("--join", arguments->run.join,
                "help processes that compute the same result, or begin it")
      ->excludes(resume)
      ->excludes(force);
  app->add_option("--shard", arguments->shard, "only part I of N, written I/N, for `sweep merge`");
  app->add_flag("--without-fma", arguments->without_fma,
                "compute as a processor without fused multiply-add does, to the last digit");
  app->add_flag("--mixed-fma", arguments->run.mixed_fma,
                "with --resume: also take parts of processors that differ in fused multiply-add");

  const auto merged = std::make_shared<SweepArguments>();
  CLI::App* merge = app->add_subcommand("merge", "put shards together");
  merge->add_option("SHARD", merged->files, "all shards of one sweep")->required();
  merge->add_option("-o,--out", merged->run.result, "the result, an HDF5 file")->required();
  merge->add_flag("--force", merged->run.force, "replace a result that is there");
  merge->add_flag("--mixed-fma", merged->run.mixed_fma,
                  "also shards of processors with and without fused multiply-add");
  add_output_options(*merge, *merged);
  merge->footer(footer_with_scenes(merge_footer));

  const auto shown = std::make_shared<SweepArguments>();
  CLI::App* show = app->add_subcommand("show", "tell what a result holds, and draw it");
  show->add_option("RESULT", shown->files, "a result, an HDF5 file")->required()->expected(1);
  add_output_options(*show, *shown);
  show->add_flag("--cases", shown->cases,
                 "each point in place of the summaries: what varies, the speed, the outputs");
  show->footer(footer_with_scenes(show_footer));

  const auto compared = std::make_shared<SweepDiffArguments>();
  CLI::App* diff = add_sweep_diff(*app, *compared);
  diff->footer(footer_with_scenes(diff_footer));

  return {
      app,
      [=](OutputStream& output) {
        if (merge->parsed()) return merge_shards(*merged, output);
        if (diff->parsed())
          return told_of_results(compared->files, [&] { return diff_sweeps(*compared, output); });
        if (show->parsed()) return show_results(*shown, output);
        return run_sweep(*arguments, output);
      },
      [arguments]() -> std::vector<Ignored> {
        return {
            {{"--format", "--pictures", "--shard", "--resume", "--join", "--force", "--mixed-fma"},
             arguments->estimate,
             "with --estimate, which writes nothing"},
            {{"-o", "--format", "--pictures", "--threads", "--strict", "--estimate", "--resume",
              "--force", "--join", "--shard", "--without-fma", "--mixed-fma"},
             arguments->one_case.has_value(),
             "with --case, which only prints a scene"},
            {{"--format", "--pictures"},
             !arguments->shard.empty(),
             "with --shard, as `sweep merge` shows the result"},
            {{"--mixed-fma"}, !arguments->run.resume && !arguments->run.join, "without --resume"}};
      }};
}

}  // namespace tribo::cli
