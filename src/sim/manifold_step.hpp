// Runge-Kutta on the configuration's manifold: how fast the increment from a step's start grows.
#pragma once

#include "burnish/base/views.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// du/dt where q0 (+) u moves with the twist v: v + [u, v]/2 + [u, [u, v]]/12 for joints of several
/// entries, exact up to the fourth order in u, and v for the others. u, v, out: nv.
void increment_rate(const Model& model, const ConstVectorRef& u, const ConstVectorRef& v,
                    Eigen::VectorXd& out) noexcept;

}  // namespace burnish
