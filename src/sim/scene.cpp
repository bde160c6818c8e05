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

int body_of(const Model& model, const std::string& frame) {
  return model.frames[to_size(model.frame_index(frame))].body;
}

void check_surface(const Model& model, const TouchSpec& touch, const std::string& whose) {
  const SurfaceSpec& surface = touch.surface;
  check_ranges(description_of(&surface), &surface,
               [&](const std::string& entry) { return whose + " surface." + entry; });
  surface.shape.check(whose + " surface");
  if (!surface.frame.empty()) {
    check_moves(model, surface.frame, "the surface's");
    if (body_of(model, surface.frame) == body_of(model, touch.frame))
      throw Error("the surface's frame " + in_quotes(surface.frame) + " and the touch's frame " +
                  in_quotes(touch.frame) + " are on one body; wanted frames that move relative " +
                  "to each other");
  }
  const double concavity = surface_of(surface).max_concavity();
  if (!touch.is_rectangle() && !(concavity * touch.radius < 1.0))
    throw Error(whose + " radius of " + number(touch.radius) + " m does not fit into the " +
                surface.shape.text() + "; wanted a radius below " + number(1.0 / concavity) +
                " m, the smallest concave radius");
}

/// Returns the reason why the surface cannot carry feet, such as "moves"; empty if it can.
std::string unfit_for_supports(const SurfaceSpec& surface) {
  if (!surface.frame.empty()) return "is carried by frame " + in_quotes(surface.frame);
  if (!surface.motion.is_at_rest()) return "moves";
  if (!surface.shape.is_flat()) return "is a " + surface.shape.text();
  return std::isinf(surface.extent) ? "" : "has edges";
}

void check_touch(const Model& model, const TouchSpec& touch) {
  if (touch.frame.empty()) throw Error("a touch of the scene has no frame; wanted its frame");
  const std::string of = "touch " + in_quotes(touch.frame) + ":";
  check_ranges(description_of(&touch), &touch,
               [&](const std::string& entry) { return of + " " + entry; });
  check_moves(model, touch.frame, "a touch's");
  if (!touch.is_rectangle() && (touch.half_x > 0.0 || touch.half_y > 0.0))
    throw Error(of + " the half sides are " + number(touch.half_x) + " and " +
                number(touch.half_y) +
                " m; wanted both above 0 for a rectangle, or both 0 for a sphere");
  check_surface(model, touch, of);
  if (touch.is_rectangle() && !touch.is_support)
    throw Error(of +
                " it is a rectangle, but not a support; wanted a rectangle that is a support, or a "
                "sphere (half_x and half_y 0)");
  if (const std::string unfit = unfit_for_supports(touch.surface);
      touch.is_support && !unfit.empty())
    throw Error(of + " its surface " + unfit +
                "; wanted a plane in the world without edges for a support");
}

/// Throws Error unless the slippery ground is under a support. Under another frame, the ground
/// would have no effect.
void check_ground(const SceneSpec& scene, const SlipperyGround& ground) {
  check_ranges(description_of(&ground), &ground,
               [](const std::string& entry) { return "the slippery ground's " + entry; });
  if (ground.frame.empty()) return;
  std::vector<std::string> supports;
  for (const TouchSpec& touch : scene.touches)
    if (touch.is_support) supports.push_back(touch.frame);
  if (std::find(supports.begin(), supports.end(), ground.frame) == supports.end())
    throw Error("the slippery ground is under " + in_quotes(ground.frame) +
                ", which is not a support of the scene" + did_you_mean(ground.frame, supports));
}

/// Returns the index of the first tool. Throws Error if the scene has no tool.
int checked_tool_index(const SceneSpec& scene) {
  const int index = scene.tool_index();
  if (index < 0) throw Error("the scene has no tool; wanted a touch that is not a support");
  return index;
}

}  // namespace

WrenchSensor TouchSpec::measured() const {
  if (sensor != WrenchSensor::Automatic) return sensor;
  return is_support ? WrenchSensor::Wrench : WrenchSensor::Force;
}

int SceneSpec::tool_index() const noexcept {
  for (std::size_t i = 0; i < touches.size(); ++i)
    if (!touches[i].is_support) return static_cast<int>(i);
  return -1;
}

const TouchSpec& SceneSpec::tool() const { return touches[to_size(checked_tool_index(*this))]; }

TouchSpec& SceneSpec::tool() { return touches[to_size(checked_tool_index(*this))]; }

std::vector<TouchSpec> SceneSpec::supports() const {
  std::vector<TouchSpec> result;
  for (const TouchSpec& touch : touches)
    if (touch.is_support) result.push_back(touch);
  return result;
}

const TouchSpec& SceneSpec::touch(std::string_view frame) const {
  std::vector<std::string> frames;
  for (const TouchSpec& touch : touches) {
    if (touch.frame == frame) return touch;
    frames.push_back(touch.frame);
  }
  throw Error("the scene has no touch " + in_quotes(std::string(frame)) +
              did_you_mean(std::string(frame), frames));
}

SceneSpec checked_scene(const Model& model, const SceneSpec& scene) {
  for (const TouchSpec& touch : scene.touches) {
    check_touch(model, touch);
    if (&scene.touch(touch.frame) != &touch)
      throw Error("the scene has two touches with frame " + in_quotes(touch.frame) +
                  "; wanted another frame for each touch");
  }
  for (const SlipperyGround& ground : scene.slippery_ground) check_ground(scene, ground);
  check_ranges(description_of(&scene.hoist), &scene.hoist,
               [](const std::string& entry) { return "the hoist's " + entry; });
  if (!scene.hoist.frame.empty()) check_moves(model, scene.hoist.frame, "the hoist's");
  SceneSpec result = scene;
  for (TouchSpec& touch : result.touches) touch.surface.normal.normalize();
  return result;
}

double HoistSpec::load_fraction(double time) const noexcept {
  if (!holds() || time >= duration) return 0.0;
  const double s = std::clamp(2.0 * time / duration - 1.0, 0.0, 1.0);
  return 1.0 - s * s * (3.0 - 2.0 * s);
}

bool acts_at(double start, double duration, double time) noexcept {
  // Tolerance for rounding errors of `time`, which is computed as a multiple of the step [s].
  constexpr double rounding = 1e-9;
  const double now = time + rounding;
  return now >= start && now < start + duration;
}

double friction_under(const SceneSpec& scene, const TouchSpec& support, double time) noexcept {
  double friction = support.surface.friction;
  for (const SlipperyGround& ground : scene.slippery_ground)
    if ((ground.frame.empty() || ground.frame == support.frame) && acts_at(ground, time))
      friction = ground.friction;
  return friction;
}

TouchSpec with_surface_at(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                          const Eigen::Vector3d& normal, TouchSpec touch, double clearance) {
  touch.surface.normal = normal;
  touch = checked_scene(model, {.touches = {touch}}).touches.front();
  const Eigen::Vector3d p = surface_placement(model, q, touch.surface).inverse() *
                            frame_placement(model, q, touch.frame).translation();
  const double below = touch.is_rectangle() ? 0.0 : touch.radius;
  touch.surface.point = p - (below + clearance) * touch.surface.normal;
  return touch;
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

Eigen::Vector3d normal_at(const SurfaceSpec& surface, const Eigen::Vector3d& p) {
  return surface.shape.is_flat() ? surface.normal : surface_of(surface).at(p).normal;
}

double gap(const TouchSpec& touch, const Eigen::Vector3d& p) {
  const SurfaceSpec& surface = touch.surface;
  const double distance = surface.shape.is_flat() ? surface.normal.dot(p - surface.point)
                                                  : surface_of(surface).at(p).distance;
  return distance - touch.radius;
}

Eigen::Vector3d seen_from_surface(const SurfaceSpec& surface, const Eigen::Vector3d& p) {
  const Eigen::Matrix3d axes = Reference::surface_with_normal(surface.normal).rotation;
  return axes.transpose() * (p - surface.point);
}

bool is_over(const TouchSpec& touch, const Eigen::Vector3d& p, bool in_contact) {
  const double extent = touch.surface.extent;
  if (std::isinf(extent)) return true;
  const Eigen::Vector3d seen = seen_from_surface(touch.surface, p);
  if (!(std::abs(seen.x()) <= extent && std::abs(seen.y()) <= extent)) return false;
  return in_contact || gap(touch, p) > -touch.radius;
}

}  // namespace burnish
