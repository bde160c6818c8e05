// Thresholds lie between what the URDF files of about 80 robots hold, named beside each, and what a
// wrong unit makes of such figures.
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

constexpr double two_turns = 4.0 * std::numbers::pi;  // rad

/// Whether a figure is one that stands for "unknown" in many files: 1, 10, 100, 1000, ...
bool is_power_of_ten(double x) {
  const double exponent = std::log10(x);
  return std::abs(exponent - std::round(exponent)) < 1e-9;
}

/// The largest finite position limit in size; 0 where there is none.
double largest_limit(const JointSpec& joint) {
  const auto size = [](double limit) { return std::isfinite(limit) ? std::abs(limit) : 0.0; };
  return std::max(size(joint.lower), size(joint.upper));
}

std::string limits_text(const JointSpec& joint) {
  return "limits of position " + number(joint.lower) + " and " + number(joint.upper) + " rad";
}

/// What is odd about one joint is odd about more than half of those that were looked at.
struct Suspects {
  std::vector<const JointSpec*> odd;
  std::size_t seen = 0;

  bool are_most(std::size_t fewest = 1) const {
    return odd.size() >= fewest && 2 * odd.size() > seen;
  }
  /// "line 3: joint 'a' (and 4 of 5 others)"
  std::string text() const {
    const std::string others = seen < 2 ? ""
                                        : " (and " + std::to_string(odd.size() - 1) + " of " +
                                              std::to_string(seen - 1) + " others)";
    return label_of(*odd.front()) + others;
  }
};

template <class Odd>
Suspects suspects(const TreeSpec& tree, Odd&& odd) {
  Suspects result;
  for (const JointSpec& joint : tree.joints) {
    if (joint.type != JointType::Revolute) continue;
    const std::optional<bool> is_odd = odd(joint);
    if (!is_odd) continue;  // says nothing about it
    ++result.seen;
    if (*is_odd) result.odd.push_back(&joint);
  }
  return result;
}

// ---- Joints

void check_angles(const TreeSpec& tree, Findings& findings) {
  constexpr double beyond_degrees = 1000.0;  // rad; a figure for "unlimited"
  const Suspects degrees = suspects(tree, [](const JointSpec& joint) -> std::optional<bool> {
    const double largest = largest_limit(joint);
    return largest > two_turns && largest <= beyond_degrees;
  });
  if (degrees.are_most())
    findings.warn(degrees.text() + " has " + limits_text(*degrees.odd.front()) +
                  "; a joint that turns less than twice was expected. Are they in degrees?");
  // Both limits at one angle stand for a joint that nobody measured.
  constexpr double narrow = 0.12;  // rad; 2 pi in degrees that are read as rad are 0.11
  const Suspects small = suspects(tree, [](const JointSpec& joint) -> std::optional<bool> {
    if (!std::isfinite(joint.lower) || !std::isfinite(joint.upper)) return std::nullopt;
    return joint.upper > joint.lower && joint.upper - joint.lower < narrow;
  });
  if (small.are_most(3))
    findings.warn(small.text() + " has " + limits_text(*small.odd.front()) + "; more room than " +
                  number(narrow) + " rad was expected. Are rad read as degrees?");
}

void check_velocities(const TreeSpec& tree, Findings& findings) {
  constexpr double fastest = 60.0;    // rad/s; 52 among the good ones
  constexpr double slowest = 5000.0;  // rad/s; 90 in degrees
  const Suspects degrees = suspects(tree, [](const JointSpec& joint) -> std::optional<bool> {
    if (!std::isfinite(joint.velocity_limit)) return std::nullopt;
    return joint.velocity_limit > fastest && joint.velocity_limit < slowest &&
           !is_power_of_ten(joint.velocity_limit);
  });
  if (degrees.are_most())
    findings.warn(degrees.text() + " has a velocity limit of " +
                  number(degrees.odd.front()->velocity_limit) + " rad/s; at most " +
                  number(fastest) + " rad/s was expected. Is it in degrees per second?");
  for (const JointSpec& joint : tree.joints)
    if (joint.type != JointType::Fixed && joint.velocity_limit == 0.0)
      findings.warn(label_of(joint) +
                    " has a velocity limit of 0, so that it cannot move; a positive one was "
                    "expected, or that it is locked");
}

// ---- Links

struct Moments {
  double smallest, largest, sum;
};
Moments moments_of(const InertiaSpec& inertia) {
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia.inertia_at_com, Eigen::EigenvaluesOnly)
          .eigenvalues();
  return {principal[0], principal[2], principal.sum()};
}

/// Links of which no joint moves any mass are named by check_inertia_along_joints.
void check_zero_masses(const MovingLinks& robot, Findings& findings) {
  constexpr double negligible = 1e-6;  // beside that of the whole robot
  std::vector<std::string> all, hollow;
  bool any_armature = false;
  for (const MovingLink& link : robot.links) {
    all.push_back(link.link->name);
    any_armature = any_armature || (link.joint != nullptr && link.joint->armature > 0.0);
    const Moments moments = moments_of(link.link->inertia);
    if (link.link->inertia.mass == 0.0 && moments.smallest >= 0.0 &&
        moments.largest > negligible * robot.mass * robot.reach * robot.reach)
      hollow.push_back(link.link->name);
  }
  const std::string expected = "; masses in kg were expected";
  if (!hollow.empty())
    findings.warn(listed("link", hollow) + (hollow.size() == 1 ? " has" : " have") +
                  " moments of inertia but no mass, as no solid has" + expected);
  else if (any_armature && robot.mass == 0.0)
    findings.warn("nothing that moves has a mass: " + listed("link", all) + expected);
}

void check_far_masses(const MovingLinks& robot, Findings& findings) {
  for (const MovingLink& link : robot.links)
    if (robot.is_far_off(link))
      findings.warn(label_of(*link.link) + ": its centre of mass is " +
                    number(link.link->inertia.com.norm()) +
                    " m from its origin, but joints and shapes reach " + number(robot.skeleton) +
                    " m; a centre inside the link was expected. Is it in mm?");
}

/// Radii of gyration of links that count: at most 0.85 of the reach among the good ones.
void check_large_inertias(const MovingLinks& robot, Findings& findings) {
  constexpr double least_share = 0.01;  // of the robot's mass
  const MovingLink* worst = nullptr;
  double largest = 0.0;
  std::size_t count = 0;
  for (const MovingLink& link : robot.links) {
    const InertiaSpec& inertia = link.link->inertia;
    if (inertia.mass <= 0.0 || inertia.mass < least_share * robot.mass) continue;
    const double radius = std::sqrt(std::max(moments_of(inertia).largest, 0.0) / inertia.mass);
    if (radius <= robot.reach) continue;
    ++count;
    if (radius <= largest) continue;
    worst = &link;
    largest = radius;
  }
  if (worst == nullptr) return;
  const InertiaSpec& inertia = worst->link->inertia;
  findings.warn(label_of(*worst->link) + ": a moment of inertia of " +
                number(moments_of(inertia).largest) + " kg m^2 at a mass of " +
                number(inertia.mass) + " kg is a radius of gyration of " + number(largest) +
                " m, beyond the robot's reach of " + number(robot.reach) + " m" +
                (count > 1 ? ", as of " + std::to_string(count - 1) + " other links" : "") +
                "; a smaller one was expected. Is it in kg mm^2, or the mass in t?");
}

/// Density of a ball with the largest second moment of the link, which no solid of its inertia
/// undercuts by much; 0 of points and of links without a mass.
double least_density(const InertiaSpec& inertia) {
  const Moments moments = moments_of(inertia);
  const double second = 0.5 * moments.sum - moments.smallest;
  if (inertia.mass <= 0.0 || second <= 0.0) return 0.0;
  const double radius = std::sqrt(5.0 * second / inertia.mass);
  return inertia.mass / (4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3));
}

/// Links that are denser than metal: most of them, or very much so where they weigh half of all.
/// Among the good ones most links have 2,800 kg/m^3 at most, and some a stand-in for an inertia.
void check_small_inertias(const MovingLinks& robot, Findings& findings) {
  constexpr double densest = 2e5;    // kg/m^3; osmium has 22,600, a part of a link weighs more
  constexpr double absurd = 5e8;     // kg/m^3; bases of good robots with a stand-in have 5e7
  constexpr std::size_t fewest = 2;  // links; a single one may have a stand-in
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
  const bool are_most = dense >= fewest && 2 * dense > seen;
  if (worst == nullptr || (!are_most && 2.0 * absurd_mass <= robot.mass)) return;
  findings.warn(label_of(*worst) + ": moments of inertia up to " +
                number(moments_of(worst->inertia).largest) + " kg m^2 at a mass of " +
                number(worst->inertia.mass) + " kg are those of a ball of " +
                number(least_density(worst->inertia)) +
                " kg/m^3; at most that of a metal was expected. Is the mass in g, or the inertia "
                "too small?");
}

/// Mass over reach cubed: 2.3 to 117 kg/m^3 among the good ones.
void check_size(const MovingLinks& robot, Findings& findings) {
  constexpr double thinnest = 0.05, densest = 1e4;  // kg/m^3
  const double density = robot.mass / std::pow(robot.reach, 3);
  if (density >= thinnest && density <= densest) return;
  findings.warn("links of " + number(robot.mass) + " kg reach " + number(robot.reach) + " m, " +
                number(density) + " kg/m^3 of reach cubed; " + number(thinnest) + " to " +
                number(densest) + " was expected. Are " +
                (density < thinnest ? "lengths in mm, or masses in t?" : "masses in g?"));
}

/// A light link that has the shape and the inertia of a heavy one.
void check_light_links(const MovingLinks& robot, Findings& findings) {
  constexpr double largest_share = 0.01;  // of the robot's mass; heavier ones are judged above
  constexpr double least_inertia =
      1e-4;                          // beside robot.mass robot.reach^2; below it changes little
  constexpr double lightest = 20.0;  // kg/m^3 of the shapes; foam has as much
  for (const MovingLink& link : robot.links) {
    const InertiaSpec& inertia = link.link->inertia;
    const double largest = moments_of(inertia).largest;
    if (inertia.mass <= 0.0 || inertia.mass >= largest_share * robot.mass ||
        largest < least_inertia * robot.mass * robot.reach * robot.reach ||
        largest <= inertia.mass * robot.reach * robot.reach ||
        inertia.mass >= lightest * link.volume)
      continue;
    findings.warn(label_of(*link.link) + ": its mass is " + number(inertia.mass) +
                  " kg, with shapes of " + number(1e3 * link.volume) +
                  " l and moments of inertia up to " + number(largest) +
                  " kg m^2; a heavier one was expected. Is it in t?");
  }
}

// ---- Drives

/// Torque that the weight of all beyond the joint has at the robot's reach [Nm].
double weight_torque(const MovingLinks& robot, const MovingLink& link, double gravity) {
  return gravity * link.mass_beyond * robot.reach;
}

struct Efforts {
  std::vector<const JointSpec*> large, small;
  std::size_t seen = 0;
};

void check_efforts(const MovingLinks& robot, const ModelOptions& options, Findings& findings) {
  // Largest efforts of good robots: 0.01 to 20 times the torque of their whole weight, figures such
  // as 10, 100 and 1000 left out.
  constexpr double strongest = 50.0, weakest = 0.003;
  constexpr std::size_t share_of_strong = 4;  // one in four: legs beside hands
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
  if (share_of_strong * large.odd.size() >= large.seen)
    findings.warn(
        large.text() + " has an effort limit of " + number(large.odd.front()->effort_limit) +
        " Nm; the robot's weight at its reach takes " + number(whole) + " Nm. Is it in Nmm?");
  if (small.are_most())
    findings.warn(small.text() + " has an effort limit of " +
                  number(small.odd.front()->effort_limit) +
                  " Nm, too little for the weight that it carries. Is it in kNm?");
}

void check_armatures(const MovingLinks& robot, Findings& findings) {
  constexpr double largest = 10.0;  // beside robot.mass robot.reach^2, or robot.mass
  for (const MovingLink& link : robot.links) {
    const JointSpec* joint = link.joint;
    if (joint == nullptr || joint->armature <= 0.0) continue;
    const bool slides = joint->type == JointType::Prismatic;
    const double scale = slides ? robot.mass : robot.mass * robot.reach * robot.reach;
    if (scale <= 0.0 || joint->armature <= largest * scale) continue;
    findings.warn(label_of(*joint) + " has an armature of " + number(joint->armature) +
                  (slides ? " kg" : " kg m^2") + ", but the whole robot " +
                  (slides ? "weighs " : "stretched out has ") + number(scale) +
                  (slides ? " kg" : " kg m^2") + "; less was expected. Is it in kg cm^2?");
  }
}

void check_slides(const MovingLinks& robot, Findings& findings) {
  constexpr double longest = 20.0;  // reaches; what carries half of the robot may be a rail
  for (const MovingLink& link : robot.links) {
    const JointSpec* joint = link.joint;
    if (joint == nullptr || joint->type != JointType::Prismatic ||
        2.0 * link.mass_beyond > robot.mass)
      continue;
    const double travel = largest_limit(*joint);
    if (travel <= longest * robot.reach || is_power_of_ten(travel)) continue;
    findings.warn(label_of(*joint) + " has limits of position " + number(joint->lower) + " and " +
                  number(joint->upper) + " m, but the robot reaches " + number(robot.reach) +
                  " m. Are they in mm?");
  }
}

void check_gravity(const ModelOptions& options, Findings& findings) {
  constexpr double strongest = 30.0, weakest = 0.1;  // m/s^2; Jupiter has 25, Pluto 0.6
  const double gravity = options.gravity.norm();
  if (gravity == 0.0 || (gravity >= weakest && gravity <= strongest)) return;
  findings.warn("gravity is " + number(gravity) +
                " m/s^2; 9.81 was expected, that of another planet, or zero");
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
  // A body alone, or bodies on top of each other, have no size to compare with.
  if (robot.joints_in_a_part < 2 || robot.reach <= 0.0) return;
  check_far_masses(robot, findings);
  check_large_inertias(robot, findings);
  check_light_links(robot, findings);
  check_armatures(robot, findings);
  check_slides(robot, findings);
  // A pendulum or a mass on slides may be as small as it likes.
  constexpr int fewest = 3;  // joints, and links with a mass
  const auto massive = std::count_if(robot.links.begin(), robot.links.end(), [](const auto& link) {
    return link.link->inertia.mass > 0.0;
  });
  if (robot.joints_in_a_part >= fewest && massive >= fewest) check_size(robot, findings);
}

}  // namespace burnish
