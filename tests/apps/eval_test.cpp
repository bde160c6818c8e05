// Tests of the command burnish eval: answers, exit codes and refusals.
#include <Eigen/Core>
#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;

const std::string repository = BURNISH_ROBOTS_DIR "/..";

Json answer_to(const Json& request, int exit_code = 0) {
  const Outcome outcome = run("eval -", request.dump());
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  return Json::parse(outcome.out);
}

void expect_near(const Json& a, const Json& b, double tolerance, const std::string& where) {
  ASSERT_EQ(a.is_number(), b.is_number()) << where;
  if (a.is_number()) {
    EXPECT_NEAR(a.get<double>(), b.get<double>(), tolerance * (1.0 + std::abs(b.get<double>())))
        << where;
    return;
  }
  if (!a.is_structured()) {
    EXPECT_EQ(a, b) << where;
    return;
  }
  ASSERT_EQ(a.size(), b.size()) << where;
  for (const auto& item : b.items()) {
    const Json& other = a.is_array() ? a.at(std::stoul(item.key())) : a.at(item.key());
    expect_near(other, item.value(), tolerance, where + "/" + item.key());
  }
}

/// Returns the n-th block of JSON in docs/eval.md.
std::string documented(int n) {
  const std::string text = contents(repository + "/docs/eval.md");
  std::size_t begin = 0;
  for (int i = 0; i <= n; ++i) begin = text.find("```json\n", begin) + 8;
  return text.substr(begin, text.find("```", begin) - begin);
}

TEST(Eval, DocumentedExample_EqualsTheFileAndItsAnswer) {
  EXPECT_EQ(documented(0), contents(repository + "/examples/eval/press.json"));
  const Outcome outcome = run("eval '" + repository + "/examples/eval/press.json'");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  expect_near(Json::parse(outcome.out), Json::parse(documented(1)), 1e-9, "answer");
}

TEST(Eval, EveryExample_Runs) {
  for (const auto& file : std::filesystem::directory_iterator(repository + "/examples/eval")) {
    const Outcome outcome = run("eval '" + file.path().string() + "'");
    EXPECT_EQ(outcome.exit_code, 0) << file.path() << outcome.err;
    EXPECT_FALSE(Json::parse(outcome.out).empty());
  }
}

TEST(Eval, EveryQuantity_HasItsSize) {
  const Json request{
      {"robot", "talos"},
      {"contacts",
       {{{"name", "foot"},
         {"tool", "left_sole_link"},
         {"directions", {"z", "rx"}},
         {"target", "here"}}}},
      {"compute",
       {"mass_matrix", "bias", "jacobian", "contact_velocity", "contact_error", "forward",
        "forward_derivatives", "inverse", "inverse_derivatives", "acceleration",
        "acceleration_derivatives", "forces", "frames", "diagnosis"}}};
  const Json answer = answer_to(request);
  const Json& state = answer["states"][0];
  EXPECT_EQ(answer["q_names"].size(), 37U);
  EXPECT_EQ(answer["v_names"][0], "root_joint.vx");
  EXPECT_EQ(answer["row_names"], Json({"foot/z", "foot/rx"}));
  const auto expect_size = [](const Json& matrix, std::size_t rows, std::size_t columns) {
    ASSERT_EQ(matrix.size(), rows);
    for (const Json& row : matrix) EXPECT_EQ(row.size(), columns);
  };
  expect_size(state["mass_matrix"], 36, 36);
  expect_size(state["jacobian"], 2, 36);
  expect_size(state["forward_derivatives"]["da_dtau"], 36, 36);
  expect_size(state["forward_derivatives"]["dlambda_dq"], 2, 36);
  expect_size(state["inverse_derivatives"]["dtau_dlambda"], 36, 2);
  expect_size(state["acceleration_derivatives"]["dalpha_dv"], 2, 36);
  EXPECT_EQ(state["bias"].size(), 36U);
  EXPECT_EQ(state["contact_error"].size(), 2U);
  EXPECT_NEAR(state["frames"]["left_sole_link"]["xyz"][2].get<double>(), 0.0, 1e-5);
  EXPECT_TRUE(state["diagnosis"]["independent"].get<bool>());
  EXPECT_EQ(state["forces"][0]["by"], "world");
}

TEST(Eval, InverseOfForward_ReturnsTheTorques) {
  Json request{{"robot", "arm7"},
               {"contacts", {{{"tool", "tool"}, {"directions", "linear"}}}},
               {"compute", {"forward", "inverse", "bias"}},
               {"states",
                {{{"v", {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}},
                  {"tau", {{"joint_2", 12.5}, {"joint_4", -3.25}}}}}}};
  const Json forward = answer_to(request)["states"][0]["forward"];
  request["states"][0]["a"] = forward["a"];
  request["states"][0]["lambda"] = forward["lambda"];
  const Json inverse = answer_to(request)["states"][0]["inverse"];
  expect_near(inverse["tau"], {0.0, 12.5, 0.0, -3.25, 0.0, 0.0, 0.0}, 1e-10, "tau");
}

/// Returns a request with a force of 10 N at the tool of an arm at rest.
Json pressing_with_ten_newtons(const Json& compute) {
  return {{"robot", "arm7"},
          {"contacts",
           {{{"tool", "tool"},
             {"reference", {{"surface", {{"normal", {0, 0, 1}}}}}},
             {"directions", "z"}}}},
          {"compute", compute},
          {"forces_in", {"centered"}},
          {"states", {{{"q", "ready"}, {"lambda", {10}}}}}};
}

TEST(Eval, ForcesBesideInverse_AreTheGivenForces) {
  for (const Json& compute : {Json{"inverse", "forces"}, Json{"inverse_derivatives"},
                              Json{"inverse", "acceleration", "diagnosis"}}) {
    const Json state = answer_to(pressing_with_ten_newtons(compute))["states"][0];
    EXPECT_EQ(state["forces_of"], "inverse");
    EXPECT_NEAR(state["forces"][0]["value"][2].get<double>(), 10.0, 1e-12);
    EXPECT_NEAR(state["forces"][0]["in"]["centered"]["value"][2].get<double>(), 10.0, 1e-12);
  }
}

TEST(Eval, ForcesBesideForwardAndInverse_AreTheForwardForces) {
  const Json state = answer_to(pressing_with_ten_newtons({"inverse", "forward"}))["states"][0];
  EXPECT_EQ(state["forces_of"], "forward");
  EXPECT_NEAR(state["forces"][0]["value"][2].get<double>(),
              state["forward"]["lambda"][0].get<double>(), 1e-9);
  EXPECT_GT(std::abs(state["forces"][0]["value"][2].get<double>() - 10.0), 1.0);
}

TEST(Eval, GivenMotionOrForceThatForcesIgnore_IsRefused) {
  const auto expect_refused = [](const Json& request, const std::string& words) {
    const Outcome outcome = run("eval -", request.dump());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  };
  expect_refused(pressing_with_ten_newtons({"acceleration"}),
                 "which \"acceleration\" does not compute");
  expect_refused(pressing_with_ten_newtons({"forces"}), "states[0].lambda: it is given");
  Json moved = pressing_with_ten_newtons({"forces", "frames"});
  moved["states"][0] = {{"a", {1, 0, 0, 0, 0, 0, 0}}};
  expect_refused(moved, "states[0].a: it is given");
  moved["states"][0] = {{"q", "ready"}, {"tau", {{"joint_2", 1.0}}}};
  EXPECT_EQ(answer_to(moved)["states"][0]["forces_of"], "forward");
}

TEST(Eval, ImplausibleStates_AreRefusedOrWarnedOf) {
  Json request{{"robot", "arm7"}, {"states", {{{"q", {0, 1e20, 0, 0, 0, 0, 0}}}}}};
  const auto refused = [&](const std::string& options) {
    const Outcome outcome = run("eval " + options + "-", request.dump());
    EXPECT_EQ(outcome.exit_code, 2);
    return outcome.err;
  };
  for (const char* words :
       {"states[0].q", "'joint_2' is 1e+20", "floating-point numbers differ by 16384"})
    EXPECT_NE(refused("").find(words), std::string::npos) << refused("");
  request["states"][0] = {{"q", {{"joint_2", -1e12}}}};
  EXPECT_NE(refused("").find("'joint_2' is -1e+12"), std::string::npos) << refused("");
  request["states"][0] = {{"v", {{"joint_2", 1e10}}}};
  EXPECT_NE(refused("").find("states[0].v"), std::string::npos) << refused("");
  // Degrees in place of radians, and velocities and torques beyond the limits.
  request["states"] = {{{"q", "ready"}},
                       {{"q", {{"joint_2", 90}}}},
                       {{"v", {{"joint_1", 1e3}}}, {"tau", {{"joint_3", -1e6}}}}};
  const Outcome outcome = run("eval -", request.dump());
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("warning: states[1]: joint 'joint_2' is at 90 rad; its limits are"),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("1 more state has a warning"), std::string::npos) << outcome.err;
  const Json states = Json::parse(outcome.out)["states"];
  EXPECT_FALSE(states[0].contains("warnings"));
  EXPECT_EQ(states[1]["warnings"].size(), 1U);
  EXPECT_EQ(states[2]["warnings"].size(), 2U);
  EXPECT_NE(refused("--strict ").find("states[1]"), std::string::npos);
}

TEST(Eval, ContradictoryRows_AreNamedAndSolvedByLeastSquares) {
  // Two contacts at one place; the second asks the tool to accelerate upwards.
  Json table{{"name", "table"}, {"tool", "tool"}, {"directions", "linear"}};
  Json lift = table;
  lift["name"] = "lift";
  lift["kp"] = 100;
  lift["target"] = {{"xyz", {0.4, 0, 2.0}}};
  Json request{{"robot", "arm7"},
               {"contacts", {table, lift}},
               {"compute", {"forward", "forces"}},
               {"solver", {{"mu", 1e-4}, {"max_proximal_iterations", 10}}}};
  const Json ten = answer_to(request, 1)["states"][0];
  EXPECT_EQ(ten["status"], "not_converged");
  for (const char* words : {"table/z", "lift/z", "contradict each other", "m/s^2"})
    EXPECT_NE(ten["sentence"].get<std::string>().find(words), std::string::npos);
  request["solver"]["max_proximal_iterations"] = 1000;
  const Json thousand = answer_to(request, 1)["states"][0];
  expect_near(thousand["forward"]["lambda"], ten["forward"]["lambda"], 1e-6, "lambda");
  expect_near(thousand["forward"]["unmet"], ten["forward"]["unmet"], 1e-9, "unmet");
  // Each contact misses half of the requested acceleration.
  EXPECT_NEAR(ten["forward"]["unmet"][2].get<double>(), -ten["forward"]["unmet"][5].get<double>(),
              1e-9);
  EXPECT_NEAR(ten["forward"]["lambda"][2].get<double>(), ten["forward"]["lambda"][5].get<double>(),
              1e-6);
}

TEST(Eval, FramesGravityAndPostures_AreApplied) {
  Json request{{"robot", "arm7"},
               {"frames",
                {{{"name", "sander"},
                  {"parent", "tool"},
                  {"xyz", {0, 0, 0.1}},
                  {"rpy", {0, 0, 1.5707963267948966}}}}},
               {"gravity", {0, 0, 0}},
               {"contacts", {{{"tool", "sander"}, {"target", {{"xyz", {0.1, 0, 0}}}}}}},
               {"compute", {"forward", "frames", "contact_error"}},
               {"states", {{{"q", "home"}}, {{"q", {{"joint_2", 0.25}}}}}}};
  const Json answer = answer_to(request);
  for (const Json& state : answer["states"]) {
    for (const Json& x : state["forward"]["a"]) EXPECT_EQ(x.get<double>(), 0.0);
    // Without gains the contact exerts no force; its error is still computed.
    const Json& at = state["frames"]["sander"]["xyz"];
    EXPECT_NEAR(state["contact_error"][0].get<double>(), at[0].get<double>() - 0.1, 1e-12);
    EXPECT_NEAR(state["contact_error"][2].get<double>(), at[2].get<double>(), 1e-12);
  }
  EXPECT_NE(answer["states"][0]["frames"]["tool"], answer["states"][1]["frames"]["tool"]);
}

TEST(Eval, TargetHere_IsThePoseOfTheToolInTheFirstState) {
  Json request{{"robot", "arm7"},
               {"contacts", {{{"tool", "tool"}, {"kp", 100}, {"target", "here"}}}},
               {"compute", {"contact_error"}},
               {"states", {{{"q", "home"}}, {{"q", "ready"}}}}};
  const auto errors = [&] {
    std::vector<double> sizes;
    const Json answer = answer_to(request);
    for (const Json& state : answer["states"]) {
      double sum = 0.0;
      for (const Json& e : state["contact_error"]) sum += std::abs(e.get<double>());
      sizes.push_back(sum);
    }
    return sizes;
  };
  EXPECT_NEAR(errors()[0], 0.0, 1e-12);
  EXPECT_GT(errors()[1], 0.1);
  request["contacts"][0]["target"] = {{"xyz", {0, 0, 0}}};
  EXPECT_GT(errors()[0], 0.1);
}

TEST(Eval, ContactsAsAMap_EqualContactsAsAList) {
  const auto forces = [](const Json& contacts) {
    return answer_to({{"robot", "arm7"}, {"contacts", contacts}, {"compute", "forces"}})["states"];
  };
  const Json named = forces({{{"name", "tip"},
                              {"tool", "tool"},
                              {"reference", {{"surface", {{"normal", {0, 0.2, 1}}}}}},
                              {"directions", {"z", "rx"}}}});
  EXPECT_EQ(named[0]["forces"][0]["contact"], "tip");
  EXPECT_EQ(named, forces({{"tip",
                            {{"tool", "tool"},
                             {"reference", {{"surface", {{"normal", {0, 0.2, 1}}}}}},
                             {"directions", "z,rx"},
                             {"kd", 0}}}}));
}

TEST(Eval, RedundantContacts_AreAStatusWithExitCodeOne) {
  const Json request{{"robot", "arm7"},
                     {"contacts",
                      {{{"name", "one"}, {"tool", "tool"}, {"directions", "z"}},
                       {{"name", "two"}, {"tool", "tool"}, {"directions", "z"}}}},
                     {"compute", {"forward", "forward_derivatives", "mass_matrix", "diagnosis"}}};
  const Json answer = answer_to(request, 1);
  const Json& state = answer["states"][0];
  EXPECT_EQ(state["status"], "singular_contacts");
  EXPECT_NE(state["sentence"].get<std::string>().find("redundant"), std::string::npos);
  EXPECT_TRUE(state["forward"].is_null());
  EXPECT_TRUE(state["forward_derivatives"].is_null());
  EXPECT_EQ(state["mass_matrix"].size(), 7U);
  EXPECT_EQ(state["diagnosis"]["redundant"][0]["implied_by"], Json({"one/z"}));
  EXPECT_TRUE(state["diagnosis"]["condition"].is_null());
}

TEST(Eval, CompactAnswer_EqualsThePrettyAnswer) {
  const Outcome pretty = run("eval -", R"({"robot": "arm7"})");
  const Outcome compact = run("eval - --compact", R"({"robot": "arm7"})");
  EXPECT_EQ(Json::parse(pretty.out), Json::parse(compact.out));
  EXPECT_EQ(compact.out.find('\n') + 1, compact.out.size());
}

TEST(Eval, ListOfRequests_IsAnsweredWithAList) {
  EXPECT_TRUE(Json::parse(run("eval -", R"([{"robot": "arm7"}])").out).is_array());
  EXPECT_TRUE(Json::parse(run("eval -", R"({"robot": "arm7"})").out).is_object());
  EXPECT_EQ(run("eval -", "[]").out, "[]\n");
}

TEST(Eval, RobotBesideTheRequest_IsFound) {
  const Scratch scratch;
  scratch.write("mine.urdf", contents(BURNISH_ROBOTS_DIR "/arm7/arm7.urdf"));
  const auto file = scratch.write("request.json", R"({"robot": "mine.urdf"})");
  const Outcome outcome = run("eval '" + file.string() + "'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["v_names"].size(), 7U);
}

TEST(Eval, MasslessJoint_IsAWarningAndAStatus) {
  const Scratch scratch;
  scratch.write("finger.urdf",
                "<robot name='finger'><link name='base'/><link name='tip'/><joint name='hinge' "
                "type='continuous'><parent link='base'/><child link='tip'/></joint></robot>");
  const auto request = [&](const std::string& more) {
    const std::string text =
        R"({"robot": "finger.urdf", "compute": ["forward", "forward_derivatives"])" + more + "}";
    return run("eval '" + scratch.write("request.json", text).string() + "'");
  };
  const Outcome outcome = request("");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const Json answer = Json::parse(outcome.out);
  EXPECT_EQ(answer["states"][0]["status"], "singular_mass");
  EXPECT_TRUE(answer["states"][0]["forward"].is_null());
  ASSERT_EQ(answer["warnings"].size(), 1U);
  EXPECT_NE(answer["warnings"][0].get<std::string>().find("joint 'hinge' moves no mass"),
            std::string::npos);
  EXPECT_NE(outcome.err.find("joint 'hinge' moves no mass"), std::string::npos);
  expect_refused(request(R"(, "strict": true)"), "joint 'hinge' moves no mass");
}

struct BadRequest {
  const char* request;
  const char* sentence;
};

class EvalRefusal : public ::testing::TestWithParam<BadRequest> {};

TEST_P(EvalRefusal, BadRequest_IsRefusedWithItsPlace) {
  expect_refused(run("eval -", GetParam().request), GetParam().sentence);
}

INSTANTIATE_TEST_SUITE_P(
    Requests, EvalRefusal,
    ::testing::Values(
        BadRequest{"", "standard input: parse error at line 1"},
        BadRequest{"{\"robot\": \"arm7\",}", "standard input: parse error at line 1, column 18"},
        BadRequest{"{\"robot\": NaN}", "parse error"},
        BadRequest{R"({"robot": "arm7", "gravity": [0, 0, 1e999]})",
                   "line 1: gravity: '1e999' is too large; wanted a magnitude below 1.8e308"},
        BadRequest{R"({"robot": "arm7", "robot": "crane"})", "line 1: key 'robot' is stated twice"},
        BadRequest{"3", "it is the number 3; wanted keys with values"},
        BadRequest{"{}", "key 'robot' is missing"},
        BadRequest{R"({"robot": "arm8"})",
                   "robot: robot 'arm8' does not exist; did you mean 'arm7'?"},
        BadRequest{R"([{"robot": "arm7"}, {"robt": "arm7"}])",
                   "[1]: key 'robt' is unknown; did you mean 'robot'?"},
        BadRequest{R"({"robot": "arm7", "base": "floating"})",
                   "base: 'floating' is unknown; wanted fixed or free_flyer"},
        BadRequest{R"({"robot": "arm7", "contacts": [{"tool": "tool", "directons": "z"}]})",
                   "contacts[0]: key 'directons' is unknown; did you mean 'directions'?"},
        BadRequest{R"({"robot": "arm7", "contacts": [{"tool": "tol"}]})", "did you mean 'tool'?"},
        BadRequest{R"({"robot": "arm7", "contacts": [{"tool": "tool", "kp": [1, 2]}]})",
                   "contacts[0].kp: it has 2 numbers; wanted 6"},
        BadRequest{R"({"robot": "arm7", "contacts": [{"tool": "tool", "reference": "wrld"}]})",
                   "contacts[0].reference: "},
        BadRequest{R"({"robot": "arm7", "contacts": [{"tool": "tool", "reference":
                {"surface": {"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 2]]}}}]})",
                   "contacts[0].reference.surface.matrix: it is not a rotation matrix"},
        BadRequest{R"({"robot": "arm7", "contacts": [{"tool": "tool", "reference":
                {"local": {"normal": [0, 0, 1]}}}]})",
                   "contacts[0].reference.local: key 'normal' is possible only in 'surface'"},
        BadRequest{R"({"robot": "arm7", "contacts": [{"tool": "tool", "target":
                {"quaternion": [1, 1, 0, 0]}}]})",
                   "contacts[0].target.quaternion: the quaternion has length 1.41421; wanted 1"},
        BadRequest{R"({"robot": "arm7", "contacts": [{"tool": "tool", "reference":
                {"type": "surface", "normal": [0, 0.2, 1]}}]})",
                   "wanted {\"surface\": {\"normal\": [0, 0.2, 1]}}"},
        BadRequest{
            R"({"robot": "arm7", "contacts": [{"tool": "tool", "kp": 4}]})",
            "contacts[0]: key 'target' is missing, but kp is not 0; wanted \"target\": \"here\""},
        BadRequest{R"({"robot": "arm7", "contacts": [{"tool": "tool", "kp": 4}]})",
                   "or \"target\": {\"xyz\": [0, 0, 0]} (the frame 'base'"},
        BadRequest{R"({"robot": "arm7", "contacts": {"tip": {"tool": "tool"}}, "compute":
                "contact_error"})",
                   "contacts.tip: key 'target' is missing, but compute lists contact_error"},
        BadRequest{
            R"({"robot": "arm7", "states": [{"q": {"joint_1": [{}]}}]})",
            "input: line 1: states[0].q.joint_1[0]: it is keys with values; wanted a number"},
        BadRequest{R"({"robot": "arm7", "states": [{}, {"q": [1, 2]}]})",
                   "states[1].q: it has 2 numbers; wanted 7"},
        BadRequest{R"({"robot": "arm7", "states": [{"q": "redy"}]})", "did you mean 'ready'?"},
        BadRequest{R"({"robot": "arm7", "states": [{"v": {"joint_9": 1}}]})",
                   "states[0].v: key 'joint_9' is unknown; did you mean 'joint_1'?"},
        BadRequest{R"({"robot": "arm7", "states": [{"tau": [0, 0, 0, 0, 0, 0, "x"]}]})",
                   "line 1: states[0].tau[6]: 'x' is not a number"},
        BadRequest{R"({"robot": "arm7", "compute": ["foward"]})",
                   "compute[0]: 'foward' is unknown; did you mean 'forward'?"},
        BadRequest{R"({"robot": "arm7", "forces_in": ["here"]})",
                   "forces_in[0]: reference: unknown"},
        BadRequest{R"({"robot": "arm7", "forces_in": [{"local": {"over_time": {"line": {}}}}]})",
                   "forces_in[0].local.over_time: only optimal control problems support a rotation "
                   "over time"},
        BadRequest{R"({"robot": "arm7", "forces_in": [{"axes": "tol"}]})",
                   "forces_in[0]: robot 'arm7': frame 'tol' does not exist"},
        BadRequest{
            R"({"robot": "arm7", "forces_in": ["surface", {"surface": {"normal": [1, 0, 0]}}]})",
            "forces_in[1]: two references have the name 'surface'; wanted an object"},
        BadRequest{R"({"robot": "arm7", "solver": {"mu": -1}})", "solver.mu: it is -1"},
        BadRequest{R"({"robot": "arm7", "solver": {"max_proximal_iterations": 1.5}})",
                   "solver.max_proximal_iterations: it is 1.5; wanted a whole number"},
        BadRequest{R"({"robot": "arm7", "solver": {"max_proximal_iterations": 1000000000}})",
                   "solver.max_proximal_iterations: it is 1e+09; wanted at most 10000"},
        BadRequest{R"({"robot": "arm7", "frames": [{"name": "tool", "parent": "tool"}]})",
                   "frames[0].name: the name 'tool' is taken"},
        BadRequest{R"({"robot": "arm7", "frames": [{"name": "a", "parent": "tol"}]})",
                   "frames[0].parent: robot 'arm7': frame 'tol' does not exist"}));

TEST(Eval, ForcesIn_WritesForcesInEveryReference) {
  const Json slope{{"surface", {{"normal", {0, 1, 1}}}}},
      link{{"axes", "link_3"}, {"rpy", {0, 0, 1}}};
  const auto forces = [](const Json& reference, const Json& forces_in) {
    return answer_to({{"robot", "arm7"},
                      {"contacts", {{{"name", "tip"}, {"tool", "tool"}, {"reference", reference}}}},
                      {"states", {{{"q", "ready"}}}},
                      {"forces_in", forces_in}})["states"][0]["forces"][0];
  };
  const Json listed = forces("local", {"world", slope, link})["in"];
  const Json named = forces("local", {{"room", "world"}, {"board", slope}, {"link", link}})["in"];
  EXPECT_EQ(listed["world"], named["room"]);
  EXPECT_EQ(listed["surface"], named["board"]);
  EXPECT_EQ(listed["axes of link_3 at the tool"], named["link"]);
  EXPECT_EQ(forces("local", link)["in"], Json({{"axes of link_3 at the tool", named["link"]}}));
  // All six directions are constrained, at rest: the contact's reference changes only the axes.
  for (const auto& [reference, name] : {std::pair{slope, "board"}, std::pair{link, "link"}})
    expect_near(named[name]["value"], forces(reference, Json::array())["value"], 1e-9, name);
}

TEST(Eval, ForcesInACurvedSurface_AreInTheAxesAtTheTool) {
  const Json ball{{"sphere", {{"center", {0.5, 0.1, -0.1}}, {"radius", 0.3}}},
                  {"near", {0.5, 0.1, 0.2}}};
  const auto asked = [&](const Json& forces_in) {
    return Json{{"robot", "arm7"},
                {"contacts", {{{"tool", "tool"}, {"reference", "centered"}}}},
                {"compute", {"forces", "frames"}},
                {"forces_in", forces_in},
                {"states", {{{"q", "ready"}, {"tau", {{"joint_2", 9.0}}}}}}};
  };
  const Json state = answer_to(asked({{"ball", {{"surface", ball}}}}))["states"][0];
  const auto vector = [](const Json& numbers) {
    return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  };
  const Eigen::Vector3d tool = vector(state["frames"]["tool"]["xyz"]);
  const Eigen::Vector3d n = (tool - Eigen::Vector3d(0.5, 0.1, -0.1)).normalized();
  const Json& force = state["forces"][0];
  const Eigen::Vector3d world = vector(force["value"]),
                        there = vector(force["in"]["ball"]["value"]);
  EXPECT_GT(world.norm(), 1.0);
  EXPECT_NEAR(there.z(), n.dot(world), 1e-9 * world.norm());
  EXPECT_NEAR(there.norm(), world.norm(), 1e-9 * world.norm());
  // A surface may be fixed in another link, not in the tool, and needs the key 'near'.
  Json on_a_link = ball;
  on_a_link["axes"] = "link_2";
  EXPECT_EQ(answer_to(asked(on_a_link))["states"][0]["status"], "ok");
  Json on_the_tool = ball;
  on_the_tool["axes"] = "tool";
  Json nowhere{{"surface", ball}};
  nowhere["surface"].erase("near");
  for (const auto& [bad, words] : {std::pair(on_the_tool, "fixed to the tool itself"),
                                   std::pair(nowhere, "key 'near' is missing")}) {
    const Outcome outcome = run("eval -", asked(bad).dump());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  }
}

TEST(Eval, UnreadableFiles_AreRefused) {
  expect_refused(run("eval nowhere.json"), "nowhere.json: the file cannot be opened");
  expect_refused(run("eval /tmp"), "/tmp: this is a folder");
  expect_refused(run("eval"), "FILE is required");
}

}  // namespace
}  // namespace burnish::testing
