// The robot by itself, as what estimates and holds it sees it.
#pragma once

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Dynamics without contacts but the robot's loops. These are held without gains, which would turn
/// noise into forces, and with a little compliance for dead points. Throws Error as
/// loop_contacts() does.
ContactDynamics closed_dynamics(const Model& model);

}  // namespace burnish
