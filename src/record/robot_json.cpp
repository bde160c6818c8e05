#include <set>

#include "record/page_json.hpp"

namespace burnish {
namespace {

std::string file_name(const std::string& uri) {
  return uri.substr(uri.find_last_of("/\\") + 1);  // without a slash: npos + 1 is 0
}

/// Returns a joint with its limits; limits of joints with several entries are null.
Json joint_json(const Model& model, const Joint& joint) {
  const bool single = joint.nv == 1, bounded = joint.nq == 1;
  Json json{{"name", joint.name},
            {"kind", name_of(joint.kind)},
            {"q_index", joint.q_index},
            {"nq", joint.nq},
            {"lower", bounded ? number_json(model.q_lower[joint.q_index]) : Json()},
            {"upper", bounded ? number_json(model.q_upper[joint.q_index]) : Json()},
            {"effort", single ? number_json(model.effort_limit[joint.v_index]) : Json()},
            {"velocity", single ? number_json(model.velocity_limit[joint.v_index]) : Json()},
            {"follows", nullptr}};
  if (joint.follows)
    json["follows"] = {{"leader", joint.follows->leader},
                       {"multiplier", joint.follows->multiplier},
                       {"offset", joint.follows->offset}};
  return json;
}

Json body_json(const Model& model, const Joint& joint) {
  const Eigen::Matrix3d& I = joint.inertia_at_com;
  return {{"name", joint.name},
          {"parent", joint.parent},
          {"joint", joint_json(model, joint)},
          {"placement", pose_json(joint.placement)},
          {"mass", number_json(joint.mass)},
          {"com", numbers_json(joint.com)},
          {"inertia", {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)}}};
}

struct ShapeJson {
  const RobotDrawing& robot;

  Json operator()(const BoxShape& box) const {
    return {{"kind", "box"}, {"size", numbers_json(box.size)}};
  }
  Json operator()(const CylinderShape& cylinder) const {
    return {{"kind", "cylinder"}, {"radius", cylinder.radius}, {"length", cylinder.length}};
  }
  Json operator()(const SphereShape& sphere) const {
    return {{"kind", "sphere"}, {"radius", sphere.radius}};
  }
  Json operator()(const MeshShape& shape) const {
    Json json{{"kind", "mesh"}, {"name", file_name(shape.uri)}};
    const auto found = robot.meshes.find(shape.uri);
    if (found == robot.meshes.end()) return json;
    std::vector<float> vertices = found->second.vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      vertices[i] *= static_cast<float>(shape.scale[static_cast<Eigen::Index>(i % 3)]);
    json["vertices"] = packed_json(vertices);
    json["triangles"] = packed_json(found->second.triangles);
    return json;
  }
};

const char* kind_name(FrameKind kind) {
  constexpr const char* names[] = {"link", "joint", "user"};
  return names[static_cast<int>(kind)];
}

}  // namespace

Json robot_json(const RobotDrawing& robot) {
  const Model& model = robot.model;
  Json json{{"name", model.name}, {"moving", Json::array()}, {"bodies", Json::array()}};
  for (const Joint& joint : model.joints) {
    if (!joint.follows) json["moving"].push_back(joint.name);
    json["bodies"].push_back(body_json(model, joint));
  }
  json["nq"] = model.nq;
  json["q"] = numbers_json(robot.q.size() == model.nq ? robot.q : model.q_neutral);
  json["visuals"] = Json::array();
  for (const Visual& visual : model.visuals)
    json["visuals"].push_back({{"body", visual.body},
                               {"link", visual.link},
                               {"placement", pose_json(visual.placement)},
                               {"rgba", numbers_json(visual.rgba)},
                               {"shape", std::visit(ShapeJson{robot}, visual.shape)}});
  json["frames"] = Json::array();
  for (const Frame& frame : model.frames)
    json["frames"].push_back({{"name", frame.name},
                              {"kind", kind_name(frame.kind)},
                              {"body", frame.body},
                              {"placement", pose_json(frame.placement)}});
  json["postures"] = Json::array();
  for (const auto& [name, q] : robot.postures)
    json["postures"].push_back({{"name", name}, {"q", numbers_json(q)}});
  json["gravity"] = numbers_json(model.gravity);
  json["total_mass"] = model.total_mass();
  return json;
}

std::vector<std::string> missing_meshes(const RobotDrawing& robot) {
  std::set<std::string> names;
  for (const Visual& visual : robot.model.visuals)
    if (const auto* mesh = std::get_if<MeshShape>(&visual.shape))
      if (!robot.meshes.contains(mesh->uri)) names.insert(file_name(mesh->uri));
  return {names.begin(), names.end()};
}

}  // namespace burnish
