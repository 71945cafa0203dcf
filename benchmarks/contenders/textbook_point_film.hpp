// SPDX-License-Identifier: Apache-2.0
// The film of a flooded point contact as textbooks program it. The equations of model/ehl on one
// grid are solved by Newton's method with a full matrix, or by relaxation line by line.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "ehl/far_inlet.hpp"
#include "ehl/plane_kernel.hpp"
#include "ehl/point_film.hpp"
#include "ehl/point_reynolds.hpp"

namespace tribo::benchmarks {

class TextbookPointFilm {
 public:
  TextbookPointFilm(const ehl::PointContact& contact, const ehl::PlaneGrid& grid);

  void start_from(const ehl::PointFilm& film);

  // Fills the matrix of influences, N² entries, if it is not filled yet.
  void fill_kernel();
  // Makes a step of Newton's method by Eigen's PartialPivLU in about N³ operations. Damps it by
  // damped_step(), and returns what that function returns.
  double newton_step();
  // Makes steps until newton_step() returns less than 1e-6. After 40 steps or NaN: not_converged.
  ehl::PointFilm newton();
  // The bytes of the matrix of influences and of Newton's matrix.
  std::size_t newton_bytes() const;

  // Relaxes line after line along X (Gauss–Seidel). Where pressure hardly drives liquid, a quarter
  // of each change at a node is subtracted from each neighbour, so that the film changes only near
  // the node. Fourier transforms give the film after each sweep. Ends if a sweep changes the
  // pressure by less than 1e-6 of the load and less than 1e-5 of the load is missing. After
  // `most_sweeps` sweeps the outcome is not_converged. Source: C. H. Venner, A. A. Lubrecht:
  // Multilevel Methods in Lubrication. Elsevier (2000), chapter 6, on one grid.
  ehl::PointFilm relaxed(int most_sweeps);

 private:
  Eigen::VectorXd film_of(const Eigen::VectorXd& pressure, double separation) const;
  double missing_load(const Eigen::VectorXd& pressure, double separation) const;
  bool is_free(const ehl::PlaneBalance& balance, Eigen::Index node) const;
  double relax_line(const ehl::PlaneBalance& balance, int j, Eigen::VectorXd& made);

  ehl::PointContact contact_;
  ehl::PointNumbers numbers_;
  ehl::PlaneKernel transform_;
  ehl::FarInlet inlet_;
  Eigen::MatrixXd kernel_, jacobian_;  // only Newton's method uses them
  Eigen::VectorXd areas_, gap_;
  ehl::PointFilm now_;
};

}  // namespace tribo::benchmarks
