// Random states at which a set of contacts can be checked.
#pragma once

#include <optional>
#include <random>
#include <utility>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/dynamics/surface_shape.hpp"
#include "burnish/model/model.hpp"
#include "derivatives/check_units.hpp"

namespace burnish {

/// Arguments of forward (q, v, tau), inverse (q, v, a, lambda) and acceleration (q, v, a).
struct CheckState {
  Eigen::VectorXd q, v, tau, a, lambda;
  std::optional<Quadric> surface = {};  ///< that the first contact follows there
};

/// Draws states of one model.
class CheckStates {
 public:
  /// Where a shape is given, the only contact follows a surface of it.
  CheckStates(const Model& model, std::uint64_t seed, std::optional<SurfaceShape> shape = {})
      : model_(model), units_(model), shape_(std::move(shape)), generator_(seed) {}

  /// `count` states for the contacts of `dynamics`: q within limits, away from jumps of the pose
  /// error and, for a rigid contact, from singular postures; v and a up to 1 rad/s and 5 rad/s^2,
  /// or as many lengths of the robot, lambda up to a tenth of the weight, or of it times that
  /// length, tau up to what gravity and motion ask for. Empty when the robot can hold the contacts
  /// rigidly at too few of the postures that were tried.
  std::optional<std::vector<CheckState>> draw(ContactDynamics& dynamics, int count, bool rigid);

  /// A compliance that leaves the contacts soft enough to solve, m/s^2 per N: a hundredth of the
  /// mean diagonal of J M^-1 J^T, in which rows that the joints hardly move count as they would at
  /// postures where they do.
  double compliance(ContactDynamics& dynamics);

 private:
  Eigen::VectorXd uniform(Eigen::Index size, double reach);
  bool far_from_jumps(const ContactSet& set, const Eigen::VectorXd& q) const;
  /// What osculates a surface of the shape near the tool.
  Quadric surface_near(const ContactSpec& contact, const Eigen::VectorXd& q);

  const Model& model_;
  CheckUnits units_;
  std::optional<SurfaceShape> shape_;
  std::mt19937_64 generator_;
};

}  // namespace burnish
