// Dynamics of a robot with its closed loops and with the supports that it stands on, for estimators
// and for the fallback.
#pragma once

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/model/model.hpp"
#include "burnish/ocp/problem_spec.hpp"

namespace burnish {

/// Returns the contacts of those supports that are in contact in every stage, in the order of
/// ProblemSpec::contacts. `supports`: names, as in MpcSpec::supports.
std::vector<ContactSpec> supports_of(const ProblemSpec& problem,
                                     const std::vector<std::string>& supports);

/// Returns dynamics whose only contacts are `supports` and the loops of the robot. The gains of
/// these contacts are zero, because gains would turn measurement noise into forces. A small
/// regularization allows singular postures. Throws Error for loops that loop_contacts() rejects.
ContactDynamics closed_dynamics(const Model& model, std::vector<ContactSpec> supports = {});

}  // namespace burnish
