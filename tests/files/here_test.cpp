// Tests of targets that start from `here`: offsets and paths are along the axes of their cost.
#include "files/here.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "burnish/dynamics/placement.hpp"
#include "support/problem_files.hpp"

namespace burnish::testing {
namespace {

class HereTargets : public ProblemFiles {
 protected:
  /// Returns the displacement of a position target from the tool at the start, at a time, along
  /// the axes of the residual's rows [m].
  Eigen::Vector3d moved(const std::string& axes, const std::string& target, double time) const {
    const ProblemFile file =
        read(small("frame: tool, target: here", "frame: tool, " + axes + ", target: " + target));
    const auto& cost = std::get<residual::FramePosition>(file.spec.stages[0].costs[1].residual);
    const Eigen::VectorXd q = file.spec.initial_state.head(file.spec.model.nq);
    const files::PositionAxes seen =
        files::position_axes(file.spec.model, q, "tool", cost.reference.at(0.0));
    Eigen::VectorXd numbers(3);
    cost.target.at(time, numbers);
    const Eigen::Vector3d tool = frame_placement(file.spec.model, q, "tool").translation();
    return seen.rows.transpose() * (seen.numbers * Eigen::Vector3d(numbers) - tool);
  }
};

const std::vector<std::string> all_axes{
    "axes: {normal: [-0.5, 0, 0.8660254]}",
    "axes: {rpy: [0.3, -0.5, 1.0]}",
    "reference: {origin: link_3, axes: link_3}",
    "reference: {origin: link_3, axes: link_2, rpy: [0, 0.7, 0.2]}",
    "reference: {surface: {sphere: {center: [0, 0, -1], radius: 1}, near: [0, 0, 0]}}",
    "reference: {axes: link_2, over_time: {line: {from: {rpy: [0.4, 0, 0]}, to: {rpy: [0, 0, 0]},"
    " start: 0, duration: 1}}}",
};

TEST_F(HereTargets, Offset_IsAlongTheAxesOfTheCost) {
  for (const std::string& axes : all_axes)
    EXPECT_LT(
        (moved(axes, "{here: [0.1, 0.02, -0.03]}", 0.0) - Eigen::Vector3d(0.1, 0.02, -0.03)).norm(),
        1e-9)
        << axes;
}

TEST_F(HereTargets, Paths_AreAlongTheAxesOfTheCost) {
  write("time,x,y,z\n0,0,0,0\n1,0.1,0.2,0.3\n", "path.csv");
  for (const std::string& axes : all_axes)
    for (const auto& [target, wanted] : {
             std::pair<std::string, Eigen::Vector3d>{
                 "{line: {from: here, to: {here: [0.1, 0, 0]}, duration: 2}}", {0.05, 0, 0}},
             {"{circle: {start: here, radius: 0.1, rate: 3.14159265}}", {-0.2, 0, 0}},
             {"{circle: {center: here, axes: [[0, 0, 1], [1, 0, 0]], radius: 0.1,"
              " rate: 3.14159265}}",
              {0, 0, -0.1}},
             {"{sine: {center: here, amplitude: {z: 0.06}, rate: 1.57079633}}", {0, 0, 0.06}},
             {"{points: {file: path.csv, columns: [x, y, z], relative_to: here}}", {0.1, 0.2, 0.3}},
         })
      EXPECT_LT((moved(axes, target, 1.0) - wanted).norm(), 1e-8) << axes << " " << target;
}

TEST_F(HereTargets, NumbersWithoutHere_StayInTheirOwnCoordinates) {
  const std::string axes = "axes: {rpy: [0, 0, 1.5707963]}";
  const Eigen::Vector3d first =
      moved(axes, "{circle: {center: [1, 0, 0], radius: 0.1, rate: 0}}", 0.0);
  const Eigen::Vector3d second = moved(axes, "[1.1, 0, 0]", 0.0);
  EXPECT_LT((first - second).norm(), 1e-9);
}

/// Numbers are in the axes of a frame that is rotated at the world's origin.
TEST_F(HereTargets, FrameAtTheWorldsOrigin_HasNumbersInItsAxes) {
  ProblemSpec spec = read(small()).spec;
  Frame board{};
  board.name = "board";
  board.placement = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY());
  spec.model.frames.push_back(board);
  const Eigen::VectorXd q = spec.initial_state.head(spec.model.nq);
  const Reference reference{.origin = "board", .axes = "board"};
  const Eigen::Vector3d here = files::position_here(spec.model, q, "tool", reference).target;
  spec.stages[0].costs[1].residual =
      residual::FramePosition{.frame = "tool", .target = here, .reference = reference};
  Problem problem(spec);
  const Eigen::VectorXd r =
      problem.residual(0, 1, spec.initial_state, Eigen::VectorXd::Zero(spec.model.nv));
  EXPECT_LT(r.norm(), 1e-12);
}

}  // namespace
}  // namespace burnish::testing
