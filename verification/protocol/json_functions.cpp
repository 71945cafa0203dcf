// SPDX-License-Identifier: Apache-2.0
// The model's answers to calls of its functions.
#include "protocol/answer_object.hpp"
#include "protocol/json_answers.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/gaussian_moment.hpp"
#include "tribo/hertz.hpp"
#include "tribo/load_sharing.hpp"
#include "tribo/starvation.hpp"

namespace tribo::protocol {
namespace {

template <class Enum>
Enum enum_at(double place) {
  return static_cast<Enum>(static_cast<int>(place));
}

void answer_hertz_point(AnswerObject& answer, const FunctionArguments& given) {
  const HertzPoint<double> hertz = hertz_point(given[0], given[1], given[2]);
  answer.number("radius", hertz.radius);
  answer.number("mean_pressure", hertz.mean_pressure);
  answer.number("peak_pressure", hertz.peak_pressure);
  answer.number("approach", hertz.approach);
}

double load_sharing(const FunctionArguments& given) {
  const LoadSharing<double> sharing(enum_at<AsperityModel>(given[0]), given[2], given[3]);
  return sharing.solve(given[1]).film_parameter;
}

void answer(AnswerObject& answer, Function function, const FunctionArguments& given) {
  switch (function) {
    case Function::gaussian_moment:
      return answer.number("value", gaussian_moment(enum_at<Order>(2 * given[0]), given[1]));
    case Function::hertz_point:
      return answer_hertz_point(answer, given);
    case Function::hamrock_dowson_central:
      return answer.number("value", hamrock_dowson_central(given[0], given[1], given[2], given[3],
                                                           given[4], given[5], given[6]));
    case Function::starvation_ratio:
      return answer.number(
          "value", starvation_ratio(enum_at<StarvationClosure>(given[0]), given[1], given[2]));
    case Function::load_sharing:
      return answer.number("value", load_sharing(given));
  }
}

}  // namespace

void append_function_answer(Text& to, const FunctionCall& call) {
  if (call.mistake) return append_error(to, call.id, call.mistake->field, call.mistake->message);
  AnswerObject object(to, call.id);
  answer(object, call.function, call.arguments);
  object.close();
  to.push_back('\n');
}

}  // namespace tribo::protocol
