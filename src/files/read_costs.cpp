#include "files/read_costs.hpp"

#include <cmath>
#include <functional>

#include "burnish/dynamics/placement.hpp"
#include "dynamics/frame.hpp"
#include "files/here.hpp"
#include "files/read_penalty.hpp"
#include "model/followers.hpp"
#include "ocp/friction_pyramid.hpp"

namespace burnish::files {
namespace {

/// A cost or a constraint on its way: what its keys say, and what its rows are.
struct CostReader {
  const ProblemScope& scope;
  const std::vector<std::string>& contacts;
  const Reader& reader;
  std::vector<std::string> common;  ///< keys beside those of the type
  PenaltyRows rows = {};

  const Model& model() const { return scope.model(); }

  void keys(std::vector<std::string> own) const {
    own.insert(own.end(), common.begin(), common.end());
    reader.allow_only(own);
  }

  Signal target(std::optional<Eigen::VectorXd> here,
                TargetSpace::Kind kind = TargetSpace::Kind::Plain,
                const std::optional<Eigen::Matrix3d>& offsets = {}) const {
    const auto given = reader.find("target");
    if (!given) return {};
    std::vector<RowGroup> groups = rows.rows;
    if (kind == TargetSpace::Kind::Rotation) groups = {{"quaternion", 4}};
    if (kind == TargetSpace::Kind::Placement) groups = {{"xyz", 3}, {"quaternion", 4}};
    return read_target(scope.folder, {groups, std::move(here), kind, offsets}, *given);
  }

  std::string frame() const {
    const Reader name = reader["frame"];
    name.named([&] { compile_frame(model(), name.text()); });
    return name.text();
  }
  const ContactSpec& contact() const {
    const Reader name = reader["contact"];
    return name.named([&]() -> const ContactSpec& { return scope.contact(name.text()); });
  }
  std::optional<Reference> reference() const {
    const auto given = reader.find("reference");
    if (!given) return std::nullopt;
    return read_reference(*given, Reference::centered(), &scope.folder);
  }

  /// The residual with the reference that is stated, if it is; `shorter` is a key that states parts
  /// of one.
  template <class Frame>
  Frame in_reference(Frame residual, const std::string& shorter) const {
    const auto given = reader.find("reference");
    if (!given) return residual;
    if (reader.has(shorter))
      reader.refuse("keys 'reference' and '" + shorter + "' are both stated; state one");
    residual.reference = read_reference(*given, Frame{}.reference, &scope.folder);
    return residual;
  }

  /// The residual with the reference that is stated, if it is.
  template <class Frame>
  Frame against(Frame residual) const {
    if (const auto given = reader.find("reference"))
      residual.reference = read_reference(*given, residual.reference, &scope.folder);
    return residual;
  }

  /// Frame, reference and target of what a frame's position in a reference is asked for.
  template <class Frame>
  Frame seen_from() const {
    Frame result{.frame = frame()};
    if (const auto axes = reader.find("axes"))
      result.reference = Reference::world(read_axes(*axes));
    result = in_reference(result, "axes");
    const PositionHere here = reader.named([&] {
      return position_here(model(), scope.q, result.frame,
                           result.reference.at(scope.spec.start_time));
    });
    result.target = target(here.target, TargetSpace::Kind::Plain, here.offsets);
    return result;
  }

  /// The joints that are named, or those that `otherwise` accepts.
  std::vector<const Joint*> joints(const std::function<bool(const Joint&)>& otherwise) const {
    std::vector<const Joint*> result;
    if (const auto names = reader.find("joints")) {
      for (const std::string& name : names->texts()) {
        const Joint& joint = model().joints[static_cast<std::size_t>(
            names->named([&] { return model().joint_index(name); }))];
        if (joint.follows) names->refuse(that_it_follows(model(), joint));
        result.push_back(&joint);
      }
      return result;
    }
    for (const Joint& joint : model().joints)
      if (!joint.follows && otherwise(joint)) result.push_back(&joint);
    return result;
  }
  std::vector<std::string> joint_names() const {
    const auto names = reader.find("joints");
    return names ? names->texts() : std::vector<std::string>();
  }
  /// Fills rows with entries of v of these joints and the limits in `largest` (nv).
  void set_rows(const std::vector<const Joint*>& from, const Eigen::VectorXd& largest) {
    for (const Joint* joint : from) rows.rows.push_back({joint->name, joint->nv});
    rows.upper.resize(rows_of(rows.rows));
    int row = 0;
    for (const Joint* joint : from)
      for (int k = 0; k < joint->nv; ++k) rows.upper[row++] = largest[joint->v_index + k];
    rows.lower = -rows.upper;
  }

  Residual state() {
    keys({"target"});
    const auto given = reader.find("target");
    if (!given || given->is("here")) return residual::State{};
    Eigen::VectorXd x = scope.spec.initial_state;
    const auto set_q = [&](const Reader& q) {
      x.head(model().nq) = read_configuration(scope.robot, q);
    };
    if (given->is_list()) return residual::State{given->numbers(x.size())};
    given->allow_only({"posture", "q", "velocity"});
    if (given->has("posture") && given->has("q"))
      given->refuse("keys 'posture' and 'q' are both stated; state one");
    if (const auto posture = given->find("posture")) set_q(*posture);
    if (const auto q = given->find("q")) set_q(*q);
    if (const auto v = given->find("velocity")) {
      x.segment(model().nq, model().nv) = read_rows(*v, velocity_rows(model()), 0.0);
    }
    return residual::State{x};
  }

  /// The torque, force or both of `hold`, taken from a robot at rest at the start.
  Holding holding(const Reader& given) const {
    return hold(scope.spec, contacts, scope.q, read_held_forces(scope, contacts, given));
  }

  Residual control() {
    keys({"target"});
    set_rows(scope.driven(), model().effort_limit);
    const auto given = reader.find("target");
    if (given && is_hold(*given)) return residual::Control{holding(*given).control};
    return residual::Control{target({})};
  }
  Residual joint_position() {
    keys({"joints", "target"});
    const auto limited = [&](const Joint& joint) {
      return joint.nq == 1 && (std::isfinite(model().q_lower[joint.q_index]) ||
                               std::isfinite(model().q_upper[joint.q_index]));
    };
    const std::vector<const Joint*> from = joints(limited);
    Eigen::VectorXd here(static_cast<Eigen::Index>(from.size()));
    rows.lower = rows.upper = here;
    Eigen::Index i = 0;
    for (const Joint* joint : from) {
      rows.rows.push_back({joint->name, 1});
      here[i] = scope.q[joint->q_index];
      rows.lower[i] = model().q_lower[joint->q_index];
      rows.upper[i++] = model().q_upper[joint->q_index];
    }
    return residual::JointPosition{joint_names(), target(here)};
  }
  Residual joint_velocity() {
    keys({"joints", "target"});
    set_rows(joints([](const Joint& j) { return j.kind != JointKind::FreeFlyer; }),
             model().velocity_limit);
    return residual::JointVelocity{joint_names(), target({})};
  }
  Residual joint_torque() {
    keys({"joints", "target"});
    const std::vector<const Joint*> driven = scope.driven();
    const std::vector<const Joint*> from = reader.has("joints") ? joints({}) : driven;
    set_rows(from, model().effort_limit);
    const auto given = reader.find("target");
    if (!given || !is_hold(*given)) return residual::JointTorque{joint_names(), target({})};
    const Eigen::VectorXd control = holding(*given).control;
    Eigen::VectorXd torque(rows_of(rows.rows));
    int row = 0, entry = 0;
    for (const Joint* wanted : from) {
      entry = 0;
      for (const Joint* joint : driven) {
        if (joint == wanted) torque.segment(row, joint->nv) = control.segment(entry, joint->nv);
        entry += joint->nv;
      }
      row += wanted->nv;
    }
    return residual::JointTorque{joint_names(), torque};
  }
  Residual joint_torque_rate() {
    keys({"joints", "target"});
    for (const Joint* joint : reader.has("joints") ? joints({}) : scope.driven())
      rows.rows.push_back({joint->name, joint->nv});
    return residual::JointTorqueRate{joint_names(), target({})};
  }

  Residual frame_position() {
    keys({"frame", "target", "axes", "reference"});
    rows.rows = direction_rows(Directions::linear());
    return seen_from<residual::FramePosition>();
  }
  Residual frame_distance() {
    keys({"frame", "target", "axes", "reference", "directions"});
    rows.rows = direction_rows(Directions::linear());  // of the target
    auto result = seen_from<residual::FrameDistance>();
    rows.rows = {{"distance", 1}};
    if (const auto directions = reader.find("directions"))
      result.directions = read_directions(*directions);
    return result;
  }
  Residual frame_rotation() {
    keys({"frame", "target", "reference"});
    rows.rows = direction_rows(Directions::angular());
    residual::FrameRotation result{.frame = frame()};
    result = against(result);
    const Eigen::VectorXd here = reader.named([&] {
      return rotation_here(model(), scope.q, result.frame,
                           result.reference.at(scope.spec.start_time));
    });
    result.target = target(here, TargetSpace::Kind::Rotation);
    return result;
  }
  Residual frame_inclination() {
    keys({"frame", "reference", "axis", "target"});
    rows.rows = {{"lead", 1}, {"tilt", 1}};
    residual::FrameInclination result = against(residual::FrameInclination{.frame = frame()});
    if (const auto axis = reader.find("axis")) result.axis = axis->vector3();
    result.target = target({});
    return result;
  }
  Residual frame_height() {
    keys({"frame", "reference", "target"});
    rows.rows = {{"height", 1}};
    residual::FrameHeight result{.frame = frame()};
    result.reference = read_reference(reader["reference"], result.reference, &scope.folder);
    result.target = target({});
    return result;
  }
  Residual frame_placement() {
    keys({"frame", "target"});
    rows.rows = direction_rows(Directions::all());
    const std::string name = frame();
    return residual::FramePlacement{
        name, target(placement_here(model(), scope.q, name), TargetSpace::Kind::Placement)};
  }
  Residual frame_velocity() {
    keys({"frame", "axes", "rotation", "reference", "target"});
    rows.rows = direction_rows(Directions::all());
    residual::FrameVelocity result{frame()};
    if (const auto axes = reader.find("axes"))
      result.reference = Reference::parse(axes->word({"local", "centered", "world"}));
    if (const auto rotation = reader.find("rotation"))
      result.reference.rotation = read_axes(*rotation);
    result.target = target({});
    return in_reference(result, reader.has("axes") ? "axes" : "rotation");
  }
  Residual contact_force() {
    keys({"contact", "reference", "target"});
    const ContactSpec& spec = contact();
    residual::ContactForce result{reader["contact"].text(), reference(), {}};
    rows.rows = direction_rows(result.reference ? Directions::all() : spec.directions);
    const auto given = reader.find("target");
    if (given && is_hold(*given)) {
      if (result.reference)
        given->refuse("'hold' gives the force in the contact's own reference; leave out the other");
      const HeldForces forces = holding(*given).forces;
      const auto found = forces.find(result.contact);
      if (found == forces.end()) given->refuse("the contact does not hold in this stage");
      result.target = found->second;
    } else {
      result.target = target({});
    }
    return result;
  }
  Residual contact_force_rate() {
    keys({"contact", "target"});
    rows.rows = direction_rows(contact().directions);
    return residual::ContactForceRate{reader["contact"].text(), target({})};
  }
  Residual friction_cone() {
    keys({"contact", "reference", "friction", "normal", "sides"});
    contact();
    residual::FrictionCone result{reader["contact"].text()};
    result.reference = reference();
    if (const auto friction = reader.find("friction")) result.friction = friction->positive();
    if (const auto normal = reader.find("normal"))
      result.normal = normal->word({"x", "y", "z"})[0] - 'x';
    if (const auto sides = reader.find("sides")) {
      result.sides = sides->count(0);
      sides->named([&] { ocp::check_sides(result.sides); });
    }
    for (const std::string& row : ocp::cone_row_names(result.sides)) rows.rows.push_back({row, 1});
    return result;
  }
  Residual center_of_pressure() {
    keys({"contact", "half_x", "half_y", "friction"});
    rows.rows = {{"x_above", 1}, {"x_below", 1}, {"y_below", 1}, {"y_above", 1}};
    contact();
    residual::CenterOfPressure result{reader["contact"].text(), reader["half_x"].positive(),
                                      reader["half_y"].positive()};
    if (const auto friction = reader.find("friction")) {
      result.friction = friction->positive();
      for (const std::string& row : ocp::turning_row_names()) rows.rows.push_back({row, 1});
    }
    return result;
  }
  Residual com() {
    keys({"target"});
    rows.rows = direction_rows(Directions::linear());
    return residual::CenterOfMass{target(center_of_mass(model(), scope.q))};
  }
  Residual support_margin() {
    keys({"points"});
    residual::SupportMargin result;
    for (const Reader& point : reader["points"].entries()) {
      rows.rows.push_back({"edge_" + std::to_string(result.points.size()), 1});
      result.points.emplace_back(point.numbers(2));
    }
    return result;
  }
  Residual momentum() {
    keys({"target"});
    rows.rows = direction_rows(Directions::all());
    return residual::CentroidalMomentum{target({})};
  }

  bool remembers_torque() const {
    return scope.spec.torque_model && scope.spec.torque_model->is_held();
  }
  int remembered_forces() const { return static_cast<int>(remembered_of(scope.spec, {}).size()); }

  /// Where none are said. What is remembered is no motion: it costs where it is said to.
  Eigen::VectorXd state_weights() const {
    const int nv = model().nv, nu = scope.spec.torque_model ? scope.controls() : 0;
    Eigen::VectorXd result = Eigen::VectorXd::Zero(2 * nv + nu + remembered_forces());
    result.head(2 * nv + (remembers_torque() ? 0 : nu)).setOnes();
    return result;
  }

  /// {q: ..., v: ..., tau: ...}, each as read_rows has it.
  Eigen::VectorXd state_weights(const Reader& given) const {
    const std::vector<RowGroup> v = velocity_rows(model());
    std::vector<RowGroup> tau;
    if (scope.spec.torque_model)
      for (const Joint* joint : scope.driven()) tau.push_back({joint->name, joint->nv});
    const int nv = model().nv, nu = rows_of(tau);
    if (given.is_list()) return given.numbers(2 * nv + nu + remembered_forces());
    if (!given.is_map()) return given.not_negative() * state_weights();
    given.allow_only(nu > 0 ? std::vector<std::string>{"q", "v", "tau"}
                            : std::vector<std::string>{"q", "v"});
    Eigen::VectorXd result = state_weights();
    if (const auto q = given.find("q")) result.head(nv) = read_rows(*q, v, 1.0);
    if (const auto rates = given.find("v")) result.segment(nv, nv) = read_rows(*rates, v, 1.0);
    if (const auto torques = given.find("tau"))
      result.segment(2 * nv, nu) = read_rows(*torques, tau, 1.0);
    return result;
  }
};

using Read = Residual (CostReader::*)();
struct CostType {
  const char* name;
  Read read;
};
constexpr CostType types[] = {
    {"state", &CostReader::state},
    {"control", &CostReader::control},
    {"joint_position", &CostReader::joint_position},
    {"joint_velocity", &CostReader::joint_velocity},
    {"joint_torque", &CostReader::joint_torque},
    {"joint_torque_rate", &CostReader::joint_torque_rate},
    {"frame_position", &CostReader::frame_position},
    {"frame_distance", &CostReader::frame_distance},
    {"frame_rotation", &CostReader::frame_rotation},
    {"frame_inclination", &CostReader::frame_inclination},
    {"frame_height", &CostReader::frame_height},
    {"frame_placement", &CostReader::frame_placement},
    {"frame_velocity", &CostReader::frame_velocity},
    {"contact_force", &CostReader::contact_force},
    {"contact_force_rate", &CostReader::contact_force_rate},
    {"friction_cone", &CostReader::friction_cone},
    {"center_of_pressure", &CostReader::center_of_pressure},
    {"center_of_mass", &CostReader::com},
    {"support_margin", &CostReader::support_margin},
    {"centroidal_momentum", &CostReader::momentum},
};

Read read_type(const Reader& type) {
  std::vector<std::string> known;
  for (const CostType& candidate : types) known.emplace_back(candidate.name);
  const std::string name = type.word(known);
  for (const CostType& candidate : types)
    if (name == candidate.name) return candidate.read;
  type.refuse("is no cost");
}

CostTerm read_cost(const ProblemScope& scope, const std::vector<std::string>& contacts,
                   const std::string& name, const Reader& reader) {
  CostReader cost{scope, contacts, reader, {"type", "weight", "weights", "penalty"}};
  const Read read = read_type(reader["type"]);
  CostTerm term{.name = name, .residual = (cost.*read)()};
  if (const auto weight = reader.find("weight")) term.weight = weight->not_negative();
  if (const auto weights = reader.find("weights"))
    term.weights = read == &CostReader::state ? cost.state_weights(*weights)
                                              : read_rows(*weights, cost.rows.rows, 1.0);
  else if (read == &CostReader::state && (cost.remembers_torque() || cost.remembered_forces() > 0))
    term.weights = cost.state_weights();
  if (const auto penalty = reader.find("penalty")) term.penalty = read_penalty(cost.rows, *penalty);
  return term;
}

Constraint read_constraint(const ProblemScope& scope, const std::vector<std::string>& contacts,
                           const std::string& name, const Reader& reader) {
  CostReader rows{
      scope, contacts, reader, {"type", "lower", "upper", "limits", "scale", "price", "square"}};
  const Read read = read_type(reader["type"]);
  if (read == &CostReader::state)
    reader["type"].refuse(
        "a state has no limits by name; wanted 'joint_position', 'joint_velocity' or "
        "'joint_torque'");
  Constraint constraint{.name = name, .residual = (rows.*read)()};
  const RowLimits limits = read_limits(rows.rows, reader);
  constraint.lower = limits.lower;
  constraint.upper = limits.upper;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (const auto scale = reader.find("scale"))
    constraint.scale = read_rows(*scale, rows.rows.rows, infinity);
  if (const auto price = reader.find("price"); price && !price->is("hard"))
    constraint.price = price->not_negative();
  if (const auto square = reader.find("square")) constraint.square = square->not_negative();
  return constraint;
}

}  // namespace

std::vector<Constraint> read_constraints(const ProblemScope& scope,
                                         const std::vector<std::string>& contacts,
                                         const Reader& reader) {
  std::vector<Constraint> constraints;
  for (const auto& [name, value] : reader.items())
    constraints.push_back(read_constraint(scope, contacts, name, value));
  return constraints;
}

void check_shared(const Reader& shared) {
  for (const auto& [name, term] : shared.items()) read_type(term["type"]);
}

std::vector<CostTerm> read_costs(const ProblemScope& scope, const std::optional<Reader>& shared,
                                 const std::vector<std::string>& contacts, const Reader& reader) {
  std::vector<std::string> known;
  if (shared)
    for (const auto& [name, term] : shared->items()) known.push_back(name);
  std::vector<CostTerm> terms;
  for (const auto& [name, value] : reader.items()) {
    if (value.is_map() && value.has("type")) {
      terms.push_back(read_cost(scope, contacts, name, value));
      continue;
    }
    const auto base = shared ? shared->find(name) : std::nullopt;
    if (!base)
      value.refuse(known.empty()
                       ? "wanted a cost with a 'type'; the file has no 'terms' to refer to"
                       : "no term of this name; wanted a cost with a 'type', or a name "
                         "among the file's 'terms'" +
                             did_you_mean(name, known));
    if (value.is_map()) {
      terms.push_back(read_cost(scope, contacts, name, base->changed_by(value)));
    } else {
      const double weight = value.not_negative();
      terms.push_back(read_cost(scope, contacts, name, *base));
      terms.back().weight = weight;
    }
  }
  return terms;
}

}  // namespace burnish::files
