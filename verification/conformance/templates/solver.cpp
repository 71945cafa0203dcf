// A solver for tribocheck in C++. It skips everything: give a function for each thing you have.
// Cases, results, units: verification/conformance/serve.hpp of tribocheck. A CMakeLists.txt for it:
//
//   cmake_minimum_required(VERSION 3.25)
//   project(solver LANGUAGES CXX)
//   add_subdirectory(/path/to/tribocheck tribocheck EXCLUDE_FROM_ALL)
//   add_executable(solver solver.cpp)
//   target_link_libraries(solver PRIVATE tribocheck::conformance_serve)
//
//   cmake -S . -B build && cmake --build build && tribocheck verify --subject build/solver
#include "conformance/serve.hpp"

using namespace tribo::conformance;

// Answer<double> hamrock_dowson(const FilmCase& asked) {
//   if (asked.ellipticity != 1) return skip("circular contacts only");
//   return my_film(asked.speed, asked.viscosity, …);
// }

int main() {
  Solver solver;
  // solver.hamrock_dowson_central = each(hamrock_dowson);
  return serve(solver);
}
