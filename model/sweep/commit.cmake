# SPDX-License-Identifier: Apache-2.0
# Writes the header with the commit of the build, if the commit has changed. Run at each build.
execute_process(COMMAND git describe --always --dirty --abbrev=40 --exclude "*"
  WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit "")  # no git, or no checkout
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "inline constexpr const char* build_commit = \"${commit}\";  // empty: not known\n" @ONLY)
