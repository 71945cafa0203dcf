// SPDX-License-Identifier: Apache-2.0
// The commands write to the stream of the protocol's answers.
#pragma once

#include "protocol/text_streams.hpp"

namespace tribo::cli {

using protocol::append;
using protocol::OutputClosed;
using protocol::OutputFailed;
using protocol::OutputStream;
using protocol::Text;

}  // namespace tribo::cli
