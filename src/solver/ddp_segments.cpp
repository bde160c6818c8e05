// The recursion by segments of the horizon, all at the same time.
#include <cmath>

#include "solver/ddp_impl.hpp"

namespace burnish {

void DdpSolver::Impl::check_segments(int segments) const {
  if (segments > 1 && segments >= N)
    throw Error("solver: " + std::to_string(segments) + " segments of a horizon of " +
                std::to_string(N) + (N == 1 ? " knot" : " knots") +
                "; wanted fewer segments than knots");
}

/// Where segments begin, and the end. The last is swept once and the others twice, for the first
/// time at about twice the cost of a knot, but for the first, whose begin nobody waits for. With
/// lengths 1 : 1 : ... : 1 : 2 all take as long in both sweeps.
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
  steps.resize(static_cast<std::size_t>(N));
}

/// A bound makes the part that depends on the end's multiplier piecewise, which no parametric value
/// function says.
bool DdpSolver::Impl::can_be_cut() const {
  if (parts.empty()) return false;
  for (std::size_t k = 0; k < static_cast<std::size_t>(N); ++k)
    if (lower[k] != nullptr && upper[k] != nullptr && controls[k] > 0) return false;
  return true;
}

/// The knots of a segment, from the value function after it; `parametric`: its end is a parameter.
/// The knot that fails, or -1.
int DdpSolver::Impl::sweep_segment(int segment, const ValueStorage& after, bool parametric) {
  const auto j = static_cast<std::size_t>(segment);
  ParametricSegment& part = *parts[j];
  if (parametric) part.start();
  for (int k = borders[j + 1] - 1; k >= borders[j]; --k) {
    const auto i = static_cast<std::size_t>(k);
    const ValueStorage follows = k + 1 == borders[j + 1] ? after : value(k + 1);
    steps[i] = part.recursion().step(expansions[i], controls[i], gap(current, k + 1), follows,
                                     regularization, {}, policy(k), value(k), hessian_gap(k + 1));
    if (steps[i].failed_control >= 0) return k;
    if (parametric) part.extend(expansions[i], controls[i], gap(current, k + 1), policy(k));
  }
  return -1;
}

/// The sweep in segments. `usable` is false where a segment has no solution of its own although the
/// whole may have one: then nothing was decided.
bool DdpSolver::Impl::sweep_segments(bool& usable) {
  const int segments = static_cast<int>(parts.size());
  const int last = segments - 1;
  std::fill(failures.begin(), failures.end(), -1);
  // The last one takes as long as the others together with their ends: it goes first.
  pool->for_each(segments - 1, [&](int /*worker*/, int piece) {
    const int j = last - piece;
    const auto i = static_cast<std::size_t>(j);
    failures[i] =
        j == last ? sweep_segment(j, value(N), false) : sweep_segment(j, parts[i]->nothing(), true);
  });
  usable = true;
  if (failures.back() >= 0) return note_failure(failures.back());
  usable = join_segments();
  if (!usable) return false;
  pool->for_each(segments - 1, [&](int /*worker*/, int j) {
    const auto i = static_cast<std::size_t>(j);
    const ValueStorage after = j + 1 == last ? value(borders[i + 1]) : parts[i + 1]->joined();
    failures[i] = sweep_segment(j, after, false);
  });
  for (int j = last; j >= 0; --j)
    if (failures[static_cast<std::size_t>(j)] >= 0)
      return note_failure(failures[static_cast<std::size_t>(j)]);
  for (int k = N - 1; k >= 0; --k) take_step(k, steps[static_cast<std::size_t>(k)]);
  return true;
}

/// Value functions of the whole where segments begin, from the last to the second.
bool DdpSolver::Impl::join_segments() {
  const int last = static_cast<int>(parts.size()) - 1;
  for (int j = last - 1; j > 0; --j) {
    const auto i = static_cast<std::size_t>(j);
    const ValueStorage following = j + 1 == last ? value(borders[i + 1]) : parts[i + 1]->joined();
    if (failures[i] >= 0 || !parts[i]->join(value(borders[i]), following)) return false;
  }
  return true;
}

bool DdpSolver::Impl::note_failure(int knot) {
  take_step(knot, steps[static_cast<std::size_t>(knot)]);
  return false;
}

}  // namespace burnish
