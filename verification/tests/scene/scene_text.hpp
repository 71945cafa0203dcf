// SPDX-License-Identifier: Apache-2.0
// Scenes as text, to be spoilt field by field. The same fields are written as TOML and as JSON.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tribo/scene_reader.hpp"
#include "tribo/validity.hpp"

namespace tribo::scene_test {

enum class Format { toml, json };
inline constexpr Format formats[] = {Format::toml, Format::json};

// Fields in the order given. The text of a value is the same in TOML and in JSON.
class SceneText {
 public:
  // The paper's contact with the rough surface, at one speed.
  static SceneText good() {
    SceneText text;
    text.set("id", "\"rough\"").set("load", "50").set("speed", "0.1");
    text.set("surface.summit_density", "5e10").set("surface.summit_radius", "1e-5");
    text.set("surface.summit_height_sd", "1e-7").set("surface.summit_plane_offset", "1.146");
    text.set("bodies.effective_modulus", "107.9e9").set("bodies.reduced_radius", "9.5e-3");
    text.set("lubricant.viscosity", "0.0202").set("lubricant.pressure_viscosity", "2e-8");
    text.set("lubricant.eyring_stress", "2.5e6");
    text.set("supply.inlet_film_ratio", "4").set("friction.boundary_coefficient", "0.13");
    return text;
  }

  // A good scene with this field, too, and without fields that exclude it.
  static SceneText good_with(const FieldInfo& field) {
    SceneText text = good();
    if (field.path.starts_with("supply.")) text.remove_section("supply");
    if (field.path.starts_with("speed.")) {
      text.remove("speed");
      text.set("speed.from", "1e-4").set("speed.to", "3");
    }
    for (const FieldGroup group : scene_field_groups()) text.take_set_with(group, field.path);
    if (field.path == "closures.starvation") text.set("closures.film", "\"solved\"");
    if (field.path == "bodies.length") text.set("closures.film", "\"dowson_toyoda_central\"");
    return text.set(field.path, good_value(field));
  }

  // Replaces the group's fields by those of its first set that has this field.
  void take_set_with(FieldGroup group, std::string_view path) {
    const auto has = [&](const FieldSet& set) {
      return std::find(set.fields.begin(), set.fields.end(), path) != set.fields.end();
    };
    const auto found = std::find_if(group.begin(), group.end(), has);
    if (found == group.end() || found == group.begin()) return;
    for (const FieldSet& set : group)
      for (const auto& others : {set.fields, set.optional})
        for (const std::string_view other : others) remove(other);
    for (const FieldInfo& field : scene_fields())
      if (std::find(found->fields.begin(), found->fields.end(), field.path) != found->fields.end())
        set(field.path, field.path.starts_with("lubricant.") ? good_value(field) : "0.3");
  }

  static std::string good_value(const FieldInfo& field) {
    if (field.path == "closures.film") return "\"hamrock_dowson_minimum\"";
    if (field.type == FieldType::choice) return '"' + std::string(field.choices.back()) + '"';
    if (field.type == FieldType::outputs) return R"(["film", "regime"])";
    if (field.type == FieldType::limits) return R"(["barus"])";
    if (field.type == FieldType::integer) return "2";
    if (field.type == FieldType::viscosities) return "[[313.15, 46e-6], [373.15, 6.8e-6]]";
    if (field.path == "lubricant.iso_vg") return "46";
    if (field.path == "lubricant.viscosity_index") return "95";
    if (field.path == "lubricant.density") return "870";
    if (field.path == "lubricant.temperature") return "333.15";
    const SceneText base = good();
    for (const auto& [path, value] : base.fields_)
      if (path == field.path) return value;
    if (field.path.ends_with("poisson_ratio") || field.path == "surface.m2") return "0.3";
    if (field.path == "speed.from") return "1e-4";
    if (field.path == "supply.inlet_film") return "4e-7";
    if (field.path == "supply.inlet_flow") return "4e-9";
    return "1";
  }

  SceneText& set(std::string_view path, std::string_view value) {
    for (auto& [known, old] : fields_)
      if (known == path) {
        old = value;
        return *this;
      }
    fields_.emplace_back(path, value);
    return *this;
  }

  SceneText& remove(std::string_view path) {
    std::erase_if(fields_, [path](const auto& field) { return field.first == path; });
    return *this;
  }

  SceneText& remove_section(std::string_view section) {
    const std::string start = std::string(section) + '.';
    std::erase_if(fields_, [&start](const auto& field) { return field.first.starts_with(start); });
    return *this;
  }

  SceneText& rename(std::string_view path, std::string_view other) {
    for (auto& field : fields_)
      if (field.first == path) field.first = other;
    return *this;
  }

  std::string written(Format format) const { return format == Format::toml ? toml() : json(); }

  std::string toml() const {
    std::string text;
    for (const auto& [path, value] : fields_) text += path + " = " + value + '\n';
    return text;
  }

  std::string json() const {
    std::string text = "{";
    std::vector<std::string> done;
    for (const auto& [path, value] : fields_) {
      const std::string section = section_of(path);
      if (std::find(done.begin(), done.end(), section) != done.end()) continue;
      if (text.size() > 1) text += ", ";
      if (section.empty()) {
        text += '"' + path + "\": " + value;
        continue;
      }
      done.push_back(section);
      text += '"' + section + "\": {" + section_json(section) + '}';
    }
    return text + '}';
  }

 private:
  static std::string section_of(const std::string& path) {
    const std::size_t dot = path.find('.');
    return dot == std::string::npos ? "" : path.substr(0, dot);
  }

  std::string section_json(const std::string& section) const {
    std::string text;
    for (const auto& [path, value] : fields_) {
      if (section_of(path) != section) continue;
      if (!text.empty()) text += ", ";
      text += '"' + path.substr(section.size() + 1) + "\": " + value;
    }
    return text;
  }

  std::vector<std::pair<std::string, std::string>> fields_;
};

inline SceneReading read(Format format, std::string_view text, SceneUse use = SceneUse::speeds) {
  return format == Format::toml ? parse_scene_toml(text, "test", use)
                                : parse_scene_json(text, "test", use);
}

inline SceneReading read(Format format, const SceneText& text, SceneUse use = SceneUse::speeds) {
  return read(format, text.written(format), use);
}

// The lines that a failing test prints.
inline std::string lines_of(const std::vector<InputProblem>& problems) {
  std::string text;
  for (const InputProblem& problem : problems) text += "  " + problem.line() + '\n';
  return text.empty() ? "  none\n" : text;
}

inline bool has_problem(const std::vector<InputProblem>& problems, std::string_view field,
                        std::string_view part) {
  return std::any_of(problems.begin(), problems.end(), [&](const InputProblem& problem) {
    return problem.field == field && problem.message().find(part) != std::string::npos;
  });
}

// --- Judgements on a text in one format, or on a SceneText in both formats.

template <class Judge>
testing::AssertionResult in_both_formats(const SceneText& text, const Judge& judge) {
  const testing::AssertionResult of_toml = judge(Format::toml, text.toml());
  return of_toml ? judge(Format::json, text.json()) : of_toml;
}

inline testing::AssertionResult accepted(Format format, const std::string& text,
                                         SceneUse use = SceneUse::speeds) {
  const SceneReading reading = read(format, text, use);
  if (reading.scene && reading.errors.empty()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "refused: " << text << "\nerrors:\n"
                                     << lines_of(reading.errors);
}

inline testing::AssertionResult accepted(const SceneText& text, SceneUse use = SceneUse::speeds) {
  return in_both_formats(text, [&](Format format, const std::string& written) {
    return accepted(format, written, use);
  });
}

// An error on a field, with a part of its message.
struct Error {
  std::string_view field, part;
};

// Is the text refused with these errors and no others?
inline testing::AssertionResult refused(Format format, const std::string& text,
                                        const std::vector<Error>& wanted,
                                        SceneUse use = SceneUse::speeds) {
  const SceneReading reading = read(format, text, use);
  if (!reading.scene && reading.errors.size() == wanted.size() &&
      std::all_of(wanted.begin(), wanted.end(), [&](const Error& one) {
        return has_problem(reading.errors, one.field, one.part);
      }))
    return testing::AssertionSuccess();
  testing::AssertionResult failure = testing::AssertionFailure() << "input: " << text;
  for (const Error& one : wanted)
    failure << "\nwanted an error on '" << one.field << "' with: " << one.part;
  return failure << "\nerrors:\n" << lines_of(reading.errors);
}

inline testing::AssertionResult refused(const SceneText& text, const std::vector<Error>& wanted,
                                        SceneUse use = SceneUse::speeds) {
  return in_both_formats(text, [&](Format format, const std::string& written) {
    return refused(format, written, wanted, use);
  });
}

// Is the text refused with this error and no other?
inline testing::AssertionResult refused(Format format, const std::string& text,
                                        std::string_view field, std::string_view part) {
  return refused(format, text, {{field, part}});
}

inline testing::AssertionResult refused(const SceneText& text, std::string_view field,
                                        std::string_view part, SceneUse use = SceneUse::speeds) {
  return refused(text, {{field, part}}, use);
}

// The words of the limits that a scene passes and does not accept.
inline std::vector<std::string_view> words_passed(const Scene& scene,
                                                  SceneUse use = SceneUse::speeds) {
  std::vector<std::string_view> words;
  for (const Validity& limit : passed_limits(scene, use)) words.push_back(limit.word);
  return words;
}

// Does a scene pass the limit of this word?
inline bool passes(const SceneText& text, std::string_view word, SceneUse use = SceneUse::speeds) {
  const SceneReading reading = read(Format::toml, text, use);
  if (!reading.scene) {
    ADD_FAILURE() << lines_of(reading.errors);
    return false;
  }
  const std::vector<std::string_view> words = words_passed(*reading.scene, use);
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace tribo::scene_test
