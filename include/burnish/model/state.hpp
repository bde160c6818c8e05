// Operations on configurations: q (+) dq, q1 (-) q0, random configurations, checks.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// Returns q (+) dq: the configuration that is reached from q if each joint moves for unit time
/// with constant velocity dq. q has nq entries. dq has nv entries, in the same body axes as v.
/// Throws Error for a wrong size.
Eigen::VectorXd integrate(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                          const Eigen::Ref<const Eigen::VectorXd>& dq);

/// Returns dq (nv entries) for which q0 (+) dq = q1, where (+) is integrate(). Rotations take the
/// shortest path. Throws Error for a wrong size.
Eigen::VectorXd difference(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q0,
                           const Eigen::Ref<const Eigen::VectorXd>& q1);

/// Returns the derivative of integrate(model, q, dq) with respect to dq at dq = 0: an nq x nv
/// matrix.
Eigen::MatrixXd tangent_map(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q);

/// Returns q with all quaternions and (cos, sin) pairs scaled to unit length. Throws Error if a
/// quaternion or pair has zero length.
Eigen::VectorXd normalized(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q);

/// Returns a random configuration. Rotations are uniform. Positions are uniform within their
/// limits, or within +-pi rad or +-1 m without limits. A limit beyond 1e4 rad or m counts as no
/// limit.
Eigen::VectorXd random_configuration(const Model& model, std::mt19937_64& generator);

/// Checks a configuration. Throws Error if
///  - q has the wrong size;
///  - an entry is a NaN, an infinity or beyond 1e9 rad or m (where too few digits remain);
///  - the length of a quaternion or (cos, sin) pair differs from 1 by more than 1e-6.
/// The message names the entry and calls the vector by the name `argument`.
void check_configuration(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                         std::string_view argument = "q");
/// Checks a velocity. Throws Error if v has the wrong size, or if an entry is a NaN, an infinity or
/// beyond 1e9 rad/s or m/s. The message names the entry and calls the vector by the name
/// `argument`.
void check_tangent(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& v,
                   std::string_view argument = "v");

/// Returns a sentence about each implausible value of a state, such as an angle in degrees. q has
/// nq entries, v and tau have nv. Implausible values are
///  - displacements that exceed a limit by more than the range from lower to upper limit;
///  - angles that exceed a limit by more than this range and by more than one turn;
///  - positions beyond 1e4 rad or m of joints without limits;
///  - positions beyond 1e6 m of floating and planar joints;
///  - velocities above ten times their limit, or above 1e4 rad/s or m/s without a limit;
///  - torques above ten times their limit.
std::vector<std::string> odd_state(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                                   const Eigen::Ref<const Eigen::VectorXd>& v,
                                   const Eigen::Ref<const Eigen::VectorXd>& tau);

/// Rounding error of positions in posture files [rad or m].
inline constexpr double posture_rounding = 1e-4;
/// Returns a sentence about the joint that is farthest outside its position limits, such as "joint
/// 'a' is at 1.2 rad; its limits are -1 and 1 rad". Returns an empty string if no joint exceeds its
/// limits by more than `slack` [rad or m]. Joints with several entries have no limits. q has nq
/// entries.
std::string beyond_limits(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                          double slack = posture_rounding);

}  // namespace burnish
