#include "files/read_parts.hpp"

#include <limits>

#include "burnish/dynamics/placement.hpp"
#include "contact/descriptions.gen.hpp"
#include "document/described.hpp"
#include "robots/known_robots.hpp"

namespace burnish::files {
namespace {

namespace fs = std::filesystem;

/// Returns folder/name if `name` is a path of a robot and exists there. Otherwise returns `name`.
std::string locate(const std::string& name, const fs::path& folder) {
  const std::string bare = name.substr(0, name.rfind(':'));
  if (!is_robot_path(name) && !is_robot_path(bare)) return name;
  std::error_code ignored;
  const fs::path here = beside(folder, name);
  return fs::exists(here, ignored) || fs::exists(beside(folder, bare), ignored) ? here.string()
                                                                                : name;
}

Vector6 read_gains(const Reader& reader) {
  if (reader.is_list()) return reader.numbers(6);
  return Vector6::Constant(reader.number());
}

}  // namespace

RobotOverrides read_overrides(const Reader& reader) {
  RobotOverrides overrides;
  if (const auto base = reader.find("base"))
    overrides.base = base->word({"fixed", "free_flyer"}) == "fixed" ? Base::Fixed : Base::FreeFlyer;
  if (const auto lock = reader.find("lock")) overrides.locked = lock->texts();
  if (const auto free = reader.find("free")) overrides.free = free->texts();
  if (const auto posture = reader.find("lock_posture")) overrides.posture = posture->text();
  if (const auto strict = reader.find("strict")) overrides.strict = strict->yes_or_no();
  return overrides;
}

std::string robot_name(const Reader& reader, const fs::path& folder) {
  if (!reader.is_map()) return locate(reader.text(), folder);
  std::string name = locate(reader["name"].text(), folder);
  if (const auto variant = reader.find("variant")) name += ":" + variant->text();
  return name;
}

Robot read_robot(const Reader& reader, const fs::path& folder, const RobotOverrides& overrides) {
  if (!reader.is_map())
    return reader.named([&] { return load_robot(locate(reader.text(), folder), overrides); });
  reader.allow_only({"name", "variant", "base", "lock", "free", "lock_posture", "strict"});
  const std::string name = robot_name(reader, folder);
  return reader.named([&] { return load_robot(name, read_overrides(reader)); });
}

std::vector<std::pair<std::string, Reader>> contacts_in(const Reader& reader) {
  if (!reader.is_list()) return reader.items();
  std::vector<std::pair<std::string, Reader>> contacts;
  for (const Reader& entry : reader.entries()) contacts.emplace_back("", entry);
  return contacts;
}

ContactSpec read_contact(const std::string& name, const Reader& reader, const Model& model,
                         const Eigen::VectorXd& q, const fs::path* tables) {
  std::vector<std::string> keys{"tool",  "base", "reference", "directions", "acceleration",
                                "error", "kp",   "kd",        "target",     "friction"};
  if (name.empty()) keys.emplace_back("name");
  if (tables != nullptr) keys.emplace_back("surface_input");
  reader.allow_only(keys);
  ContactSpec spec{.name = name, .tool = reader["tool"].text()};
  if (const auto own = reader.find("name")) spec.name = own->text();
  const auto placed = [&](const Reader& frame) {
    return frame.named([&] { return frame_placement(model, q, frame.text()); });
  };
  const Eigen::Isometry3d tool = placed(reader["tool"]);
  Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
  if (const auto other = reader.find("base")) {
    spec.base = other->text();
    base = placed(*other);
  }
  if (const auto reference = reader.find("reference"))
    spec.reference = read_reference(*reference, Reference::centered(), tables);
  if (const auto directions = reader.find("directions"))
    spec.directions = read_directions(*directions);
  if (const auto kind = reader.find("acceleration"))
    spec.acceleration = kind->named([&] { return parse_acceleration(kind->text()); });
  if (const auto kind = reader.find("error"))
    spec.error = kind->named([&] { return parse_pose_error(kind->text()); });
  if (const auto kp = reader.find("kp")) spec.kp = read_gains(*kp);
  if (const auto kd = reader.find("kd")) spec.kd = read_gains(*kd);
  if (const auto friction = reader.find("friction")) {
    document::read_described(description_of(&spec.friction.emplace()), &*spec.friction, *friction);
    if (const auto input = friction->find("coefficient_input"); input && tables == nullptr)
      input->refuse("only optimal control problems have inputs; wanted no such key");
  }
  const auto target = reader.find("target");
  spec.target = target && !target->is("here") ? read_placement(*target) : base.inverse() * tool;
  return spec;
}

ContactSolver read_contact_solver(const Reader& reader) {
  reader.allow_only({"mu", "max_proximal_iterations", "proximal_tolerance"});
  ContactSolver solver;
  if (const auto mu = reader.find("mu")) solver.mu = mu->not_negative();
  if (const auto iterations = reader.find("max_proximal_iterations"))
    solver.max_proximal_iterations = iterations->count(0, 10'000);
  if (const auto tolerance = reader.find("proximal_tolerance"))
    solver.proximal_tolerance = tolerance->not_negative();
  return solver;
}

ActuationSpec read_actuation(const Reader& reader, const Model& model) {
  reader.allow_only({"joints", "passive_torques", "slip_velocity"});
  ActuationSpec actuation;
  if (const auto joints = reader.find("joints")) {
    actuation.joints = joints->texts();
    for (const std::string& joint : actuation.joints)
      joints->named([&] { model.joint_index(joint); });
  }
  if (const auto passive = reader.find("passive_torques"))
    actuation.passive_torques = passive->yes_or_no();
  if (const auto slip = reader.find("slip_velocity")) actuation.slip_velocity = slip->positive();
  return actuation;
}

TorqueModel read_torque_model(const Reader& reader) {
  if (!reader.is_map()) {
    reader.word({"held"});
    return TorqueModel::held();
  }
  reader.allow_only({"cutoff", "discretization"});
  TorqueModel model{.cutoff = reader["cutoff"].positive()};
  if (const auto kind = reader.find("discretization"))
    model.discretization = kind->word({"exact", "euler"}) == "exact"
                               ? TorqueModel::Discretization::Exact
                               : TorqueModel::Discretization::Euler;
  return model;
}

void read_bounds(const Reader& reader, const ProblemScope& scope, ProblemSpec& spec) {
  std::vector<RowGroup> rows;
  Eigen::VectorXd effort(scope.controls());
  int row = 0;
  for (const Joint* joint : scope.driven()) {
    rows.push_back({joint->name, joint->nv});
    for (int k = 0; k < joint->nv; ++k)
      effort[row++] = scope.model().effort_limit[joint->v_index + k];
  }
  if (reader.is("effort_limits")) {
    spec.control_upper = effort;
    spec.control_lower = -effort;
    return;
  }
  reader.allow_only({"effort_limits", "lower", "upper"});
  if (const auto fraction = reader.find("effort_limits")) {
    spec.control_upper = fraction->positive() * effort;
    spec.control_lower = -spec.control_upper;
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (const auto lower = reader.find("lower"))
    spec.control_lower = read_rows(*lower, rows, -infinity);
  if (const auto upper = reader.find("upper"))
    spec.control_upper = read_rows(*upper, rows, infinity);
}

}  // namespace burnish::files
