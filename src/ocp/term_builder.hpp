// A cost or a constraint on its way from what the user states to what the kernels read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "burnish/base/error.hpp"
#include "ocp/compiled_problem.hpp"

namespace burnish::ocp {

/// Knows where it stands for messages.
struct TermBuilder {
  const ProblemSpec& spec;
  const CompiledProblem& problem;
  const Residual& residual;
  CompiledStage& stage;
  CompiledTerm term;
  std::string where;

  [[noreturn]] void refuse(const std::string& what) const { throw Error(where + ": " + what); }

  const StateLayout& layout() const { return problem.layout; }

  // term_builder.cpp: what residuals of several kinds have.

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
  /// As compile_reference makes it of the reference at the start, and where the stage's targets
  /// have the rotation of one that turns.
  TurningReference turning(const Reference& reference, const CompiledFrame& tool,
                           const CompiledFrame& base);
  /// Of a reference whose tool is the frame and whose base is the world.
  FrameView view(int frame, const Reference& reference);
  WrenchView wrench(int contact, const std::optional<Reference>& reference);
  int contact(const std::string& name);

  // compile_terms.cpp: what a cost or a constraint has beside its residual.

  bool is_margin() const;
  void finish_penalty(const CostTerm& cost);
  void finish_weights(const CostTerm& cost);
  void finish_constraint(const Constraint& constraint);
  /// Lower and upper per row; `of` whose they are, for messages.
  void finish_limits(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                     const std::string& of);
  /// Rows that are entries of z each, another than those before: they need no coefficients.
  void find_entries();
  /// Room for the second derivatives that a constraint's residual offers.
  void find_bends();
};

/// Fills in the rows, the target and the columns that the builder's residual has.
void compile_residual(TermBuilder& builder);

}  // namespace burnish::ocp
