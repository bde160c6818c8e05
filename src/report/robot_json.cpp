#include <map>

#include "report/json_writer.hpp"
#include "report/run_page.hpp"

namespace burnish {
namespace {

std::string file_name(const std::string& uri) {
  return uri.substr(uri.find_last_of("/\\") + 1);  // npos + 1 is 0
}

/// Limits of joints of one entry; null where there is none.
void write_joint(JsonWriter& json, const Model& model, const Joint& joint) {
  const bool single = joint.nv == 1, bounded = joint.nq == 1;
  json.begin_object();
  json.field("name", joint.name);
  json.field("kind", name_of(joint.kind));
  json.field("q_index", joint.q_index);
  json.field("nq", joint.nq);
  const auto limit = [&](const char* name, bool has, const Eigen::VectorXd& all, int at) {
    json.key(name);
    has ? json.value(all[at]) : json.null();
  };
  limit("lower", bounded, model.q_lower, joint.q_index);
  limit("upper", bounded, model.q_upper, joint.q_index);
  limit("effort", single, model.effort_limit, joint.v_index);
  limit("velocity", single, model.velocity_limit, joint.v_index);
  json.key("follows");
  if (joint.follows) {
    json.begin_object();
    json.field("leader", joint.follows->leader);
    json.field("multiplier", joint.follows->multiplier);
    json.field("offset", joint.follows->offset);
    json.end_object();
  } else {
    json.null();
  }
  json.end_object();
}

void write_body(JsonWriter& json, const Model& model, const Joint& joint) {
  const Eigen::Matrix3d& I = joint.inertia_at_com;
  json.begin_object();
  json.field("name", joint.name);
  json.field("parent", joint.parent);
  json.key("joint");
  write_joint(json, model, joint);
  json.field("placement", joint.placement);
  json.field("mass", joint.mass);
  json.field("com", joint.com);
  json.field(
      "inertia",
      (Eigen::VectorXd(6) << I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)).finished());
  json.end_object();
}

/// Writes the members of a shape.
struct ShapeWriter {
  JsonWriter& json;
  const RobotDrawing& robot;

  void operator()(const BoxShape& box) const {
    json.field("kind", "box");
    json.field("size", box.size);
  }
  void operator()(const CylinderShape& cylinder) const {
    json.field("kind", "cylinder");
    json.field("radius", cylinder.radius);
    json.field("length", cylinder.length);
  }
  void operator()(const SphereShape& sphere) const {
    json.field("kind", "sphere");
    json.field("radius", sphere.radius);
  }
  void operator()(const MeshShape& shape) const {
    json.field("kind", "mesh");
    json.field("name", file_name(shape.uri));
    const auto found = robot.meshes.find(shape.uri);
    if (found == robot.meshes.end()) return;
    std::vector<float> vertices = found->second.vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      vertices[i] *= static_cast<float>(shape.scale[static_cast<Eigen::Index>(i % 3)]);
    json.key("vertices");
    json.floats(vertices);
    json.key("triangles");
    json.integers(found->second.triangles);
  }
};

void write_visual(JsonWriter& json, const RobotDrawing& robot, const Visual& visual) {
  json.begin_object();
  json.field("body", visual.body);
  json.field("link", visual.link);
  json.field("placement", visual.placement);
  json.field("rgba", visual.rgba);
  json.key("shape");
  json.begin_object();
  std::visit(ShapeWriter{json, robot}, visual.shape);
  json.end_object();
  json.end_object();
}

const char* kind_name(FrameKind kind) {
  constexpr const char* names[] = {"link", "joint", "user"};
  return names[static_cast<int>(kind)];
}

void write_frame(JsonWriter& json, const Frame& frame) {
  json.begin_object();
  json.field("name", frame.name);
  json.field("kind", kind_name(frame.kind));
  json.field("body", frame.body);
  json.field("placement", frame.placement);
  json.end_object();
}

/// A list of what `write` writes of each.
template <class List, class Write>
void write_list(JsonWriter& json, const char* name, const List& list, Write&& write) {
  json.key(name);
  json.begin_array();
  for (const auto& entry : list) write(entry);
  json.end_array();
}

}  // namespace

std::string robot_json(const RobotDrawing& robot) {
  const Model& model = robot.model;
  JsonWriter json;
  json.begin_object();
  json.field("name", model.name);
  write_list(json, "moving", model.joints, [&](const Joint& joint) {
    if (!joint.follows) json.value(joint.name);
  });
  write_list(json, "bodies", model.joints,
             [&](const Joint& joint) { write_body(json, model, joint); });
  json.field("nq", model.nq);
  json.field("q", robot.q.size() == model.nq ? robot.q : model.q_neutral);
  write_list(json, "visuals", model.visuals,
             [&](const Visual& visual) { write_visual(json, robot, visual); });
  write_list(json, "frames", model.frames, [&](const Frame& frame) { write_frame(json, frame); });
  write_list(json, "postures", robot.postures, [&](const auto& posture) {
    json.begin_object();
    json.field("name", posture.first);
    json.field("q", posture.second);
    json.end_object();
  });
  json.field("gravity", model.gravity);
  json.field("total_mass", model.total_mass());
  json.end_object();
  return json.take();
}

std::vector<std::string> missing_meshes(const RobotDrawing& robot) {
  std::map<std::string, bool> names;  // each once, by name
  for (const Visual& visual : robot.model.visuals)
    if (const auto* mesh = std::get_if<MeshShape>(&visual.shape))
      if (!robot.meshes.contains(mesh->uri)) names[file_name(mesh->uri)] = true;
  std::vector<std::string> result;
  for (const auto& [name, missing] : names) result.push_back(name);
  return result;
}

}  // namespace burnish
