// A knot's linearised dynamics as an operator, in either form.
#pragma once

#include "burnish/solver/shooting_problem.hpp"

namespace burnish {

/// The largest lead block that the solver's scratch memory holds.
inline constexpr int max_lead_size = 8;

/// The entries of lead blocks of a row over dq times A, or times B where `of_velocity`.
void transform_lead(const StateShape& state, const double* lead, bool of_velocity, double* row);

/// T^T X of SecondOrder dynamics (riccati.hpp): nv rows from X's ndx rows of as many columns, both
/// with `stride`.
void project_rows(const StateShape& state, const KnotExpansion& e, const double* x, int stride,
                  double* out);

/// next = F z. `scratch`: nv entries.
void multiply(const StateShape& state, const KnotExpansion& e, int controls, const double* z,
              double* scratch, double* next);

/// What multiply does once dv' stands in next. SecondOrder.
void complete_next(const StateShape& state, const KnotExpansion& e, int controls, const double* z,
                   double* scratch, double* next);

/// out += F^T w. Spoils w; `scratch`: nv entries and a vector to spare. Writes whole vectors.
void add_transposed(const StateShape& state, const KnotExpansion& e, int controls, double* w,
                    double* scratch, double* out);

}  // namespace burnish
