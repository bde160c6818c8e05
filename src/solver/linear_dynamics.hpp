// Linearized dynamics of a knot as an operator, in either form of DynamicsForm.
#pragma once

#include "burnish/solver/shooting_problem.hpp"

namespace burnish {

/// Largest size of a non-Euclidean tangent block that the solver's scratch memory supports.
inline constexpr int max_tangent_size = 8;

/// Multiplies `row`, a row vector over dq, in place by the matrices A of the non-Euclidean tangent
/// blocks, or by their matrices B if `of_velocity`. Only entries inside such blocks change.
void transform_tangent(const StateShape& state, const double* tangent_blocks, bool of_velocity,
                       double* row);

/// Computes T^T X of SecondOrder dynamics (riccati.hpp): nv rows from the ndx rows of X. X and
/// `out` have ndx columns and the row stride `stride`.
void project_rows(const StateShape& state, const KnotExpansion& e, const double* x, int stride,
                  double* out);

/// Computes next = F z. `scratch` needs nv entries.
void multiply(const StateShape& state, const KnotExpansion& e, int controls, const double* z,
              double* scratch, double* next);

/// Completes next = F z: computes all entries except the part dv', which `next` already contains.
/// SecondOrder only.
void complete_next(const StateShape& state, const KnotExpansion& e, int controls, const double* z,
                   double* scratch, double* next);

/// Adds F^T w to `out`, in whole SIMD vectors. Overwrites w. `scratch`: nv entries plus one vector.
void add_transposed(const StateShape& state, const KnotExpansion& e, int controls, double* w,
                    double* scratch, double* out);

}  // namespace burnish
