#include "files/residual_target.hpp"

#include "base/to_size.hpp"
#include "files/here.hpp"

namespace burnish::files {
namespace {

struct TargetReader {
  const TargetText& text;
  const Residual& residual;

  const ProblemScope& scope() const { return text.scope; }
  const Reader& given() const { return text.reader; }
  const Model& model() const { return scope().model(); }

  Signal read(const TargetSpace& space) const {
    return read_target(scope().folder, space, given());
  }
  std::vector<RowGroup> groups() const { return ocp::residual_rows(scope().spec, residual).groups; }
  /// Torques and forces for `hold`: they keep the robot at rest in its starting configuration.
  Holding holding() const {
    return hold(scope().spec, text.contacts, scope().q,
                read_held_forces(scope(), text.contacts, given()));
  }

  Signal operator()(const residual::State& /*of*/) const {
    Eigen::VectorXd x = scope().spec.initial_state;
    if (given().is("here")) return {};
    if (given().is_list()) return given().numbers(x.size());
    given().allow_only({"posture", "q", "velocity"});
    if (given().has("posture") && given().has("q"))
      given().refuse("keys 'posture' and 'q' are both stated; state one");
    for (const char* key : {"posture", "q"})
      if (const auto q = given().find(key))
        x.head(model().nq) = read_configuration(scope().robot, *q);
    if (const auto v = given().find("velocity"))
      x.segment(model().nq, model().nv) = read_rows(*v, velocity_rows(model()), 0.0);
    return x;
  }
  Signal operator()(const residual::Control& /*of*/) const {
    if (is_hold(given())) return holding().control;
    return read({groups()});
  }
  Signal operator()(const residual::JointTorque& /*of*/) const {
    if (!is_hold(given())) return read({groups()});
    const Eigen::VectorXd control = holding().control;
    const std::vector<RowGroup> wanted = groups();
    Eigen::VectorXd torque = Eigen::VectorXd::Zero(rows_of(wanted));
    int row = 0;
    for (const RowGroup& group : wanted) {
      int entry = 0;
      for (const Joint* joint : scope().driven()) {
        if (joint->name == group.name)
          torque.segment(row, joint->nv) = control.segment(entry, joint->nv);
        entry += joint->nv;
      }
      row += group.size;
    }
    return torque;
  }
  Signal operator()(const residual::JointPosition& /*of*/) const {
    const std::vector<RowGroup> rows = groups();
    Eigen::VectorXd here(static_cast<Eigen::Index>(rows.size()));
    Eigen::Index i = 0;
    for (const RowGroup& row : rows) {
      const int joint = model().joint_index(row.name);
      here[i++] = scope().q[model().joints[to_size(joint)].q_index];
    }
    return read({rows, here});
  }
  /// Reads the target of a frame's position in `reference`; its rows are x, y and z.
  Signal position(const std::string& frame, const Reference& reference) const {
    const PositionHere here = given().named([&] {
      return position_here(model(), scope().q, frame, reference.at(scope().spec.start_time));
    });
    return read({ocp::direction_rows(Directions::linear()), here.target, TargetSpace::Kind::Plain,
                 here.offsets});
  }
  Signal operator()(const residual::FramePosition& r) const {
    return position(r.frame, r.reference);
  }
  Signal operator()(const residual::FrameDistance& r) const {
    return position(r.frame, r.reference);
  }
  Signal operator()(const residual::FrameRotation& r) const {
    const Eigen::VectorXd here = given().named([&] {
      return rotation_here(model(), scope().q, r.frame, r.reference.at(scope().spec.start_time));
    });
    return read({{{"quaternion", 4}}, here, TargetSpace::Kind::Rotation});
  }
  Signal operator()(const residual::FramePlacement& r) const {
    return read({{{"xyz", 3}, {"quaternion", 4}},
                 placement_here(model(), scope().q, r.frame),
                 TargetSpace::Kind::Placement});
  }
  Signal operator()(const residual::ContactForce& r) const {
    if (!is_hold(given())) return read({groups()});
    if (r.reference)
      given().refuse(
          "'hold' stands for a force in the contact's own reference, but this residual has the key "
          "'reference'; wanted a residual without this key, or a target in numbers");
    const HeldForces forces = holding().forces;
    const auto found = forces.find(r.contact);
    if (found == forces.end())
      given().refuse("'hold' has no force, because the contact is not active in this stage");
    return found->second;
  }
  Signal operator()(const residual::CenterOfMass& /*of*/) const {
    return read({groups(), center_of_mass(model(), scope().q)});
  }
  /// Reads targets of all other residuals: one number for each row, without `here`.
  Signal operator()(const auto& /*of*/) const { return read({groups()}); }
};

}  // namespace

Signal read_target_of(const Residual& residual, const TargetText& text) {
  return std::visit(TargetReader{text, residual}, residual);
}

Eigen::VectorXd default_state_weights(const ProblemScope& scope) {
  const ProblemSpec& spec = scope.spec;
  const Eigen::Index motion = 2 * spec.model.nv, forces = force_states_of(spec, {}).size();
  const bool holds_torque = spec.torque_model && spec.torque_model->is_held();
  if (!holds_torque && forces == 0) return {};
  const Eigen::Index torques = spec.torque_model ? scope.controls() : 0;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(motion + torques + forces);
  result.head(motion + (holds_torque ? 0 : torques)).setOnes();
  return result;
}

Eigen::VectorXd read_state_weights(const ProblemScope& scope, const Reader& reader) {
  const Model& model = scope.model();
  const std::vector<RowGroup> v = velocity_rows(model);
  std::vector<RowGroup> tau;
  if (scope.spec.torque_model)
    for (const Joint* joint : scope.driven()) tau.push_back({joint->name, joint->nv});
  const Eigen::Index nv = model.nv, nu = rows_of(tau),
                     size = 2 * nv + nu + force_states_of(scope.spec, {}).size();
  if (reader.is_list()) return reader.numbers(size);
  Eigen::VectorXd result = default_state_weights(scope);
  if (result.size() == 0) result = Eigen::VectorXd::Ones(size);
  if (!reader.is_map()) return reader.not_negative() * result;
  reader.allow_only(nu > 0 ? std::vector<std::string>{"q", "v", "tau"}
                           : std::vector<std::string>{"q", "v"});
  if (const auto q = reader.find("q")) result.head(nv) = read_rows(*q, v, 1.0);
  if (const auto rates = reader.find("v")) result.segment(nv, nv) = read_rows(*rates, v, 1.0);
  if (const auto torques = reader.find("tau"))
    result.segment(2 * nv, nu) = read_rows(*torques, tau, 1.0);
  return result;
}

}  // namespace burnish::files
