# SPDX-License-Identifier: Apache-2.0
# The line contact on a film solved a second way. The generator of its table and the tests link it.
include_guard(GLOBAL)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
add_library(tribocheck_line_collocation STATIC
  ${CMAKE_CURRENT_LIST_DIR}/line_collocation.cpp ${CMAKE_CURRENT_LIST_DIR}/log_element.cpp)
set_target_properties(tribocheck_line_collocation PROPERTIES UNITY_BUILD OFF)
target_include_directories(tribocheck_line_collocation PUBLIC
  ${PROJECT_SOURCE_DIR}/reference ${PROJECT_SOURCE_DIR}/model)
# This library uses the model's liquid and contact's numbers, which are headers alone.
target_link_libraries(tribocheck_line_collocation PUBLIC Eigen3::Eigen)
if(TRIBOCHECK_SANITIZE)
  target_compile_options(tribocheck_line_collocation PRIVATE -O2)
endif()
