// Log-Cholesky coordinates: a body's ten inertial parameters as ten unbounded numbers (C. Rucker,
// P. Wensing, "Smooth Parameterization of Rigid-Body Inertia", 2022). The pseudo-inertia is
// J = U U^T with
//   U = e^alpha [ e^d1 s12  s13  t1 ]
//               [ 0    e^d2 s23  t2 ]
//               [ 0    0    e^d3 t3 ]
//               [ 0    0    0    1  ].
// The mass is e^(2 alpha), and t is the centre of mass. With the upper left 3 x 3 block L of the
// matrix in brackets, L L^T is the second moment about the centre of mass, divided by the mass.
#pragma once

#include "burnish/model/inertia.hpp"

namespace burnish::identify_detail {

using Matrix10 = Eigen::Matrix<double, 10, 10>;

/// Coordinates alpha, d1, d2, d3, s12, s23, s13, t1, t2, t3.
struct LogCholesky {
  static Vector10 of(const InertiaSpec& inertia);
  static Vector10 parameters(const Vector10& eta);
  /// Returns d(parameters)/d(eta).
  static Matrix10 derivative(const Vector10& eta);
};

}  // namespace burnish::identify_detail
