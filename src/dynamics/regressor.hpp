// The regressor of inverse dynamics: the torque as a linear function of mass distributions, which
// it is because the force that moves a body is one (C. Atkeson, C. An, J. Hollerbach, "Estimation
// of Inertial Parameters of Manipulator Loads and Links", 1986).
#pragma once

#include "dynamics/inverse_dynamics.hpp"

namespace burnish {

/// Ten columns, row-major with leading dimension `stride`, of a body's parameters (mass, mass times
/// centre, moments of inertia about the body's origin as xx xy xz yy yz zz, all in body axes): adds
/// to nv rows what each adds to the torques at the accelerations of the last accelerate().
template <class S>
void body_regressor(const Tree& tree, const Kinematics<S>& kinematics, const InverseDynamics<S>& id,
                    int body, S* out, int stride);

}  // namespace burnish
