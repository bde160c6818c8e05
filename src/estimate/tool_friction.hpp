// Estimate of the friction between a tool and the surface along which it slides.
#pragma once

#include <optional>

#include "burnish/estimate/friction_estimate.hpp"
#include "estimate/loop_times.hpp"
#include "estimate/robot_state.hpp"

namespace burnish {

/// Settings of a ToolFriction.
struct ToolFrictionSpec {
  double bandwidth;          ///< Bandwidth of the estimate [rad/s].
  double contact_threshold;  ///< Normal force above which the tool is in contact [N].
  /// Settings of the coefficient's estimate; not set: the tool's contacts have no friction.
  std::optional<FrictionEstimateOptions> coefficient;
  /// Speed below which friction fades out in plans; unused without `coefficient` [m/s].
  double planned_speed = 0.0;
  LoopTimes times;
  double plan_lead;  ///< Time from the first knot of a new plan to the velocity for foresee() [s].
};

/// Force of the surface on the tool at a valid measurement.
struct ToolForce {
  Eigen::Vector3d force_world;   ///< Force, in world axes [N].
  Eigen::Vector3d normal_world;  ///< Unit normal of the surface, in world axes.
  double normal() const { return force_world.dot(normal_world); }  ///< Normal force [N].
};

/// Estimate of the friction along the surface: the coefficient of friction for the contacts of
/// plans, and the friction that these contacts do not model.
///
/// Feedback of the measured friction would close a loop through normal force, friction, the inertia
/// of the arm and the lag of the observer. This loop rings if pressing and sliding are coupled in
/// the arm, as with a light wrist on a heavy arm. The estimate is therefore the ratio of friction
/// to normal force. The feedback is this ratio times the target of the normal force.
class ToolFriction {
 public:
  ToolFriction(const ToolFrictionSpec& spec, int nv);

  void reset() noexcept;
  /// Updates the estimate, `dt` [s] after the previous measurement. `target`: target of the normal
  /// force [N].
  void update(const RigidBody& body, const ToolMotion& motion, const ToolForce& tool, double target,
              double dt) noexcept;
  /// Sets the planned velocity (nv) [rad/s or m/s], from which the estimate takes the direction of
  /// motion.
  void foresee(const Eigen::VectorXd& v) noexcept { v_ahead_ = v; }

  /// Returns the coefficient of friction of the tool's contacts; 0 without a friction model.
  double coefficient() const { return coefficient_ ? coefficient_->coefficient() : 0.0; }
  /// Returns true if the tool's contacts have a friction model.
  bool is_modelled() const { return coefficient_.has_value(); }
  /// Returns true if the filtered normal force exceeds the contact threshold.
  bool presses() const { return pressed_ > spec_.contact_threshold; }
  /// Returns the filtered friction that the contacts do not model, in world axes [N].
  const Eigen::Vector3d& unmodelled_world() const { return unmodelled_; }
  /// Returns the friction to feed forward, divided by feedforward_ratio(), in world axes [N]. It is
  /// unmodelled_world(), rotated from the past to the future sliding direction.
  const Eigen::Vector3d& ahead_world() const { return ahead_; }
  /// Returns the ratio of the target force to the normal force; 0 if the tool does not press.
  double feedforward_ratio() const { return ratio_; }

 private:
  Eigen::Vector3d along_plan(const ToolMotion& motion, const Eigen::Vector3d& n,
                             double dt) noexcept;
  Eigen::Vector3d modelled(const Eigen::Vector3d& v_tool, const ToolForce& tool,
                           const Eigen::Vector3d& across, double dt) noexcept;

  ToolFrictionSpec spec_;
  std::optional<FrictionEstimator> coefficient_;
  double smoothing_;         ///< Time constant of the filters of between_ and v_tool_ [s].
  Eigen::VectorXd v_ahead_;  ///< Planned velocity set by foresee(), nv.
  double pressed_ = 0.0;     ///< Low-pass filtered normal force [N].
  double ratio_ = 0.0;
  Eigen::Vector3d unmodelled_ = Eigen::Vector3d::Zero(), ahead_ = unmodelled_;
  /// Planned tool velocity from v_ahead_, low-pass filtered once (between_) and twice (v_tool_)
  /// [m/s]. v_tool_ is the planned velocity at the time when torques act.
  Eigen::Vector3d between_ = unmodelled_, v_tool_ = unmodelled_;
  /// Direction of v_tool_ at the time of the force measurement.
  Eigen::Vector3d slid_ = unmodelled_;
};

}  // namespace burnish
