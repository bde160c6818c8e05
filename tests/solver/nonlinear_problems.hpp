// Two small nonlinear problems with hand-written derivatives. Their functions do not allocate.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "solver/test_problem.hpp"

namespace burnish::testing {

/// Swing-up of a pendulum of unit mass and length by a torque u; angle 0 hangs down. Semi-implicit
/// Euler steps.
inline TestProblem pendulum_swing_up(int knots = 60, double step = 0.05,
                                     double torque_cost = 1e-2) {
  TestProblem p;
  p.shape = {.nx = 2, .ndx = 2, .nv = 1, .filtered = 0, .blocks = {}};
  constexpr double gravity = 9.81;
  constexpr double damping = 0.1;
  for (int k = 0; k < knots; ++k)
    p.stages.push_back({1,
                        [=](const double* x, const double* u, double* next) {
                          if (next != nullptr) {
                            const double a = u[0] - gravity * std::sin(x[0]) - damping * x[1];
                            next[1] = x[1] + step * a;
                            next[0] = x[0] + step * next[1];
                          }
                          return 0.5 * step * (torque_cost * u[0] * u[0] + 1e-2 * x[1] * x[1]);
                        },
                        [=](const double* x, const double* u, KnotExpansion& e) {
                          e.form = DynamicsForm::SecondOrder;
                          e.step = step;
                          e.dynamics[0] = step;
                          e.dynamics[1] = -step * gravity * std::cos(x[0]);
                          e.dynamics[2] = 1.0 - step * damping;
                          for (int i = 0; i < 3; ++i)
                            for (int j = 0; j <= i; ++j) e.hessian[i * e.stride + j] = 0.0;
                          e.gradient[0] = step * torque_cost * u[0];
                          e.gradient[1] = 0.0;
                          e.gradient[2] = step * 1e-2 * x[1];
                          e.hessian[0] = step * torque_cost;
                          e.hessian[2 * e.stride + 2] = step * 1e-2;
                        }});
  p.stages.push_back({0,
                      [](const double* x, const double*, double*) {
                        const double angle = x[0] - std::numbers::pi;
                        return 50.0 * angle * angle + 5.0 * x[1] * x[1];
                      },
                      [](const double* x, const double*, KnotExpansion& e) {
                        e.gradient[0] = 100.0 * (x[0] - std::numbers::pi);
                        e.gradient[1] = 10.0 * x[1];
                        e.hessian[0] = 100.0;
                        e.hessian[e.stride] = 0.0;
                        e.hessian[e.stride + 1] = 10.0;
                      }});
  p.start = {0.0, 0.0};
  p.close();
  return p;
}

/// Unicycle (x, y, heading), driven by (speed, turn rate) to the origin.
inline TestProblem unicycle(int knots = 40, double step = 0.1) {
  TestProblem p;
  p.shape = {.nx = 3, .ndx = 3, .nv = 0, .filtered = 0, .blocks = {}};
  const auto cost = [](const double* x, double weight) {
    return 0.5 * weight * (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  };
  for (int k = 0; k < knots; ++k)
    p.stages.push_back({2,
                        [=](const double* x, const double* u, double* next) {
                          if (next != nullptr) {
                            next[0] = x[0] + step * u[0] * std::cos(x[2]);
                            next[1] = x[1] + step * u[0] * std::sin(x[2]);
                            next[2] = x[2] + step * u[1];
                          }
                          return cost(x, step) + 0.25 * step * (u[0] * u[0] + u[1] * u[1]);
                        },
                        [=](const double* x, const double* u, KnotExpansion& e) {
                          e.form = DynamicsForm::Dense;
                          const double c = std::cos(x[2]);
                          const double s = std::sin(x[2]);
                          const std::array<double, 15> f = {
                              step * c, 0.0,  1.0, 0.0, -step * u[0] * s,  //
                              step * s, 0.0,  0.0, 1.0, step * u[0] * c,   //
                              0.0,      step, 0.0, 0.0, 1.0};
                          for (int i = 0; i < 3; ++i)
                            std::copy_n(f.data() + 5 * i, 5, e.dynamics + i * e.stride);
                          for (int i = 0; i < 5; ++i) {
                            for (int j = 0; j < i; ++j) e.hessian[i * e.stride + j] = 0.0;
                            e.hessian[i * e.stride + i] = (i < 2 ? 0.5 : 1.0) * step;
                            e.gradient[i] = i < 2 ? 0.5 * step * u[i] : step * x[i - 2];
                          }
                        }});
  p.stages.push_back({0, [=](const double* x, const double*, double*) { return cost(x, 10.0); },
                      [](const double* x, const double*, KnotExpansion& e) {
                        for (int i = 0; i < 3; ++i) {
                          for (int j = 0; j < i; ++j) e.hessian[i * e.stride + j] = 0.0;
                          e.hessian[i * e.stride + i] = 10.0;
                          e.gradient[i] = 10.0 * x[i];
                        }
                      }});
  p.start = {-1.0, -1.0, 1.0};
  p.close();
  return p;
}

/// Sets the same bounds on every control of every knot.
inline void set_bounds(TestProblem& p, double lower, double upper) {
  const std::vector<double> low(static_cast<std::size_t>(p.max_nu), lower);
  const std::vector<double> high(low.size(), upper);
  p.lower.assign(p.stages.size(), low);
  p.upper.assign(p.stages.size(), high);
}

}  // namespace burnish::testing
