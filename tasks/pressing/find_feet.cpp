#include "burnish/tasks/pressing/find_feet.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "base/words_in.hpp"
#include "burnish/dynamics/placement.hpp"
#include "ocp/position_limits.hpp"
#include "pressing/foot_shape.hpp"

namespace burnish {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Lengths as fractions of the base's height above the ground, chosen by hand.
constexpr double level = 0.1;      // largest difference in height between feet
constexpr double opposite = 0.15;  // largest distance of a foot from its partner's mirror image
// Assumed sizes of feet without a stated size, as fractions of the base's height.
constexpr double ball_radius = 0.05, sole_length = 0.2, sole_width = 0.1;
constexpr double longest_sole = 0.25, widest_sole = 0.15;  // largest sole from inertia

/// Returns a score of how well a name fits a foot frame; 0 means that the name does not fit.
int score_of(const std::string& name) {
  int score = has_one_of(name, {"sole"})           ? 8
              : has_one_of(name, {"foot", "feet"}) ? 6
              : has_one_of(name, {"toe", "paw"})   ? 4
              : has_one_of(name, {"ankle"})        ? 2
                                                   : 0;
  if (has_one_of(name, {"imu", "sensor", "_ft", "force", "torque", "motor", "rotor", "camera",
                        "constraint"}))
    score -= 3;
  return std::max(score, 0);
}

/// End of a branch of the robot in the reference posture. The end may be a foot.
struct End {
  int body = -1;            ///< Body at the end, which carries `frame`.
  std::vector<int> bodies;  ///< `body` and the toes that it carries.
  int frame = -1;           ///< Frame whose name has the best score; -1: none.
  double low = infinity;    ///< Height of the lowest point of `bodies` [m].
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< Origin of the frame, else of the body [m].
  int joints = 0;                                    ///< Number of joints of the leg.
};

class FootSearch {
 public:
  explicit FootSearch(const Robot& robot) : robot_(robot), model_(robot.model) {
    Eigen::VectorXd q = robot.reference_configuration();
    if (model_.loops.empty())
      for (const Joint& joint : model_.joints)
        if (joint.nq == 1)
          q[joint.q_index] = std::clamp(q[joint.q_index], model_.q_lower[joint.q_index],
                                        model_.q_upper[joint.q_index]);
    frames_ = frame_placements(model_, q);
    place_bodies();
  }

  std::optional<Feet> find() {
    std::vector<End> ends = low_ends();
    if (ends.empty()) {
      why_ = "no branch ends below the base";
      return std::nullopt;
    }
    if (!order(ends)) {
      // Keeps only ends that are named like feet, because other branches may be as low as the feet.
      const std::string why = why_;
      std::erase_if(ends, [&](const End& end) { return name_score(end) == 0; });
      if (ends.empty() || !order(ends)) {
        why_ = why;
        return std::nullopt;
      }
    }
    for (const End& end : ends)
      if (is_wheel(end)) {
        why_ = name_of(end) + " is a wheel on joint " + in_quotes(joint(end.body).name);
        return std::nullopt;
      }
    const bool soles = ends.front().joints >= (ends.size() == 2 ? 4 : 5);
    std::optional<Feet> feet = soles ? with_soles(ends) : with_balls(ends);
    if (feet) add_notes(*feet);
    return feet;
  }

  /// Returns the reason why find() returned nothing.
  const std::string& why() const { return why_; }

 private:
  /// Computes the placements of bodies and base in the world, and the heading (axes with x forwards
  /// and z up).
  void place_bodies() {
    bodies_.assign(model_.joints.size(), Eigen::Isometry3d::Identity());
    std::vector<bool> visited(model_.joints.size(), false);
    for (std::size_t i = 0; i < model_.frames.size(); ++i) {
      const Frame& frame = model_.frames[i];
      if (frame.body < 0 || visited[to_size(frame.body)]) continue;
      visited[to_size(frame.body)] = true;
      bodies_[to_size(frame.body)] = frames_[i] * frame.placement.inverse();
    }
    const bool floats =
        !model_.joints.empty() && model_.joints.front().kind == JointKind::FreeFlyer;
    base_ = floats ? bodies_.front() : Eigen::Isometry3d::Identity();
    const double yaw = std::atan2(base_.linear()(1, 0), base_.linear()(0, 0));
    heading_ = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  }

  const Frame& frame(int i) const { return model_.frames[to_size(i)]; }
  const Eigen::Isometry3d& placement(int frame) const { return frames_[to_size(frame)]; }
  const Eigen::Isometry3d& body_at(int body) const { return bodies_[to_size(body)]; }
  const Joint& joint(int body) const { return model_.joints[to_size(body)]; }
  bool is_root(int body) const { return body < 0 || joint(body).kind == JointKind::FreeFlyer; }

  /// Returns the height of the lowest point of a body's solids [m]; infinite without solids.
  double lowest_solid(int body) const {
    double low = infinity;
    for (const Visual& solid : pressing::solids_of(robot_, {body}))
      low = std::min(low, pressing::lowest_of(solid.shape, body_at(body) * solid.placement));
    return low;
  }
  /// Returns the height of the lowest point of a body's solids, or of its frames if it has no
  /// solids [m].
  double lowest(int body) const {
    double low = lowest_solid(body);
    if (std::isfinite(low)) return low;
    for (std::size_t i = 0; i < model_.frames.size(); ++i)
      if (model_.frames[i].body == body) low = std::min(low, frames_[i].translation().z());
    return low;
  }
  bool is_named(int body, std::initializer_list<std::string_view> words) const {
    return std::any_of(model_.frames.begin(), model_.frames.end(), [&](const Frame& frame) {
      return frame.body == body && has_one_of(frame.name, words);
    });
  }
  int joints_to(int body) const {
    int count = 0;
    for (int at = body; !is_root(at); at = joint(at).parent)
      if (!joint(at).follows) ++count;
    return count;
  }
  bool is_wheel(const End& end) const {
    return is_named(end.body, {"wheel"}) ||
           (pressing::turns_freely(model_, end.body) && name_score(end) < score_of("toe"));
  }
  int name_score(const End& end) const {
    return end.frame < 0 ? 0 : score_of(frame(end.frame).name);
  }
  std::string name_of(const End& end) const {
    return in_quotes(end.frame < 0 ? joint(end.body).name : frame(end.frame).name);
  }
  bool carries(int body, bool rotors_too) const {
    for (int other = 0; other < static_cast<int>(model_.joints.size()); ++other)
      if (joint(other).parent == body && (rotors_too || !is_rotor(other))) return true;
    return false;
  }
  /// Returns whether a body is the rotor of a motor, which some descriptions contain as a body.
  bool is_rotor(int body) const {
    if (!is_named(body, {"rotor"}) && joint(body).mass > 0.0) return false;
    const int best = named_frame(body);
    return !carries(body, true) && (best < 0 || score_of(frame(best).name) == 0);
  }

  /// Adds a note about legs whose ends were derived from mass and inertia.
  void add_notes(Feet& feet) const {
    if (assumed_.empty()) return;
    feet.notes.push_back(
        listed("link", assumed_) + (assumed_.size() == 1 ? " has" : " have") +
        " neither geometry nor a foot frame, so the end of the leg is estimated from "
        "mass and inertia; a foot frame in robot.yaml replaces this estimate");
  }

  End end_at(int body) const {
    End end{.body = body, .bodies = {body}, .low = lowest(body)};
    // A toe belongs to the foot that carries it.
    const int parent = joint(body).parent;
    if (!is_root(parent) && is_named(body, {"toe"}) && is_named(parent, {"foot", "sole"}) &&
        !is_named(body, {"foot", "sole"})) {
      end.body = parent;
      end.bodies.push_back(parent);
      end.low = std::min(end.low, lowest(parent));
    }
    end.joints = joints_to(end.body);
    end.frame = named_frame(end.body);
    end.middle =
        end.frame >= 0 ? placement(end.frame).translation() : body_at(end.body).translation();
    return end;
  }

  /// Returns the ends of the lowest branches, one for each foot.
  std::vector<End> low_ends() {
    std::vector<End> ends;
    for (int body = 0; body < static_cast<int>(model_.joints.size()); ++body) {
      if (is_root(body) || carries(body, false) || is_rotor(body) ||
          is_named(body, {"hand", "finger", "gripper", "wrist", "palm", "thumb"}))
        continue;
      End end = end_at(body);
      const auto same = std::find_if(ends.begin(), ends.end(),
                                     [&](const End& other) { return other.body == end.body; });
      if (same == ends.end()) {
        ends.push_back(end);
      } else {
        same->bodies.push_back(body);
        same->low = std::min(same->low, end.low);
      }
    }
    double ground = infinity;
    for (const End& end : ends) ground = std::min(ground, end.low);
    height_ = base_.translation().z() - ground;
    if (!(height_ > 0.0)) return {};
    std::erase_if(ends, [&](const End& end) { return end.low > ground + level * height_; });
    return ends;
  }

  /// Sorts ends into left-right pairs, from front to rear. If an end does not have a mirrored
  /// partner, returns false and sets why_.
  bool order(std::vector<End>& ends) {
    const std::size_t count = ends.size();
    if (count != 2 && count != 4 && count != 6) {
      why_ = std::to_string(count) + (count == 1 ? " branch ends" : " branches end") + " low:";
      constexpr std::size_t max_names = 8;
      for (std::size_t i = 0; i < std::min(count, max_names); ++i)
        why_ += (i == 0 ? " " : ", ") + name_of(ends[i]);
      if (count > max_names) why_ += " and " + std::to_string(count - max_names) + " more";
      why_ += "; wanted two, four or six such branches";
      return false;
    }
    const auto place = [&](const End& end) -> Eigen::Vector3d {
      return heading_.transpose() * (end.middle - base_.translation());
    };
    std::sort(ends.begin(), ends.end(),
              [&](const End& a, const End& b) { return place(a).x() > place(b).x(); });
    for (std::size_t i = 0; i < count; i += 2) {
      std::size_t partner = i + 1;
      double nearest = infinity;
      for (std::size_t k = i + 1; k < count; ++k) {
        Eigen::Vector3d mirrored = place(ends[k]);
        mirrored.y() = -mirrored.y();
        const double off = (mirrored - place(ends[i])).norm();
        if (off < nearest) partner = k;
        nearest = std::min(nearest, off);
      }
      const std::string pair = name_of(ends[i]) + " and " + name_of(ends[partner]);
      if (nearest > opposite * height_) {
        why_ = pair + " end low, but are " + number(std::round(1e3 * nearest) / 1e3) +
               " m away from mirror-symmetric positions; wanted at most " +
               number(std::round(1e3 * opposite * height_) / 1e3) + " m";
        return false;
      }
      if (ends[partner].joints != ends[i].joints) {
        why_ = pair + " end low at mirror-symmetric positions, but have legs of " +
               std::to_string(ends[i].joints) + " and " + std::to_string(ends[partner].joints) +
               " joints";
        return false;
      }
      std::swap(ends[i + 1], ends[partner]);
      if (place(ends[i]).y() < place(ends[i + 1]).y()) std::swap(ends[i], ends[i + 1]);
    }
    return true;
  }

  /// Returns the frame of a body whose name has the best score, or -1 if the body has no frames. Of
  /// frames with equal scores, returns the lowest one.
  int named_frame(int body) const {
    int best = -1;
    const auto is_better = [&](int a, int b) {
      const auto rank = [&](int i) {
        return score_of(frame(i).name) - (frame(i).kind == FrameKind::Joint ? 1 : 0);
      };
      if (rank(a) != rank(b)) return rank(a) > rank(b);
      return placement(a).translation().z() < placement(b).translation().z() - 1e-6;
    };
    for (int i = 0; i < static_cast<int>(model_.frames.size()); ++i)
      if (frame(i).body == body && (best < 0 || is_better(i, best))) best = i;
    return best;
  }

  /// Returns the axes R of a foot, reordered so that x points most nearly forwards and z up. If no
  /// axis is within 35 degrees of up, returns the heading.
  Eigen::Matrix3d level_axes(const Eigen::Matrix3d& R) const {
    constexpr double min_cosine = 0.82;  // cosine of 35 degrees, chosen by hand
    const auto along = [&](const Eigen::Vector3d& wanted, int taken) {
      int axis = -1;
      for (int k = 0; k < 3; ++k)
        if (k != taken &&
            (axis < 0 || std::abs(R.col(k).dot(wanted)) > std::abs(R.col(axis).dot(wanted))))
          axis = k;
      return axis;
    };
    const int up = along(Eigen::Vector3d::UnitZ(), -1);
    const Eigen::Vector3d z = R.col(up) * (R(2, up) < 0.0 ? -1.0 : 1.0);
    if (z.z() < min_cosine) return heading_;
    const Eigen::Vector3d forwards = heading_.col(0);
    const int ahead = along(forwards, up);
    const Eigen::Vector3d x = R.col(ahead) * (R.col(ahead).dot(forwards) < 0.0 ? -1.0 : 1.0);
    Eigen::Matrix3d axes;
    axes << x, z.cross(x), z;
    return axes;
  }

  std::vector<pressing::PlacedShape> solids_in(const End& end, const Eigen::Matrix3d& axes) const {
    std::vector<pressing::PlacedShape> solids;
    for (const Visual& solid : pressing::solids_of(robot_, end.bodies))
      solids.push_back({solid.shape, Eigen::Isometry3d(axes.transpose()) *
                                         bodies_[to_size(solid.body)] * solid.placement});
    return solids;
  }

  /// Adds a frame of a foot at `p` [m] with the axes `axes`, both in the world. Uses the frame of
  /// `end` if it is within `tolerance` [m] of `p` and, for a sole, has these axes.
  void put_frame(const End& end, const Eigen::Vector3d& p, const Eigen::Matrix3d& axes,
                 double tolerance, Feet& feet) const {
    const bool turned = feet.has_soles();  // a point foot may have axes of any orientation
    if (end.frame >= 0 && frame(end.frame).kind != FrameKind::Joint) {
      const Eigen::Isometry3d& at = placement(end.frame);
      // Norm of the difference below which rotation matrices count as equal; chosen by hand.
      constexpr double same = 1e-2;
      if ((at.translation() - p).norm() < tolerance &&
          (!turned || (at.linear() - axes).norm() < same)) {
        feet.frames.push_back(frame(end.frame).name);
        return;
      }
    }
    const std::string& stem = end.frame >= 0 ? frame(end.frame).name : joint(end.body).name;
    Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
    placed.linear() = axes;
    placed.translation() = p;
    feet.frames.push_back(stem + (turned ? "/sole" : "/ball"));
    if (!model_.has_frame(feet.frames.back()))
      feet.added.push_back(
          {feet.frames.back(), FrameKind::User, end.body, body_at(end.body).inverse() * placed});
  }

  /// Returns the sole of a foot in the given axes. Its size comes from the foot's solids, or else
  /// from its inertia, or else from the height of the base.
  pressing::SoleShape sole(const End& end, const Eigen::Matrix3d& axes, Feet::Size& from) const {
    constexpr double min_side = 0.02;  // shortest side, as a fraction of the base's height
    if (const auto sole = pressing::sole_of(solids_in(end, axes), min_side * height_)) {
      from = Feet::Size::Collision;
      return *sole;
    }
    from = Feet::Size::Height;
    pressing::SoleShape sole{axes.transpose() * end.middle, 0.5 * sole_length * height_,
                             0.5 * sole_width * height_};
    const Joint& foot = joint(end.body);
    const Eigen::Matrix3d R = axes.transpose() * body_at(end.body).linear();
    const Eigen::Vector3d box =
        pressing::box_of(foot.mass, R * foot.inertia_at_com * R.transpose());
    constexpr double shortest_sole = 0.1, narrowest_sole = 0.04;  // fractions of the base's height
    if (box.x() < shortest_sole * height_ || box.y() < narrowest_sole * height_) return sole;
    from = Feet::Size::Inertia;
    sole.half_x = 0.5 * std::min(box.x(), longest_sole * height_);
    sole.half_y = 0.5 * std::min(box.y(), widest_sole * height_);
    if (end.frame >= 0 && has_one_of(frame(end.frame).name, {"sole"})) return sole;
    const Eigen::Vector3d com = axes.transpose() * (body_at(end.body) * foot.com);
    const double ankle = (axes.transpose() * body_at(end.body).translation()).z();
    sole.centre.head<2>() = com.head<2>();
    // Assumes that a frame below the ankle is on the ground.
    if (sole.centre.z() > ankle - min_side * height_)
      sole.centre.z() = std::min(ankle, com.z() - 0.5 * box.z());
    return sole;
  }

  std::optional<Feet> with_soles(const std::vector<End>& ends) const {
    Feet feet;
    feet.half_x = feet.half_y = infinity;
    for (const End& end : ends) {
      const Eigen::Matrix3d axes =
          level_axes(end.frame >= 0 ? placement(end.frame).linear() : body_at(end.body).linear());
      const pressing::SoleShape shape = sole(end, axes, feet.size_from);
      feet.half_x = std::min(feet.half_x, shape.half_x);
      feet.half_y = std::min(feet.half_y, shape.half_y);
      constexpr double near = 0.1;  // tolerance of positions / half the width
      put_frame(end, axes * shape.centre, axes, near * shape.half_y, feet);
    }
    return feet;
  }

  /// Returns the end of a link without geometry. The link is modelled as a rod from its joint
  /// through its centre of mass, with the mass and the largest moment of inertia of the link.
  std::optional<Eigen::Vector3d> tip_of(const End& end) const {
    const Joint& link = joint(end.body);
    const Eigen::Vector3d arm = body_at(end.body).linear() * link.com;
    constexpr double min_arm = 0.02;  // shortest arm, as a fraction of the base's height
    if (!(link.mass > 0.0) || arm.norm() < min_arm * height_) return std::nullopt;
    const double moment = link.inertia_at_com.diagonal().maxCoeff();
    return Eigen::Vector3d(body_at(end.body).translation() + arm +
                           std::sqrt(3.0 * moment / link.mass) * arm.normalized());
  }

  /// Returns whether a foot's frame is well above its lowest solid, as the axle of a wheel is.
  bool is_above_rounding(const End& end) const {
    constexpr double max_radius = 0.2;  // fraction of the base's height; chosen by hand
    const double radius = end.middle.z() - end.low;
    return name_score(end) >= score_of("toe") && std::isfinite(lowest_solid(end.body)) &&
           radius > level * height_ && radius < max_radius * height_;
  }

  std::optional<Feet> with_balls(const std::vector<End>& ends) {
    // Largest distance at which a frame is taken as the centre of a foot [m]; chosen by hand.
    constexpr double near = 2e-3;
    Feet feet;
    feet.radius = infinity;
    for (const End& end : ends) {
      pressing::BallShape ball{heading_.transpose() * end.middle, ball_radius * height_};
      if (const auto found = pressing::ball_of(solids_in(end, heading_))) {
        ball = *found;
        feet.size_from = Feet::Size::Collision;
      } else if (const auto tip = tip_of(end);
                 tip && name_score(end) == 0 && !std::isfinite(lowest_solid(end.body))) {
        ball.centre = heading_.transpose() * *tip;
        ball.radius = ball_radius * (base_.translation().z() - tip->z());
        ball.centre.z() += ball.radius;
        assumed_.push_back(end.frame < 0 ? joint(end.body).name : frame(end.frame).name);
      } else if (is_above_rounding(end)) {
        ball.radius = end.middle.z() - end.low;
        feet.size_from = Feet::Size::Collision;
      } else if (end.frame < 0 || end.middle.z() > end.low + level * height_) {
        why_ = name_of(end) + " ends low, but has no sphere or frame at its contact point";
        return std::nullopt;
      }
      feet.radius = std::min(feet.radius, ball.radius);
      put_frame(end, heading_ * ball.centre, heading_, near, feet);
    }
    return feet;
  }

  const Robot& robot_;
  const Model& model_;
  std::vector<Eigen::Isometry3d> frames_, bodies_;  ///< Placements in the world.
  Eigen::Isometry3d base_;
  Eigen::Matrix3d heading_;
  double height_ = 0.0;               ///< Height of the base above the lowest point [m].
  std::string why_;                   ///< Reason why no feet were found.
  std::vector<std::string> assumed_;  ///< Links whose ends were derived from mass and inertia.
};

}  // namespace

std::optional<Feet> find_feet(const Robot& robot, std::string* why) {
  if (robot.model.joints.empty()) {
    if (why != nullptr) *why = "the robot does not have a joint";
    return std::nullopt;
  }
  FootSearch search(robot);
  auto feet = search.find();
  if (!feet && why != nullptr) *why = search.why();
  return feet;
}

Robot with_feet(Robot robot, const Feet& feet) {
  for (const Frame& frame : feet.added)
    if (!robot.model.has_frame(frame.name)) robot.model.frames.push_back(frame);
  return robot;
}

Standing with_feet(Standing standing, const Feet& feet) {
  standing.feet = feet.frames;
  standing.half_x = feet.half_x;
  standing.half_y = feet.half_y;
  if (feet.radius > 0.0) standing.radius = feet.radius;
  return standing;
}

std::string feet_text(const Feet& feet) {
  std::string text;
  for (const std::string& frame : feet.frames) text += (text.empty() ? "" : ", ") + frame;
  const auto millimetres = [](double length) { return number(std::round(1e3 * length) / 1e3); };
  text += " (found), ";
  text += feet.has_soles() ? "soles of " + millimetres(2.0 * feet.half_x) + " x " +
                                 millimetres(2.0 * feet.half_y) + " m"
                           : "point feet of radius " + millimetres(feet.radius) + " m";
  switch (feet.size_from) {
    case Feet::Size::Collision:
      return text + ", from collision geometry";
    case Feet::Size::Inertia:
      return text + ", from the inertia of the foot";
    case Feet::Size::Height:
      return text + ", assumed as a fraction of the height of the base: no geometry states it";
  }
  return text;
}

}  // namespace burnish
