// Inputs of a problem through which a controller changes its plans.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "burnish/mpc/mpc_spec.hpp"
#include "burnish/ocp/problem.hpp"

namespace burnish {

/// Returns the specification as a controller uses it. Normalizes the surface normal, and adds
/// contacts for the robot's loops, fade speeds, and the inputs below unless the specification
/// declares them. Added inputs are used in the listed places, except where another input is named
/// already. Terminal costs are left out unless they are listed:
/// - `surface`: contacts of the tool on a curved surface of MpcSpec::base; target positions of the
///   tool relative to MpcSpec::base, also in terminal costs;
/// - `tool_friction`: contacts with friction between the tool and MpcSpec::base;
/// - `force_error`: targets of one-dimensional contact forces, with ModelErrorKind::Force;
/// - `torque_error`: the torque bias, with ModelErrorKind::Torque;
/// - `SUPPORT/friction`, for each support with a friction cone that is in contact in every stage:
///   friction cones and centres of pressure of the support.
/// MpcTask::set_inputs() sets all other inputs. Throws Error if the specification declares one of
/// these inputs with another kind.
MpcSpec completed(MpcSpec spec);

/// contacts_on_surface() returns the contacts that use the input `surface`,
/// contacts_with_friction() the contacts that use `tool_friction`. Both functions return indices.
std::vector<int> contacts_on_surface(const std::vector<ContactSpec>& contacts);
std::vector<int> contacts_with_friction(const std::vector<ContactSpec>& contacts);

/// Sets inputs of a problem whose specification completed() returned. Values of inputs that the
/// problem lacks are ignored.
class PlanInputs {
 public:
  explicit PlanInputs(const MpcSpec& spec);

  /// Sets the coefficient of friction at the tool.
  void set_friction(Problem& problem, double coefficient) const noexcept;
  /// Sets the coefficient of friction under each support, in the order of supports_of().
  void set_support_friction(Problem& problem, const Eigen::VectorXd& friction) const noexcept;
  /// Sets the surface and the depth by which it yields under the tool [m].
  void set_surface(Problem& problem, const Quadric& surface, double depth) const noexcept;
  /// Sets the amount by which the targets of contact forces are lowered [N].
  void set_force_error(Problem& problem, double error) const noexcept;
  /// Sets the torque error: a constant part `lasting` and a part `decaying` that decays over the
  /// horizon [Nm or N]. With an infinite `decay_time` [s], `decaying` is ignored. Returns false if
  /// the problem rejects the values.
  bool set_torque_error(Problem& problem, const Eigen::VectorXd& lasting,
                        const Eigen::VectorXd& decaying, double decay_time) const noexcept;

 private:
  int surface_, friction_, force_error_, torque_error_;  ///< Indices of inputs; -1: none.
  std::vector<int> support_friction_;
  Eigen::VectorXd cones_;  ///< Friction coefficient of each support's cone; infinite: no cone.
};

}  // namespace burnish
