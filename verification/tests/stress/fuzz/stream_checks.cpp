// SPDX-License-Identifier: Apache-2.0
// Checks of `tribocheck stream` on any bytes. The lines come from descriptors, as in the program.
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <system_error>
#include <vector>

#include "protocol/answers.hpp"
#include "stress/fuzz/checks.hpp"

namespace tribo::fuzz {
namespace {

using Json = nlohmann::json;

// Far below the program's 1 MiB, so that lines that are too long are common.
constexpr std::size_t longest_line = 1000;

// --- The stream.

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {
    if (number < 0) throw std::system_error(errno, std::generic_category());
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { ::close(number_); }
  int number() const { return number_; }

 private:
  int number_;
};

void write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0) throw std::system_error(errno, std::generic_category());
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

std::string contents(int descriptor) {
  std::string text(static_cast<std::size_t>(::lseek(descriptor, 0, SEEK_END)), '\0');
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count =
        ::pread(descriptor, text.data() + done, text.size() - done, static_cast<off_t>(done));
    if (count <= 0) throw std::system_error(errno, std::generic_category());
    done += static_cast<std::size_t>(count);
  }
  return text;
}

struct Streamed {
  std::string output;
  std::set<std::size_t> warned;  // numbers of lines
};

Streamed stream_from(int input) {
  const Descriptor output(::memfd_create("answers", 0));
  Streamed streamed;
  protocol::LineReader lines(input, longest_line);
  protocol::OutputStream to(output.number());
  protocol::answer_lines(lines, to, [&](std::size_t number, const std::vector<Validity>&) {
    streamed.warned.insert(number);
  });
  to.flush();
  streamed.output = contents(output.number());
  return streamed;
}

Streamed streamed_whole(std::string_view text) {
  const Descriptor input(::memfd_create("lines", 0));
  write_all(input.number(), text);
  ::lseek(input.number(), 0, SEEK_SET);
  return stream_from(input.number());
}

// Each read of a sequenced-packet socket gives one piece. All pieces fit the socket's buffer.
Streamed streamed_in_pieces(std::string_view text) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends.data()) != 0)
    throw std::system_error(errno, std::generic_category());
  const Descriptor reading(ends[0]);
  {
    const Descriptor writing(ends[1]);
    const std::size_t piece = std::max<std::size_t>(7, text.size() / 60);
    for (std::size_t at = 0; at < text.size(); at += piece)
      write_all(writing.number(), text.substr(at, piece));
  }
  return stream_from(reading.number());
}

// --- The input.

// The lines, as a text editor shows them, without "\r\n" and "\n".
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
  }
  return lines;
}

bool is_blank(std::string_view line) {
  return std::all_of(line.begin(), line.end(),
                     [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
}

// --- The output.

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

void check_error(const Json& answer, const std::string& text) {
  require(answer.size() == 2, "an answer with an error has nothing else", text);
  const Json& error = answer["error"];
  require(error.is_object() && error.size() == 2, "an error is a field and a message", text);
  require(error.value("field", Json()).is_string(), "an error has a field", text);
  require(error.value("message", Json()).is_string(), "an error has a message", text);
  require(!error["message"].get<std::string>().empty(), "an error says something", text);
  for (const char* part : {"field", "message"}) {
    const std::string words = error[part];
    require(std::none_of(words.begin(), words.end(), is_control), "an error is one line", text);
  }
}

// Nulls and reasons for them come in pairs.
void check_undefined(const Json& answer, const std::string& text) {
  const Json reasons = answer.value("undefined", Json::object());
  require(reasons.is_object(), "the reasons are an object", text);
  require(!answer.contains("undefined") || !reasons.empty(), "reasons where there are any", text);
  std::size_t nulls = 0;
  for (const auto& [name, value] : answer.items()) {
    if (name == "id" || !value.is_null()) continue;
    ++nulls;
    require(reasons.contains(name) && reasons[name].is_string(), "a null has a reason", text);
    require(!reasons[name].get<std::string>().empty(), "a reason says something", text);
  }
  require(nulls == reasons.size(), "a reason has a null", text);
}

bool is_share(double number) { return number >= 0 && number <= 1; }

// The number, or `otherwise` where it is undefined or was not asked for.
double number_or(const Json& answer, const char* name, double otherwise) {
  const auto found = answer.find(name);
  if (found == answer.end() || !found->is_number()) return otherwise;
  return found->get<double>();
}

void check_point(const Json& answer, const std::string& text) {
  std::size_t outputs = 0;
  for (const auto& [name, value] : answer.items()) {
    if (name == "id" || name == "undefined") continue;
    ++outputs;
    const std::optional<Output> output = output_by_name(name);
    require(output.has_value(), "an output is known", text);
    const bool word = output == Output::regime || output == Output::inlet;
    require(value.is_null() || (word ? value.is_string() : value.is_number()),
            "an output has its type", text);
    require(!value.is_number() || value.get<double>() >= 0, "no output is negative", text);
  }
  require(outputs > 0, "an answer has outputs", text);
  const double asperity = number_or(answer, "asperity_load_share", 0.5);
  const double fluid = number_or(answer, "fluid_load_share", 0.5);
  require(is_share(asperity) && is_share(fluid), "a share is a share", text);
  if (answer.contains("asperity_load_share") && answer.contains("fluid_load_share")) {
    require(answer["asperity_load_share"].is_null() == answer["fluid_load_share"].is_null(),
            "both shares or none", text);
    require(std::abs(asperity + fluid - 1) < 1e-12, "the shares add up", text);
  }
  const double film = number_or(answer, "film", 0);
  require(film <= number_or(answer, "film_flooded", HUGE_VAL), "no film beyond the flooded", text);
  require(film <= number_or(answer, "separation", HUGE_VAL), "the faces are a film apart", text);
  if (answer.value("inlet", Json()) == "collapsed")
    require(film == 0 && number_or(answer, "film_parameter", 0) == 0, "no film where it collapsed",
            text);
  // Without a film and a floor nothing balances the load: there are no shares and no friction.
  if (answer.value("regime", Json()) == "collapsed")
    for (const char* none : {"asperity_load_share", "fluid_load_share", "friction"})
      require(!answer.contains(none) || answer[none].is_null(), "nothing balances the load", text);
}

// The names of the values of each function that gives more than one.
const std::map<std::string_view, std::vector<const char*>> parts_of_functions{
    {"hertz_point", {"radius", "mean_pressure", "peak_pressure", "approach"}},
    {"hertz_ellipse",
     {"semi_axis_x", "semi_axis_y", "ellipticity", "mean_pressure", "peak_pressure", "approach"}},
    {"hertz_line", {"half_width", "mean_pressure", "peak_pressure", "peak_shear"}},
    {"reduced_radius", {"radius_x", "radius_y", "reduced_radius"}},
    {"lambda_ratio", {"composite_roughness", "lambda_ratio"}},
    {"summits_from_spectral_moments",
     {"bandwidth", "summit_density", "summit_radius", "summit_height_sd", "summit_plane_offset"}}};

void check_function(const Json& question, const Json& answer, const std::string& text) {
  const std::string name = question["function"];
  if (const auto several = parts_of_functions.find(name); several != parts_of_functions.end()) {
    for (const char* part : several->second)
      require(answer.contains(part) && number_or(answer, part, 0) >= 0,
              "a part is there, and not negative", text);
    require(number_or(answer, "mean_pressure", 0) <= number_or(answer, "peak_pressure", HUGE_VAL),
            "no mean above the peak", text);
    return;
  }
  require(answer.contains("value"), "a function has a value", text);
  const double value = number_or(answer, "value", 0);
  require(value >= 0 || name == "viscosity_index", "no value is negative", text);
  if (name == "starvation_ratio") require(is_share(value), "the starved film is a share", text);
  if (name == "gupta_thermal_reduction" || name == "murch_wilson_thermal_reduction")
    require(is_share(value), "heating does not thicken the film", text);
  if (name == "persson_contact_area" || name == "patir_cheng_pressure_flow")
    require(is_share(value), "no more than the whole face touches, or flows", text);
  if (name == "dowson_higginson_density" && answer["value"].is_number())
    require(value >= 1 && value <= 1.3400001, "an oil is at most 34 % denser", text);
  if (name == "load_sharing" && answer["value"].is_number())
    require(value >= question["flooded_film_parameter"].get<double>(),
            "asperities only add to the film", text);
  if (name == "gaussian_moment" && question["order"] == 0)
    require(is_share(value), "a probability is a share", text);
}

void check_answer(std::string_view line, const std::string& text, bool plausible) {
  const Json answer = Json::parse(text, nullptr, false);
  require(answer.is_object(), "an answer is JSON", text);
  require(answer.contains("id"), "an answer has an id", text);
  require(answer["id"].is_null() || answer["id"].is_string() || answer["id"].is_number(),
          "an id is null, a text or a number", text);
  if (answer.contains("error")) return check_error(answer, text);
  check_undefined(answer, text);
  const Json question = Json::parse(line, nullptr, false);
  require(question.is_object(), "what is no JSON gets an error", text);
  require(answer["id"] == question.value("id", Json()), "the id comes back", text);
  if (question.contains("function")) return check_function(question, answer, text);
  check_point(answer, text);
  require(!plausible || text.find(protocol::beyond_double) == std::string::npos,
          "plausible inputs never overflow", text);
}

}  // namespace

void check_stream(std::string_view text) {
  const Streamed streamed = streamed_whole(text);
  require(streamed.output == streamed_in_pieces(text).output, "pieces make no difference");
  std::string_view rest = streamed.output;
  std::size_t number = 0;
  for (const std::string_view line : lines_of(text)) {
    ++number;
    if (line.size() <= longest_line && is_blank(line)) continue;
    const std::size_t end = rest.find('\n');
    require(end != std::string_view::npos, "each line has an answer", line);
    const std::string answer(rest.substr(0, end));
    rest.remove_prefix(end + 1);
    const bool may_accept = line.find("accept") != std::string_view::npos;
    check_answer(line, answer, !may_accept && streamed.warned.count(number) == 0);
    if (line.size() > longest_line) {
      require(answer.find("over 1 MiB") != std::string::npos, "too long a line is told", answer);
      continue;
    }
    check_ordinary_scene(line);
    protocol::Text alone;
    std::vector<Validity> passed;
    protocol::append_answer(alone, line, number, passed);
    require(std::string_view(alone.data(), alone.size()) == answer + '\n',
            "an answer does not depend on its place", answer);
  }
  require(rest.empty(), "no answer without a line", rest);
}

}  // namespace tribo::fuzz
