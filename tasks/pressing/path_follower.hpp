// Where a controller without a plan stands in its task: on the way to the surface, on the way to
// the force, or on the path.
#pragma once

#include <string>

#include "base/description.hpp"
#include "burnish/mpc/controller.hpp"
#include "burnish/tasks/pressing/pressing_path.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "pressing/contact_detector.hpp"

namespace burnish::pressing {

/// The path with a normal of length one. Throws Error "the <controller>'s ..." for numbers out of
/// range in all of the specification that it is part of, an empty task, and a posture that is none
/// of the model's.
PressingPath checked_path(const Model& model, const PressingPath& path,
                          const Description& description, const void* spec,
                          const std::string& controller);

class PathFollower {
 public:
  /// A path that is checked.
  explicit PathFollower(const PressingPath& path);

  void reset(Command& command) noexcept;
  /// Moves on to the next phase where its time has come; what is aimed at now, its normal set.
  /// Writes what the command says for the record. The measured force is finite.
  TaskPoint update(const Measurement& measurement, Command& command) noexcept;

  /// The last target with place, velocity and normal as they will be `lead` s later.
  TaskPoint ahead(double lead) const noexcept;

  Phase phase() const noexcept { return phase_; }
  /// Whether contact was made at the last update.
  bool touched() const noexcept { return touched_; }
  double measured() const noexcept { return measured_; }  ///< N, along the normal, at that update

 private:
  Eigen::Vector3d normal_;
  std::function<TaskPoint(double t)> task_;
  double period_, touch_force_, ramp_;
  ContactDetector touch_;
  Phase phase_ = Phase::Approach;
  bool touched_ = false;
  TaskPoint target_;
  double since_ = 0.0;  ///< s in the phase
  double measured_ = 0.0;
};

/// Whether a torque reaches its limit, nv each.
bool at_limit(const Eigen::VectorXd& tau, const Eigen::VectorXd& effort_limit) noexcept;

}  // namespace burnish::pressing
