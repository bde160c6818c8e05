// A body's ten parameters through ten unbounded numbers (C. Rucker, P. Wensing, "Smooth
// Parameterization of Rigid-Body Inertia", 2022): its pseudo-inertia is J = U U^T with
//   U = e^alpha [ e^d1 s12  s13  t1 ]
//               [ 0    e^d2 s23  t2 ]
//               [ 0    0    e^d3 t3 ]
//               [ 0    0    0    1  ],
// so that the mass is e^(2 alpha), its centre t, and the upper left block of U without e^alpha a
// root of the second moments per mass about the centre.
#pragma once

#include "burnish/model/inertia.hpp"

namespace burnish::identify_detail {

using Matrix10 = Eigen::Matrix<double, 10, 10>;

/// alpha, d1, d2, d3, s12, s23, s13, t1, t2, t3.
struct LogCholesky {
  static Vector10 of(const InertiaSpec& inertia);
  static Vector10 parameters(const Vector10& eta);
  /// d(parameters)/d(eta).
  static Matrix10 derivative(const Vector10& eta);
};

}  // namespace burnish::identify_detail
