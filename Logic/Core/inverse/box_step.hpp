#pragma once

#include <Eigen/Core>

/// Which step within bounds lowers a quadratic most?
namespace f2b
{

/// Minimises 1/2 s.H s + g.s over least <= s <= most, by the primal active-set method (Nocedal and
/// Wright, Numerical Optimization, 2006, section 16.5): exact up to rounding.
///
/// \param H            symmetric, positive definite
/// \param least, most  least <= 0 <= most in every component
Eigen::VectorXd box_step(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                         const Eigen::VectorXd& least, const Eigen::VectorXd& most);

/// Takes a coordinate out of a quadratic's matrix: nothing depends on it any more, and its own
/// stiffness is the largest, so that tests of the smallest one do not see it.
void hold_coordinate(Eigen::MatrixXd& H, Eigen::Index k);

} // namespace f2b
