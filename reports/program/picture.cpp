// SPDX-License-Identifier: Apache-2.0
#include "picture.hpp"

#include <filesystem>
#include <stdexcept>

#include "messages.hpp"
#include "page/project_files.hpp"
#include "page/rendering.hpp"
#include "sweep/output_file.hpp"

namespace tribo::cli {

void add_picture_option(CLI::App& app, std::string& picture, const std::string& subject) {
  app.add_option("--picture", picture,
                 "draw " + subject + ": a file .png or .svg (needs gnuplot and python3)")
      ->check([](const std::string& name) {
        const std::string ending = std::filesystem::path(name).extension().string();
        return ending == ".png" || ending == ".svg"
                   ? std::string()
                   : name + " is not allowed; allowed: a name that ends in .png or .svg";
      });
}

bool draw_picture(const std::string& script, std::string_view data, const std::string& picture) {
  try {
    // The file is removed at the end. It is not in the picture's folder: if nothing can be written
    // there, the message has to name the picture.
    const sweep::PartFile file(std::filesystem::temp_directory_path() / "tribocheck-picture.json");
    file.write(data);
    const report::Rendering drawn =
        report::run_script(report::usual_places(), script, {file.path(), picture});
    for (const std::string& why : drawn.undrawn) complain(why);
    for (const std::string& one : drawn.written) complain("drew " + one);
    return drawn.undrawn.empty();
  } catch (const std::runtime_error& error) {
    complain(error.what());
    return false;
  }
}

}  // namespace tribo::cli
