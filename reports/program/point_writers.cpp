// SPDX-License-Identifier: Apache-2.0
#include "point_writers.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "page/texts.hpp"
#include "protocol/answers.hpp"
#include "table.hpp"

namespace tribo::cli {
namespace {

protocol::OutputValue speed_of(const OperatingPoint<double>& point) {
  if (!std::isfinite(point.speed)) return {.undefined = protocol::beyond_double, .word = {}};
  return {.undefined = {}, .word = {}, .number = point.speed};
}

// One header and one row a point for all scenes; the columns are what any of them asks for.
class CsvWriter : public PointWriter {
 public:
  CsvWriter(OutputStream& output, const std::vector<Scene>& scenes) : output_(output) {
    for (const OutputInfo& info : output_infos)
      if (std::any_of(scenes.begin(), scenes.end(),
                      [&info](const Scene& scene) { return scene.outputs.contains(info.output); }))
        columns_.push_back(info.output);
    append(output_.text(), "id,speed");
    for (const Output column : columns_) {
      output_.text().push_back(',');
      append(output_.text(), info(column).name);
    }
    end_row();
  }

  void begin_scene(const Scene& scene) override { scene_ = &scene; }

  void add(const OperatingPoint<double>& point) override {
    append(output_.text(), report::csv_text(scene_->id));
    add_cell(speed_of(point));
    for (const Output column : columns_) {
      if (scene_->outputs.contains(column))
        add_cell(protocol::value_of(point, column));
      else
        output_.text().push_back(',');
    }
    end_row();
  }

  void finish() override {}

 private:
  void add_cell(const protocol::OutputValue& value) {
    Text& text = output_.text();
    text.push_back(',');
    if (!value.undefined.empty()) return;
    if (value.word.empty())
      protocol::append_number(text, value.number);
    else
      append(text, value.word);
  }

  void end_row() {
    output_.text().push_back('\n');
    output_.end_row();
  }

  OutputStream& output_;
  std::vector<Output> columns_;
  const Scene* scene_ = nullptr;
};

// One array, one object a line.
class JsonWriter : public PointWriter {
 public:
  explicit JsonWriter(OutputStream& output) : output_(output) {}

  void begin_scene(const Scene& scene) override { scene_ = &scene; }

  void add(const OperatingPoint<double>& point) override {
    append(output_.text(), std::exchange(before_, ",\n"));
    protocol::AnswerObject answer(output_.text(), scene_->id);
    answer.value("speed", speed_of(point));
    for (const OutputInfo& info : output_infos)
      if (scene_->outputs.contains(info.output))
        answer.value(info.name, protocol::value_of(point, info.output));
    answer.close();
    output_.end_row();
  }

  void finish() override { append(output_.text(), "\n]\n"); }

 private:
  OutputStream& output_;
  const Scene* scene_ = nullptr;
  const char* before_ = "[\n";
};

// A titled table a scene; what is undefined is "-", and below the table stands why.
class TableWriter : public PointWriter {
 public:
  explicit TableWriter(OutputStream& output) : output_(output) {}

  void begin_scene(const Scene& scene) override {
    if (scene_ != nullptr) {
      end_scene();
      output_.text().push_back('\n');
    }
    scene_ = &scene;
    append_title(output_.text(), title());
    heads_.emplace_back("speed", "[m/s]", number_width);
    for (const OutputInfo& info : output_infos)
      if (scene.outputs.contains(info.output))
        heads_.emplace_back(info.name, unit_of(info), least_width(info));
    append_heads(output_.text(), heads_);
  }

  void add(const OperatingPoint<double>& point) override {
    std::size_t column = 0;
    add_cell(column, "speed", speed_of(point));
    for (const OutputInfo& info : output_infos)
      if (scene_->outputs.contains(info.output))
        add_cell(++column, info.name, protocol::value_of(point, info.output));
    output_.text().push_back('\n');
    output_.end_row();
  }

  void finish() override {
    if (scene_ != nullptr) end_scene();
  }

 private:
  static std::size_t least_width(const OutputInfo& info) {
    return info.words.empty() ? number_width : width_of_words(info.words);
  }

  static std::string unit_of(const OutputInfo& info) {
    if (!info.words.empty()) return "";
    return info.unit.empty() ? "[-]" : fmt::format("[{}]", info.unit);
  }

  std::string title() const {
    const std::size_t count = scene_->speeds.size();
    return fmt::format("{}: {} speed{}", scene_->id, count, count == 1 ? "" : "s");
  }

  void add_cell(std::size_t column, std::string_view name, const protocol::OutputValue& value) {
    Text& text = output_.text();
    const std::size_t width = heads_[column].width();
    if (!value.undefined.empty()) {
      append_cell(text, "-", width);
      note(name, value.undefined);
    } else if (!value.word.empty()) {
      append_cell(text, value.word, width);
    } else {
      append_cell(text, readable(value.number), width);
    }
  }

  void note(std::string_view name, std::string_view reason) {
    const std::pair note(name, reason);
    if (std::find(notes_.begin(), notes_.end(), note) == notes_.end()) notes_.push_back(note);
  }

  void end_scene() {
    for (const auto& [name, reason] : notes_)
      append(output_.text(), fmt::format("  - {}: {}\n", name, reason));
    notes_.clear();
    heads_.clear();
  }

  OutputStream& output_;
  const Scene* scene_ = nullptr;
  std::vector<ColumnHead> heads_;
  std::vector<std::pair<std::string_view, std::string_view>> notes_;
};

}  // namespace

std::unique_ptr<PointWriter> make_point_writer(std::string_view format, OutputStream& output,
                                               const std::vector<Scene>& scenes) {
  if (format == "csv") return std::make_unique<CsvWriter>(output, scenes);
  if (format == "json") return std::make_unique<JsonWriter>(output);
  return std::make_unique<TableWriter>(output);
}

}  // namespace tribo::cli
