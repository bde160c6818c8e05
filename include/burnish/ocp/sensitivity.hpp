// What an optimal motion's cost owes to what the robot carries.
#pragma once

#include <string_view>

#include "burnish/model/inertia.hpp"
#include "burnish/ocp/problem.hpp"
#include "burnish/solver/ddp.hpp"

namespace burnish {

/// Derivative of the least cost by the ten parameters (inertia_parameter_names) of what the
/// problem's robot carries at a frame, in the frame's axes about its origin: cost per kg, kg m, kg
/// m^2. At a solution the states and controls that answer a change do not count (the envelope
/// theorem), and what is left is, with the costates V_x and the multipliers nu of limits,
///   dV/dtheta = sum over knots k of d/dtheta [ l_k + V_x,k+1^T f_k + nu_k^T c_k ]  at x_k, u_k,
/// where costs l, dynamics f and rows c know the parameters through accelerations and forces,
/// momenta and the centre of mass. Each knot is differentiated by central differences of its own
/// values, the motion held; they are right to 1e-6 or so. The sign is that of a mass that is added.
///
/// The solver must have converged on the problem as it is: with its last payload, targets and
/// start. The problem comes back as it was. Throws Error as Problem::set_payload does, for a frame
/// whose body has no mass, and where the solver has not solved this problem to its end or a knot
/// cannot be evaluated.
Vector10 cost_by_payload(Problem& problem, const DdpSolver& solver, std::string_view frame);

}  // namespace burnish
