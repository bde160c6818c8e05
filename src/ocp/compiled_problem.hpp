// A compiled ProblemSpec: names are resolved and sizes are fixed. Only the torque bias, the
// masses of the bodies and the values of inputs change after construction.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "burnish/ocp/problem_spec.hpp"
#include "burnish/solver/shooting_problem.hpp"
#include "dynamics/passive.hpp"
#include "ocp/compiled_residual.hpp"
#include "ocp/inputs.hpp"
#include "ocp/knot_time.hpp"

namespace burnish::ocp {

/// A cost or a constraint. A constraint has limits, but no weights and no penalty.
struct CompiledTerm {
  std::string name;
  CompiledResidual residual;
  Signal signal;  ///< Target in the user's form, or the default target
  int rows = 0;
  std::vector<std::string> row_names;  ///< Names of the rows; empty for a StateDifference
  int target = 0;                      ///< First entry in the stage's targets
  int target_size = 0;                 ///< Number of entries in the stage's targets
  int signal_size = 0;                 ///< Number of entries of the signal
  /// Conversion of the signal to target entries
  enum class Load { Plain, Rotation, Placement } load = Load::Plain;
  double weight = 1.0;          ///< Weight of a cost, per second in stages with a step
  std::vector<double> weights;  ///< Weights of a cost's rows
  Penalty::Kind penalty = Penalty::Kind::Quadratic;
  std::vector<double> lower, upper;  ///< Limits of the rows of a barrier or a constraint
  double width = 1.0;                ///< Width of the penalty
  std::vector<JacobianBlock> blocks;
  int jacobian_size = 0;
  int first_row = 0;  ///< First row of a constraint, among the stage's constraint rows
  /// First row of a constraint among the stage's rows with coefficients. -1: every row of the
  /// constraint is an entry of z, which needs no coefficients.
  int first_coefficients = 0;
  /// Index in the stage of a constraint's first curvature vector b (RowCurvature); -1: no curvature
  int first_curvature = -1;
  int curvature_rows = 0;  ///< Number of curvature vectors b of a constraint
};

/// A reference whose rotation depends on time. The stage's targets store the rotation in nine
/// entries, by columns.
struct CompiledTurning {
  Signal rotation;   ///< Rotation over time, as quaternions
  int target = 0;    ///< First entry in the stage's targets
  int contact = -1;  ///< Contact with this reference; -1: a term's reference
  std::string of;    ///< Owner of the reference for messages, such as "contact 'pad'"
};

/// A surface that a reference follows and that may differ from knot to knot. The stage's targets
/// store its numbers in surface_size entries.
struct CompiledSurface {
  Quadric surface;   ///< Surface at all knots until an input replaces it
  int target = 0;    ///< First entry in the stage's targets
  int contact = -1;  ///< Contact that follows the surface; -1: a term
  int term = -1;     ///< Term of the stage that follows the surface; -1: a contact
};

/// A contact's coefficient of friction, which may differ from knot to knot. The stage's targets
/// store it in one entry.
struct CompiledFriction {
  double coefficient = 0.0;
  int target = 0, contact = 0;
};

/// A stage: its contacts, costs, constraints and integrator.
struct CompiledStage {
  std::string name;
  std::vector<char> active;  ///< Whether each contact of the problem is active
  std::vector<CompiledFrame> frames;
  std::vector<std::string> frame_names;
  std::vector<CompiledTurning> turnings;
  std::vector<CompiledSurface> surfaces;
  std::vector<CompiledFriction> frictions;
  std::vector<CompiledUse> uses;             ///< Uses of inputs, in the order of application
  std::vector<CompiledTerm> terms;           ///< Costs, then constraints
  std::size_t costs = 0;                     ///< Number of costs
  std::vector<double> row_lower, row_upper;  ///< Limits of all constraint rows
  std::vector<double> row_scale, row_l1_weight, row_quadratic_weight;
  std::vector<int> row_entry;  ///< ShootingProblem::row_entry
  std::span<const CompiledTerm> cost_terms() const { return std::span(terms).first(costs); }
  std::span<const CompiledTerm> constraints() const { return std::span(terms).subspan(costs); }
  int rows() const { return static_cast<int>(row_lower.size()); }
  std::vector<RowCurvature> curvatures;  ///< ShootingProblem::row_curvatures
  int curvature_rows = 0;                ///< Number of curvature vectors b of all constraints
  int coefficient_rows = 0;              ///< Number of constraint rows that are not entries of z
  int targets = 0;  ///< Number of entries of all targets, turnings, surfaces and frictions
  int nu = 0;
  bool terminal = false, impact = false;
  bool solves_contacts = true;  ///< Whether accelerations and contact forces are computed
  bool has_momentum = false;
  Integrator integrator = Integrator::SemiImplicitEuler;
  bool dense = false;  ///< Whether the dynamics are linearized as DynamicsForm::Dense
  double step = 0.0;   ///< Step of knots without their own step [s]
  bool passes_time() const { return !terminal && !impact; }
};

/// Force state of a contact: its force at the previous step, as part of the state.
struct ForceState {
  int contact, rows;
  int first;  ///< Index of its first entry among all force states
};

/// The robot, the contacts and all stages of a problem.
struct CompiledProblem {
  /// Throws Error for an invalid specification.
  CompiledProblem(const ProblemSpec& spec);

  /// Returns the timing of a knot with this step [s], without KnotTime::times.
  KnotTime<double> timing(const CompiledStage& stage, double step) const;
  /// Throws Error("<place>: ...") for an invalid step [s].
  void check_step(const std::string& place, double step) const;

  Model model;
  Tree tree;
  StateLayout layout;
  StateShape shape;
  std::vector<TangentBlock> blocks;
  ContactSet contacts;
  Inputs inputs;
  std::vector<ForceState> force_states;
  ContactSolver contact_solver;
  std::optional<TorqueModel> torque_model;
  std::optional<PassiveJoints> passive;
  std::vector<double> torque_bias;  ///< Constant additional torque, nv entries [Nm or N]
  /// Decaying additional torque, to be multiplied by KnotTime::decaying; nv entries [Nm or N]
  std::vector<double> decaying_torque;
  std::vector<CompiledStage> stages;  ///< The terminal stage is the last one
  int largest_rows = 0;               ///< Largest number of rows of a term
  int largest_jacobian = 0;           ///< Largest CompiledTerm::jacobian_size
  int largest_targets = 0;            ///< Largest CompiledStage::targets
  int largest_terms = 0;              ///< Largest number of terms of a stage
  int largest_limited_rows = 0;       ///< Largest number of constraint rows of a stage
  int largest_curvatures = 0;         ///< Largest CompiledStage::curvature_rows
  bool has_impacts = false;
  bool has_dense_stages = false;  ///< Whether any stage is CompiledStage::dense
  bool has_custom = false;        ///< Whether any residual is a CustomResidual
};

/// Converts a target in the user's form to the target entries of the term.
void store_target(const CompiledTerm& term, const ConstVectorRef& value, double* out);
/// Evaluates the signals of a stage at `time` and writes all target entries of the stage to `out`,
/// without the effect of inputs (CompiledUse). A quaternion whose length is not 1 becomes a
/// rotation of NaN. `scratch` has as many entries as the largest signal, and at least 4.
void load_targets(const CompiledStage& stage, double time, const InputValues& inputs,
                  Eigen::VectorXd& scratch, double* out);
/// Writes the surface_size target entries of a surface to `out`.
void store_surface(const Quadric& surface, double* out);
/// Adds the surface that a reference follows to the stage's targets and returns its first entry; -1
/// if the reference follows no surface. `followed` names the contact or the term.
int add_surface(const Reference& reference, CompiledSurface followed, CompiledStage& stage);
/// Adds a reference's rotation to the stage's targets if it depends on time, and returns its first
/// entry; -1 for a constant reference.
int add_turning(const Reference& reference, int contact, const std::string& of,
                CompiledStage& stage);

/// Compiles costs and constraints of a stage. Error messages begin with `place` ("stage 'press'").
void compile_terms(const ProblemSpec& spec, const CompiledProblem& problem,
                   const std::vector<CostTerm>& costs, const std::vector<Constraint>& constraints,
                   const std::string& place, CompiledStage& stage);

}  // namespace burnish::ocp
