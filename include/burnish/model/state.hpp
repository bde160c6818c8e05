// Arithmetic on configurations: q (+) dq, q1 (-) q0, random states, checks.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// q (+) dq: moves every joint along its own twist dq for unit time. q: nq, dq: nv (body axes of
/// each joint, as v). Throws Error on wrong sizes.
Eigen::VectorXd integrate(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                          const Eigen::Ref<const Eigen::VectorXd>& dq);

/// The dq with q0 (+) dq = q1 (shortest for rotations).
Eigen::VectorXd difference(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q0,
                           const Eigen::Ref<const Eigen::VectorXd>& q1);

/// d(q (+) dq)/d(dq) at dq = 0: nq x nv.
Eigen::MatrixXd tangent_map(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q);

/// Scales quaternions and (cos, sin) pairs to unit length.
Eigen::VectorXd normalized(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q);

/// A random configuration: uniform within position limits (within +-pi or +-1 m where there are
/// none, or limits beyond 1e4 rad or m, which no joint reaches), uniform rotations.
Eigen::VectorXd random_configuration(const Model& model, std::mt19937_64& generator);

/// Throws Error with a sentence naming the argument and the entry if q or v has the wrong size,
/// holds a NaN or infinity, an entry beyond 1e9 rad or m (or per s), of which too few digits are
/// left, or q holds a quaternion or (cos, sin) pair that is not of unit length.
void check_configuration(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                         std::string_view argument = "q");
void check_tangent(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& v,
                   std::string_view argument = "v");

/// Sentences about a state that the robot cannot be in, such as angles in degrees; empty where
/// there are none. They name positions beyond the limits by more than their range (and a turn), or
/// beyond 1e4 rad or m where there are none (1e6 m of a base), velocities and torques above ten
/// times their limits, and velocities above 1e4 rad/s or m/s where there are none. q: nq, v and
/// tau: nv.
std::vector<std::string> odd_state(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                                   const Eigen::Ref<const Eigen::VectorXd>& v,
                                   const Eigen::Ref<const Eigen::VectorXd>& tau);

/// Rounding of positions in files of postures [rad, m].
inline constexpr double posture_rounding = 1e-4;
/// Sentence about the joint that is farthest beyond its position limits, such as "joint 'a' is at
/// 1.2 rad; its limits are -1 and 1 rad". Empty if no joint is beyond by more than `slack` [rad,
/// m]. Joints with more than one entry have no limits. q: nq.
std::string beyond_limits(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                          double slack = posture_rounding);

}  // namespace burnish
