// Tests of the commands with a robot that has mimic joints; no joint has to be locked.
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;

std::string link_text(const std::string& name) {
  return "<link name=\"" + name +
         "\"><inertial><origin xyz=\"0.02 0.01 0.1\"/><mass value=\"1.5\"/><inertia ixx=\"0.01\" "
         "ixy=\"0\" ixz=\"0\" iyy=\"0.012\" iyz=\"0\" izz=\"0.008\"/></inertial></link>\n";
}

std::string joint_text(const std::string& type, const std::string& parent, const std::string& child,
                       const std::string& axis, const std::string& more) {
  return "<joint name=\"" + child + "_joint\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/><origin xyz=\"0.05 0 0.25\"/><axis xyz=\"" + axis +
         "\"/><limit lower=\"-1.5\" upper=\"1.5\" effort=\"60\" velocity=\"3\"/>" + more +
         "</joint>\n";
}

/// Returns an arm of three joints with two fingers. The right finger leads the left finger, which
/// leads its tip.
std::string gripper_urdf() {
  std::string text = "<robot name=\"gripper\">\n";
  for (const char* name : {"base", "one", "two", "hand", "left", "left_tip", "right"})
    text += link_text(name);
  const auto mimic = [](const char* leader, const char* multiplier, const char* offset) {
    return std::string("<mimic joint=\"") + leader + "_joint\" multiplier=\"" + multiplier +
           "\" offset=\"" + offset + "\"/>";
  };
  text += joint_text("revolute", "base", "one", "0 0 1", "");
  text += joint_text("revolute", "one", "two", "0 1 0", "");
  text += joint_text("revolute", "two", "hand", "1 0 0", "");
  text += joint_text("prismatic", "hand", "left", "0 1 0", mimic("right", "-1", "0"));
  text += joint_text("revolute", "left", "left_tip", "1 0 0", mimic("left", "0.5", "-0.2"));
  text += joint_text("prismatic", "hand", "right", "0 1 0", "");
  return text + "</robot>\n";
}

class MimicJointCommands : public ::testing::Test {
 protected:
  Scratch scratch;
  std::string robot = quoted(scratch.write("gripper.urdf", gripper_urdf()));
};

TEST_F(MimicJointCommands, Show_NamesLeadersAndRatios) {
  const Outcome table = run("show " + robot);
  ASSERT_EQ(table.exit_code, 0) << table.err;
  for (const char* words : {"6 moving joints, 4 entries in q, 4 in v", "Joints that follow others",
                            "-1 right_joint", "-0.5 right_joint - 0.2"})
    EXPECT_NE(table.out.find(words), std::string::npos) << words << "\n" << table.out;
  const Json json = Json::parse(run("show --json " + robot).out);
  EXPECT_EQ(json["nv"], 4);
  for (const Json& joint : json["joints"]) {
    if (joint["name"] == "left_tip_joint") {
      EXPECT_EQ(joint["follows"],
                Json::parse(R"({"leader": "right_joint", "multiplier": -0.5, "offset": -0.2})"));
    }
    if (joint["name"] == "right_joint") {
      EXPECT_TRUE(joint["follows"].is_null());
      EXPECT_EQ(joint["effort_limit"][0], 60.0 + 60.0 + 30.0);
    }
  }
}

TEST_F(MimicJointCommands, CheckOfAFollowingTool_Passes) {
  const Outcome outcome = run("check --tool left_tip " + robot);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

TEST_F(MimicJointCommands, Eval_AnswersInEntriesOfTheLeaders) {
  scratch.write("request.json", R"({
    "robot": "gripper.urdf",
    "contacts": [{"name": "grip", "tool": "left_tip", "base": "right", "directions": "z"}],
    "compute": ["forward", "mass_matrix"],
    "states": [{"q": {"left_joint": -0.05, "two_joint": 0.4}, "v": {"right_joint": 0.2}}]
  })");
  const Outcome outcome =
      shell("cd " + quoted(scratch.folder) + " && '" BURNISH_PROGRAM "' eval request.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const Json state = Json::parse(outcome.out)["states"][0];
  EXPECT_EQ(state["a"].size(), 4U);
  EXPECT_EQ(state["mass_matrix"].size(), 4U);
}

TEST_F(MimicJointCommands, Bench_MeasuresTheLeaders) {
  const Outcome outcome = run("bench --tool left_tip --seconds 0.01 --knots 20 --json " + robot);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["nu"], 4);
}

}  // namespace
}  // namespace burnish::testing
