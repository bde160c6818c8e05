#include "pressing/foot_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/to_size.hpp"

namespace burnish::pressing {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Returns points of a solid, among them the lowest ones [m]: the corners of a box, 16 points on
/// each rim of a cylinder, the lowest point of a sphere. Empty for meshes.
std::vector<Eigen::Vector3d> low_points(const Shape& shape, const Eigen::Isometry3d& at) {
  std::vector<Eigen::Vector3d> points;
  if (const auto* box = std::get_if<BoxShape>(&shape)) {
    for (int corner = 0; corner < 8; ++corner) {
      Eigen::Vector3d p = 0.5 * box->size;
      for (int k = 0; k < 3; ++k)
        if ((corner >> k & 1) != 0) p[k] = -p[k];
      points.emplace_back(at * p);
    }
  } else if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) {
    constexpr int rim_points = 16;
    for (int i = 0; i < rim_points; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / rim_points;
      for (const double end : {-0.5, 0.5})
        points.emplace_back(at * Eigen::Vector3d(cylinder->radius * std::cos(angle),
                                                 cylinder->radius * std::sin(angle),
                                                 end * cylinder->length));
    }
  } else if (const auto* sphere = std::get_if<SphereShape>(&shape)) {
    points.emplace_back(at.translation() - sphere->radius * Eigen::Vector3d::UnitZ());
  }
  return points;
}

}  // namespace

std::vector<Visual> solids_of(const Robot& robot, const std::vector<int>& bodies) {
  std::vector<Visual> solids;
  for (const auto* list : {&robot.collisions, &robot.model.visuals}) {
    for (const Visual& solid : *list)
      if (std::find(bodies.begin(), bodies.end(), solid.body) != bodies.end() &&
          !std::holds_alternative<MeshShape>(solid.shape))
        solids.push_back(solid);
    if (!solids.empty()) break;
  }
  return solids;
}

bool turns_freely(const Model& model, int body) {
  const auto joint = [&](int i) -> const Joint& { return model.joints[to_size(i)]; };
  if (body < 0 || joint(body).kind != JointKind::Continuous) return false;
  for (int at = joint(body).parent; at >= 0; at = joint(at).parent)
    if (joint(at).kind == JointKind::Revolute) return true;
  return false;
}

double lowest_of(const Shape& shape, const Eigen::Isometry3d& in_axes) {
  double lowest = infinity;
  for (const Eigen::Vector3d& p : low_points(shape, in_axes)) lowest = std::min(lowest, p.z());
  return lowest;
}

std::optional<SoleShape> sole_of(const std::vector<PlacedShape>& solids, double min_side) {
  // Height difference within which points count as level [m]. Edges of real soles are rounded, and
  // spheres at the corners of a foot differ in height by up to 6 mm.
  constexpr double level = 0.006;
  std::vector<Eigen::Vector3d> points;
  double ground = infinity;
  for (const PlacedShape& solid : solids)
    for (const Eigen::Vector3d& p : low_points(solid.shape, solid.at)) {
      points.push_back(p);
      ground = std::min(ground, p.z());
    }
  Eigen::AlignedBox2d spanned;
  for (const Eigen::Vector3d& p : points)
    if (p.z() < ground + level) spanned.extend(p.head<2>());
  if (spanned.isEmpty() || spanned.sizes().minCoeff() < min_side) return std::nullopt;
  const Eigen::Vector2d centre = spanned.center(), half = 0.5 * spanned.sizes();
  return SoleShape{{centre.x(), centre.y(), ground}, half.x(), half.y()};
}

std::optional<BallShape> ball_of(const std::vector<PlacedShape>& solids) {
  std::optional<BallShape> ball;
  double lowest = infinity;
  for (const PlacedShape& solid : solids) {
    const double low = lowest_of(solid.shape, solid.at);
    if (low >= lowest) continue;
    lowest = low;
    const auto* sphere = std::get_if<SphereShape>(&solid.shape);
    if (sphere == nullptr)
      ball.reset();
    else
      ball = BallShape{solid.at.translation(), sphere->radius};
  }
  return ball;
}

Eigen::Vector3d box_of(double mass, const Eigen::Matrix3d& inertia) {
  if (!(mass > 0.0)) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d moments = inertia.diagonal();
  const Eigen::Vector3d squares =
      6.0 / mass * (Eigen::Vector3d::Constant(moments.sum()) - 2.0 * moments);
  return squares.cwiseMax(0.0).cwiseSqrt();
}

}  // namespace burnish::pressing
