// SPDX-License-Identifier: Apache-2.0
// tribocheck film: solves contacts, and writes each formula's film beside the solved film.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "film_case.hpp"
#include "film_command.hpp"
#include "kept_films.hpp"
#include "messages.hpp"
#include "options.hpp"
#include "picture.hpp"
#include "prepared_scenes.hpp"
#include "progress.hpp"
#include "scene_arguments.hpp"
#include "stop_signal.hpp"
#include "sweep/needs_text.hpp"
#include "sweep/on_threads.hpp"
#include "sweep/output_file.hpp"
#include "sweep/plan.hpp"
#include "table.hpp"

namespace tribo::cli {
namespace {

struct FilmArguments {
  SceneArguments scenes;
  FilmSettings settings;
  double speed = 0;  // 0: the scene's
  int threads = 1;
  bool with_profile = false, estimate = false;
  std::string picture, fields, keep;
  WriteFields write_fields = nullptr;
};

bool is_csv(const std::string& name) { return std::filesystem::path(name).extension() == ".csv"; }

// The good scenes, at the speeds that are asked for.
LoadedScenes scenes_of(const FilmArguments& arguments) {
  bool has_supply = false;
  LoadedScenes loaded = load_scenes(arguments.scenes.paths, SceneUse::film, [&](Scene& scene) {
    has_supply |= has_supply_of_film(scene);
    return prepare_film(scene, arguments.speed, arguments.settings);
  });
  if (arguments.settings.is_flooded && !has_supply) {
    complain(fmt::format("--flooded {}", no_supply_of_film));
    loaded.scenes.clear();
  }
  return loaded;
}

// A scene at one of its speeds.
struct Contact {
  const Scene* scene;
  double speed;

  std::string name() const { return fmt::format("{} at {} m/s", scene->id, readable(speed)); }
};

class FilmRun {
 public:
  // Opens the file for fields and the file in which films are kept, so that the user is told before
  // the solve if that is not possible. Throws sweep::RunRefused if something else is there.
  FilmRun(const FilmArguments& arguments, std::size_t total, OutputStream& output)
      : arguments_(arguments),
        total_(total),
        output_(output),
        writer_(arguments.scenes.format, arguments.with_profile, output.text()) {
    if (!arguments.fields.empty()) fields_.emplace(sweep::output_behind_links(arguments.fields));
    if (!arguments.keep.empty()) kept_.emplace(sweep::output_behind_links(arguments.keep));
  }

  // Solves a film, or takes a kept one, and shows it as soon as all films before it are shown.
  // Several threads may call this at once; `place` counts the contacts from 0 on. Does nothing
  // after Ctrl-C.
  void solve(const Contact& contact, std::size_t place) {
    std::unique_lock lock(mutex_);
    if (stop_signal() != 0) return;
    Result result{.name = contact.name(), .shown = {}, .film = {}, .is_stopped = false};
    const std::string key = kept_ ? key_of(contact) : "";
    if (const KeptFilm* const kept = kept_ ? kept_->find(key) : nullptr) {
      ++taken_;
      result.shown = *kept;
    } else {
      lock.unlock();
      FilmCase film =
          solve_film(*contact.scene, contact.speed, arguments_.settings, [&](int cells, int step) {
            const std::lock_guard watching(mutex_);
            if (line_.is_due())
              line_.show(fmt::format("{} ({} of {}): grid of {} cells, step {} of Newton's method",
                                     printable(result.name), place + 1, total_, cells, step + 1));
            return stop_signal() == 0;
          });
      lock.lock();
      line_.wipe();
      result.shown = {film.reason, writer_.text_of(film)};
      result.is_stopped = stop_signal() != 0;
      result.film = std::move(film);
      if (kept_ && !result.is_stopped) keep(key, result.shown);
    }
    waiting_.emplace(place, std::move(result));
    for (; !waiting_.empty() && waiting_.begin()->first == next_; ++next_) show_first();
  }

  int finish(const LoadedScenes& loaded) {
    while (!waiting_.empty()) show_first();
    if (stop_signal() != 0)
      complain(
          fmt::format("stopped: {} of {} contacts are solved to the tolerance", done_, total_) +
          (stopped_.empty() ? "" : "; " + stopped_));
    writer_.finish(loaded.warnings.json());
    output_.flush();
    if (taken_ > 0)
      complain(fmt::format("{} of {} films are taken from {}", taken_, total_, arguments_.keep));
    if (stop_signal() != 0) return 128 + stop_signal();
    const int code = loaded.exit_code(arguments_.scenes);
    return code == exit_done && !all_solved_ ? exit_failed : code;
  }

 private:
  struct Result {
    std::string name;
    KeptFilm shown;
    std::optional<FilmCase> film;  // empty where it was kept
    bool is_stopped;
  };

  std::string key_of(const Contact& contact) const {
    return fmt::format("{} {} {} {}", sweep::numbers_version, arguments_.scenes.format,
                       arguments_.with_profile,
                       key_of_film(*contact.scene, contact.speed, arguments_.settings));
  }

  void show_first() {
    const Result result = std::move(waiting_.begin()->second);
    waiting_.erase(waiting_.begin());
    const std::string& reason = result.shown.reason;
    if (!result.is_stopped || result.film->is_solved) {
      print(result.shown.text);
      if (result.film && result.film->is_solved) draw(*result.film);
    }
    if (!result.is_stopped || reason.empty())
      tell(result.name, reason);
    else if (stopped_.empty())
      stopped_ = result.name + ": " + reason;
  }

  void tell(const std::string& name, const std::string& reason) {
    if (reason.empty()) {
      ++done_;
      return;
    }
    complain(name + ": " + reason);
    all_solved_ = false;
  }

  // Flushes at once, because the next film may take minutes.
  void print(std::string_view film) {
    writer_.add(film);
    output_.flush();
  }

  void draw(const FilmCase& film) {
    if (fields_) write_fields(film);
    if (!arguments_.picture.empty() &&
        !draw_picture("film_picture.py", film_picture_json(film).dump(), arguments_.picture))
      all_solved_ = false;
  }

  void keep(const std::string& key, const KeptFilm& film) {
    try {
      kept_->keep(key, film);
    } catch (const std::runtime_error& error) {
      complain(error.what() + std::string("; the films from here on are not kept"));
      kept_.reset();
      all_solved_ = false;
    }
  }

  void write_fields(const FilmCase& film) {
    try {
      arguments_.write_fields(film, fields_->open_path(), is_csv(arguments_.fields));
      fields_->keep({.any = true, .only = {}});
      complain("wrote " + arguments_.fields);
    } catch (const std::runtime_error& error) {
      complain("cannot write " + arguments_.fields + ": " + error.what());
      all_solved_ = false;
    }
  }

  const FilmArguments& arguments_;
  std::size_t total_, done_ = 0, taken_ = 0;
  bool all_solved_ = true;
  OutputStream& output_;
  FilmWriter writer_;
  std::optional<sweep::PartFile> fields_;
  std::optional<KeptFilms> kept_;
  StepLine line_{std::chrono::milliseconds(500), std::chrono::milliseconds(100)};
  std::mutex mutex_;                       // locked by solve(), except while it solves a film
  std::map<std::size_t, Result> waiting_;  // by place: solved, but not yet shown
  std::size_t next_ = 0;                   // place of the film that is shown next
  std::string stopped_;  // the first film that was being solved at Ctrl-C, and how far it came
};

std::string span(const std::string& from, const std::string& up_to) {
  return from == up_to ? from : from + " to " + up_to;
}

// Contacts of one scene at successive speeds that are refused for the same reason. The numbers in
// the reason may differ.
class RefusedContacts {
 public:
  // Adds a contact. If it is not like those before, these are written first.
  void add(Text& to, const Scene& scene, double speed, const FilmNeeds& needs) {
    const std::string kind = without_numbers(needs.reason);
    if (count_ > 0 && (kind != kind_ || scene.id != id_)) finish(to);
    if (count_++ == 0) {
      first_ = needs;
      id_ = scene.id;
      kind_ = kind;
      from_ = readable(speed);
    }
    last_ = needs;
    up_to_ = readable(speed);
  }

  void finish(Text& to) {
    if (count_ == 0) return;
    const auto numbers = [&](double FilmNeeds::*number) {
      return span(readable(first_.*number), readable(last_.*number));
    };
    append(to, fmt::format("{} at {} m/s{}: M = {}, L = {}, {}, {}, to {}: refused{}: {}\n",
                           printable(id_), span(from_, up_to_),
                           count_ == 1 ? "" : fmt::format(" ({} speeds)", count_),
                           numbers(&FilmNeeds::load_number), numbers(&FilmNeeds::material_number),
                           first_.viscosity, first_.density, readable(first_.tolerance),
                           count_ == 1 ? "" : ", the first because", first_.reason));
    count_ = 0;
  }

 private:
  static std::string without_numbers(std::string_view text) {
    std::string kind;
    for (const char c : text)
      if (std::string_view("0123456789.+-e").find(c) == std::string_view::npos) kind += c;
    return kind;
  }

  std::size_t count_ = 0;
  FilmNeeds first_{}, last_{};
  std::string id_, kind_, from_, up_to_;
};

// Tells what all contacts will take, and solves none.
int estimate_films(const FilmArguments& arguments, const LoadedScenes& loaded,
                   OutputStream& output) {
  Text& to = output.text();
  RefusedContacts refused;
  FilmNeeds::Grids least{}, most{};
  std::size_t count = 0;
  for (const Scene& scene : loaded.scenes)
    for (std::size_t i = 0; i < scene.speeds.size(); ++i) {
      const FilmNeeds needs = needs_of_film(scene, scene.speeds[i], arguments.settings);
      if (!needs.reason.empty()) {
        refused.add(to, scene, scene.speeds[i], needs);
        continue;
      }
      refused.finish(to);
      append(to, fmt::format(
                     "{} at {} m/s: M = {}, L = {}, {}, {}, to {}: {} grids, the finest of "
                     "{} nodes\n",
                     printable(scene.id), readable(scene.speeds[i]), readable(needs.load_number),
                     readable(needs.material_number), needs.viscosity, needs.density,
                     readable(needs.tolerance),
                     span(fmt::to_string(needs.least.count), fmt::to_string(needs.most.count)),
                     span(fmt::to_string(needs.least.nodes), fmt::to_string(needs.most.nodes))));
      ++count;
      for (const auto& [sum, one] : {std::pair{&least, &needs.least}, {&most, &needs.most}}) {
        sum->seconds += one->seconds;
        sum->memory = std::max(sum->memory, one->memory);
      }
    }
  refused.finish(to);
  const std::size_t threads = std::clamp<std::size_t>(static_cast<std::size_t>(arguments.threads),
                                                      1, std::max<std::size_t>(count, 1));
  const auto at_once = static_cast<double>(threads);
  append(to, fmt::format("contacts {}\n", count));
  append(to, fmt::format("time   {} on {} thread{}, roughly\n",
                         span(sweep::time_text(least.seconds / at_once),
                              sweep::time_text(most.seconds / at_once)),
                         threads, threads == 1 ? "" : "s"));
  append(to, fmt::format("memory {}\n", span(sweep::bytes_text(at_once * least.memory),
                                             sweep::bytes_text(at_once * most.memory))));
  output.flush();
  return loaded.exit_code(arguments.scenes);
}

int solve_films(const FilmArguments& arguments, OutputStream& output) {
  const LoadedScenes loaded = scenes_of(arguments);
  if (loaded.scenes.empty()) return exit_bad;
  if (arguments.estimate) return estimate_films(arguments, loaded, output);
  if (!loaded.all_good && arguments.with_profile)
    return fail(exit_bad,
                "--profile takes no file, and prints nothing where a scene is bad; it writes to "
                "stdout, as in `--profile --format csv > profiles.csv`");
  std::vector<Contact> contacts;
  for (const Scene& scene : loaded.scenes)
    for (std::size_t i = 0; i < scene.speeds.size(); ++i)
      contacts.push_back({&scene, scene.speeds[i]});
  if (contacts.size() > 1)
    for (const auto& [file, words] :
         {std::pair{&arguments.picture, "--picture draws"}, {&arguments.fields, "--fields writes"}})
      if (!file->empty())
        return fail(exit_bad,
                    fmt::format("{} one contact, and this would be {}; allowed: one scene, "
                                "and one speed, as by --speed",
                                words, contacts.size()));
  if (!arguments.fields.empty() && is_of_line(loaded.scenes.front()))
    return fail(exit_bad,
                fmt::format("--fields writes pressure and film over a circle or an ellipse, and {} "
                            "is a line contact; allowed: --profile",
                            printable(loaded.scenes.front().id)));
  watch_for_stop();
  try {
    FilmRun run(arguments, contacts.size(), output);
    each_on_threads(arguments.threads, contacts.size(),
                    [&](std::size_t place) { run.solve(contacts[place], place); });
    return run.finish(loaded);
  } catch (const sweep::RunRefused& refused) {
    return fail(exit_bad, refused.what());
  }
}

constexpr const char* film_footer =
    R"(The contact is smooth, the liquid steady, isothermal and Newtonian, and the inlet flooded, unless the
scene of a circle or an ellipse has a [supply]: then a layer of oil of thickness h_oil meets the contact, and the gap
is filled where the oil reaches. Its flooded film is solved too, and each closure of starvation stands beside the ratio of
the two; oil that flows back into the track behind the contact is not modelled. A scene
needs its load, bodies, speed, lubricant.viscosity and lubricant.pressure_viscosity, and
friction.viscosity is taken where it is barus or roelands. With lubricant.eyring_stress the friction of the oil is given
too, by friction.fluid and friction.slide_roll_ratio. The other fields may be absent and are not used.

Each number is followed by what the numerical solution may be off by (±, in CSV and JSON `error`), as
grids that halve their cells show it. Another liquid changes the film by far more: `--viscosity
roelands --density dowson_higginson` solves a real oil, whose film is often a tenth thinner than that of the default, incompressible
liquid. `deviation` is how far a formula's film is from the solved film that it stands for, of the
liquid that the formula was fitted to, which is solved as well: it tells how good the formula is. Beside it stands how far
it is from this contact's own film. Where no text tells which liquid that was, there is no deviation.
Lengths in m, pressures in Pa. M and L are Moes' numbers of load and
material; x is along the direction of entrainment, from the middle of Hertz' contact. A profile is
that of the finest grid; the films are extrapolated from all grids, and so are nearer to the truth.

Bodies may meet along a line, at a circle or at an ellipse. Films of circles and ellipses are solved on plane
grids, to 0.1 % (the minimum film to 0.3 %) unless --tolerance asks for another error. At M up to 200 this takes
1 to 30 seconds, seldom two minutes, beyond M = 1000 up to some minutes and 1.7 GB; with `--tolerance 1e-2` it takes a fraction. Their profile is
that of the middle, y = 0; --picture draws it below film and pressure over the whole contact, and --fields writes these. A circle's bodies.ellipticity is not used: the axes follow from the radii.

With lubricant.pressure_viscosity = 0 the liquid's viscosity is constant; formulas without a film for
such a liquid are empty. Where Roelands' z is outside 0.2 to 1.2, a
warning says so.

A line takes some tenths of a second, and less with a larger tolerance; a scene of 200 speeds is
200 contacts. With --threads 4 four contacts are solved at once, in the memory of four; what is printed stays
the same. Ctrl-C stops at the next step, which takes up to some ten seconds on fine plane grids,
and what was solved is written. With --keep FILE each film is kept there too, as it is printed; the same
command again, or one with more scenes or speeds, takes those films from the file and solves the others. A
film that was kept in another --format, or with other settings, is solved anew.

Exit code 0: done; 1: a contact was not solved, or not to the tolerance, or the picture is missing;
2: bad usage or input; 130: stopped by Ctrl-C.

Example:
  tribocheck film reference/scenes/roller.toml
  tribocheck film reference/scenes/roller.toml --format csv > films.csv
  tribocheck film reference/scenes/ball_on_flat.toml --speed 1
  tribocheck film reference/scenes/ball_on_flat.toml --speed 1 --picture ball.png --fields ball.h5
  tribocheck film reference/scenes/gear_flank.toml --speed 2 --density dowson_higginson
  tribocheck film reference/scenes/ball_on_flat.toml --estimate
  tribocheck film reference/scenes/roller.toml --format csv --keep roller.films > films.csv
  tribocheck film reference/scenes/roller.toml --speed 0.5 --picture roller.png
  tribocheck film reference/scenes/roller.toml --profile --format csv > profiles.csv)";

void add_settings(CLI::App& app, FilmSettings& settings) {
  app.add_option(
         "--viscosity", settings.viscosity,
         "law of viscosity against pressure: barus or roelands (default: friction.viscosity of "
         "the scene where it is one of these, else barus)")
      ->check(CLI::IsMember({"barus", "roelands"}));
  app.add_option("--density", settings.density,
                 "incompressible or dowson_higginson (default: incompressible)")
      ->check(CLI::IsMember({"incompressible", "dowson_higginson"}));
  app.add_flag("--flooded", settings.is_flooded,
               "take the inlet as flooded, whatever [supply] says; the inlet of a line always is");
  add_number_option(
      app, "--tolerance", [&settings](double tolerance) { settings.tolerance = tolerance; },
      is_film_tolerance, std::string(film_tolerance_allowed),
      "relative error of the films, 1e-6 to 1e-2 (default: 1e-4 of a line, 1e-3 of a circle or an "
      "ellipse)");
}

}  // namespace

Command add_film(CLI::App& program) { return film_command(program, nullptr); }

Command film_command(CLI::App& program, WriteFields write) {
  CLI::App* app = program.add_subcommand(
      "film", "contacts solved: film and pressure, and each formula's error");
  app->footer(footer_with_scenes(film_footer));
  const auto arguments = std::make_shared<FilmArguments>();
  add_scene_arguments(*app, arguments->scenes);
  add_settings(*app, arguments->settings);
  add_speed_option(*app, [arguments](double speed) { arguments->speed = speed; });
  app->add_flag(
      "--profile", arguments->with_profile,
      "print pressure and film at each node of the grid too, from the first of the inlet on, "
      "far in front of the contact; in CSV in place of the films");
  add_picture_option(*app, arguments->picture, "pressure and film of one contact");
  app->add_option("--threads", arguments->threads,
                  "contacts that are solved at once, each in the memory of one (default: 1)")
      ->check(CLI::Range(1, 1024));
  app->add_flag("--estimate", arguments->estimate,
                "print grids, time and memory that the films will take, and solve none");
  arguments->write_fields = write;
  CLI::Option* const fields_option =
      app->add_option(
             "--fields", arguments->fields,
             "write x, y, p(x, y) and h(x, y) of one circle or ellipse, as on the finest grid, "
             "in SI units: a file .h5 (HDF5) or .csv")
          ->check([](const std::string& name) {
            return is_csv(name) || std::filesystem::path(name).extension() == ".h5"
                       ? std::string()
                       : name + " is not allowed; allowed: a name that ends in .h5 or .csv";
          });
  app->add_option("--keep", arguments->keep,
                  "keep each film in this file as soon as it is solved, and take from it the films "
                  "that an earlier run has kept")
      ->excludes(fields_option)
      ->excludes("--picture");
  return {app,
          [arguments](OutputStream& output) {
            arguments->settings.with_fields =
                !arguments->picture.empty() || !arguments->fields.empty();
            return solve_films(*arguments, output);
          },
          [arguments]() -> std::vector<Ignored> {
            return {{{"--format", "--profile", "--picture", "--fields", "--keep"},
                     arguments->estimate,
                     "with --estimate, which solves nothing"}};
          }};
}

}  // namespace tribo::cli
