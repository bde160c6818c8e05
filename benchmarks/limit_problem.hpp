// Random optimal control problems with limits of robots that press, as values and as the text of a
// problem file.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/robots/robot.hpp"

namespace burnish::bench {

/// Random numbers that are the same with every standard library.
class Draws {
 public:
  explicit Draws(std::uint64_t seed);

  double uniform(double low, double high);
  double log_uniform(double low, double high);
  double either_sign(double low, double high);  ///< a size between the two, of either sign
  int whole(int low, int high);                 ///< both are possible
  bool chance(double probability);
  Eigen::Vector3d direction();

 private:
  std::uint64_t next();
  std::uint64_t state_;
};

/// What a limit is on.
enum class LimitKind { Band, Lean, Speed, Range, Effort, Box, Cone };
inline constexpr LimitKind limit_kinds[] = {LimitKind::Band,  LimitKind::Lean,   LimitKind::Speed,
                                            LimitKind::Range, LimitKind::Effort, LimitKind::Box,
                                            LimitKind::Cone};
std::string_view name_of(LimitKind kind);

/// Limits on some rows of a residual.
struct Limit {
  LimitKind kind = LimitKind::Band;
  std::vector<std::string> rows = {};  ///< limited ones by name; empty: all
  Eigen::VectorXd lower = {}, upper = {};
  double friction = 0.5;  ///< cone: its coefficient
  int sides = 0;          ///< cone: of a pyramid inside; 0: the cone
  bool late = false;      ///< not at the first knots, LimitProblem::early of them
};

/// Weights and targets that decide where the optimum is.
struct Aims {
  double posture = 0.1, torque = 1e-4, along = 1e4, force = 1.0, turn = 100.0;
  double length = 0.1;                                  ///< of the path, m, or a circle's radius
  double swing = 3.0;                                   ///< amplitude of the force's target, N
  double sideways = 0.0;                                ///< holding: that of a tangential force, N
  Eigen::Vector2d lean_goal = Eigen::Vector2d::Zero();  ///< holding: where the tool turns to, rad
};

/// An arm whose tool presses on a board: it slides along a path, or holds a point and turns.
struct LimitProblem {
  std::string robot, frame;
  Eigen::VectorXd start;                              ///< nq
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of the board, world
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();    ///< of the tool, in its frame
  bool holds = false;
  int knots = 100;
  double step = 0.01;   ///< s
  double force = 15.0;  ///< N
  double rate = 6.0, phase = 0.0;
  bool circle = false;
  double path_angle = 0.0;  ///< rad, of its direction in the board
  Aims aims = {};
  int early = 0;          ///< knots without the late limits
  double weight = 100.0;  ///< of the robot, N: what counts as much of a cone's rows
  std::vector<Limit> limits = {};

  Eigen::Matrix3d board() const;  ///< columns: tangents and normal
};

/// Where robots come from.
struct RobotChoice {
  std::string robot = {};  ///< empty: the shipped arms in turn; else a name or a URDF file
  std::string frame = {};
};

/// A problem without limits.
LimitProblem draw_problem(Draws& draws, const RobotChoice& choice);
/// Aims that differ, of the same problem: their optimum is a known trajectory of the first.
Aims other_aims(Draws& draws, const Aims& aims);
/// One to four kinds, each with a limit that keeps nothing from anywhere.
std::vector<Limit> draw_kinds(Draws& draws, const LimitProblem& problem);
/// Limits that know nothing of a solution, in the place of those of `kinds`.
std::vector<Limit> free_limits(Draws& draws, const LimitProblem& problem,
                               const std::vector<Limit>& kinds);

/// What is written of limits.
struct TextForm {
  bool limits = true;
  /// Weight of squared violations over their scales, as costs in the place of the limits; 0: limits
  double penalty = 0.0;
  std::string description = {};
};

/// A problem file.
std::string text_of(const LimitProblem& problem, const TextForm& form);

}  // namespace burnish::bench
