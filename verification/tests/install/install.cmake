# SPDX-License-Identifier: Apache-2.0
# cmake -D BUILD_DIR=… -D VERSION=… -D SOURCE_DIR=… -P this
# A folder of its own for each run: .ci/test-elsewhere has two at a time. A failure leaves it to be looked at.
execute_process(COMMAND mktemp --directory --tmpdir tribocheck-install-XXXXXX
  OUTPUT_VARIABLE scratch OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(prefix ${scratch}/prefix)

function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${scratch} OUTPUT_VARIABLE out ERROR_VARIABLE out RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    list(JOIN ARGV " " line)
    message(FATAL_ERROR "${line}: ${code}\n${out}")
  endif()
  set(output "${out}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})

# A consumer is not asked for what only the build of the library needs; Highway and SLEEF are linked with it.
file(GLOB_RECURSE package_files ${prefix}/tribocheck*.cmake)
if(NOT package_files)
  message(FATAL_ERROR "no CMake package under ${prefix}")
endif()
foreach(file IN LISTS package_files)
  file(STRINGS ${file} leaks REGEX "nlohmann|tomlplusplus|CLI11|fmt::|[Gg][Ss][Ll]|find_dependency")
  list(FILTER leaks EXCLUDE REGEX "^find_dependency\\((hwy|PkgConfig)\\)$")
  if(leaks)
    message(FATAL_ERROR "${file} asks consumers for: ${leaks}")
  endif()
endforeach()

# A public header that is not installed builds here, and is missing there.
file(GLOB headers RELATIVE ${SOURCE_DIR}/model ${SOURCE_DIR}/model/include/tribo/*.hpp)
file(GLOB scenes RELATIVE ${SOURCE_DIR}/reference
  ${SOURCE_DIR}/reference/published/*.toml ${SOURCE_DIR}/reference/published/*.tsv)
if(NOT headers OR NOT scenes)
  message(FATAL_ERROR "no headers or no scenes under ${SOURCE_DIR}")
endif()
list(TRANSFORM scenes PREPEND share/tribocheck/)
foreach(file IN LISTS headers scenes
    ITEMS include/tribo/version.hpp share/doc/tribocheck/LICENSE
    share/tribocheck/scene.schema.json share/tribocheck/schemas/solve.schema.json share/tribocheck/page/gnuplot share/tribocheck/page/render/render.py)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()

run(${prefix}/bin/tribocheck --version)
if(NOT output MATCHES "${VERSION}")
  message(FATAL_ERROR "the installed program calls itself: ${output}")
endif()
# Outside of the tree too.
run(${prefix}/bin/tribocheck report --section figures --out ${scratch}/report)
file(SIZE ${scratch}/report/index.html page_size)
if(page_size LESS 100000)
  message(FATAL_ERROR "the installed program's page has ${page_size} bytes")
endif()
file(REMOVE_RECURSE ${scratch})
