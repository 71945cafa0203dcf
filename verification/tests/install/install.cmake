# SPDX-License-Identifier: Apache-2.0
# cmake -D BUILD_DIR=… -D VERSION=… -D SOURCE_DIR=… -P this
# Each run has its own folder, because two may run at a time. After a failure the folder stays, to be looked at.
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
string(REGEX MATCH "tribocheck is installed under ${prefix}:\n.*" summary "${output}")
string(REGEX MATCHALL "\n  [^ ]+" places "${summary}")
list(LENGTH places count)
if(count LESS 6)
  message(FATAL_ERROR "the installation does not say where its parts are: ${output}")
endif()
foreach(place IN LISTS places)
  string(STRIP "${place}" place)
  if(NOT EXISTS ${prefix}/${place})
    message(FATAL_ERROR "the installation says that it has ${place}")
  endif()
endforeach()

# The package does not ask consumers for libraries that only the build needs.
file(GLOB_RECURSE package_files ${prefix}/tribocheck*.cmake)
if(NOT package_files)
  message(FATAL_ERROR "no CMake package under ${prefix}")
endif()
foreach(file IN LISTS package_files)
  file(STRINGS ${file} leaks REGEX "nlohmann|tomlplusplus|CLI11|fmt::|[Gg][Ss][Ll]|find_dependency")
  if(leaks)
    message(FATAL_ERROR "${file} asks consumers for: ${leaks}")
  endif()
endforeach()

# Configures a project that links the CMake target `link` and asks for `components`. `has_libraries`: whether the
# libraries of the model are found. A project that only tests a solver needs none of them. Sets `result` to "code: output".
function(configure_project result link components has_libraries)
  set(folder ${scratch}/project)
  file(REMOVE_RECURSE ${folder})
  file(WRITE ${folder}/CMakeLists.txt "
    cmake_minimum_required(VERSION 3.25)
    project(consumer LANGUAGES CXX)
    enable_testing()
    find_package(tribocheck CONFIG REQUIRED ${components})
    include(tribocheck)
    file(WRITE one.cpp \"int main() {}\")
    add_executable(one one.cpp)
    target_link_libraries(one PRIVATE ${link})
    tribocheck_add_subject(solver COMMAND python3 my_solver.py BASELINE b.json JUNIT out/my.xml SPEED s.json)")
  set(environment "")
  set(options "")
  if(NOT has_libraries)
    set(environment PKG_CONFIG_LIBDIR=/nowhere)
    set(options -D CMAKE_DISABLE_FIND_PACKAGE_hwy=ON)
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} -E env ${environment} ${CMAKE_COMMAND} -S ${folder} -B ${folder}/build
      -D CMAKE_PREFIX_PATH=${prefix} ${options}
    OUTPUT_VARIABLE out ERROR_VARIABLE out RESULT_VARIABLE code)
  string(REGEX REPLACE "[ \n]+" " " out "${out}")
  set(${result} "${code}: ${out}" PARENT_SCOPE)
endfunction()

function(expect text expression)
  if(NOT text MATCHES "${expression}")
    message(FATAL_ERROR "no ${expression} in: ${text}")
  endif()
endfunction()

set(needs "tribocheck::model needs Highway, SLEEF and pkg-config .on Debian: apt-get install libhwy-dev")
configure_project(said tribocheck::model "" TRUE)
expect("${said}" "^0: ")
configure_project(said tribocheck::model "COMPONENTS model" TRUE)
expect("${said}" "^0: ")
configure_project(said tribocheck::model "" FALSE)
expect("${said}" "^1: .*${needs}")
configure_project(said tribocheck::plugin "COMPONENTS model" FALSE)
expect("${said}" "^1: .*${needs}")
configure_project(said tribocheck::plugin "COMPONENTS subject" FALSE)
expect("${said}" "^0: ")
configure_project(said tribocheck::plugin "" FALSE)
expect("${said}" "^0: ")
file(READ ${scratch}/project/build/CTestTestfile.cmake tests)
expect("${tests}" [["verify" "--subject" "python3 my_solver.py" "--baseline" "b.json" "--junit" "out/my.xml"\)]])
expect("${tests}" [["bench" "--subject" "python3 my_solver.py" "--baseline" "s.json" "--junit" "out/my_speed.xml"\)]])
expect("${tests}" [[solver_speed[^ ]* PROPERTIES +LABELS "speed" RUN_SERIAL "TRUE"]])

# No installed file is linked with GSL (GPL) or Google Benchmark, neither by a library that it loads nor by code in it.
file(GLOB_RECURSE installed LIST_DIRECTORIES FALSE ${prefix}/*)
set(binaries 0)
foreach(file IN LISTS installed)
  file(READ ${file} magic LIMIT 8 HEX)
  if(magic MATCHES "^7f454c46")  # ELF
    run(ldd ${file})
    set(linked "${output}")
  elseif(magic STREQUAL "213c617263683e0a")  # an archive
    set(linked "")
  else()
    continue()
  endif()
  run(nm -C ${file})
  string(REGEX MATCH "libgsl[^\n]*|libcblas[^\n]*|libbenchmark[^\n]*|[^\n]* (gsl|cblas)_[^\n]*|[^\n]* benchmark::[^\n]*"
    found "${linked}${output}")
  if(found)
    message(FATAL_ERROR "${file} is linked with ${found}")
  endif()
  math(EXPR binaries "${binaries} + 1")
endforeach()
if(binaries LESS 4)  # two programs and two libraries
  message(FATAL_ERROR "${binaries} binaries are installed")
endif()

# A program in C finds the library by pkg-config, and the library finds the certified values under its prefix.
file(GLOB_RECURSE pkgconfig ${prefix}/tribocheck.pc)
get_filename_component(pkgconfig ${pkgconfig} DIRECTORY)
run(${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${pkgconfig} pkg-config --cflags --libs tribocheck)
separate_arguments(flags UNIX_COMMAND "${output}")
run(cc -std=c99 -D_GNU_SOURCE ${SOURCE_DIR}/reports/tests/library_user.c -o user ${flags} -lm -pthread)
file(GLOB_RECURSE library ${prefix}/libtribocheck.so)
get_filename_component(library ${library} DIRECTORY)
file(CREATE_LINK ${library} ${scratch}/lib SYMBOLIC)  # through a link, as /lib is on Debian
run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${scratch}/lib ${scratch}/user judge right)

# A public header that is not installed is found in the source tree, but not by consumers.
file(GLOB headers RELATIVE ${SOURCE_DIR}/model ${SOURCE_DIR}/model/include/tribo/*.hpp)
file(GLOB scenes RELATIVE ${SOURCE_DIR}/reference
  ${SOURCE_DIR}/reference/published/*.toml ${SOURCE_DIR}/reference/published/*.tsv)
if(NOT headers OR NOT scenes)
  message(FATAL_ERROR "no headers or no scenes under ${SOURCE_DIR}")
endif()
list(TRANSFORM scenes PREPEND share/tribocheck/)
foreach(file IN LISTS headers scenes
    ITEMS include/tribo/version.hpp share/doc/tribocheck/LICENSE
    share/tribocheck/ci/github.yml share/tribocheck/ci/gitlab.yml
    share/tribocheck/scene.schema.json share/tribocheck/schemas/solve.schema.json
    share/tribocheck/page/gnuplot share/tribocheck/page/render/render.py)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()

run(${prefix}/bin/tribocheck --version)
if(NOT output MATCHES "${VERSION}")
  message(FATAL_ERROR "the installed program calls itself: ${output}")
endif()
# The installed program works outside of the source tree, too.
run(${prefix}/bin/tribocheck field ${prefix}/share/tribocheck/verdicts -o ${scratch}/field.html)
run(${prefix}/bin/tribocheck report --section figures --out ${scratch}/report)
file(SIZE ${scratch}/report/index.html page_size)
if(page_size LESS 100000)
  message(FATAL_ERROR "the installed program's page has ${page_size} bytes")
endif()
file(REMOVE_RECURSE ${scratch})
