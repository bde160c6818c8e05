// Plausibility checks. Each threshold lies between values in URDF files of about 80 robots and the
// values that a wrong unit makes of them. Comments beside the thresholds state the values in files.
#include "model/plausibility.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/sentence.hpp"
#include "model/moving_links.hpp"
#include "model/tree_sentence.hpp"

namespace burnish {
namespace {

constexpr double two_turns = 4.0 * std::numbers::pi;  // [rad]

/// Returns true for powers of ten, which stand for "unknown" in many files.
bool is_power_of_ten(double x) {
  const double exponent = std::log10(x);
  return std::abs(exponent - std::round(exponent)) < 1e-9;
}

/// Returns the largest absolute value of a finite position limit, 0 without finite limits.
double largest_limit(const JointSpec& joint) {
  const auto size = [](double limit) { return std::isfinite(limit) ? std::abs(limit) : 0.0; };
  return std::max(size(joint.lower), size(joint.upper));
}

std::string limits_text(const JointSpec& joint) {
  return "position limits " + number(joint.lower) + " and " + number(joint.upper) + " rad";
}

/// Joints with an odd value among the examined joints.
struct Suspects {
  std::vector<const JointSpec*> odd;  ///< Joints with an odd value
  std::size_t seen = 0;               ///< Number of examined joints

  /// Returns true if more than half of the examined joints, and at least `min_count`, are odd.
  bool are_majority(std::size_t min_count = 1) const {
    return odd.size() >= min_count && 2 * odd.size() > seen;
  }
  /// Returns a text such as "line 3: joint 'a' (and 4 of 5 others)".
  std::string text() const {
    const std::string others = seen < 2 ? ""
                                        : " (and " + std::to_string(odd.size() - 1) + " of " +
                                              std::to_string(seen - 1) + " others)";
    return label_of(*odd.front()) + others;
  }
};

/// Examines all revolute joints. `odd` returns whether a joint is odd, or nothing if the joint has
/// no value to examine.
template <class Odd>
Suspects suspects(const TreeSpec& tree, Odd&& odd) {
  Suspects result;
  for (const JointSpec& joint : tree.joints) {
    if (joint.type != JointType::Revolute) continue;
    const std::optional<bool> is_odd = odd(joint);
    if (!is_odd) continue;
    ++result.seen;
    if (*is_odd) result.odd.push_back(&joint);
  }
  return result;
}

// ---- Joints

void check_angles(const TreeSpec& tree, Findings& findings) {
  constexpr double beyond_degrees = 1000.0;  // larger limits stand for "unlimited" [rad]
  const Suspects degrees = suspects(tree, [](const JointSpec& joint) -> std::optional<bool> {
    const double largest = largest_limit(joint);
    return largest > two_turns && largest <= beyond_degrees;
  });
  if (degrees.are_majority())
    findings.warn(degrees.text() + " has " + limits_text(*degrees.odd.front()) +
                  "; limits below two turns were expected. Are the limits in degrees?");
  // Equal limits stand for a joint whose range nobody measured. If a file converts radians as if
  // they were degrees, a range of one turn becomes 2 pi * pi / 180 = 0.11 rad.
  constexpr double narrow = 0.12;  // smallest range that is not suspect [rad]
  const Suspects small = suspects(tree, [](const JointSpec& joint) -> std::optional<bool> {
    if (!std::isfinite(joint.lower) || !std::isfinite(joint.upper)) return std::nullopt;
    return joint.upper > joint.lower && joint.upper - joint.lower < narrow;
  });
  if (small.are_majority(3))
    findings.warn(small.text() + " has " + limits_text(*small.odd.front()) +
                  "; a range of more than " + number(narrow) +
                  " rad was expected. Were radians converted as if they were degrees?");
}

void check_velocities(const TreeSpec& tree, Findings& findings) {
  constexpr double fastest = 60.0;      // largest plausible limit; correct files: up to 52 [rad/s]
  constexpr double unlimited = 5000.0;  // larger values stand for "unlimited" [rad/s]
  const Suspects degrees = suspects(tree, [](const JointSpec& joint) -> std::optional<bool> {
    if (!std::isfinite(joint.velocity_limit)) return std::nullopt;
    return joint.velocity_limit > fastest && joint.velocity_limit < unlimited &&
           !is_power_of_ten(joint.velocity_limit);
  });
  if (degrees.are_majority())
    findings.warn(degrees.text() + " has a velocity limit of " +
                  number(degrees.odd.front()->velocity_limit) + " rad/s; at most " +
                  number(fastest) + " rad/s was expected. Is the limit in degrees per second?");
  for (const JointSpec& joint : tree.joints)
    if (joint.type != JointType::Fixed && joint.velocity_limit == 0.0)
      findings.warn(label_of(joint) +
                    " has a velocity limit of 0, so that it cannot move; a positive limit or a "
                    "locked joint was expected");
}

// ---- Links

/// Principal moments of inertia [kg m^2].
struct Moments {
  double smallest, largest, sum;
};
Moments moments_of(const InertiaSpec& inertia) {
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia.inertia_at_com, Eigen::EigenvaluesOnly)
          .eigenvalues();
  return {principal[0], principal[2], principal.sum()};
}

/// Warns of moving links without mass. check_inertia_along_joints() reports joints that move no
/// mass.
void check_zero_masses(const MovingLinks& robot, Findings& findings) {
  constexpr double negligible = 1e-6;  // moment, divided by the robot's mass * reach^2
  std::vector<std::string> all, hollow;
  bool has_armature = false;
  for (const MovingLink& link : robot.links) {
    all.push_back(link.link->name);
    has_armature = has_armature || (link.joint != nullptr && link.joint->armature > 0.0);
    const Moments moments = moments_of(link.link->inertia);
    if (link.link->inertia.mass == 0.0 && moments.smallest >= 0.0 &&
        moments.largest > negligible * robot.mass * robot.reach * robot.reach)
      hollow.push_back(link.link->name);
  }
  const std::string expected = "; masses in kg were expected";
  if (!hollow.empty())
    findings.warn(listed("link", hollow) + (hollow.size() == 1 ? " has" : " have") +
                  " moments of inertia but no mass" + expected);
  else if (has_armature && robot.mass == 0.0)
    findings.warn("no moving link has a mass: " + listed("link", all) + expected);
}

void check_far_masses(const MovingLinks& robot, Findings& findings) {
  for (const MovingLink& link : robot.links)
    if (robot.is_far_off(link))
      findings.warn(label_of(*link.link) + ": its centre of mass is " +
                    number(link.link->inertia.com.norm()) +
                    " m from its origin, but joints and shapes reach " + number(robot.skeleton) +
                    " m; a centre inside the link was expected. Is the centre in mm?");
}

/// Warns of a radius of gyration above the robot's reach. Correct files have at most 0.85 of the
/// reach. Skips light links.
void check_large_inertias(const MovingLinks& robot, Findings& findings) {
  constexpr double min_mass_fraction = 0.01;  // of the robot's mass
  const MovingLink* worst = nullptr;
  double largest = 0.0;
  std::size_t count = 0;
  for (const MovingLink& link : robot.links) {
    const InertiaSpec& inertia = link.link->inertia;
    if (inertia.mass <= 0.0 || inertia.mass < min_mass_fraction * robot.mass) continue;
    const double radius = std::sqrt(std::max(moments_of(inertia).largest, 0.0) / inertia.mass);
    if (radius <= robot.reach) continue;
    ++count;
    if (radius <= largest) continue;
    worst = &link;
    largest = radius;
  }
  if (worst == nullptr) return;
  const InertiaSpec& inertia = worst->link->inertia;
  findings.warn(
      label_of(*worst->link) + ": a moment of inertia of " + number(moments_of(inertia).largest) +
      " kg m^2 at a mass of " + number(inertia.mass) + " kg gives a radius of gyration of " +
      number(largest) + " m, beyond the robot's reach of " + number(robot.reach) + " m" +
      (count > 1 ? ", as for " + std::to_string(count - 1) + " other links" : "") +
      "; a smaller moment was expected. Is the moment in kg mm^2, or the mass in tonnes?");
}

/// Returns the density of a ball with the link's mass and largest second moment of mass [kg/m^3].
/// No solid with this inertia has a much lower density. Returns 0 for points and links without
/// mass.
double least_density(const InertiaSpec& inertia) {
  const Moments moments = moments_of(inertia);
  const double second = 0.5 * moments.sum - moments.smallest;
  if (inertia.mass <= 0.0 || second <= 0.0) return 0.0;
  const double radius = std::sqrt(5.0 * second / inertia.mass);
  return inertia.mass / (4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3));
}

/// Warns if most links are denser than metal, or if links of absurd density have half of the mass.
/// In correct files most links have at most 2,800 kg/m^3, and some have a placeholder inertia.
void check_small_inertias(const MovingLinks& robot, Findings& findings) {
  constexpr double densest = 2e5;  // osmium has 22,600, which compact links can exceed [kg/m^3]
  constexpr double absurd = 5e8;   // placeholder inertias in correct files give 5e7 [kg/m^3]
  constexpr std::size_t min_count = 2;  // a single link may have a placeholder
  const LinkSpec* worst = nullptr;
  std::size_t seen = 0, dense = 0;
  double absurd_mass = 0.0;
  for (const MovingLink& link : robot.links) {
    const double density = least_density(link.link->inertia);
    if (density <= 0.0) continue;
    ++seen;
    if (density <= densest) continue;
    ++dense;
    if (density > absurd) absurd_mass += link.link->inertia.mass;
    if (worst == nullptr || link.link->inertia.mass > worst->inertia.mass) worst = link.link;
  }
  const bool are_majority = dense >= min_count && 2 * dense > seen;
  if (worst == nullptr || (!are_majority && 2.0 * absurd_mass <= robot.mass)) return;
  findings.warn(label_of(*worst) + ": moments of inertia up to " +
                number(moments_of(worst->inertia).largest) + " kg m^2 at a mass of " +
                number(worst->inertia.mass) + " kg correspond to a ball with a density of " +
                number(least_density(worst->inertia)) +
                " kg/m^3; at most the density of a metal was expected. Is the mass in g, or the "
                "inertia too small?");
}

/// Warns if mass / reach^3 is implausible. Correct files have 2.3 to 117 kg/m^3.
void check_size(const MovingLinks& robot, Findings& findings) {
  constexpr double thinnest = 0.05, densest = 1e4;  // [kg/m^3]
  const double density = robot.mass / std::pow(robot.reach, 3);
  if (density >= thinnest && density <= densest) return;
  findings.warn("the links weigh " + number(robot.mass) + " kg and reach " + number(robot.reach) +
                " m: mass over reach cubed is " + number(density) + " kg/m^3; " + number(thinnest) +
                " to " + number(densest) + " was expected. Are " +
                (density < thinnest ? "lengths in mm, or masses in tonnes?" : "masses in g?"));
}

/// Warns of light links with the shape and the inertia of a heavy link.
void check_light_links(const MovingLinks& robot, Findings& findings) {
  // Mass fraction below which a link is light; check_large_inertias() examines heavier links.
  constexpr double max_mass_fraction = 0.01;
  // Smallest relevant moment of inertia, relative to the robot's mass * reach^2; chosen by hand.
  constexpr double min_inertia = 1e-4;
  constexpr double lightest = 20.0;  // mass per volume of the shapes, as low as foam [kg/m^3]
  for (const MovingLink& link : robot.links) {
    const InertiaSpec& inertia = link.link->inertia;
    const double largest = moments_of(inertia).largest;
    if (inertia.mass <= 0.0 || inertia.mass >= max_mass_fraction * robot.mass ||
        largest < min_inertia * robot.mass * robot.reach * robot.reach ||
        largest <= inertia.mass * robot.reach * robot.reach ||
        inertia.mass >= lightest * link.volume)
      continue;
    findings.warn(label_of(*link.link) + ": its mass is " + number(inertia.mass) +
                  " kg, but its shapes have a volume of " + number(1e3 * link.volume) +
                  " litres and its moments of inertia are up to " + number(largest) +
                  " kg m^2; a larger mass was expected. Is the mass in tonnes?");
  }
}

// ---- Drives

/// Returns the torque of the weight beyond a joint, with the robot's reach as lever arm [N m].
double weight_torque(const MovingLinks& robot, const MovingLink& link, double gravity) {
  return gravity * link.mass_beyond * robot.reach;
}

/// Joints with too large and with too small effort limits, and the number of examined joints.
struct Efforts {
  std::vector<const JointSpec*> large, small;
  std::size_t seen = 0;
};

void check_efforts(const MovingLinks& robot, const ModelOptions& options, Findings& findings) {
  // The largest effort limit in a correct file is 0.01 to 20 times the robot's weight * reach.
  // Powers of ten, which often mean "unknown", are exempt.
  constexpr double strongest = 50.0, weakest = 0.003;
  // One joint in four suffices for a warning, because most joints can belong to weak fingers.
  constexpr std::size_t joints_per_strong = 4;
  const double gravity = options.gravity.norm();
  const double whole = gravity * robot.mass * robot.reach;
  Efforts efforts;
  for (const MovingLink& link : robot.links) {
    const JointSpec* joint = link.joint;
    if (joint == nullptr || joint->type != JointType::Revolute || joint->mimic) continue;
    const double effort = joint->effort_limit;
    if (!(effort > 0.0) || !std::isfinite(effort)) continue;
    ++efforts.seen;
    if (effort > strongest * whole && !is_power_of_ten(effort)) efforts.large.push_back(joint);
    if (effort < weakest * weight_torque(robot, link, gravity)) efforts.small.push_back(joint);
  }
  if (whole <= 0.0 || efforts.seen < 3) return;
  const Suspects large{efforts.large, efforts.seen}, small{efforts.small, efforts.seen};
  if (joints_per_strong * large.odd.size() >= large.seen)
    findings.warn(large.text() + " has an effort limit of " +
                  number(large.odd.front()->effort_limit) +
                  " Nm; the robot's weight at its reach requires " + number(whole) +
                  " Nm. Is the limit in Nmm?");
  if (small.are_majority())
    findings.warn(small.text() + " has an effort limit of " +
                  number(small.odd.front()->effort_limit) +
                  " Nm, too little for the weight that it carries. Is the limit in kNm?");
}

void check_armatures(const MovingLinks& robot, Findings& findings) {
  constexpr double largest = 10.0;  // armature / (robot's inertia or mass); chosen by hand
  for (const MovingLink& link : robot.links) {
    const JointSpec* joint = link.joint;
    if (joint == nullptr || joint->armature <= 0.0) continue;
    const bool slides = joint->type == JointType::Prismatic;
    const double scale = slides ? robot.mass : robot.mass * robot.reach * robot.reach;
    if (scale <= 0.0 || joint->armature <= largest * scale) continue;
    findings.warn(label_of(*joint) + " has an armature of " + number(joint->armature) +
                  (slides ? " kg" : " kg m^2") + ", but " +
                  (slides ? "the whole robot weighs " : "the inertia of the stretched robot is ") +
                  number(scale) + (slides ? " kg" : " kg m^2") +
                  "; a smaller armature was expected. Is the armature in kg cm^2?");
  }
}

void check_slides(const MovingLinks& robot, Findings& findings) {
  // Largest plausible position limit, relative to the robot's reach; chosen by hand. Joints that
  // carry more than half of the robot are skipped, because they may be rails.
  constexpr double max_travel = 20.0;
  for (const MovingLink& link : robot.links) {
    const JointSpec* joint = link.joint;
    if (joint == nullptr || joint->type != JointType::Prismatic ||
        2.0 * link.mass_beyond > robot.mass)
      continue;
    const double travel = largest_limit(*joint);
    if (travel <= max_travel * robot.reach || is_power_of_ten(travel)) continue;
    findings.warn(label_of(*joint) + " has position limits " + number(joint->lower) + " and " +
                  number(joint->upper) + " m, but the robot reaches " + number(robot.reach) +
                  " m. Are the limits in mm?");
  }
}

void check_gravity(const ModelOptions& options, Findings& findings) {
  constexpr double strongest = 30.0, weakest = 0.1;  // Jupiter has 25, Pluto 0.6 [m/s^2]
  const double gravity = options.gravity.norm();
  if (gravity == 0.0 || (gravity >= weakest && gravity <= strongest)) return;
  findings.warn("gravity is " + number(gravity) + " m/s^2; zero or " + number(weakest) + " to " +
                number(strongest) + " m/s^2 was expected (9.81 on Earth)");
}

}  // namespace

void check_plausibility(const TreeSpec& tree, const ModelOptions& options, Findings& findings) {
  check_angles(tree, findings);
  check_velocities(tree, findings);
  check_gravity(options, findings);
  const MovingLinks robot = moving_links(tree, options);
  check_zero_masses(robot, findings);
  if (robot.mass <= 0.0) return;
  check_small_inertias(robot, findings);
  check_efforts(robot, options, findings);
  // A single body, or bodies with coinciding origins, have no reach for a comparison.
  if (robot.joints_in_a_subtree < 2 || robot.reach <= 0.0) return;
  check_far_masses(robot, findings);
  check_large_inertias(robot, findings);
  check_light_links(robot, findings);
  check_armatures(robot, findings);
  check_slides(robot, findings);
  // Robots with fewer joints, such as a pendulum or a mass on slides, may have any size.
  constexpr int min_count = 3;  // of joints, and of links with a mass
  const auto massive = std::count_if(robot.links.begin(), robot.links.end(), [](const auto& link) {
    return link.link->inertia.mass > 0.0;
  });
  if (robot.joints_in_a_subtree >= min_count && massive >= min_count) check_size(robot, findings);
}

}  // namespace burnish
