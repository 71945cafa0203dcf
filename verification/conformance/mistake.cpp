// SPDX-License-Identifier: Apache-2.0
#include "conformance/mistake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "conformance/insides.hpp"
#include "conformance/mistake_entry.hpp"
#include "scene/entries.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;

constexpr std::size_t most_fields = 100'000;  // far more than the files of this project have

json json_of(const scene_detail::Value& value) {
  switch (value.kind) {
    case scene_detail::ValueKind::number:
      return value.number;
    case scene_detail::ValueKind::text:
      return value.text;
    case scene_detail::ValueKind::boolean:
      return value.number != 0;
    default:
      return nullptr;
  }
}

json json_of(const scene_detail::Entry& entry) {
  if (entry.value.kind == scene_detail::ValueKind::table) {
    json object = json::object();
    for (const scene_detail::Entry& one : entry.inner) object[one.path] = json_of(one);
    return object;
  }
  if (entry.value.kind != scene_detail::ValueKind::list) return json_of(entry.value);
  json list = json::array();
  for (const scene_detail::Value& one : entry.elements) list.push_back(json_of(one));
  for (const scene_detail::Entry& one : entry.inner)  // "[3]": tables and lists
    list[std::stoul(one.path.substr(1))] = json_of(one);
  return list;
}

std::runtime_error not_allowed(std::string_view name, const json& value) {
  return std::runtime_error(fmt::format("{}: {} is not allowed", name, value.dump()));
}

// Takes members out of an entry one by one. finish() refuses those that are left, as unknown.
class Members {
 public:
  explicit Members(json object) : object_(std::move(object)) {
    if (!object_.is_object()) throw std::runtime_error("is no table");
  }

  template <class T>
  void take(const char* name, T& to) {
    const auto found = object_.find(name);
    if (found == object_.end()) return;
    try {
      to = found->template get<T>();
    } catch (const json::exception&) {
      throw not_allowed(name, *found);
    }
    object_.erase(found);
  }
  json take_any(const char* name) {
    json value;
    take(name, value);
    return value;
  }
  void finish() const {
    if (!object_.empty())
      throw std::runtime_error(fmt::format("unknown field {}", object_.begin().key()));
  }

 private:
  json object_;
};

NumberChange change_of(const json& written) {
  NumberChange change;
  Members members(written);
  members.take("times", change.times);
  members.take("inverted", change.is_inverted);
  members.take("by", change.by);
  members.take("over", change.over);
  if (const json is = members.take_any("is"); !is.is_null()) change.is = is;
  if (change.is && (change.times != 1 || change.is_inverted))
    throw std::runtime_error("a number that is another one (is) has no times and is not inverted");
  members.finish();
  return change;
}

NumberChanges changes_of(const json& written) {
  NumberChanges changes;
  if (written.is_null()) return changes;
  if (!written.is_object()) throw std::runtime_error("changes are a table, not " + written.dump());
  for (const auto& [name, one] : written.items()) changes.emplace_back(name, change_of(one));
  return changes;
}

NamedNumbers named_numbers(const json& written) {
  NamedNumbers numbers;
  if (written.is_null()) return numbers;
  if (!written.is_object()) throw std::runtime_error("numbers are a table, not " + written.dump());
  for (const auto& [name, value] : written.items())
    numbers.emplace_back(name,
                         value.is_number() ? value.get<double>() : throw not_allowed(name, value));
  return numbers;
}

// Changes of a scene, in its tables: { bodies = { reduced_radius = { times = 2 } } }.
NumberChanges scene_changes_of(const json& written) {
  NumberChanges changes;
  if (written.is_null()) return changes;
  for (const auto& [section, fields] : written.items())
    for (auto& [field, change] : changes_of(fields))
      changes.emplace_back(section + '.' + field, change);
  return changes;
}

// An entry has one kind of change. Changes of arguments, results, sharing, and a law or a formula
// are one kind, and may stand together.
void check_kinds(const MistakeEntry& entry) {
  const bool is_of_function = !entry.input.empty() || !entry.result.empty() ||
                              !entry.where.empty() || !entry.law.is_null() ||
                              !entry.sharing.empty();
  const bool changes = !entry.input.empty() || !entry.result.empty() || !entry.law.is_null() ||
                       !entry.sharing.empty() || !entry.formula.empty();
  const bool is_of_point = !entry.scene.empty() || !entry.area.empty() ||
                           !entry.stiffness.empty() || !entry.friction.empty() ||
                           !entry.left_out.empty();
  const int kinds = (changes ? 1 : 0) + (entry.scene.empty() ? 0 : 1) +
                    (entry.area.empty() ? 0 : 1) + (entry.stiffness.empty() ? 0 : 1) +
                    (entry.friction.empty() ? 0 : 1) + (entry.swapped.empty() ? 0 : 1) +
                    (entry.left_out.empty() ? 0 : 1);
  if (entry.function == "operating_point" && is_of_function)
    throw std::runtime_error("where, input, result, law and sharing are for single functions");
  if (entry.function != "operating_point" && is_of_point)
    throw std::runtime_error(
        "scene, area, stiffness, friction and left_out are for operating_point");
  if (kinds == 0) throw std::runtime_error("nothing is changed");
  if (kinds > 1 || (!entry.swapped.empty() && !entry.where.empty()) ||
      (!entry.law.is_null() && !entry.formula.empty()) ||
      (entry.law == "another" && !(entry.where.empty() && entry.input.empty() &&
                                   entry.result.empty() && entry.sharing.empty())))
    throw std::runtime_error("these changes cannot stand together");
}

MistakeEntry entry_of(const json& written) {
  MistakeEntry entry;
  Members members(written);
  members.take("function", entry.function);
  members.take("name", entry.name);
  members.take("text", entry.text);
  members.take("follows", entry.follows);
  members.take("swapped", entry.swapped);
  members.take("left_out", entry.left_out);
  members.take("stiffness", entry.stiffness);
  members.take("area", entry.area);
  entry.sharing = named_numbers(members.take_any("sharing"));
  entry.friction = named_numbers(members.take_any("friction"));
  if (const json where = members.take_any("where"); !where.is_null()) {
    if (!where.is_object()) throw not_allowed("where", where);
    for (const auto& [name, values] : where.items())
      entry.where.emplace_back(name, values.is_array() ? values.get<std::vector<json>>()
                                                       : throw not_allowed(name, values));
  }
  entry.input = changes_of(members.take_any("input"));
  entry.result = changes_of(members.take_any("result"));
  entry.scene = scene_changes_of(members.take_any("scene"));
  entry.law = members.take_any("law");
  if (const json formula = members.take_any("formula"); !formula.is_null()) {
    Members of_formula(formula);
    of_formula.take("name", entry.formula);
    of_formula.take("numbers", entry.numbers);
    of_formula.finish();
  }
  members.finish();
  if (entry.function.empty() || entry.name.empty() || entry.text.empty())
    throw std::runtime_error("function, name and text are needed");
  check_kinds(entry);
  return entry;
}

// Splits an entry whose `function` is a list.
std::vector<json> one_for_each_function(const json& written) {
  if (!written.is_object() || !written.contains("function") || !written["function"].is_array())
    return {written};
  std::vector<json> all;
  for (const json& function : written["function"]) {
    all.push_back(written);
    all.back()["function"] = function;
  }
  return all;
}

// An entry for several functions is read as one entry for each of them.
std::vector<MistakeEntry> read_mistake_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw std::runtime_error(path + ": cannot be read");
  SceneReading reading;
  scene_detail::Problems problems(reading, path);
  const auto written_entries = scene_detail::toml_entries(text, problems, most_fields);
  if (!written_entries) throw std::runtime_error(reading.errors.front().line());
  json all = json::array();
  for (const scene_detail::Entry& one : *written_entries) {
    if (one.path != "mistake")
      throw std::runtime_error(fmt::format("{}: unknown name {}", path, one.path));
    all = json_of(one);
  }
  std::vector<MistakeEntry> entries;
  for (const json& written : all) {
    const std::string name = written.is_object() ? written.value("name", json("")).dump() : "";
    try {
      for (const json& one : one_for_each_function(written)) entries.push_back(entry_of(one));
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("{}: mistake {}: {}", path, name, error.what()));
    }
  }
  if (entries.empty()) throw std::runtime_error(path + ": no [[mistake]] is there");
  return entries;
}

}  // namespace

bool Mistake::can_stand_beside(const Mistake& other) const {
  return std::none_of(touches.begin(), touches.end(), [&](const std::string& one) {
    return std::find(other.touches.begin(), other.touches.end(), one) != other.touches.end();
  });
}

std::optional<Numbers> numbers_with(std::span<const Mistake* const> mistakes,
                                    const Question& question) {
  const auto applies = [&](const Mistake* one) { return !one->applies || one->applies(question); };
  if (std::none_of(mistakes.begin(), mistakes.end(), applies)) return std::nullopt;
  Question misread = question;
  for (const Mistake* const one : mistakes)
    if (one->before && applies(one)) one->before(misread);
  std::optional<Numbers> numbers;
  for (const Mistake* const one : mistakes)
    if (one->instead && applies(one)) {
      numbers = one->instead(misread);
      if (!numbers) return std::nullopt;
    }
  if (!numbers) numbers = right_numbers(misread);
  for (const Mistake* const one : mistakes)
    if (one->after && applies(one)) one->after(misread, *numbers);
  return numbers;
}

bool is_film_of_points(std::string_view function) {
  return std::any_of(named_film_laws.begin(), named_film_laws.end(), [&](const auto& named) {
    return named.word == function && named.law->has_fixed_exponents() &&
           named.law->sharing_exponent.p != 0;
  });
}

std::vector<Mistake> read_mistakes(const std::string& path) {
  std::vector<Mistake> all, of_points;
  std::map<std::string, std::vector<Mistake>> of_films;  // by name: one for each film law
  for (const MistakeEntry& entry : read_mistake_file(path)) try {
      if (entry.function == "operating_point") {
        for (Mistake& one : point_mistakes_of(entry)) of_points.push_back(std::move(one));
        continue;
      }
      for (const catalogue::Function* const function : functions_of(entry))
        for (Mistake& one : mistakes_of(*function, entry)) {
          if (is_film_of_points(function->name))
            of_films[one.name].push_back(one);
          else if (std::optional<Mistake> same = for_points(one))
            of_points.push_back(std::move(*same));
          all.push_back(std::move(one));
        }
    } catch (const std::exception& error) {
      throw std::runtime_error(
          fmt::format("{}: mistake \"{}\": {}", path, entry.name, error.what()));
    }
  for (const auto& [name, laws] : of_films) of_points.push_back(with_film(laws));
  for (Mistake& one : mistakes_of_insides()) of_points.push_back(std::move(one));
  for (Mistake& one : of_points) all.push_back(std::move(one));
  for (const Mistake& one : all)
    if (!one.follows.empty() && std::none_of(all.begin(), all.end(), [&](const Mistake& other) {
          return other.name == one.follows;
        }))
      throw std::runtime_error(
          fmt::format("{}: mistake \"{}\": follows: no mistake {}", path, one.name, one.follows));
  return all;
}

}  // namespace tribo::conformance
