#pragma once

/// Include before any ITK header in a file that also uses our Eigen.
///
/// ITK's headers bring a copy of Eigen of their own, of another version; its modules are skipped
/// where the system's are known already.
#include <Eigen/Dense>
