#include "burnish/ocp/residual.hpp"

namespace burnish {
namespace {
struct NameOf {
  std::string operator()(const residual::State&) const { return "state"; }
  std::string operator()(const residual::Control&) const { return "control"; }
  std::string operator()(const residual::JointPosition&) const { return "joint position"; }
  std::string operator()(const residual::JointVelocity&) const { return "joint velocity"; }
  std::string operator()(const residual::JointTorque&) const { return "joint torque"; }
  std::string operator()(const residual::FramePosition&) const { return "frame position"; }
  std::string operator()(const residual::FrameRotation&) const { return "frame rotation"; }
  std::string operator()(const residual::FramePlacement&) const { return "frame placement"; }
  std::string operator()(const residual::FrameVelocity&) const { return "frame velocity"; }
  std::string operator()(const residual::ContactForce&) const { return "contact force"; }
  std::string operator()(const residual::FrictionCone&) const { return "friction cone"; }
  std::string operator()(const residual::CenterOfPressure&) const { return "center of pressure"; }
  std::string operator()(const residual::CenterOfMass&) const { return "center of mass"; }
  std::string operator()(const residual::CentroidalMomentum&) const {
    return "centroidal momentum";
  }
  std::string operator()(const residual::Custom& r) const {
    return r.name.empty() ? "custom" : r.name;
  }
};
}  // namespace

std::string name_of(const Residual& residual) { return std::visit(NameOf{}, residual); }

}  // namespace burnish
