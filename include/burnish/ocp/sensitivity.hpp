// Sensitivity of the optimal cost to the payload that the robot carries.
#pragma once

#include <string_view>

#include "burnish/model/inertia.hpp"
#include "burnish/ocp/problem.hpp"
#include "burnish/solver/ddp.hpp"

namespace burnish {

/// Returns the derivative of the optimal cost with respect to the ten inertia parameters of a
/// payload at `frame`, in cost per kg, kg m and kg m^2. The parameters (inertia_parameter_names)
/// are in the frame's axes, about the frame's origin. The derivative with respect to mass is
/// positive if added mass raises the cost. At a solution, first-order changes of states and
/// controls do not contribute (envelope theorem). With costates V_x and constraint multipliers nu,
///   dV/dtheta = sum over knots k of d/dtheta [ l_k + V_x,k+1^T f_k + nu_k^T c_k ]  at x_k, u_k.
/// Costs l, dynamics f and constraint rows c depend on the parameters theta through accelerations,
/// forces, momenta and the centre of mass. At each knot, l, f and c are differentiated by central
/// differences, with fixed states and controls. The accuracy is about 1e-6.
///
/// The solver must have converged on the problem with its current payload, targets and initial
/// state. The function changes the problem and restores it. Throws Error
///  - for an unknown frame, with the nearest known name;
///  - for a frame that is fixed to the world, or whose body has no mass;
///  - if the solver has not converged on this problem;
///  - if a knot cannot be evaluated.
Vector10 cost_by_payload(Problem& problem, const DdpSolver& solver, std::string_view frame);

}  // namespace burnish
