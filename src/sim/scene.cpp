#include "burnish/sim/scene.hpp"

#include <cmath>

#include "base/sentence.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/dynamics/reference.hpp"
#include "sim/descriptions.hpp"

namespace burnish {
SceneSpec checked_scene(const Model& model, const SceneSpec& scene) {
  const SurfaceSpec& surface = scene.surface;
  check_ranges(description_of(&surface), &surface,
               [](const std::string& entry) { return "the surface's " + entry; });
  check_ranges(description_of(&scene.tip), &scene.tip,
               [](const std::string& entry) { return "the tip's " + entry; });
  const int frame = model.frame_index(scene.tip.frame);
  if (model.frames[static_cast<std::size_t>(frame)].body < 0)
    throw Error("the tip's frame " + in_quotes(scene.tip.frame) +
                " is fixed to the world; wanted one that the robot moves");
  SceneSpec result = scene;
  result.surface.normal.normalize();
  return result;
}

SceneSpec scene_under_tip(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                          const Eigen::Vector3d& normal, SceneSpec scene, double clearance) {
  scene.surface.normal = normal;
  scene = checked_scene(model, scene);
  const Eigen::Vector3d p_tip_world = frame_placement(model, q, scene.tip.frame).translation();
  scene.surface.point = p_tip_world - (scene.tip.radius + clearance) * scene.surface.normal;
  return scene;
}

double gap(const SceneSpec& scene, const Eigen::Vector3d& p_tip_world) {
  return scene.surface.normal.dot(p_tip_world - scene.surface.point) - scene.tip.radius;
}

Eigen::Vector3d seen_from_surface(const SurfaceSpec& surface, const Eigen::Vector3d& p_world) {
  const Eigen::Matrix3d axes = Reference::surface_with_normal(surface.normal).rotation;
  return axes.transpose() * (p_world - surface.point);
}

bool is_over(const SceneSpec& scene, const Eigen::Vector3d& p_tip_world, bool in_contact) {
  const double extent = scene.surface.extent;
  if (std::isinf(extent)) return true;
  const Eigen::Vector3d p = seen_from_surface(scene.surface, p_tip_world);
  return std::abs(p.x()) <= extent && std::abs(p.y()) <= extent && (in_contact || p.z() > 0.0);
}

}  // namespace burnish
