# SPDX-License-Identifier: Apache-2.0
# After find_package(tribocheck): include(tribocheck), and
#
#   tribocheck_add_subject(<test> COMMAND <word>… | PLUGIN <target or file>
#     [TOLERANCE strict|engineering|<file>] [BASELINE <file>] [REQUIRE <quantity>…] [SAMPLE <count>]
#     [JUNIT <file>] [SPEED <baseline>])
#
# adds the CTest test <test>, which checks the solver by `tribocheck verify`. The test fails if the solver
# fails (with BASELINE: if it does worse than that file says). If the first word of COMMAND is a target of
# the project, its program is run. JUNIT writes the verdict on each quantity to a file.
# SPEED adds a second test, <test>_speed, with the label `speed`, which runs alone. It fails if the solver
# is slower than the baseline says. `tribocheck bench --subject COMMAND`, or `tribocheck bench --plugin LIB
# --alone`, makes the baseline with `--baseline <baseline> --update-baseline`. With JUNIT this test writes
# a file of its own, with _speed before the extension.
# The target tribocheck::plugin adds the folder of tribocheck_plugin.h.
find_program(TRIBOCHECK_PROGRAM tribocheck HINTS "${CMAKE_CURRENT_LIST_DIR}/../../../bin"
  "${CMAKE_CURRENT_LIST_DIR}/../../../../bin"
  DOC "The program tribocheck" REQUIRED)

find_path(TRIBOCHECK_PLUGIN_INCLUDE_DIR tribocheck_plugin.h
  HINTS "${CMAKE_CURRENT_LIST_DIR}/../../../include" "${CMAKE_CURRENT_LIST_DIR}/../../../../include"
  DOC "The folder of tribocheck_plugin.h" REQUIRED)
if(NOT TARGET tribocheck::plugin)
  add_library(tribocheck::plugin INTERFACE IMPORTED)
  target_include_directories(tribocheck::plugin INTERFACE ${TRIBOCHECK_PLUGIN_INCLUDE_DIR})
endif()

function(tribocheck_add_subject test)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PLUGIN;TOLERANCE;BASELINE;SAMPLE;JUNIT;SPEED" "COMMAND;REQUIRE")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "tribocheck_add_subject(${test}): ${arg_UNPARSED_ARGUMENTS}: not known")
  endif()
  if(arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "tribocheck_add_subject(${test}): no value: ${arg_KEYWORDS_MISSING_VALUES}")
  endif()
  if(arg_COMMAND AND NOT arg_PLUGIN)
    list(POP_FRONT arg_COMMAND program)
    if(TARGET ${program})
      set(program $<TARGET_FILE:${program}>)
    endif()
    # Plain words get no quotes, as if typed in a shell: a speed baseline names its solver by the command.
    set(words "")
    foreach(word IN LISTS program arg_COMMAND)
      if(NOT word MATCHES "^[A-Za-z0-9_./+=:@%,-]+$")
        string(REPLACE "'" "'\\''" word "${word}")  # as a shell writes an apostrophe
        set(word "'${word}'")
      endif()
      list(APPEND words "${word}")
    endforeach()
    list(JOIN words " " line)
    set(solver --subject "${line}")
  elseif(arg_PLUGIN AND NOT arg_COMMAND)
    if(TARGET ${arg_PLUGIN})
      set(arg_PLUGIN $<TARGET_FILE:${arg_PLUGIN}>)
    endif()
    set(solver --plugin ${arg_PLUGIN})
  else()
    message(FATAL_ERROR "tribocheck_add_subject(${test}): either COMMAND or PLUGIN")
  endif()

  set(options "")
  foreach(option IN ITEMS TOLERANCE BASELINE SAMPLE JUNIT)
    if(DEFINED arg_${option})
      string(TOLOWER ${option} name)
      list(APPEND options --${name} ${arg_${option}})
    endif()
  endforeach()
  foreach(quantity IN LISTS arg_REQUIRE)
    list(APPEND options --require ${quantity})
  endforeach()
  add_test(NAME ${test} COMMAND ${TRIBOCHECK_PROGRAM} verify ${solver} ${options})

  if(DEFINED arg_SPEED)
    set(options --baseline ${arg_SPEED})
    if(arg_PLUGIN)
      list(APPEND options --alone)  # without the contenders, whose program is not installed
    endif()
    if(DEFINED arg_JUNIT)
      cmake_path(GET arg_JUNIT EXTENSION LAST_ONLY extension)
      cmake_path(REMOVE_EXTENSION arg_JUNIT LAST_ONLY)
      list(APPEND options --junit ${arg_JUNIT}_speed${extension})
    endif()
    add_test(NAME ${test}_speed COMMAND ${TRIBOCHECK_PROGRAM} bench ${solver} ${options})
    set_tests_properties(${test}_speed PROPERTIES RUN_SERIAL TRUE LABELS speed)
  endif()
endfunction()
