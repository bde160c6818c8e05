// A ProblemSpec compiled: names resolved, sizes fixed, lists made. Immutable but for the bias.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "burnish/ocp/problem_spec.hpp"
#include "burnish/solver/shooting_problem.hpp"
#include "dynamics/passive.hpp"
#include "ocp/compiled_residual.hpp"
#include "ocp/knot_time.hpp"

namespace burnish::ocp {

/// A cost, or a constraint: that has limits and neither weights nor a penalty.
struct CompiledTerm {
  std::string name;
  CompiledResidual residual;
  Signal signal;  ///< the target as the user gave it, or its default
  int rows = 0;
  std::vector<std::string> row_names;  ///< none of a difference of states
  int target = 0;                      ///< first entry in the stage's targets
  int target_size = 0;                 ///< entries there
  int signal_size = 0;                 ///< entries of the signal
  enum class Load { Plain, Rotation, Placement } load = Load::Plain;  ///< signal -> target entries
  double weight = 1.0;          ///< of a cost, per second while time passes
  std::vector<double> weights;  ///< of a cost's rows
  Penalty::Kind penalty = Penalty::Kind::Square;
  std::vector<double> lower, upper;  ///< rows
  double width = 1.0;
  std::vector<JacobianBlock> blocks;
  int jacobian_size = 0;
  int first_row = 0;  ///< of a constraint, in the stage's rows
  /// Of a constraint, in those of the stage that are no entries of z; -1: all of its rows are.
  int first_coefficients = 0;
  int first_bend = -1;  ///< of a constraint, in the stage's bend rows; -1: it offers none
  int bend_rows = 0;
};

/// A reference whose rotation is data of each knot: nine of the stage's targets, by columns.
struct CompiledTurning {
  Signal rotation;   ///< quaternions
  int target = 0;    ///< first entry in the stage's targets
  int contact = -1;  ///< whose it is; -1: a term's own
  std::string of;    ///< for messages, such as "contact 'pad'"
};

/// A surface that a reference follows, whose numbers are data of each knot: surface_size of the
/// stage's targets.
struct CompiledSurface {
  Quadric surface;   ///< where nothing else is said
  int target = 0;    ///< first entry in the stage's targets
  int contact = -1;  ///< whose it is; -1: a term's
  int term = -1;     ///< of the stage; -1: a contact's
};

/// A contact's coefficient of friction, likewise: one of the stage's targets.
struct CompiledFriction {
  double coefficient = 0.0;
  int target = 0, contact = 0;
};

struct CompiledStage {
  std::string name;
  std::vector<char> active;  ///< per contact of the problem
  std::vector<CompiledFrame> frames;
  std::vector<std::string> frame_names;
  std::vector<CompiledTurning> turnings;
  std::vector<CompiledSurface> surfaces;
  std::vector<CompiledFriction> frictions;
  std::vector<CompiledTerm> terms;           ///< costs, then constraints
  std::size_t costs = 0;                     ///< how many are costs
  std::vector<double> row_lower, row_upper;  ///< of all constraints, one after the other
  std::vector<double> row_scale, row_price, row_square;
  std::vector<int> row_entry;  ///< ShootingProblem::row_entry
  std::span<const CompiledTerm> cost_terms() const { return std::span(terms).first(costs); }
  std::span<const CompiledTerm> constraints() const { return std::span(terms).subspan(costs); }
  int rows() const { return static_cast<int>(row_lower.size()); }
  std::vector<RowBend> bends;  ///< ShootingProblem::row_bends
  int bend_rows = 0;           ///< their b
  int coefficient_rows = 0;    ///< of all constraints, those that are no entries of z
  int targets = 0;             ///< entries of all targets, turnings, surfaces and frictions
  int nu = 0;
  bool terminal = false, impact = false;
  bool solves_contacts = true;  ///< accelerations and forces are needed
  bool has_momentum = false;
  Integrator integrator = Integrator::SemiImplicitEuler;
  bool dense = false;  ///< its step is expanded as DynamicsForm::Dense
  double step = 0.0;   ///< s, of knots that have none of their own
  bool passes_time() const { return !terminal && !impact; }
};

/// The force of a contact in the state.
struct RememberedForce {
  int contact, rows;
  int first;  ///< entry among all that are remembered
};

struct CompiledProblem {
  CompiledProblem(const ProblemSpec& spec);

  /// Of a knot of a stage whose step is so long, s; without its time.
  KnotTime<double> timing(const CompiledStage& stage, double step) const;
  /// Throws Error("<place>: ...") for a step that cannot be.
  void check_step(const std::string& place, double step) const;

  Model model;
  Tree tree;
  StateLayout layout;
  StateShape shape;
  std::vector<TangentBlock> blocks;
  ContactSet contacts;
  std::vector<RememberedForce> remembered;
  ContactSolver contact_solver;
  std::optional<TorqueModel> torque_model;
  std::optional<PassiveJoints> passive;
  std::vector<double> torque_bias;     ///< nv, Nm (N): acts beside the actuators
  std::vector<double> passing_torque;  ///< nv, Nm (N): likewise, of which KnotTime::passing is left
  std::vector<CompiledStage> stages;   ///< the terminal one last
  int largest_rows = 0;                ///< of a term
  int largest_jacobian = 0;
  int largest_targets = 0;  ///< of a stage
  int largest_terms = 0;
  int largest_limited_rows = 0;  ///< of all constraints of a stage
  int largest_bends = 0;         ///< CompiledStage::bend_rows
  bool has_impacts = false;
  bool has_dense_stages = false;  ///< CompiledStage::dense
  bool has_custom = false;        ///< residuals
};

/// A target as the user writes it -> target entries of the term.
void store_target(const CompiledTerm& term, const ConstVectorRef& value, double* out);
/// Targets and rotations of a stage from their signals at a time; scratch: as many entries as the
/// largest signal, at least 4. What is no rotation becomes NaN.
void load_targets(const CompiledStage& stage, double time, Eigen::VectorXd& scratch, double* out);
void store_surface(const Quadric& surface, double* out);
/// Makes room for the surface that a reference follows among the stage's targets; `followed` is
/// whose. -1 for a reference that follows none.
int add_surface(const Reference& reference, CompiledSurface followed, CompiledStage& stage);
/// Makes room for a rotation over time among the stage's targets; -1 for a reference that stays.
int add_turning(const Reference& reference, int contact, const std::string& of,
                CompiledStage& stage);

/// Makes the terms of a stage. `place` says where for messages, such as "stage 'press'".
void compile_terms(const ProblemSpec& spec, const CompiledProblem& problem,
                   const std::vector<CostTerm>& costs, const std::vector<Constraint>& constraints,
                   const std::string& place, CompiledStage& stage);

}  // namespace burnish::ocp
