#include "show_json.hpp"

#include <cmath>

#include "base/to_size.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/dynamics/placement.hpp"
#include "record/json_text.hpp"

namespace burnish::app {
namespace {

Json follows_json(const Model& model, const Joint& joint) {
  if (!joint.follows) return nullptr;
  const Following& follows = *joint.follows;
  return {{"leader", model.joints[to_size(follows.leader)].name},
          {"multiplier", follows.multiplier},
          {"offset", follows.offset}};
}

Json joint_json(const Model& model, const Joint& joint) {
  const int q = joint.q_index, v = joint.v_index;
  return {
      {"name", joint.name},
      {"kind", std::string(name_of(joint.kind))},
      {"parent", joint.parent < 0 ? Json("world") : Json(model.joints[to_size(joint.parent)].name)},
      {"q_index", q},
      {"nq", joint.nq},
      {"v_index", v},
      {"nv", joint.nv},
      {"follows", follows_json(model, joint)},
      {"lower", numbers_json(model.q_lower.segment(q, joint.nq))},
      {"upper", numbers_json(model.q_upper.segment(q, joint.nq))},
      {"velocity_limit", numbers_json(model.velocity_limit.segment(v, joint.nv))},
      {"effort_limit", numbers_json(model.effort_limit.segment(v, joint.nv))},
      {"damping", numbers_json(model.damping.segment(v, joint.nv))},
      {"friction", numbers_json(model.friction.segment(v, joint.nv))},
      {"armature", numbers_json(model.armature.segment(v, joint.nv))},
      {"stiffness", numbers_json(model.stiffness.segment(v, joint.nv))},
      {"spring_rest", numbers_json(model.spring_rest.segment(v, joint.nv))},
      {"mass", joint.mass},
      {"com", numbers_json(joint.com)}};
}

Json names_json(const Directions& directions) {
  Json names = Json::array();
  for (int d = 0; d < 6; ++d)
    if (directions.has(d)) names.push_back(direction_names[to_size(d)]);
  return names;
}

Json loops_json(const Model& model, const LoopFreedom& freedom) {
  Json loops = Json::array();
  for (const Loop& loop : model.loops) {
    Directions redundant;
    for (const auto& of : freedom.redundant)
      if (of.loop == loop.name) redundant = of.directions;
    loops.push_back({{"name", loop.name},
                     {"first", loop.first},
                     {"second", loop.second},
                     {"directions", names_json(loop.directions)},
                     {"redundant", names_json(redundant)}});
  }
  return loops;
}

Json loop_json(const LoopMargins& loop) {
  Json gains = Json::array();
  for (const GainRange& gain : loop.gains)
    gains.push_back({{"joint", gain.joint}, {"below", gain.below}, {"above", gain.above}});
  return {{"delay", loop.delay}, {"bandwidth", loop.bandwidth}, {"gains", gains}};
}

}  // namespace

Json margins_json(const polishing::TaskMargins& margins, const std::string& tool,
                  const std::string& fitted) {
  return {{"tool", tool},
          {"surface", "table"},
          {"fitted", fitted},
          {"delay", margins.delay()},
          {"max_delay", LoopAnalysis::max_delay},
          {"air", loop_json(margins.air)},
          {"contact", loop_json(margins.contact)}};
}

std::string kind_text(FrameKind kind) {
  switch (kind) {
    case FrameKind::Link:
      return "link";
    case FrameKind::Joint:
      return "joint";
    case FrameKind::User:
      return "added";
  }
  return "unknown";
}

Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& R) {
  const double pitch = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)));
  // Gimbal lock: roll and yaw turn about the same axis. The yaw is chosen as zero.
  if (std::hypot(R(0, 0), R(1, 0)) < 1e-9) {
    return {std::atan2(-R(1, 2), R(1, 1)), pitch, 0.0};
  }
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

Json show_json(const Robot& robot, const Eigen::VectorXd& q, const std::string& posture) {
  const Model& model = robot.model;
  Json result{{"name", model.name},
              {"nq", model.nq},
              {"nv", model.nv},
              {"total_mass", model.total_mass()},
              {"gravity", numbers_json(model.gravity)},
              {"locked_joints", model.locked_joints},
              {"warnings", robot.warnings},
              {"notes", robot.notes},
              {"joints", Json::array()},
              {"frames", Json::array()},
              {"postures", Json::object()},
              {"default_posture", robot.default_posture},
              {"shown_posture", posture},
              {"q", numbers_json(q)}};
  for (const Joint& joint : model.joints) result["joints"].push_back(joint_json(model, joint));
  const std::vector<Eigen::Isometry3d> placements = frame_placements(model, q);
  for (std::size_t i = 0; i < model.frames.size(); ++i) {
    const Frame& frame = model.frames[i];
    Json entry{{"name", frame.name},
               {"kind", kind_text(frame.kind)},
               {"moved_by",
                frame.body < 0 ? Json(nullptr) : Json(model.joints[to_size(frame.body)].name)}};
    entry.update(placement_json(placements[i]));
    result["frames"].push_back(entry);
  }
  if (!model.loops.empty()) {
    const LoopFreedom freedom = loop_freedom(model, q);
    result["loops"] = loops_json(model, freedom);
    result["loop_rows"] = freedom.rows;
    result["loop_rank"] = freedom.rank;
    result["degrees_of_freedom"] = freedom.freedom;
  }
  for (const auto& [name, values] : robot.postures) result["postures"][name] = values;
  return result;
}

}  // namespace burnish::app
