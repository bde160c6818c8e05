#include "pressing/reach_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/reference.hpp"
#include "burnish/model/state.hpp"
#include "pressing/standing_terms.hpp"

namespace burnish::pressing {
namespace {

bool is_limited(const Joint& joint) { return joint.nq == 1; }

}  // namespace

class ReachWalk::Impl {
 public:
  Impl(const Model& model, const SceneSpec& scene, const Eigen::VectorXd& q_start,
       const ReachOptions& options, bool has_path)
      : options_(options),
        touch_(scene.tool()),
        surface_(surface_of(touch_.surface)),
        surface_axes_(Reference::surface_with_normal(touch_.surface.normal).rotation),
        model_(model),
        body_(model_),
        tool_(body_.frame(touch_.frame)),
        q_start_(q_start),
        q_(q_start),
        has_path_(has_path),
        supports_(scene.supports()),
        carrying_(supports_) {
    report_.joint_margin = report_.clearance = std::numeric_limits<double>::infinity();
    find_skeleton();
    evaluate(q_);
    start_rotation_ = body_.placement(tool_).linear();
    start_com_ = body_.com();
    for (const TouchSpec& support : supports_)
      stood_.push_back(body_.placement(body_.frame(support.frame)));
  }

  void load(const std::string& support, const Eigen::Vector3d& force_world) {
    const auto at = std::find_if(carrying_.begin(), carrying_.end(),
                                 [&](const TouchSpec& each) { return each.frame == support; });
    if (at == carrying_.end())
      throw Error("reach check: " + in_quotes(support) + " is not a support of the scene");
    carrying_.erase(at);
    loads_.push_back({body_.frame(support), force_world});
  }

  /// Moves to a stop and checks it. Returns false at the first problem.
  bool visit(const ReachStop& stop) {
    ++report_.points;
    Eigen::VectorXd q = q_;
    if (!settle(q, stop.p_world, true)) {
      refuse_position(stop);
      return false;
    }
    q_ = q;
    note_margins();
    return stays_outside(stop) && torques_fit(stop, 0.0) &&
           (stop.force == 0.0 || torques_fit(stop, stop.force));
  }

  bool pass(const Eigen::VectorXd& q, const std::string& where) {
    ++report_.points;
    q_ = q;
    evaluate(q_);
    note_margins();
    const ReachStop stop{body_.placement(tool_).translation(), 0.0, 0.0, where};
    return tip_stays_outside(stop) && stays_outside(stop) && torques_fit(stop, 0.0);
  }

  const Eigen::VectorXd& posture() const { return q_; }
  ReachReport& report() { return report_; }

 private:
  void evaluate(const Eigen::VectorXd& q) {
    if (!is_usable(body_.update(q, Eigen::VectorXd::Zero(model_.nv))))
      throw Error("a posture of the reach check cannot be evaluated");
    body_.frame_derivatives(tool_, Reference::centered(), derivatives_);
  }

  /// Moves q until the tool is at `p`. In the null space, the tool's orientation and the posture
  /// return to the start. Returns false if the tool stays away from `p` by more than the tolerance.
  bool settle(Eigen::VectorXd& q, const Eigen::Vector3d& p, bool within_limits) {
    constexpr int max_iterations = 200;
    // Damping of the position error [m (rad)], largest step per iteration [rad (m)], and null-space
    // gains, chosen by hand.
    constexpr double damping = 1e-3, max_step = 0.2;
    constexpr double orientation = 0.05, posture = 0.02;
    for (int iteration = 0; iteration < max_iterations; ++iteration) {
      evaluate(q);
      const Eigen::Isometry3d placement = body_.placement(tool_);
      const Eigen::Vector3d error = p - placement.translation();
      off_ = error.norm();
      // At least three iterations are made, because otherwise the null-space motion would lag
      // behind the path.
      if (off_ < 0.01 * options_.tolerance && iteration >= 3) return true;
      const Eigen::AngleAxisd turned(
          Eigen::Matrix3d(start_rotation_ * placement.linear().transpose()));
      const Eigen::VectorXd free =
          within_limits ? free_directions(q) : Eigen::VectorXd::Ones(model_.nv);
      const Footing footing = stand(free);
      const Eigen::MatrixXd J = derivatives_.jacobian * free.asDiagonal() * footing.allowed;
      const Eigen::MatrixXd Jp = carried(J.topRows<3>(), footing), Jr = J.bottomRows<3>();
      Eigen::VectorXd wanted = Eigen::VectorXd::Zero(Jp.rows());
      wanted.head<3>() = error - derivatives_.jacobian.topRows<3>() * footing.back;
      if (wanted.size() > 3) wanted.tail<2>() = (start_com_ - body_.com()).head<2>();
      const Eigen::VectorXd secondary =
          orientation * Jr.transpose() * (turned.angle() * turned.axis()) +
          posture * footing.allowed.transpose() * difference(model_, q, q_start_);
      Eigen::VectorXd dq =
          footing.back +
          footing.allowed *
              (secondary + damped_step(Jp, Eigen::VectorXd::Constant(Jp.rows(), damping * damping),
                                       wanted - Jp * secondary));
      dq *= std::min(1.0, max_step / std::max(dq.cwiseAbs().maxCoeff(), 1e-12));
      q = integrate(model_, q, dq);
      if (within_limits) clamp(q);
    }
    return off_ < options_.tolerance;
  }

  /// Basis of the joint motions that keep the feet in place, and a step that moves the feet back.
  struct Footing {
    /// Orthonormal basis of the motions that keep the feet in place (nv x freedom).
    Eigen::MatrixXd allowed;
    Eigen::VectorXd back;  ///< Step that moves the feet back to their starting placements (nv).
    /// Jacobian of the horizontal position of the centre of mass (2 x freedom).
    Eigen::MatrixXd com;
  };
  Footing stand(const Eigen::VectorXd& free) {
    Footing footing;
    footing.back = Eigen::VectorXd::Zero(model_.nv);
    if (stood_.empty()) {
      footing.allowed = Eigen::MatrixXd::Identity(model_.nv, model_.nv);
      return footing;
    }
    const Eigen::MatrixXd J = support_jacobian(model_, body_, supports_) * free.asDiagonal();
    Eigen::VectorXd off(J.rows());
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < stood_.size(); ++i) {
      const Eigen::Isometry3d at = body_.placement(body_.frame(supports_[i].frame));
      off.segment<3>(row) = stood_[i].translation() - at.translation();
      row += 3;
      if (!supports_[i].is_rectangle()) continue;
      const Eigen::AngleAxisd turn(Eigen::Matrix3d(stood_[i].linear() * at.linear().transpose()));
      off.segment<3>(row) = turn.angle() * turn.axis();
      row += 3;
    }
    footing.allowed = free.asDiagonal() * null_space(J);
    footing.back = free.asDiagonal() * least_squares(J, off);
    body_.update_derivatives();
    footing.com = body_.com_dq().topRows<2>() * footing.allowed;
    return footing;
  }
  /// Returns the Jacobian rows of the tool, followed by rows for balance if the robot stands.
  static Eigen::MatrixXd carried(const Eigen::MatrixXd& tool, const Footing& footing) {
    if (footing.com.rows() == 0) return tool;
    Eigen::MatrixXd both(tool.rows() + footing.com.rows(), tool.cols());
    both << tool, footing.com;
    return both;
  }

  double lower(const Joint& joint) const {
    return model_.q_lower[joint.q_index] + options_.joint_margin;
  }
  double upper(const Joint& joint) const {
    return model_.q_upper[joint.q_index] - options_.joint_margin;
  }

  static const char* unit(const Joint& joint) {
    return joint.kind == JointKind::Prismatic ? " m" : " rad";
  }
  bool is_sliding(int k) const {
    return model_.joints[to_size(model_.joint_of_v[to_size(k)])].kind == JointKind::Prismatic;
  }

  void clamp(Eigen::VectorXd& q) const {
    for (const Joint& joint : model_.joints)
      if (is_limited(joint))
        q[joint.q_index] = std::min(std::max(q[joint.q_index], lower(joint)), upper(joint));
  }
  /// Returns 0 for joints at a limit, which stay still in this iteration, and 1 for other joints.
  Eigen::VectorXd free_directions(const Eigen::VectorXd& q) const {
    Eigen::VectorXd free = Eigen::VectorXd::Ones(model_.nv);
    for (const Joint& joint : model_.joints)
      if (is_limited(joint) &&
          (q[joint.q_index] <= lower(joint) || q[joint.q_index] >= upper(joint)))
        free[joint.v_index] = 0.0;
    return free;
  }

  void note_margins() {
    for (const Joint& joint : model_.joints) {
      if (!is_limited(joint)) continue;
      const double q = q_[joint.q_index];
      const double margin =
          std::min(q - model_.q_lower[joint.q_index], model_.q_upper[joint.q_index] - q);
      if (margin >= report_.joint_margin) continue;
      report_.joint_margin = margin;
      report_.tightest_joint = joint.name;
    }
  }

  void refuse(ReachProblem problem, const ReachStop& stop, const std::string& joint, double value,
              double limit, const std::string& what) {
    report_.problem = problem;
    report_.s = stop.s;
    report_.p_world = stop.p_world;
    report_.joint = joint;
    report_.value = value;
    report_.limit = limit;
    const Eigen::Vector3d& p = stop.p_world;
    char mm[32];
    std::snprintf(mm, sizeof mm, "%.0f mm", 1e3 * std::abs(stop.s));
    char at[96];
    std::snprintf(at, sizeof at, "(%.3f, %.3f, %.3f) m", p.x(), p.y(), p.z());
    const std::string where =
        has_path_      ? stop.s < 0.0 ? " before the start of the path" : " along the path"
        : stop.s < 0.0 ? " above the surface"
                       : "";
    const std::string place = where.empty() ? std::string("at the point") : mm + where;
    report_.text =
        (stop.where.empty() ? place : stop.where) + ", with the tool at " + at + ", " + what;
  }

  /// Reports that the tool does not reach a position. If the tool reaches it without joint limits,
  /// reports the violated joint limit instead.
  void refuse_position(const ReachStop& stop) {
    const double off = off_;
    Eigen::VectorXd q = q_;
    if (settle(q, stop.p_world, false)) {
      for (const Joint& joint : model_.joints) {
        if (!is_limited(joint)) continue;
        const double value = q[joint.q_index];
        const bool low = value < lower(joint);
        if (!low && value <= upper(joint)) continue;
        const double limit = low ? lower(joint) : upper(joint);
        refuse(ReachProblem::Joint, stop, joint.name, value, limit,
               "joint " + in_quotes(joint.name) + " would be at " + number(value) + unit(joint) +
                   "; wanted " + (low ? "at least " : "at most ") + number(limit));
        return;
      }
    }
    refuse(ReachProblem::Position, stop, "", off, options_.tolerance,
           "the arm cannot reach this point: the tool stays " + number(off) +
               " m away from it; wanted at most " + number(options_.tolerance) + " m");
  }

  /// Collects the joints that carry the tool, each with a frame on its body. Leaves out the joint
  /// that is attached to the world, because its origin does not move.
  void find_skeleton() {
    const Frame& tip = model_.frames[to_size(model_.frame_index(touch_.frame))];
    int last = tip.body;
    // Excludes a joint with its origin at the tip, because the tip touches the surface.
    if (last >= 0 && tip.placement.translation().norm() < options_.link_radius)
      last = model_.joints[to_size(last)].parent;
    for (int j = last; j >= 0; j = model_.joints[to_size(j)].parent) {
      if (model_.joints[to_size(j)].parent < 0) break;
      for (const Frame& frame : model_.frames) {
        if (frame.body != j) continue;
        // Skips a frame if an earlier frame has its name, because lookups by name find the earlier.
        const auto found = to_size(model_.frame_index(frame.name));
        if (&model_.frames[found] != &frame) continue;
        skeleton_.push_back({j, body_.frame(frame.name), frame.placement.inverse().translation()});
        break;
      }
    }
  }

  /// Returns the distance between a point and the surface with the material behind it [m]; negative
  /// inside.
  double distance_at(const Eigen::Vector3d& p_world) const {
    const SurfaceSpec& surface = touch_.surface;
    const double height = surface_.at(p_world).distance;
    if (std::isinf(surface.extent)) return height;
    const Eigen::Vector3d p = surface_axes_.transpose() * (p_world - surface.point);
    const Eigen::Vector3d beyond(std::abs(p.x()) - surface.extent, std::abs(p.y()) - surface.extent,
                                 height);
    const double inside = beyond.maxCoeff();
    return inside <= 0.0 ? inside : beyond.cwiseMax(0.0).norm();
  }
  /// Returns the point of the line from a to b that is nearest to the material, as a fraction of
  /// the line. Uses ternary search, because the distance is convex along a line.
  double nearest_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 24; ++i) {
      const double third = (high - low) / 3.0;
      if (distance_at(a + (low + third) * (b - a)) < distance_at(a + (high - third) * (b - a)))
        high -= third;
      else
        low += third;
    }
    return 0.5 * (low + high);
  }

  bool tip_stays_outside(const ReachStop& stop) {
    const double distance = distance_at(stop.p_world), radius = touch_.radius;
    if (distance >= radius) return true;
    refuse(ReachProblem::Collision, stop, "", distance, radius,
           "the tool's centre would be " + number(std::abs(distance)) +
               (distance < 0.0 ? " m inside the surface" : " m from the surface") +
               "; wanted at least " + number(radius) + " m outside, the tip's radius");
    return false;
  }

  /// Returns whether the arm stays outside the surface and its material.
  bool stays_outside(const ReachStop& stop) {
    std::vector<Eigen::Vector3d> origins;
    for (const Node& node : skeleton_) origins.push_back(body_.placement(node.frame) * node.origin);
    for (std::size_t i = 0; i < skeleton_.size(); ++i) {
      double distance = distance_at(origins[i]);
      std::size_t nearest = i;
      // The point of a link nearest to an infinite plane is one of the link's ends.
      if (i + 1 < skeleton_.size() && std::isfinite(touch_.surface.extent)) {
        const double fraction = nearest_between(origins[i], origins[i + 1]);
        const double between = distance_at(origins[i] + fraction * (origins[i + 1] - origins[i]));
        if (between < distance) {
          distance = between;
          nearest = fraction < 0.5 ? i : i + 1;
        }
      }
      if (!keeps_off(stop, skeleton_[nearest].joint, distance)) return false;
    }
    return true;
  }
  bool keeps_off(const ReachStop& stop, int joint, double distance) {
    const std::string& name = model_.joints[to_size(joint)].name;
    if (distance - options_.link_radius < report_.clearance) {
      report_.clearance = distance - options_.link_radius;
      report_.tightest_clearance = name;
    }
    if (distance >= options_.link_radius) return true;
    refuse(ReachProblem::Collision, stop, name, distance, options_.link_radius,
           "the arm at joint " + in_quotes(name) + " would be " + number(std::abs(distance)) +
               (distance < 0.0 ? " m inside the surface" : " m from the surface") +
               "; wanted at least " + number(options_.link_radius) + " m outside");
    return false;
  }

  bool torques_fit(const ReachStop& stop, double force) {
    evaluate(q_);
    const Eigen::Vector3d normal = surface_.at(stop.p_world).normal;
    Eigen::VectorXd needed = Eigen::VectorXd(body_.gravity_torque()) -
                             derivatives_.jacobian.topRows(3).transpose() * (force * normal);
    FrameDerivatives loaded;
    for (const Load& load : loads_) {
      body_.frame_derivatives(load.frame, Reference::centered(), loaded);
      needed -= loaded.jacobian.topRows(3).transpose() * load.force_world;
    }
    const Eigen::VectorXd tau = torque_on_supports(model_, body_, carrying_, needed);
    if (force > 0.0) note_force_sensitivity(normal);
    for (int k = 0; k < model_.nv; ++k) {
      const double limit = model_.effort_limit[k];
      const Joint& joint = model_.joints[to_size(model_.joint_of_v[to_size(k)])];
      if (!std::isfinite(limit) || joint.kind == JointKind::FreeFlyer) continue;
      const double fraction = std::abs(tau[k]) / limit;
      if (fraction > report_.torque_share) {
        report_.torque_share = fraction;
        report_.tightest_torque = model_.v_name(k);
      }
      if (fraction <= options_.torque_share) continue;
      const std::string load =
          force > 0.0 ? "pressing with " + number(force) + " N" : "the weight of the arm alone";
      refuse(ReachProblem::Torque, stop, model_.v_name(k), std::abs(tau[k]),
             options_.torque_share * limit,
             load + " needs " + number(std::abs(tau[k])) + (is_sliding(k) ? " N" : " Nm") +
                 " in joint " + in_quotes(model_.v_name(k)) + "; wanted at most " +
                 number(options_.torque_share * limit));
      return false;
    }
    return true;
  }

  /// Computes the change of the normal force per torque error, and keeps the largest one in the
  /// report. The force f of joint torques tau is the least-squares solution f = (J J^T)^-1 J tau.
  void note_force_sensitivity(const Eigen::Vector3d& normal) {
    // Square of the lever arm below which joint torques cannot determine a force [m^2]. Chosen by
    // hand.
    constexpr double damping = 1e-6;
    const Eigen::VectorXd per_torque =
        damped_step(derivatives_.jacobian.topRows(3), Eigen::Vector3d::Constant(damping), normal);
    if (per_torque.norm() <= report_.force_per_torque) return;
    report_.force_per_torque = per_torque.norm();
    Eigen::Index joint = 0;
    per_torque.cwiseAbs().maxCoeff(&joint);
    report_.force_joint = model_.v_name(static_cast<int>(joint));
  }

  /// Origin of a joint, expressed in a frame on the joint's body.
  struct Node {
    int joint, frame;
    Eigen::Vector3d origin;
  };

  /// Stated force on a support.
  struct Load {
    int frame;
    Eigen::Vector3d force_world;  ///< Force, in world axes [N].
  };

  ReachOptions options_;
  TouchSpec touch_;  ///< Tool and surface that it touches.
  Surface surface_;
  Eigen::Matrix3d surface_axes_;
  const Model& model_;
  RigidBody body_;
  int tool_;
  const Eigen::VectorXd& q_start_;
  Eigen::VectorXd q_;
  bool has_path_;
  std::vector<TouchSpec> supports_;
  std::vector<TouchSpec> carrying_;  ///< Supports without a stated force.
  std::vector<Load> loads_;
  Eigen::Matrix3d start_rotation_;
  Eigen::Vector3d start_com_;
  std::vector<Eigen::Isometry3d> stood_;  ///< Starting placements of the supports' frames.
  FrameDerivatives derivatives_;
  std::vector<Node> skeleton_;
  double off_ = 0.0;  ///< Position error of the tool after the last settle() [m].
  ReachReport report_;
};

ReachWalk::ReachWalk(const Model& model, const SceneSpec& scene, const Eigen::VectorXd& q_start,
                     const ReachOptions& options, bool has_path)
    : impl_(std::make_unique<Impl>(model, scene, q_start, options, has_path)),
      spacing_(options.spacing) {}
ReachWalk::~ReachWalk() = default;
void ReachWalk::load(const std::string& support, const Eigen::Vector3d& force_world) {
  impl_->load(support, force_world);
}
bool ReachWalk::visit(const ReachStop& stop) { return impl_->visit(stop); }
bool ReachWalk::pass(const Eigen::VectorXd& q, const std::string& where) {
  return impl_->pass(q, where);
}
const Eigen::VectorXd& ReachWalk::posture() const { return impl_->posture(); }
ReachReport& ReachWalk::report() { return impl_->report(); }

bool ReachWalk::visit_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double s_end) {
  const double length = (to - from).norm();
  const int steps = std::max(1, static_cast<int>(std::ceil(length / spacing_)));
  for (int i = 0; i <= steps; ++i) {
    const double fraction = static_cast<double>(i) / steps;
    if (!visit({from + fraction * (to - from), s_end - (1.0 - fraction) * length, 0.0}))
      return false;
  }
  return true;
}

}  // namespace burnish::pressing
