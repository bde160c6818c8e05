// Riccati recursion over segments of the horizon in parallel.
#include <cmath>

#include "base/to_size.hpp"
#include "solver/ddp_impl.hpp"

namespace burnish {

void DdpSolver::Impl::check_segments(int segments) const {
  if (segments > 1 && segments >= N)
    throw Error("solver: " + std::to_string(segments) + " segments are too many for a horizon of " +
                std::to_string(N) + (N == 1 ? " knot" : " knots") +
                "; wanted fewer segments than knots");
}

/// Computes the first knot of each segment. The first sweep omits the first segment, and the second
/// sweep omits the last one. A knot costs about twice as much in the first sweep as in the second,
/// except in the last segment, whose end is not a parameter. With lengths 1 : 1 : ... : 1 : 2, all
/// threads take about equally long in each sweep.
void DdpSolver::Impl::cut_horizon(int segments) {
  if (segments == static_cast<int>(parts.size()) || (segments < 3 && parts.empty())) return;
  parts.clear();
  borders.clear();
  if (segments < 3) return;
  for (int j = 0; j < segments; ++j) {
    parts.push_back(std::make_unique<ParametricSegment>(state, nu_max));
    borders.push_back(N * j / (segments + 1));
  }
  borders.push_back(N);
  failures.resize(parts.size());
  steps.resize(to_size(N));
}

/// Returns whether the recursion can run in segments. With bounds, the solution of a segment is a
/// piecewise linear function of the multiplier at the segment's end. A parametric value function
/// cannot represent this.
bool DdpSolver::Impl::can_be_cut() const {
  if (parts.empty()) return false;
  for (std::size_t k = 0; k < to_size(N); ++k)
    if (lower[k] != nullptr && upper[k] != nullptr && controls[k] > 0) return false;
  return true;
}

/// Sweeps the knots of a segment backwards from the value function `after` at its end. With
/// `parametric`, the multiplier at the end is a parameter. Returns the knot that failed, or -1.
int DdpSolver::Impl::sweep_segment(int segment, const ValueStorage& after, bool parametric) {
  const auto j = to_size(segment);
  ParametricSegment& part = *parts[j];
  if (parametric) part.start();
  for (int k = borders[j + 1] - 1; k >= borders[j]; --k) {
    const auto i = to_size(k);
    const ValueStorage follows = k + 1 == borders[j + 1] ? after : value(k + 1);
    steps[i] = part.recursion().step({expansions[i], controls[i], gap(current, k + 1), follows,
                                      policy(k), value(k), hessian_gap(k + 1)},
                                     {.regularization = regularization});
    if (steps[i].failed_control >= 0) return k;
    if (parametric) part.extend(expansions[i], controls[i], gap(current, k + 1), policy(k));
  }
  return -1;
}

/// Sweeps all segments. `usable` is false if a segment alone has no solution although the whole
/// horizon may have one; the sweep then has no result.
bool DdpSolver::Impl::sweep_segments(bool& usable) {
  const int segments = static_cast<int>(parts.size());
  const int last = segments - 1;
  std::fill(failures.begin(), failures.end(), -1);
  // First sweep: the last segment, and the segments 1 to last - 1, whose ends are parameters.
  pool->for_each(segments - 1, [&](int /*worker*/, int piece) {
    const int j = last - piece;
    const auto i = to_size(j);
    failures[i] =
        j == last ? sweep_segment(j, value(N), false) : sweep_segment(j, parts[i]->nothing(), true);
  });
  usable = true;
  if (failures.back() >= 0) return note_failure(failures.back());
  usable = join_segments();
  if (!usable) return false;
  pool->for_each(segments - 1, [&](int /*worker*/, int j) {
    const auto i = to_size(j);
    const ValueStorage after = j + 1 == last ? value(borders[i + 1]) : parts[i + 1]->joined();
    failures[i] = sweep_segment(j, after, false);
  });
  for (int j = last; j >= 0; --j)
    if (failures[to_size(j)] >= 0) return note_failure(failures[to_size(j)]);
  for (int k = N - 1; k >= 0; --k) take_step(k, steps[to_size(k)]);
  return true;
}

/// Computes the value functions at the starts of segments, from the last segment to the second.
bool DdpSolver::Impl::join_segments() {
  const int last = static_cast<int>(parts.size()) - 1;
  for (int j = last - 1; j > 0; --j) {
    const auto i = to_size(j);
    const ValueStorage following = j + 1 == last ? value(borders[i + 1]) : parts[i + 1]->joined();
    if (failures[i] >= 0 || !parts[i]->join(value(borders[i]), following)) return false;
  }
  return true;
}

bool DdpSolver::Impl::note_failure(int knot) {
  take_step(knot, steps[to_size(knot)]);
  return false;
}

}  // namespace burnish
