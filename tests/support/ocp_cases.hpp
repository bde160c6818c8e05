// Robots, contacts and horizons for the laws of optimal control problems.
#pragma once

#include "burnish/ocp/problem.hpp"
#include "ocp/problem_impl.hpp"
#include "support/contact_states.hpp"
#include "support/robots.hpp"

namespace burnish::test {

struct OcpCase {
  TestRobot robot;
  bool torque_model = false;
  bool zero_order_hold = false;   ///< the state has the torques of the previous step
  bool has_force_states = false;  ///< the state has the last forces of "pad" and "brace"
  bool has_friction = false;      ///< "brace" has friction
  bool acts_from_state() const { return torque_model && !zero_order_hold; }
  std::string label() const {
    return robot.label() +
           (zero_order_hold ? "_zero_order_hold"
            : torque_model  ? "_filtered"
                            : "") +
           (has_force_states ? "_force_states" : "") + (has_friction ? "_sliding" : "");
  }
};

inline const OcpCase arm{{"arm7", Base::Fixed, "tool"}};
inline void PrintTo(const OcpCase& test, std::ostream* out) { *out << test.label(); }

inline std::vector<OcpCase> ocp_cases() {
  std::vector<OcpCase> cases;
  for (const bool torque_model : {false, true})
    for (const TestRobot& robot : available({{"talos:right_arm", Base::Fixed, "tool"},
                                             humanoid(),
                                             {"arm7", Base::Fixed, "tool"},
                                             {"crane", Base::Fixed, "left_tip"},
                                             {"every_joint", Base::Fixed, "tip"},
                                             {"every_joint", Base::FreeFlyer, "tip"}}))
      cases.push_back({robot, torque_model});
  cases.push_back({{"arm7", Base::Fixed, "tool"}, true, true});
  cases.push_back({{"every_joint", Base::FreeFlyer, "tip"}, true, true});
  cases.push_back({{"arm7", Base::Fixed, "tool"}, false, false, true});
  cases.push_back({{"arm7", Base::Fixed, "tool"}, true, false, true});
  cases.push_back({{"every_joint", Base::FreeFlyer, "tip"}, true, true, true});
  cases.push_back({{"arm7", Base::Fixed, "tool"}, false, false, false, true});
  cases.push_back({{"every_joint", Base::FreeFlyer, "tip"}, true, false, false, true});
  return cases;
}

/// Context in which residuals are made.
struct OcpSetup {
  const Model& model;
  std::string tool;
  std::mt19937_64& generator;

  Eigen::VectorXd random(int n) const { return random_vector(n, 1.0, generator); }
  Eigen::Vector4d quaternion() const { return Eigen::Vector4d(random(4).normalized()); }
  Eigen::VectorXd placement() const {
    Eigen::VectorXd p(7);
    p << random(3), quaternion();
    return p;
  }
  Eigen::VectorXd state(const OcpCase& test) const {
    const RobotState s = test::random_state(model, generator);
    const int filtered = test.torque_model ? static_cast<int>(driven().size()) : 0;
    const int force_states = test.has_force_states ? 7 : 0;  // six of the pad, one of the brace
    Eigen::VectorXd x(model.nq + model.nv + filtered + force_states);
    x << s.q, s.v, random(filtered), random(force_states);
    return x;
  }
  /// Frame that other joints move.
  std::string other() const { return far_frame(model, {tool}); }
  /// Entries of v that are driven.
  std::vector<int> driven() const {
    std::vector<int> entries;
    for (const Joint& joint : model.joints)
      if (joint.kind != JointKind::FreeFlyer)
        for (int k = 0; k < joint.nv; ++k) entries.push_back(joint.v_index + k);
    return entries;
  }
  std::vector<std::string> plain_joints() const {
    std::vector<std::string> names;
    for (const Joint& joint : model.joints)
      if (joint.nq == 1) names.push_back(joint.name);
    return names;
  }
};

/// User-defined residual: power, a force, height, acceleration and speed; differentiated by the
/// library.
struct WithoutJacobian {
  int rows = 5;
  std::string name = "without jacobian";
  std::vector<std::string> frames, contacts;
  void value(const NodeView& at, Eigen::Ref<Eigen::VectorXd> out) const {
    out[0] = at.tau().dot(at.v());
    out[1] = at.force(0)[1] * (1.0 + at.time());
    out[2] = at.placement(0).translation().z() + at.q()[0];
    out[3] = at.acceleration()[0] + (at.u().size() > 0 ? at.u()[0] : 0.0);
    out[4] = at.velocity(0, Reference::centered()).squaredNorm();
  }
};

/// User-defined residual with its own derivative: a position, a product of forces, squared
/// velocity.
struct WithJacobian {
  int rows = 3;
  std::vector<std::string> frames, contacts;
  void value(const NodeView& at, Eigen::Ref<Eigen::VectorXd> out) const {
    const Eigen::Vector3d p = at.placement(0).translation();
    out[0] = p.x() + 2.0 * p.y() * p.z();
    out[1] = at.force(1)[0] * at.force(0)[2];
    out[2] = at.v().squaredNorm();
  }
  void jacobian(const NodeView& at, Eigen::Ref<RowMatrix> out) const {
    const Eigen::Vector3d p = at.placement(0).translation();
    const int nv = at.layout().nv;
    const MatrixView J = at.jacobian(0, Reference::centered());
    out.row(0).segment(at.layout().column_q(), nv) =
        J.row(0) + 2.0 * p.z() * J.row(1) + 2.0 * p.y() * J.row(2);
    out.row(1) = at.force(0)[2] * at.force_derivative(1).row(0);
    out.row(1) += at.force(1)[0] * at.force_derivative(0).row(2);
    out.row(2).segment(at.layout().column_v(), nv) = 2.0 * at.v().transpose();
  }
};

/// Rotation that turns by 2 rad/s; its quaternions alternate in sign.
inline Eigen::Matrix3d turned_at(double time) {
  return Eigen::AngleAxisd(0.4 + 2.0 * time, Eigen::Vector3d(0.6, -0.48, 0.64)).toRotationMatrix();
}
inline Signal turning() {
  return Signal::over_time(4, [](double time, Eigen::Ref<Eigen::VectorXd> xyzw) {
    const double sign = std::fmod(time, 0.04) < 0.02 ? 1.0 : -1.0;
    xyzw = sign * Eigen::Quaterniond(turned_at(time)).coeffs();
  });
}
inline Reference turning_reference(const Anchor& origin, const Anchor& axes) {
  return {.origin = origin, .axes = axes, .rotation_over_time = turning()};
}

/// Frame on a body half way between base and tool.
inline std::string middle_frame(const Model& model, const std::string& tool) {
  std::vector<int> bodies;
  for (int j = model.frames[static_cast<std::size_t>(model.frame_index(tool))].body; j >= 0;
       j = model.joints[static_cast<std::size_t>(j)].parent)
    bodies.push_back(j);
  const int middle = bodies[bodies.size() / 2];
  for (const Frame& frame : model.frames)
    if (frame.body == middle) return frame.name;
  throw Error("no frame half way to " + tool);
}

/// "idle" is never active; "brace" constrains one turning direction half way to the tool; "pad"
/// constrains all six directions of the tool, in axes that follow a curved surface.
inline std::vector<ContactSpec> ocp_contacts(const Model& model, const std::string& tool) {
  ContactSpec idle = contact(tool);
  ContactSpec pad = contact(
      tool, "world",
      Reference::on(Quadric::osculating({0.3, 0.0, 0.2}, tilt(), 0.6, 0.2, -0.9), {0.3, 0.0, 0.2}));
  ContactSpec brace =
      contact(middle_frame(model, tool), "world", turning_reference(Anchor::Tool, Anchor::World),
              Directions::z(), Acceleration::Classical);
  idle.name = "idle";
  pad.name = "pad";
  pad.with_gains(0.0, 5.0);
  brace.name = "brace";
  return {idle, brace, pad};
}

/// Robots on a fixed base cannot satisfy seven rigid directions: their contacts are compliant.
inline ContactSolver ocp_solver(const TestRobot& robot) {
  return {.mu = robot.base == Base::Fixed ? 0.05 : 0.0};
}

/// Problem without costs and horizon.
inline ProblemSpec bare_problem(const OcpCase& test, const Model& model) {
  std::mt19937_64 generator(11);
  ProblemSpec spec{.model = model};
  spec.contacts = ocp_contacts(model, test.robot.tool);
  if (test.has_friction) spec.contacts[1].friction = {0.3, 0.3, 0.05};
  spec.contact_solver = ocp_solver(test.robot);
  spec.actuation.passive_torques = true;
  spec.actuation.slip_velocity = 0.5;
  if (test.torque_model)
    spec.torque_model = test.zero_order_hold ? TorqueModel::held() : TorqueModel{.cutoff = 30.0};
  spec.initial_state = OcpSetup{model, test.robot.tool, generator}.state(test);
  if (test.has_force_states) spec.force_states = {"pad", "brace"};
  spec.start_time = 0.7;
  return spec;
}

/// State and control at which rigid contacts are independent.
struct OcpState {
  Eigen::VectorXd x, u;
};
inline OcpState random_ocp_state(const Problem& problem, std::mt19937_64& generator) {
  const Model& model = problem.model();
  const StateLayout& l = problem.layout();
  ContactDynamics dynamics(model, contacts_at(problem.spec().contacts, problem.time_of(0)));
  dynamics.set_active(0, false);
  const RobotState s = problem.spec().contact_solver.mu > 0.0
                           ? random_state(model, generator)
                           : regular_state(model, dynamics, generator, 1e-2);
  OcpState state{Eigen::VectorXd(l.nx()), uniform(l.nu, 5.0, generator)};
  state.x << s.q, s.v, uniform(l.filtered, 5.0, generator), uniform(l.force_states, 5.0, generator);
  return state;
}

/// Trajectories of a whole horizon, and memory for its expansion.
struct OcpHorizon {
  OcpHorizon(Problem& problem, std::mt19937_64& generator) {
    const StateShape& shape = problem.state();
    const auto knots = static_cast<std::size_t>(problem.knots() + 1);
    stride = shape.ndx + problem.max_controls();
    for (std::size_t k = 0; k < knots; ++k) {
      const OcpState state = random_ocp_state(problem, generator);
      x.insert(x.end(), state.x.begin(), state.x.end());
      u.insert(u.end(), state.u.begin(), state.u.end());
    }
    next.resize(x.size());
    values.resize(knots);
    int tangent_size = 0;
    for (const NonEuclideanBlock& block : shape.blocks) tangent_size += 2 * block.size * block.size;
    for (std::size_t k = 0; k < knots; ++k) {
      gradient.emplace_back(stride);
      hessian.emplace_back(stride, stride);
      dynamics.emplace_back(stride, stride);
      tangent_blocks.emplace_back(tangent_size);
      decay.emplace_back(shape.filtered);
      rows.emplace_back(problem.rows(static_cast<int>(k)), stride);
      curvatures.emplace_back(problem.max_curvatures(), stride);
      row_values.emplace_back(problem.rows(static_cast<int>(k)));
    }
    out.resize(knots);
    for (std::size_t k = 0; k < knots; ++k) point_at(k);
  }
  /// Lets the expansion of knot k point to the memory of this object; needed after a copy.
  void point_at(std::size_t k) {
    KnotExpansion& knot = out[k];
    knot.stride = stride;
    knot.gradient = gradient[k].data();
    knot.hessian = hessian[k].data();
    knot.dynamics = dynamics[k].data();
    knot.tangent_blocks = tangent_blocks[k].data();
    knot.decay = decay[k].data();
    knot.rows = rows[k].data();
    knot.curvatures = curvatures[k].data();
    knot.row_values = row_values[k].data();
  }
  TrajectoryView view() const { return {x.data(), u.data()}; }
  void expand(Problem& problem) {
    for (const KnotRange range : problem.ranges())
      problem.expand(0, range, view(), next.data(), values.data(), out.data());
  }
  void evaluate(Problem& problem) {
    for (const KnotRange range : problem.ranges())
      problem.evaluate(0, range, view(), next.data(), values.data());
  }
  Eigen::Map<const Eigen::VectorXd> x_of(const Problem& problem, int knot) const {
    const int nx = problem.state().nx;
    return {x.data() + static_cast<std::ptrdiff_t>(knot) * nx, nx};
  }
  Eigen::Map<const Eigen::VectorXd> u_of(const Problem& problem, int knot) const {
    const int nu = problem.max_controls();
    return {u.data() + static_cast<std::ptrdiff_t>(knot) * nu, nu};
  }
  Eigen::Map<const Eigen::VectorXd> next_of(const Problem& problem, int knot) const {
    const int nx = problem.state().nx;
    return {next.data() + static_cast<std::ptrdiff_t>(knot) * nx, nx};
  }

  int stride = 0;
  std::vector<double> x, u, next;
  std::vector<KnotValue> values;
  std::vector<Eigen::VectorXd> gradient, tangent_blocks, decay, row_values;
  std::vector<RowMatrix> hessian, dynamics, rows, curvatures;
  std::vector<KnotExpansion> out;
};

}  // namespace burnish::test
