// Geoms: mass and appearance.
#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "mjcf/reading.hpp"
#include "mjcf/solid.hpp"

namespace burnish::mjcf {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double negligible = 1e-14;        // Lengths [m] and masses [kg] up to this count as zero
constexpr double default_density = 1000.0;  // Default density of MJCF [kg/m^3]

/// A geom as the file states it.
struct GeomSource {
  const Item& item;
  std::string type;
  std::optional<Primitive> primitive;
  std::string mesh;
  Isometry3d placement = Isometry3d::Identity();  // Pose in the body's frame
  Solid solid;
  int group = 0;
  std::optional<double> mass;
  double density = default_density;
};

std::optional<Primitive> primitive_of(const std::string& type) {
  if (type == "sphere") return Primitive::Sphere;
  if (type == "capsule") return Primitive::Capsule;
  if (type == "cylinder") return Primitive::Cylinder;
  if (type == "ellipsoid") return Primitive::Ellipsoid;
  if (type == "box") return Primitive::Box;
  return std::nullopt;
}

std::string type_of(const Item& item) {
  std::string type = item.text("type").value_or("sphere");
  const std::vector<std::string> known = {"plane",    "hfield", "sphere", "capsule", "ellipsoid",
                                          "cylinder", "box",    "mesh",   "sdf"};
  if (std::find(known.begin(), known.end(), type) != known.end()) return type;
  refuse_at(item.xml(), "type " + in_quotes(type) + " is unknown" + did_you_mean(type, known));
}

/// Applies `fromto`, which states two end points instead of a placement and one size.
void take_ends(const std::vector<double>& ends, GeomSource& geom) {
  const Vector3d from(ends[0], ends[1], ends[2]), to(ends[3], ends[4], ends[5]);
  if (geom.primitive == Primitive::Sphere)
    refuse_at(geom.item.xml(),
              "a sphere has no fromto; wanted a capsule, cylinder, ellipsoid or box");
  const double half = 0.5 * (from - to).norm();
  if (half < negligible) refuse_at(geom.item.xml(), "fromto states two equal points");
  Vector3d& size = geom.solid.size;
  const bool round = geom.primitive == Primitive::Capsule || geom.primitive == Primitive::Cylinder;
  size = round ? Vector3d(size[0], half, 0.0) : Vector3d(size[0], size[0], half);
  geom.placement.translation() = 0.5 * (from + to);
  geom.placement.linear() = rotation_to(from - to);
}

void check_sizes(const GeomSource& geom) {
  const int count = *geom.primitive == Primitive::Sphere     ? 1
                    : *geom.primitive == Primitive::Capsule  ? 2
                    : *geom.primitive == Primitive::Cylinder ? 2
                                                             : 3;
  for (int i = 0; i < count; ++i)
    if (!(geom.solid.size[i] > 0.0))
      refuse_at(geom.item.xml(), "a " + geom.type + " needs " + std::to_string(count) +
                                     " positive sizes; size " + std::to_string(i + 1) + " is " +
                                     number(geom.solid.size[i]));
}

GeomSource state(const Item& item, const Isometry3d& around, const Compiler& compiler) {
  GeomSource geom{item, type_of(item),  std::nullopt, item.text("mesh").value_or(""), {}, {}, 0,
                  {},   default_density};
  geom.primitive = primitive_of(geom.type);
  geom.group = static_cast<int>(std::clamp(item.number("group", 0.0), -1e6, 1e6));
  if (item.stating("mass") != nullptr) geom.mass = item.number("mass", 0.0);
  geom.density = item.number("density", default_density);
  if (geom.mass.value_or(0.0) < 0.0 || geom.density < 0.0)
    refuse_at(item.xml(), "its mass or density is negative; wanted zero or more");
  const std::vector<double> size = item.overlaid("size", {0.0, 0.0, 0.0});
  geom.solid.size = Vector3d(size[0], size[1], size[2]);
  geom.solid.is_shell = item.flag("shellinertia", false);
  if (geom.primitive) geom.solid.kind = *geom.primitive;
  const auto ends = item.numbers("fromto", 6);
  if (ends && geom.primitive)
    take_ends(*ends, geom);
  else
    geom.placement = placement_of(item, compiler);
  geom.placement = around * geom.placement;
  if (geom.primitive && geom.mesh.empty()) check_sizes(geom);
  return geom;
}

MeshAsset* mesh_of(const GeomSource& geom, Reading& reading) {
  const auto found = reading.meshes.find(geom.mesh);
  if (found != reading.meshes.end()) return &found->second;
  std::vector<std::string> known;
  for (const auto& [name, mesh] : reading.meshes) known.push_back(name);
  refuse_at(geom.item.xml(),
            "mesh " + in_quotes(geom.mesh) + " does not exist" + did_you_mean(geom.mesh, known));
}

/// Reads the mesh's file, unless an earlier call has read it.
void open(MeshAsset& mesh, Reading& reading) {
  if (mesh.was_opened) return;
  mesh.was_opened = true;
  const auto file = reading.source.find(mesh.file);
  if (!file) return;
  reading.findings.attempt_or_warn(
      [&] {
        Triangles triangles = read_triangles(*file);
        const Isometry3d to_origin = mesh.reference.inverse();
        for (Vector3d& vertex : triangles.vertices)
          vertex = mesh.scale.cwiseProduct(to_origin * vertex);
        if (mesh.scale.prod() < 0.0)
          for (auto& face : triangles.faces) std::swap(face[1], face[2]);
        mesh.of_density_one = inertia_of(triangles, mesh.inertia, file->string());
      },
      "; the masses of its geoms are missing");
  if (mesh.is_hull)
    reading.warning_notes.note(
        "inertia of convex hulls is replaced by the inertia of the meshes themselves",
        example_of(*mesh.xml));
}

/// Returns mass and inertia in the geom's own frame; nothing if they are not available.
std::optional<InertiaSpec> weigh_mesh(const GeomSource& geom, bool warns, Reading& reading) {
  MeshAsset& mesh = *mesh_of(geom, reading);
  open(mesh, reading);
  if (!mesh.of_density_one) {
    if (!warns) return std::nullopt;
    if (mesh.file.empty())
      reading.warning_notes.note("bodies lack the masses of geoms whose mesh has no file",
                                 example_of(geom.item.xml()));
    else
      reading.warning_notes.note("bodies lack the masses of geoms whose mesh file is absent",
                                 example_of(geom.item.xml()) + ", file " + in_quotes(mesh.file));
    return std::nullopt;
  }
  InertiaSpec body = *mesh.of_density_one;
  const double mass = geom.mass.value_or(geom.density * body.mass);
  body.inertia_at_com *= mass / body.mass;
  body.mass = mass;
  return body;
}

std::optional<InertiaSpec> weigh(const GeomSource& geom, bool warns, Reading& reading) {
  if (geom.mass ? *geom.mass == 0.0 : geom.density == 0.0) return std::nullopt;
  if (geom.type == "plane" || geom.type == "hfield") return std::nullopt;
  std::optional<InertiaSpec> body;
  if (geom.type == "mesh") {
    body = weigh_mesh(geom, warns, reading);
  } else if (!geom.primitive || !geom.mesh.empty()) {
    if (!warns) return std::nullopt;
    reading.warning_notes.note(
        "bodies lack the masses of geoms that are fitted to a mesh or made by a plugin",
        example_of(geom.item.xml()));
  } else {
    body = InertiaSpec{};
    body->mass = geom.mass.value_or(geom.density * extent_of(geom.solid));
    body->inertia_at_com = (body->mass * moments_over_mass(geom.solid)).asDiagonal();
  }
  if (!body || body->mass <= negligible) return std::nullopt;
  const Eigen::Matrix3d turned =
      geom.placement.linear() * body->inertia_at_com * geom.placement.linear().transpose();
  body->com = geom.placement * body->com;
  body->inertia_at_com = 0.5 * (turned + turned.transpose());
  return body;
}

/// Returns the geom's own colour, or its material's colour if the geom has the default grey.
Eigen::Vector4d colour_of(const GeomSource& geom, const Reading& reading) {
  const Eigen::Vector4d grey(0.5, 0.5, 0.5, 1.0);
  Eigen::Vector4d own = grey;
  if (const auto rgba = geom.item.numbers("rgba", 4))
    own = Eigen::Vector4d((*rgba)[0], (*rgba)[1], (*rgba)[2], (*rgba)[3]);
  if (own != grey) return own;
  const auto material = reading.colours.find(geom.item.text("material").value_or(""));
  return material == reading.colours.end() ? own : material->second;
}

void draw_capsule(double radius, double half, const VisualSpec& like,
                  std::vector<VisualSpec>& visuals) {
  VisualSpec solid = like;
  solid.shape = CylinderShape{radius, 2.0 * half};
  visuals.push_back(solid);
  for (const double end : {-half, half}) {
    solid.shape = SphereShape{radius};
    solid.placement = like.placement * Eigen::Translation3d(0.0, 0.0, end);
    visuals.push_back(solid);
  }
}

/// Draws an ellipsoid as a capsule along its longest axis, with the mean of its other two radii.
void draw_ellipsoid(const Vector3d& size, VisualSpec visual, std::vector<VisualSpec>& visuals) {
  int longest_axis = 0;
  size.maxCoeff(&longest_axis);
  const double radius = 0.5 * (size.sum() - size[longest_axis]);
  visual.placement.linear() *= rotation_to(Vector3d::Unit(longest_axis));
  draw_capsule(radius, std::max(size[longest_axis] - radius, 0.0), visual, visuals);
}

void draw_mesh(const GeomSource& geom, VisualSpec visual, Reading& reading,
               std::vector<VisualSpec>& visuals) {
  const MeshAsset& mesh = *mesh_of(geom, reading);
  if (mesh.file.empty()) return;
  visual.shape = MeshShape{mesh.file, mesh.scale};
  // MuJoCo moves the mesh to the origin, then scales it; a MeshShape is scaled first. Both orders
  // agree unless a rotated mesh has different scales along its axes.
  Isometry3d back = mesh.reference.inverse();
  back.translation() = mesh.scale.cwiseProduct(back.translation());
  visual.placement = visual.placement * back;
  visuals.push_back(visual);
}

std::vector<VisualSpec> visuals_of(const GeomSource& geom, Reading& reading) {
  std::vector<VisualSpec> visuals;
  VisualSpec visual;
  visual.placement = geom.placement;
  visual.rgba = colour_of(geom, reading);
  if (visual.rgba[3] <= 0.0) return visuals;
  const Vector3d& size = geom.solid.size;
  if (geom.type == "mesh") {
    draw_mesh(geom, visual, reading, visuals);
    return visuals;
  }
  if (!geom.primitive || !geom.mesh.empty()) return visuals;
  switch (*geom.primitive) {
    case Primitive::Sphere:
      visual.shape = SphereShape{size[0]};
      break;
    case Primitive::Cylinder:
      visual.shape = CylinderShape{size[0], 2.0 * size[1]};
      break;
    case Primitive::Box:
      visual.shape = BoxShape{2.0 * size};
      break;
    case Primitive::Capsule:
      draw_capsule(size[0], size[1], visual, visuals);
      return visuals;
    case Primitive::Ellipsoid:
      draw_ellipsoid(size, visual, visuals);
      return visuals;
  }
  visuals.push_back(visual);
  return visuals;
}

}  // namespace

InertiaSpec read_geoms(const std::vector<Geom>& geoms, std::size_t link, Weigh how,
                       Reading& reading) {
  InertiaSpec sum;
  for (const Geom& one : geoms) {
    reading.findings.attempt([&] {
      const Compiler& compiler = reading.compiler_of(one.item->xml());
      const GeomSource geom = state(*one.item, one.around, compiler);
      for (VisualSpec& visual : visuals_of(geom, reading))
        reading.drawn.push_back({link, geom.group, std::move(visual)});
      const bool weighs = how != Weigh::No && geom.group >= compiler.first_group &&
                          geom.group <= compiler.last_group;
      const auto body = weighs ? weigh(geom, how == Weigh::Yes, reading) : std::nullopt;
      if (body) sum = together(sum, *body);
    });
  }
  return sum;
}

}  // namespace burnish::mjcf
