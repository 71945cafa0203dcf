# SPDX-License-Identifier: Apache-2.0
# cmake -D BUILD_DIR=… -D SCRATCH=… -D CONSUMER=… -D COMPILER=… -D GENERATOR=… -D VERSION=…
#       -D SOURCE_DIR=… -P this
set(prefix ${SCRATCH}/prefix)
file(REMOVE_RECURSE ${SCRATCH})

function(run)
  execute_process(COMMAND ${ARGV} OUTPUT_VARIABLE out ERROR_VARIABLE out RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    list(JOIN ARGV " " line)
    message(FATAL_ERROR "${line}: ${code}\n${out}")
  endif()
  set(output "${out}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})

# A consumer is not asked for what only the build of the library needs; Highway is linked with it.
file(GLOB_RECURSE package_files ${prefix}/tribocheck*.cmake)
if(NOT package_files)
  message(FATAL_ERROR "no CMake package under ${prefix}")
endif()
foreach(file IN LISTS package_files)
  file(STRINGS ${file} leaks REGEX "nlohmann|tomlplusplus|CLI11|fmt::|[Gg][Ss][Ll]|find_dependency")
  list(FILTER leaks EXCLUDE REGEX "^find_dependency\\(hwy\\)$")
  if(leaks)
    message(FATAL_ERROR "${file} asks consumers for: ${leaks}")
  endif()
endforeach()

# A header forgotten on the list in model/CMakeLists.txt builds here, and is missing there.
file(GLOB headers RELATIVE ${SOURCE_DIR}/model ${SOURCE_DIR}/model/include/tribo/*.hpp)
file(GLOB scenes RELATIVE ${SOURCE_DIR}/reference
  ${SOURCE_DIR}/reference/published/*.toml ${SOURCE_DIR}/reference/published/*.tsv)
if(NOT headers OR NOT scenes)
  message(FATAL_ERROR "no headers or no scenes under ${SOURCE_DIR}")
endif()
list(TRANSFORM scenes PREPEND share/tribocheck/)
foreach(file IN LISTS headers scenes
    ITEMS include/tribo/version.hpp share/doc/tribocheck/LICENSE
    share/tribocheck/scene.schema.json share/tribocheck/gnuplot)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()

run(${prefix}/bin/tribocheck --version)
if(NOT output MATCHES "${VERSION}")
  message(FATAL_ERROR "the installed program calls itself: ${output}")
endif()

set(newcomer ${SOURCE_DIR}/verification/conformance/subjects/small_python/my_solver.py)
# What the newcomer's solver did before it was looked at; its test, gated by that, passes.
execute_process(COMMAND ${prefix}/bin/tribocheck verify --subject "/usr/bin/python3 ${newcomer}" --sample 50
  --baseline ${SCRATCH}/newcomer.json --update-baseline OUTPUT_QUIET ERROR_QUIET)
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${SCRATCH}/build -G ${GENERATOR}
  -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${prefix}
  -D NEWCOMER=${newcomer} -D BASELINE=${SCRATCH}/newcomer.json)
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/consumer)
# The contact radius of the paper's Table 1.
if(NOT output MATCHES "^148\\.9 µm")
  message(FATAL_ERROR "the consumer printed: ${output}")
endif()

# Of the consumer's solvers the plug-in holds, the newcomer's film is wrong, and gated it passes.
execute_process(COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${SCRATCH}/build --output-on-failure
  OUTPUT_VARIABLE out RESULT_VARIABLE code)
if(code EQUAL 0 OR NOT out MATCHES "plugin \\.+ +Passed" OR NOT out MATCHES "newcomer \\.+\\*+Failed"
   OR NOT out MATCHES "gated \\.+ +Passed" OR NOT out MATCHES "R/2 in place of R")
  message(FATAL_ERROR "the consumer's solvers: ${out}")
endif()
