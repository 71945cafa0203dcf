// SPDX-License-Identifier: Apache-2.0
// The last bytes of a result or a part, behind all that HDF5 writes and reads: a mark, the size and
// the checksum (XXH3) of the bytes before them. They are checked before HDF5 opens the file,
// because a damaged file may crash or hang HDF5.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace tribo::sweep {

// Puts these bytes at the end of a whole, open file. Throws std::runtime_error where that fails.
void seal(int file);

// Says why an open file is not as it was sealed; empty if it is. `kind`: "result" or "part". Throws
// std::runtime_error, with a text that names the file by `path`, where it cannot be read, and
// Stopped once stopped() is true.
std::string broken_seal(int file, const std::string& path, std::string_view kind,
                        const std::function<bool()>& stopped = {});

}  // namespace tribo::sweep
