// Robot that stands on two feet in a synthetic run: a floating base with a foot on either side.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "burnish/base/trace.hpp"
#include "burnish/model/model.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish::testing {

/// Base of 20 kg at 0.5 m, with feet on the ground 15 cm to its left and right. In every row of a
/// trace at rest, each foot carries 100 N.
class StandingTrace {
 public:
  using Set = std::function<void(const std::string& column, double value)>;
  /// Called for every row after the values at rest are set.
  using Change = std::function<void(int row, const Set& set)>;

  /// `radius`: radius of point feet [m]; 0: planar feet of 20 by 10 cm.
  explicit StandingTrace(double radius = 0.0) {
    TreeSpec tree;
    tree.name = "biped";
    LinkSpec body{"body", {}, {}}, left{"left", {}, {}}, right{"right", {}, {}};
    body.inertia.mass = 20.0;
    body.inertia.inertia_at_com = Eigen::Matrix3d::Identity();
    tree.links = {body, left, right};
    for (const double side : {1.0, -1.0}) {
      JointSpec foot;
      foot.name = side > 0.0 ? "left_ankle" : "right_ankle";
      foot.type = JointType::Fixed;
      foot.parent_link = "body";
      foot.child_link = side > 0.0 ? "left" : "right";
      foot.placement.translation() = Eigen::Vector3d(0.0, 0.15 * side, -0.5);
      tree.joints.push_back(foot);
    }
    ModelOptions options;
    options.base = Base::FreeFlyer;
    model = build_model(tree, options);
    for (const char* frame : {"left", "right"}) {
      TouchSpec support{.frame = frame, .surface = {.friction = 0.8}, .is_support = true};
      support.half_x = radius > 0.0 ? 0.0 : 0.1;
      support.half_y = radius > 0.0 ? 0.0 : 0.05;
      support.radius = radius > 0.0 ? radius : 0.02;
      support.surface.point.z() = -radius;
      supports.push_back(support);
    }
  }

  /// Columns of the robot; columns of a tool are not included.
  std::vector<TraceColumn> columns() const {
    std::vector<TraceColumn> columns{{"time", "s"}};
    for (int k = 0; k < model.nq; ++k) columns.push_back({"q_" + model.q_name(k), "-"});
    for (int k = 0; k < model.nv; ++k) columns.push_back({"v_" + model.v_name(k), "-"});
    for (const TouchSpec& support : supports)
      for (const char* entry : {"fx", "fy", "fz", "mx", "my", "mz"})
        columns.push_back({"support_" + support.frame + "_" + entry, "N"});
    return columns;
  }

  Trace trace(const Change& change = {}) const {
    Trace trace(columns(), 10);
    for (int row = 0; row < 10; ++row) {
      double* const values = trace.add_row();
      const Set set = [&](const std::string& column, double value) {
        values[trace.index(column)] = value;
      };
      set("time", 0.1 * row);
      set("q_" + model.q_name(2), 0.5);
      set("q_" + model.q_name(6), 1.0);
      for (const TouchSpec& support : supports) set("support_" + support.frame + "_fz", 100.0);
      if (change) change(row, set);
    }
    return trace;
  }

  Model model;
  std::vector<TouchSpec> supports;
};

}  // namespace burnish::testing
