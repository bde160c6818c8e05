// Regressor of inverse dynamics: joint torques as a linear function of the inertial parameters of
// bodies (C. Atkeson, C. An, J. Hollerbach, "Estimation of Inertial Parameters of Manipulator Loads
// and Links", 1986).
#pragma once

#include "dynamics/inverse_dynamics.hpp"

namespace burnish {

/// Adds the regressor of one body to `out` (nv x 10, row-major with leading dimension `stride`), at
/// the accelerations of the last accelerate(). Column j is the torque per unit of parameter j. The
/// parameters are mass, mass times centre of mass (3), and moments of inertia about the origin of
/// the body (xx, xy, xz, yy, yz, zz), all in body axes.
template <class S>
void body_regressor(const Tree& tree, const Kinematics<S>& kinematics, const InverseDynamics<S>& id,
                    int body, S* out, int stride);

}  // namespace burnish
