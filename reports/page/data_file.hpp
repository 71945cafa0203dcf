// SPDX-License-Identifier: Apache-2.0
// A file of data that the report leaves beside its page.
#pragma once

#include <string>

namespace tribo::report {

struct DataFile {
  std::string path;  // below the report's folder
  std::string content;
};

}  // namespace tribo::report
