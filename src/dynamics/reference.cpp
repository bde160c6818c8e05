#include "burnish/dynamics/reference.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "dynamics/reference.hpp"

namespace burnish {
namespace {
constexpr const char* moves_with_tool =
    "the curved surface of the reference is fixed to the tool itself; wanted a surface fixed to "
    "the base, to the world or to another frame";
}  // namespace

Anchor Anchor::parse(const std::string& text) {
  if (text == "tool") return Tool;
  if (text == "base") return Base;
  if (text == "world") return World;
  if (text.starts_with("frame ")) return text.substr(6);
  return text;
}

std::string Anchor::text() const {
  switch (kind) {
    case Tool:
      return "tool";
    case Base:
      return "base";
    case World:
      return "world";
    case Frame:
      break;
  }
  const bool means_another = parse(frame) != Anchor(frame);
  return means_another ? "frame " + frame : frame;
}

Reference Reference::local(const Eigen::Matrix3d& rotation) {
  return {Anchor::Tool, Anchor::Tool, rotation};
}
Reference Reference::centered(const Eigen::Matrix3d& rotation) {
  return {Anchor::Tool, Anchor::World, rotation};
}
Reference Reference::surface(const Eigen::Matrix3d& rotation) {
  return {Anchor::Tool, Anchor::Base, rotation};
}
Reference Reference::world(const Eigen::Matrix3d& rotation) {
  return {Anchor::World, Anchor::World, rotation};
}

Reference Reference::surface_with_normal(const Eigen::Vector3d& normal) {
  if (!normal.allFinite() || normal.norm() < 1e-9)
    throw Error("surface_with_normal: the normal must be finite and not zero");
  const Eigen::Vector3d z = normal.normalized();
  // x is a horizontal tangent. On a horizontal surface, x is the projection of the world's x axis.
  Eigen::Vector3d x = Eigen::Vector3d::UnitZ().cross(z);
  if (x.norm() < 1e-6) {
    x = Eigen::Vector3d::UnitX() - z * z.x();
  }
  x.normalize();
  Eigen::Matrix3d rotation;
  rotation << x, z.cross(x), z;
  return surface(rotation);
}

Reference Reference::on(const Quadric& surface, const Eigen::Vector3d& near) {
  surface.check("on");
  Reference result = surface_with_normal(surface.normal(near));
  result.quadric = surface;
  return result;
}

Reference Reference::on(const Quadric& surface, const Eigen::Vector3d& near,
                        const Eigen::Vector3d& along) {
  Reference result = on(surface, near);
  const Eigen::Vector3d n = result.rotation.col(2);
  const Eigen::Vector3d tangent = along - n.dot(along) * n;
  if (!along.allFinite() || !(tangent.norm() > 1e-6 * along.norm()))
    throw Error("Reference::on: the direction [" + number(along.x()) + ", " + number(along.y()) +
                ", " + number(along.z()) +
                "] has no tangential part; wanted a direction that is not parallel to the normal");
  const Eigen::Vector3d x = tangent.normalized();
  result.rotation << x, n.cross(x), n;
  return result;
}

Reference Reference::at(const Eigen::Vector3d& point) const {
  if (!quadric) return *this;
  check("at");
  const Eigen::Vector3d n0 = rotation.col(2), n = quadric->normal(point);
  if (n0.dot(n) < -1.0 + 1e-9)
    throw Error("the surface's normal at [" + number(point.x()) + ", " + number(point.y()) + ", " +
                number(point.z()) +
                "] is opposite to the normal of the reference, so the smallest rotation between "
                "these normals is not unique");
  Reference result = *this;
  result.quadric.reset();
  result.rotation = Eigen::Quaterniond::FromTwoVectors(n0, n).toRotationMatrix() * rotation;
  return result;
}

std::string Reference::name() const {
  if (origin == Anchor::World && axes == Anchor::World) return "world";
  if (origin == Anchor::Tool && axes == Anchor::Tool) return "local";
  if (origin == Anchor::Tool && axes == Anchor::Base) return "surface";
  if (origin == Anchor::Tool && axes == Anchor::World) return "centered";
  const auto of = [](const Anchor& anchor) {
    return anchor.kind == Anchor::Frame ? anchor.text() : "the " + anchor.text();
  };
  return "axes of " + of(axes) + " at " + of(origin);
}

Reference Reference::parse(const std::string& name) {
  if (name == "local") return local();
  if (name == "centered") return centered();
  if (name == "surface") return surface(Eigen::Matrix3d::Identity());
  if (name == "world") return world();
  throw Error("reference: unknown name '" + name + "'; wanted local, centered, surface or world" +
              did_you_mean(name, {"local", "centered", "surface", "world"}));
}

void Reference::check(const std::string& who) const {
  if (!is_rotation(rotation))
    throw Error(who + ": the reference's rotation is not a rotation matrix");
  if (quadric) {
    quadric->check(who);
    if (axes == Anchor::Tool) throw Error(who + ": " + moves_with_tool);
    if (!rotation_over_time.empty())
      throw Error(
          who +
          ": the reference has a curved surface and a rotation over time; wanted one of them");
  }
  if (rotation_over_time.empty()) return;
  if (!rotation.isIdentity(0.0))
    throw Error(who +
                ": the reference has a rotation and a rotation over time; wanted one of them");
  if (rotation_over_time.depends_on_inputs())
    throw Error(
        who + ": the reference's rotation over time depends on inputs; wanted a function of time");
  if (rotation_over_time.size() != 4)
    throw Error(who + ": the reference's rotation over time has " +
                std::to_string(rotation_over_time.size()) +
                " entries; wanted a quaternion x, y, z, w");
}

Reference Reference::at(double time) const {
  if (rotation_over_time.empty()) return *this;
  check("at");
  Eigen::VectorXd xyzw(4);
  rotation_over_time.at(time, xyzw);
  if (!is_unit_quaternion(xyzw))
    throw Error("the reference's rotation has length " + number(xyzw.norm()) + " at " +
                number(time) + " s; wanted a quaternion of length 1");
  return {origin, axes, rotation_matrix(xyzw)};
}

Reference asked_for_positions(Reference reference) {
  if (reference.quadric && reference.origin == Anchor::Tool) reference.origin = reference.axes;
  return reference;
}

bool is_rotation(const Eigen::Matrix3d& matrix) {
  return (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).norm() <= 1e-6 &&
         matrix.determinant() > 0.0;
}
bool is_unit_quaternion(const ConstVectorRef& xyzw) { return std::abs(xyzw.norm() - 1.0) <= 1e-6; }
Eigen::Matrix3d rotation_matrix(const ConstVectorRef& xyzw) {
  const Eigen::Vector4d entries = xyzw;
  return Eigen::Quaterniond(entries).normalized().toRotationMatrix();
}

namespace {

struct Place {
  int body;
  Mat3<double> R;
  Vec3<double> p;
};

Place place_of(const Model& model, const Anchor& anchor, const CompiledFrame& tool,
               const CompiledFrame& base) {
  const auto place = [](const CompiledFrame& frame) { return Place{frame.body, frame.R, frame.p}; };
  const Place world = place(world_frame());
  return fixed_in(anchor, place(tool), place(base), world, [&](const std::string& name) {
    if (name == "world" && !model.has_frame(name)) return world;
    const Frame& frame = model.frames[to_size(model.frame_index(name))];
    return Place{frame.body, from_eigen(Eigen::Matrix3d(frame.placement.linear())),
                 from_eigen(Eigen::Vector3d(frame.placement.translation()))};
  });
}

bool is_same(const Vec3<double>& a, const Vec3<double>& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

}  // namespace

CompiledReference compile_reference(const Model& model, const Reference& reference,
                                    const CompiledFrame& tool, const CompiledFrame& base) {
  if (!reference.rotation_over_time.empty())
    throw Error(
        "the reference's rotation changes over time, which only optimal control problems support; "
        "wanted the reference at one time, from Reference::at");
  if (reference.quadric && reference.axes == Anchor::Tool)
    throw Error(std::string(moves_with_tool));
  const Place origin = place_of(model, reference.origin, tool, base);
  const Place axes = place_of(model, reference.axes, tool, base);
  CompiledReference result{};
  result.origin_body = origin.body;
  result.origin = origin.p;
  result.axes_body = axes.body;
  result.fixed_in = axes.R;
  result.axes = axes.R * from_eigen(reference.rotation);
  result.at_tool = origin.body == tool.body && is_same(origin.p, tool.p);
  result.at_world = origin.body < 0 && is_same(origin.p, Vec3<double>::zero());
  result.is_aligned = axes.body < 0 && to_eigen(result.axes).isIdentity(0.0);
  if (!reference.quadric) return result;
  result.is_curved = true;
  result.is_aligned = false;
  result.tool_body = tool.body;
  result.tool = tool.p;
  result.place = axes.p;
  result.Q = from_eigen(reference.quadric->Q);
  result.b = from_eigen(reference.quadric->b);
  result.c = reference.quadric->c;
  return result;
}

}  // namespace burnish
