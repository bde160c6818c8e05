#include "burnish/dynamics/placement.hpp"

#include "base/to_size.hpp"
#include "burnish/model/state.hpp"
#include "dynamics/kinematics.tpp"

namespace burnish {
namespace {

Kinematics<double> kinematics_at(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q) {
  check_configuration(model, q);
  const Tree tree(model);
  Kinematics<double> kinematics(tree);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
  update_kinematics(tree, q.data(), rest.data(), kinematics);
  return kinematics;
}

Eigen::Isometry3d placement_of(const Frame& frame, const Kinematics<double>& kinematics) {
  if (frame.body < 0) return frame.placement;
  const BodyState<double>& body = kinematics.bodies[to_size(frame.body)];
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  placement.linear() = to_eigen(body.R);
  placement.translation() = to_eigen(body.p);
  return placement * frame.placement;
}

}  // namespace

std::vector<Eigen::Isometry3d> frame_placements(const Model& model,
                                                const Eigen::Ref<const Eigen::VectorXd>& q) {
  const Kinematics<double> kinematics = kinematics_at(model, q);
  std::vector<Eigen::Isometry3d> result;
  for (const Frame& frame : model.frames) result.push_back(placement_of(frame, kinematics));
  return result;
}

Eigen::Isometry3d frame_placement(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                                  std::string_view frame) {
  if (frame == "world" && !model.has_frame(frame)) return Eigen::Isometry3d::Identity();
  const Frame& found = model.frames[to_size(model.frame_index(frame))];
  return placement_of(found, kinematics_at(model, q));
}

}  // namespace burnish
