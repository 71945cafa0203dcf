# SPDX-License-Identifier: Apache-2.0
# After find_package(tribocheck): include(tribocheck), and
#
#   tribocheck_add_subject(<test> COMMAND <word>… | PLUGIN <target or file>
#     [TOLERANCE strict|engineering|<file>] [BASELINE <file>] [REQUIRE <quantity>…] [SAMPLE <count>])
#
# adds the CTest test <test>: the solver is put to tribocheck's tests, and the test fails where it does
# (with BASELINE: where it does worse than that file says). A COMMAND that is a target of the project is
# its program.
# The target tribocheck::plugin has the plug-in's header.
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
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PLUGIN;TOLERANCE;BASELINE;SAMPLE" "COMMAND;REQUIRE")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "tribocheck_add_subject(${test}): ${arg_UNPARSED_ARGUMENTS}: not known")
  endif()
  if(arg_COMMAND AND NOT arg_PLUGIN)
    list(POP_FRONT arg_COMMAND program)
    if(TARGET ${program})
      set(program $<TARGET_FILE:${program}>)
    endif()
    list(PREPEND arg_COMMAND ${program})
    list(JOIN arg_COMMAND "' '" line)
    set(asked --subject "'${line}'")
  elseif(arg_PLUGIN AND NOT arg_COMMAND)
    if(TARGET ${arg_PLUGIN})
      set(arg_PLUGIN $<TARGET_FILE:${arg_PLUGIN}>)
    endif()
    set(asked --plugin ${arg_PLUGIN})
  else()
    message(FATAL_ERROR "tribocheck_add_subject(${test}): either COMMAND or PLUGIN")
  endif()
  foreach(option IN ITEMS TOLERANCE BASELINE SAMPLE)
    if(DEFINED arg_${option})
      string(TOLOWER ${option} name)
      list(APPEND asked --${name} ${arg_${option}})
    endif()
  endforeach()
  foreach(quantity IN LISTS arg_REQUIRE)
    list(APPEND asked --require ${quantity})
  endforeach()
  add_test(NAME ${test} COMMAND ${TRIBOCHECK_PROGRAM} verify ${asked})
endfunction()
