// SPDX-License-Identifier: Apache-2.0
// From the flat list of entries to a Scene: first every entry finds its field, then every field
// of the schema takes its value, then come the rules that look at several fields.
#include <algorithm>
#include <array>
#include <cmath>
#include <forward_list>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "scene/contact_rules.hpp"
#include "scene/entries.hpp"
#include "scene/fault_text.hpp"
#include "scene/schema.hpp"
#include "scene/text.hpp"
#include "scene/units.hpp"
#include "tribo/friction.hpp"
#include "tribo/roughness.hpp"
#include "tribo/validity.hpp"

namespace tribo::scene_detail {
namespace {

// Two faces count as equally rough up to this ratio of their roughness.
constexpr double greatest_factor_of_alike_faces = 2;

bool is_whole(double number) { return std::trunc(number) == number; }

// The places of fields that the rules below name, looked up once.
struct NamedFields {
  std::size_t speed = field_at("speed"), speed_from = field_at("speed.from");
  std::size_t speed_to = field_at("speed.to"), outputs = field_at("outputs");
  std::size_t film = field_at("closures.film");
  std::size_t rms_roughness = field_at("surface.rms_roughness");
  FieldPlaces of_speed, of_supply;  // all fields of the tables `speed` and `supply`
  FieldPlaces of_roughness;         // Rq is given by one of these
  FieldPlaces of_summits;           // all fields of the table `surface` but Rq and Ra

  NamedFields() {
    for (std::size_t field = 0; field < scene_fields().size(); ++field) {
      const std::string_view section = section_of(scene_fields()[field].path);
      of_speed.set(field, section == "speed");
      of_supply.set(field, section == "supply");
      of_summits.set(field, section == "surface" && !scene_fields()[field].takes_both_faces);
    }
    for (const std::string_view path :
         {"surface.m0", "surface.rms_roughness", "surface.average_roughness"})
      of_roughness.set(field_at(path));
  }
};
const NamedFields& named() {
  static const NamedFields fields;
  return fields;
}

class SceneBinder {
 public:
  SceneBinder(SceneUse use, Problems& problems, SceneReading& reading)
      : use_(use), problems_(problems), reading_(reading) {}

  void bind(std::span<const Entry> entries) {
    for (const Entry& entry : entries) place(entry);
    for (const GroupPlaces& group : group_places())
      if (!(is_smooth() && (group.fields & named().of_summits).any())) check_group(group);
    for (std::size_t field = 0; field < fields_.size(); ++field) take(field);
    check_supply();
    check_roughness();
    if (!is_of_solved_film()) check_outputs();
    check_smooth();
    check_speed_range();
    check_roelands();
    if (problems_.any()) return;
    const auto numbers = check_contact(scene_, use_, is_given_[named().film], problems_);
    if (!numbers) return;
    complete(*numbers);
    note_heat();
    reading_.scene = std::move(scene_);
  }

 private:
  // --- Every entry finds its field.

  void place(const Entry& entry) {
    if (entry.value.kind == ValueKind::table && is_section(entry.path))
      place_section(entry);
    else if (const auto field = entry.field ? entry.field : find_field(entry.path))
      place_field(entry, *field);
    else if (is_section(entry.path))
      refuse_section(entry);
    else
      refuse_unknown(entry);
  }

  void place_section(const Entry& entry) {
    // TOML may give a table in pieces, in one entry. Two entries mean a table that is given twice.
    if (has_section(entry.path)) return problems_.error(entry.path, {Fault::once});
    sections_[section_count_++] = entry.path;
    if (entry.path == "speed") place_field(entry, named().speed);
  }

  void place_field(const Entry& entry, std::size_t field) {
    if (given_[field] != nullptr) return problems_.error(entry.path, {Fault::once});
    auto number = in_si(entry, fields_[field]);
    given_[field] = number ? &in_si_.emplace_front(std::move(*number)) : &entry;
    is_given_.set(field);
  }

  void refuse_section(const Entry& entry) {
    problems_.error(entry.path, wrong_kind(entry.value, "a table of " + names_in(entry.path)));
    for (std::size_t field = 0; field < fields_.size(); ++field)
      if (section_of(fields_[field].path) == entry.path) explained_.set(field);
    if (entry.path == "supply") supply_explained_ = true;
  }

  void refuse_unknown(const Entry& entry) {
    const bool table = entry.value.kind == ValueKind::table;
    const bool on_top = section_of(entry.path).empty();
    const std::string_view nearest = nearest_name(entry.path, on_top, !table);
    problems_.error(entry.path, {Fault::unknown, value_text(entry.value), table ? "table" : "field",
                                 nearest.empty() ? names_in(section_of(entry.path)) : "",
                                 std::string(nearest)});
    explain(nearest);
    if (section_of(entry.path) == "supply") supply_explained_ = true;
  }

  // The field that a misspelt name probably means is not reported as missing, too.
  void explain(std::string_view name) {
    if (name == "supply" || section_of(name) == "supply") supply_explained_ = true;
    for (std::size_t field = 0; field < fields_.size(); ++field) {
      const std::string_view path = fields_[field].path;
      if (!name.empty() && (path == name || section_of(path) == name)) explained_.set(field);
    }
  }

  // --- Every field takes its value.

  void take(std::size_t field) {
    const FieldInfo& info = fields_[field];
    if (given_[field] == nullptr) return miss(field);
    const Value& value = given_[field]->value;
    switch (info.type) {
      case FieldType::number:
      case FieldType::integer:
        if (info.takes_both_faces && value.kind == ValueKind::list)
          return take_both_faces(field, *given_[field]);
        if (const auto number = number_of(info, value, info.path)) {
          store_of(field)(scene_, *number);
        }
        return;
      case FieldType::choice:
        return take_choice(field, value);
      case FieldType::text:
        return take_id(value);
      case FieldType::speeds:
        return take_speeds(info, *given_[field]);
      case FieldType::outputs:
        return take_list(info, *given_[field], [&](const Value& one, std::size_t place) {
          take_output(info, one, place);
        });
      case FieldType::limits:
        return take_list(info, *given_[field], [&](const Value& one, std::size_t place) {
          take_limit(info, one, element_name(info.path, place));
        });
      case FieldType::viscosities:
        return take_viscosities(info, *given_[field]);
    }
  }

  void miss(std::size_t field) {
    const FieldInfo& info = fields_[field];
    bool needed = info.required;
    if (named().of_speed[field]) needed = needed && speed_is_table();
    if (info.type == FieldType::speeds) needed = use_ != SceneUse::onset && !is_of_solved_film();
    if (needed) report_missing(field, "");
  }

  void report_missing(std::size_t field, const std::string& why) {
    if (explained_[field]) return;
    const FieldInfo& info = fields_[field];
    const std::string allowed = use_ == SceneUse::one_speed && info.type == FieldType::speeds
                                    ? "one number above 0, in m/s"
                                    : allowed_text(info);
    problems_.error(info.path, {Fault::presence, "", why, allowed});
  }

  void refuse(const FieldInfo& info, std::string_view name, const Value& value) {
    problems_.error(name, wrong_kind(value, allowed_text(info)));
  }
  void refuse_empty(const FieldInfo& info) {
    problems_.error(info.path, {Fault::emptiness, "", "", allowed_text(info)});
  }

  // The number if it is one and in range; else nothing, and an error under `name`.
  std::optional<double> number_of(const FieldInfo& info, const Value& value,
                                  std::string_view name) {
    const std::optional<Fault::Rule> rule = broken_rule(info, value);
    if (!rule) return value.number + 0.0;  // −0 becomes 0
    const bool is_of_sweep = value.kind == ValueKind::list && !info.takes_both_faces;
    const std::string allowed =
        allowed_text(info) + (is_of_sweep ? "; a sweep takes lists: tribocheck sweep" : "");
    if (rule == Fault::kind)
      problems_.error(name, no_number(value, written_unit(info), allowed));
    else
      problems_.error(name, {*rule, value_text(value), "", allowed});
    return std::nullopt;
  }

  // The rule that the value breaks as a number of this field, if it breaks one.
  static std::optional<Fault::Rule> broken_rule(const FieldInfo& info, const Value& value) {
    const double number = value.number;
    if (value.kind != ValueKind::number) return Fault::kind;
    if (value.fault == NumberFault::overflow) return Fault::overflow;
    if (value.fault == NumberFault::underflow) return Fault::underflow;
    if (info.is_radius_of_face && !std::isnan(number))
      return number == 0 ? std::optional(Fault::range) : std::nullopt;
    if (!std::isfinite(number)) return Fault::finiteness;
    if (info.type == FieldType::integer && !is_whole(number)) return Fault::wholeness;
    const bool low = info.exclusive_minimum ? number <= info.minimum : number < info.minimum;
    if (low || (info.maximum && number > *info.maximum)) return Fault::range;
    return std::nullopt;
  }

  void take_both_faces(std::size_t field, const Entry& entry) {
    const FieldInfo& info = fields_[field];
    for (const Value& element : entry.elements)
      if (element.kind == ValueKind::table || element.kind == ValueKind::list)
        return problems_.error(
            info.path,
            {.what = "a list of two faces takes no " +
                     std::string(element.kind == ValueKind::table ? "distribution" : "lists") +
                     "; allowed: two numbers, or in a sweep { from = …, to = …, count = … } or a "
                     "distribution of both faces together, √(x₁² + x₂²)"});
    if (entry.elements.size() != 2) return refuse(info, info.path, entry.value);
    std::array<std::optional<double>, 2> faces;
    for (std::size_t i = 0; i < faces.size(); ++i)
      faces[i] = number_of(info, entry.elements[i], element_name(info.path, i));
    if (!faces[0] || !faces[1]) return;
    const auto [less, greater] = std::minmax(*faces[0], *faces[1]);
    scene_.surface.has_alike_faces = greater <= greatest_factor_of_alike_faces * less;
    store_of(field)(scene_, composite_roughness(*faces[0], *faces[1]));
  }

  void take_choice(std::size_t field, const Value& value) {
    const FieldInfo& info = fields_[field];
    if (value.kind != ValueKind::text) return refuse(info, info.path, value);
    for (std::size_t place = 0; place < info.choices.size(); ++place)
      if (info.choices[place] == value.text)
        return store_of(field)(scene_, static_cast<double>(place));
    problems_.error(info.path, unknown_word(value, info.choices, allowed_text(info)));
  }

  void take_id(const Value& value) {
    const bool is_of_line = use_ == SceneUse::one_speed;
    if (!is_of_line && value.kind != ValueKind::text)
      return problems_.error("id", wrong_kind(value, "a text"));
    reading_.id = line_id(value);
    if (!reading_.id)
      return problems_.error("id", wrong_kind(value, std::string(allowed_line_ids)));
    reading_.id_is_number = value.kind == ValueKind::number;
    scene_.id = *reading_.id;
  }

  // --- The oil.

  void take_viscosities(const FieldInfo& info, const Entry& entry) {
    if (entry.elements.size() != 2 || entry.inner.size() != 2)
      return refuse(info, info.path, entry.value);
    for (std::size_t i = 0; i < 2; ++i) {
      const std::vector<Value>& pair = entry.inner[i].elements;
      if (pair.size() != 2) return refuse(info, element_name(info.path, i), entry.inner[i].value);
      KinematicViscosity& to = scene_.lubricant.oil.viscosities[i];
      to.temperature = part_of_pair(pair[0], "K", i, 0).value_or(0);
      to.viscosity = part_of_pair(pair[1], "m²/s", i, 1).value_or(0);
    }
  }

  std::optional<double> part_of_pair(const Value& value, std::string_view unit, std::size_t pair,
                                     std::size_t part) {
    const FieldInfo number{.path = "", .unit = unit};
    return number_of(number, in_si(value, unit),
                     element_name(element_name("lubricant.kinematic_viscosity", pair), part));
  }

  // --- Speeds.

  bool speed_is_table() const {
    const Entry* speed = given_[named().speed];
    return speed != nullptr && speed->value.kind == ValueKind::table;
  }

  void take_speeds(const FieldInfo& info, const Entry& entry) {
    const ValueKind kind = entry.value.kind;
    if (use_ == SceneUse::one_speed && kind != ValueKind::number) {
      problems_.error("speed", wrong_kind(entry.value, "one number above 0, in m/s"));
      explained_.set(named().speed_from);
      explained_.set(named().speed_to);
      return;
    }
    if (kind == ValueKind::table) {
      scene_.speeds.count = 200;
    } else if (kind == ValueKind::list) {
      take_speed_list(info, entry.elements);
    } else if (const auto number = number_of(info, entry.value, "speed")) {
      scene_.speeds.list = {*number};
    }
  }

  void take_speed_list(const FieldInfo& info, const std::vector<Value>& elements) {
    if (elements.empty()) return refuse_empty(info);
    scene_.speeds.list.reserve(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i)
      if (const auto number = speed_of(info, elements[i], i)) scene_.speeds.list.push_back(*number);
  }

  std::optional<double> speed_of(const FieldInfo& info, const Value& value, std::size_t i) {
    if (!broken_rule(info, value)) return value.number;  // names are made for errors only
    const FieldInfo& element = fields_[named().speed_from];
    return number_of(element, value, element_name("speed", i));
  }

  static std::string element_name(std::string_view list, std::size_t i) {
    return std::string(list) + '[' + std::to_string(i) + ']';
  }

  void check_speed_range() {
    const Speeds& speeds = scene_.speeds;
    if (!speed_is_table() || speeds.from <= 0 || speeds.to <= 0) return;
    if (speeds.from < speeds.to) return;
    problems_.error("speed.to",
                    {Fault::range, number_text(speeds.to), "",
                     "a number above speed.from, which is " + number_text(speeds.from)});
  }

  // --- Outputs.

  template <class Take>
  void take_list(const FieldInfo& info, const Entry& entry, const Take& take_one) {
    if (entry.value.kind != ValueKind::list) return refuse(info, info.path, entry.value);
    if (entry.elements.empty() && info.type == FieldType::outputs) return refuse_empty(info);
    for (std::size_t i = 0; i < entry.elements.size(); ++i) take_one(entry.elements[i], i);
  }

  void take_output(const FieldInfo& info, const Value& value, std::size_t i) {
    const auto output = value.kind == ValueKind::text ? output_by_name(value.text) : std::nullopt;
    if (!output || scene_.outputs.contains(*output))
      return refuse_output(info, value, element_name("outputs", i));
    scene_.outputs.insert(*output);
  }

  void refuse_output(const FieldInfo& info, const Value& value, const std::string& name) {
    if (value.kind != ValueKind::text) return refuse(info, name, value);
    if (output_by_name(value.text)) return problems_.error(name, repeated(value));
    problems_.error(name, unknown_word(value, output_names, allowed_text(info)));
  }

  // A word may be given twice.
  void take_limit(const FieldInfo& info, const Value& value, const std::string& name) {
    if (value.kind != ValueKind::text) return refuse(info, name, value);
    const auto words = limit_words();
    const auto found = std::find(words.begin(), words.end(), value.text);
    if (found == words.end())
      return problems_.error(name, unknown_word(value, words, allowed_text(info)));
    scene_.accepted.push_back(*found);
  }

  // Asked outputs need their inputs. Without a list, outputs without their inputs are left out.
  void check_outputs() {
    const bool asked = given_[named().outputs] != nullptr;
    if (!asked) scene_.outputs = OutputSet::all();
    for (std::size_t field = 0; field < fields_.size(); ++field) {
      const FieldInfo& info = fields_[field];
      if (!info.needed_by || given_[field] != nullptr) continue;
      if (!scene_.outputs.contains(*info.needed_by) && asked) continue;
      if (asked)
        report_missing(field, ": " + std::string(tribo::info(*info.needed_by).name) + " needs it");
      else
        scene_.outputs.erase(*info.needed_by);
    }
    if (scene_.outputs.contains(Output::lambda_ratio) && !has_roughness())
      report_missing(named().rms_roughness,
                     ": lambda_ratio needs it, or average_roughness, or the moments of a profile");
  }

  bool has_roughness() const { return (is_given_ & named().of_roughness).any(); }
  void check_roughness() {
    if ((is_given_ & named().of_roughness).count() < 2) return;
    std::string_view first;
    for (std::size_t field = 0; field < fields_.size(); ++field) {
      if (!is_given_[field] || !named().of_roughness[field]) continue;
      const std::string_view path = fields_[field].path;
      if (first.empty())
        first = path;
      else
        refuse_beside(path, first, "exactly one of m0, rms_roughness and average_roughness");
    }
  }

  // Refuses outputs and supplies that are ratios to σ_s where the bodies are smooth.
  void check_smooth() {
    if (!is_smooth()) return;
    const auto refuse_ratio = [this](std::string_view field, std::string_view name,
                                     std::string_view allowed) {
      problems_.error(field, {Fault::together, std::string(name),
                              ": it is a ratio to σ_s, and without summits the bodies are smooth",
                              std::string(allowed) + ", or the summits in a table surface"});
    };
    if (given_[named().outputs] == nullptr)
      scene_.outputs.erase(Output::film_parameter);
    else if (scene_.outputs.contains(Output::film_parameter) && !is_of_solved_film())
      refuse_ratio("outputs", "film_parameter", "other outputs");
    if (is_given("supply.inlet_film_ratio") && !is_of_solved_film())
      refuse_ratio("supply.inlet_film_ratio", "this", "inlet_film or inlet_flow");
  }

  // --- Rules on several fields.

  bool is_given(std::string_view path) const { return given_[field_at(path)] != nullptr; }

  bool is_of_solved_film() const { return is_of_solved_films(use_); }
  // The bodies are smooth if [surface] is missing, or has nothing but the roughness for Λ.
  bool is_smooth() const {
    return ((is_given_ | explained_) & named().of_summits).none() &&
           (!has_section("surface") || has_roughness());
  }

  // Refuses a group unless all fields of one of its sets are given, and none of the other sets.
  void check_group(const GroupPlaces& group) {
    const FieldPlaces given = is_given_ & group.fields, beside = is_given_ & group.optional;
    for (const SetPlaces& set : group.sets)
      if (given == set.fields && (beside & ~set.optional).none()) return;
    if ((explained_ & group.fields).none()) refuse_group(group, given);
  }

  void refuse_group(const GroupPlaces& group, const FieldPlaces& given) {
    FieldPlaces so_far;
    std::string_view first;
    for (std::size_t field = 0; field < fields_.size(); ++field) {
      if (!given[field]) continue;
      const std::string_view path = fields_[field].path;
      if (first.empty()) first = path;
      if (fitting_set(group, so_far.set(field)) == nullptr)
        return refuse_beside(path, first, sets_text(group.names));
    }
    const FieldSet& chosen = fitting_set(group, given)->names;
    for (const std::string_view path : chosen.fields)
      if (!is_given(path)) report_missing_of(group.names, path, first);
    for (const SetPlaces& set : group.sets)
      for (const std::string_view path : set.names.optional)
        if (is_given(path) && !first.empty() && !contains(chosen.optional, path))
          refuse_beside(path, first, "only beside " + std::string(set.names.fields.front()));
  }

  // The set with exactly the given fields, else the first set that has all of them, else null.
  static const SetPlaces* fitting_set(const GroupPlaces& group, const FieldPlaces& given) {
    const SetPlaces* fitting = nullptr;
    for (const SetPlaces& set : group.sets) {
      if (set.fields == given) return &set;
      if (fitting == nullptr && (given & ~set.fields).none()) fitting = &set;
    }
    return fitting;
  }

  static bool contains(std::span<const std::string_view> names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  void refuse_beside(std::string_view path, std::string_view first, const std::string& allowed) {
    problems_.error(path, {Fault::absence, "", std::string(first), allowed});
  }

  // `first`: the first given field of the group, empty if there is none.
  void report_missing_of(FieldGroup group, std::string_view path, std::string_view first) {
    const std::size_t field = field_at(path);
    if (first.empty() && group.front().fields.size() > 1) return report_missing(field, "");
    if (first.empty())
      return problems_.error(
          path, {Fault::presence, "", "",
                 allowed_text(fields_[field]) + "; or, in its place, " + sets_text(group, 1)});
    problems_.error(path, {Fault::presence, "", " beside " + std::string(first), sets_text(group)});
  }

  // Puts the numbers that follow from two bodies, from spectral moments, or from an oil into the
  // scene, as if they had been given.
  void complete(const detail::SceneNumbers<double>& numbers) {
    Surface& surface = scene_.surface;
    if (!surface.is_smooth()) {
      surface.summit_density = numbers.summit_density;
      surface.summit_radius = numbers.summit_radius;
      surface.summit_height_sd = numbers.summit_height_sd;
      surface.summit_plane_offset = numbers.summit_plane_offset;
    }
    scene_.lubricant.viscosity = numbers.viscosity;
    surface.rms_roughness = numbers.rms_roughness;
    Bodies& bodies = scene_.bodies;
    bodies.effective_modulus = numbers.effective_modulus;
    if (bodies.shape() == ContactShape::circle) return;
    bodies.radius_x = numbers.radius_x;
    if (bodies.shape() == ContactShape::ellipse) bodies.radius_y = numbers.across;
  }

  void check_supply() {
    const FieldPlaces given = is_given_ & named().of_supply;
    std::string_view first;
    for (std::size_t field = 0; field < fields_.size(); ++field) {
      if (!given[field]) continue;
      const std::string_view path = fields_[field].path;
      if (first.empty())
        first = path;
      else
        refuse_beside(path, first, "exactly one of " + names_in("supply"));
    }
    if (is_of_solved_film() && !first.empty() &&
        (use_ == SceneUse::line_film || is_given("bodies.length")))
      problems_.warning(first,
                        {.what = "not used: the solved film of a line is that of a flooded inlet"});
    if (first.empty() && has_section("supply") && !supply_explained_)
      problems_.error("supply", {Fault::other, "", "empty",
                                 "exactly one of " + names_in("supply") +
                                     " (no supply at all: fully flooded)"});
  }

  bool has_section(std::string_view name) const {
    const auto end = sections_.begin() + static_cast<std::ptrdiff_t>(section_count_);
    return std::find(sections_.begin(), end, name) != end;
  }

  // A heated inlet takes friction.slide_roll_ratio, whose default is that of the published model,
  // not that of a bearing.
  void note_heat() {
    if (scene_.lubricant.thermal == ThermalInlet::none) return;
    if (is_of_solved_film())
      problems_.warning("lubricant.thermal",
                        {.what = "not used: the solved film is that of an isothermal inlet"});
    else if (!is_given("friction.slide_roll_ratio"))
      problems_.warning(
          "friction.slide_roll_ratio",
          {Fault::presence, "",
           ", and the heated inlet of lubricant.thermal depends on it: the default of " +
               number_text(scene_.friction.slide_roll_ratio) +
               " is taken, as much sliding as rolling",
           "0 of pure rolling, 0.01 to 0.05 of a rolling bearing, 0 to 0.5 of gears"});
  }

  void check_roelands() {
    const double viscosity = scene_.lubricant.viscosity;
    if (scene_.friction.viscosity != ViscosityLaw::roelands || viscosity <= 0) return;
    if (viscosity > least_roelands_viscosity) return;
    problems_.error(
        "lubricant.viscosity",
        {Fault::range, number_text(viscosity), " with friction.viscosity = \"roelands\"",
         "a number above " + number_text(least_roelands_viscosity) + ", in Pa·s"});
  }

  const std::span<const FieldInfo> fields_ = scene_fields();
  SceneUse use_;
  Problems& problems_;
  SceneReading& reading_;
  Scene scene_;
  std::array<const Entry*, field_capacity> given_{};
  std::forward_list<Entry> in_si_;  // entries that were given as texts with units
  FieldPlaces is_given_;            // those with an entry in given_
  FieldPlaces explained_;           // an error already says why the field is not there
  bool supply_explained_ = false;
  std::array<std::string_view, sections.size()> sections_;  // the tables that were given
  std::size_t section_count_ = 0;
};

}  // namespace

void put_outputs(std::span<const std::string_view> outputs, std::vector<Entry>& entries) {
  if (outputs.empty()) return;
  std::erase_if(entries, [](const Entry& one) { return one.path == "outputs"; });
  Entry& list = entries.emplace_back();
  list.path = "outputs";
  list.value.kind = ValueKind::list;
  for (const std::string_view name : outputs)
    list.elements.push_back({.kind = ValueKind::text, .text = std::string(name)});
}

void bind_scene(std::span<const Entry> entries, SceneUse use, Problems& problems,
                SceneReading& reading) {
  SceneBinder(use, problems, reading).bind(entries);
}

}  // namespace tribo::scene_detail
