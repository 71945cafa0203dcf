// SPDX-License-Identifier: Apache-2.0
// What makes a file outlast a power failure.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>

namespace tribo::sweep {

inline std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == path.npos ? "." : path.substr(0, slash + 1);
}

// Sees to it that what was written to a file, or which files a folder has, is on the disk. Returns
// the number of the error, 0: none.
inline int sync_to_disk(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return errno;
  // EINVAL: a file system on which there is nothing to do.
  const int code = ::fsync(descriptor) == 0 || errno == EINVAL ? 0 : errno;
  ::close(descriptor);
  return code;
}

}  // namespace tribo::sweep
