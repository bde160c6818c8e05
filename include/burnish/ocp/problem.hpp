// An optimal control problem of a robot in contact, compiled: what a solver solves.
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

/// Knots of one stage that follow each other are evaluated as packs, one knot per lane.
///
/// Everything is allocated when the problem is made and by prepare(); the setters of targets, times
/// and the initial state allocate nothing and may be called between the ticks of a controller.
class Problem final : public ShootingProblem {
 public:
  /// Compiles the specification. Throws Error with one sentence that names the stage and the term.
  explicit Problem(const ProblemSpec& spec);
  ~Problem() override;
  Problem(Problem&&) noexcept;
  Problem& operator=(Problem&&) noexcept;

  const ProblemSpec& spec() const;
  const Model& model() const;
  const StateLayout& layout() const;

  /// Names of the stages, the last one "terminal", and which one a knot belongs to.
  std::vector<std::string> stage_names() const;
  int stage_of(int knot) const;
  double time_of(int knot) const;  ///< s
  double step_of(int knot) const;  ///< s; 0 at impacts and at the end
  /// Index of a stage, or of a term in a stage: its costs first, then its constraints. Throw Error
  /// with the nearest known name.
  int stage_index(const std::string& name) const;
  int term_index(int stage, const std::string& name) const;
  int terms(int knot) const;  ///< how many: costs and constraints

  /// nx entries. Returns WrongSize, NotFinite, NotNormalized or Ok; a state that is refused changes
  /// nothing. Targets that are the specification's initial state stay that.
  Status set_initial_state(const ConstVectorRef& x);
  /// Gives a knot another stage and time; signals are asked for their values there. The terminal
  /// knot keeps its stage. Throws Error for a knot or stage that there is not.
  void set_knot(int knot, int stage, double time);
  /// Gives a knot a step of its own, s, whatever its stage, from then on. Times stay: set_knot()
  /// gives them to the knots that are now earlier or later. Throws Error for a knot that there is
  /// not or where no time passes, and for a step that is not positive, or with which the torque
  /// model's Euler steps are unstable.
  void set_step(int knot, double step);
  /// Drops knot 0, moves the others one forward and appends one of this stage at the time after the
  /// last one, as long as that was if it has a step of its own; the terminal knot follows. Throws
  /// Error for a stage that there is not.
  void advance(int stage);
  /// Writes the target of one term at one knot until the knot is set or advanced again: entries as
  /// the residual says. Returns WrongSize or Ok. Throws Error for a knot or term that there is not.
  Status set_target(int knot, int term, const ConstVectorRef& target);
  /// Gives a knot another surface, in the axes of the base, in the place of the one that the
  /// reference of a contact follows (Reference::on), until the knot is set or advanced again; a
  /// stage that does not hold the contact passes it over. Returns NotFinite for one that holds a
  /// NaN or an infinity, which changes nothing, or Ok. Throws Error for a knot or contact that
  /// there is not, and for a reference that follows no surface.
  Status set_surface(int knot, int contact, const Quadric& surface);
  /// Gives a knot another coefficient of a contact's friction, likewise: NotFinite for one that is
  /// no number of at least zero. Throws Error for a contact without friction.
  Status set_friction(int knot, int contact, double coefficient);
  /// The same of the surface that the reference of one term follows. Throws Error for a knot or
  /// term that there is not, and for one whose reference follows no surface.
  Status set_term_surface(int knot, int term, const Quadric& surface);
  /// What the robot carries at a frame from now on, at all knots, in the frame's axes and in the
  /// place of what that frame's body carried before; model() has it from then on. Allocates
  /// nothing. Returns Ok, or NotFinite or NotPhysical as check_inertia() does, which changes
  /// nothing. Throws Error with the nearest known name for a frame that there is not, and for one
  /// that is fixed to the world.
  Status set_payload(std::string_view frame, const InertiaSpec& payload);
  /// A constant torque on the joints that the model does not know of, nv entries, Nm (N); zero at
  /// first. Returns WrongSize, NotFinite or Ok.
  Status set_torque_bias(const ConstVectorRef& torque);
  /// The same, with another torque beside it that is there at the first knot and passes:
  /// exp(-t / fading) of it is left t s later, by the times that the knots have now; `fading`: s.
  Status set_torque_bias(const ConstVectorRef& torque, const ConstVectorRef& passing,
                         double fading);

  /// The control of least norm that with the contacts of a stage holds a state at rest.
  /// @described ocp @result
  /// Where a state that does not move needs no control but this: nu entries of least norm that with
  /// the contacts of a stage hold x at rest, together with the forces; `residual` of the rest, Nm.
  struct QuasiStatic {
    Eigen::VectorXd control;  ///< nu, Nm
    Eigen::VectorXd force;    ///< rows of the stage's contacts, N and Nm
    double residual = 0.0;    ///< largest torque that nothing balances, Nm
  };
  /// `force`, when not empty, prescribes the contact forces, and only the control is free; without
  /// rows for the robot's loops those carry what they must.
  /// References that turn are as at the first knot of the stage.
  QuasiStatic quasi_static(int stage, const ConstVectorRef& x,
                           const Eigen::VectorXd& force = {}) const;

  /// One term at a knot: r (rows) and dr/dz (rows x nz), z = (u, dq, dv, dtau). Throws Error for a
  /// knot or term that there is not and for wrong sizes.
  Eigen::VectorXd residual(int knot, int term, const ConstVectorRef& x, const ConstVectorRef& u);
  RowMatrix residual_derivative(int knot, int term, const ConstVectorRef& x,
                                const ConstVectorRef& u);
  /// Contact forces (rows of the stage's contacts, in their order) and joint accelerations at a
  /// knot; empty where nothing solves for them.
  Eigen::VectorXd forces(int knot, const ConstVectorRef& x, const ConstVectorRef& u);
  Eigen::VectorXd acceleration(int knot, const ConstVectorRef& x, const ConstVectorRef& u);
  std::vector<std::string> force_names(int knot) const;
  /// Of the forces that the state remembers, likewise.
  std::vector<std::string> remembered_names() const;

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
  const double* row_price(int knot) const override;
  const double* row_square(int knot) const override;
  /// Of distances with an upper limit and of friction cones with a lower one: the bend of a length
  /// of position or force, as if those were linear in the state.
  std::span<const RowBend> row_bends(int knot) const override;
  int max_bends() const override;
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
  /// "CONSTRAINT/ROW", such as "force/z" or "range/arm_right_2_joint".
  std::vector<std::string> row_names(int knot) const override;
  std::vector<double> term_costs(int knot, const double* x, const double* u) override;
  std::vector<double> row_values(int knot, const double* x, const double* u) override;
  std::string knot_name(int knot) const override;

 private:
  friend struct ocp::ProblemInside;  // the checker reads what was compiled
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
