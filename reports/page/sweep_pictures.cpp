// SPDX-License-Identifier: Apache-2.0
#include "page/sweep_pictures.hpp"

#include <filesystem>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "page/drawing.hpp"
#include "page/pending_file.hpp"
#include "page/sweep_picture_parts.hpp"

namespace tribo::report {
namespace {

namespace fs = std::filesystem;

// Names of all columns, each once, in the order of the scenes.
std::vector<std::string> column_names(const sweep::SweepResult& result) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const sweep::SceneResult& scene : result.scenes)
    for (const sweep::ColumnResult& column : scene.columns)
      if (seen.insert(column.name).second) names.push_back(column.name);
  return names;
}

void add(SweepPictures& to, std::optional<SweepPicture> picture) {
  if (!picture) return;
  to.figures.push_back(std::move(picture->figure));
  to.data.push_back(std::move(picture->data));
}

// Several scenes may have a map each.
void number_maps(SweepPicture& map, std::size_t number) {
  if (number == 1) return;
  const std::string old = map.figure.stem;
  map.figure.stem = old + '_' + std::to_string(number);
  map.data.path.replace(map.data.path.rfind(old), old.size(), map.figure.stem);
  map.figure.data = {map.data.path};
  map.figure.drawing.name = map.figure.stem;
}

}  // namespace

SweepPictures sweep_pictures(const sweep::SweepResult& result, const std::string& path) {
  SweepPictures pictures;
  add(pictures, onset_distribution(result));
  const std::vector<std::string> names = column_names(result);
  for (const std::string& name : names) add(pictures, sensitivity(result, name));
  std::size_t maps = 0;
  for (const sweep::SceneResult& scene : result.scenes)
    if (auto map = film_map(scene, path)) {
      number_maps(*map, ++maps);
      add(pictures, std::move(map));
    }
  for (const std::string& name : names) add(pictures, curve_band(result, name));
  return pictures;
}

DrawnPictures draw_sweep_pictures(const sweep::SweepResult& result, const std::string& path,
                                  const std::string& folder,
                                  const std::function<void(std::string_view)>& told) {
  DrawnPictures drawn;
  try {
    const fs::path gnuplot = find_places({}).render.parent_path() / "gnuplot";
    const fs::path out = fs::absolute(folder);
    make_folder(out);
    SweepPictures pictures = sweep_pictures(result, path);
    if (pictures.figures.empty()) told("nothing in this result can be drawn");
    for (const DataFile& file : pictures.data)
      write_file(out / fs::path(file.path).filename(), file.content);
    for (const Figure& figure : pictures.figures)
      for (const std::string_view format : {"svg", "png"}) {
        const fs::path target = fs::path(folder) / (figure.stem + '.' + std::string(format));
        const GnuplotRun run = draw_picture(gnuplot, figure.drawing, out, format, target);
        if (run.end == GnuplotEnd::drawn) {
          drawn.paths.push_back(target.string());
          continue;
        }
        drawn.failed = true;
        std::error_code ignored;
        fs::remove(target, ignored);  // an old one would not belong to the new data
        told(run.end == GnuplotEnd::not_found
                 ? run.message + ": no pictures (Debian: apt-get install gnuplot-nox)"
                 : target.string() + ": " + run.message);
        if (run.end == GnuplotEnd::not_found) return drawn;
      }
  } catch (const std::runtime_error& error) {
    told(error.what());
    drawn.failed = true;
  }
  return drawn;
}

}  // namespace tribo::report
