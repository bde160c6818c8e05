#include "burnish/sim/scene.hpp"

#include <cmath>

#include "base/sentence.hpp"
#include "burnish/contact/reference.hpp"
#include "burnish/dynamics/placement.hpp"

namespace burnish {
namespace {

void check_number(double value, const char* what, bool zero_is_fine) {
  if (std::isfinite(value) && (zero_is_fine ? value >= 0.0 : value > 0.0)) return;
  throw Error(std::string(what) + " is " + number(value) + "; wanted a " +
              (zero_is_fine ? "number that is not negative" : "positive number"));
}

}  // namespace

SceneSpec checked_scene(const Model& model, const SceneSpec& scene) {
  const SurfaceSpec& surface = scene.surface;
  if (!surface.point.allFinite() || !surface.normal.allFinite())
    throw Error("the surface's point or normal holds a NaN or an infinity; wanted numbers");
  if (!(surface.normal.norm() > 1e-9))
    throw Error("the surface's normal has length " + number(surface.normal.norm()) +
                "; wanted a direction");
  check_number(surface.friction, "the surface's friction", true);
  check_number(surface.stiffness, "the surface's stiffness", false);
  check_number(surface.damping, "the surface's damping", true);
  if (!(surface.extent > 0.0))
    throw Error("the surface's extent is " + number(surface.extent) +
                " m; wanted a positive number, or infinity for a plane without end");
  check_number(surface.half_size, "the surface's half_size", false);
  check_number(scene.tip.radius, "the tip's radius", false);
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
