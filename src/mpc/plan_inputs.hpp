// Inputs of a problem through which a controller changes its plans.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "burnish/mpc/mpc_spec.hpp"
#include "burnish/ocp/problem.hpp"

namespace burnish {

/// Returns the specification as a controller uses it. Normalizes the normals of tools, and adds
/// contacts for the robot's loops, fade speeds, and the inputs below unless the specification
/// declares them. Added inputs are used in the listed places, except where another input is named
/// already. Terminal costs are left out unless they are listed:
/// - `TOOL/surface`, for each tool: contacts of the tool on a curved surface of ToolSpec::base;
///   target positions of the tool relative to ToolSpec::base, also in terminal costs;
/// - `TOOL/friction`, for each tool: contacts with friction between the tool and ToolSpec::base;
/// - `TOOL/force_error`, for each tool, with ModelErrorKind::Force: targets of contact forces of
/// the
///   tool's one-dimensional contacts;
/// - `torque_error`: the torque bias, with ModelErrorKind::Torque;
/// - `SUPPORT/friction`, for each support with a friction cone that is in contact in every stage:
///   friction cones and centres of pressure of the support.
/// MpcTask::set_inputs() sets all other inputs. Throws Error if the specification declares one of
/// these inputs with another kind.
MpcSpec completed(MpcSpec spec);

/// Returns the tool of each contact, as an index in MpcSpec::tools; -1: none. tools_of_surfaces()
/// returns the tool whose input `TOOL/surface` the contact uses. tools_of_friction() does so for
/// `TOOL/friction`.
std::vector<int> tools_of_surfaces(const MpcSpec& spec);
std::vector<int> tools_of_friction(const MpcSpec& spec);

/// Sets inputs of a problem whose specification completed() returned. Values of inputs that the
/// problem lacks are ignored.
class PlanInputs {
 public:
  explicit PlanInputs(const MpcSpec& spec);

  /// Sets the coefficient of friction at a tool.
  void set_friction(Problem& problem, std::size_t tool, double coefficient) const noexcept;
  /// Sets the coefficient of friction under each support, in the order of supports_of().
  void set_support_friction(Problem& problem, const Eigen::VectorXd& friction) const noexcept;
  /// Sets the surface under a tool, and the depth by which it yields [m].
  void set_surface(Problem& problem, std::size_t tool, const Quadric& surface,
                   double depth) const noexcept;
  /// Sets the amount by which the targets of a tool's contact forces are lowered [N].
  void set_force_error(Problem& problem, std::size_t tool, double error) const noexcept;
  /// Sets the torque error: a constant part `lasting` and a part `decaying` that decays over the
  /// horizon [Nm or N]. With an infinite `decay_time` [s], `decaying` is ignored. Returns false if
  /// the problem rejects the values.
  bool set_torque_error(Problem& problem, const Eigen::VectorXd& lasting,
                        const Eigen::VectorXd& decaying, double decay_time) const noexcept;

 private:
  struct Tool {
    int surface, friction, force_error;  ///< Indices of inputs; -1: none.
  };
  std::vector<Tool> tools_;
  int torque_error_;  ///< Index of an input; -1: none.
  std::vector<int> support_friction_;
  Eigen::VectorXd cones_;  ///< Friction coefficient of each support's cone; infinite: no cone.
};

}  // namespace burnish
