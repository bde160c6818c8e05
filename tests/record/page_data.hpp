// A made-up run for tests of pages and recordings: an arm of two joints, with values by formulas.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/run_page.hpp"

namespace burnish::testing {

constexpr double page_dt = 1e-3;  // period of the trace [s]

/// Returns an arm with a limited hinge, a continuous wheel, a box, and a mesh in a package.
inline TreeSpec page_tree() {
  TreeSpec tree;
  tree.name = "two";
  for (const char* name : {"base", "arm", "wheel"}) {
    LinkSpec link{name, {}, {}};
    link.inertia.mass = 2.0;
    link.inertia.com = Eigen::Vector3d(0.0, 0.1, 0.0);
    link.inertia.inertia_at_com = Eigen::Vector3d(0.1, 0.2, 0.25).asDiagonal();
    tree.links.push_back(link);
  }
  tree.links[1].visuals = {{BoxShape{{0.1, 0.2, 0.3}}}};
  tree.links[2].visuals = {{MeshShape{"package://parts/meshes/wheel.stl", {2.0, 1.0, 1.0}}}};
  JointSpec hinge;
  hinge.name = "hinge";
  hinge.type = JointType::Revolute;
  hinge.parent_link = "base";
  hinge.child_link = "arm";
  hinge.lower = -1.0;
  hinge.upper = 2.0;
  hinge.effort_limit = 10.0;
  JointSpec spin;
  spin.name = "spin";
  spin.type = JointType::Continuous;
  spin.parent_link = "arm";
  spin.child_link = "wheel";
  spin.placement.translation() = Eigen::Vector3d(0.5, 0.0, 0.0);
  tree.joints = {hinge, spin};
  return tree;
}
inline Model page_model() { return build_model(page_tree()); }

/// Returns a trace with the columns of ClosedLoop. The force is 30 N, and 99 N at row 105; a plan
/// takes 1 ms, and 7 ms at row 205.
inline Trace page_trace(const Model& model, int rows) {
  std::vector<TraceColumn> columns{{"time", "s"}, {"phase", "-"}};
  const auto add = [&](const std::string& name, const char* unit) {
    columns.push_back({name, unit});
  };
  for (const char* what : {"tool", "target"})
    for (const char* axis : {"_x_world", "_y_world", "_z_world"})
      add(std::string(what) + axis, "m");
  for (const char* what :
       {"tool_force", "estimated_force", "measured_force", "surface_normal", "estimated_normal"})
    for (const char* axis : {"_x_world", "_y_world", "_z_world"})
      add(std::string(what) + axis, "N");
  for (const char* axis : {"tool_rx_start", "tool_ry_start", "tool_rz_start"}) add(axis, "rad");
  for (const char* name :
       {"target_force", "in_contact", "tick", "solve_time", "iterations", "missed_deadline",
        "active_constraints", "constraint_violation", "constraints_infeasible", "clipped_torques"})
    add(name, "-");
  for (int k = 0; k < model.nq; ++k) add("q_" + model.q_name(k), "rad");
  for (int k = 0; k < model.nv; ++k)
    for (const char* what : {"v_", "tau_applied_", "tau_command_"})
      add(what + model.v_name(k), "Nm");
  Trace trace(columns, rows);
  for (int row = 0; row < rows; ++row) {
    double* const values = trace.add_row();
    const auto set = [&](const std::string& name, double value) {
      values[trace.index(name)] = value;
    };
    const double t = page_dt * row;
    set("time", t);
    set("phase", row < 50 ? 1.0 : 3.0);
    set("tool_x_world", 0.3 + 0.1 * t);
    set("target_x_world", 0.3 + 0.1 * t);
    set("tool_y_world", 0.2 + 1e-3);
    set("target_y_world", 0.2);
    set("tool_force_z_world", row == 105 ? 99.0 : 30.0);
    set("tool_force_x_world", 4.0);
    set("estimated_force_z_world", 31.0);
    set("surface_normal_z_world", 1.0);
    set("estimated_normal_z_world", 1.0);
    set("measured_force_z_world", row == 7 ? std::nan("") : 29.0);
    set("tool_rx_start", 0.3);
    set("tool_ry_start", 0.4);
    set("target_force", 30.0);
    set("in_contact", row < 50 ? 0.0 : 1.0);
    set("tick", 1.0);
    set("solve_time", row == 205 ? 7e-3 : 1e-3);
    set("missed_deadline", row == 205 ? 1.0 : 0.0);
    set("iterations", 1.0);
    set("active_constraints", row == 205 ? 7.0 : 2.0);
    set("constraint_violation", row == 205 ? 1e-3 : 0.0);
    set("constraints_infeasible", row == 200 ? 1.0 : 0.0);
    set("clipped_torques", row == 200 ? 1.0 : 0.0);
    set("q_hinge", 0.5 * t);
    set("q_" + model.q_name(1), 1.0);
    set("v_hinge", 0.5);
    set("tau_applied_hinge", -2.0);
    set("tau_command_hinge", -2.5);
  }
  return trace;
}

/// Returns the page of the made-up run.
inline RunPage page_of_run(int rows = 1000, int record_every = 10) {
  RunPage page;
  page.name = "made_up";
  page.created = 1'700'000'000;
  page.version = "0.0.0";
  page.facts = {{"task", "made up"}};
  page.outcome = "polished";
  page.succeeded = true;
  page.metrics = page_metrics(std::nullopt);
  page.phase_names = {"reach", "approach", "ramp", "track", "retreat"};
  page.robot.model = page_model();
  page.tool_frame = "wheel";
  page.tip_radius = 0.02;
  page.path_origin_world = Eigen::Vector3d(0.3, 0.2, 0.0);
  page.path_u = Eigen::VectorXd::LinSpaced(5, 0.0, 0.1);
  page.path_w = Eigen::VectorXd::Zero(5);
  page.solver = PageSolver{.period_ms = 1.0};
  add_trace(page, page_trace(page.robot.model, rows), record_every);
  return page;
}

inline std::string decoded(const std::string& base64_text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned group = 0;
  int bits = 0;
  for (const char letter : base64_text) {
    const auto at = letters.find(letter);
    if (at == std::string::npos) continue;  // padding
    group = (group << 6U) | static_cast<unsigned>(at);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>((group >> static_cast<unsigned>(bits)) & 0xFFU);
  }
  return bytes;
}

/// Returns the numbers of {"n", "f32"}.
inline std::vector<float> floats_of(const nlohmann::json& packed) {
  const std::string bytes = decoded(packed.at("f32").get<std::string>());
  std::vector<float> result(bytes.size() / 4);
  for (std::size_t i = 0; i < result.size(); ++i) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
      word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[4 * i + k])) << (8 * k);
    result[i] = std::bit_cast<float>(word);
  }
  EXPECT_EQ(packed.at("n").get<std::size_t>(), result.size());
  return result;
}

/// Returns the object with this name in a list of objects.
inline nlohmann::json named(const nlohmann::json& list, const std::string& name) {
  for (const nlohmann::json& entry : list)
    if (entry.at("name") == name) return entry;
  ADD_FAILURE() << "no " << name;
  return {};
}

}  // namespace burnish::testing
