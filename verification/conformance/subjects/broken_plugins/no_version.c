/* SPDX-License-Identifier: Apache-2.0
 * A shared library, but no plug-in. */
#include "tribocheck_plugin.h"

const char* tribocheck_plugin_name(void) { return "no version"; }
