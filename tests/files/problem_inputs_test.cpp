// Tests of inputs in problem files: every kind and every use is read, and a wrong name is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "burnish/ocp/problem.hpp"
#include "support/problem_files.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

/// Returns a problem with an input of each kind, and each use of inputs.
std::string with_inputs() {
  return arm +
         "inputs:\n"
         "  force_error: 0.5\n"
         "  torque_error: [0, 0, 0, 0, 0, 0, 1]\n"
         "  grip: {kind: scalar, value: {line: {from: 0.2, to: 0.4, duration: 0.2,\n"
         "                                      profile: constant_speed}}}\n"
         "  ratio: {kind: scalar}\n"
         "  turn: {kind: rotation, value: {rpy: [0, 0, 1]}}\n"
         "  shift: {kind: vector, value: [0.1, 0, 0]}\n"
         "  surface: {kind: surface}\n"
         "  load: {kind: inertia, frame: tool}\n"
         "torque_bias_input: torque_error\n"
         "contacts:\n"
         "  pad:\n"
         "    {tool: tool, directions: z, kd: 50, surface_input: surface,\n"
         "     reference: {surface: {sphere: {center: [0.4, 0, -1], radius: 1}, near: [0.4, 0, "
         "0]}},\n"
         "     friction: {coefficient: 0.3, coefficient_input: grip}}\n"
         "  foot: {tool: tool, directions: [x, y, z], kd: 50}\n"
         "stages:\n"
         "  press:\n"
         "    contacts: [pad]\n"
         "    step: 0.02\n"
         "    costs:\n"
         "      force: {type: contact_force, contact: pad, target: 30, offset_input: force_error}\n"
         "      axes: {type: frame_rotation, frame: tool, target: here, offset_input: turn}\n"
         "      point: {type: frame_position, frame: tool, target: here, offset_input: shift,\n"
         "              surface_input: surface}\n"
         "  stand:\n"
         "    contacts: [foot]\n"
         "    costs: {rest: {type: state}}\n"
         "    constraints:\n"
         "      cone: {type: friction_cone, contact: foot, friction_ratio_input: ratio}\n"
         "horizon: [press: 4, stand: 2]\n";
}

TEST_F(ProblemFiles, InputsOfEachKind_AreRead) {
  const ProblemFile file = read(with_inputs());
  const std::vector<InputSpec>& inputs = file.spec.inputs;
  ASSERT_EQ(inputs.size(), 8U);
  const InputKind kinds[] = {InputKind::Scalar,  InputKind::Vector,   InputKind::Scalar,
                             InputKind::Scalar,  InputKind::Rotation, InputKind::Vector,
                             InputKind::Surface, InputKind::Inertia};
  for (std::size_t i = 0; i < inputs.size(); ++i)
    EXPECT_EQ(inputs[i].kind, kinds[i]) << inputs[i].name;
  EXPECT_EQ(inputs[7].frame, "tool");
  const Problem problem(file.spec);
  EXPECT_EQ(problem.input_at(problem.input_index("force_error"), 3)[0], 0.5);
  EXPECT_EQ(problem.input_at(problem.input_index("torque_error"), 3)[6], 1.0);
  EXPECT_NEAR(problem.input_at(problem.input_index("grip"), 3)[0], 0.26, 1e-12);
  EXPECT_EQ(problem.input_at(problem.input_index("ratio"), 3).size(), 0);
  EXPECT_NEAR(problem.input_at(problem.input_index("turn"), 3)[2], std::sin(0.5), 1e-12);
  EXPECT_EQ(problem.input_at(problem.input_index("shift"), 3), Eigen::Vector3d(0.1, 0.0, 0.0));
}

TEST_F(ProblemFiles, UsesOfInputs_AreRead) {
  const ProblemSpec spec = read(with_inputs()).spec;
  EXPECT_EQ(spec.torque_bias_input, "torque_error");
  EXPECT_EQ(spec.contacts[0].surface_input, "surface");
  EXPECT_EQ(spec.contacts[0].friction->coefficient_input, "grip");
  EXPECT_EQ(spec.contacts[1].surface_input, "");
  const std::vector<CostTerm>& costs = spec.stages[0].costs;
  EXPECT_EQ(costs[0].offset_input, "force_error");
  EXPECT_EQ(costs[1].offset_input, "turn");
  EXPECT_EQ(costs[2].offset_input, "shift");
  EXPECT_EQ(costs[2].surface_input, "surface");
  EXPECT_EQ(spec.stages[1].constraints[0].friction_ratio_input, "ratio");
}

TEST_F(ProblemFiles, OffsetOfAFile_MovesTheTarget) {
  const auto residual_with = [&](const std::string& use) {
    const ProblemFile file = read(small("target: 30", "target: 30" + use, "inputs: {error: 2}\n"));
    Problem problem(file.spec);
    const Eigen::VectorXd u = Eigen::VectorXd::Zero(7);
    return problem.residual(1, problem.term_index(0, "force"), file.spec.initial_state, u)[0];
  };
  EXPECT_NEAR(residual_with(", offset_input: error"), residual_with("") - 2.0, 1e-9);
}

TEST_F(ProblemFiles, BadInputs_AreRefusedWithTheirPlace) {
  struct BadInput {
    std::string from, to, more;
    std::vector<std::string> words;
  };
  const std::string force = "contact: pad, target: 30", error = "inputs: {error: 2}\n";
  const std::vector<BadInput> table{
      {force,
       force + ", offset_input: eror",
       error,
       {"line 14: stages.press.costs.force.offset_input: unknown input 'eror'",
        "did you mean 'error'?"}},
      {force,
       force + ", offset_input: error",
       "",
       {"force.offset_input: unknown input 'error'; the file has no 'inputs'"}},
      {force,
       force + ", surface_input: error",
       error,
       {"'force'", "input 'error' is a scalar; wanted a surface"}},
      {"kd: 50",
       "kd: 50, surface_input: eror",
       error,
       {"contacts.pad.surface_input: unknown input 'eror'", "did you mean 'error'?"}},
      {"kd: 50",
       "kd: 50, surface_input: ball",
       "inputs: {ball: {kind: surface}}\n",
       {"'pad'", "follows no surface"}},
      {"kd: 50",
       "kd: 50, friction: {coefficient_input: grp}",
       "inputs: {grip: 0.3}\n",
       {"contacts.pad.friction.coefficient_input: unknown input 'grp'", "did you mean 'grip'?"}},
      {"", "", "torque_bias_input: eror\n" + error, {"torque_bias_input: unknown input 'eror'"}},
      {"",
       "",
       "torque_bias_input: error\n" + error,
       {"input 'error' is a scalar; wanted a vector"}},
      {"",
       "",
       "inputs: {error: {kind: scaler}}\n",
       {"inputs.error.kind", "did you mean 'scalar'?"}},
      {"", "", "inputs: {error: {valu: 1}}\n", {"inputs.error", "did you mean 'value'?"}},
      {"", "", "inputs: {error: much}\n", {"inputs.error: it is not an input"}},
      {"", "", "inputs: {error: {kind: vector}}\n", {"inputs.error", "'value' is missing"}},
      {"", "", "inputs: {error: {value: [1, 2]}}\n", {"inputs.error.value"}},
      {"",
       "",
       "inputs: {ball: {kind: surface, value: 3}}\n",
       {"inputs.ball.value: a surface or an inertia has no value"}},
      {"", "", "inputs: {load: {kind: inertia}}\n", {"inputs.load", "'frame' is missing"}},
      {"",
       "",
       "inputs: {load: {kind: inertia, frame: tol}}\n",
       {"inputs.load.frame", "did you mean 'tool'?"}},
      {"",
       "",
       "inputs: {load: {value: 1, frame: tool}}\n",
       {"inputs.load.frame: only an input of the kind 'inertia' has a frame"}},
  };
  for (const BadInput& row : table)
    expect_words(refusal([&] { read(small(row.from, row.to, row.more)); }), row.words);
}

}  // namespace
}  // namespace burnish::testing
