// Mass distributions: change of axes, sum and checks. Each body has ten inertial parameters;
// inverse dynamics is linear in these parameters.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "burnish/base/status.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

using Vector10 = Eigen::Matrix<double, 10, 1>;

/// Names of the ten inertial parameters of a body: mass [kg], mass times centre of mass [kg m], and
/// moments of inertia [kg m^2]. All parameters are in the axes of the body's joint frame, and the
/// moments of inertia are about its origin.
inline constexpr std::array<std::string_view, 10> inertia_parameter_names{
    "m", "mcx", "mcy", "mcz", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz"};

/// Returns the ten inertial parameters of a mass distribution, in the order of
/// inertia_parameter_names.
Vector10 inertia_parameters(const InertiaSpec& inertia);
/// Returns the mass distribution that has the ten inertial parameters `parameters`. If the mass is
/// zero, the centre of mass is set to the origin.
InertiaSpec inertia_of(const Vector10& parameters);

/// Returns the pseudo-inertia matrix [S, h; h^T, m] of ten inertial parameters. m is the mass, h is
/// the mass times the centre of mass, and S is the 3 x 3 matrix of second moments about the origin.
/// The inertia about the origin is trace(S) I - S, with the identity matrix I. A solid with these
/// parameters exists if and only if the pseudo-inertia matrix is positive semidefinite. Source: P.
/// Wensing, S. Kim, J.-J. Slotine, "Linear Matrix Inequalities for Physically Consistent Inertial
/// Parameter Identification", 2018.
Eigen::Matrix4d pseudo_inertia(const Vector10& parameters);
/// Returns the ten inertial parameters of a pseudo-inertia matrix: the inverse of pseudo_inertia().
Vector10 parameters_of_pseudo_inertia(const Eigen::Matrix4d& pseudo_inertia);
/// Returns the matrix that converts the ten inertial parameters of a mass distribution from a frame
/// to its parent frame. `placement` is the pose of the frame in the parent frame.
Eigen::Matrix<double, 10, 10> inertia_transform(const Eigen::Isometry3d& placement);

/// Converts a mass distribution from a frame to the parent frame. `inertia` is in the axes of the
/// frame. `placement` is the pose of the frame in the parent frame.
InertiaSpec placed(const InertiaSpec& inertia, const Eigen::Isometry3d& placement);
/// Returns the sum of two mass distributions that are rigidly joined. `a`, `b` and the result are
/// in the same axes.
InertiaSpec together(const InertiaSpec& a, const InertiaSpec& b);

/// Checks whether a solid can have this mass distribution. Allocates no memory. Returns
///  - NotFinite if an entry is a NaN or an infinity, or if the mass is negative;
///  - NotPhysical if the inertia is not symmetric;
///  - NotPhysical if a principal moment about the centre of mass is negative or exceeds the sum of
///    the other two moments;
///  - NotPhysical if there are moments of inertia without a mass.
/// A violation by up to 5 % of the largest moment is accepted, since published values are rounded.
Status check_inertia(const InertiaSpec& inertia) noexcept;
/// Returns the problem that check_inertia() finds, as a sentence such as "the mass is -1; wanted a
/// number of at least 0". Returns an empty string if check_inertia() returns Ok.
std::string inertia_problem(const InertiaSpec& inertia);

/// Returns the mass distribution of one body, in the axes of its joint frame. `body` is the index
/// of the joint that carries the body.
InertiaSpec inertia_of_body(const Model& model, int body);
void set_inertia_of_body(Model& model, int body, const InertiaSpec& inertia);

/// A load that a robot carries at the frame `frame`. The inertia is in the axes of this frame.
struct Payload {
  std::string frame = "tool";
  InertiaSpec inertia;
};

/// Returns the frame with the name `frame`. Throws Error if the frame does not exist (with the
/// nearest known name), or if it is fixed to the world and cannot carry a load. The message begins
/// with `call`, the name of the calling function. Allocates no memory unless it throws.
const Frame& frame_on_body(std::string_view call, const Model& model, std::string_view frame);

/// Returns the model with the payload added to the inertia of the body that carries the frame.
/// Throws Error if the frame does not exist, if the frame is fixed to the world, or if no solid can
/// have the payload's mass distribution.
Model with_payload(Model model, const Payload& payload);

}  // namespace burnish
