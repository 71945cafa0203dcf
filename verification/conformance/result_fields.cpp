// SPDX-License-Identifier: Apache-2.0
#include "conformance/result_fields.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "protocol/answers.hpp"

namespace tribo::conformance {
namespace {

using protocol::OutputValue;
using protocol::Text;
using Id = std::optional<std::string_view>;

struct Field {
  std::string_view name;
  std::optional<OutputValue> value;  // none: not offered
};
using Fields = std::vector<Field>;

std::optional<OutputValue> value_of(double number,
                                    std::string_view undefined = protocol::beyond_double) {
  if (is_not_offered(number)) return std::nullopt;
  if (std::isnan(number)) return OutputValue{.undefined = {}, .word = "NaN"};
  if (std::isinf(number)) return OutputValue{.undefined = undefined, .word = {}};
  return OutputValue{.undefined = {}, .word = {}, .number = number};
}

template <class Word>
std::optional<OutputValue> value_of(const WordResult<Word>& result) {
  using Kind = typename WordResult<Word>::Kind;
  if (result.kind == Kind::absent) return std::nullopt;
  if (result.kind == Kind::undefined)
    return OutputValue{.undefined = protocol::beyond_double, .word = {}};
  return OutputValue{.undefined = {}, .word = name(result.word)};
}

template <class Word>
bool is(const WordResult<Word>& result, Word word) {
  return result.kind == WordResult<Word>::Kind::word && result.word == word;
}

// A number that rests on the balance of the load; where nothing balances it NaN says that there is
// none.
std::optional<OutputValue> of_balance(double number, const PointResult& point) {
  const bool has_collapsed = is(point.inlet, Inlet::collapsed);
  if (std::isnan(number) && is(point.regime, Regime::collapsed))
    return OutputValue{.undefined = protocol::film_collapsed, .word = {}};
  return value_of(number, has_collapsed ? protocol::film_collapsed : protocol::beyond_double);
}

std::optional<OutputValue> value_of(const PointResult& point, Output output) {
  switch (output) {
    case Output::film_flooded:
      return value_of(point.film_flooded);
    case Output::film:
      return value_of(point.film);
    case Output::separation:
      return value_of(point.separation);
    case Output::film_parameter:
      return value_of(point.film_parameter);
    case Output::asperity_load_share:
      return of_balance(point.asperity_load_share, point);
    case Output::fluid_load_share:
      return of_balance(point.fluid_load_share, point);
    case Output::real_area_ratio:
      return value_of(point.real_area_ratio);
    case Output::summit_count:
      return value_of(point.summit_count);
    case Output::friction:
      return of_balance(point.friction, point);
    case Output::regime:
      return value_of(point.regime);
    case Output::inlet:
      return value_of(point.inlet);
  }
  return std::nullopt;
}

Fields fields_of(const catalogue::Results& values, const catalogue::Function& function) {
  Fields fields;
  for (std::size_t i = 0; i < function.results.size(); ++i)
    fields.push_back({function.results[i].name, value_of(values[i])});
  return fields;
}

Fields fields_of(const PointResult& point, OutputSet asked) {
  Fields fields;
  for (const OutputInfo& output : output_infos)
    if (asked.contains(output.output))
      fields.push_back({output.name, value_of(point, output.output)});
  return fields;
}

void append_fields(Text& to, Id id, const Fields& fields) {
  protocol::AnswerObject object(to, id);
  for (const Field& field : fields)
    if (field.value) object.value(field.name, *field.value);
  object.close();
  to.push_back('\n');
}

void append_undefined(Text& to, Id id, const Fields& fields, std::string_view reason) {
  protocol::AnswerObject object(to, id);
  for (const Field& field : fields) object.undefined(field.name, reason);
  object.close();
  to.push_back('\n');
}

// `asked`: what fields_of() takes beside the result.
template <class Result, class Asked>
void append_line(Text& to, Id id, const Answer<Result>& answer, const Asked& asked) {
  switch (answer.status) {
    case Status::done:
      return append_fields(to, id, fields_of(answer.result, asked));
    case Status::skipped:
      return append_skip_line(to, id, answer.reason);
    case Status::undefined:
      return append_undefined(to, id, fields_of(answer.result, asked), answer.reason);
    case Status::failed:
      return protocol::append_error(to, id, "", answer.reason);
  }
}

}  // namespace

void append_answer_line(Text& to, Id id, const Answer<catalogue::Results>& answer,
                        const catalogue::Function& function) {
  const bool has_one = function.results.size() == 1;
  if (answer.status == Status::done && has_one && std::isnan(answer.result[0]))
    return protocol::append_error(to, id, "", "the solver gave NaN");
  append_line(to, id, answer, function);
}

void append_answer_line(Text& to, Id id, const Answer<PointResult>& answer, OutputSet asked) {
  append_line(to, id, answer, asked);
}

void append_skip_line(Text& to, Id id, std::string_view reason) {
  protocol::AnswerObject object(to, id);
  object.word("skip", reason);
  object.close();
  to.push_back('\n');
}

}  // namespace tribo::conformance
