#include "burnish/sim/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/dynamics/reference.hpp"
#include "sim/descriptions.gen.hpp"

namespace burnish {

double SurfaceMotion::displacement(double time) const noexcept {
  const double since = std::max(0.0, time - start);
  return amplitude * std::sin(2.0 * std::numbers::pi * frequency * since) + drift * since;
}

namespace {

void check_moves(const Model& model, const std::string& frame, const char* whose) {
  if (model.frames[to_size(model.frame_index(frame))].body < 0)
    throw Error(std::string(whose) + " frame " + in_quotes(frame) +
                " is fixed to the world; wanted a frame that the robot moves");
}

void check_carried(const Model& model, const SceneSpec& scene) {
  const std::string& frame = scene.surface.frame;
  check_moves(model, frame, "the surface's");
  const auto body = [&](const std::string& name) {
    return model.frames[to_size(model.frame_index(name))].body;
  };
  if (scene.tip.exists() && body(frame) == body(scene.tip.frame))
    throw Error("the surface's frame " + in_quotes(frame) + " and the tip's " +
                in_quotes(scene.tip.frame) + " are on one body; wanted frames that move relative " +
                "to each other");
}

void check_support(const Model& model, const SupportSpec& support) {
  check_ranges(description_of(&support), &support, [&](const std::string& entry) {
    return "support " + in_quotes(support.frame) + ": " + entry;
  });
  check_moves(model, support.frame, "a support's");
  if (!support.is_sole() && (support.half_x > 0.0 || support.half_y > 0.0))
    throw Error("support " + in_quotes(support.frame) + " has half sides of " +
                number(support.half_x) + " and " + number(support.half_y) +
                " m; wanted both above 0 for a planar foot, or both 0 for a point foot");
}

/// Throws Error unless the slippery ground is under a support. Under another frame, the ground
/// would have no effect.
void check_ground(const SceneSpec& scene, const SlipperyGround& ground) {
  check_ranges(description_of(&ground), &ground,
               [](const std::string& entry) { return "the slippery ground's " + entry; });
  if (ground.frame.empty()) return;
  std::vector<std::string> supports;
  for (const SupportSpec& support : scene.supports) supports.push_back(support.frame);
  if (std::find(supports.begin(), supports.end(), ground.frame) == supports.end())
    throw Error("the slippery ground is under " + in_quotes(ground.frame) +
                ", which is not a support of the scene" + did_you_mean(ground.frame, supports));
}

}  // namespace

SceneSpec checked_scene(const Model& model, const SceneSpec& scene) {
  const SurfaceSpec& surface = scene.surface;
  check_ranges(description_of(&surface), &surface,
               [](const std::string& entry) { return "the surface's " + entry; });
  check_ranges(description_of(&scene.tip), &scene.tip,
               [](const std::string& entry) { return "the tip's " + entry; });
  if (scene.tip.exists()) check_moves(model, scene.tip.frame, "the tip's");
  if (!surface.frame.empty()) check_carried(model, scene);
  for (const SupportSpec& support : scene.supports) check_support(model, support);
  for (const SlipperyGround& ground : scene.slippery_ground) check_ground(scene, ground);
  check_ranges(description_of(&scene.hoist), &scene.hoist,
               [](const std::string& entry) { return "the hoist's " + entry; });
  if (!scene.hoist.frame.empty()) check_moves(model, scene.hoist.frame, "the hoist's");
  surface.shape.check("the surface");
  const double concavity = surface_of(surface).max_concavity();
  if (scene.tip.exists() && !(concavity * scene.tip.radius < 1.0))
    throw Error("the tip's radius of " + number(scene.tip.radius) + " m does not fit into the " +
                surface.shape.text() + "; wanted a tip radius below " + number(1.0 / concavity) +
                " m, the smallest concave radius");
  SceneSpec result = scene;
  result.surface.normal.normalize();
  for (SupportSpec& support : result.supports) support.normal.normalize();
  return result;
}

double HoistSpec::load_fraction(double time) const noexcept {
  if (!holds() || time >= duration) return 0.0;
  const double s = std::clamp(2.0 * time / duration - 1.0, 0.0, 1.0);
  return 1.0 - s * s * (3.0 - 2.0 * s);
}

bool acts_at(double start, double duration, double time) noexcept {
  // Rounding error of the plant's time, a multiple of its step [s].
  constexpr double rounding = 1e-9;
  const double now = time + rounding;
  return now >= start && now < start + duration;
}

double friction_under(const SceneSpec& scene, const SupportSpec& support, double time) noexcept {
  double friction = support.friction;
  for (const SlipperyGround& ground : scene.slippery_ground)
    if ((ground.frame.empty() || ground.frame == support.frame) && acts_at(ground, time))
      friction = ground.friction;
  return friction;
}

SceneSpec scene_under_tip(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                          const Eigen::Vector3d& normal, SceneSpec scene, double clearance) {
  if (!scene.tip.exists())
    throw Error("the scene has no tip, to which the surface could be moved; wanted tip.frame");
  scene.surface.normal = normal;
  scene = checked_scene(model, scene);
  const Eigen::Vector3d p_tip = surface_placement(model, q, scene.surface).inverse() *
                                frame_placement(model, q, scene.tip.frame).translation();
  scene.surface.point = p_tip - (scene.tip.radius + clearance) * scene.surface.normal;
  return scene;
}

Eigen::Isometry3d surface_placement(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                                    const SurfaceSpec& surface) {
  return surface.frame.empty() ? Eigen::Isometry3d::Identity()
                               : frame_placement(model, q, surface.frame);
}

Surface surface_of(const SurfaceSpec& surface) {
  return {surface.shape, surface.point, surface.normal};
}

SurfaceSpec in_world(SurfaceSpec surface, const Eigen::Isometry3d& placement) {
  surface.frame.clear();
  surface.point = placement * surface.point;
  surface.normal = placement.linear() * surface.normal;
  return surface;
}

Eigen::Vector3d normal_at(const SceneSpec& scene, const Eigen::Vector3d& p_tip) {
  if (scene.surface.shape.is_flat()) return scene.surface.normal;
  return surface_of(scene.surface).at(p_tip).normal;
}

double gap(const SceneSpec& scene, const Eigen::Vector3d& p_tip) {
  if (!scene.surface.shape.is_flat())
    return surface_of(scene.surface).at(p_tip).distance - scene.tip.radius;
  return scene.surface.normal.dot(p_tip - scene.surface.point) - scene.tip.radius;
}

Eigen::Vector3d seen_from_surface(const SurfaceSpec& surface, const Eigen::Vector3d& p) {
  const Eigen::Matrix3d axes = Reference::surface_with_normal(surface.normal).rotation;
  return axes.transpose() * (p - surface.point);
}

bool is_over(const SceneSpec& scene, const Eigen::Vector3d& p_tip, bool in_contact) {
  const double extent = scene.surface.extent;
  if (std::isinf(extent)) return true;
  const Eigen::Vector3d seen = seen_from_surface(scene.surface, p_tip);
  if (!(std::abs(seen.x()) <= extent && std::abs(seen.y()) <= extent)) return false;
  return in_contact || gap(scene, p_tip) > -scene.tip.radius;
}

}  // namespace burnish
