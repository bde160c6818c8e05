#include "burnish/sim/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/dynamics/reference.hpp"
#include "sim/descriptions.hpp"

namespace burnish {

double SurfaceMotion::way(double time) const noexcept {
  const double since = std::max(0.0, time - start);
  return amplitude * std::sin(2.0 * std::numbers::pi * frequency * since) + drift * since;
}

namespace {

void check_moves(const Model& model, const std::string& frame, const char* whose) {
  if (model.frames[static_cast<std::size_t>(model.frame_index(frame))].body < 0)
    throw Error(std::string(whose) + " frame " + in_quotes(frame) +
                " is fixed to the world; wanted one that the robot moves");
}

void check_support(const Model& model, const SupportSpec& support) {
  check_ranges(description_of(&support), &support, [&](const std::string& entry) {
    return "support " + in_quotes(support.frame) + ": " + entry;
  });
  check_moves(model, support.frame, "a support's");
  if (!support.is_sole() && (support.half_x > 0.0 || support.half_y > 0.0))
    throw Error("support " + in_quotes(support.frame) + " has half sides of " +
                number(support.half_x) + " and " + number(support.half_y) +
                " m; wanted both of a sole, or neither of a ball");
}

}  // namespace

SceneSpec checked_scene(const Model& model, const SceneSpec& scene) {
  const SurfaceSpec& surface = scene.surface;
  check_ranges(description_of(&surface), &surface,
               [](const std::string& entry) { return "the surface's " + entry; });
  check_ranges(description_of(&scene.tip), &scene.tip,
               [](const std::string& entry) { return "the tip's " + entry; });
  check_moves(model, scene.tip.frame, "the tip's");
  for (const SupportSpec& support : scene.supports) check_support(model, support);
  surface.shape.check("the surface");
  const double bend = surface_of(surface).most_concave();
  if (!(bend * scene.tip.radius < 1.0))
    throw Error("the tip's radius of " + number(scene.tip.radius) + " m does not fit into the " +
                surface.shape.text() + ", whose least radius is " + number(1.0 / bend) +
                " m where it is hollow; wanted a smaller tip");
  SceneSpec result = scene;
  result.surface.normal.normalize();
  for (SupportSpec& support : result.supports) support.normal.normalize();
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

Surface surface_of(const SurfaceSpec& surface) {
  return {surface.shape, surface.point, surface.normal};
}

Eigen::Vector3d normal_at(const SceneSpec& scene, const Eigen::Vector3d& p_tip_world) {
  if (scene.surface.shape.is_flat()) return scene.surface.normal;
  return surface_of(scene.surface).at(p_tip_world).normal;
}

double gap(const SceneSpec& scene, const Eigen::Vector3d& p_tip_world) {
  if (!scene.surface.shape.is_flat())
    return surface_of(scene.surface).at(p_tip_world).distance - scene.tip.radius;
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
  if (!(std::abs(p.x()) <= extent && std::abs(p.y()) <= extent)) return false;
  return in_contact || gap(scene, p_tip_world) > -scene.tip.radius;
}

}  // namespace burnish
