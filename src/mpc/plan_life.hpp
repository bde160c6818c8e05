// State of an MpcController: which plan it follows, and whether it computes one.
#pragma once

namespace burnish {

/// State machine of an MpcController. An event that a state does not expect leaves the state
/// unchanged. docs/architecture.md has the table of transitions.
class PlanLife {
 public:
  enum class State : int {
    Settling,              ///< No plan was requested; the fallback holds the robot.
    FirstPlan,             ///< The first plan is being computed; the fallback holds the robot.
    Following,             ///< The controller follows a plan and computes none.
    FollowingWhileMaking,  ///< The controller follows a plan and computes the next one.
    Faulted,               ///< The fallback holds the robot until reset().
    FaultedWhileMaking,    ///< Faulted, and the result of a computation is not yet collected.
  };
  State state() const noexcept { return state_; }
  /// Returns true while the controller follows a plan.
  bool follows() const noexcept {
    return state_ == State::Following || state_ == State::FollowingWhileMaking;
  }
  /// Returns true from begin() until finish() or reset(), also after a fault.
  bool is_making() const noexcept {
    return state_ == State::FirstPlan || state_ == State::FollowingWhileMaking ||
           state_ == State::FaultedWhileMaking;
  }
  /// Returns true if a computation may begin.
  bool can_begin() const noexcept {
    return state_ == State::Settling || state_ == State::Following;
  }

  /// Records that the computation of a plan begins.
  void begin() noexcept {
    if (state_ == State::Settling) state_ = State::FirstPlan;
    if (state_ == State::Following) state_ = State::FollowingWhileMaking;
  }
  /// Records the collected result of a computation. An unusable first plan is a fault.
  void finish(bool usable) noexcept {
    if (state_ == State::FollowingWhileMaking) state_ = State::Following;
    if (state_ == State::FirstPlan) state_ = usable ? State::Following : State::Faulted;
    if (state_ == State::FaultedWhileMaking) state_ = State::Faulted;
  }
  /// Records a fault. A thread may still compute a plan.
  void raise_fault() noexcept { state_ = is_making() ? State::FaultedWhileMaking : State::Faulted; }
  /// Must not be called while a thread computes a plan.
  void reset() noexcept { state_ = State::Settling; }

 private:
  State state_ = State::Settling;
};

}  // namespace burnish
