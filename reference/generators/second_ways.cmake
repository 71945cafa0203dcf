# SPDX-License-Identifier: Apache-2.0
# Libraries that solve lines and points on a film in a second way. Generators of tables and tests link them.
include_guard(GLOBAL)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
add_library(tribocheck_line_collocation STATIC
  ${CMAKE_CURRENT_LIST_DIR}/line_collocation.cpp ${CMAKE_CURRENT_LIST_DIR}/log_element.cpp)
add_library(tribocheck_point_elements STATIC
  ${CMAKE_CURRENT_LIST_DIR}/point_elements.cpp ${CMAKE_CURRENT_LIST_DIR}/point_mesh.cpp)
foreach(way tribocheck_line_collocation tribocheck_point_elements)
  set_target_properties(${way} PROPERTIES UNITY_BUILD OFF)
  target_include_directories(${way} PUBLIC ${PROJECT_SOURCE_DIR}/reference ${PROJECT_SOURCE_DIR}/model)
  # They use only headers of model/ehl: the liquid, the numbers of a contact and the estimate.
  target_link_libraries(${way} PUBLIC Eigen3::Eigen tribocheck::model)
  if(TRIBOCHECK_SANITIZE)
    target_compile_options(${way} PRIVATE -O2)
  endif()
endforeach()
