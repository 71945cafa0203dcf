// SPDX-License-Identifier: Apache-2.0
// tribocheck._library: the functions of tribocheck.h for Python, with arrays of numpy.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tribocheck.h"

namespace py = pybind11;

namespace {

constexpr std::size_t most_columns = 16;
constexpr std::size_t block = 1 << 15;  // points between two checks for Ctrl-C

using Array = py::array_t<double, py::array::c_style>;

// The code that a function of tribocheck.h returns, and the text that it writes. A text of `room`
// or more bytes needs a second call.
template <std::size_t room = 1 << 16, class Call, class... Given>
std::pair<int, std::string> told_by(Call call, Given... given) {
  std::string text(room, '\0');
  std::size_t length = 0;
  int code = 0;
  const auto ask = [&] {
    const py::gil_scoped_release released;
    code = call(given..., text.data(), text.size(), &length);
  };
  ask();
  if (length >= text.size()) {
    text.resize(length + 1);
    ask();
  }
  text.resize(length);
  return {code, text};
}

std::string text_or_error(const std::pair<int, std::string>& told) {
  if (told.first == TRIBOCHECK_REFUSED) throw py::value_error(told.second);
  return told.second;
}

template <class Call, class... Given>
std::string text_of(Call call, Given... given) {
  return text_or_error(told_by(call, given...));
}

// The attribute of numpy with this name.
py::object of_numpy(const char* name) { return py::module_::import("numpy").attr(name); }

Array numbers_of(const py::array& given, const std::string& what) {
  const char kind = given.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    throw py::type_error(what + " is an array of " + py::cast<std::string>(py::str(given.dtype())) +
                         ", not of numbers");
  return Array(given);
}

// The place of a point as people write it: "at index 17", "at index (2, 3)".
std::string place_text(std::size_t point, const std::vector<py::ssize_t>& shape) {
  std::string text;
  for (std::size_t k = shape.size(); k-- > 0;) {
    const auto extent = static_cast<std::size_t>(shape[k]);
    text.insert(0, std::to_string(point % extent) + (text.empty() ? "" : ", "));
    point /= extent;
  }
  return shape.size() == 1 ? "at index " + text : "at index (" + text + ")";
}

// One argument: a number for all points, or an array of the common shape.
struct Column {
  double number = 0;
  std::optional<Array> array;  // empty: it is a number
};

class Function {
 public:
  Function(std::string name, std::vector<std::string> parameters,
           std::vector<std::vector<std::string>> words, std::size_t results)
      : name_(std::move(name)),
        parameters_(std::move(parameters)),
        words_(std::move(words)),
        result_count_(results) {
    if (parameters_.size() > most_columns || result_count_ > most_columns ||
        words_.size() != parameters_.size())
      throw py::value_error("a function with too many columns");
  }

  // A number or an array; a tuple of these where the function has several results.
  py::object call(const py::tuple& given, bool masked) const {
    if (given.size() != parameters_.size()) throw py::type_error(name_ + ": too few arguments");
    std::array<Column, most_columns> columns;
    bool any_array = false;
    for (std::size_t k = 0; k < parameters_.size(); ++k) {
      columns[k] = column_of(k, given[k]);
      any_array |= columns[k].array.has_value();
    }
    return any_array ? of_arrays(columns, masked) : of_numbers(columns, masked);
  }

 private:
  std::string argument_text(std::size_t k) const { return name_ + ": " + parameters_[k]; }

  double code_of(std::size_t k, const std::string& word) const {
    const auto& words = words_[k];
    const auto found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return static_cast<double>(found - words.begin());
    std::string allowed;
    for (const std::string& one : words) allowed += (allowed.empty() ? "" : ", ") + one;
    throw py::value_error(argument_text(k) + ": \"" + word +
                          "\" is not known; allowed: " + allowed);
  }

  Column column_of(std::size_t k, const py::handle& given) const {
    Column column;
    if (!words_[k].empty()) {
      if (PyUnicode_Check(given.ptr()) != 0) {
        column.number = code_of(k, py::cast<std::string>(given));
        return column;
      }
      const py::array texts = of_numpy("asarray")(given);
      if (texts.dtype().kind() != 'U')
        throw py::type_error(argument_text(k) + " is no text, nor an array of texts");
      std::vector<py::ssize_t> shape(texts.shape(), texts.shape() + texts.ndim());
      double* to = column.array.emplace(shape).mutable_data();
      for (const py::handle one : texts.attr("ravel")())
        *to++ = code_of(k, py::cast<std::string>(one));
      return column;
    }
    if (PyFloat_Check(given.ptr()) != 0) {
      column.number = PyFloat_AS_DOUBLE(given.ptr());
      return column;
    }
    if (PyBool_Check(given.ptr()) != 0 || PyUnicode_Check(given.ptr()) != 0)
      throw py::type_error(argument_text(k) + " is no number");
    if (PyLong_Check(given.ptr()) != 0) {
      column.number = PyLong_AsDouble(given.ptr());
      if (PyErr_Occurred() != nullptr) throw py::error_already_set();
      return column;
    }
    column.array = numbers_of(of_numpy("asarray")(given), argument_text(k));
    return column;
  }

  // Gives all arrays the same shape.
  void broadcast(std::array<Column, most_columns>& columns) const {
    py::list arrays;
    std::string shapes;
    bool is_same = true;
    for (std::size_t k = 0; k < parameters_.size(); ++k) {
      if (!columns[k].array) continue;
      const py::object shape = columns[k].array->attr("shape");
      is_same &= arrays.empty() || shape.equal(arrays[0].attr("shape"));
      arrays.append(*columns[k].array);
      shapes += (shapes.empty() ? "" : ", ") + parameters_[k] + " " +
                py::cast<std::string>(py::str(shape));
    }
    if (is_same) return;
    try {
      const py::list wide = of_numpy("broadcast_arrays")(*arrays);
      std::size_t place = 0;
      for (Column& one : columns)
        if (one.array) one.array = Array(py::object(wide[place++]));
    } catch (const py::error_already_set& error) {
      if (!error.matches(PyExc_ValueError)) throw;
      throw py::value_error(name_ + ": shapes that do not go together: " + shapes);
    }
  }

  [[noreturn]] void refuse(const double* arguments, const std::string& place) const {
    const std::string fault = told_by(tribocheck_fault, name_.c_str(), arguments).second;
    throw py::value_error(name_ + (place.empty() ? "" : " " + place) + ": " + fault);
  }

  template <class One>
  py::object results_of(const One& one) const {
    if (result_count_ == 1) return one(0);
    py::tuple all(result_count_);
    for (std::size_t k = 0; k < result_count_; ++k) all[k] = one(k);
    return all;
  }

  py::object of_numbers(const std::array<Column, most_columns>& columns, bool masked) const {
    std::array<double, most_columns> numbers{}, found{};
    std::array<const double*, most_columns> argument{};
    std::array<double*, most_columns> result{};
    for (std::size_t k = 0; k < parameters_.size(); ++k) {
      numbers[k] = columns[k].number;
      argument[k] = &numbers[k];
    }
    for (std::size_t k = 0; k < result_count_; ++k) result[k] = &found[k];
    int status = TRIBOCHECK_FAILED;
    tribocheck_call(name_.c_str(), 1, argument.data(), nullptr, result.data(), &status);
    const bool is_done = status == TRIBOCHECK_DONE;
    if (!is_done && !masked) refuse(numbers.data(), "");
    const auto one = [&](double number) -> py::object {
      return is_done ? py::object(py::float_(number)) : of_numpy("ma").attr("masked");
    };
    return results_of([&](std::size_t k) { return one(found[k]); });
  }

  py::object of_arrays(std::array<Column, most_columns>& columns, bool masked) const {
    broadcast(columns);
    const auto widest = std::find_if(columns.begin(), columns.end(),
                                     [](const Column& one) { return one.array.has_value(); });
    const std::vector<py::ssize_t> shape(widest->array->shape(),
                                         widest->array->shape() + widest->array->ndim());
    const auto count = static_cast<std::size_t>(widest->array->size());
    std::vector<Array> results;
    for (std::size_t k = 0; k < result_count_; ++k) results.emplace_back(shape);
    py::array_t<bool> mask(masked ? shape : std::vector<py::ssize_t>{0});
    std::array<const double*, most_columns> argument{};
    std::array<std::size_t, most_columns> step{};
    std::array<double*, most_columns> result{};
    std::vector<int> status(std::min(block, count));
    for (std::size_t first = 0; first < count; first += block) {
      const std::size_t length = std::min(block, count - first);
      for (std::size_t k = 0; k < parameters_.size(); ++k) {
        step[k] = columns[k].array ? 1 : 0;
        argument[k] = columns[k].array ? columns[k].array->data() + first : &columns[k].number;
      }
      for (std::size_t k = 0; k < result_count_; ++k) result[k] = results[k].mutable_data() + first;
      const auto ask = [&](int* statuses) {
        const py::gil_scoped_release released;
        return tribocheck_call(name_.c_str(), length, argument.data(), step.data(), result.data(),
                               statuses);
      };
      if (masked) {
        ask(status.data());
        bool* const to = mask.mutable_data() + first;
        for (std::size_t i = 0; i < length; ++i) to[i] = status[i] != TRIBOCHECK_DONE;
      } else if (ask(nullptr) != 1) {
        ask(status.data());
        const auto at = static_cast<std::size_t>(
            std::find(status.begin(), status.end(), int{TRIBOCHECK_FAILED}) - status.begin());
        std::array<double, most_columns> numbers{};
        for (std::size_t k = 0; k < parameters_.size(); ++k) numbers[k] = argument[k][step[k] * at];
        refuse(numbers.data(), shape.empty() ? "" : place_text(first + at, shape));
      }
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
    const auto one = [&](const Array& numbers) -> py::object {
      if (masked) return of_numpy("ma").attr("masked_array")(numbers, mask);
      return shape.empty() ? py::object(py::float_(*numbers.data())) : py::object(numbers);
    };
    return results_of([&](std::size_t k) { return one(results[k]); });
  }

  std::string name_;
  std::vector<std::string> parameters_;
  std::vector<std::vector<std::string>> words_;  // of each parameter; empty: it is a number
  std::size_t result_count_;
};

std::optional<double> number_of(const std::string& text, const std::string& unit) {
  double number = 0;
  const int code = tribocheck_number(text.c_str(), unit.c_str(), &number);
  return code == TRIBOCHECK_OK ? std::optional(number) : std::nullopt;
}

// The speeds of a scene, or those of its curve.
Array speeds_of(const std::string& scene, bool is_curve, std::size_t count) {
  Array speeds(static_cast<py::ssize_t>(count));
  const char* const name = "speed";
  double* const result = speeds.mutable_data();
  const std::size_t columns = 1;
  if (is_curve)
    text_of(tribocheck_curve, scene.c_str(), count, columns, &name, &result);
  else
    text_of(tribocheck_solve, scene.c_str(), count, nullptr, columns, &name, &result);
  return speeds;
}

// Outputs at speeds, each as an array that has the shape of the speeds. An output that is a word is
// given by its code, −1 where it is undefined.
std::vector<py::array> solved(const std::string& scene, const py::array& given,
                              const std::vector<std::string>& outputs,
                              const std::vector<bool>& are_words) {
  const Array speeds = numbers_of(given, "speeds");
  const std::vector<py::ssize_t> shape(speeds.shape(), speeds.shape() + speeds.ndim());
  const auto count = static_cast<std::size_t>(speeds.size());
  for (std::size_t i = 0; i < count; ++i)
    if (const double speed = speeds.data()[i]; !(speed > 0 && std::isfinite(speed)))
      throw py::value_error("speeds" + (shape.empty() ? "" : " " + place_text(i, shape)) + ": " +
                            py::cast<std::string>(py::str(py::float_(speed))) +
                            " is not allowed; allowed: a number above 0, in m/s");
  constexpr std::size_t most = 2 * block;
  std::vector<py::array> columns;
  std::vector<const char*> names;
  std::vector<std::vector<double>> codes(outputs.size());
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    names.push_back(outputs[k].c_str());
    if (are_words.at(k)) {
      columns.emplace_back(py::array_t<std::int8_t>(shape));
      codes[k].resize(std::min(most, count));
    } else {
      columns.emplace_back(Array(shape));
    }
  }
  std::vector<double*> result(columns.size());
  std::size_t first = 0;
  do {  // runs once even without speeds, so that a faulty scene is told
    const std::size_t length = std::min(most, count - first);
    for (std::size_t k = 0; k < columns.size(); ++k)
      result[k] =
          are_words[k] ? codes[k].data() : static_cast<double*>(columns[k].mutable_data()) + first;
    text_of(tribocheck_solve, scene.c_str(), length, speeds.data() + first, names.size(),
            names.data(), result.data());
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (are_words[k])
        std::transform(codes[k].begin(), codes[k].begin() + static_cast<std::ptrdiff_t>(length),
                       static_cast<std::int8_t*>(columns[k].mutable_data()) + first,
                       [](double code) { return static_cast<std::int8_t>(code >= 0 ? code : -1); });
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    first += length;
  } while (first < count);
  return columns;
}

// Checks for Ctrl-C. Another number than 0 stops the solve; Python's exception stays set.
int stops(void*, int, int) {
  const py::gil_scoped_acquire held;
  return PyErr_CheckSignals();
}

// Solved films as JSON, with a profile of up to some megabytes.
std::string film(const std::string& scene, const std::string& request) {
  const auto told =
      told_by<1 << 22>(tribocheck_film, scene.c_str(), request.c_str(), stops, nullptr);
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  return text_or_error(told);
}

}  // namespace

PYBIND11_MODULE(_library, module) {
  module.def("version", &tribocheck_version);
  module.def("describe", [] { return text_of(tribocheck_describe); });
  module.def("cases",
             [](const std::string& request) { return text_of(tribocheck_cases, request.c_str()); });
  // Whether all that is offered holds, and the verdict's text.
  module.def("judge", [](const std::string& request, const std::string& answers) {
    const auto told = told_by<1 << 20>(tribocheck_judge, request.c_str(), answers.c_str());
    return std::pair(told.first == TRIBOCHECK_OK, text_or_error(told));
  });
  module.def("number", &number_of);
  module.def("describe_scene", [](const std::string& scene) {
    return text_of(tribocheck_describe_scene, scene.c_str());
  });
  module.def("speeds", &speeds_of);
  module.def("solve", &solved);
  module.def("onset", [](const std::string& scene, double departure) {
    return text_of(tribocheck_onset, scene.c_str(), departure);
  });
  module.def("film", &film);
  py::class_<Function>(module, "Function")
      .def(py::init<std::string, std::vector<std::string>, std::vector<std::vector<std::string>>,
                    std::size_t>())
      .def("call", &Function::call);
}
