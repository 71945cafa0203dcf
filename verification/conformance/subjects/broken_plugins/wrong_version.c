/* SPDX-License-Identifier: Apache-2.0
 * Made for a header that is newer than this one. */
#include "tribocheck_plugin.h"

int tribocheck_plugin_version(void) { return TRIBOCHECK_PLUGIN_VERSION + 1; }
