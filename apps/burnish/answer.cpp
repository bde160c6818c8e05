#include "answer.hpp"

#include <cmath>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/diagnosis.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/ocp/loop_inverse.hpp"
#include "record/json_text.hpp"

namespace burnish::app {
namespace {

std::string status_name(Status status) {
  switch (status) {
    case Status::Ok:
      return "ok";
    case Status::NotConverged:
      return "not_converged";
    case Status::SingularContacts:
      return "singular_contacts";
    case Status::SingularMass:
      return "singular_mass";
    case Status::NotNormalized:
      return "not_normalized";
    case Status::NotFinite:
      return "not_finite";
    case Status::WrongSize:
      return "wrong_size";
    case Status::NotEvaluated:
      return "not_evaluated";
    case Status::NotPhysical:
      return "not_physical";
  }
  return "unknown";
}

/// Evaluation of a request, one state after the other.
class Evaluation {
 public:
  explicit Evaluation(const EvalRequest& request)
      : request_(request),
        model_(request.robot.model),
        dynamics_(model_, request.contacts, request.solver) {}

  Json state(const EvalState& x) {
    status_ = Status::Ok;
    sentence_ = describe(status_);
    Json result{{"status", nullptr}, {"sentence", nullptr}};
    if (!x.warnings.empty()) result["warnings"] = x.warnings;
    add_acceleration(x, result);
    add_loop_inverse(x, result);
    add_inverse(x, result);
    add_forward(x, result);
    if (wants("frames")) result["frames"] = frames(x);
    if (wants("diagnosis")) result["diagnosis"] = diagnosis(x);
    result["status"] = status_name(status_);
    result["sentence"] = sentence_;
    good = good && status_ == Status::Ok;
    return result;
  }

  Json names() const {
    Json q_names = Json::array(), v_names = Json::array();
    for (int k = 0; k < model_.nq; ++k) q_names.push_back(model_.q_name(k));
    for (int k = 0; k < model_.nv; ++k) v_names.push_back(model_.v_name(k));
    return {{"q_names", q_names}, {"v_names", v_names}, {"row_names", dynamics_.row_names()}};
  }

  bool good = true;

 private:
  bool wants(const char* word) const { return request_.compute.contains(word); }

  /// Records the status of an evaluation. Returns false if there are no results to report.
  bool usable(Status status) {
    if (worst(status_, status) != status_) sentence_ = dynamics_.explanation();
    status_ = worst(status_, status);
    return is_usable(status);
  }

  /// Adds the contact acceleration and all other results that depend only on the state.
  void add_acceleration(const EvalState& x, Json& result) {
    const bool ok = usable(dynamics_.acceleration(x.q, x.v, x.a));
    const auto add = [&](const char* word, auto&& value) {
      if (wants(word)) result[word] = ok ? Json(value()) : Json(nullptr);
    };
    add("mass_matrix", [&] { return matrix_json(dynamics_.mass_matrix()); });
    add("bias", [&] { return numbers_json(dynamics_.bias()); });
    add("jacobian", [&] { return matrix_json(dynamics_.jacobian()); });
    add("contact_velocity", [&] { return numbers_json(dynamics_.contact_velocity()); });
    add("contact_error", [&] { return numbers_json(dynamics_.contact_error()); });
    add("acceleration", [&] { return Json{{"alpha", numbers_json(dynamics_.alpha())}}; });
    if (!wants("acceleration_derivatives")) return;
    const bool derived = ok && usable(dynamics_.acceleration_derivatives());
    result["acceleration_derivatives"] =
        derived ? Json{{"dalpha_dq", matrix_json(dynamics_.dalpha_dq())},
                       {"dalpha_dv", matrix_json(dynamics_.dalpha_dv())},
                       {"dalpha_da", matrix_json(dynamics_.jacobian())}}
                : Json(nullptr);
  }

  /// Adds the motor torques that produce a motion of a robot with loops.
  void add_loop_inverse(const EvalState& x, Json& result) {
    if (!wants("loop_inverse")) return;
    const LoopInverse motion =
        loop_inverse(request_.robot.model, dynamics_, {x.q, x.v, x.a, x.lambda});
    result["loop_inverse"] = nullptr;
    if (!usable(motion.status)) return;
    result["loop_inverse"] = Json{{"v", numbers_json(motion.v)},
                                  {"a", numbers_json(motion.a)},
                                  {"tau", numbers_json(motion.tau)},
                                  {"lambda", numbers_json(motion.lambda)},
                                  {"unbalanced", motion.unbalanced}};
  }

  void add_inverse(const EvalState& x, Json& result) {
    if (!wants("inverse") && !wants("inverse_derivatives")) return;
    const bool ok = usable(dynamics_.inverse(x.q, x.v, x.a, x.lambda));
    if (wants("inverse")) {
      result["inverse"] = ok ? Json{{"tau", numbers_json(dynamics_.tau())}} : Json(nullptr);
    }
    add_forces("inverse", ok, result);
    if (!wants("inverse_derivatives")) return;
    const bool derived = ok && usable(dynamics_.inverse_derivatives());
    result["inverse_derivatives"] =
        derived ? Json{{"dtau_dq", matrix_json(dynamics_.dtau_dq())},
                       {"dtau_dv", matrix_json(dynamics_.dtau_dv())},
                       {"dtau_da", matrix_json(dynamics_.mass_matrix())},
                       {"dtau_dlambda", matrix_json(-dynamics_.jacobian().transpose())}}
                : Json(nullptr);
  }

  void add_forward(const EvalState& x, Json& result) {
    if (!wants("forward") && !wants("forward_derivatives") && request_.forces_of != "forward")
      return;
    const bool ok = usable(dynamics_.forward(x.q, x.v, x.tau));
    if (wants("forward")) result["forward"] = ok ? forward() : Json(nullptr);
    if (wants("forward_derivatives")) {
      const bool derived = ok && usable(dynamics_.forward_derivatives());
      result["forward_derivatives"] = derived ? forward_derivatives() : Json(nullptr);
    }
    add_forces("forward", ok, result);
  }

  /// Adds the contact forces to `result` if the request wants the forces of `evaluation`, which is
  /// "forward" or "inverse".
  void add_forces(const char* evaluation, bool ok, Json& result) const {
    if (request_.forces_of != evaluation) return;
    result["forces"] = ok ? forces() : Json(nullptr);
    result["forces_of"] = evaluation;
  }

  Json forward() const {
    Json result{{"a", numbers_json(dynamics_.a())}, {"lambda", numbers_json(dynamics_.lambda())}};
    if (request_.solver.mu > 0.0) {
      result["proximal_iterations"] = dynamics_.proximal_iterations();
      result["proximal_residual"] = dynamics_.proximal_residual();
      result["unmet"] = numbers_json(dynamics_.unmet());
    }
    return result;
  }

  Json forward_derivatives() const {
    return {{"da_dq", matrix_json(dynamics_.da_dq())},
            {"da_dv", matrix_json(dynamics_.da_dv())},
            {"da_dtau", matrix_json(dynamics_.da_dtau())},
            {"dlambda_dq", matrix_json(dynamics_.dlambda_dq())},
            {"dlambda_dv", matrix_json(dynamics_.dlambda_dv())},
            {"dlambda_dtau", matrix_json(dynamics_.dlambda_dtau())}};
  }

  Json forces() const {
    Json list = Json::array();
    for (int c = 0; c < dynamics_.contacts().size(); ++c) {
      const ContactForce force = dynamics_.force(c);
      Json entry{{"contact", force.contact},
                 {"on", force.on},
                 {"by", force.by},
                 {"reference", force.reference.name()},
                 {"value", numbers_json(force.value)},
                 {"text", force.text()}};
      if (!request_.forces_in.empty()) entry["in"] = Json::object();
      for (const auto& [name, reference] : request_.forces_in) {
        const ContactForce other = dynamics_.force(c, reference);
        entry["in"][name] = {{"value", numbers_json(other.value)}, {"text", other.text()}};
      }
      list.push_back(entry);
    }
    return list;
  }

  Json frames(const EvalState& x) const {
    Json result = Json::object();
    const std::vector<Eigen::Isometry3d> placements = frame_placements(model_, x.q);
    for (std::size_t i = 0; i < placements.size(); ++i) {
      // If a link and a joint have the same name, the name refers to the link's frame.
      const std::string& name = model_.frames[i].name;
      if (model_.frame_index(name) == static_cast<int>(i)) {
        result[name] = placement_json(placements[i]);
      }
    }
    return result;
  }

  Json diagnosis(const EvalState& x) {
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model_.nv);
    // The diagnosis of dependent contacts uses the mass matrix as its metric. This matrix must be
    // invertible.
    const Status status = dynamics_.forward(x.q, rest, rest);
    if (status > Status::SingularContacts && !usable(status)) return nullptr;
    const ContactDiagnosis found = diagnose(model_, dynamics_.contacts(), x.q);
    Json rows = Json::array();
    for (const RedundantRow& row : found.redundant) {
      rows.push_back({{"contact", row.contact},
                      {"direction", row.direction},
                      {"row", row.row},
                      {"immovable", row.immovable},
                      {"implied_by", row.implied_by},
                      {"text", row.text()}});
    }
    return {{"independent", found.redundant.empty()},
            {"condition", std::isfinite(found.condition) ? Json(found.condition) : Json(nullptr)},
            {"redundant", rows}};
  }

  const EvalRequest& request_;
  const Model& model_;
  ContactDynamics dynamics_;
  Status status_ = Status::Ok;
  std::string sentence_;
};

}  // namespace

Answer evaluate(const EvalRequest& request) {
  Evaluation evaluation(request);
  Json json{{"robot", request.robot_name}, {"warnings", request.robot.warnings}};
  json.update(evaluation.names());
  json["states"] = Json::array();
  for (const EvalState& state : request.states) json["states"].push_back(evaluation.state(state));
  return {json, evaluation.good};
}

}  // namespace burnish::app
