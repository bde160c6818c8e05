#include "burnish/model/state.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "model/joint_entries.hpp"

namespace burnish {
namespace {

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using ConstVector = Eigen::Ref<const Eigen::VectorXd>;

/// Tolerance on the unit length of quaternions and (cos, sin) pairs; chosen by hand.
constexpr double unit_tolerance = 1e-6;

void check_size(Eigen::Index size, int wanted, std::string_view argument) {
  if (size == wanted) return;
  throw Error("argument " + in_quotes(argument) + " has " + std::to_string(size) +
              " entries; wanted " + std::to_string(wanted));
}

/// Terms (1 - cos t) / t^2 and (t - sin t) / t^3 of the exponential map at angle t; smooth at 0.
struct ExpTerms {
  double first, second;
};
ExpTerms exp_terms(double angle) {
  const double square = angle * angle;
  if (square < 1e-4) {
    return {0.5 - square / 24.0 * (1.0 - square / 30.0),
            1.0 / 6.0 - square / 120.0 * (1.0 - square / 42.0)};
  }
  const double half = std::sin(0.5 * angle);
  return {2.0 * half * half / square, (angle - std::sin(angle)) / (square * angle)};
}

/// Returns the term (1 - (t / 2) / tan(t / 2)) / t^2 of the logarithm, smooth at zero, for
/// |t| <= pi.
double log_term(double angle) {
  const double square = angle * angle;
  if (square < 1e-4) return 1.0 / 12.0 + square / 720.0 * (1.0 + square / 42.0);
  const double half = 0.5 * angle;
  return (1.0 - half * std::cos(half) / std::sin(half)) / square;
}

Eigen::Quaterniond quaternion_exp(const Vector3& w) {
  const double half = 0.5 * w.norm();
  const double scale = half < 1e-4 ? 0.5 * (1.0 - half * half / 6.0) : 0.5 * std::sin(half) / half;
  Eigen::Quaterniond result;
  result.vec() = scale * w;
  result.w() = std::cos(half);
  return result;
}

/// Returns the rotation vector, of length at most pi.
Vector3 quaternion_log(const Eigen::Quaterniond& rotation) {
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
  const double sine = rotation.vec().norm();
  if (sine < 1e-12) return 2.0 * sign * rotation.vec();
  return 2.0 * std::atan2(sine, sign * rotation.w()) / sine * sign * rotation.vec();
}

Vector2 rotated(const Vector2& pair, const Vector2& x) {
  return {pair[0] * x[0] - pair[1] * x[1], pair[1] * x[0] + pair[0] * x[1]};
}
Vector2 pair_of(double angle) { return {std::cos(angle), std::sin(angle)}; }
double angle_between(const Vector2& from, const Vector2& to) {
  return std::atan2(from[0] * to[1] - from[1] * to[0], from.dot(to));
}

/// Returns the displacement by the constant twist (v, w) during unit time, in the initial axes.
Vector3 exp_position(const Vector3& v, const Vector3& w) {
  const ExpTerms terms = exp_terms(w.norm());
  const Vector3 turned = w.cross(v);
  return v + terms.first * turned + terms.second * w.cross(turned);
}
Vector3 log_position(const Vector3& p, const Vector3& w) {
  const Vector3 turned = w.cross(p);
  return p - 0.5 * turned + log_term(w.norm()) * w.cross(turned);
}

template <class Entries, class Twist>
void integrate_joint(JointKind kind, Entries q, const Twist& dq) {
  switch (kind) {
    case JointKind::Revolute:
    case JointKind::Prismatic:
      q[0] += dq[0];
      break;
    case JointKind::Continuous:
      q.template head<2>() = rotated(q.template head<2>(), pair_of(dq[0])).normalized();
      break;
    case JointKind::Planar: {
      const Vector2 pair = q.template tail<2>();
      const Vector3 moved = exp_position({dq[0], dq[1], 0.0}, {0.0, 0.0, dq[2]});
      q.template head<2>() += rotated(pair, moved.head<2>());
      q.template tail<2>() = rotated(pair, pair_of(dq[2])).normalized();
      break;
    }
    case JointKind::FreeFlyer: {
      const Eigen::Quaterniond rotation(Eigen::Vector4d(q.template tail<4>()));
      const Vector3 v = dq.template head<3>(), w = dq.template tail<3>();
      q.template head<3>() += rotation * exp_position(v, w);
      q.template tail<4>() = (rotation * quaternion_exp(w)).normalized().coeffs();
      break;
    }
    case JointKind::Ball: {
      const Eigen::Quaterniond rotation(Eigen::Vector4d(q.template head<4>()));
      const Vector3 w = dq.template head<3>();
      q.template head<4>() = (rotation * quaternion_exp(w)).normalized().coeffs();
      break;
    }
  }
}

template <class Entries, class Twist>
void difference_joint(JointKind kind, const Entries& q0, const Entries& q1, Twist dq) {
  switch (kind) {
    case JointKind::Revolute:
    case JointKind::Prismatic:
      dq[0] = q1[0] - q0[0];
      break;
    case JointKind::Continuous:
      dq[0] = angle_between(q0.template head<2>(), q1.template head<2>());
      break;
    case JointKind::Planar: {
      const Vector2 pair = q0.template tail<2>();
      const double angle = angle_between(pair, q1.template tail<2>());
      const Vector2 displacement = q1.template head<2>() - q0.template head<2>();
      const Vector2 inverse(pair[0], -pair[1]);
      Vector3 moved = Vector3::Zero();
      moved.head<2>() = rotated(inverse, displacement);
      dq.template head<2>() = log_position(moved, {0.0, 0.0, angle}).head<2>();
      dq[2] = angle;
      break;
    }
    case JointKind::FreeFlyer: {
      const Eigen::Quaterniond from(Eigen::Vector4d(q0.template tail<4>()));
      const Eigen::Quaterniond to(Eigen::Vector4d(q1.template tail<4>()));
      const Vector3 w = quaternion_log(from.conjugate() * to);
      const Vector3 displacement = q1.template head<3>() - q0.template head<3>();
      dq.template head<3>() = log_position(from.conjugate() * displacement, w);
      dq.template tail<3>() = w;
      break;
    }
    case JointKind::Ball: {
      const Eigen::Quaterniond from(Eigen::Vector4d(q0.template head<4>()));
      const Eigen::Quaterniond to(Eigen::Vector4d(q1.template head<4>()));
      dq.template head<3>() = quaternion_log(from.conjugate() * to);
      break;
    }
  }
}

/// Returns d(quaternion * exp(w)) / dw at w = 0, with the quaternion as x, y, z, w.
Eigen::Matrix<double, 4, 3> quaternion_tangent(const Eigen::Vector4d& q) {
  Eigen::Matrix<double, 4, 3> result;
  result << q[3], -q[2], q[1], q[2], q[3], -q[0], -q[1], q[0], q[3], -q[0], -q[1], -q[2];
  return 0.5 * result;
}

Eigen::Matrix2d pair_rotation(const Vector2& pair) {
  Eigen::Matrix2d result;
  result << pair[0], -pair[1], pair[1], pair[0];
  return result;
}

template <class Entries, class Block>
void tangent_joint(JointKind kind, const Entries& q, Block map) {
  switch (kind) {
    case JointKind::Revolute:
    case JointKind::Prismatic:
      map(0, 0) = 1.0;
      break;
    case JointKind::Continuous:
      map.template topLeftCorner<2, 1>() = pair_rotation(q.template head<2>()).col(1);
      break;
    case JointKind::Planar: {
      const Eigen::Matrix2d rotation = pair_rotation(q.template tail<2>());
      map.template topLeftCorner<2, 2>() = rotation;
      map.template block<2, 1>(2, 2) = rotation.col(1);
      break;
    }
    case JointKind::FreeFlyer: {
      const Eigen::Vector4d rotation = q.template tail<4>();
      map.template topLeftCorner<3, 3>() = Eigen::Quaterniond(rotation).toRotationMatrix();
      map.template bottomRightCorner<4, 3>() = quaternion_tangent(rotation);
      break;
    }
    case JointKind::Ball:
      map.template topLeftCorner<4, 3>() = quaternion_tangent(q.template head<4>());
      break;
  }
}

/// Returns the first entry in q of the joint's unit vector, and its size (0 for none).
std::pair<int, int> rotation_entries(const Joint& joint) {
  const int size = joint.follows ? 0 : unit_entries(joint.kind);
  return {joint.q_index + joint.nq - size, size};
}

/// Returns a uniform number in [0, 1). Results do not depend on the standard library.
double uniform(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11) * 0x1.0p-53;
}

double random_coordinate(double lower, double upper, double reach, std::mt19937_64& generator) {
  // Limits beyond `furthest` count as infinite, since huge angles have large rounding errors.
  constexpr double furthest = 1e4;  // chosen by hand [rad, m]
  if (lower < -furthest) lower = -std::numeric_limits<double>::infinity();
  if (upper > furthest) upper = std::numeric_limits<double>::infinity();
  if (std::isinf(lower) && std::isinf(upper)) {
    lower = -reach;
    upper = reach;
  } else if (std::isinf(lower)) {
    lower = upper - 2.0 * reach;
  } else if (std::isinf(upper)) {
    upper = lower + 2.0 * reach;
  }
  return lower + (upper - lower) * uniform(generator);
}

/// Returns a uniformly distributed rotation (K. Shoemake, Uniform random rotations, 1992).
Eigen::Vector4d random_quaternion(std::mt19937_64& generator) {
  const double split = uniform(generator);
  const double a = 2.0 * std::numbers::pi * uniform(generator);
  const double b = 2.0 * std::numbers::pi * uniform(generator);
  const double s = std::sqrt(1.0 - split), c = std::sqrt(split);
  return {s * std::sin(a), s * std::cos(a), c * std::sin(b), c * std::cos(b)};
}

void check_finite(const ConstVector& values, std::string_view argument) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    throw Error("argument " + in_quotes(argument) + ": entry " + std::to_string(i) + " is " +
                number(values[i]) + "; wanted a finite number");
  }
}

}  // namespace

Eigen::VectorXd integrate(const Model& model, const ConstVector& q, const ConstVector& dq) {
  check_size(q.size(), model.nq, "q");
  check_size(dq.size(), model.nv, "dq");
  Eigen::VectorXd result = q;
  for (const Joint& joint : model.joints) {
    if (joint.follows) continue;
    integrate_joint(joint.kind, result.segment(joint.q_index, joint.nq),
                    dq.segment(joint.v_index, joint.nv));
  }
  return result;
}

Eigen::VectorXd difference(const Model& model, const ConstVector& q0, const ConstVector& q1) {
  check_size(q0.size(), model.nq, "q0");
  check_size(q1.size(), model.nq, "q1");
  Eigen::VectorXd dq(model.nv);
  for (const Joint& joint : model.joints) {
    if (joint.follows) continue;
    difference_joint(joint.kind, q0.segment(joint.q_index, joint.nq),
                     q1.segment(joint.q_index, joint.nq), dq.segment(joint.v_index, joint.nv));
  }
  return dq;
}

Eigen::MatrixXd tangent_map(const Model& model, const ConstVector& q) {
  check_size(q.size(), model.nq, "q");
  Eigen::MatrixXd map = Eigen::MatrixXd::Zero(model.nq, model.nv);
  for (const Joint& joint : model.joints) {
    if (joint.follows) continue;
    tangent_joint(joint.kind, q.segment(joint.q_index, joint.nq),
                  map.block(joint.q_index, joint.v_index, joint.nq, joint.nv));
  }
  return map;
}

Eigen::VectorXd normalized(const Model& model, const ConstVector& q) {
  check_size(q.size(), model.nq, "q");
  Eigen::VectorXd result = q;
  for (const Joint& joint : model.joints) {
    const auto [first, size] = rotation_entries(joint);
    if (size == 0) continue;
    const double length = result.segment(first, size).norm();
    if (!(length > 1e-12) || !std::isfinite(length)) {
      throw Error("argument 'q': the rotation of joint " + in_quotes(joint.name) + " has length " +
                  number(length) + "; wanted a finite length above 1e-12");
    }
    result.segment(first, size) /= length;
  }
  return result;
}

Eigen::VectorXd random_configuration(const Model& model, std::mt19937_64& generator) {
  Eigen::VectorXd q(model.nq);
  for (const Joint& joint : model.joints) {
    if (joint.follows) continue;
    auto entries = q.segment(joint.q_index, joint.nq);
    if (joint.kind == JointKind::Continuous) {
      entries.head<2>() = pair_of(2.0 * std::numbers::pi * uniform(generator));
      continue;
    }
    const double reach = joint.kind == JointKind::Revolute ? std::numbers::pi : 1.0;
    const int plain = joint.nq - unit_entries(joint.kind);
    for (int i = 0; i < plain; ++i) {
      entries[i] = random_coordinate(model.q_lower[joint.q_index + i],
                                     model.q_upper[joint.q_index + i], reach, generator);
    }
    if (joint.kind == JointKind::Planar) {
      entries.tail<2>() = pair_of(2.0 * std::numbers::pi * uniform(generator));
    } else if (unit_entries(joint.kind) == 4) {
      entries.tail<4>() = random_quaternion(generator);
    }
  }
  return q;
}

namespace {

/// Largest magnitude of an entry of q or v [rad, m, rad/s, m/s]. Above it, the resolution of double
/// is worse than 1e-7, and products and sums of lengths lose further digits.
constexpr double largest_coordinate = 1e9;

template <class Name>
void check_digits(const ConstVector& x, std::string_view argument, const Name& name) {
  for (Eigen::Index i = 0; i < x.size(); ++i)
    if (std::abs(x[i]) > largest_coordinate)
      throw Error("argument " + in_quotes(argument) + ": " + in_quotes(name(i)) + " is " +
                  number(x[i]) + ", where two adjacent floating-point numbers differ by " +
                  number(std::nextafter(std::abs(x[i]), INFINITY) - std::abs(x[i])) +
                  "; wanted a magnitude of at most " + number(largest_coordinate));
}

// Thresholds of odd_state(), chosen by hand.
constexpr double largest_usual = 1e4;  ///< Largest magnitude without a limit [rad, m, rad/s, m/s]
constexpr double largest_place = 1e6;  ///< Largest coordinate of a base in the world [m]
constexpr double far_above = 10.0;     ///< Largest velocity or torque, relative to its limit

/// Returns a text such as "joint 'a' is at 1.2 rad".
std::string position_text(const Joint& joint, double q) {
  return "joint " + in_quotes(joint.name) + " is at " + number(q) +
         (joint.kind == JointKind::Prismatic ? " m" : " rad");
}
/// Returns a text such as "; its limits are -1 and 1 rad".
std::string limits_text(const Model& model, const Joint& joint) {
  return "; its limits are " + number(model.q_lower[joint.q_index]) + " and " +
         number(model.q_upper[joint.q_index]) +
         (joint.kind == JointKind::Prismatic ? " m" : " rad");
}

/// Adds a sentence if a position lies far beyond its limits: by more than the distance between the
/// limits, and for angles also by more than one turn.
void about_position(const Model& model, const Joint& joint, double q,
                    std::vector<std::string>& sentences) {
  const double lower = model.q_lower[joint.q_index], upper = model.q_upper[joint.q_index];
  const bool slides = joint.kind == JointKind::Prismatic;
  const bool limited = lower > -largest_usual && upper < largest_usual;
  const double turn = slides ? 0.0 : 2.0 * std::numbers::pi;
  const double over = limited ? std::max(upper - lower, turn) : 0.0;
  const double lowest = limited ? lower - over : -largest_usual;
  const double highest = limited ? upper + over : largest_usual;
  if (q >= lowest && q <= highest) return;
  std::string sentence = position_text(joint, q);
  sentence += limited ? limits_text(model, joint)
                      : "; wanted a magnitude of at most " + number(largest_usual) +
                            (slides ? " m" : " rad");
  if (limited && !slides) sentence += ", and angles must be in radians, not degrees";
  sentences.push_back(sentence);
}

/// Adds a sentence for each entry that is far above its limit, or above `otherwise` if it has no
/// limit.
void about_entries(const Model& model, const ConstVector& x, const char* quantity,
                   const Eigen::VectorXd& limits, double otherwise,
                   std::vector<std::string>& sentences) {
  for (int k = 0; k < model.nv; ++k) {
    const bool limited = limits[k] > 0.0 && std::isfinite(limits[k]);
    if (std::abs(x[k]) <= (limited ? far_above * limits[k] : otherwise)) continue;
    sentences.push_back(quantity + in_quotes(model.v_name(k)) + " is " + number(x[k]) +
                        (limited ? "; its limit is " + number(limits[k])
                                 : "; wanted a magnitude of at most " + number(otherwise)));
  }
}

}  // namespace

std::vector<std::string> odd_state(const Model& model, const ConstVector& q, const ConstVector& v,
                                   const ConstVector& tau) {
  std::vector<std::string> sentences;
  for (const Joint& joint : model.joints) {
    if (joint.nq == 1) about_position(model, joint, q[joint.q_index], sentences);
    if (joint.kind != JointKind::FreeFlyer && joint.kind != JointKind::Planar) continue;
    const double place =
        q.segment(joint.q_index, joint.kind == JointKind::Planar ? 2 : 3).cwiseAbs().maxCoeff();
    if (place > largest_place)
      sentences.push_back("joint " + in_quotes(joint.name) + " is " + number(place) +
                          " m from the world's origin; wanted at most " + number(largest_place) +
                          " m, because larger distances lose digits");
  }
  about_entries(model, v, "the velocity of ", model.velocity_limit, largest_usual, sentences);
  about_entries(model, tau, "the torque of ", model.effort_limit, INFINITY, sentences);
  return sentences;
}

void check_configuration(const Model& model, const ConstVector& q, std::string_view argument) {
  check_size(q.size(), model.nq, argument);
  check_finite(q, argument);
  check_digits(q, argument, [&](Eigen::Index i) { return model.q_name(static_cast<int>(i)); });
  for (const Joint& joint : model.joints) {
    const auto [first, size] = rotation_entries(joint);
    if (size == 0) continue;
    const double length = q.segment(first, size).norm();
    if (std::abs(length - 1.0) <= unit_tolerance) continue;
    throw Error("argument " + in_quotes(argument) + ": the " +
                (size == 4 ? "quaternion" : "(cos, sin) pair") + " of joint " +
                in_quotes(joint.name) + " at entry " + std::to_string(first) + " has length " +
                number(length) + "; wanted 1");
  }
}

void check_tangent(const Model& model, const ConstVector& v, std::string_view argument) {
  check_size(v.size(), model.nv, argument);
  check_finite(v, argument);
  check_digits(v, argument, [&](Eigen::Index i) { return model.v_name(static_cast<int>(i)); });
}

std::string beyond_limits(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                          double slack) {
  double farthest = slack;
  std::string sentence;
  for (const Joint& joint : model.joints) {
    if (joint.nq != 1) continue;
    const double value = q[joint.q_index];
    const double beyond =
        std::max(model.q_lower[joint.q_index] - value, value - model.q_upper[joint.q_index]);
    if (!(beyond > farthest)) continue;
    farthest = beyond;
    sentence = position_text(joint, value) + limits_text(model, joint);
  }
  return sentence;
}

}  // namespace burnish
