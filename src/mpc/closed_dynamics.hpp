// Dynamics of a robot with its closed loops and with the supports that it stands on, for estimators
// and for the fallback.
#pragma once

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/model/model.hpp"
#include "burnish/mpc/mpc_spec.hpp"

namespace burnish {

/// Returns the contacts of supports that always carry the robot: all supports in contact in every
/// stage, except MpcSpec::resting_supports. The order is that of ProblemSpec::contacts.
std::vector<ContactSpec> supports_of(const MpcSpec& spec);

/// Returns dynamics whose only contacts are `supports` and the loops of the robot. The gains of
/// these contacts are zero, because gains would turn measurement noise into forces. A small
/// regularization allows singular postures. Throws Error for loops that loop_contacts() rejects.
ContactDynamics closed_dynamics(const Model& model, std::vector<ContactSpec> supports = {});

}  // namespace burnish
