#include "burnish/model/urdf.hpp"

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <mutex>

#include "model/sentence.hpp"
#include "model/text_file.hpp"
#include "model/tree_check.hpp"
#include "model/urdf_check.hpp"

namespace burnish {
namespace {

/// Keeps urdfdom off the console and remembers its last complaint. The handler is global to the
/// process, so one reader at a time holds it.
class QuietUrdfdom : private console_bridge::OutputHandler {
 public:
  QuietUrdfdom() : lock_(mutex()), previous_(console_bridge::getOutputHandler()) {
    console_bridge::useOutputHandler(this);
  }
  ~QuietUrdfdom() override { console_bridge::useOutputHandler(previous_); }
  QuietUrdfdom(const QuietUrdfdom&) = delete;
  QuietUrdfdom& operator=(const QuietUrdfdom&) = delete;

  const std::string& complaint() const { return complaint_; }

 private:
  static std::mutex& mutex() {
    static std::mutex shared;
    return shared;
  }
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) complaint_ = text;
  }

  std::lock_guard<std::mutex> lock_;
  console_bridge::OutputHandler* previous_;
  std::string complaint_;
};

urdf::ModelInterfaceSharedPtr parse_quietly(const UrdfOutline& outline) {
  QuietUrdfdom quiet;
  std::string reason;
  try {
    if (urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(outline.xml)) return model;
    reason = quiet.complaint();
  } catch (const std::exception& error) {
    reason = error.what();
  }
  refuse(outline.tree, "urdfdom refuses it: " + (reason.empty() ? "no reason given" : reason));
}

Eigen::Vector3d vector_of(const urdf::Vector3& x) { return {x.x, x.y, x.z}; }

Eigen::Isometry3d placement_of(const urdf::Pose& pose) {
  const urdf::Rotation& r = pose.rotation;
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  placement.translation() = vector_of(pose.position);
  placement.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
  return placement;
}

InertiaSpec inertia_of(const urdf::Inertial& stated) {
  const Eigen::Isometry3d origin = placement_of(stated.origin);
  Eigen::Matrix3d inertia;
  inertia << stated.ixx, stated.ixy, stated.ixz, stated.ixy, stated.iyy, stated.iyz, stated.ixz,
      stated.iyz, stated.izz;
  const Eigen::Matrix3d turned = origin.linear() * inertia * origin.linear().transpose();
  // The product is symmetric up to rounding only.
  return {stated.mass, origin.translation(), 0.5 * (turned + turned.transpose())};
}

Shape shape_of(const urdf::Geometry& geometry) {
  switch (geometry.type) {
    case urdf::Geometry::SPHERE:
      return SphereShape{static_cast<const urdf::Sphere&>(geometry).radius};
    case urdf::Geometry::BOX:
      return BoxShape{vector_of(static_cast<const urdf::Box&>(geometry).dim)};
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
      return CylinderShape{cylinder.radius, cylinder.length};
    }
    case urdf::Geometry::MESH:
      break;
  }
  const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
  return MeshShape{mesh.filename, vector_of(mesh.scale)};
}

VisualSpec visual_of(const urdf::Visual& stated) {
  VisualSpec visual;
  visual.shape = shape_of(*stated.geometry);
  visual.placement = placement_of(stated.origin);
  if (stated.material) {
    const urdf::Color& colour = stated.material->color;
    visual.rgba = Eigen::Vector4f(colour.r, colour.g, colour.b, colour.a).cast<double>();
  }
  return visual;
}

void fill_link(LinkSpec& link, const urdf::Link& stated) {
  if (stated.inertial) link.inertia = inertia_of(*stated.inertial);
  for (const urdf::VisualSharedPtr& visual : stated.visual_array) {
    if (visual && visual->geometry) link.visuals.push_back(visual_of(*visual));
  }
}

void fill_joint(JointSpec& joint, const urdf::Joint& stated) {
  joint.placement = placement_of(stated.parent_to_joint_origin_transform);
  if (joint.type != JointType::Fixed && joint.type != JointType::Floating) {
    joint.axis = vector_of(stated.axis);
    // A zero axis stays as it is for check_values to name.
    if (joint.axis.norm() > 0.0) joint.axis.normalize();
  }
  if (stated.dynamics) {
    joint.damping = stated.dynamics->damping;
    joint.friction = stated.dynamics->friction;
  }
  if (stated.mimic) {
    joint.mimic =
        MimicSpec{stated.mimic->joint_name, stated.mimic->multiplier, stated.mimic->offset};
  }
}

}  // namespace

TreeSpec parse_urdf(const std::string& xml, const std::string& source) {
  UrdfOutline outline = check_urdf(xml, source);
  const urdf::ModelInterfaceSharedPtr stated = parse_quietly(outline);
  TreeSpec tree = std::move(outline.tree);
  for (LinkSpec& link : tree.links) fill_link(link, *stated->getLink(link.name));
  for (JointSpec& joint : tree.joints) fill_joint(joint, *stated->getJoint(joint.name));
  check_values(tree);
  return tree;
}

TreeSpec read_urdf(const std::filesystem::path& file) {
  return parse_urdf(read_text(file, "URDF file"), file.string());
}

}  // namespace burnish
