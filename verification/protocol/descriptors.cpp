// SPDX-License-Identifier: Apache-2.0
#include "protocol/descriptors.hpp"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace tribo::protocol {
namespace {

// After a failed call: is it worth trying again? Waits until it is.
bool try_again(int descriptor, short event) {
  if (errno == EINTR) return true;
  if (errno != EAGAIN) return false;
  pollfd ready{descriptor, event, 0};
  ::poll(&ready, 1, -1);
  return true;
}

}  // namespace

ssize_t read_some(int descriptor, char* to, std::size_t most) {
  ssize_t count = 0;
  do {
    count = ::read(descriptor, to, most);
  } while (count < 0 && try_again(descriptor, POLLIN));
  return count;
}

ssize_t write_some(int descriptor, const char* from, std::size_t count) {
  ssize_t written = 0;
  do {
    written = ::write(descriptor, from, count);
  } while (written < 0 && try_again(descriptor, POLLOUT));
  return written;
}

std::string system_message(int code) { return std::generic_category().message(code); }

}  // namespace tribo::protocol
