// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "page/drawing.hpp"
#include "page/markup.hpp"
#include "page/page.hpp"

namespace tribo::report {
namespace {

using Json = nlohmann::ordered_json;

Json plain_texts(const std::vector<std::string>& markup) {
  Json texts = Json::array();
  for (const std::string& one : markup) texts.push_back(to_plain(one));
  return texts;
}

Json table_object(const TextTable& table) {
  Json columns = Json::array(), rows = Json::array();
  for (std::size_t i = 0; i < table.headings.size(); ++i)
    columns.push_back(
        {{"name", to_plain(table.headings[i])}, {"is_number", bool{table.is_number[i]}}});
  for (const auto& row : table.rows) rows.push_back(plain_texts(row));
  Json object{{"caption", to_plain(table.caption)},
              {"columns", std::move(columns)},
              {"rows", std::move(rows)},
              {"note", to_plain(table.note)}};
  if (!table.data.empty()) object["data"] = table.data;
  return object;
}

Json figure_object(const Figure& figure) {
  const bool is_drawn = !figure.svg.empty();
  return {{"id", figure.stem},
          {"heading", to_plain(figure.heading)},
          {"caption", to_plain(figure.caption)},
          {"alternative", figure.alternative},
          {"svg", is_drawn ? Json(picture_path(figure, "svg")) : Json()},
          {"png", is_drawn ? Json(picture_path(figure, "png")) : Json()},
          {"data", figure.data}};
}

Json section_object(const Section& section) {
  Json tables = Json::array(), figures = Json::array(), not_run = Json::array(),
       files = Json::array();
  for (const TextTable& table : section.tables) tables.push_back(table_object(table));
  for (const Figure& figure : section.figures) figures.push_back(figure_object(figure));
  for (const NotRun& one : section.not_run)
    not_run.push_back({{"what", to_plain(one.what)},
                       {"why", to_plain(one.why)},
                       {"how_to", to_plain(one.how_to)}});
  for (const DataFile& file : section.data) files.push_back(file.path);
  return {{"id", section.id},
          {"title", to_plain(section.title)},
          {"paragraphs", plain_texts(section.paragraphs)},
          {"tables", std::move(tables)},
          {"figures", std::move(figures)},
          {"data", std::move(files)},
          {"not_run", std::move(not_run)}};
}

}  // namespace

std::string json_page(const Page& page) {
  Json all{{"title", page.title}, {"introduction", plain_texts(page.introduction)}};
  Json& lines = all["verdicts"] = Json::array();
  for (const PlacedVerdict& one : verdicts(page))
    lines.push_back({{"standing", standing_word(one.verdict.standing)},
                     {"subject", to_plain(one.verdict.subject)},
                     {"text", to_plain(one.verdict.text)},
                     {"section", one.section}});
  Json& sections = all["sections"] = Json::array();
  for (const Section& section : page.sections) sections.push_back(section_object(section));
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace tribo::report
