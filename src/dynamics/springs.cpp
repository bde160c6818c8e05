#include "dynamics/springs.tpp"

#include <cmath>
#include <map>
#include <utility>

#include "math/pack.hpp"

namespace burnish {
namespace {

/// Accumulator of the terms of all springs and dampers in the linear law.
struct Sum {
  std::map<std::pair<int, int>, Springs::Linear> entries;
  std::map<int, Springs::Pull> pulls;
  double energy_at_zero = 0.0;

  void add(const Tendon& tendon) {
    energy_at_zero += 0.5 * tendon.stiffness * tendon.rest * tendon.rest;
    for (const Tendon::Entry& a : tendon.parts) {
      if (tendon.stiffness * tendon.rest != 0.0) {
        Springs::Pull& pull = pulls.try_emplace(a.v, Springs::Pull{a.v, a.q, 0.0}).first->second;
        pull.torque += tendon.stiffness * tendon.rest * a.coefficient;
      }
      for (const Tendon::Entry& b : tendon.parts) {
        Springs::Linear& entry =
            entries.try_emplace({a.v, b.v}, Springs::Linear{a.v, b.v, a.q, b.q, 0.0, 0.0})
                .first->second;
        entry.by_q -= tendon.stiffness * a.coefficient * b.coefficient;
        entry.by_v -= tendon.damping * a.coefficient * b.coefficient;
      }
    }
  }
};

}  // namespace

Springs::Springs(const Model& model) {
  Sum sum;
  for (const Joint& joint : model.joints) {
    if (joint.follows || model.stiffness.segment(joint.v_index, joint.nv).isZero(0.0)) continue;
    const int q = joint.q_index, v = joint.v_index;
    const double stiffness = model.stiffness[v], rest = model.spring_rest[v];
    if (joint.kind == JointKind::Ball)
      balls.push_back({v, q, stiffness});
    else if (joint.kind == JointKind::Continuous)
      circles.push_back({v, q, stiffness, std::cos(rest), std::sin(rest)});
    else
      sum.add({"", {{q, v, 1.0}}, rest, stiffness, 0.0});
  }
  for (const Tendon& tendon : model.tendons) sum.add(tendon);
  energy_at_zero = sum.energy_at_zero;
  for (const auto& [row, pull] : sum.pulls) pulls.push_back(pull);
  for (const auto& [at, entry] : sum.entries) linear.push_back(entry);
  for (const Linear& entry : linear) places.push_back({entry.row, entry.column, entry.by_v});
  for (const Circle& circle : circles) places.push_back({circle.row, circle.row, 0.0});
  for (const Ball& ball : balls)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) places.push_back({ball.row + i, ball.row + j, 0.0});
}

template void add_spring_torque(const Springs&, const double*, const double*, double*);
template void add_spring_torque(const Springs&, const NativePack*, const NativePack*, NativePack*);
template void spring_slopes(const Springs&, const double*, double*);
template void spring_slopes(const Springs&, const NativePack*, NativePack*);
template double spring_energy(const Springs&, const double*);

}  // namespace burnish
