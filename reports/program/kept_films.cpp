// SPDX-License-Identifier: Apache-2.0
#include "kept_films.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "protocol/bounded_json.hpp"
#include "sweep/output_file.hpp"

namespace tribo::cli {
namespace {

constexpr std::string_view mark = "tribocheck films 1\n";

bool is_mark(std::span<const std::byte> start) {
  return std::string_view(reinterpret_cast<const char*>(start.data()), start.size())
      .starts_with(mark);
}

void append_to(int file, std::string_view text, const std::string& path) try {
  sweep::write_all(file, text);
} catch (const std::runtime_error& error) {
  throw std::runtime_error("cannot write " + path + ": " + error.what());
}

}  // namespace

KeptFilms::KeptFilms(const std::string& path) : path_(path) {
  const sweep::FilePlace place(path);
  while (file_ < 0) {
    auto opened = place.open_ours(is_mark);
    if (!opened) opened = place.create();
    if (opened) file_ = std::move(*opened);
  }
  if (sweep::lock_file(file_, path) == sweep::Locking::taken_by_another)
    throw sweep::RunRefused("another process keeps its films in " + path);
  read();
}

void KeptFilms::read() {
  const std::string what = "cannot read " + path_;
  std::string text(sweep::size_of(file_, what), '\0');
  text.resize(sweep::read_at(file_, 0, std::as_writable_bytes(std::span(text)), what));
  text.resize(text.rfind('\n') + 1);
  if (::ftruncate(file_, static_cast<off_t>(text.size())) != 0 || ::lseek(file_, 0, SEEK_END) < 0)
    throw std::runtime_error("cannot write " + path_ + ": " + sweep::error_text(errno));
  if (text.empty()) return append_to(file_, mark, path_);
  int number = 1;
  for (std::size_t at = mark.size(), end = 0; at < text.size(); at = end + 1) {
    end = text.find('\n', at);
    ++number;
    try {
      const auto line = protocol::parse_bounded_json(std::string_view(text).substr(at, end - at));
      films_[line.at("contact")] = {line.at("reason"), line.at("text")};
    } catch (const std::exception&) {
      throw sweep::RunRefused(fmt::format(
          "{}: line {} is no film that tribocheck has kept; allowed: the file without this line",
          path_, number));
    }
  }
}

const KeptFilm* KeptFilms::find(const std::string& contact) const {
  const auto found = films_.find(contact);
  return found == films_.end() ? nullptr : &found->second;
}

void KeptFilms::keep(const std::string& contact, const KeptFilm& film) {
  const nlohmann::ordered_json line{
      {"contact", contact}, {"reason", film.reason}, {"text", film.text}};
  append_to(file_, line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n',
            path_);
  films_[contact] = film;
}

}  // namespace tribo::cli
