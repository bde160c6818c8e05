// Tests of the commands with robots that have kinematic loops.
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;

const std::string robots = BURNISH_ROBOTS_DIR;

TEST(LoopCommands, Show_CountsDegreesOfFreedomAndNamesRedundantRows) {
  const Outcome table = run("show " + robots + "/gripper");
  ASSERT_EQ(table.exit_code, 0) << table.err;
  EXPECT_EQ(table.err, "");
  for (const char* words : {"5 entries of v, 10 rows of rank 4: 1 degrees of freedom",
                            "left_pin   x,y,z,rx,rz  y,rx,rz"})
    EXPECT_NE(table.out.find(words), std::string::npos) << words << "\n" << table.out;
  const Json json = Json::parse(run("show --json " + robots + "/four_bar").out);
  EXPECT_EQ(json["degrees_of_freedom"], 1);
  EXPECT_EQ(json["loop_rows"], 3);
  EXPECT_EQ(json["loop_rank"], 2);
  EXPECT_EQ(json["loops"][0]["redundant"], Json::parse(R"(["y"])"));
}

TEST(LoopCommands, Eval_ClosesTheLoopsByDefault) {
  const Outcome outcome = run("eval -", R"({"robot": ")" + robots + R"(/four_bar",
      "states": [{"q": {"drive": 1.0}}], "compute": ["forward", "contact_error"]})");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json answer = Json::parse(outcome.out);
  EXPECT_EQ(answer["row_names"], Json::parse(R"(["pin/x", "pin/z"])"));
  const Json& state = answer["states"][0];
  EXPECT_EQ(state["status"], "ok");
  for (const double error : state["contact_error"]) EXPECT_LT(std::abs(error), 1e-8);
}

/// Forward dynamics with the torques of the loop inverse returns the accelerations.
TEST(LoopCommands, EvalLoopInverse_ReturnsTheTorquesOfAMotion) {
  for (const auto& [robot, motion] :
       {std::pair<std::string, std::string>{"four_bar",
                                            R"("q": {"drive": 1.0}, "v": {"drive": 2.0},
                                               "a": {"drive": -3.0})"},
        {"gripper", R"("v": {"left_drive": 0.4}, "a": {"left_drive": 1.5})"},
        {"parallel_ankle", R"("v": {"knee": 0.7, "left_motor": 0.5, "right_motor": -0.3},
                              "a": {"knee": -1.0, "left_motor": 2.0, "right_motor": 1.0})"}}) {
    const std::string head = R"({"robot": ")" + robots + "/" + robot + R"(", "states": [{)";
    const Outcome found =
        run("eval -", head + motion + R"(}], "compute": ["loop_inverse", "contact_velocity"]})");
    ASSERT_EQ(found.exit_code, 0) << found.err << found.out;
    const Json answer = Json::parse(found.out), inverse = answer["states"][0]["loop_inverse"];
    EXPECT_LT(inverse["unbalanced"].get<double>(), 1e-9) << robot;
    const std::string q =
        motion.find("\"q\"") == std::string::npos ? "" : R"("q": {"drive": 1.0}, )";
    const Outcome back = run("eval -", head + q + R"("v": )" + inverse["v"].dump() +
                                           R"(, "tau": )" + inverse["tau"].dump() +
                                           R"(}], "compute": ["forward", "contact_velocity"]})");
    ASSERT_EQ(back.exit_code, 0) << back.err;
    const Json state = Json::parse(back.out)["states"][0];
    double max_acceleration = 0.0;
    for (std::size_t k = 0; k < inverse["a"].size(); ++k) {
      EXPECT_NEAR(state["forward"]["a"][k].get<double>(), inverse["a"][k].get<double>(), 1e-6)
          << robot << ' ' << answer["v_names"][k];
      max_acceleration = std::max(max_acceleration, std::abs(inverse["a"][k].get<double>()));
    }
    EXPECT_GT(max_acceleration, 1.0);
    for (const double v : state["contact_velocity"]) EXPECT_LT(std::abs(v), 1e-9) << robot;
  }
  const Outcome refused = run("eval -", R"({"robot": "arm7", "compute": "loop_inverse"})");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("has no loops"), std::string::npos) << refused.err;
}

TEST(LoopCommands, CheckOfEveryLoopRobot_Passes) {
  for (const char* name : {"four_bar", "parallel_ankle", "gripper"}) {
    const Outcome outcome = run("check --states 2 " + robots + "/" + name);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  }
}

TEST(LoopCommands, BenchOfALoopRobot_MeasuresThreeControls) {
  const Outcome outcome =
      run("bench --seconds 0.01 --knots 20 --json " + robots + "/parallel_ankle");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["nu"], 3);
}

}  // namespace
}  // namespace burnish::testing
