// Derivative of the increment u in Runge-Kutta steps on the manifold of configurations.
#pragma once

#include "burnish/base/views.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Computes du/dt for a configuration q = q0 (+) u that moves with the velocity v. For joints with
/// several entries, du/dt is v + [u, v]/2 + [u, [u, v]]/12, which is exact up to the fourth order
/// in u. For other joints, du/dt is v. u, v and `out` have nv entries.
void increment_rate(const Model& model, const ConstVectorRef& u, const ConstVectorRef& v,
                    Eigen::VectorXd& out) noexcept;

}  // namespace burnish
