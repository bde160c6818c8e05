// Tests of the command burnish bench: measurements, allocations and bad input. None asserts a time.
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;

const std::string quick = " --seconds 0.01 --knots 20";

TEST(Bench, Arm_IsMeasuredInEveryGroupWithoutAllocation) {
  const Outcome outcome = run("bench arm7 --threads 2 --json" + quick);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["robot"], "arm7");
  EXPECT_EQ(json["tool"], "tool");
  EXPECT_EQ(json["nx"], 14);
  EXPECT_EQ(json["nu"], 7);
  EXPECT_EQ(json["knots"], 20);
  EXPECT_GT(json["peak_multiply_adds_per_s"].get<double>(), 1e8);
  std::map<std::string, int> lines;
  for (const Json& line : json["lines"]) {
    ++lines[line["group"]];
    EXPECT_GT(line["best_s"].get<double>(), 0.0) << line;
    EXPECT_LE(line["best_s"], line["median_s"]) << line;
    EXPECT_LE(line["median_s"], line["p99_s"]) << line;
    if (!line["allocations"].is_null()) {
      EXPECT_EQ(line["allocations"], 0.0) << line;
    }
    if (line["group"] == "state") {
      // A fraction above 1 would be an error in the count of operations.
      EXPECT_GT(line["peak_share"].get<double>(), 0.0) << line;
      EXPECT_LT(line["peak_share"].get<double>(), 1.0) << line;
    }
    if (line["group"] == "iteration") {
      for (const char* phase : {"expand_s", "backward_s", "trial_s"})
        EXPECT_GT(line[phase].get<double>(), 0.0) << line;
    }
  }
  // The iteration is measured on one thread and on two threads with packs.
  EXPECT_EQ(lines, (std::map<std::string, int>{{"iteration", 2}, {"state", 4}, {"tick", 1}}));
}

TEST(Bench, ArmAtAPosture_IsPrintedAsATable) {
  const Outcome outcome = run("bench arm7 --posture ready" + quick);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* words :
       {"arm7: nq = 7, nv = 7", "| per ", "backward pass", "posture ready", "| tick ", "packs of"})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << "\n" << outcome.out;
}

TEST(Bench, SingularPosture_IsReplacedUnlessRequested) {
  // The tip of a hanging pendulum cannot move up or down.
  const Outcome outcome = run("bench pendulum --json" + quick);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["posture"], "near hanging");
  const Outcome hanging = run("bench pendulum --posture hanging" + quick);
  EXPECT_EQ(hanging.exit_code, 2);
  for (const char* words : {"posture 'hanging'", "'tip'", "wanted another posture or tool"})
    EXPECT_NE(hanging.err.find(words), std::string::npos) << hanging.err;
}

TEST(Bench, FloatingBaseAndContinuousJoint_AreMeasured) {
  const Scratch scratch;
  std::string urdf = contents(std::filesystem::path(BURNISH_ROBOTS_DIR) / "arm7" / "arm7.urdf");
  const std::string joint = "\"joint_7\" type=\"revolute\"";
  ASSERT_NE(urdf.find(joint), std::string::npos);
  urdf.replace(urdf.find(joint), joint.size(), "\"joint_7\" type=\"continuous\"");
  const auto turning = scratch.write("turning.urdf", urdf);
  for (const std::string& robot :
       {std::string("crane"), std::string("quadruped"), quoted(turning)}) {
    const Outcome outcome = run("bench " + robot + quick);
    EXPECT_EQ(outcome.exit_code, 0) << robot << outcome.err;
    EXPECT_NE(outcome.out.find("| tick "), std::string::npos) << robot << outcome.out;
  }
}

/// Runs the task in real time. A busy machine may miss deadlines; that is not a failure.
TEST(Bench, Task_IsMeasuredInRealTime) {
  const auto file = std::filesystem::path(BURNISH_ROBOTS_DIR).parent_path() / "tasks/polishing";
  const Outcome outcome =
      run("bench --task " + quoted(file / "table.yaml") +
          " --seconds 0.3 --set controller.tick_rate=1000 --set controller.horizon=0.3 --json");
  ASSERT_NE(outcome.exit_code, 2) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["knots"], 30);
  EXPECT_GT(json["plan"]["count"].get<long>(), 100);
  const double parts = json["expand"]["median_s"].get<double>() +
                       json["backward"]["median_s"].get<double>() +
                       json["trial"]["median_s"].get<double>();
  EXPECT_LT(parts, 1.5 * json["plan"]["median_s"].get<double>());
  const Json& real = json["real_time"];
  if (outcome.exit_code == 0) {
    EXPECT_NEAR(real["ticks"].get<double>(), 300.0, 2.0);
    EXPECT_GT(real["plan"]["count"].get<long>(), 0);
    EXPECT_LE(real["missed"], real["ticks"]);
    for (const char* where : {"tick_allocations", "plan_allocations"}) {
      if (!real[where].is_null()) {
        EXPECT_EQ(real[where], 0) << where;
      }
    }
  } else {
    EXPECT_NE(real["fault"], "");
  }
}

TEST(Bench, BadInput_IsRefusedInOneSentence) {
  const Outcome both = run("bench arm7 --task table.yaml");
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_NE(both.err.find("--task"), std::string::npos) << both.err;
  EXPECT_EQ(run("bench --task no_such.yaml").exit_code, 2);

  EXPECT_EQ(run("bench arm8").exit_code, 2);
  const Outcome frame = run("bench arm7 --tool tol" + quick);
  EXPECT_EQ(frame.exit_code, 2);
  EXPECT_NE(frame.err.find("did you mean 'tool'?"), std::string::npos) << frame.err;
  const Outcome posture = run("bench arm7 --posture redy" + quick);
  EXPECT_EQ(posture.exit_code, 2);
  EXPECT_NE(posture.err.find("did you mean 'ready'?"), std::string::npos) << posture.err;
  EXPECT_EQ(run("bench arm7 --knots 0").exit_code, 2);
}

}  // namespace
}  // namespace burnish::testing
