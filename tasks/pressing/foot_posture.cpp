#include "pressing/foot_posture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/model/state.hpp"
#include "ocp/position_limits.hpp"
#include "pressing/standing_terms.hpp"

namespace burnish::pressing {
namespace {

/// The turn that leads from R to the target, rad, world axes.
Eigen::Vector3d turn_to(const Eigen::Matrix3d& target, const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(target * R.transpose()));
  return turn.angle() * turn.axis();
}

/// Whether each entry of v (nv) is between a foot and the base, or the base's.
std::vector<bool> entries_of_legs(const Model& model, const Standing& standing) {
  std::vector<bool> leg(static_cast<std::size_t>(model.nv), false);
  for (const std::string& foot : standing.feet) {
    const Frame& frame = model.frames[static_cast<std::size_t>(model.frame_index(foot))];
    for (const int k : model.support(frame.body)) leg[static_cast<std::size_t>(k)] = true;
  }
  return leg;
}

/// What is off, and how the robot's motion changes it.
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
  /// False where q is no state.
  bool look(const Eigen::VectorXd& q) {
    if (body_.update(q, Eigen::VectorXd::Zero(J.cols())) > Status::NotConverged) return false;
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

/// rad (m) that a joint is to be off its limits where nothing asks for more: of a short range a
/// part.
double room_of(const Model& model, const Joint& joint) {
  constexpr double usual = 0.2, part = 0.1;
  return std::min(usual, part * (model.q_upper[joint.q_index] - model.q_lower[joint.q_index]));
}

/// A configuration with the joints of the legs moved by `way`, rad (m), within their ranges. Others
/// come off their limits, at which they could not move.
Eigen::VectorXd bent(const Model& model, const Standing& standing, const Eigen::VectorXd& from,
                     double way) {
  Eigen::VectorXd dq = Eigen::VectorXd::Zero(model.nv);
  for (const std::string& foot : standing.feet) {
    const Frame& frame = model.frames[static_cast<std::size_t>(model.frame_index(foot))];
    for (const int k : model.support(frame.body))
      if (model.joints[static_cast<std::size_t>(model.joint_of_v[k])].nv == 1) dq[k] = way;
  }
  Eigen::VectorXd q = integrate(model, from, dq);
  clamp(model, q);
  const std::vector<bool> leg = entries_of_legs(model, standing);
  for (const Joint& joint : model.joints) {
    const int k = joint.q_index;
    if (!ocp::has_position_limit(model, joint) || leg[static_cast<std::size_t>(joint.v_index)])
      continue;
    const double room = room_of(model, joint);
    q[k] = std::clamp(q[k], model.q_lower[k] + room, model.q_upper[k] - room);
  }
  return q;
}

/// Whether the joints of the legs are off their limits.
bool has_room(const Model& model, const Standing& standing, const Eigen::VectorXd& q) {
  const std::vector<bool> leg = entries_of_legs(model, standing);
  return std::all_of(model.joints.begin(), model.joints.end(), [&](const Joint& joint) {
    if (!ocp::has_position_limit(model, joint) || !leg[static_cast<std::size_t>(joint.v_index)])
      return true;
    const int k = joint.q_index;
    const double room = 0.5 * room_of(model, joint);
    return q[k] >= model.q_lower[k] + room && q[k] <= model.q_upper[k] - room;
  });
}

/// Nm: all torques that hold it on its feet, as the root of their squares.
double torque_at(const Model& model, const Standing& standing, const Eigen::VectorXd& q) {
  RigidBody body(model);
  if (body.update(q, Eigen::VectorXd::Zero(model.nv)) > Status::NotConverged)
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
  throw Error("robot " + in_quotes(model.name) + " has a fixed base; wanted one that floats");
}

std::optional<Eigen::VectorXd> posture_on_feet(const Model& model, const Standing& standing,
                                               const FootPosture& wanted, const Eigen::VectorXd& q,
                                               double tolerance, Eigen::VectorXd* last) {
  constexpr int most = 200;
  constexpr double longest = 0.2, damping = 1e-4;
  OffPlace off(model, standing, wanted);
  const std::vector<bool> leg = entries_of_legs(model, standing);
  Eigen::VectorXd goes = Eigen::VectorXd::Ones(model.nv);
  for (Eigen::Index k = 0; k < goes.size(); ++k)
    if (!leg[static_cast<std::size_t>(k)]) goes[k] = wanted.others;
  Eigen::VectorXd at = q;
  for (int i = 0; i < most; ++i) {
    clamp(model, at);
    if (last != nullptr) *last = at;
    if (!off.look(at)) return std::nullopt;
    if (off.error.cwiseAbs().maxCoeff() < tolerance) return at;
    const Eigen::VectorXd dq = goes.cwiseProduct(
        damped_step(off.J * goes.asDiagonal(), Eigen::VectorXd::Constant(off.error.size(), damping),
                    off.error));
    at = integrate(model, at, dq * std::min(1.0, longest / dq.cwiseAbs().maxCoeff()));
  }
  return std::nullopt;
}

namespace {

/// "; joints 'knee' and 'ankle' came to their limits" of the legs at q; empty: none did.
std::string joints_at_limits(const Model& model, const Standing& standing,
                             const Eigen::VectorXd& q) {
  constexpr double near = 1e-6;
  constexpr std::size_t most = 4;
  if (q.size() != model.nq) return "";
  const std::vector<bool> leg = entries_of_legs(model, standing);
  std::vector<std::string> names;
  for (const Joint& joint : model.joints) {
    const int k = joint.q_index;
    if (ocp::has_position_limit(model, joint) && leg[static_cast<std::size_t>(joint.v_index)] &&
        (q[k] < model.q_lower[k] + near || q[k] > model.q_upper[k] - near))
      names.push_back(in_quotes(joint.name));
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > most) text += " and others";
  return text.empty() ? "" : "; the search ended at limits of " + text;
}

/// Placement of a foot whose sole is level, turned about its origin by the smallest angle. A frame
/// whose z does not point up, as that of a sole does, is left as it is.
Eigen::Isometry3d level(Eigen::Isometry3d foot) {
  constexpr double upwards = 0.7;  // cosine: 45 degrees
  const Eigen::Vector3d z = foot.linear().col(2);
  if (z.z() > upwards)
    foot.linear() = Eigen::Quaterniond::FromTwoVectors(z, Eigen::Vector3d::UnitZ()) *
                    Eigen::Matrix3d(foot.linear());
  return foot;
}

/// The posture that takes the least torque with the base lower by `crouch`, searched from `from`
/// on; nothing where none was found. `last`: where the search ended.
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
  // The trunk and the arms stay as they are where the legs alone get there. Straight legs do not
  // know which way to bend.
  std::optional<Eigen::VectorXd> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double others : {0.0, 0.1, 1.0}) {
    wanted.others = others;
    for (const double way : {0.0, 0.4, -0.4, 0.8, -0.8}) {
      auto found = posture_on_feet(model, standing, wanted, bent(model, standing, from, way),
                                   tolerance, &last);
      if (!found) continue;
      const double torque = torque_at(model, standing, *found);
      if (torque < least) best = std::move(found);
      least = std::min(least, torque);
    }
    if (best) break;
  }
  return best;
}

}  // namespace

Eigen::VectorXd crouched_posture(const Model& model, const Standing& standing,
                                 const Eigen::VectorXd& from, double crouch) {
  constexpr double less = 0.7;
  constexpr int most = 5;  // tries, the last but one at a third of it; then on straight legs
  std::optional<Eigen::VectorXd> first;
  Eigen::VectorXd last;
  double lower = crouch;
  for (int i = 0; i < most; ++i, lower = i + 1 < most ? lower * less : 0.0) {
    auto found = posture_lower_by(model, standing, from, lower, last);
    if (found && has_room(model, standing, *found)) return *found;
    if (!first) first = std::move(found);
  }
  if (first) return *first;
  throw Error("no posture was found with level feet, an upright base lowered by at most " +
              number(crouch) +
              " of its height above them (crouch), and the centre of mass above their middle" +
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
