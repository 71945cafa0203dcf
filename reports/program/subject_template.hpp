// SPDX-License-Identifier: Apache-2.0
// The templates of `tribocheck init`, in Mustache: what stands between {{#functions}} and
// {{/functions}} is written once for each function of the catalogue.
#pragma once

#include <string>

namespace tribo::cli {

// `next` is what a user types next, for {{next}}. Throws std::runtime_error with one line where
// `text`, which is that of the file `path`, is no Mustache.
std::string filled_template(const std::string& text, const std::string& path,
                            const std::string& next);

}  // namespace tribo::cli
