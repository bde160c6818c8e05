// Compiler of one cost or constraint: from the user's specification to a CompiledTerm.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "burnish/base/error.hpp"
#include "ocp/compiled_problem.hpp"

namespace burnish::ocp {

/// State of the compilation of one term. Error messages begin with `where`.
struct TermBuilder {
  const ProblemSpec& spec;
  const CompiledProblem& problem;
  const Residual& residual;
  CompiledStage& stage;
  CompiledTerm term;
  std::string where;

  [[noreturn]] void refuse(const std::string& what) const { throw Error(where + ": " + what); }

  const StateLayout& layout() const { return problem.layout; }

  // Defined in term_builder.cpp: parts that several kinds of residuals share.

  void target(const Signal& signal, int size, const Eigen::VectorXd& fallback,
              CompiledTerm::Load load = CompiledTerm::Load::Plain);
  void zero_target(const Signal& signal, int size);
  void unit_quaternion(int first) const;
  void unit_configuration() const;
  void dense_block(int rows, std::vector<int> columns);
  std::vector<int> all_columns() const;
  static std::vector<int> columns(int first, const std::vector<int>& entries);
  std::vector<int> support_columns(int frame) const;
  int frame(const std::string& name);
  /// Compiles a reference at the start time. If the reference rotates over time or follows a
  /// surface, adds the rotation or the surface to the stage's targets.
  TurningReference turning(const Reference& reference, const CompiledFrame& tool,
                           const CompiledFrame& base);
  /// Compiles `reference` with the frame as its tool and the world as its base.
  FrameView view(int frame, const Reference& reference);
  WrenchView wrench(int contact, const std::optional<Reference>& reference);
  int contact(const std::string& name);
  /// Returns the first target entry of the surface that the residual's reference follows; -1: none.
  int surface() const;

  // Defined in compile_terms.cpp: the parts of a cost or a constraint other than the residual.

  bool is_margin() const;
  void finish_penalty(const CostTerm& cost);
  void finish_weights(const CostTerm& cost);
  void finish_constraint(const Constraint& constraint);
  /// Sets the limits of each row. In messages, `of` precedes a limit's name: "the penalty's ".
  void finish_limits(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                     const std::string& of);
  /// Finds out whether every row is an entry of z that no other row uses. Such rows need no
  /// coefficients.
  void find_entries();
  /// Adds the curvature of a constraint's residual to the stage, if the residual has one.
  void find_curvatures();
};

/// Sets the rows, the target and the Jacobian blocks of the builder's residual.
void compile_residual(TermBuilder& builder);

}  // namespace burnish::ocp
