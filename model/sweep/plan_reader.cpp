// SPDX-License-Identifier: Apache-2.0
#include "sweep/plan_reader.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "scene/entries.hpp"
#include "scene/input_text.hpp"
#include "scene/schema.hpp"
#include "scene/text.hpp"
#include "sweep/correlation.hpp"
#include "sweep/plan.hpp"
#include "sweep/sensitivity.hpp"
#include "sweep/table_reader.hpp"
#include "sweep/variable_reader.hpp"
#include "tribo/onset.hpp"
#include "tribo/version.hpp"

namespace tribo::sweep {
namespace {

using scene_detail::Entry;
using scene_detail::Problems;
using scene_detail::Value;
using scene_detail::ValueKind;

constexpr auto keep_names = std::to_array<std::string_view>({"points", "summaries"});

const std::string list_of_criteria =
    "a list of " + scene_detail::joined(onset_criterion_words, ", ");

const auto fields = std::to_array<SweepField>({
    {"design", "sobol, latin_hypercube, monte_carlo; factorial where all that varies is a grid",
     "sobol", "how the distributions are drawn from; grids are always crossed in full"},
    {"draws", "a whole number from 1 to 1e12", "16384",
     "for each set of grid values; with sensitivity, of each of its two matrices"},
    {"seed", "a whole number from 0 to 9007199254740992", "1", "of the draws"},
    {"onset", list_of_criteria, "none",
     "the onset's speed, film and film parameter by these criteria; with it, operating "
     "points are computed only where the scene lists `outputs`"},
    {"departure", "a number above 0 and below 1", "0.05", "the ε of film_departure"},
    {"solved_film", "true or false", "false",
     "of lines: the flooded film solved, with its error, in some tenths of a second a point; with "
     "it, "
     "operating points are computed only where the scene lists `outputs`"},
    {"sensitivity", "true or false", "false",
     "Sobol indices of the drawn fields, which have to be independent, without grids"},
    {"correlated", "a list of drawn fields", "none", "the fields of the correlation matrix"},
    {"correlation", "a list of its rows", "none",
     "correlations of the normals behind the draws (a Gaussian copula)"},
    {"keep", "points or summaries", "points", "what the result holds of each case"},
});

std::vector<std::string_view> field_names() {
  std::vector<std::string_view> names;
  for (const SweepField& field : fields) names.push_back(field.name);
  return names;
}
std::string_view allowed(std::string_view name) {
  for (const SweepField& field : fields)
    if (field.name == name) return field.allowed;
  return "";
}

// Fields that the scene reader checks together: radii of faces (double must hold their ellipse of
// contact), the moments of a profile, Roelands' law, and an oil's viscosity by temperature.
constexpr auto faces =
    std::to_array<std::string_view>({"bodies.first_radius_x", "bodies.second_radius_x",
                                     "bodies.first_radius_y", "bodies.second_radius_y"});
constexpr auto radii = std::to_array<std::string_view>({"bodies.radius_x", "bodies.radius_y"});
constexpr auto moments =
    std::to_array<std::string_view>({"surface.m0", "surface.m2", "surface.m4"});
constexpr auto roelands =
    std::to_array<std::string_view>({"lubricant.viscosity", "friction.viscosity"});
constexpr auto oil =
    std::to_array<std::string_view>({"lubricant.iso_vg", "lubricant.viscosity_index",
                                     "lubricant.temperature", "friction.viscosity"});
constexpr auto fields_of_rules =
    std::to_array<std::span<const std::string_view>>({faces, radii, moments, roelands, oil});

// A variable, and the place of its field in the list of entries.
struct VariedEntry {
  std::size_t entry;
  Variable variable;
};

class SweepBinder {
 public:
  // `problems` adds to `reading`, whose scene is not used. `passed` gets the passed limits.
  SweepBinder(std::vector<Entry> entries, const std::string& source, SceneReading& reading,
              Problems& problems, std::vector<Validity>& passed)
      : entries_(std::move(entries)),
        source_(source),
        reading_(reading),
        problems_(problems),
        passed_(passed) {}

  // The sweep; nothing where an error was reported.
  std::optional<SceneSweep> bind() {
    take_sweep_table();
    take_variables();
    take_settings();
    if (ok()) take_scene();
    if (ok()) {
      check_extremes();
      take_correlation();
      check_combinations();
    }
    if (ok()) check_size();
    if (!ok()) return std::nullopt;
    lay_out(sweep_);
    return std::move(sweep_);
  }

 private:
  bool ok() const { return !problems_.any(); }
  void error(std::string_view field, Fault fault) { problems_.error(field, std::move(fault)); }
  void error(std::string_view field, std::string what, std::string allowed) {
    error(field, {Fault::other, "", std::move(what), std::move(allowed)});
  }

  // --- Takes the table [sweep], and the fields that vary, out of the entries.

  void take_sweep_table() {
    const Entry* const found = entry_of(entries_, "sweep");
    if (found == nullptr) return;
    if (found->value.kind != ValueKind::table)
      error("sweep", "not a table", "a table with the fields of [sweep]");
    settings_ = *found;
    entries_.erase(entries_.begin() + (found - entries_.data()));
  }
  const Entry* setting(std::string_view name) const { return entry_of(settings_.inner, name); }

  void take_variables() {
    gather_speed();
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const auto place = scene_detail::find_field(entries_[i].path);
      if (!place || !varies(entries_[i])) continue;
      const FieldInfo& field = scene_fields()[*place];
      if (field.type == FieldType::viscosities) refuse_pairs(entries_[i]);
      if (scene_detail::store_of(*place) == nullptr) continue;
      if (field.type == FieldType::speeds && !speed_is_drawn_) continue;
      if (auto variable = read_variable(entries_[i], field, problems_)) {
        entries_[i] = {entries_[i].path, value_for(*variable, variable->nominal), {}, {}};
        varied_.push_back({i, std::move(*variable)});
      }
    }
    // Grids first, then the schema's order: the order of the file is not known any more.
    std::ranges::sort(varied_, {}, [](const VariedEntry& varied) {
      return std::pair(varied.variable.is_drawn(), scene_detail::field_at(varied.variable.path));
    });
    if (varied_.size() > most_variables)
      error("", {.what = "more than " + std::to_string(most_variables) + " fields vary"});
  }

  // Refuses a table among the pairs of temperature and viscosity, because these do not vary.
  void refuse_pairs(const Entry& pairs) {
    const auto is_table = [](const auto& one) { return one.kind == ValueKind::table; };
    const auto has_table = [&](const Entry& pair) {
      return is_table(pair.value) || std::ranges::any_of(pair.elements, is_table);
    };
    if (has_table(pairs) || std::ranges::any_of(pairs.inner, has_table))
      error(pairs.path, "its pairs do not vary",
            "lubricant.viscosity alone, or lubricant.iso_vg and lubricant.viscosity_index with "
            "lubricant.temperature, each of which may vary");
  }

  // Puts the fields of a drawn `speed` into its entry. The schema gives them entries of their own.
  void gather_speed() {
    constexpr std::string_view prefix = "speed.";
    const auto is_part = [&](const Entry& entry) { return entry.path.starts_with(prefix); };
    speed_is_drawn_ = entry_of(entries_, "speed.distribution") != nullptr ||
                      entry_of(entries_, "speed.printed") != nullptr;
    if (!speed_is_drawn_) return;
    std::vector<Entry> parts;
    std::copy_if(entries_.begin(), entries_.end(), std::back_inserter(parts), is_part);
    std::erase_if(entries_, is_part);
    for (Entry& part : parts) part.path.erase(0, prefix.size());
    for (Entry& entry : entries_)
      if (entry.path == "speed") entry.inner = parts;
  }

  // --- The table [sweep].

  void take_settings() {
    const std::vector<std::string_view> names = field_names();
    TableReader table("sweep", settings_.inner, names, problems_);
    sweep_.draws = default_draws;
    sweep_.departure = default_departure;
    if (const auto design = table.word("design", design_names))
      sweep_.design = static_cast<Design>(*design);
    if (const auto draws = table.whole("draws", 1, most_cases, allowed("draws")))
      sweep_.draws = *draws;
    if (const auto seed = table.whole("seed", 0, std::uint64_t{1} << 53, allowed("seed")))
      sweep_.seed = *seed;
    if (const auto criteria = table.words("onset", onset_criterion_words))
      for (const std::size_t place : *criteria)
        sweep_.criteria.push_back(static_cast<OnsetCriterion>(place));
    if (const auto departure = table.number("departure", allowed("departure"))) {
      if (*departure > 0 && *departure < 1)
        sweep_.departure = *departure;
      else
        table.refuse("departure", {Fault::range, scene_detail::number_text(*departure), "",
                                   std::string(allowed("departure"))});
    }
    sweep_.solves_film = table.boolean("solved_film").value_or(false);
    sweep_.sensitivity = table.boolean("sensitivity").value_or(false);
    if (const auto keep = table.word("keep", keep_names)) sweep_.keep_points = *keep == 0;
  }

  // --- The scene with nominal values.

  void take_scene() {
    asks_points_ = (sweep_.criteria.empty() && !sweep_.solves_film) ||
                   entry_of(entries_, "outputs") != nullptr;
    SceneReading scene = bound(entries_);
    reading_.errors = std::move(scene.errors);
    reading_.warnings = std::move(scene.warnings);
    if (!scene.scene) return;
    if (varied_.empty())  // not said of a wrong scene: its error may hide a variable
      return error("", "nothing varies",
                   "a grid or a distribution in place of a number, as in "
                   "viscosity = { distribution = \"uniform\", from = 0.01, to = 0.03 }");
    sweep_.scene = std::move(*scene.scene);
    note_limits(sweep_.scene);
    if (!scene.id && source_ != "-") sweep_.scene.id = scene_detail::stem_of(source_);
    if (asks_points_) sweep_.outputs = sweep_.scene.outputs;
    check_id();
    for (const VariedEntry& varied : varied_) sweep_.variables.push_back(varied.variable);
  }

  SceneUse use() const {
    if (asks_points_) return SceneUse::speeds;
    return sweep_.criteria.empty() ? SceneUse::line_film : SceneUse::onset;
  }

  SceneReading bound(const std::vector<Entry>& entries) const {
    SceneReading reading;
    Problems problems(reading, source_);
    scene_detail::bind_scene(entries, use(), problems, reading);
    return reading;
  }

  void note_limits(const Scene& scene) {
    for (const Validity& limit : passed_limits(scene, use()))
      if (std::ranges::find(passed_, limit.word, &Validity::word) == passed_.end())
        passed_.push_back(limit);
  }

  void check_id() {
    const std::string& id = sweep_.scene.id;
    if (!id.empty() && id != "." && id.find('/') == std::string::npos &&
        id.find('\0') == std::string::npos && id.size() <= 200)
      return;
    error("id", '"' + printable(id) + "\" cannot name a group of the result",
          "up to 200 bytes without \"/\", not empty and not \".\"");
  }

  // --- The values of the variables, each alone and with those of variables that share a rule.

  struct Setting {
    const VariedEntry* varied;
    double value;
  };

  void check_extremes() {
    bool all_good = true;
    for (const VariedEntry& varied : varied_)
      for (const double value : values_to_check(varied.variable))
        if (!check({{&varied, value}})) {
          all_good = false;
          break;
        }
    for (const auto& together : fields_of_rules)
      if (all_good) check_together(together);
  }

  // If these values are legal, so are all others of the variable, because legal numbers form one
  // interval. Only radii of faces form two, below 0 and above. In each of them 1/R, which the rule
  // of two faces adds up, is monotonic. For whole numbers and words, all values are checked.
  static std::vector<double> values_to_check(const Variable& variable) {
    const FieldInfo& field = scene_fields()[scene_detail::field_at(variable.path)];
    if (variable.is_drawn()) {
      const double least = variable.distribution.least();
      const double greatest = variable.distribution.greatest();
      if (field.is_radius_of_face && least < 0 && greatest > 0) return {0};
      return {least, greatest};
    }
    const std::vector<double>& grid = variable.grid;
    if (!variable.words.empty() || field.type == FieldType::integer) return grid;
    const auto [least, greatest] = std::minmax_element(grid.begin(), grid.end());
    std::vector<double> values{*least, *greatest};
    if (!field.is_radius_of_face || *least > 0) return values;
    double below = *least, above = *greatest;
    for (const double value : grid) {
      if (value == 0) return {0};
      if (value < 0) below = std::max(below, value);
      if (value > 0) above = std::min(above, value);
    }
    values.insert(values.end(), {below, above});
    return values;
  }

  // Checks the fields of one rule that vary, in all combinations of their values to check.
  void check_together(std::span<const std::string_view> paths) {
    std::vector<std::vector<Setting>> sets{{}};
    std::size_t count = 0;
    for (const VariedEntry& varied : varied_) {
      if (std::find(paths.begin(), paths.end(), varied.variable.path) == paths.end()) continue;
      ++count;
      std::vector<std::vector<Setting>> longer;
      for (const std::vector<Setting>& set : sets)
        for (const double value : values_to_check(varied.variable)) {
          longer.push_back(set);
          longer.back().push_back({&varied, value});
        }
      sets = std::move(longer);
    }
    if (count < 2) return;
    for (const std::vector<Setting>& set : sets)
      if (!check(set)) return;
  }

  void set(const VariedEntry& varied, double value) {
    entries_[varied.entry].value = value_for(varied.variable, value);
  }

  // Is the scene legal with these values?
  bool check(const std::vector<Setting>& settings) {
    for (const Setting& one : settings) set(*one.varied, one.value);
    const SceneReading scene = bound(entries_);
    for (const Setting& one : settings) set(*one.varied, one.varied->variable.nominal);
    for (const InputProblem& warning : scene.warnings)
      if (std::ranges::find(reading_.warnings, warning.line(), &InputProblem::line) ==
          reading_.warnings.end())
        reading_.warnings.push_back(warning);
    // The ends of a distribution are not noted: they lie far beyond nearly all of its draws.
    if (scene.scene && settings.size() == 1 && !settings.front().varied->variable.is_drawn())
      note_limits(*scene.scene);
    if (scene.errors.empty()) return true;
    const auto& [source, field, found, row, column] = scene.errors.front();
    const Setting& first = settings.front();
    const Variable& variable = first.varied->variable;
    const bool is_own = settings.size() == 1 && field == variable.path;
    const bool is_of_limits = found.rule == Fault::range || found.rule == Fault::result;
    if (is_own && variable.is_drawn() && is_of_limits) {
      error(field, reach(variable, first.value, found.allowed));
    } else {
      Fault fault = found;
      const bool is_of_grid = is_own && !variable.is_drawn();
      fault.where = is_of_grid ? "a value of its grid: " : where_text(settings);
      error(field, std::move(fault));
    }
    return false;
  }

  // "where surface.m0 is 1e-15 and surface.m2 is 1e-3: "
  static std::string where_text(const std::vector<Setting>& settings) {
    std::string text;
    for (const Setting& one : settings) {
      const Variable& variable = one.varied->variable;
      text += text.empty() ? "where " : " and ";
      text += variable.path + (variable.is_drawn() ? " reaches " : " is ");
      text += variable.is_drawn()      ? scene_detail::rounded_text(one.value)
              : variable.words.empty() ? scene_detail::number_text(one.value)
                                       : variable.words[static_cast<std::size_t>(one.value)];
    }
    return text + ": ";
  }

  // The fault of a distribution that reaches beyond its field's range.
  static Fault reach(const Variable& variable, double value, const std::string& allowed) {
    const bool is_printed = variable.text.starts_with("printed");
    const DistributionKind kind = variable.distribution.kind();
    const bool has_tails = kind == DistributionKind::normal || kind == DistributionKind::log_normal;
    const std::string_view end = value < variable.nominal ? "from" : "to";
    return {
        Fault::reach,
        (is_printed ? "this printed number" : "this " + std::string(name(kind)) + " distribution") +
            (value < 0 ? " reaches −" : " reaches ") + scene_detail::rounded_text(std::abs(value)),
        has_tails ? ": truncate it with `" + std::string(end) + "`" + bound_text(variable, value) +
                        beyond_text(variable, value, allowed)
                  : "",
        allowed};
  }

  // Advice on a lower bound, and the part that it cuts off, for a normal distribution with a mean
  // above the least of its field that reaches beyond it. Empty for all others.
  static std::string bound_text(const Variable& variable, double value) {
    const double mean = variable.nominal;
    const double least = scene_fields()[scene_detail::field_at(variable.path)].minimum;
    if (variable.distribution.kind() != DistributionKind::normal ||
        !(value <= least && mean > least))
      return {};
    const double bound = std::max(mean - 0.5 * (mean - value), least + (mean - least) / 100);
    const double part = variable.distribution.part_beyond(bound, false);
    return ", as from = " + scene_detail::rounded_text(bound) + ", which cuts off " +
           scene_detail::rounded_text(part) + " of it" +
           (part > 1e-3 && least == 0 ? ", or take a log_normal distribution" : "");
  }

  // How much of a distribution with tails is beyond the range of its field; empty where the allowed
  // range depends on another field.
  static std::string beyond_text(const Variable& variable, double value,
                                 const std::string& allowed) {
    const FieldInfo& field = scene_fields()[scene_detail::field_at(variable.path)];
    if (allowed != scene_detail::allowed_text(field)) return {};
    const bool above = value > variable.nominal;
    const double part = variable.distribution.part_beyond(
        above ? field.maximum.value_or(value) : field.minimum, above);
    return part > 0 ? "; " + scene_detail::rounded_text(part) + " of it lies beyond that range"
                    : "";
  }

  // --- Correlation.

  void take_correlation() {
    const Entry* const names = setting("correlated");
    const Entry* const rows = setting("correlation");
    if (names == nullptr && rows == nullptr) return;
    if (names == nullptr || rows == nullptr)
      return error(names == nullptr ? "sweep.correlated" : "sweep.correlation",
                   {Fault::presence, "", "", "correlated and correlation, or neither"});
    const auto places = correlated_places(*names);
    if (!ok()) return;
    const auto matrix = matrix_of(*rows, places.size());
    if (!ok()) return;
    std::vector<std::vector<double>> whole(sweep_.drawn(), std::vector<double>(sweep_.drawn(), 0));
    for (std::size_t i = 0; i < whole.size(); ++i) whole[i][i] = 1;
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t j = 0; j < places.size(); ++j) whole[places[i]][places[j]] = matrix[i][j];
    CorrelationRoot root = correlation_root(whole);
    if (!root.fault.empty()) return error("sweep.correlation", root.fault, "a correlation matrix");
    sweep_.correlation_root = std::move(root.rows);
  }

  std::vector<std::size_t> correlated_places(const Entry& entry) {
    std::vector<std::string_view> drawn;
    for (const Variable& variable : sweep_.variables)
      if (variable.is_drawn()) drawn.push_back(variable.path);
    if (drawn.size() < 2) {
      error("sweep.correlated", "fewer than two fields are drawn", "drawn fields");
      return {};
    }
    TableReader table("sweep", std::span(&entry, 1), field_names(), problems_);
    return table.words("correlated", drawn).value_or(std::vector<std::size_t>());
  }

  std::vector<std::vector<double>> matrix_of(const Entry& entry, std::size_t size) {
    const std::string shape = std::to_string(size) + " rows of " + std::to_string(size) +
                              " numbers from -1 to 1, symmetric, with 1 on the diagonal";
    const auto refuse = [&](const std::string& what) {
      error("sweep.correlation", what, shape);
      return std::vector<std::vector<double>>();
    };
    if (entry.value.kind != ValueKind::list || entry.elements.size() != size ||
        entry.inner.size() != size)
      return refuse("not as many rows as correlated fields");
    std::vector<std::vector<double>> matrix;
    for (const Entry& row : entry.inner) {
      if (row.elements.size() != size) return refuse("row " + row.path + " has another length");
      matrix.emplace_back();
      for (const Value& value : row.elements) {
        if (value.kind != ValueKind::number || !(std::abs(value.number) <= 1))
          return refuse("row " + row.path + " holds what is no number from -1 to 1");
        matrix.back().push_back(value.number);
      }
    }
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        if (matrix[i][j] != matrix[j][i] || (i == j && matrix[i][j] != 1))
          return refuse("not symmetric with 1 on the diagonal");
    return matrix;
  }

  // --- Settings that do not go together.

  void check_combinations() {
    const bool drawn = sweep_.drawn() > 0;
    if (drawn && sweep_.design == Design::factorial)
      error("sweep.design",
            "factorial takes grids alone, but " + sweep_.variables.back().path + " is drawn",
            "sobol, latin_hypercube or monte_carlo");
    if (!drawn && setting("design") != nullptr && sweep_.design != Design::factorial)
      error("sweep.design", "nothing is drawn", "factorial, or no design");
    if (!drawn && setting("draws") != nullptr)
      error("sweep.draws", "nothing is drawn", "no draws where all that varies is a grid");
    if (!drawn) sweep_.design = Design::factorial, sweep_.draws = 1;
    if (sweep_.sensitivity) check_sensitivity();
    check_onsets();
    if (sweep_.solves_film && sweep_.scene.bodies.shape() != ContactShape::line)
      error("sweep.solved_film", "the film is solved of lines alone",
            "true where bodies.length makes a line");
    if (sweep_.solves_film && sweep_.scene.speeds.empty())
      error("speed",
            {Fault::presence, "", ", and the solved film needs it", "a number, a list or a range"});
  }

  void check_sensitivity() {
    if (sweep_.drawn() != sweep_.variables.size() || sweep_.drawn() == 0)
      error("sweep.sensitivity", "Sobol indices are of drawn fields alone",
            "true where no field has a grid");
    if (!sweep_.correlation_root.empty())
      error("sweep.sensitivity", "Sobol indices are of independent fields",
            "true without a correlation");
    if (sweep_.drawn() > 0 && sweep_.draws < 2 * jackknife_blocks)
      error("sweep.draws", std::to_string(sweep_.draws) + " is too few for sensitivity",
            std::to_string(2 * jackknife_blocks) + " and more");
  }

  // Warns of a criterion that has no onset at the nominal values: few cases will have one.
  void check_onsets() {
    if (sweep_.criteria.empty()) return;
    const MixedContact<double> contact(sweep_.scene);
    for (const OnsetCriterion criterion : sweep_.criteria) {
      const Onset<double> found = onset(contact, sweep_.scene, criterion, sweep_.departure);
      if (found.exists) continue;
      problems_.warning("sweep.onset", {.what = std::string(name(criterion)) +
                                                " has no onset at the nominal values: " +
                                                std::string(found.reason)});
    }
  }

  void check_size() {
    double points = static_cast<double>(sweep_.draws * sweep_.cases_per_group());
    for (const Variable& variable : sweep_.variables)
      if (!variable.is_drawn()) points *= static_cast<double>(variable.grid.size());
    if (sweep_.asks_at_speeds()) points *= static_cast<double>(sweep_.scene.speeds.size());
    if (points <= static_cast<double>(most_cases)) return;
    error("sweep", "comes to " + scene_detail::number_text(points) + " points", "up to 1e12");
  }

  std::vector<Entry> entries_;
  const std::string& source_;
  SceneReading& reading_;
  Problems& problems_;
  std::vector<Validity>& passed_;
  Entry settings_;
  std::vector<VariedEntry> varied_;
  SceneSweep sweep_;
  bool speed_is_drawn_ = false;
  bool asks_points_ = true;
};

bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = scene_detail::utf8_length(text, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

SweepReading refused(const std::string& source, const std::string& why) {
  SceneReading scene;
  Problems(scene, source).error("", {.what = why});
  return {{}, std::move(scene.errors), {}, {}};
}

// The digest of a plan: 32 hexadecimal digits.
std::string digest_of(const std::string& of_program, const std::vector<SceneSweep>& scenes) {
  XXH3_state_t state{};
  XXH3_128bits_reset(&state);
  const auto add = [&state](std::string_view text) {
    const std::uint64_t size = text.size();
    XXH3_128bits_update(&state, &size, sizeof size);
    XXH3_128bits_update(&state, text.data(), text.size());
  };
  add(of_program);
  for (const SceneSweep& scene : scenes) {
    add(scene.scene.id);
    add(scene.text);
    add(std::to_string(scene.chunk_groups));
  }
  const XXH128_hash_t hash = XXH3_128bits_digest(&state);
  std::string text;
  for (const std::uint64_t word : {hash.high64, hash.low64})
    for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[(word >> shift) & 15];
  return text;
}

}  // namespace

std::span<const SweepField> sweep_fields() { return fields; }

SweepReading parse_sweep(std::string_view text, const std::string& source) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && text[first] == '{')
    return refused(source, "looks like JSON; allowed: a sweep in TOML");
  if (!is_utf8(source))
    return refused(source,
                   "has a name that is not UTF-8, and it is kept in the result; allowed: a "
                   "file whose name is UTF-8");
  SceneReading scene;
  Problems problems(scene, source);
  std::optional<SceneSweep> sweep;
  std::vector<Validity> passed;
  if (auto entries = scene_detail::toml_entries(text, problems))
    sweep = SweepBinder(std::move(*entries), source, scene, problems, passed).bind();
  if (sweep) {
    sweep->file = source.substr(source.rfind('/') + 1);  // the result tells no folder
    sweep->text = text;
  }
  return {std::move(sweep), std::move(scene.errors), std::move(scene.warnings), std::move(passed)};
}

SweepReading read_sweep(const std::string& path) {
  std::string text;
  if (const std::string refusal = scene_detail::read_input_text(path, "a sweep", text);
      !refusal.empty())
    return refused(path.empty() ? "\"\"" : path, refusal);
  return parse_sweep(text, path);
}

SweepPlan make_plan(std::vector<SceneSweep> scenes) {
  for (const SceneSweep& scene : scenes)
    for (const SceneSweep& other : scenes)
      if (&other != &scene && other.scene.id == scene.scene.id)
        throw std::invalid_argument(other.file + " and " + scene.file + " both have the id \"" +
                                    printable(scene.scene.id) +
                                    "\"; allowed: each its own, as it names a group of the result");
  SweepPlan plan;
  plan.version = version;
  plan.digest = digest_of(std::to_string(numbers_version), scenes);
  plan.scenes = std::move(scenes);
  return plan;
}

}  // namespace tribo::sweep
