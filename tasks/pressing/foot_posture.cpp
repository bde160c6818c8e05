#include "pressing/foot_posture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/model/state.hpp"
#include "ocp/position_limits.hpp"
#include "pressing/standing_terms.hpp"

namespace burnish::pressing {
namespace {

/// Returns the rotation vector from `R` to `target`, in world axes [rad].
Eigen::Vector3d turn_to(const Eigen::Matrix3d& target, const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(target * R.transpose()));
  return turn.angle() * turn.axis();
}

/// Returns for each entry of v (nv) whether it belongs to the base or to a joint between the base
/// and a foot.
std::vector<bool> entries_of_legs(const Model& model, const Standing& standing) {
  std::vector<bool> leg(to_size(model.nv), false);
  for (const std::string& foot : standing.feet) {
    const Frame& frame = model.frames[to_size(model.frame_index(foot))];
    for (const int k : model.support(frame.body)) leg[to_size(k)] = true;
  }
  return leg;
}

/// Deviations of feet and trunk from their targets, with the Jacobian of the deviations.
class OffPlace {
 public:
  OffPlace(const Model& model, const Standing& standing, const FootPosture& wanted)
      : body_(model), wanted_(wanted), base_(body_.frame(base_frame(model))) {
    for (const std::string& foot : standing.feet) feet_.push_back(body_.frame(foot));
    held_ = standing.has_soles() ? 6 : 3;
    const auto rows = static_cast<Eigen::Index>(feet_.size()) * held_ + 6;
    J = Eigen::MatrixXd::Zero(rows, model.nv);
    error = Eigen::VectorXd::Zero(rows);
  }
  /// Updates J and error for the posture `q`. Returns false if `q` cannot be evaluated.
  bool look(const Eigen::VectorXd& q) {
    if (!is_usable(body_.update(q, Eigen::VectorXd::Zero(J.cols())))) return false;
    body_.update_derivatives();
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < feet_.size(); ++i, row += held_)
      look_at(feet_[i], wanted_.feet[i], row, held_);
    J.middleRows<3>(row) = body_.com_dq();
    error.segment<3>(row) = wanted_.com - body_.com();
    const Eigen::Isometry3d base = body_.placement(base_);
    body_.frame_derivatives(base_, Reference::centered(), at_);
    if (wanted_.base_height) {
      J.row(row + 2) = at_.jacobian.row(2);
      error[row + 2] = *wanted_.base_height - base.translation().z();
    }
    J.bottomRows<3>() = at_.jacobian.bottomRows<3>();
    error.tail<3>() = turn_to(wanted_.R_base, base.linear());
    return true;
  }

  Eigen::MatrixXd J;
  Eigen::VectorXd error;

 private:
  void look_at(int frame, const Eigen::Isometry3d& target, Eigen::Index row, int held) {
    const Eigen::Isometry3d is = body_.placement(frame);
    body_.frame_derivatives(frame, Reference::centered(), at_);
    J.middleRows(row, held) = at_.jacobian.topRows(held);
    error.segment<3>(row) = target.translation() - is.translation();
    if (held > 3) error.segment<3>(row + 3) = turn_to(target.linear(), is.linear());
  }

  RigidBody body_;
  const FootPosture& wanted_;
  int base_, held_;
  std::vector<int> feet_;
  FrameDerivatives at_;
};

void clamp(const Model& model, Eigen::VectorXd& q) {
  for (const Joint& joint : model.joints)
    if (ocp::has_position_limit(model, joint))
      q[joint.q_index] =
          std::clamp(q[joint.q_index], model.q_lower[joint.q_index], model.q_upper[joint.q_index]);
}

/// Returns the margin of a joint to its limits: 0.2, or a tenth of the range if that is smaller
/// [rad (m)]. Chosen by hand.
double margin_of(const Model& model, const Joint& joint) {
  constexpr double usual = 0.2, fraction = 0.1;
  return std::min(usual, fraction * (model.q_upper[joint.q_index] - model.q_lower[joint.q_index]));
}

/// Returns `from` with all joints of the legs moved by `step` [rad (m)], within their limits. Other
/// joints move off their limits, so that a search can move them in both directions.
Eigen::VectorXd bent(const Model& model, const Standing& standing, const Eigen::VectorXd& from,
                     double step) {
  Eigen::VectorXd dq = Eigen::VectorXd::Zero(model.nv);
  for (const std::string& foot : standing.feet) {
    const Frame& frame = model.frames[to_size(model.frame_index(foot))];
    for (const int k : model.support(frame.body))
      if (model.joints[to_size(model.joint_of_v[k])].nv == 1) dq[k] = step;
  }
  Eigen::VectorXd q = integrate(model, from, dq);
  clamp(model, q);
  const std::vector<bool> leg = entries_of_legs(model, standing);
  for (const Joint& joint : model.joints) {
    const int k = joint.q_index;
    if (!ocp::has_position_limit(model, joint) || leg[to_size(joint.v_index)]) continue;
    const double margin = margin_of(model, joint);
    q[k] = std::clamp(q[k], model.q_lower[k] + margin, model.q_upper[k] - margin);
  }
  return q;
}

/// Returns whether all joints of the legs keep at least half of margin_of() to their limits.
bool has_margins(const Model& model, const Standing& standing, const Eigen::VectorXd& q) {
  const std::vector<bool> leg = entries_of_legs(model, standing);
  return std::all_of(model.joints.begin(), model.joints.end(), [&](const Joint& joint) {
    if (!ocp::has_position_limit(model, joint) || !leg[to_size(joint.v_index)]) return true;
    const int k = joint.q_index;
    const double margin = 0.5 * margin_of(model, joint);
    return q[k] >= model.q_lower[k] + margin && q[k] <= model.q_upper[k] - margin;
  });
}

/// Returns the norm of the torques that hold the robot on its feet [Nm]; infinite if q cannot be
/// evaluated.
double torque_at(const Model& model, const Standing& standing, const Eigen::VectorXd& q) {
  RigidBody body(model);
  if (!is_usable(body.update(q, Eigen::VectorXd::Zero(model.nv))))
    return std::numeric_limits<double>::infinity();
  return torque_on_supports(model, body, supports_at(model, standing, q), body.gravity_torque())
      .norm();
}

}  // namespace

std::string base_frame(const Model& model) {
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    if (model.joints[i].kind != JointKind::FreeFlyer) continue;
    const auto is_on = [&](const Frame& frame) { return frame.body == static_cast<int>(i); };
    auto at = std::find_if(model.frames.begin(), model.frames.end(), [&](const Frame& frame) {
      return is_on(frame) && frame.kind == FrameKind::Link;
    });
    if (at == model.frames.end())
      at = std::find_if(model.frames.begin(), model.frames.end(), is_on);
    if (at != model.frames.end()) return at->name;
  }
  throw Error("robot " + in_quotes(model.name) + " has a fixed base; wanted a floating base");
}

std::optional<Eigen::VectorXd> posture_on_feet(const Model& model, const Standing& standing,
                                               const FootPosture& wanted, const Eigen::VectorXd& q,
                                               double tolerance, Eigen::VectorXd* last) {
  constexpr int max_iterations = 200;
  constexpr double max_step = 0.2;  // largest step of an iteration [rad (m)]; chosen by hand
  constexpr double damping = 1e-4;  // weight of |dq|^2 relative to |error|^2; chosen by hand
  OffPlace off(model, standing, wanted);
  const std::vector<bool> leg = entries_of_legs(model, standing);
  Eigen::VectorXd step_ratios = Eigen::VectorXd::Ones(model.nv);
  for (Eigen::Index k = 0; k < step_ratios.size(); ++k)
    if (!leg[to_size(k)]) step_ratios[k] = wanted.others;
  Eigen::VectorXd at = q;
  for (int i = 0; i < max_iterations; ++i) {
    clamp(model, at);
    if (last != nullptr) *last = at;
    if (!off.look(at)) return std::nullopt;
    if (off.error.cwiseAbs().maxCoeff() < tolerance) return at;
    const Eigen::VectorXd dq = step_ratios.cwiseProduct(
        damped_step(off.J * step_ratios.asDiagonal(),
                    Eigen::VectorXd::Constant(off.error.size(), damping), off.error));
    at = integrate(model, at, dq * std::min(1.0, max_step / dq.cwiseAbs().maxCoeff()));
  }
  return std::nullopt;
}

namespace {

/// Returns the leg joints that are at their limits, as "; the search ended at the limits of the
/// joints 'knee', 'ankle'"; empty if there are none.
std::string joints_at_limits(const Model& model, const Standing& standing,
                             const Eigen::VectorXd& q) {
  constexpr double near = 1e-6;
  constexpr std::size_t max_names = 4;
  if (q.size() != model.nq) return "";
  const std::vector<bool> leg = entries_of_legs(model, standing);
  std::vector<std::string> names;
  for (const Joint& joint : model.joints) {
    const int k = joint.q_index;
    if (ocp::has_position_limit(model, joint) && leg[to_size(joint.v_index)] &&
        (q[k] < model.q_lower[k] + near || q[k] > model.q_upper[k] - near))
      names.push_back(in_quotes(joint.name));
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(max_names, names.size()); ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > max_names) text += " and others";
  return text.empty() ? "" : "; the search ended at the limits of the joints " + text;
}

/// Returns the foot turned about its origin by the smallest angle that makes its sole level. A foot
/// whose z axis does not point up is returned unchanged.
Eigen::Isometry3d level(Eigen::Isometry3d foot) {
  constexpr double upwards = 0.7;  // cosine of 45 degrees: smallest z of an axis that points up
  const Eigen::Vector3d z = foot.linear().col(2);
  if (z.z() > upwards)
    foot.linear() = Eigen::Quaterniond::FromTwoVectors(z, Eigen::Vector3d::UnitZ()) *
                    Eigen::Matrix3d(foot.linear());
  return foot;
}

/// Searches for postures with the base lowered by `crouch`, starting near `from`. Returns the
/// posture found that has the smallest torques, or nothing. `last` receives the last iterate.
std::optional<Eigen::VectorXd> posture_lower_by(const Model& model, const Standing& standing,
                                                const Eigen::VectorXd& from, double crouch,
                                                Eigen::VectorXd& last) {
  const Eigen::VectorXd& q = model.q_neutral;
  const Eigen::Isometry3d base = frame_placement(model, q, base_frame(model));
  FootPosture wanted{.R_base = base.linear(), .com = Eigen::Vector3d::Zero()};
  double ground = std::numeric_limits<double>::infinity();
  for (const std::string& foot : standing.feet) {
    const Eigen::Isometry3d at = frame_placement(model, q, foot);
    wanted.feet.push_back(standing.has_soles() ? level(at) : at);
    ground = std::min(ground, wanted.feet.back().translation().z());
  }
  for (Eigen::Isometry3d& foot : wanted.feet) {
    foot.translation().z() = ground;
    wanted.com += foot.translation() / static_cast<double>(wanted.feet.size());
  }
  wanted.base_height = ground + (1.0 - crouch) * (base.translation().z() - ground);
  constexpr double tolerance = 1e-4;
  // Trunk and arms move only if no posture is found with the legs alone. Searches start with legs
  // bent by several angles in both directions, because straight legs are singular.
  std::optional<Eigen::VectorXd> best;
  double min_torque = std::numeric_limits<double>::infinity();
  for (const double others : {0.0, 0.1, 1.0}) {
    wanted.others = others;
    for (const double step : {0.0, 0.4, -0.4, 0.8, -0.8}) {
      auto found = posture_on_feet(model, standing, wanted, bent(model, standing, from, step),
                                   tolerance, &last);
      if (!found) continue;
      const double torque = torque_at(model, standing, *found);
      if (torque < min_torque) best = std::move(found);
      min_torque = std::min(min_torque, torque);
    }
    if (best) break;
  }
  return best;
}

}  // namespace

Eigen::VectorXd crouched_posture(const Model& model, const Standing& standing,
                                 const Eigen::VectorXd& from, double crouch) {
  constexpr double reduction = 0.7;  // factor on the crouch per try
  constexpr int tries = 5;           // factors on the crouch: 1, 0.7, 0.49, 0.34, 0
  std::optional<Eigen::VectorXd> first;
  Eigen::VectorXd last;
  double lower = crouch;
  for (int i = 0; i < tries; ++i, lower = i + 1 < tries ? lower * reduction : 0.0) {
    auto found = posture_lower_by(model, standing, from, lower, last);
    if (found && has_margins(model, standing, *found)) return *found;
    if (!first) first = std::move(found);
  }
  if (first) return *first;
  throw Error(
      "no posture was found with level feet, an upright base, the centre of mass above the middle "
      "of the feet and a crouch of at most " +
      number(crouch) + " (fraction of the height of the base above the feet)" +
      joints_at_limits(model, standing, last) +
      "; wanted a posture in the robot's settings, or another crouch");
}

double crouch_at(const Model& model, const Standing& standing, const Eigen::VectorXd& q) {
  const std::string base = base_frame(model);
  const auto height = [&](const Eigen::VectorXd& at) {
    double ground = std::numeric_limits<double>::infinity();
    for (const std::string& foot : standing.feet)
      ground = std::min(ground, frame_placement(model, at, foot).translation().z());
    return frame_placement(model, at, base).translation().z() - ground;
  };
  return 1.0 - height(q) / height(model.q_neutral);
}

}  // namespace burnish::pressing
