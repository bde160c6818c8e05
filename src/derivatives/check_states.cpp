#include "derivatives/check_states.hpp"

#include <algorithm>
#include <numbers>

#include "burnish/dynamics/placement.hpp"
#include "burnish/model/state.hpp"
#include "derivatives/contact_rows.hpp"

namespace burnish {
namespace {

// Limits of random states; all chosen by hand.
constexpr double largest_angle = std::numbers::pi - 0.1;  // rotation from target to tool [rad]
constexpr double largest_condition = 1e5;  // condition number of J M^-1 J^T (condition_by_reach)
constexpr int tries_per_state = 20;
constexpr double largest_surface_offset = 0.02;  // from the tool, per axis [robot lengths]
constexpr double largest_tilt = 0.6;             // random change of each entry of a unit normal
constexpr double min_normal_cosine = -0.9;       // cos(angle to the first normal); axes jump at -1

/// Returns the position of a contact's tool in its base [m].
Eigen::Vector3d tool_in_base(const Model& model, const ContactSpec& contact,
                             const Eigen::VectorXd& q) {
  return frame_placement(model, q, contact.base).inverse() *
         frame_placement(model, q, contact.tool).translation();
}

}  // namespace

Eigen::VectorXd CheckStates::uniform(Eigen::Index size, double reach) {
  Eigen::VectorXd result(size);
  for (double& x : result) {
    // std::uniform_real_distribution differs between standard libraries; this formula does not.
    x = reach * (2.0 * static_cast<double>(generator_() >> 11) * 0x1.0p-53 - 1.0);
  }
  return result;
}

bool CheckStates::far_from_jumps(const ContactSet& set, const Eigen::VectorXd& q) const {
  for (const CompiledContact& contact : set.contacts()) {
    const Reference& reference = contact.spec.reference;
    if (reference.quadric && !shape_) {
      const Eigen::Vector3d g = reference.quadric->gradient(tool_in_base(model_, contact.spec, q));
      const bool has_axes = g.dot(reference.rotation.col(2)) > min_normal_cosine * g.norm();
      if (!(g.norm() > 1e-3) || !has_axes) return false;
    }
    if (!contact.proportional) continue;
    if (!contact.holds_rotation && contact.spec.error == PoseError::Split) continue;
    const Eigen::Isometry3d target =
        frame_placement(model_, q, contact.spec.base) * contact.spec.target;
    const Eigen::Isometry3d tool = frame_placement(model_, q, contact.spec.tool);
    const Eigen::AngleAxisd rotation_error(
        Eigen::Matrix3d(target.linear().transpose() * tool.linear()));
    if (std::abs(rotation_error.angle()) > largest_angle) return false;
  }
  return true;
}

Quadric CheckStates::surface_near(const ContactSpec& contact, const Eigen::VectorXd& q) {
  const Eigen::Vector3d tool = tool_in_base(model_, contact, q);
  const Eigen::Vector3d normal =
      contact.reference.rotation.col(2) + Eigen::Vector3d(uniform(3, largest_tilt));
  const double curvature = Surface(*shape_, tool, normal).at(tool).hessian.norm();
  const double offset =
      std::min(largest_surface_offset * units_.length, 0.1 / std::max(curvature, 1e-6));
  const Surface near(*shape_, tool + Eigen::Vector3d(uniform(3, offset)), normal);
  return near.at(tool).quadric(tool, 0.0);
}

std::optional<std::vector<CheckState>> CheckStates::draw(ContactDynamics& dynamics, int count,
                                                         bool rigid) {
  const ContactSet& set = dynamics.contacts();
  const CheckUnits units(model_, set);
  ContactDynamics free(model_);
  std::vector<CheckState> states;
  for (int remaining_tries = tries_per_state * count; static_cast<int>(states.size()) < count;
       --remaining_tries) {
    if (remaining_tries == 0) return std::nullopt;
    CheckState state;
    state.q = random_configuration(model_, generator_);
    if (!far_from_jumps(set, state.q)) continue;
    if (shape_) {
      state.surface = surface_near(set.contacts()[0].spec, state.q);
      if (dynamics.set_surface(0, *state.surface) != Status::Ok) continue;
    }
    if (rigid &&
        !(condition_by_reach(set, contact_rows(model_, dynamics, state.q)) < largest_condition))
      continue;
    state.v = uniform(model_.nv, 1.0).cwiseProduct(units.motion);
    state.a = uniform(model_.nv, 5.0).cwiseProduct(units.motion);
    state.lambda = uniform(set.rows(), 0.1).cwiseProduct(units.row_force);
    const Eigen::VectorXd acceleration = uniform(model_.nv, 5.0).cwiseProduct(units.motion);
    const Status status = free.inverse(state.q, state.v, acceleration, Eigen::VectorXd());
    if (status != Status::Ok) {
      throw Error("check: the inverse dynamics of the model fails: " +
                  std::string(describe(status)));
    }
    state.tau = free.tau();
    states.push_back(state);
  }
  return states;
}

double CheckStates::compliance(ContactDynamics& dynamics) {
  const Eigen::VectorXd q = random_configuration(model_, generator_);
  const ContactRows rows = contact_rows(model_, dynamics, q);
  double sum = 0.0;
  for (Eigen::Index r = 0; r < rows.relative_size.size(); ++r)
    if (rows.relative_size[r] > 0.0)
      sum += rows.Y.row(r).squaredNorm() / std::min(1.0, rows.relative_size[r]);
  // Rows that no joint moves contribute zero to the sum. If no joint moves any row, returns 1e-2.
  return sum > 0.0 ? 1e-2 * sum / static_cast<double>(rows.relative_size.size()) : 1e-2;
}

}  // namespace burnish
