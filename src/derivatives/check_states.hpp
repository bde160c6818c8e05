// Random states for derivative checks of a set of contacts.
#pragma once

#include <optional>
#include <random>
#include <utility>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/dynamics/surface_shape.hpp"
#include "burnish/model/model.hpp"
#include "derivatives/check_units.hpp"

namespace burnish {

/// State (q, v) with the arguments of forward (tau), inverse (a, lambda) and acceleration (a).
struct CheckState {
  Eigen::VectorXd q, v, tau, a, lambda;
  std::optional<Quadric> surface = {};  ///< Surface that the first contact follows
};

/// Generator of random states of one model.
class CheckStates {
 public:
  /// With a `shape`, the only contact follows surfaces of this shape.
  CheckStates(const Model& model, std::uint64_t seed, std::optional<SurfaceShape> shape = {})
      : model_(model), units_(model), shape_(std::move(shape)), generator_(seed) {}

  /// Draws `count` states for the contacts of `dynamics`. Returns nothing if too few postures are
  /// valid.
  ///
  /// q is within limits and away from jumps of the pose error; if `rigid`, also away from singular
  /// postures. With angles in rad and lengths in robot lengths, entries of v are at most 1 /s, and
  /// entries of a at most 5 /s^2. Forces in lambda are at most a tenth of the weight, and moments a
  /// tenth of the weight times the robot length. tau is the inverse dynamics of a random a.
  std::optional<std::vector<CheckState>> draw(ContactDynamics& dynamics, int count, bool rigid);

  /// Returns a compliance that regularizes the contacts at singular postures [m/s^2 per N]: a
  /// hundredth of the mean diagonal of J M^-1 J^T. Rows that the joints hardly move at this posture
  /// are scaled up to their size at other postures.
  double compliance(ContactDynamics& dynamics);

 private:
  Eigen::VectorXd uniform(Eigen::Index size, double reach);
  bool far_from_jumps(const ContactSet& set, const Eigen::VectorXd& q) const;
  /// Places a surface at random near the tool. Returns the quadric that osculates it at the tool.
  Quadric surface_near(const ContactSpec& contact, const Eigen::VectorXd& q);

  const Model& model_;
  CheckUnits units_;
  std::optional<SurfaceShape> shape_;
  std::mt19937_64 generator_;
};

}  // namespace burnish
