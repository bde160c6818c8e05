// Tests of problem files: every key is read, and a bad file is refused with its place.
#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "support/problem_files.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

TEST_F(ProblemFiles, SmallFile_IsReadWithItsDefaults) {
  const ProblemFile file = read(small());
  const ProblemSpec& spec = file.spec;
  ASSERT_EQ(spec.contacts.size(), 1U);
  EXPECT_EQ(spec.contacts[0].name, "pad");
  EXPECT_EQ(spec.contacts[0].directions, Directions::z());
  EXPECT_EQ(spec.contacts[0].kd[2], 50.0);
  const Eigen::VectorXd q = file.robot.reference_configuration();
  const Eigen::Isometry3d tool = frame_placement(spec.model, q, "tool");
  EXPECT_TRUE(spec.contacts[0].target.isApprox(tool, 1e-12)) << "the default is the tool's pose";
  EXPECT_EQ(spec.initial_state.head(7), q);
  ASSERT_EQ(spec.stages.size(), 1U);
  const Stage& press = spec.stages[0];
  EXPECT_EQ(press.contacts, std::vector<std::string>{"pad"});
  EXPECT_EQ(press.step, 0.02);
  ASSERT_EQ(press.costs.size(), 3U);
  EXPECT_EQ(press.costs[0].weight, 0.5) << "a number is the weight of a shared term";
  EXPECT_EQ(press.costs[1].weight, 3.0) << "a map without a type changes a shared term";
  Eigen::VectorXd point(3);
  std::get<residual::FramePosition>(press.costs[1].residual).target.at(0.0, point);
  EXPECT_LT((point - tool.translation()).norm(), 1e-12);
  EXPECT_EQ(spec.terminal.at(0).weight, 7.0);
  EXPECT_EQ(spec.horizon.at(0).knots, 5);
  EXPECT_EQ(file.guess.kind, WarmStart::Kind::Hold);
}

TEST_F(ProblemFiles, FileWithEveryKey_IsReadCompletely) {
  const ProblemFile file = read(
      arm +
      "description: all of it\n"
      "start: {q: [0.07, 0.23, -0.19, -1.94, 0.23, -0.67, 0.3], velocity: {joint_2: 0.1},"
      " torques: {hold: {pad: 5}}, time: 0.5}\n"
      "contacts:\n"
      "  pad:\n"
      "    {tool: tool, base: world, reference: {surface: {normal: [0, 0.2, 1]}}, directions: z,\n"
      "     acceleration: spatial, error: log6, kp: [1, 2, 3, 4, 5, 6], kd: 2,\n"
      "     target: {xyz: [0, 0, 1], rpy: [0, 0, 0.1]}}\n"
      "contact_solver: {mu: 1e-6, max_proximal_iterations: 3, proximal_tolerance: 1e-8}\n"
      "actuation: {joints: [joint_1, joint_2, joint_4], passive_torques: true,"
      " slip_velocity: 0.02}\n"
      "torque_model: {cutoff: 30, discretization: euler}\n"
      "control_bounds: {effort_limits: 0.5, lower: {joint_1: -1, other: -2}}\n"
      "stages:\n"
      "  go:\n"
      "    contacts: pad\n"
      "    integrator: runge_kutta_4\n"
      "    costs:\n"
      "      a: {type: state, weights: {q: 1, v: {joint_1: 5, other: 2}, tau: 3},"
      " target: {posture: bent}}\n"
      "      b: {type: joint_position, joints: [joint_1, joint_2], weights: {joint_2: 4},"
      " penalty: {barrier: {limits: 0.5, lower: {joint_1: -9}}}}\n"
      "      c: {type: joint_velocity, penalty: {smooth_absolute: 0.1}}\n"
      "      d: {type: joint_torque, penalty: {log_barrier: {limits: 0.9, width: 2}}}\n"
      "      e: {type: frame_rotation, frame: tool, target: {rpy: [0, 0, 1]}}\n"
      "      f: {type: frame_placement, frame: tool, target: {xyz: [0.4, 0, 0.3]}}\n"
      "      g: {type: frame_velocity, frame: tool, axes: local, target: [0, 0, 0.1, 0, 0, 0]}\n"
      "      h: {type: contact_force, contact: pad, reference: world}\n"
      "      i: {type: center_of_mass, target: {here: [0.1, 0, 0]}}\n"
      "      j: {type: centroidal_momentum, weights: [1, 1, 1, 0, 0, 0]}\n"
      "      k: {type: control, target: hold, weight: 0.1}\n"
      "      l: {type: frame_position, frame: tool, axes: {normal: [1, 0, 0]},\n"
      "          target: {circle: {center: [0, 0, 1], radius: 2, rate: 3,\n"
      "                            axes: [[0, 1, 0], [0, 0, 1]], phase: 0.5}}}\n"
      "      n: {type: frame_velocity, frame: tool, reference: {axes: link_3, rpy: [0, 0, 1]}}\n"
      "      o: {type: frame_position, frame: tool, target: here,\n"
      "          reference: {origin: link_3, axes: link_3}}\n"
      "      q: {type: frame_distance, frame: tool, directions: [x, z], target: [1, 2, 3],\n"
      "          penalty: {barrier: {lower: 0.2}}}\n"
      "      r: {type: frame_distance, frame: tool, reference: {origin: link_3}}\n"
      "      s: {type: joint_torque_rate, joints: [joint_4, joint_2],\n"
      "          penalty: {barrier: {lower: -200, upper: {joint_2: 100, other: 200}}}}\n"
      "      t: {type: support_margin, points: [[0, 0], [1, 0], [0, 1]], weights: {edge_1: 2}}\n"
      "      p: {type: contact_force, contact: pad, reference: {axes: link_2, normal: [1, 0, 0]}}\n"
      "      m: {type: contact_force, contact: pad,\n"
      "          target: {sine: {center: 30, amplitude: 5, rate: 2, phase: 0.1}}}\n"
      "      u: {type: frame_rotation, frame: tool, target: here, reference: {axes: link_3}}\n"
      "      v: {type: frame_inclination, frame: tool, axis: [0, 0, -1], weights: {tilt: 2},\n"
      "          target: {lead: 0.1, tilt: 0},\n"
      "          reference: {surface: {sphere: {center: [0, 0, -1], radius: 1},"
      " near: [0.4, 0, 0]}}}\n"
      "      w: {type: frame_height, frame: tool, target: 0.05,\n"
      "          reference: {axes: link_3, cylinder: {point: [0, 0, -2], axis: [1, 0, 0],"
      " radius: 1}, near: [0, 0, 0]}}\n"
      "      x: {type: frame_position, frame: tool, target: here, weights: [1, 1, 0],\n"
      "          reference: {surface: {sphere: {center: [0, 0, -1], radius: 1},"
      " near: [0.4, 0, 0]}}}\n"
      "horizon:\n"
      "  - repeat: 2\n"
      "    of: [go: 3, go: 1]\n"
      "solver: {update: multiple_shooting, max_iterations: 7, threads: 2, pin_threads: true,\n"
      "         share_knots: false, segments: 2, stop_tolerance: 1e-5,\n"
      "         line_search: {halvings: 4}, regularization: {initial: 0.1}}\n"
      "guess: still\n");
  const ProblemSpec& spec = file.spec;
  EXPECT_EQ(spec.start_time, 0.5);
  EXPECT_EQ(spec.initial_state[8], 0.1);
  EXPECT_EQ(spec.initial_state.size(), 7 + 7 + 3);
  EXPECT_EQ(spec.contacts[0].acceleration, Acceleration::Spatial);
  EXPECT_EQ(spec.contacts[0].error, PoseError::Log6);
  EXPECT_EQ(spec.contacts[0].kp[5], 6.0);
  EXPECT_EQ(spec.contacts[0].target.translation().z(), 1.0);
  EXPECT_EQ(spec.contact_solver.max_proximal_iterations, 3);
  EXPECT_TRUE(spec.actuation.passive_torques);
  EXPECT_EQ(spec.torque_model->discretization, TorqueModel::Discretization::Euler);
  EXPECT_EQ(spec.control_lower, Eigen::Vector3d(-1, -2, -2));
  EXPECT_EQ(spec.control_upper[0], 90.0);
  const Stage& go = spec.stages[0];
  EXPECT_EQ(go.integrator, Integrator::RungeKutta4);
  EXPECT_EQ(go.costs[0].weights[7], 5.0);
  EXPECT_EQ(go.costs[0].weights[8], 2.0);
  EXPECT_EQ(go.costs[0].weights[14], 3.0);
  EXPECT_EQ(go.costs[1].weights, Eigen::Vector2d(1, 4));
  EXPECT_EQ(go.costs[1].penalty->lower[0], -9.0);
  EXPECT_EQ(go.costs[1].penalty->upper[1], 0.95);
  EXPECT_EQ(go.costs[3].penalty->width, 2.0);
  Eigen::VectorXd p(3), f(1);
  std::get<residual::FramePosition>(go.costs[11].residual).target.at(0.2, p);
  EXPECT_LT((p - Eigen::Vector3d(0, 2 * std::cos(1.1), 1 + 2 * std::sin(1.1))).norm(), 1e-12);
  const auto& turned = std::get<residual::FrameVelocity>(go.costs[12].residual).reference;
  EXPECT_EQ(turned.origin, Anchor(Anchor::Tool));
  EXPECT_EQ(turned.axes, Anchor("link_3"));
  EXPECT_NEAR(turned.rotation(0, 1), -std::sin(1.0), 1e-12);
  const auto& seen = std::get<residual::FramePosition>(go.costs[13].residual);
  const auto placement = [&](const char* frame) {
    return frame_placement(spec.model, spec.initial_state.head(7), frame);
  };
  seen.target.at(0.0, p);  // 'here' in the axes of link_3
  EXPECT_LT((placement("link_3") * Eigen::Vector3d(p) - placement("tool").translation()).norm(),
            1e-12);
  const auto& apart = std::get<residual::FrameDistance>(go.costs[14].residual);
  EXPECT_EQ(apart.directions, Directions::x() | Directions::z());
  apart.target.at(0.0, p);
  EXPECT_EQ(p, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(go.costs[14].penalty->lower, Eigen::VectorXd::Constant(1, 0.2));
  const auto& from_link = std::get<residual::FrameDistance>(go.costs[15].residual);
  EXPECT_TRUE(from_link.target.empty());
  EXPECT_EQ(from_link.reference.origin, Anchor("link_3"));
  EXPECT_EQ(std::get<residual::JointTorqueRate>(go.costs[16].residual).joints.size(), 2U);
  EXPECT_EQ(go.costs[16].penalty->upper, Eigen::Vector2d(200, 100));
  EXPECT_EQ(std::get<residual::SupportMargin>(go.costs[17].residual).points[1],
            Eigen::Vector2d(1, 0));
  EXPECT_EQ(go.costs[17].weights, Eigen::Vector3d(1, 2, 1));
  const auto& force_reference = *std::get<residual::ContactForce>(go.costs[18].residual).reference;
  EXPECT_EQ(force_reference.axes, Anchor("link_2"));
  EXPECT_EQ(force_reference.rotation.col(2), Eigen::Vector3d::UnitX());
  std::get<residual::ContactForce>(go.costs[19].residual).target.at(0.2, f);
  EXPECT_NEAR(f[0], 30 + 5 * std::sin(0.5), 1e-12);
  const auto& turn = std::get<residual::FrameRotation>(go.costs[20].residual);
  EXPECT_EQ(turn.reference.axes, Anchor("link_3"));
  Eigen::VectorXd xyzw(4);
  turn.target.at(0.5, xyzw);
  const Eigen::VectorXd start = spec.initial_state.head(7);
  const Eigen::Matrix3d here = frame_placement(spec.model, start, "link_3").linear().transpose() *
                               frame_placement(spec.model, start, "tool").linear();
  EXPECT_LT(
      (Eigen::Quaterniond(xyzw[3], xyzw[0], xyzw[1], xyzw[2]).toRotationMatrix() - here).norm(),
      1e-9);
  const auto& inclination = std::get<residual::FrameInclination>(go.costs[21].residual);
  EXPECT_EQ(inclination.axis, Eigen::Vector3d(0.0, 0.0, -1.0));
  Eigen::VectorXd angles(2);
  inclination.target.at(0.5, angles);
  EXPECT_EQ(angles, Eigen::Vector2d(0.1, 0.0));
  EXPECT_EQ(go.costs[21].weights, Eigen::Vector2d(1.0, 2.0));
  const auto& height = std::get<residual::FrameHeight>(go.costs[22].residual);
  EXPECT_EQ(height.reference.axes, Anchor("link_3"));
  EXPECT_EQ(height.reference.quadric->Q, Quadric::cylinder({0, 0, -2}, {1, 0, 0}, 1.0).Q);
  const auto& along = std::get<residual::FramePosition>(go.costs[23].residual);
  EXPECT_EQ(along.reference.origin, Anchor(Anchor::Tool));
  EXPECT_TRUE(along.reference.quadric.has_value());
  EXPECT_EQ(spec.horizon.size(), 4U);
  EXPECT_EQ(file.solver.update, StepUpdate::MultipleShooting);
  EXPECT_EQ(file.solver.threads, 2);
  EXPECT_TRUE(file.solver.pin_threads);
  EXPECT_FALSE(file.solver.share_knots);
  EXPECT_EQ(file.solver.segments, 2);
  EXPECT_EQ(file.solver.line_search.halvings, 4);
  EXPECT_EQ(file.guess.kind, WarmStart::Kind::Still);
}

TEST_F(ProblemFiles, HorizonSteps_SetTheStepsOfTheirKnots) {
  const ProblemFile file = read(small("- press: 5",
                                      "- press: 2\n"
                                      "  - press: {knots: 3, step: 0.03}\n"
                                      "  - press: {knots: 4, step: 0.01, duration: 0.15}\n"
                                      "  - press: {knots: 2, duration: 0.05}"));
  const std::vector<double> steps = knot_steps(file.spec);
  const double wanted[] = {0.02, 0.02, 0.03, 0.03, 0.03, 0.01, 0.02, 0.04, 0.08, 0.02, 0.03};
  ASSERT_EQ(steps.size(), std::size(wanted));
  for (std::size_t k = 0; k < steps.size(); ++k) EXPECT_NEAR(steps[k], wanted[k], 1e-12) << k;
}

TEST_F(ProblemFiles, Constraints_AreReadWithTheirLimits) {
  const ProblemFile file =
      read(small("    costs:\n",
                 "    constraints:\n"
                 "      range: {type: joint_position, limits: 0.9}\n"
                 "      band: {type: contact_force, contact: pad, lower: 25, upper: {z: 35}}\n"
                 "    costs:\n",
                 "terminal_constraints:\n"
                 "  stopped: {type: joint_velocity, lower: 0, upper: 0}\n"));
  const ProblemSpec& spec = file.spec;
  const std::vector<Constraint>& constraints = spec.stages[0].constraints;
  ASSERT_EQ(constraints.size(), 2U);
  EXPECT_EQ(constraints[0].name, "range");
  EXPECT_NEAR(constraints[0].upper[1], 0.95 * spec.model.q_upper[1] + 0.05 * spec.model.q_lower[1],
              1e-12);
  EXPECT_EQ(constraints[1].lower, Eigen::VectorXd::Constant(1, 25.0));
  EXPECT_EQ(constraints[1].upper, Eigen::VectorXd::Constant(1, 35.0));
  ASSERT_EQ(spec.terminal_constraints.size(), 1U);
  const Problem problem(spec);
  EXPECT_EQ(problem.row_names(0).back(), "band/z");
  EXPECT_EQ(problem.rows(problem.knots()), spec.model.nv);
}

TEST_F(ProblemFiles, CenterOfPressure_RowsHaveTheNamesOfTheirEdges) {
  std::string text =
      small("    costs:\n",
            "    constraints:\n"
            "      foot: {type: center_of_pressure, contact: pad, half_x: 0.1, half_y: 0.05,\n"
            "             lower: {x_above: 1, x_below: 2, y_below: 3, y_above: 4}}\n"
            "    costs:\n");
  for (const auto& [from, to] : {std::pair{"directions: z", "directions: pad_z, reference: local"},
                                 {"pad, target: 30", "pad, target: [30, 0, 0]"}})
    text.replace(text.find(from), std::string(from).size(), to);
  Problem problem(read(text).spec);
  const std::vector<std::string> names{"foot/x_above", "foot/x_below", "foot/y_below",
                                       "foot/y_above"};
  EXPECT_EQ(problem.row_names(0), names);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(problem.row_lower(0)[i], i + 1.0);
  const Eigen::VectorXd x = problem.spec().initial_state, u = Eigen::VectorXd::Constant(7, 2.0);
  const Eigen::Vector3d force = problem.forces(0, x, u);  // z, rx, ry
  const Eigen::Vector2d centre(-force[2] / force[0], force[1] / force[0]);
  const std::vector<double> rows = problem.row_values(0, x.data(), u.data());
  EXPECT_NEAR(rows[0], force[0] * (0.1 - centre.x()), 1e-9);
  EXPECT_NEAR(rows[1], force[0] * (0.1 + centre.x()), 1e-9);
  EXPECT_NEAR(rows[2], force[0] * (0.05 + centre.y()), 1e-9);
  EXPECT_NEAR(rows[3], force[0] * (0.05 - centre.y()), 1e-9);
}

TEST_F(ProblemFiles, PointsOfATable_AreInterpolatedAndConstantOutside) {
  write("time [s],x [m],y [m],z [m]\n0,0,0,0\n1,1,0,2\n2,1,1,2\n", "path.csv");
  const ProblemFile file =
      read(small("frame: tool, target: here",
                 "frame: tool, target: {points: {file: path.csv, columns: [x, y, z]}}"));
  const Signal& target =
      std::get<residual::FramePosition>(file.spec.stages[0].costs[1].residual).target;
  Eigen::VectorXd p(3);
  for (const auto& [time, expected] : {std::pair{-1.0, Eigen::Vector3d(0, 0, 0)},
                                       {0.5, Eigen::Vector3d(0.5, 0, 1)},
                                       {1.25, Eigen::Vector3d(1, 0.25, 2)},
                                       {9.0, Eigen::Vector3d(1, 1, 2)}}) {
    target.at(time, p);
    EXPECT_LT((p - expected).norm(), 1e-12) << time;
  }
}

TEST_F(ProblemFiles, LineTarget_IsAtRestAtBothEnds) {
  const ProblemFile file = read(small("target: 30",
                                      "target: {line: {from: 0, to: 30, start: 1,"
                                      " duration: 2}}"));
  const Signal& target =
      std::get<residual::ContactForce>(file.spec.stages[0].costs[2].residual).target;
  Eigen::VectorXd f(1);
  for (const auto& [time, expected] :
       {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.001, 0.0}, {2.0, 15.0}, {2.999, 30.0}, {4.0, 30.0}}) {
    target.at(time, f);
    EXPECT_NEAR(f[0], expected, 1e-6) << time;
  }
}

TEST_F(ProblemFiles, TorqueStates_HaveNoCostUnlessStated) {
  const ProblemFile file = read(small("", "", "torque_model: held\n"));
  ASSERT_TRUE(file.spec.torque_model && file.spec.torque_model->is_held());
  EXPECT_EQ(file.spec.initial_state.size(), 21);
  EXPECT_GT(file.spec.initial_state.tail(7).norm(), 0.1) << "default: torques of the robot at rest";
  const Eigen::VectorXd unstated = file.spec.stages[0].costs[0].weights;
  ASSERT_EQ(unstated.size(), 21);
  EXPECT_EQ(unstated.head(14), Eigen::VectorXd::Ones(14));
  EXPECT_TRUE(unstated.tail(7).isZero(0.0));
  const ProblemFile stated = read(small(
      "{type: state, weight: 2}", "{type: state, weights: {tau: 3}}", "torque_model: held\n"));
  EXPECT_EQ(stated.spec.stages[0].costs[0].weights.tail(7), Eigen::VectorXd::Constant(7, 3.0));
}

TEST_F(ProblemFiles, ForceStates_StartAtTheForcesAtRestUnlessStated) {
  const auto of = [&](const std::string& start) {
    return read(small("posture: 0.5",
                      "rate: {type: contact_force_rate, contact: pad}\n"
                      "      posture: 0.5",
                      "force_states: pad\n" + start));
  };
  const ProblemFile unstated = of("");
  ASSERT_EQ(unstated.spec.initial_state.size(), 15);
  const Eigen::VectorXd weights = unstated.spec.stages[0].costs[1].weights;
  ASSERT_EQ(weights.size(), 15) << "force states have no cost by default";
  EXPECT_EQ(weights.head(14), Eigen::VectorXd::Ones(14));
  EXPECT_EQ(weights[14], 0.0);
  Problem problem(unstated.spec);
  const TrajectoryGuess guess = make_guess(problem, {});
  const Eigen::VectorXd x = guess.xs.row(1), u = guess.us.row(0);
  EXPECT_NEAR(x[14], problem.forces(0, x, u)[0], 1e-9) << "default: force of the robot at rest";
  EXPECT_NEAR(x[14], unstated.spec.initial_state[14], 1e-12);
  EXPECT_EQ(of("start: {forces: {pad: 12}}\n").spec.initial_state[14], 12.0);
  const ProblemFile torques = of("torque_model: held\nstart: {torques: {hold: {pad: 30}}}\n");
  ASSERT_EQ(torques.spec.initial_state.size(), 22);
  EXPECT_EQ(torques.spec.initial_state[21], 30.0);
}

TEST_F(ProblemFiles, HoldTarget_KeepsTheRobotAtRest) {
  const ProblemFile file =
      read(small("posture: 0.5", "hold: {type: control, target: {hold: {pad: 30}}}"));
  Problem problem(file.spec);
  Eigen::VectorXd u(7);
  std::get<residual::Control>(file.spec.stages[0].costs[0].residual).target.at(0.0, u);
  EXPECT_LT(problem.acceleration(0, file.spec.initial_state, u).norm(), 1e-9);
  EXPECT_NEAR(problem.forces(0, file.spec.initial_state, u)[0], 30.0, 1e-9);
  // Without a given force, the guess is a robot at rest, too.
  const TrajectoryGuess guess = make_guess(problem, {});
  EXPECT_LT(problem.acceleration(0, file.spec.initial_state, guess.us.row(0).transpose()).norm(),
            1e-9);
}

struct BadFile {
  std::string from, to, more;
  std::vector<std::string> words;
};

TEST_F(ProblemFiles, BadFiles_AreRefusedWithTheirPlace) {
  const std::vector<BadFile> table{
      {"contacts:\n  pad", "contact:\n  pad", "", {"'contact' is unknown", "'contacts'?"}},
      {"directions: z", "direction: z", "", {"line 3: contacts.pad:", "'directions'?"}},
      {"directions: z", "directions: zz", "", {"contacts.pad.directions:", "unknown word 'zz'"}},
      {"tool: tool", "tool: tol", "", {"contacts.pad.tool:", "did you mean 'tool'"}},
      {"kd: 50", "kd: much", "", {"contacts.pad.kd: 'much' is not a number"}},
      {"kd: 50", "kd: [1, 2]", "", {"it has 2 numbers; wanted 6"}},
      {"kd: 50", "reference: sureface", "", {"contacts.pad.reference", "'surface'?"}},
      {"kd: 50", "reference: {axes: link_99}", "", {"'pad'", "reference", "did you mean"}},
      {"kd: 50", "reference: {axis: link_3}", "", {"'axis' is unknown", "'axes'?"}},
      {"kd: 50",
       "reference: {local: {rpy: [0, 0, 1]}, axes: link_3}",
       "",
       {"'local' excludes all other keys"}},
      {"type: state", "type: stat", "", {"terms.posture.type", "did you mean 'state'?"}},
      {"weight: 2", "wheight: 2", "", {"terms.posture", "did you mean 'weight'?"}},
      {"posture: 0.5", "posture: -1", "", {"stages.press.costs.posture: it is -1"}},
      {"posture: 0.5", "postur: 0.5", "", {"costs.postur: it has no 'type'", "'posture'?"}},
      {"contact: pad", "contact: pat", "", {"force.contact", "did you mean 'pad'?"}},
      {"target: 30", "target: [1, 2]", "", {"force.target: it has 2 numbers; wanted 1"}},
      {"target: 30", "target: here", "", {"force.target: 'here' is not defined for this residual"}},
      {"target: 30", "target: soon", "", {"force.target: 'soon' is not a target"}},
      {"target: 30", "target: {ramp: 3}", "", {"force.target: key 'ramp' is unknown"}},
      {"target: 30", "target: {hold: {pat: 3}}", "", {"did you mean 'pad'?"}},
      {"target: 30",
       "target: {line: {from: 0, to: 1, duration: 0}}",
       "",
       {"line.duration: it is 0; wanted more than 0"}},
      {"target: 30",
       "target: {points: {file: no.csv, columns: a}}",
       "",
       {"points.file:", "no.csv", "cannot be opened"}},
      {"target: here", "target: {circle: {radius: 1, rate: 1}}", "", {"'center' and 'start'"}},
      {"frame_position, frame: tool",
       "frame_distance, frame: tool, directions: xw",
       "",
       {"point.directions:", "'xw'"}},
      {"target: here", "target: nan", "", {"point.target: nan is not finite"}},
      {"frame: tool", "frame: tol", "", {"frame: ", "did you mean 'tool'?"}},
      {"contacts: [pad]", "contacts: [pod]", "", {"stages.press.contacts", "'pad'?"}},
      {"contacts: [pad]", "contacts: []", "", {"term 'force'", "'pad'", "is not active"}},
      {"step: 0.02",
       "constraints: {still: {type: joint_velocity, weight: 1}}",
       "",
       {"stages.press.constraints.still: key 'weight' is unknown"}},
      {"step: 0.02",
       "constraints: {still: {type: state, lower: 0}}",
       "",
       {"constraints.still.type: the residual 'state' cannot", "'joint_velocity'"}},
      {"step: 0.02",
       "constraints: {still: {type: joint_velocity}}",
       "",
       {"constraint 'still'", "no limits"}},
      {"step: 0.02", "step: 0", "", {"stages.press.step: it is 0; wanted more than 0"}},
      {"step: 0.02", "step: 0.02\n    impact: maybe", "", {"stages.press.impact", "true or false"}},
      {"step: 0.02", "integrator: euler", "", {"stages.press.integrator", "is unknown"}},
      {"- press: 5", "- pres: 5", "", {"horizon[0]", "did you mean 'press'?"}},
      {"- press: 5", "- press: 0", "", {"horizon[0].press: it is 0; wanted at least 1"}},
      {"- press: 5", "- press: {step: 0.1}", "", {"horizon[0].press", "knots"}},
      {"- press: 5",
       "- press: {knots: 5, steps: 0.1}",
       "",
       {"horizon[0].press", "'steps'", "did you mean 'step'?"}},
      {"- press: 5", "- press: {knots: 5, step: 0}", "", {"horizon[0].press.step"}},
      {"- press: 5",
       "- press: {knots: 5, step: 0.01, duration: 9}",
       "",
       {"'press' has a duration of 9 s with 5 knots", "0.01 s", "0.31 s"}},
      {"- press: 5", "- press: 2.5", "", {"it is 2.5; wanted a whole number"}},
      {"- press: 5", "- press", "", {"horizon[0]: it is not a stage with its number of knots"}},
      {"posture: 7", "force: {type: contact_force, contact: pad}", "", {"terminal, term 'force'"}},
      {"", "", "solver: {max_iteration: 3}\n", {"solver:", "did you mean 'max_iterations'?"}},
      {"",
       "",
       "solver: {stop_tolerance: -1}\n",
       {"solver.stop_tolerance: it is -1; wanted at least 0"}},
      {"", "", "solver: {threads: 2000}\n", {"solver.threads: it is 2000; wanted 1 to 1024"}},
      {"",
       "",
       "solver: {line_search: {merit_fraction: 1}}\n",
       {"solver.line_search.merit_fraction: it is 1; wanted at least 0 and less than 1"}},
      {"",
       "",
       "solver: {regularization: {factor: 1}}\n",
       {"solver.regularization.factor: it is 1; wanted more than 1"}},
      {"",
       "",
       "solver: {regularization: {largest: 1e-10}}\n",
       {"regularization.largest is 1e-10; wanted a number that is at least "
        "regularization.smallest"}},
      {"", "", "solver: {callback: 3}\n", {"solver: ", "'callback'"}},
      {"", "", "guess: zero\n", {"guess: 'zero' is unknown; wanted hold or still"}},
      {"", "", "start: {posture: redy}\n", {"start.posture", "did you mean 'ready'?"}},
      {"", "", "start: {posture: {joint_9: 1}}\n", {"start.posture", "joint_9"}},
      {"", "", "start: {q: [1, 2]}\n", {"start.q: it has 2 numbers; wanted 7"}},
      {"", "", "start: {torques: hold}\n", {"start.torques", "only with a 'torque_model'"}},
      {"", "", "start: {forces: {pad: 1}}\n", {"start.forces", "only with 'force_states'"}},
      {"", "", "force_states: [pads]\n", {"force_states", "'pads'", "'pad'"}},
      {"", "", "torque_model: hold\n", {"torque_model: 'hold' is unknown", "did you mean 'held'?"}},
      {"", "", "torque_model: {cutof: 3}\n", {"torque_model:", "did you mean 'cutoff'?"}},
      {"", "", "torque_model: {cutoff: 300, discretization: euler}\n", {"unstable"}},
      {"", "", "control_bounds: {lower: 3, upper: 2}\n", {"control_lower 3 is above"}},
      {"", "", "actuation: {joints: [joint_8]}\n", {"actuation.joints", "joint_8"}},
      {"", "", "horizon: []\n", {"'horizon' is stated twice"}},
      {"robot: ", "robot: [", "", {"this is not valid YAML"}},
      {"/arm7", "/arm8", "", {"line 1: robot:", "arm8", "does not exist"}},
      {"kd: 50}", "kd: 50}\n  pad: {tool: tool}", "", {"key 'pad' is stated twice"}},
      {"type: state", "type: state, penalty: {barrier: limits}", "", {"states no limits"}},
      {"type: state",
       "type: state, penalty: barrier",
       "",
       {"penalty: the penalty has no parameters"}},
      {"type: state",
       "type: state, weights: {joint_1: 1}",
       "",
       {"weights", "'joint_1' is unknown"}},
  };
  for (const BadFile& row : table) {
    const std::string text = small(row.from, row.to, row.more);
    const std::string sentence = refusal([&] { read(text); });
    expect_words(sentence, row.words);
    EXPECT_EQ(sentence.rfind((scratch_.folder / "problem.yaml").string() + ": ", 0), 0U)
        << sentence;
  }
  expect_words(refusal([&] { read_problem_file(scratch_.folder / "none.yaml"); }),
               {"cannot be opened"});
  expect_words(refusal([&] { read_problem_file(scratch_.folder); }), {"this is a folder"});
}

}  // namespace
}  // namespace burnish::testing
