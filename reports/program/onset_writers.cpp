// SPDX-License-Identifier: Apache-2.0
#include "onset_writers.hpp"

#include <utility>

#include "page/number_text.hpp"
#include "protocol/answers.hpp"
#include "table.hpp"

namespace tribo::cli {
namespace {

class OnsetCsv : public OnsetWriter {
 public:
  explicit OnsetCsv(OutputStream& output) : text_(output.text()) {
    append(text_, "id,criterion,speed,film,film_parameter,reason\n");
  }

  void add(const Scene& scene, const std::vector<Onset<double>>& onsets) override {
    for (const Onset<double>& onset : onsets) add_row(scene, onset);
  }

 private:
  void add_row(const Scene& scene, const Onset<double>& onset) {
    append(text_, report::csv_text(scene.id));
    text_.push_back(',');
    append(text_, name(onset.criterion));
    for (const double value : {onset.speed, onset.film, onset.film_parameter}) {
      text_.push_back(',');
      if (onset.exists) protocol::append_number(text_, value);
    }
    text_.push_back(',');
    append(text_, report::csv_text(onset.reason));
    text_.push_back('\n');
  }

  Text& text_;
};

class OnsetJson : public OnsetWriter {
 public:
  explicit OnsetJson(OutputStream& output) : text_(output.text()) {}

  void add(const Scene& scene, const std::vector<Onset<double>>& onsets) override {
    for (const Onset<double>& onset : onsets) add_object(scene, onset);
  }

  void finish() override { append(text_, "\n]\n"); }

 private:
  void add_object(const Scene& scene, const Onset<double>& onset) {
    append(text_, std::exchange(before_, ",\n"));
    protocol::AnswerObject answer(text_, scene.id);
    answer.word("criterion", name(onset.criterion));
    add_value(answer, "speed", onset.speed, onset);
    add_value(answer, "film", onset.film, onset);
    add_value(answer, "film_parameter", onset.film_parameter, onset);
    answer.close();
  }

  static void add_value(protocol::AnswerObject& answer, std::string_view name, double value,
                        const Onset<double>& onset) {
    if (onset.exists)
      answer.number(name, value);
    else
      answer.undefined(name, onset.reason);
  }

  Text& text_;
  const char* before_ = "[\n";
};

class OnsetTable : public OnsetWriter {
 public:
  explicit OnsetTable(OutputStream& output) : text_(output.text()) {}

  void add(const Scene& scene, const std::vector<Onset<double>>& onsets) override {
    if (!std::exchange(first_, false)) text_.push_back('\n');
    append_title(text_, scene.id + ": onset of starvation");
    const std::vector<ColumnHead> heads{{"criterion", "", criterion_width},
                                        {"speed", "[m/s]", number_width},
                                        {"film", "[m]", number_width},
                                        {"film_parameter", "[-]", number_width}};
    append_heads(text_, heads);
    for (const Onset<double>& onset : onsets) add_row(onset);
  }

 private:
  static constexpr std::size_t criterion_width = name(OnsetCriterion::friction_minimum).size();

  void add_row(const Onset<double>& onset) {
    append_cell(text_, name(onset.criterion), criterion_width);
    if (onset.exists) {
      for (const double value : {onset.speed, onset.film, onset.film_parameter})
        append_cell(text_, readable(value), number_width);
    } else {
      append(text_, "  none: ");
      append(text_, onset.reason);
    }
    text_.push_back('\n');
  }

  Text& text_;
  bool first_ = true;
};

}  // namespace

std::unique_ptr<OnsetWriter> make_onset_writer(std::string_view format, OutputStream& output) {
  if (format == "csv") return std::make_unique<OnsetCsv>(output);
  if (format == "json") return std::make_unique<OnsetJson>(output);
  return std::make_unique<OnsetTable>(output);
}

}  // namespace tribo::cli
