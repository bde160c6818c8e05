#include "files/here.hpp"

#include "burnish/dynamics/placement.hpp"
#include "dynamics/frame_kinematics.hpp"
#include "dynamics/momentum.hpp"

namespace burnish::files {
namespace {

Kinematics<double> at_rest(const Tree& tree, const Eigen::VectorXd& q) {
  Kinematics<double> kinematics(tree);
  const Eigen::VectorXd v = Eigen::VectorXd::Zero(tree.nv);
  update_kinematics(tree, q.data(), v.data(), kinematics);
  return kinematics;
}

}  // namespace

Eigen::VectorXd center_of_mass(const Model& model, const Eigen::VectorXd& q) {
  const Tree tree(model);
  Momentum<double> momentum(tree);
  const Eigen::VectorXd v = Eigen::VectorXd::Zero(model.nv);
  update_momentum(tree, at_rest(tree, q), v.data(), momentum);
  Eigen::VectorXd com(3);
  com << momentum.com.x, momentum.com.y, momentum.com.z;
  return com;
}

Eigen::VectorXd placement_here(const Model& model, const Eigen::VectorXd& q,
                               const std::string& frame) {
  const Eigen::Isometry3d placement = frame_placement(model, q, frame);
  Eigen::VectorXd result(7);
  result.head<3>() = placement.translation();
  result.tail<4>() = Eigen::Quaterniond(placement.linear()).coeffs();
  return result;
}

Eigen::VectorXd rotation_here(const Model& model, const Eigen::VectorXd& q,
                              const std::string& frame, const Reference& reference) {
  const Kinematics<double> kinematics = at_rest(Tree(model), q);
  const CompiledFrame seen = compile_frame(model, frame);
  const CompiledReference in = compile_reference(model, reference, seen, world_frame());
  FrameState<double> state;
  update_frame(seen, kinematics, state);
  const ReferencePose<double> pose = reference_pose(in, kinematics);
  return Eigen::Quaterniond(to_eigen(transpose_times(pose.R, state.R))).coeffs();
}

PositionAxes position_axes(const Model& model, const Eigen::VectorXd& q, const std::string& frame,
                           const Reference& reference) {
  const Kinematics<double> kinematics = at_rest(Tree(model), q);
  const CompiledReference in = compile_reference(model, asked_for_positions(reference),
                                                 compile_frame(model, frame), world_frame());
  PositionAxes result{Eigen::Isometry3d::Identity(), to_eigen(reference_pose(in, kinematics).R)};
  result.numbers.linear() = to_eigen(reference_axes(in, in.fixed_in, kinematics));
  result.numbers.translation() = to_eigen(reference_origin(in, kinematics));
  return result;
}

PositionHere position_here(const Model& model, const Eigen::VectorXd& q, const std::string& frame,
                           const Reference& reference) {
  const PositionAxes axes = position_axes(model, q, frame, reference);
  return {axes.numbers.inverse() * frame_placement(model, q, frame).translation(),
          axes.numbers.linear().transpose() * axes.rows};
}

}  // namespace burnish::files
