// Mass distributions: seen from other axes, put together, checked, and as the ten numbers that
// inverse dynamics is linear in.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "burnish/base/status.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

using Vector10 = Eigen::Matrix<double, 10, 1>;

/// Of a body in the axes and about the origin of its joint frame: mass (kg), mass times centre
/// (kg m), and moments of inertia about the origin (kg m^2).
inline constexpr std::array<std::string_view, 10> inertia_parameter_names{
    "m", "mcx", "mcy", "mcz", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz"};

/// The ten parameters of a mass distribution, as inertia_parameter_names has them.
Vector10 inertia_parameters(const InertiaSpec& inertia);
/// The mass distribution that has these parameters. Without a mass its centre is the origin.
InertiaSpec inertia_of(const Vector10& parameters);

/// [S, h; h^T, m] of the parameters, S being the second moments about the origin (the inertia is
/// tr(S) 1 - S): a solid has them exactly if this is positive semidefinite (P. Wensing, S. Kim,
/// J.-J. Slotine, "Linear Matrix Inequalities for Physically Consistent Inertial Parameter
/// Identification", 2018).
Eigen::Matrix4d pseudo_inertia(const Vector10& parameters);
/// And back.
Vector10 parameters_of_pseudo_inertia(const Eigen::Matrix4d& pseudo_inertia);
/// Takes parameters in a frame's axes to those in the axes that `placement` is given in.
Eigen::Matrix<double, 10, 10> inertia_transform(const Eigen::Isometry3d& placement);

/// The same masses written in the axes that `placement` is given in.
InertiaSpec placed(const InertiaSpec& inertia, const Eigen::Isometry3d& placement);
/// Both, rigidly joined, in the axes that both are written in.
InertiaSpec together(const InertiaSpec& a, const InertiaSpec& b);

/// Whether a solid can have it: NotFinite for a NaN, an infinity, a negative mass; NotPhysical for
/// moments of inertia about the centre that are not symmetric or belong to no solid (a negative one
/// or one above the sum of the two others, by more than 5 % of the largest: published figures are
/// rounded), and for moments without a mass. Allocates nothing.
Status check_inertia(const InertiaSpec& inertia) noexcept;
/// The same as a sentence, such as "the mass is -1; wanted a number of at least 0"; empty where
/// check_inertia is Ok.
std::string inertia_problem(const InertiaSpec& inertia);

/// Of the body that joint `body` carries.
InertiaSpec inertia_of_body(const Model& model, int body);
void set_inertia_of_body(Model& model, int body, const InertiaSpec& inertia);

/// What a robot carries at one of its frames, in that frame's axes.
struct Payload {
  std::string frame = "tool";
  InertiaSpec inertia;
};

/// The body that a frame is fixed to, for who wants to load it. Throws Error("<call>: ...") with
/// the nearest known name for a frame that there is not, and for one that is fixed to the world,
/// which nothing moves. Allocates nothing otherwise.
const Frame& frame_on_body(std::string_view call, const Model& model, std::string_view frame);

/// The model with the payload in addition to what it carries already. Throws Error with one
/// sentence for a frame that there is not or that is fixed to the world, and for a mass
/// distribution that no solid has.
Model with_payload(Model model, const Payload& payload);

}  // namespace burnish
