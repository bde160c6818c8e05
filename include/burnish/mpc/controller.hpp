// Interface of controllers. A controller turns each measurement of a plant into a command.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/base/status.hpp"
#include "burnish/base/trace.hpp"
#include "burnish/base/views.hpp"
#include "burnish/estimate/measurement.hpp"
#include "burnish/model/inertia.hpp"

namespace burnish {

/// Targets and estimates of a controller at one tool.
/// @described mpc
struct ToolCommand {
  /// Target of the normal force of the surface on the tool [N]
  double target_force = 0.0;
  /// Target position of the tool frame's origin, in world axes [m]
  /// @more While the tool presses, the target lies on the estimated surface
  Eigen::Vector3d p_target_world = Eigen::Vector3d::Zero();
  /// Estimated surface normal at the tool, a unit vector in world axes
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
  /// Estimated force of the surface on the tool, in world axes [N]
  Eigen::Vector3d force_estimate_world = Eigen::Vector3d::Zero();
  /// Estimated coefficient of friction between tool and surface
  double friction = 0.0;
};

/// Output of a controller. Only `tau` reaches the plant. The other entries record targets,
/// estimates and solver results.
/// @described mpc
struct Command {
  /// Joint torques to apply, nv entries, zero for a floating base [Nm (N)]
  Eigen::VectorXd tau;
  /// Current phase of the task
  /// @more For an MpcController, this is the index of the phase in the schedule
  int phase = 0;
  /// Targets and estimates at each tool
  /// @more For an MpcController, in the order of MpcSpec.tools. A controller without a tool has one
  /// entry, which records the targets of its task
  std::vector<ToolCommand> tools = std::vector<ToolCommand>(1);
  Status status = Status::Ok;
  /// Wall-clock time of the solve that finished at this tick [s]; 0: no solve finished
  double solve_time = 0.0;
  /// Number of iterations of the solve that finished at this tick; 0: no solve finished
  int iterations = 0;
  /// True if the solve that finished at this tick took longer than its deadline
  bool missed_deadline = false;
  /// Largest violation of a hard constraint in the last plan, as a fraction of the constraint's
  /// scale
  double constraint_violation = 0.0;
  /// Constraint residual after the last iteration of the last solve, as a fraction of the
  /// constraint's scale
  double constraint_residual = 0.0;
  /// Number of active constraints in the last plan, summed over all knots
  int active_constraints = 0;
  /// True if the last solve found that the hard constraints cannot all be satisfied
  bool constraints_infeasible = false;
  int clipped_torques = 0;  ///< Number of joints whose torque was clipped to its limit at this tick
};

/// Interface of controllers that run at a fixed period. tick() does not allocate and does not
/// throw.
class Controller {
 public:
  virtual ~Controller() = default;
  virtual int nv() const = 0;
  /// Returns the touches (tool or feet) whose wrenches the controller reads, in the order of the
  /// columns of Measurement::wrenches. If the result has no value, there is a column for each touch
  /// of the plant's scene. ClosedLoop throws Error if the controller reads a component of a wrench
  /// that the scene does not measure. WrenchSensor::Automatic stands for the measured components.
  virtual std::optional<std::vector<TouchSensor>> touches() const { return std::nullopt; }
  /// Returns the frames of the tools of Command::tools, in the same order. If the result is empty,
  /// Command::tools has one entry, for the first tool of the plant's scene. Otherwise, the
  /// controller must give Command::tools one entry per frame; a trace has NaN for missing entries.
  virtual std::vector<std::string> tools() const { return {}; }
  /// Returns names and units of the values that the controller publishes, such as estimates. A
  /// ClosedLoop calls signals() when it is made, and records each value in a column "signal_<name>"
  /// of its trace. The page of a run plots the signals: of each unit, up to seven with the largest
  /// absolute values. Names must differ, and must be valid names of a TraceColumn.
  virtual std::vector<TraceColumn> signals() const { return {}; }
  /// Writes the values of signals() at the last tick. `values` has one entry per signal; entries
  /// that are not written count as unknown (NaN). Called once per row of a trace. Must not
  /// allocate.
  virtual void write_signals(std::span<double> /*values*/) const noexcept {}
  /// Forgets all previous ticks.
  virtual void reset() noexcept = 0;
  /// Returns the command for a measurement. The returned object is valid until the next call. After
  /// a numerical failure, Command::status is not Ok, but Command::tau can still be applied.
  virtual const Command& tick(const Measurement& measurement) noexcept = 0;

  /// Sets the payload that the robot carries at a frame, from the next tick on. `payload`: inertia
  /// in the axes of `frame`. reset() keeps the payload. Returns NotEvaluated if the controller
  /// ignores payloads; otherwise returns and throws as ContactDynamics::set_payload() does.
  virtual Status set_payload(std::string_view frame, const InertiaSpec& payload) {
    (void)frame, (void)payload;
    return Status::NotEvaluated;
  }
  /// Returns the mass of all payloads that set_payload() has set [kg].
  virtual double payload_mass() const noexcept { return 0.0; }

 protected:
  Controller() = default;
  Controller(const Controller&) = default;
  Controller& operator=(const Controller&) = default;
};

/// Controller that passes all calls of the interface Controller on to another controller. A class
/// that changes or records the measurements or commands of a controller derives from it, and
/// overrides only what differs. A wrapper with signals of its own appends them to those of inner(),
/// and passes only the first entries of `values` on.
class ControllerWrapper : public Controller {
 public:
  /// `inner` must outlive the wrapper.
  explicit ControllerWrapper(Controller& inner) : inner_(&inner) {}
  int nv() const override { return inner_->nv(); }
  std::optional<std::vector<TouchSensor>> touches() const override { return inner_->touches(); }
  std::vector<std::string> tools() const override { return inner_->tools(); }
  std::vector<TraceColumn> signals() const override { return inner_->signals(); }
  void write_signals(std::span<double> values) const noexcept override {
    inner_->write_signals(values);
  }
  void reset() noexcept override { inner_->reset(); }
  const Command& tick(const Measurement& measurement) noexcept override {
    return inner_->tick(measurement);
  }
  Status set_payload(std::string_view frame, const InertiaSpec& payload) override {
    return inner_->set_payload(frame, payload);
  }
  double payload_mass() const noexcept override { return inner_->payload_mass(); }

 protected:
  Controller& inner() const { return *inner_; }

 private:
  Controller* inner_;
};

}  // namespace burnish
