// Random optimal control problems with limits for robots that press, as values and as text of a
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

/// Random numbers that do not depend on the standard library.
class Draws {
 public:
  explicit Draws(std::uint64_t seed);

  double uniform(double low, double high);
  double log_uniform(double low, double high);
  double either_sign(double low, double high);  ///< Magnitude between the two, with random sign.
  int whole(int low, int high);                 ///< Integer from low to high, both included.
  bool chance(double probability);
  Eigen::Vector3d direction();

 private:
  std::uint64_t next();
  std::uint64_t state_;
};

/// Quantity that a limit applies to.
enum class LimitKind { Band, Inclination, Speed, Range, Effort, Box, Cone };
inline constexpr LimitKind limit_kinds[] = {
    LimitKind::Band,   LimitKind::Inclination, LimitKind::Speed, LimitKind::Range,
    LimitKind::Effort, LimitKind::Box,         LimitKind::Cone};
std::string_view name_of(LimitKind kind);

/// Limits on some rows of a residual.
struct Limit {
  LimitKind kind = LimitKind::Band;
  std::vector<std::string> rows = {};  ///< Names of the limited rows; empty: all.
  Eigen::VectorXd lower = {}, upper = {};
  double friction = 0.5;  ///< Friction coefficient, for a cone.
  int sides = 0;          ///< Number of sides of an inscribed pyramid; 0: the exact cone.
  bool late = false;      ///< True if it does not apply to the first LimitProblem::early knots.
};

/// Weights and targets of the costs.
struct Aims {
  double posture = 0.1, torque = 1e-4, along = 1e4, force = 1.0, turn = 100.0;
  double length = 0.1;    ///< Length of a line, or radius of a circle [m].
  double swing = 3.0;     ///< Amplitude of the target force [N].
  double sideways = 0.0;  ///< Amplitude of the tangential target force, if the tool holds [N].
  Eigen::Vector2d inclination_goal = Eigen::Vector2d::Zero();  ///< Target tilt [rad].
};

/// Arm with a tool that presses on a board. The tool slides along a path, or holds a point and
/// turns.
struct LimitProblem {
  std::string robot, frame;
  Eigen::VectorXd start;                              ///< Initial configuration, nq entries.
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< Normal of the board, in the world.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();    ///< Axis of the tool, in its frame.
  bool holds = false;
  int knots = 100;
  double step = 0.01;   ///< Step of a knot [s].
  double force = 15.0;  ///< Mean target force [N].
  double rate = 6.0, phase = 0.0;
  bool circle = false;
  double path_angle = 0.0;  ///< Direction of the path in the board [rad].
  Aims aims = {};
  int early = 0;          ///< Number of first knots without the late limits.
  double weight = 100.0;  ///< Weight of the robot, used as the scale of a cone's rows [N].
  std::vector<Limit> limits = {};

  Eigen::Matrix3d board() const;  ///< Axes of the board in columns: tangents and normal.
};

struct RobotChoice {
  std::string robot = {};  ///< Name or URDF file; empty: the bundled arms in turn.
  std::string frame = {};
};

/// Draws a problem without limits.
LimitProblem draw_problem(Draws& draws, const RobotChoice& choice);
/// Draws other aims for a problem. Their optimum is a feasible trajectory of the original problem.
Aims other_aims(Draws& draws, const Aims& aims);
/// Draws one to four kinds of limits. The limits themselves are too wide to have an effect.
std::vector<Limit> draw_kinds(Draws& draws, const LimitProblem& problem);
/// Draws limits of the given kinds that are independent of any solution.
std::vector<Limit> free_limits(Draws& draws, const LimitProblem& problem,
                               const std::vector<Limit>& kinds);

/// Form of the limits in a problem file.
struct TextForm {
  bool limits = true;
  /// Weight of costs on the squared violations (over their scales), which replace the limits; 0: no
  /// such costs.
  double penalty = 0.0;
  std::string description = {};
};

/// Returns the text of a problem file.
std::string text_of(const LimitProblem& problem, const TextForm& form);

}  // namespace burnish::bench
