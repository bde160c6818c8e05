// Robots, contacts and residuals that the laws of optimal control problems are tested on. A new
// residual joins with one line in residual_cases().
#pragma once

#include "burnish/ocp/problem.hpp"
#include "ocp/problem_impl.hpp"
#include "support/contact_states.hpp"
#include "support/robots.hpp"

namespace burnish::test {

struct OcpCase {
  TestRobot robot;
  bool torque_model = false;
  bool held = false;       ///< the torque model remembers the last torques, which do not act
  bool remembers = false;  ///< the state has the last forces of "pad" and "brace"
  bool rubs = false;       ///< "brace" does
  bool acts_from_state() const { return torque_model && !held; }
  std::string label() const {
    return robot.label() +
           (held           ? "_held"
            : torque_model ? "_filtered"
                           : "") +
           (remembers ? "_remembering" : "") + (rubs ? "_rubbing" : "");
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

/// What residuals are made for.
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
    const int remembered = test.remembers ? 7 : 0;  // six of the pad, one of the brace
    Eigen::VectorXd x(model.nq + model.nv + filtered + remembered);
    x << s.q, s.v, random(filtered), random(remembered);
    return x;
  }
  /// A frame that other joints move.
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

/// A user's own: power, a force, height, acceleration and speed; differences by the library.
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

/// The same with its own derivative: a place, a product of forces, work of the tool's speed.
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

/// A rotation that turns by 2 rad/s, its quaternions now of one sign and now of the other.
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

/// Axes that follow a surface of the world, or of another frame, from where `origin` is.
inline Reference following(const Quadric& surface, const Anchor& axes = Anchor::Base,
                           const Anchor& origin = Anchor::Tool) {
  Reference result{origin, axes, tilt()};
  result.quadric = surface;
  return result;
}
inline Quadric saddle() { return Quadric::osculating({0.3, 0.0, 0.2}, tilt(), 0.15, 0.06, -0.2); }
inline Quadric ball() { return Quadric::sphere({0.2, -0.3, -4.0}, 0.4); }

/// Frame on a body in the middle of the way to the tool.
inline std::string frame_on_the_way(const Model& model, const std::string& tool);

struct ResidualCase {
  std::string name;
  std::function<Residual(const OcpSetup&)> make;
  Penalty penalty = {};
  bool at_the_end = true;  ///< needs neither controls nor forces
};

inline std::vector<ResidualCase> residual_cases(const OcpCase& test) {
  const bool at_the_end = test.acts_from_state();
  namespace R = residual;
  using Setup = const OcpSetup&;
  const Penalty abs = Penalty::smooth_absolute(0.3), square;
  const Penalty inside =
      Penalty::barrier(Eigen::VectorXd::Constant(1, -0.2), Eigen::VectorXd::Constant(1, 0.3));
  const Penalty logarithm = Penalty::log_barrier(Eigen::VectorXd::Constant(1, -0.5),
                                                 Eigen::VectorXd::Constant(1, 1.5), 0.4);
  std::vector<ResidualCase> cases{
      {"state", [](Setup) { return R::State{}; }},
      {"state to target", [=](Setup s) { return R::State{s.state(test)}; }, abs},
      {"control", [](Setup) { return R::Control{0.5}; }, square, false},
      {"joint position",
       [](Setup s) {
         return R::JointPosition{s.plain_joints(), 0.1};
       },
       inside},
      {"joint velocity", [](Setup) { return R::JointVelocity{}; }, logarithm},
      {"one velocity",
       [](Setup s) {
         return R::JointVelocity{{s.model.joints[1].name}, 0.2};
       }},
      {"joint torque", [](Setup) { return R::JointTorque{}; }, abs, at_the_end},
      {"position",
       [](Setup s) {
         return R::FramePosition{s.tool, s.random(3), Reference::world(tilt())};
       },
       inside},
      {"rotation",
       [](Setup s) {
         return R::FrameRotation{s.tool, s.quaternion()};
       }},
      {"placement",
       [](Setup s) {
         return R::FramePlacement{s.tool, s.placement()};
       },
       logarithm},
      {"local velocity",
       [](Setup s) {
         return R::FrameVelocity{s.tool, Reference::local()};
       }},
      {"world velocity",
       [](Setup s) {
         return R::FrameVelocity{s.tool, Reference::world(), 0.1};
       }},
      {"turned local velocity",
       [](Setup s) {
         return R::FrameVelocity{s.tool, Reference::local(tilt()), s.random(6)};
       }},
      {"velocity in turning axes of the world",
       [](Setup s) {
         return R::FrameVelocity{s.tool, turning_reference(Anchor::World, Anchor::World), 0.1};
       },
       abs},
      {"velocity", [](Setup s) { return R::FrameVelocity{s.tool}; }, abs},
      {"velocity in the axes of another frame",
       [](Setup s) {
         return R::FrameVelocity{s.tool, {Anchor::Tool, s.other(), tilt()}, 0.1};
       }},
      {"position seen from another frame",
       [](Setup s) {
         return R::FramePosition{s.tool, s.random(3), {s.other(), Anchor::World, tilt()}};
       }},
      {"position in axes that turn in another frame",
       [](Setup s) {
         return R::FramePosition{s.tool, s.random(3), turning_reference(Anchor::World, s.other())};
       }},
      {"distance",
       [](Setup s) {
         return R::FrameDistance{s.tool, s.random(3)};
       },
       inside},
      {"distance from a line that turns with another frame",
       [](Setup s) {
         return R::FrameDistance{s.tool, s.random(3), Directions::x() | Directions::z(),
                                 turning_reference(Anchor::World, s.other())};
       }},
      {"rotation against another frame",
       [](Setup s) {
         return R::FrameRotation{s.tool, s.quaternion(), {Anchor::Tool, s.other(), tilt()}};
       }},
      {"rotation against a surface",
       [](Setup s) {
         return R::FrameRotation{s.tool, s.quaternion(), following(saddle())};
       },
       abs},
      {"rotation in turning axes",
       [](Setup s) {
         return R::FrameRotation{s.tool, s.quaternion(),
                                 turning_reference(Anchor::World, Anchor::World)};
       }},
      {"inclination",
       [](Setup s) {
         return R::FrameInclination{s.tool, following(ball()), s.random(3), s.random(2)};
       },
       abs},
      {"inclination on a surface of another frame",
       [](Setup s) {
         return R::FrameInclination{s.tool, following(saddle(), s.other()), s.random(3)};
       }},
      {"inclination in the world", [](Setup s) { return R::FrameInclination{s.tool}; }, inside},
      {"height",
       [](Setup s) {
         return R::FrameHeight{s.tool, following(ball()), 0.1};
       },
       inside},
      {"height above a surface of another frame",
       [](Setup s) {
         return R::FrameHeight{s.tool, following(saddle(), frame_on_the_way(s.model, s.tool))};
       }},
      {"position along a surface",
       [](Setup s) {
         return R::FramePosition{s.tool, s.random(3), following(saddle())};
       }},
      {"position along a surface of another frame",
       [](Setup s) {
         return R::FramePosition{s.tool, s.random(3), following(ball(), s.other(), Anchor::World)};
       }},
      {"distance along a surface",
       [](Setup s) {
         return R::FrameDistance{s.tool, s.random(3), Directions::x() | Directions::y(),
                                 following(saddle())};
       }},
      {"velocity along a surface",
       [](Setup s) {
         return R::FrameVelocity{s.tool, following(saddle()), s.random(6)};
       }},
      {"velocity along a surface of another frame",
       [](Setup s) {
         return R::FrameVelocity{s.tool, following(ball(), s.other(), s.other())};
       }},
      {"force",
       [](Setup s) {
         return R::ContactForce{"pad", {}, s.random(6)};
       },
       abs, at_the_end},
      {"force along a surface",
       [](Setup s) {
         return R::ContactForce{"pad", following(ball(), s.other()), s.random(6)};
       },
       abs, at_the_end},
      {"cone about a surface's normal",
       [](Setup) {
         return R::FrictionCone{"pad", 0.7, 2, following(saddle(), Anchor::Base, Anchor::World)};
       },
       square, at_the_end},
      {"brace", [](Setup) { return R::ContactForce{"brace"}; }, square, at_the_end},
      {"local force",
       [](Setup) {
         return R::ContactForce{"pad", Reference::local(tilt())};
       },
       square, at_the_end},
      {"centered force",
       [](Setup) {
         return R::ContactForce{"pad", Reference::centered(), 3.0};
       },
       abs, at_the_end},
      {"world force",
       [](Setup) {
         return R::ContactForce{"brace", Reference::world()};
       },
       square, at_the_end},
      {"force about another frame in turning axes",
       [](Setup s) {
         return R::ContactForce{"pad", turning_reference(s.other(), Anchor::Tool), 1.0};
       },
       square, at_the_end},
      {"cone",
       [](Setup) {
         return R::FrictionCone{"pad", 0.4};
       },
       Penalty::at_least(1.0), at_the_end},
      {"local cone",
       [](Setup) {
         return R::FrictionCone{"pad", 0.7, 0, Reference::local()};
       },
       square, at_the_end},
      {"pyramid",
       [](Setup) { return R::FrictionCone{.contact = "pad", .friction = 0.4, .sides = 5}; },
       Penalty::at_least(1.0), at_the_end},
      {"pressure", [](Setup) { return R::CenterOfPressure{"pad"}; }, square, at_the_end},
      {"centre of mass", [](Setup s) { return R::CenterOfMass{s.random(3)}; }},
      {"support",
       [](Setup) {
         return R::SupportMargin{{{-0.1, -0.2}, {0.3, -0.1}, {0.2, 0.3}, {-0.2, 0.1}}};
       },
       Penalty::at_least(0.3)},
      {"momentum", [](Setup) { return R::CentroidalMomentum{}; }, abs},
      {"own",
       [](Setup s) { return R::custom(WithoutJacobian{.frames = {s.tool}, .contacts = {"pad"}}); },
       abs, at_the_end},
      {"own with jacobian",
       [](Setup s) {
         return R::custom(WithJacobian{.frames = {s.tool}, .contacts = {"pad", "brace"}});
       },
       square, at_the_end},
  };
  if (test.remembers) {
    cases.push_back({"force rate",
                     [](Setup s) {
                       return R::ContactForceRate{"pad", s.random(6)};
                     },
                     inside, false});
    cases.push_back(
        {"rate of a brace", [](Setup) { return R::ContactForceRate{"brace"}; }, abs, false});
  }
  if (test.torque_model)
    cases.push_back({"joint torque rate",
                     [](Setup) {
                       return R::JointTorqueRate{{}, 3.0};
                     },
                     inside, false});
  return cases;
}

inline std::string frame_on_the_way(const Model& model, const std::string& tool) {
  std::vector<int> bodies;
  for (int j = model.frames[static_cast<std::size_t>(model.frame_index(tool))].body; j >= 0;
       j = model.joints[static_cast<std::size_t>(j)].parent)
    bodies.push_back(j);
  const int middle = bodies[bodies.size() / 2];
  for (const Frame& frame : model.frames)
    if (frame.body == middle) return frame.name;
  throw Error("no frame on the way to " + tool);
}

/// "idle" never holds, "brace" holds one direction on the way to the tool, which turns, "pad" all
/// six of it, in axes that follow a curved surface.
inline std::vector<ContactSpec> ocp_contacts(const Model& model, const std::string& tool) {
  ContactSpec idle = contact(tool);
  ContactSpec pad = contact(
      tool, "world",
      Reference::on(Quadric::osculating({0.3, 0.0, 0.2}, tilt(), 0.6, 0.2, -0.9), {0.3, 0.0, 0.2}));
  ContactSpec brace = contact(frame_on_the_way(model, tool), "world",
                              turning_reference(Anchor::Tool, Anchor::World), Directions::z(),
                              Acceleration::Classical);
  idle.name = "idle";
  pad.name = "pad";
  pad.with_gains(0.0, 5.0);
  brace.name = "brace";
  return {idle, brace, pad};
}

/// Robots on a fixed base cannot hold seven directions rigidly: their contacts give way.
inline ContactSolver ocp_solver(const TestRobot& robot) {
  return {.mu = robot.base == Base::Fixed ? 0.05 : 0.0};
}

/// Everything but costs and horizon.
inline ProblemSpec bare_problem(const OcpCase& test, const Model& model) {
  std::mt19937_64 generator(11);
  ProblemSpec spec{.model = model};
  spec.contacts = ocp_contacts(model, test.robot.tool);
  if (test.rubs) spec.contacts[1].friction = {0.3, 0.3, 0.05};
  spec.contact_solver = ocp_solver(test.robot);
  spec.actuation.passive_torques = true;
  spec.actuation.slip_velocity = 0.5;
  if (test.torque_model)
    spec.torque_model = test.held ? TorqueModel::held() : TorqueModel{.cutoff = 30.0};
  spec.initial_state = OcpSetup{model, test.robot.tool, generator}.state(test);
  if (test.remembers) spec.remembered_forces = {"pad", "brace"};
  spec.start_time = 0.7;
  return spec;
}

/// One stage of one term per residual, each on as many knots as a pack has lanes; those that can
/// stand at the end also there.
inline ProblemSpec residual_problem(const OcpCase& test, const Model& model) {
  ProblemSpec spec = bare_problem(test, model);
  std::mt19937_64 generator(12);
  const OcpSetup setup{model, test.robot.tool, generator};
  for (const ResidualCase& given : residual_cases(test)) {
    CostTerm term{
        .name = given.name, .residual = given.make(setup), .weight = 0.7, .penalty = given.penalty};
    spec.stages.push_back({.name = given.name, .contacts = {"brace", "pad"}, .costs = {term}});
    spec.stages.back().step = 0.02;
    spec.horizon.push_back({given.name, native_lanes});
    if (given.at_the_end) spec.terminal.push_back(term);
  }
  return spec;
}

/// A state and a control at which rigid contacts are independent.
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
  state.x << s.q, s.v, uniform(l.filtered, 5.0, generator), uniform(l.remembered, 5.0, generator);
  return state;
}

/// Whether the values `r` of a residual are within 0.1 rad of the cut of a logarithm or an angle,
/// over which differences jump.
inline bool at_a_cut(const Residual& residual, const Eigen::VectorXd& r) {
  constexpr double largest = M_PI - 0.1;
  if (std::holds_alternative<residual::FrameRotation>(residual)) return r.norm() > largest;
  if (std::holds_alternative<residual::FramePlacement>(residual)) return r.tail(3).norm() > largest;
  if (const auto* of = std::get_if<residual::FrameInclination>(&residual)) {
    Eigen::VectorXd target = Eigen::VectorXd::Zero(2);
    if (!of->target.empty()) of->target.at(0.0, target);
    return (r + target).cwiseAbs().maxCoeff() > largest;
  }
  return false;
}
/// A random state at which a term is at no cut.
inline OcpState state_off_cuts(Problem& problem, int knot, int term, const Residual& residual,
                               std::mt19937_64& generator) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    OcpState state = random_ocp_state(problem, generator);
    if (!at_a_cut(residual, problem.residual(knot, term, state.x, state.u))) return state;
  }
  throw Error("every state is at the cut of an angle");
}

/// Trajectories of a whole horizon, and room for its expansion.
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
    int lead_size = 0;
    for (const LeadBlock& block : shape.blocks) lead_size += 2 * block.size * block.size;
    for (std::size_t k = 0; k < knots; ++k) {
      gradient.emplace_back(stride);
      hessian.emplace_back(stride, stride);
      dynamics.emplace_back(stride, stride);
      lead.emplace_back(lead_size);
      decay.emplace_back(shape.filtered);
      rows.emplace_back(problem.rows(static_cast<int>(k)), stride);
      bends.emplace_back(problem.max_bends(), stride);
      row_values.emplace_back(problem.rows(static_cast<int>(k)));
    }
    out.resize(knots);
    for (std::size_t k = 0; k < knots; ++k) point_at(k);
  }
  /// Of a copy: its expansion of knot k goes into its own room.
  void point_at(std::size_t k) {
    KnotExpansion& knot = out[k];
    knot.stride = stride;
    knot.gradient = gradient[k].data();
    knot.hessian = hessian[k].data();
    knot.dynamics = dynamics[k].data();
    knot.lead = lead[k].data();
    knot.decay = decay[k].data();
    knot.rows = rows[k].data();
    knot.bends = bends[k].data();
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
  std::vector<Eigen::VectorXd> gradient, lead, decay, row_values;
  std::vector<RowMatrix> hessian, dynamics, rows, bends;
  std::vector<KnotExpansion> out;
};

}  // namespace burnish::test
