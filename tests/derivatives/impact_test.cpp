// Inelastic impacts: momentum, contacts at rest, energy, and derivatives of velocity and impulse,
// for several robots, references, and contacts between two moving bodies.
#include <gtest/gtest.h>

#include "derivatives/constrained_derivatives.hpp"
#include "math/pack.hpp"
#include "support/allocation_guard.hpp"
#include "support/autodiff.hpp"
#include "support/contact_states.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

struct Touch {
  std::string tool, base;
  Directions directions = Directions::all();
};

struct ImpactCase {
  std::string name;
  TestRobot robot;
  std::vector<Touch> touches;
};

void PrintTo(const ImpactCase& impact, std::ostream* out) { *out << impact.name; }

std::vector<ImpactCase> impact_cases() {
  const Directions three = Directions::parse("x,z,ry");
  const std::vector<ImpactCase> cases = {
      {humanoid().name + "_on_two_feet",
       humanoid(),
       {{"right_sole_link", "world"}, {"left_sole_link", "world"}}},
      {humanoid().name + "_feet_together", humanoid(), {{"right_sole_link", "left_sole_link"}}},
      {"talos_arm", {"talos:right_arm", Base::Fixed, ""}, {{"tool", "world", Directions::pad_z()}}},
      {"arm7", {"arm7", Base::Fixed, ""}, {{"tool", "world"}}},
      {"arm7_elbow", {"arm7", Base::Fixed, ""}, {{"tool", "link_1", three}}},
      {"arm7_afloat", {"arm7", Base::FreeFlyer, ""}, {{"tool", "world"}}},
      {"crane",
       {"crane", Base::FreeFlyer, ""},
       {{"left_tip", "right_tip", three}, {"right_tip", "world", Directions::linear()}}},
      {"every_joint",
       {"every_joint", Base::Fixed, ""},
       {{"tip", "world"}, {"b_side", "d_side", three}}},
      {"every_joint_afloat", {"every_joint", Base::FreeFlyer, ""}, {{"tip", "b_side"}}},
      {"deep", {"deep", Base::FreeFlyer, ""}, {{"left_5", "world"}, {"right_2", "trunk_2", three}}},
  };
  return available(cases, [](const ImpactCase& impact) { return impact.robot.name; });
}

/// Velocity v+ after the impact, impulse Lambda, and their derivatives.
struct Result {
  Eigen::VectorXd velocity, impulse;
  Eigen::MatrixXd velocity_dq, velocity_dv, impulse_dq, impulse_dv;
};

template <class S>
Eigen::MatrixXd lane_matrix(const std::vector<S>& values, int first_row, int rows, int columns,
                            int lane) {
  Eigen::MatrixXd m(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      m(i, j) =
          Lanes<S>::get(values[static_cast<std::size_t>((first_row + i) * columns + j)], lane);
  return m;
}

template <class S>
Result result_of(const ConstrainedDynamics<S>& dynamics, const ConstrainedDerivatives<S>& by,
                 int lane = 0) {
  const int n = dynamics.nv(), m = dynamics.rows();
  return {lane_matrix(dynamics.velocity_after, 0, n, 1, lane),
          lane_matrix(dynamics.lambda, 0, m, 1, lane),
          lane_matrix(by.d_dq, 0, n, n, lane),
          lane_matrix(by.d_dv, 0, n, n, lane),
          lane_matrix(by.d_dq, n, m, n, lane),
          lane_matrix(by.d_dv, n, m, n, lane)};
}

double difference(const Result& got, const Result& want) {
  return std::max({relative_error(got.velocity, want.velocity),
                   relative_error(got.impulse, want.impulse),
                   relative_error(got.velocity_dq, want.velocity_dq),
                   relative_error(got.velocity_dv, want.velocity_dv),
                   relative_error(got.impulse_dq, want.impulse_dq),
                   relative_error(got.impulse_dv, want.impulse_dv)});
}

Result evaluate(ConstrainedDynamics<double>& dynamics, ConstrainedDerivatives<double>& by,
                const RobotState& at) {
  dynamics.impact(at.q.data(), at.v.data());
  EXPECT_EQ(dynamics.status(), Status::Ok);
  by.impact(dynamics);
  return result_of(dynamics, by);
}

Result by_autodiff(const Model& model, ConstrainedDynamics<Dual>& dynamics, const RobotState& at) {
  const int n = dynamics.nv(), m = dynamics.rows();
  Eigen::VectorXd both;
  const ByState by = differentiate(model, at.q, at.v, [&](const Duals& q, const Duals& v) {
    dynamics.impact(q.data(), v.data());
    Duals result = dynamics.velocity_after;
    result.insert(result.end(), dynamics.lambda.begin(), dynamics.lambda.begin() + m);
    both = values_of(result);
    return result;
  });
  return {both.head(n),     both.tail(m),        by.dq.topRows(n),
          by.dv.topRows(n), by.dq.bottomRows(m), by.dv.bottomRows(m)};
}

Result by_differences(const Model& model, ConstrainedDynamics<double>& dynamics,
                      const RobotState& at, double step) {
  const int n = dynamics.nv(), m = dynamics.rows();
  const auto value = [&](const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
    dynamics.impact(q.data(), v.data());
    Eigen::VectorXd both(n + m);
    for (int i = 0; i < n; ++i) both[i] = dynamics.velocity_after[static_cast<std::size_t>(i)];
    for (int r = 0; r < m; ++r) both[n + r] = dynamics.lambda[static_cast<std::size_t>(r)];
    return both;
  };
  const Eigen::VectorXd here = value(at.q, at.v);
  Eigen::MatrixXd dq(n + m, n), dv(n + m, n);
  for (int k = 0; k < n; ++k) {
    const Eigen::VectorXd e = step * Eigen::VectorXd::Unit(n, k);
    const auto by_q = [&](double s) {
      return Eigen::VectorXd((value(integrate(model, at.q, s * e), at.v) -
                              value(integrate(model, at.q, -s * e), at.v)) /
                             (2.0 * s * step));
    };
    dq.col(k) = (4.0 * by_q(0.5) - by_q(1.0)) / 3.0;
    dv.col(k) = (value(at.q, at.v + e / step) - value(at.q, at.v - e / step)) / 2.0;
  }
  return {here.head(n),  here.tail(m),     dq.topRows(n),
          dv.topRows(n), dq.bottomRows(m), dv.bottomRows(m)};
}

class Impact : public ::testing::TestWithParam<ImpactCase> {
 protected:
  /// Contacts with gains and a distant target, which must not affect an impact.
  std::vector<ContactSpec> specs(const Reference& reference, Acceleration acceleration) const {
    std::vector<ContactSpec> result;
    for (const Touch& touch : GetParam().touches) {
      ContactSpec spec = contact(touch.tool, touch.base, reference, touch.directions, acceleration);
      spec.error = result.empty() ? PoseError::Split : PoseError::Log6;
      spec.with_gains(40.0, 9.0);
      spec.target.translation() = Eigen::Vector3d(0.3, -0.2, 0.5);
      spec.target.linear() = tilt();
      result.push_back(spec);
    }
    return result;
  }
  ContactSet set(const Reference& reference,
                 Acceleration acceleration = Acceleration::TimeDerivative) const {
    return {model, specs(reference, acceleration)};
  }
  RobotState state() {
    ContactDynamics probe(model, specs(Reference::centered(), Acceleration::TimeDerivative));
    return regular_state(model, probe, generator);
  }

  Model model = GetParam().robot.model();
  std::mt19937_64 generator{57};
};

TEST_P(Impact, Velocity_BalancesMomentumStopsContactsAndLosesEnergy) {
  for (const Reference& reference : contact_references()) {
    ConstrainedDynamics<double> dynamics(model, set(reference), {});
    ContactDynamics full(model, specs(reference, Acceleration::TimeDerivative));
    for (int i = 0; i < 5; ++i) {
      const RobotState at = state();
      dynamics.impact(at.q.data(), at.v.data());
      ASSERT_EQ(dynamics.status(), Status::Ok);
      const Eigen::VectorXd after = lane_matrix(dynamics.velocity_after, 0, model.nv, 1, 0);
      const Eigen::VectorXd change = lane_matrix(dynamics.a, 0, model.nv, 1, 0);
      const Eigen::VectorXd impulse = lane_matrix(dynamics.lambda, 0, dynamics.rows(), 1, 0);
      full.acceleration(at.q, at.v, at.v);
      const Eigen::MatrixXd M = full.mass_matrix(), J = full.jacobian();
      EXPECT_LE((after - at.v - change).norm(), 1e-12 * (1.0 + after.norm()));
      EXPECT_LE(relative_error(M * change, J.transpose() * impulse), 1e-10);
      EXPECT_LE((J * after).cwiseAbs().maxCoeff(), 1e-10 * (1.0 + after.norm()) * (1.0 + J.norm()));
      const double before_J = 0.5 * at.v.dot(M * at.v), after_J = 0.5 * after.dot(M * after);
      EXPECT_LT(after_J, before_J);
      EXPECT_NEAR(before_J - after_J, 0.5 * change.dot(M * change), 1e-10 * before_J);
      // A second impact changes nothing.
      const Eigen::VectorXd once = after;
      dynamics.impact(at.q.data(), once.data());
      EXPECT_LE(relative_error(lane_matrix(dynamics.velocity_after, 0, model.nv, 1, 0), once),
                1e-9);
    }
  }
}

TEST_P(Impact, Derivatives_EqualAutodiffAndDifferences) {
  constexpr Acceleration accelerations[] = {Acceleration::TimeDerivative, Acceleration::Spatial,
                                            Acceleration::Classical};
  int i = 0;
  for (const Reference& reference : contact_references()) {
    const ContactSet contacts = set(reference, accelerations[i++ % 3]);
    ConstrainedDynamics<double> dynamics(model, contacts, {});
    ConstrainedDerivatives<double> by(dynamics);
    ConstrainedDynamics<Dual> duals(model, contacts, {});
    for (int k = 0; k < 4; ++k) {
      const RobotState at = state();
      const Result got = evaluate(dynamics, by, at);
      EXPECT_LE(difference(got, by_autodiff(model, duals, at)), 1e-9) << reference.name();
      if (k == 0) {
        EXPECT_LE(difference(got, by_differences(model, dynamics, at, 2e-4)), 1e-6)
            << reference.name();
      }
    }
  }
}

TEST_P(Impact, JointImpulse_ActsLikeMomentumBeforeTheImpact) {
  ConstrainedDynamics<double> dynamics(model, set(Reference::centered()), {});
  ConstrainedDerivatives<double> by(dynamics);
  ContactDynamics full(model);
  const RobotState at = state();
  const Result got = evaluate(dynamics, by, at);
  full.acceleration(at.q, at.v, at.v);
  const int n = model.nv, m = dynamics.rows();
  const Eigen::MatrixXd M = full.mass_matrix();
  EXPECT_LE(relative_error(lane_matrix(by.d_dtau, 0, n, n, 0) * M, got.velocity_dv), 1e-9);
  EXPECT_LE(relative_error(lane_matrix(by.d_dtau, n, m, n, 0) * M, got.impulse_dv), 1e-9);
}

TEST_P(Impact, SomeOrNoActiveContacts_EqualAutodiffOrChangeNothing) {
  const ContactSet contacts = set(Reference::centered());
  ConstrainedDynamics<double> dynamics(model, contacts, {});
  ConstrainedDerivatives<double> by(dynamics);
  ConstrainedDynamics<Dual> duals(model, contacts, {});
  const RobotState at = state();
  const Result all = evaluate(dynamics, by, at);
  dynamics.set_active(0, false);
  duals.set_active(0, false);
  EXPECT_LE(difference(evaluate(dynamics, by, at), by_autodiff(model, duals, at)), 1e-9);
  for (int c = 1; c < contacts.size(); ++c) dynamics.set_active(c, false);
  const Result none = evaluate(dynamics, by, at);
  EXPECT_EQ(none.velocity, at.v);
  EXPECT_EQ(none.velocity_dv, Eigen::MatrixXd::Identity(model.nv, model.nv));
  EXPECT_LE(none.velocity_dq.cwiseAbs().maxCoeff(), 1e-10);
  for (int c = 0; c < contacts.size(); ++c) dynamics.set_active(c, true);
  EXPECT_EQ(difference(evaluate(dynamics, by, at), all), 0.0);
}

TEST_P(Impact, GravityGainsAndReference_DoNotMatter) {
  Model weightless = model;
  weightless.gravity.setZero();
  std::vector<ContactSpec> bare = specs(Reference::centered(), Acceleration::Classical);
  for (ContactSpec& spec : bare) spec.with_gains(0.0, 0.0);
  ConstrainedDynamics<double> dynamics(model, set(Reference::centered()), {});
  ConstrainedDynamics<double> plain(weightless, ContactSet(weightless, bare), {});
  ConstrainedDerivatives<double> by(dynamics), plain_by(plain);
  const RobotState at = state();
  const Result want = evaluate(plain, plain_by, at);
  EXPECT_LE(difference(evaluate(dynamics, by, at), want), 1e-10);
  for (const Touch& touch : GetParam().touches)
    if (touch.directions.count() != 6) return;
  for (const Reference& reference : contact_references()) {
    ConstrainedDynamics<double> other(model, set(reference), {});
    ConstrainedDerivatives<double> other_by(other);
    const Result got = evaluate(other, other_by, at);
    EXPECT_LE(relative_error(got.velocity, want.velocity), 1e-10) << reference.name();
    EXPECT_LE(relative_error(got.velocity_dq, want.velocity_dq), 1e-9) << reference.name();
    EXPECT_LE(relative_error(got.velocity_dv, want.velocity_dv), 1e-10) << reference.name();
  }
}

TEST_P(Impact, PackLanes_EqualSingleStates) {
  using S = NativePack;
  for (const Reference& reference : contact_references()) {
    const ContactSet contacts = set(reference);
    ConstrainedDynamics<S> packed(model, contacts, {});
    ConstrainedDerivatives<S> packed_by(packed);
    ConstrainedDynamics<double> one(model, contacts, {});
    ConstrainedDerivatives<double> one_by(one);
    std::vector<RobotState> lane_states;
    std::vector<S> q(static_cast<std::size_t>(model.nq), S(0.0));
    std::vector<S> v(static_cast<std::size_t>(model.nv), S(0.0));
    for (int l = 0; l < native_lanes; ++l) {
      lane_states.push_back(state());
      for (int i = 0; i < model.nq; ++i)
        Lanes<S>::set(q[static_cast<std::size_t>(i)], l, lane_states.back().q[i]);
      for (int i = 0; i < model.nv; ++i)
        Lanes<S>::set(v[static_cast<std::size_t>(i)], l, lane_states.back().v[i]);
    }
    packed.impact(q.data(), v.data());
    packed_by.impact(packed);
    for (int l = 0; l < native_lanes; ++l) {
      EXPECT_EQ(packed.status(l), Status::Ok);
      const Result want = evaluate(one, one_by, lane_states[static_cast<std::size_t>(l)]);
      EXPECT_LE(difference(result_of(packed, packed_by, l), want), 1e-11) << reference.name();
    }
  }
}

TEST_P(Impact, DuplicatedContacts_MoveAlikeAndTheirImpulsesAddUp) {
  std::vector<ContactSpec> once = specs(Reference::centered(), Acceleration::TimeDerivative);
  std::vector<ContactSpec> twice = once;
  for (ContactSpec spec : once) {
    spec.name += "_again";
    twice.push_back(spec);
  }
  const ContactSet set_twice(model, twice);
  const ContactSolver solver{
      .mu = 1e-6, .max_proximal_iterations = 60, .proximal_tolerance = 1e-12};
  ConstrainedDynamics<double> single(model, ContactSet(model, once), {});
  ConstrainedDynamics<double> exact(model, set_twice, {}), both(model, set_twice, solver);
  ConstrainedDerivatives<double> single_by(single), exact_by(exact), both_by(both);
  const RobotState at = state();
  exact.impact(at.q.data(), at.v.data());
  exact_by.impact(exact);
  EXPECT_EQ(exact.status(), Status::SingularContacts);
  EXPECT_EQ(result_of(exact, exact_by).velocity.norm(), 0.0);
  EXPECT_EQ(result_of(exact, exact_by).velocity_dv.norm(), 0.0);
  const Result want = evaluate(single, single_by, at), got = evaluate(both, both_by, at);
  EXPECT_GT(both.proximal_iterations, 0);
  const auto sum = [&](const Eigen::MatrixXd& x) {
    const Eigen::Index rows = single.rows();
    return Eigen::MatrixXd(x.topRows(rows) + x.bottomRows(rows));
  };
  EXPECT_LE(relative_error(got.velocity, want.velocity), 1e-7);
  EXPECT_LE(relative_error(sum(got.impulse), want.impulse), 1e-7);
  EXPECT_LE(relative_error(got.velocity_dq, want.velocity_dq), 1e-6);
  EXPECT_LE(relative_error(got.velocity_dv, want.velocity_dv), 1e-7);
  EXPECT_LE(relative_error(sum(got.impulse_dq), want.impulse_dq), 1e-6);
  EXPECT_LE(relative_error(sum(got.impulse_dv), want.impulse_dv), 1e-7);
}

TEST_P(Impact, Compliance_YieldsByMuTimesTheImpulse) {
  const ContactSet contacts = set(Reference::world());
  const ContactSolver soft{.mu = 0.05};
  ConstrainedDynamics<double> dynamics(model, contacts, soft);
  ConstrainedDynamics<Dual> duals(model, contacts, soft);
  ConstrainedDerivatives<double> by(dynamics);
  const RobotState at = state();
  const Result got = evaluate(dynamics, by, at);
  ContactDynamics full(model, specs(Reference::world(), Acceleration::TimeDerivative));
  full.acceleration(at.q, at.v, at.v);
  EXPECT_LE((Eigen::MatrixXd(full.jacobian()) * got.velocity + 0.05 * got.impulse).norm(), 1e-9);
  EXPECT_LE(difference(got, by_autodiff(model, duals, at)), 1e-9);
}

TEST_P(Impact, ForwardAfterImpact_StartsAtZeroVelocity) {
  ConstrainedDynamics<double> dynamics(model, set(Reference::centered()), {});
  const RobotState at = state();
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.nv);
  dynamics.impact(at.q.data(), at.v.data());
  dynamics.forward(at.tau.data());
  const std::vector<double> after_impact = dynamics.a;
  dynamics.set_state(at.q.data(), zero.data());
  dynamics.forward(at.tau.data());
  EXPECT_EQ(after_impact, dynamics.a);
}

TEST_P(Impact, Evaluation_AllocatesNothingAndFlagsNan) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  const ContactSolver solver{.mu = 1e-3, .max_proximal_iterations = 5};
  ConstrainedDynamics<double> dynamics(model, set(Reference::centered()), solver);
  ConstrainedDerivatives<double> by(dynamics);
  RobotState at = state();
  const AllocationGuard guard;
  for (const bool active : {true, false, true}) {
    dynamics.set_active(0, active);
    dynamics.impact(at.q.data(), at.v.data());
    by.impact(dynamics);
  }
  at.v[0] = std::numeric_limits<double>::quiet_NaN();
  dynamics.impact(at.q.data(), at.v.data());
  by.impact(dynamics);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(dynamics.status(), Status::NotFinite);
  EXPECT_EQ(result_of(dynamics, by).velocity.norm(), 0.0);
  EXPECT_EQ(result_of(dynamics, by).impulse_dq.norm(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(robots, Impact, ::testing::ValuesIn(impact_cases()),
                         [](const auto& impact) { return impact.param.name; });

}  // namespace
}  // namespace burnish::test
