// Text of problems with limits, as problem files for `burnish solve`.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "limit_problem.hpp"

namespace burnish::bench {
namespace {

/// Returns a number with all digits, so that reading it gives the same value.
std::string exact(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  return buffer;
}

std::string list(const Eigen::VectorXd& values) {
  std::string text = "[";
  for (Eigen::Index i = 0; i < values.size(); ++i) text += (i == 0 ? "" : ", ") + exact(values[i]);
  return text + "]";
}

/// Returns values of rows: one number for all rows, a list, or a map by names.
std::string rows_text(const Limit& limit, const Eigen::VectorXd& values, const char* others = "") {
  if (limit.rows.empty()) return values.size() == 1 ? exact(values[0]) : list(values);
  std::string text = "{";
  for (std::size_t i = 0; i < limit.rows.size(); ++i)
    text +=
        (i == 0 ? "" : ", ") + limit.rows[i] + ": " + exact(values[static_cast<Eigen::Index>(i)]);
  return text + others + "}";
}

std::string reference_text(const LimitProblem& p) {
  return "{surface: {normal: " + list(p.normal) + "}}";
}

/// Returns type and keys of the residual.
std::string residual_text(const LimitProblem& p, const Limit& limit) {
  switch (limit.kind) {
    case LimitKind::Band:
      return "type: contact_force, contact: pad";
    case LimitKind::Inclination:
      return "type: frame_inclination, frame: " + p.frame + ", axis: " + list(p.axis) +
             ", reference: " + reference_text(p);
    case LimitKind::Speed:
      return "type: joint_velocity";
    case LimitKind::Range:
      return "type: joint_position";
    case LimitKind::Effort:
      return "type: joint_torque";
    case LimitKind::Box:
      return "type: frame_position, frame: " + p.frame + ", axes: {normal: " + list(p.normal) +
             "}, target: here";
    case LimitKind::Cone:
      return "type: friction_cone, contact: pad, friction: " + exact(limit.friction) +
             (limit.sides > 0 ? ", sides: " + std::to_string(limit.sides) : "");
  }
  return "";
}

std::string constraint_text(const LimitProblem& p, const Limit& limit) {
  const std::string residual = residual_text(p, limit);
  if (limit.kind == LimitKind::Cone) return "{" + residual + "}";
  // Rows without limits have no range for scaling.
  const std::string scale =
      limit.rows.empty()
          ? ""
          : ", scale: " + rows_text(limit, 0.5 * (limit.upper - limit.lower), ", other: 1");
  return "{" + residual + ", lower: " + rows_text(limit, limit.lower) +
         ", upper: " + rows_text(limit, limit.upper) + scale + "}";
}

/// Returns a cost on the squared violations of a limit, each divided by its scale.
std::string penalty_text(const LimitProblem& p, const Limit& limit, double weight) {
  const std::string residual = residual_text(p, limit);
  if (limit.kind == LimitKind::Cone)
    return "{" + residual + ", weight: " + exact(weight / (p.weight * p.weight)) + "}";
  const Eigen::VectorXd half = 0.5 * (limit.upper - limit.lower);
  const Eigen::VectorXd weights = half.array().square().inverse();
  return "{" + residual + ", penalty: {barrier: {lower: " + rows_text(limit, limit.lower) +
         ", upper: " + rows_text(limit, limit.upper) +
         "}}, weights: " + rows_text(limit, weights, ", other: 0") + ", weight: " + exact(weight) +
         "}";
}

/// Returns the costs of the aims, the first lines of `terms`.
std::string aims_text(const LimitProblem& p) {
  const double duration = p.knots * p.step;
  const Eigen::Matrix3d board = p.board();
  const Eigen::Vector3d a =
      std::cos(p.path_angle) * board.col(0) + std::sin(p.path_angle) * board.col(1);
  const Eigen::Vector3d b = p.normal.cross(a);
  const std::string sine = ", rate: " + exact(p.rate) + ", phase: " + exact(p.phase) + "}}}\n";
  if (p.holds)
    return "  force: {type: contact_force, contact: pad, target: {sine: {center: [0, 0, " +
           exact(p.force) + "], amplitude: " +
           list(Eigen::Vector3d(p.aims.sideways * std::cos(p.path_angle),
                                p.aims.sideways * std::sin(p.path_angle), p.aims.swing)) +
           sine + "  turn: {type: frame_inclination, frame: " + p.frame +
           ", axis: " + list(p.axis) + ", reference: " + reference_text(p) +
           ", target: " + list(p.aims.inclination_goal) + "}\n";
  const std::string path =
      p.circle ? "{circle: {start: here, radius: " + exact(p.aims.length) +
                     ", rate: " + exact(2.0 * std::numbers::pi / std::max(1.0, duration)) +
                     ", axes: [" + list(a) + ", " + list(b) + "]}}"
               : "{line: {from: here, to: {here: " + list(p.aims.length * a) +
                     "}, start: " + exact(0.1 * duration) +
                     ", duration: " + exact(0.75 * duration) + "}}";
  return "  force: {type: contact_force, contact: pad, target: {sine: {center: " + exact(p.force) +
         ", amplitude: " + exact(p.aims.swing) + sine +
         "  along: {type: frame_position, frame: " + p.frame +
         ", axes: {normal: " + list(p.normal) + "}, target: " + path + ", weights: [1, 1, 0]}\n";
}

/// Returns a stage; `late`: with the limits that apply later.
std::string stage_text(const LimitProblem& p, const TextForm& form, const char* name, bool late) {
  std::string text =
      std::string("  ") + name + ":\n    contacts: [pad]\n    step: " + exact(p.step) +
      "\n    costs:\n      posture: " + exact(p.aims.posture) +
      "\n      torque: " + exact(p.aims.torque) + "\n      force: " + exact(p.aims.force) + "\n";
  text += p.holds ? "      turn: " + exact(p.aims.turn) + "\n"
                  : "      along: " + exact(p.aims.along) + "\n";
  if (!form.limits) return text;
  std::string limits;
  for (const Limit& limit : p.limits)
    if (late || !limit.late)
      limits +=
          "      " + std::string(form.penalty > 0.0 ? "limit_" : "") +
          std::string(name_of(limit.kind)) + ": " +
          (form.penalty > 0.0 ? penalty_text(p, limit, form.penalty) : constraint_text(p, limit)) +
          "\n";
  return text + (form.penalty > 0.0 || limits.empty() ? "" : "    constraints:\n") + limits;
}

}  // namespace

std::string text_of(const LimitProblem& p, const TextForm& form) {
  std::string text;
  if (!form.description.empty()) text += "description: " + form.description + "\n";
  text += "robot: " + p.robot + "\nstart: {q: " + list(p.start) + "}\n" +
          "contacts:\n  pad: {tool: " + p.frame + ", reference: " + reference_text(p) +
          ", directions: " + (p.holds ? "linear" : "z") + ", kd: 40}\n" +
          "terms:\n  posture: {type: state}\n  torque: {type: control, target: {hold: {pad: " +
          (p.holds ? list(Eigen::Vector3d(0.0, 0.0, p.force)) : exact(p.force)) + "}}}\n" +
          aims_text(p) + "stages:\n";
  if (p.early > 0) text += stage_text(p, form, "early", false);
  text += stage_text(p, form, "press", true) + "horizon: [";
  if (p.early > 0) text += "early: " + std::to_string(p.early) + ", ";
  text +=
      "press: " + std::to_string(p.knots - p.early) + "]\n" +
      "terminal: {posture: " + exact(p.aims.posture) +
      (p.holds ? ", turn: " + exact(0.1 * p.aims.turn) : ", along: " + exact(0.1 * p.aims.along)) +
      "}\n";
  return text;
}

}  // namespace burnish::bench
