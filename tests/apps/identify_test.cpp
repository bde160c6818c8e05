// burnish identify from outside: a motion, a record of it, and what is found in that.
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;

TEST(Identify, FindsInARecordWhatWasCarried) {
  const Scratch scratch;
  const std::string record = quoted(scratch.folder / "record.csv");
  const Outcome simulated = run("identify arm7 --seed 3 --simulate " + record);
  ASSERT_EQ(simulated.exit_code, 0) << simulated.err;
  const std::size_t at = simulated.out.find("carries ");
  ASSERT_NE(at, std::string::npos) << simulated.out;
  const double mass = std::stod(simulated.out.substr(at + 8));

  const std::filesystem::path yaml = scratch.folder / "payload.yaml";
  const Outcome found = run("identify arm7 " + record + " --out " + quoted(yaml));
  EXPECT_EQ(found.exit_code, 0) << found.err;
  for (const char* word : {"mass", "com", "Izz", "+-", "joint_7", "as found"})
    EXPECT_NE(found.out.find(word), std::string::npos) << word << "\n" << found.out;
  const Outcome json = run("identify arm7 " + record + " --json");
  const Json payload = Json::parse(json.out).at("inertias").at(0);
  EXPECT_NEAR(payload.at("values").at(0).get<double>(), mass, 0.01 * mass);
  EXPECT_LE(payload.at("sigma").at(0).get<double>(), 0.01 * mass);

  // The lines that it wrote are a robot's.
  scratch.write("robot.yaml", "urdf: " BURNISH_ROBOTS_DIR
                              "/arm7/arm7.urdf\nframes: {tool: {parent: flange, "
                              "xyz: [0, 0, 0.12], rpy: [0, 0, 0.785398]}}\n" +
                                  contents(yaml));
  const auto total = [](const std::string& robot) {
    return Json::parse(run("show " + robot + " --json").out).at("total_mass").get<double>();
  };
  EXPECT_NEAR(total(quoted(scratch.folder)) - total("arm7"), mass, 0.01 * mass);
}

TEST(Identify, WritesAMotionThatARobotCanFollow) {
  const Scratch scratch;
  const std::filesystem::path file = scratch.folder / "motion.csv";
  const Outcome outcome = run("identify arm7 --duration 5 --excite " + quoted(file));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string text = contents(file);
  EXPECT_EQ(lines_of(text), 5002);
  EXPECT_EQ(text.rfind("time [s],q_joint_1 [rad]", 0), 0U) << text.substr(0, 80);
}

TEST(Identify, RefusesWhatItCannotUse) {
  const Scratch scratch;
  const auto refused = [](const std::string& arguments, const std::string& word) {
    const Outcome outcome = run("identify " + arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_EQ(lines_of(outcome.err), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
  };
  scratch.write("short.csv", "time,q_joint_1\n0,0\n0.001,0\n0.002,0\n");
  refused("arm7", "wanted DATA");
  refused("arm7 " + quoted(scratch.folder / "short.csv"), "q_joint_2");
  refused("arm7 --payload tol --excite /dev/null", "'tool'");
  refused("arm7:floating --excite /dev/null", "free-flyer");
  refused("arm7 --duration 1 --excite /dev/null", "duration");
}

}  // namespace
}  // namespace burnish::testing
