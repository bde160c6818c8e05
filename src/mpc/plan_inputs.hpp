// Inputs of a problem through which a controller changes its plans.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "burnish/mpc/mpc_spec.hpp"
#include "burnish/ocp/problem.hpp"

namespace burnish {

/// Returns the specification as a controller uses it: with a normal of length 1, contacts for the
/// robot's loops, fade speeds, and the inputs of PlanInputs. An input that the specification
/// declares itself is used as the specification says. Otherwise the input is added, and used by
/// - `surface`: contacts of the tool on a curved surface of MpcSpec::base, and target positions of
///   the tool there;
/// - `tool_friction`: contacts with friction between the tool and MpcSpec::base;
/// - `force_error`: targets of one-dimensional contact forces, with ModelErrorKind::Force;
/// - `torque_error`: the torque bias, with ModelErrorKind::Torque;
/// - `SUPPORT/friction`, for each support with a friction cone: friction cones and centres of
///   pressure of the support.
/// Other inputs than these are set by MpcTask::set_inputs(). Throws Error if an input of the
/// specification has another kind.
MpcSpec completed(MpcSpec spec);

/// Returns the indices of the contacts that use the input `surface`, or `tool_friction`.
std::vector<int> contacts_on_surface(const std::vector<ContactSpec>& contacts);
std::vector<int> contacts_with_friction(const std::vector<ContactSpec>& contacts);

/// Sets the inputs of the problem of a completed specification. Values of inputs that the problem
/// lacks are ignored.
class PlanInputs {
 public:
  explicit PlanInputs(const MpcSpec& spec);

  /// Coefficient of friction at the tool.
  void set_friction(Problem& problem, double coefficient) const noexcept;
  /// Estimated coefficient under each support, in the order of supports_of().
  void set_support_friction(Problem& problem, const Eigen::VectorXd& friction) const noexcept;
  /// Surface, and depth by which it yields under the tool [m].
  void set_surface(Problem& problem, const Quadric& surface, double depth) const noexcept;
  void forget_surface(Problem& problem) const noexcept;
  /// Amount by which the targets of contact forces are lowered [N].
  void set_force_error(Problem& problem, double error) const noexcept;
  /// Torque error: a constant part, and a part that decays over the horizon [Nm or N]. Returns
  /// false if it is not finite.
  bool set_torque_error(Problem& problem, const Eigen::VectorXd& lasting,
                        const Eigen::VectorXd& decaying, double decay_time) const noexcept;

 private:
  int surface_, friction_, force_error_, torque_error_;  ///< Indices of inputs; -1: none.
  std::vector<int> support_friction_;
  Eigen::VectorXd cones_;  ///< Friction in each support's cone in the specification.
};

}  // namespace burnish
