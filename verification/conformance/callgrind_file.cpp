// SPDX-License-Identifier: Apache-2.0
// The format: https://valgrind.org/docs/manual/cl-format.html. `fn=(7) name` begins the costs of a
// function; later lines have only its number, `fn=(7)`. A cost is `LINE INSTRUCTIONS`. The cost
// after `calls=COUNT LINE` is that of the calls, at the caller's line.
#include "conformance/callgrind_file.hpp"

#include <charconv>
#include <stdexcept>
#include <string_view>
#include <tuple>

namespace tribo::conformance {
namespace {

class Reader {
 public:
  explicit Reader(const std::function<CallGraph::Kind(const std::string&)>& kind_of)
      : kind_of_(kind_of) {}

  void take(std::string_view line) {
    const std::size_t equals = line.find('=');
    if (line.empty())
      return;
    else if (is_position(line.front()))
      take_cost(line);
    else if (equals != line.npos)
      take_name(line.substr(0, equals), line.substr(equals + 1));
    else if (line == "events: Ir")
      has_instructions_ = true;
  }

  CallGraph finish() {
    if (!has_instructions_ || graph_.functions.empty())
      throw std::runtime_error("it is no file of callgrind that counts instructions");
    return std::move(graph_);
  }

 private:
  using Names = std::map<std::string, std::string, std::less<>>;

  static bool is_position(char first) {
    return (first >= '0' && first <= '9') || first == '+' || first == '-' || first == '*';
  }

  static std::uint64_t number(std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
      throw std::runtime_error("\"" + std::string(text) + "\" is no number of callgrind");
    return value;
  }

  // The name in "(7) name", in a later "(7)", or in "name" if names are not numbered.
  static const std::string& name_of(Names& names, std::string_view text) {
    const std::size_t close = text.starts_with('(') ? text.find(')') : text.npos;
    const std::string_view key = close == text.npos ? text : text.substr(0, close + 1);
    const auto known = names.find(key);
    if (known != names.end()) return known->second;
    const std::string_view name = close == text.npos         ? text
                                  : close + 2 <= text.size() ? text.substr(close + 2)
                                                             : std::string_view();
    return names.emplace(key, name).first->second;
  }

  std::size_t function_of(const std::string& object, const std::string& file,
                          const std::string& name) {
    const auto [place, is_new] =
        places_.try_emplace(std::tuple(object, file, name), graph_.functions.size());
    if (is_new) graph_.functions.push_back({name, object, kind_of_(object), 0, {}});
    return place->second;
  }

  void take_name(std::string_view key, std::string_view value) {
    if (key == "ob") {
      object_ = name_of(objects_, value);
    } else if (key == "fl" || key == "fi" || key == "fe") {
      file_ = name_of(files_, value);
      if (key == "fl") first_file_ = file_;
    } else if (key == "fn") {
      function_ = function_of(object_, first_file_, name_of(functions_, value));
      file_ = first_file_;
      has_function_ = true;
    } else if (key == "cob") {
      called_object_ = name_of(objects_, value);
      names_object_ = true;
    } else if (key == "cfi" || key == "cfl") {
      called_file_ = name_of(files_, value);
      names_file_ = true;
    } else if (key == "cfn") {
      called_name_ = name_of(functions_, value);
    } else if (key == "calls") {
      call_count_ = number(value.substr(0, value.find(' ')));
      is_call_ = true;
    }
  }

  void take_cost(std::string_view line) {
    const std::size_t blank = line.find(' ');
    const std::string_view position = line.substr(0, blank);
    const std::uint64_t given =
        position == "*" ? 0 : number(position.substr(is_relative(position)));
    if (position.front() == '+')
      line_ += given;
    else if (position.front() == '-')
      line_ -= given;
    else if (position != "*")
      line_ = given;
    if (blank == line.npos) return;  // a line without instructions
    if (!has_function_) throw std::runtime_error("a cost stands before the first function");
    const auto cost = static_cast<double>(number(line.substr(blank + 1)));
    const CallGraph::Line where{file_ == "???" ? std::string() : file_, line_};
    if (!is_call_) {
      graph_.functions[function_].cost[where] += cost;
      return;
    }
    const std::size_t callee = function_of(names_object_ ? called_object_ : object_,
                                           names_file_ ? called_file_ : file_, called_name_);
    graph_.functions[callee].calls += call_count_;
    graph_.calls.push_back({function_, callee, where, cost});
    is_call_ = names_object_ = names_file_ = false;
  }

  static std::size_t is_relative(std::string_view position) {
    return position.front() == '+' || position.front() == '-' ? 1 : 0;
  }

  const std::function<CallGraph::Kind(const std::string&)>& kind_of_;
  CallGraph graph_;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> places_;
  Names objects_, files_, functions_;
  std::string object_, file_, first_file_;
  std::string called_object_, called_file_, called_name_;
  std::size_t function_ = 0;
  std::uint64_t line_ = 0, call_count_ = 0;
  bool has_instructions_ = false, has_function_ = false, is_call_ = false;
  bool names_object_ = false, names_file_ = false;
};

}  // namespace

CallGraph read_callgrind(std::istream& text,
                         const std::function<CallGraph::Kind(const std::string&)>& kind_of) {
  Reader reader(kind_of);
  for (std::string line; std::getline(text, line);) reader.take(line);
  return reader.finish();
}

}  // namespace tribo::conformance
