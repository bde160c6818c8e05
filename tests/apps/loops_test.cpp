// Robots with loops, from outside.
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;

const std::string robots = BURNISH_ROBOTS_DIR;

TEST(LoopsProgram, ShowCountsDegreesOfFreedomAndNamesRedundantRows) {
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

TEST(LoopsProgram, EvalHoldsTheLoopsUnasked) {
  const Outcome outcome = run("eval -", R"({"robot": ")" + robots + R"(/four_bar",
      "states": [{"q": {"drive": 1.0}}], "compute": ["forward", "contact_error"]})");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json answer = Json::parse(outcome.out);
  EXPECT_EQ(answer["row_names"], Json::parse(R"(["pin/x", "pin/z"])"));
  const Json& state = answer["states"][0];
  EXPECT_EQ(state["status"], "ok");
  for (const double error : state["contact_error"]) EXPECT_LT(std::abs(error), 1e-8);
}

TEST(LoopsProgram, CheckPasses) {
  for (const char* name : {"four_bar", "parallel_ankle", "gripper"}) {
    const Outcome outcome = run("check --states 2 " + robots + "/" + name);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  }
}

TEST(LoopsProgram, BenchAllocatesNothing) {
  const Outcome outcome =
      run("bench --seconds 0.01 --knots 20 --json " + robots + "/parallel_ankle");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["nu"], 3);
}

}  // namespace
}  // namespace burnish::testing
