// The robot by itself, as what estimates and holds it sees it.
#pragma once

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/model/model.hpp"
#include "burnish/mpc/mpc.hpp"

namespace burnish {

/// Contacts that the robot stands on always: those of MpcSpec::supports that every stage has, as
/// the problem has them.
std::vector<ContactSpec> supports_of(const MpcSpec& spec);
/// Frames of all of MpcSpec::supports, in the order of Measurement::support_wrenches; none where
/// these are not measured.
std::vector<std::string> measured_frames(const MpcSpec& spec);
/// Whether a contact is one that the robot stands on, or holds a loop of it.
bool carries(const MpcSpec& spec, const ContactSpec& contact);

/// Dynamics without contacts but the supports and the robot's loops. These are held without gains,
/// which would turn noise into forces, and with a little compliance for dead points. Throws Error
/// as loop_contacts() does.
ContactDynamics closed_dynamics(const Model& model, std::vector<ContactSpec> supports = {});

}  // namespace burnish
