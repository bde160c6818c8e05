#include "pressing/posture_search.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/model/state.hpp"
#include "pressing/tool_direction.hpp"
#include "sim/random.hpp"

namespace burnish::pressing {
namespace {

bool is_limited(const Model& model, const Joint& joint) {
  return joint.nq == 1 && std::isfinite(model.q_lower[joint.q_index]) &&
         std::isfinite(model.q_upper[joint.q_index]);
}

struct Candidate {
  Eigen::VectorXd q;
  double tilt = 0.0, margin = 0.0, off = 0.0, torque = 0.0;
  double body = 0.0;            ///< Distance between two robot parts, see measure_body() [m].
  double body_wanted = 0.0;     ///< Required distance between these parts [m].
  double manipulability = 0.0;  ///< Smallest singular value of the tool's Jacobian [m].
};

/// Weights of two goals of a search step: to turn the tool's axis to its target, and to move joints
/// towards the middle of their ranges.
struct Balance {
  double damping;  ///< Damping of the axis error [rad]; infinite: the axis is ignored.
  double middle;  ///< Fraction of the distance to the middle of the joint ranges that a step moves.
};
// Weights that the search tries from each starting posture, chosen by hand.
constexpr Balance balances[] = {{0.05, 0.0}, {0.05, 0.02}, {1.0, 0.05}};

struct SearchInput {
  const PressingPlace& place;
  const Model& model;
  const std::vector<Eigen::VectorXd>& known;
  const PostureOptions& options;
  const CheckReach& check_reach;
};

/// Search that improves starting postures by iteration, and evaluates the results.
class Search {
 public:
  /// `press`: unit vector of the pressing direction, in the frame of the tool.
  Search(const SearchInput& in, Eigen::Vector3d press)
      : place_(in.place),
        options_(in.options),
        known_(in.known),
        model_(in.model),
        body_(model_),
        tool_(body_.frame(place_.tool)),
        into_(-place_.normal_world.normalized()),
        press_(std::move(press)),
        q_middle_(model_.q_neutral),
        reach_(Eigen::VectorXd::Ones(model_.nv)) {
    for (const Joint& joint : model_.joints) {
      if (!is_limited(model_, joint)) continue;
      const double lower = model_.q_lower[joint.q_index], upper = model_.q_upper[joint.q_index];
      q_middle_[joint.q_index] = 0.5 * (lower + upper);
      reach_[joint.v_index] = std::max(0.5 * (upper - lower), 1e-6);
    }
  }

  /// Returns the starting postures, in the order in which they are tried.
  std::vector<Eigen::VectorXd> starts() const {
    std::vector<Eigen::VectorXd> result = known_;
    result.push_back(q_middle_);
    RandomStream random(options_.seed, 0);
    for (int i = 0; i < options_.random_starts; ++i) {
      Eigen::VectorXd q = q_middle_;
      for (const Joint& joint : model_.joints)
        if (is_limited(model_, joint))
          q[joint.q_index] = random.uniform(model_.q_lower[joint.q_index] + margin_of(joint),
                                            model_.q_upper[joint.q_index] - margin_of(joint));
      result.push_back(std::move(q));
    }
    return result;
  }

  Candidate descend(Eigen::VectorXd q, const Balance& balance) {
    walk(q, balance, 100);
    // Moves the tool to its position once more, because joints at their limits can leave a position
    // error.
    if (place_.point_world) walk(q, {std::numeric_limits<double>::infinity(), 0.0}, 50);
    clamp(q);
    unwind(q);
    return evaluated(q);
  }

  /// Returns a text about the first condition that the candidate violates; empty if the candidate
  /// meets all conditions on starting postures.
  std::string complaint(const Candidate& c) const {
    const auto turned = [](double rad) { return number(rad * 57.29577951308232) + " degrees"; };
    if (c.off > options_.reach.tolerance)
      return "the tool stays " + number(c.off) +
             " m away from its start position above the surface";
    if (c.tilt > options_.tilt_limit)
      return "the tool's axis stays " + turned(c.tilt) +
             " off the surface's normal; wanted at most " + turned(options_.tilt_limit);
    if (c.margin < options_.joint_margin - 1e-9)
      return "a joint comes within " + number(c.margin) + " rad of its limit; wanted at least " +
             number(options_.joint_margin) + " rad (search.joint_margin)";
    if (c.body < c.body_wanted)
      return "the tool comes within " + number(c.body) +
             " m of the robot's body; wanted at least " + number(c.body_wanted) +
             " m (search.body_distance)";
    return "";
  }
  /// Returns the weighted sum of the amounts by which the candidate violates the conditions.
  double shortfall(const Candidate& c) const {
    return 10.0 * c.off + std::max(0.0, c.tilt - options_.tilt_limit) +
           std::max(0.0, options_.joint_margin - c.margin) +
           4.0 * std::max(0.0, c.body_wanted - c.body);
  }

 private:
  void walk(Eigen::VectorXd& q, const Balance& balance, int iterations) {
    constexpr double max_step = 0.2;  // largest step of an iteration [rad (m)], chosen by hand
    for (int i = 0; i < iterations; ++i) {
      clamp(q);
      const Eigen::VectorXd dq = step_from(q, balance);
      const double size = dq.cwiseAbs().maxCoeff();
      q = integrate(model_, q, dq * std::min(1.0, max_step / std::max(size, 1e-12)));
      if (size < 1e-5) break;
    }
  }

  void evaluate(const Eigen::VectorXd& q) {
    if (!is_usable(body_.update(q, Eigen::VectorXd::Zero(model_.nv))))
      throw Error("a posture of the search cannot be evaluated");
    body_.frame_derivatives(tool_, Reference::centered(), derivatives_);
    placement_ = body_.placement(tool_);
  }

  /// Returns the target of the tool's centre, if the task states a point of the surface.
  std::optional<Eigen::Vector3d> wanted_position() const {
    if (!place_.point_world) return std::nullopt;
    return *place_.point_world - (place_.tip_radius + place_.clearance) * into_;
  }

  /// Returns one damped step towards the target axis and position. In the null space of the
  /// tool's motion, joints move towards the middle of their ranges.
  Eigen::VectorXd step_from(const Eigen::VectorXd& q, const Balance& balance) {
    constexpr double place_damping = 0.05;  // damping of the position error; chosen by hand
    evaluate(q);
    const Eigen::Vector3d axis = placement_.linear() * press_;
    const std::optional<Eigen::Vector3d> place = wanted_position();
    const int rows = place ? 6 : 3, nv = model_.nv;
    Eigen::MatrixXd J(rows, nv);
    Eigen::VectorXd error(rows);
    // Shortest rotation from the pressing axis to the inward normal. If the two are opposite, any
    // perpendicular rotation axis serves.
    Eigen::Vector3d turn = axis.cross(into_);
    const double sine = turn.norm();
    turn = sine > 1e-9 ? Eigen::Vector3d(turn / sine) : Eigen::Vector3d(axis.unitOrthogonal());
    error.head<3>() = std::atan2(sine, axis.dot(into_)) * turn;
    // Removes rotations about the pressing axis, because the task leaves them free.
    J.topRows<3>() = derivatives_.jacobian.bottomRows<3>();
    J.topRows<3>() -= axis * (axis.transpose() * derivatives_.jacobian.bottomRows<3>());
    if (place) {
      error.tail<3>() = 3.0 * (*place - placement_.translation());
      J.bottomRows<3>() = 3.0 * derivatives_.jacobian.topRows<3>();
    }
    J *= reach_.asDiagonal();
    const Eigen::VectorXd home =
        balance.middle * difference(model_, q, q_middle_).cwiseQuotient(reach_);
    Eigen::VectorXd damp = Eigen::VectorXd::Constant(rows, place_damping * place_damping);
    if (std::isinf(balance.damping)) {
      J.topRows<3>().setZero();
      error.head<3>().setZero();
    } else {
      damp.head<3>().setConstant(balance.damping * balance.damping);
    }
    const Eigen::VectorXd step = home + damped_step(J, damp, error - J * home);
    return step.cwiseProduct(reach_);
  }

  void clamp(Eigen::VectorXd& q) const {
    for (const Joint& joint : model_.joints)
      if (is_limited(model_, joint)) {
        const double lower = model_.q_lower[joint.q_index] + margin_of(joint);
        const double upper = model_.q_upper[joint.q_index] - margin_of(joint);
        q[joint.q_index] =
            lower > upper ? 0.5 * (lower + upper) : std::clamp(q[joint.q_index], lower, upper);
      }
  }

  /// Adds whole turns to joint angles, so that each angle is as near as possible to the middle of
  /// its range, or to zero without limits. Joints that other joints follow are unchanged.
  void unwind(Eigen::VectorXd& q) const {
    constexpr double turn = 2.0 * std::numbers::pi;
    for (const Joint& joint : model_.joints) {
      if (joint.kind != JointKind::Revolute || joint.nq != 1 || moves_others(joint)) continue;
      double& angle = q[joint.q_index];
      const double middle = is_limited(model_, joint) ? q_middle_[joint.q_index] : 0.0;
      const double unwound = angle - turn * std::round((angle - middle) / turn);
      if (unwound >= model_.q_lower[joint.q_index] + options_.joint_margin &&
          unwound <= model_.q_upper[joint.q_index] - options_.joint_margin)
        angle = unwound;
    }
  }
  bool moves_others(const Joint& joint) const {
    return std::any_of(model_.joints.begin(), model_.joints.end(), [&](const Joint& other) {
      return other.follows && other.v_index == joint.v_index;
    });
  }

  /// Returns the required margin to the limits of a joint [rad (m)]: the margin of the options, but
  /// for a prismatic joint at most a quarter of its range.
  double margin_of(const Joint& joint) const {
    if (joint.kind != JointKind::Prismatic) return options_.joint_margin;
    const double range = model_.q_upper[joint.q_index] - model_.q_lower[joint.q_index];
    return std::min(options_.joint_margin, 0.25 * range);
  }

  double smallest_margin(const Eigen::VectorXd& q) const {
    double margin = std::numeric_limits<double>::infinity();
    for (const Joint& joint : model_.joints)
      if (is_limited(model_, joint))
        margin = std::min(margin, options_.joint_margin - margin_of(joint) +
                                      std::min(q[joint.q_index] - model_.q_lower[joint.q_index],
                                               model_.q_upper[joint.q_index] - q[joint.q_index]));
    return margin;
  }

  /// Returns whether `body` is `other` or a descendant of `other`.
  bool hangs_on(int body, int other) const {
    while (body >= 0 && body != other) body = model_.joints[to_size(body)].parent;
    return body == other;
  }

  /// Sets `body` and `body_wanted` of a candidate to the distance and the required distance of the
  /// critical pair. A pair consists of one of three points of the last link, and of a link of the
  /// arm or the origin of another link. The critical pair has the smallest ratio of distance to
  /// required distance.
  void measure_body(Candidate& c) {
    const auto joint = [&](int index) -> const Joint& { return model_.joints[to_size(index)]; };
    const int last = model_.frames[to_size(model_.frame_index(place_.tool))].body;
    c.body = std::numeric_limits<double>::infinity();
    c.body_wanted = options_.body_distance;
    if (last < 0) return;
    const Eigen::Vector3d tool = placement_.translation(), elbow = origin(last);
    double min_ratio = std::numeric_limits<double>::infinity();
    const auto look = [&](double distance, double along) {
      const double wanted =
          std::min(options_.body_distance, options_.body_distance_fraction * along);
      if (!(wanted > 0.0) || distance / wanted >= min_ratio) return;
      min_ratio = distance / wanted;
      c.body = distance;
      c.body_wanted = wanted;
    };
    for (const double fraction : {1.0 / 3.0, 2.0 / 3.0, 1.0}) {
      const Eigen::Vector3d p = elbow + fraction * (tool - elbow);
      // Length along the arm from p to the origin of a joint, towards the base [m].
      double along = (p - elbow).norm();
      std::vector<double> to_joint(model_.joints.size(), -1.0);
      for (int j = last; j >= 0; j = joint(j).parent) {
        to_joint[to_size(j)] = along;
        if (joint(j).parent < 0) break;
        const Eigen::Vector3d a = origin(j), b = origin(joint(j).parent);
        if (j != last) look_along(p, a, b, along, look);
        along += (b - a).norm();
      }
      for (const Frame& frame : model_.frames) {
        if (frame.kind != FrameKind::Link || goes_with_the_tool(frame.body, last)) continue;
        const Eigen::Vector3d at = body_.placement(body_.frame(frame.name)).translation();
        const double to_body =
            frame.body >= 0 && to_joint[to_size(frame.body)] >= 0.0
                ? to_joint[to_size(frame.body)] + (at - origin(frame.body)).norm()
                : std::numeric_limits<double>::infinity();
        look((p - at).norm(), to_body);
      }
    }
  }
  /// Returns whether a body descends from the last link or from its parent, as for example a finger
  /// beside the tool.
  bool goes_with_the_tool(int body, int last) const {
    const int carrier = model_.joints[to_size(last)].parent;
    return body == carrier ||
           (body >= 0 && (hangs_on(body, last) || (carrier >= 0 && hangs_on(body, carrier))));
  }
  Eigen::Vector3d origin(int joint) {
    return body_.placement(body_.frame(model_.joints[to_size(joint)].name)).translation();
  }

  /// Calls look(distance from p, length along the arm from p) for short sections of the straight
  /// arm segment from a to b. `along`: length along the arm from p to a [m].
  template <class Look>
  static void look_along(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                         const Eigen::Vector3d& b, double along, const Look& look) {
    constexpr int pieces = 8;
    const double length = (b - a).norm();
    for (int i = 0; i < pieces; ++i) {
      const double begin = static_cast<double>(i) / pieces, end = begin + 1.0 / pieces;
      look(to_segment(p, a + begin * (b - a), a + end * (b - a)), along + begin * length);
    }
  }
  static double to_segment(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b) {
    const Eigen::Vector3d along = b - a;
    const double length = along.squaredNorm();
    const double fraction = length > 0.0 ? std::clamp(along.dot(p - a) / length, 0.0, 1.0) : 0.0;
    return (p - a - fraction * along).norm();
  }

  /// Returns the largest static torque of all joints, with or without the contact force, as a
  /// fraction of the effort limit.
  double torque_fraction() const {
    const Eigen::Vector3d push = -place_.force * into_;
    const Eigen::VectorXd weight = body_.gravity_torque();
    const Eigen::VectorXd pressing = weight - derivatives_.jacobian.topRows(3).transpose() * push;
    double fraction = 0.0;
    for (int k = 0; k < model_.nv; ++k)
      if (std::isfinite(model_.effort_limit[k]) && model_.effort_limit[k] > 0.0)
        fraction = std::max(fraction, std::max(std::abs(weight[k]), std::abs(pressing[k])) /
                                          model_.effort_limit[k]);
    return fraction;
  }

  Candidate evaluated(const Eigen::VectorXd& q) {
    evaluate(q);
    Candidate c{.q = q};
    const Eigen::Vector3d axis = placement_.linear() * press_;
    c.tilt = std::atan2(axis.cross(into_).norm(), axis.dot(into_));
    c.margin = smallest_margin(q);
    measure_body(c);
    if (const auto place = wanted_position()) c.off = (*place - placement_.translation()).norm();
    // Computes the smallest singular value from a 3 x 3 eigenvalue problem, which compiles faster
    // than a singular value decomposition of dynamic size.
    const auto linear = derivatives_.jacobian.topRows(3);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> squares(linear * linear.transpose(),
                                                                 Eigen::EigenvaluesOnly);
    c.manipulability = std::sqrt(std::max(0.0, squares.eigenvalues()[0]));
    c.torque = torque_fraction();
    return c;
  }

  const PressingPlace& place_;
  const PostureOptions& options_;
  const std::vector<Eigen::VectorXd>& known_;
  const Model& model_;
  RigidBody body_;
  int tool_;
  Eigen::Vector3d into_;   ///< Unit vector into the surface, in the world.
  Eigen::Vector3d press_;  ///< Unit vector of the pressing direction, in the frame of the tool.
  Eigen::VectorXd q_middle_;
  Eigen::VectorXd reach_;  ///< Half the range of each joint, the unit of its steps (nv).
  Eigen::Isometry3d placement_;
  FrameDerivatives derivatives_;
};

/// Returns the score of a candidate, lower is better; see search_posture().
double score_of(const Candidate& c, double torque_fraction, double margin) {
  return c.tilt + torque_fraction + 0.1 / std::max(margin, 1e-6) +
         0.1 / std::max(c.manipulability, 1e-6);
}
double score_at_start(const Candidate& c) { return score_of(c, c.torque, c.margin); }

/// Returns whether two candidates are the same posture. Different starting postures often lead to
/// one posture.
bool same_place(const Model& model, const Candidate& a, const Candidate& b) {
  return std::abs(score_at_start(a) - score_at_start(b)) < 1e-3 &&
         difference(model, a.q, b.q).cwiseAbs().maxCoeff() < 1e-2;
}

/// Searches from all starting postures. Returns the results that meet all conditions, the best one
/// first. If there is none, `why` receives the complaint about the result of smallest shortfall.
std::vector<Candidate> good_candidates(Search& search, const Model& model, std::string& why) {
  std::vector<Candidate> good;
  std::optional<Candidate> nearest;
  for (const Eigen::VectorXd& start : search.starts())
    for (const Balance& balance : balances) {
      Candidate candidate = search.descend(start, balance);
      if (search.complaint(candidate).empty())
        good.push_back(std::move(candidate));
      else if (!nearest || search.shortfall(candidate) < search.shortfall(*nearest))
        nearest = std::move(candidate);
    }
  if (good.empty()) {
    why = search.complaint(*nearest);
    return good;
  }
  std::stable_sort(good.begin(), good.end(), [](const Candidate& a, const Candidate& b) {
    return score_at_start(a) < score_at_start(b);
  });
  const auto twice = std::unique(good.begin(), good.end(), [&](const auto& a, const auto& b) {
    return same_place(model, a, b);
  });
  good.erase(twice, good.end());
  return good;
}

/// Returns the best posture in which the tool presses along `axis`, given in the frame of the tool.
/// If no posture is found, `why` receives the reason.
std::optional<FoundPosture> search_along(const Eigen::Vector3d& axis, const SearchInput& in,
                                         std::string& why) {
  Search search(in, axis);
  const std::vector<Candidate> good = good_candidates(search, in.model, why);
  std::string first_problem;
  std::optional<FoundPosture> best;
  const std::size_t checked = std::min(good.size(), to_size(in.options.checked));
  for (std::size_t i = 0; i < checked; ++i) {
    const Candidate& c = good[i];
    ReachReport reach = in.check_reach(c.q);
    if (!reach.ok()) {
      if (first_problem.empty()) first_problem = reach.text;
      continue;
    }
    const double score = score_of(c, reach.torque_share, reach.joint_margin);
    if (best && best->score <= score) continue;
    best = {c.q, score, c.tilt, std::move(reach), static_cast<int>(good.size())};
  }
  if (!best && checked > 0)
    why = "none of " + std::to_string(checked) +
          " postures that suit the surface's normal permits the path; the best of them fails: " +
          first_problem;
  return best;
}

/// Returns a clause that names the pressing axis of the search and says whether the opposite axis
/// has a posture.
std::string about_axis(const Eigen::Vector3d& axis, const SearchInput& in) {
  const std::string tool = "; the tool " + in_quotes(in.place.tool);
  if (in.place.tool_axis) return tool + " presses along " + axis_text(axis);
  std::string unused;
  return tool + " is assumed to press along " + axis_text(axis) +
         (search_along(-axis, in, unused)
              ? ", and with " + axis_text(-axis) + " a posture is found"
              : ", and with " + axis_text(-axis) + " none is found either");
}

/// Returns looser limits with which the search succeeds, as "; with search.body_distance=0.1 a
/// posture is found"; empty if there are none.
std::string about_looser_limits(const Eigen::Vector3d& axis, const SearchInput& in) {
  struct Looser {
    double body_distance, joint_margin;  ///< Limits [m], [rad].
  };
  // Looser limits, chosen by hand. They helped arms with links about 0.05 m thick.
  for (const Looser& looser : {Looser{0.15, 0.15}, {0.1, 0.15}, {0.1, 0.05}}) {
    PostureOptions options = in.options;
    options.body_distance = std::min(options.body_distance, looser.body_distance);
    options.joint_margin = std::min(options.joint_margin, looser.joint_margin);
    std::string with, unused;
    if (options.body_distance < in.options.body_distance)
      with = "search.body_distance=" + number(options.body_distance);
    if (options.joint_margin < in.options.joint_margin)
      with +=
          (with.empty() ? "" : " and ") + ("search.joint_margin=" + number(options.joint_margin));
    if (!with.empty() &&
        search_along(axis, {in.place, in.model, in.known, options, in.check_reach}, unused))
      return "; with " + with + " a posture is found";
  }
  return "";
}

}  // namespace

FoundPosture search_posture(const PressingPlace& place, const Model& model,
                            const std::vector<Eigen::VectorXd>& known,
                            const PostureOptions& options, const CheckReach& check_reach) {
  const SearchInput in{place, model, known, options, check_reach};
  const Eigen::Vector3d axis = tool_direction(place.tool, place.tool_axis, model).axis;
  std::string why;
  if (auto found = search_along(axis, in, why)) return *std::move(found);
  throw Error("no posture was found for the surface: " + why + about_axis(axis, in) +
              about_looser_limits(axis, in));
}

}  // namespace burnish::pressing

namespace burnish {

Eigen::Vector3d pressing_axis(const Eigen::Isometry3d& tool_placement) {
  return -tool_placement.linear().col(2);
}

}  // namespace burnish
