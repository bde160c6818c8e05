// A compiled optimal control problem of a robot in contact, ready for a solver.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/base/views.hpp"
#include "burnish/model/inertia.hpp"
#include "burnish/ocp/node_view.hpp"
#include "burnish/ocp/problem_spec.hpp"
#include "burnish/solver/shooting_problem.hpp"

namespace burnish {
namespace ocp {
struct ProblemInside;
}

/// Optimal control problem of a robot in contact, compiled from a ProblemSpec. Consecutive knots of
/// one stage are evaluated together in SIMD packs, one knot per lane.
///
/// Only the constructor and prepare() allocate. Functions that set targets, times or the initial
/// state do not allocate, so that a control loop may call them.
class Problem final : public ShootingProblem {
 public:
  /// Compiles the specification. Throws Error if the specification is invalid, with one sentence
  /// that names the stage and the term.
  explicit Problem(const ProblemSpec& spec);
  ~Problem() override;
  Problem(Problem&&) noexcept;
  Problem& operator=(Problem&&) noexcept;

  const ProblemSpec& spec() const;
  const Model& model() const;
  const StateLayout& layout() const;

  /// stage_names() returns the names of the stages, the last of which is "terminal". stage_of()
  /// returns the index of a knot's stage in stage_names().
  std::vector<std::string> stage_names() const;
  int stage_of(int knot) const;
  double time_of(int knot) const;  ///< Time at which a knot begins [s]
  double step_of(int knot) const;  ///< Duration of a knot's step [s]; 0 at impacts and at the end

  /// stage_index() returns the index of a stage. term_index() returns the index of a cost or
  /// constraint in a stage, where costs come before constraints. Both functions throw Error with
  /// the nearest known name if the name is unknown.
  int stage_index(const std::string& name) const;
  int term_index(int stage, const std::string& name) const;
  int terms(int knot) const;  ///< Number of terms of a knot, costs and constraints together

  /// Sets the initial state x, nx entries. Returns Ok, WrongSize, NotFinite or NotNormalized.
  /// Unless Ok is returned, nothing changes. A target that defaults to the initial state of the
  /// specification does not change.
  Status set_initial_state(const ConstVectorRef& x);
  /// Assigns a stage and a time [s] to a knot, and evaluates the stage's signals at that time. At
  /// the terminal knot, only the time is assigned. Throws Error if the knot or the stage does not
  /// exist.
  void set_knot(int knot, int stage, double time);
  /// Sets the duration of a knot's step [s]. This duration replaces the step of the knot's stage,
  /// even if set_knot() changes the stage later. set_step() does not change the times of knots; for
  /// these, call set_knot(). Throws Error if the knot does not exist or is an impact. Also throws
  /// Error if the step is not positive, or too long for stable Euler steps of the torque model.
  void set_step(int knot, double step);
  /// Advances the horizon by one knot: drops knot 0, renumbers the others, and appends a knot of
  /// the given stage. If the knot before the appended one has its own step, the appended knot gets
  /// the same step. The terminal knot moves to the new end. Throws Error if the stage does not
  /// exist.
  void advance(int stage);
  /// input_names() returns the names of the inputs, in the order of ProblemSpec::inputs.
  /// input_index() returns the index of an input. For an unknown name, throws Error with the
  /// nearest known name.
  std::vector<std::string> input_names() const;
  int input_index(const std::string& name) const;
  /// Sets the value of a scalar, vector or rotation input, for all knots. The value replaces
  /// InputSpec::value where the input is used. It also replaces what set_target(), set_surface(),
  /// set_term_surface() and set_friction() have set there. Targets that are functions of inputs
  /// (Signal::of_inputs()) change at the next set_knot() of each knot.
  ///
  /// Returns Ok, WrongSize, NotFinite (also for a negative friction, ratio or depth) or
  /// NotNormalized. Unless Ok is returned, nothing changes. Throws Error if the input does not
  /// exist, or is of another kind.
  Status set_input(int input, const ConstVectorRef& value);
  /// Sets a scalar input, like set_input() with a vector of one entry.
  Status set_input(int input, double value);
  /// Sets a scalar or vector input, a part of which decays along the horizon. At a knot at time t,
  /// the input is value + exp(-(t - t_0) / decay_time) decaying. Here t_0 is the time of knot 0.
  /// Returns NotFinite unless `decay_time` [s] > 0. advance() updates all knots, like a new call.
  /// If set_knot() changes the time of knot 0, the input at another knot changes only at the next
  /// set_knot() of that knot. All else is as in set_input(input, value).
  Status set_input(int input, const ConstVectorRef& value, const ConstVectorRef& decaying,
                   double decay_time);
  /// Sets a surface input. `surface` is written in the axes of the surfaces and target positions
  /// that it changes. `depth` [m] >= 0 is the depth by which the surface yields. All else is as in
  /// set_input(input, value).
  Status set_input(int input, const Quadric& surface, double depth = 0.0);
  /// Sets an inertia input, see set_payload(). `payload` is written in the axes of
  /// InputSpec::frame. All else is as in set_input(input, value).
  Status set_input(int input, const InertiaSpec& payload);
  /// Resets the input to InputSpec::value. For an inertia, removes the payload of its body, even if
  /// set_payload() has set it. Throws Error if the input does not exist.
  void reset_input(int input);
  /// Returns the value of a scalar, vector or rotation input at a knot. The result is empty for a
  /// surface, for an inertia, and for an input without a value. Torques from set_torque_bias() are
  /// not in the result. Throws Error if the input or the knot does not exist.
  Eigen::VectorXd input_at(int input, int knot) const;
  /// Sets the target of one cost or constraint at one knot. The size of `target` depends on the
  /// kind of residual. The target is valid until the next set_knot() for this knot. advance()
  /// shifts the target together with the knot, and resets the target at the terminal knot.
  ///
  /// Returns Ok or WrongSize. Throws Error if the knot or the term does not exist.
  Status set_target(int knot, int term, const ConstVectorRef& target);
  /// Sets the surface of a contact at one knot. The axes of the contact's reference must follow a
  /// surface (Reference::on). `surface` is written in the axes of the contact's base. It is valid
  /// until the next set_knot() for this knot. advance() shifts the surface together with the knot,
  /// and resets the surface at the terminal knot. If the contact is not active in the knot's stage,
  /// the surface has no effect.
  ///
  /// Returns Ok. For a NaN or an infinity, returns NotFinite and changes nothing. Throws Error if
  /// the knot or the contact does not exist, or if the reference does not follow a surface.
  Status set_surface(int knot, int contact, const Quadric& surface);
  /// Sets the friction coefficient of a contact at one knot. The coefficient is valid until the
  /// next set_knot() for this knot. advance() shifts the coefficient together with the knot, and
  /// resets the coefficient at the terminal knot. If the contact is not active in the knot's stage,
  /// the coefficient has no effect.
  ///
  /// Returns Ok, or NotFinite if the coefficient is negative or not finite. Throws Error if the
  /// knot or the contact does not exist, or if the contact has no friction.
  Status set_friction(int knot, int contact, double coefficient);
  /// Sets the surface of one cost or constraint at one knot. The axes of the term's reference must
  /// follow a surface (Reference::on). `surface` is valid until the next set_knot() for this knot.
  /// advance() shifts the surface together with the knot, and resets the surface at the terminal
  /// knot.
  ///
  /// Returns Ok. For a NaN or an infinity, returns NotFinite and changes nothing. Throws Error if
  /// the knot or the term does not exist, or if its reference does not follow a surface.
  Status set_term_surface(int knot, int term, const Quadric& surface);
  /// Sets the payload that the robot carries at a frame, for all knots and in model(). `payload` is
  /// written in the axes of the frame. It replaces an earlier payload of the frame's body.
  /// Allocates nothing. Returns Ok. If check_inertia() returns NotFinite or NotPhysical for
  /// `payload`, returns this status and changes nothing. Throws Error if the frame is fixed to the
  /// world. For an unknown frame, throws Error with the nearest known name.
  Status set_payload(std::string_view frame, const InertiaSpec& payload);
  /// Sets a constant torque that acts on the joints in addition to all torques of the model, nv
  /// entries [Nm, N]. Initially this torque is zero, or the value of
  /// ProblemSpec::torque_bias_input. The last call of set_torque_bias() or of set_input() for that
  /// input counts. Returns Ok, WrongSize or NotFinite.
  Status set_torque_bias(const ConstVectorRef& torque);
  /// Sets a constant torque and a decaying torque, nv entries each [Nm, N]. Both act on the joints
  /// in addition to all torques of the model. At a time t after the first knot, their sum is torque
  /// + exp(-t / decay_time) decaying. `decay_time` [s] must be > 0. t is computed from the current
  /// times of the knots. Returns Ok, WrongSize or NotFinite.
  Status set_torque_bias(const ConstVectorRef& torque, const ConstVectorRef& decaying,
                         double decay_time);

  /// Control and contact forces that hold a posture at rest.
  /// @described ocp @result
  /// If exact balance is impossible, the sum of the squared unbalanced torques is minimal. Among
  /// all solutions, control and forces together have the smallest norm.
  struct QuasiStatic {
    Eigen::VectorXd control;  ///< Control, nu entries, Nm
    Eigen::VectorXd force;    ///< Forces, one entry per row of the stage's contacts, N and Nm
    double residual = 0.0;    ///< Largest joint torque that remains unbalanced, Nm
  };
  /// Computes the control and the contact forces that hold the posture of x at rest in a stage. If
  /// `force` is not empty, it prescribes the contact forces. If `force` omits the rows of the
  /// robot's loops, the loop forces are still computed. References that rotate over time are
  /// evaluated at the stage's first knot. Throws Error for wrong sizes, and for a posture that
  /// cannot be evaluated.
  QuasiStatic quasi_static(int stage, const ConstVectorRef& x,
                           const Eigen::VectorXd& force = {}) const;

  /// residual() returns the residual r of one term at a knot. residual_derivative() returns dr/dz,
  /// rows x nz, with z = (du, dq, dv, dtau, dforce). Both throw Error if the knot or the term does
  /// not exist, and for wrong sizes.
  Eigen::VectorXd residual(int knot, int term, const ConstVectorRef& x, const ConstVectorRef& u);
  RowMatrix residual_derivative(int knot, int term, const ConstVectorRef& x,
                                const ConstVectorRef& u);
  /// forces() returns the contact forces at a knot: one entry per row, in the order of the stage's
  /// contacts. acceleration() returns the joint accelerations. Both are empty at impacts. They are
  /// also empty at the end of the horizon, unless a cost or constraint at the end uses contact
  /// forces.
  Eigen::VectorXd forces(int knot, const ConstVectorRef& x, const ConstVectorRef& u);
  Eigen::VectorXd acceleration(int knot, const ConstVectorRef& x, const ConstVectorRef& u);
  std::vector<std::string> force_names(int knot) const;
  /// Returns the names of the contact forces in the state, such as "foot/z". The state contains
  /// forces of the previous step for contacts in ProblemSpec::force_states.
  std::vector<std::string> force_state_names() const;

  // ShootingProblem
  const StateShape& state() const override;
  int knots() const override;
  int controls(int knot) const override;
  int max_controls() const override;
  const double* initial_state() const override;
  void integrate(const double* x, const double* dx, double* out) const override;
  void difference(const double* x0, const double* x1, double* dx) const override;
  const double* control_lower(int knot) const override;
  const double* control_upper(int knot) const override;
  const double* control_scale(int knot) const override;
  int rows(int knot) const override;
  int max_rows() const override;
  const double* row_lower(int knot) const override;
  const double* row_upper(int knot) const override;
  const int* row_entry(int knot) const override;
  const double* row_scale(int knot) const override;
  const double* row_l1_weight(int knot) const override;
  const double* row_quadratic_weight(int knot) const override;
  /// Returns the curvature of constraint rows. Only two kinds of rows have curvature: distances
  /// with an upper limit, and friction cones with a lower limit. Both contain the length of a
  /// vector, which is a relative position or a force. The curvature is computed as if the vector
  /// were linear in the state.
  std::span<const RowCurvature> row_curvatures(int knot) const override;
  int max_curvatures() const override;
  void prepare(int workers) override;
  std::span<const KnotRange> ranges() const override;
  KnotValue roll(int worker, int knot, const double* x, const double* u, double* next,
                 double* rows = nullptr) override;
  void evaluate(int worker, KnotRange range, TrajectoryView at, double* next, KnotValue* values,
                double* rows = nullptr) override;
  void expand(int worker, KnotRange range, TrajectoryView at, double* next, KnotValue* values,
              KnotExpansion* out) override;
  std::vector<std::string> state_names() const override;
  std::vector<std::string> control_names() const override;
  std::vector<std::string> term_names(int knot) const override;
  /// Returns a name "CONSTRAINT/ROW" for each constraint row, such as "force/z" or
  /// "range/arm_right_2_joint".
  std::vector<std::string> row_names(int knot) const override;
  std::vector<double> term_costs(int knot, const double* x, const double* u) override;
  std::vector<double> row_values(int knot, const double* x, const double* u) override;
  std::string knot_name(int knot) const override;

 private:
  friend struct ocp::ProblemInside;  // the checker reads the compiled problem
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
