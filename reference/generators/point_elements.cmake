# SPDX-License-Identifier: Apache-2.0
# The point contact on a film solved a second way. The generator of its table and the tests link it.
include_guard(GLOBAL)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
add_library(tribocheck_point_elements STATIC
  ${CMAKE_CURRENT_LIST_DIR}/point_elements.cpp ${CMAKE_CURRENT_LIST_DIR}/point_mesh.cpp)
set_target_properties(tribocheck_point_elements PROPERTIES UNITY_BUILD OFF)
target_include_directories(tribocheck_point_elements PUBLIC
  ${PROJECT_SOURCE_DIR}/reference ${PROJECT_SOURCE_DIR}/model)
# This library uses the contact's numbers and the estimate's two members, which are headers alone.
target_link_libraries(tribocheck_point_elements PUBLIC Eigen3::Eigen tribocheck::model)
if(TRIBOCHECK_SANITIZE)
  target_compile_options(tribocheck_point_elements PRIVATE -O2)
endif()
