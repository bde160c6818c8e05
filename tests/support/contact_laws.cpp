#include "support/contact_laws.hpp"

#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>

#include "base/decomposition.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "burnish/model/state.hpp"
#include "derivatives/constrained_derivatives.hpp"
#include "support/autodiff.hpp"
#include "support/robots.hpp"

namespace burnish::test {

const std::vector<LawRobot>& law_robots() {
  static const std::vector<LawRobot> robots = [] {
    std::vector<LawRobot> result;
    if (has_robot_files)
      result = {{"talos:right_arm", "tool", "torso_2_link"},
                {"talos", "right_sole_link", "left_sole_link", Base::FreeFlyer},
                {"arm7", "tool", "link_1"},
                {"parallel_ankle", "left_ball/second", "left_ball/first"},
                {"crane", "left_tip", "right_tip"}};
    for (const BuiltRobot& built : built_robots())
      result.push_back({built.name, built.tool, built.other_tool, built.usual});
    return result;
  }();
  return robots;
}

const std::vector<std::string>& law_references() {
  static const std::vector<std::string> names{"local",  "centered",  "surface",     "world",
                                              "third",  "elsewhere", "ball",        "barrel",
                                              "saddle", "sliding",   "sliding_ball"};
  return names;
}

const std::vector<Directions>& law_directions() {
  static const std::vector<Directions> sets{Directions::x(),
                                            Directions::y(),
                                            Directions::z(),
                                            Directions::parse("x,y"),
                                            Directions::linear(),
                                            Directions::pad_z(),
                                            Directions::parse("x,y,z,rx,ry"),
                                            Directions::all()};
  return sets;
}

int law_states() {
  const char* text = std::getenv("BURNISH_TEST_STATES");
  const int states = text == nullptr ? BURNISH_TEST_STATES : std::atoi(text);
  return states > 0 ? states : BURNISH_TEST_STATES;
}

namespace {

enum class Gains { None, Split, Log6 };

struct State {
  Eigen::VectorXd q, v, tau;
};

Eigen::VectorXd uniform(int n, double bound, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> draw(-bound, bound);
  Eigen::VectorXd x(n);
  for (double& entry : x) entry = draw(generator);
  return x;
}

State random_state(const Model& model, std::mt19937_64& generator) {
  return {random_configuration(model, generator), uniform(model.nv, 1.0, generator),
          uniform(model.nv, 10.0, generator)};
}

bool may_slide_with_friction(const Directions& directions) {
  return Directions{static_cast<std::uint8_t>(directions.bits & Directions::linear().bits)}
             .count() == 1;
}

Reference reference_of(const std::string& name, const Model& model, const ContactSpec& contact) {
  const Eigen::Matrix3d tilt =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  if (name == "surface" || name == "sliding") return Reference::surface(tilt);
  if (name == "sliding_ball") return reference_of("ball", model, contact);
  if (name == "ball" || name == "barrel" || name == "saddle") {
    const Eigen::Vector3d center(0.2, -0.3, -2.5);
    const Quadric surface = name == "ball"     ? Quadric::sphere(center, 0.3)
                            : name == "barrel" ? Quadric::cylinder(center, {0.3, 1.0, -0.2}, 0.4)
                                               : Quadric::osculating(center, tilt, 0.3, 0.1, -0.2);
    Reference reference = Reference::surface(tilt);
    reference.quadric = surface;
    return reference;
  }
  if (name == "third") return {Anchor::Tool, far_frame(model, {contact.tool, contact.base}), tilt};
  if (name == "elsewhere")
    return {far_frame(model, {contact.tool, contact.base}), Anchor::Base, tilt};
  return Reference::parse(name);
}

ContactSpec contact_of(const Model& model, const LawRobot& robot, const std::string& reference,
                       const Directions& directions, bool two_bodies, Acceleration acceleration,
                       Gains gains) {
  ContactSpec spec;
  spec.name = "contact";
  spec.tool = robot.tool;
  if (two_bodies) spec.base = robot.base;
  spec.reference = reference_of(reference, model, spec);
  spec.directions = directions;
  spec.acceleration = acceleration;
  if (reference.starts_with("sliding")) spec.friction = {0.4, 0.2, 0.03};
  if (gains == Gains::None) return spec;
  spec.error = gains == Gains::Log6 ? PoseError::Log6 : PoseError::Split;
  spec.kp << 90.0, 100.0, 110.0, 80.0, 120.0, 95.0;
  spec.kd << 19.0, 20.0, 21.0, 18.0, 22.0, 17.0;
  spec.target.linear() =
      Eigen::AngleAxisd(0.4, Eigen::Vector3d(0.3, 1.0, -0.2).normalized()).toRotationMatrix();
  spec.target.translation() = Eigen::Vector3d(0.3, -0.2, 0.1);
  return spec;
}

/// The derivative blocks by q, v and tau, with the rows of a above the rows of lambda.
struct Blocks {
  Eigen::MatrixXd dq, dv, dtau;
};

Blocks analytic(ContactDynamics& dynamics) {
  dynamics.forward_derivatives();
  const int n = dynamics.nv(), m = dynamics.rows();
  Blocks blocks{Eigen::MatrixXd(n + m, n), Eigen::MatrixXd(n + m, n), Eigen::MatrixXd(n + m, n)};
  blocks.dq << Eigen::MatrixXd(dynamics.da_dq()), Eigen::MatrixXd(dynamics.dlambda_dq());
  blocks.dv << Eigen::MatrixXd(dynamics.da_dv()), Eigen::MatrixXd(dynamics.dlambda_dv());
  blocks.dtau << Eigen::MatrixXd(dynamics.da_dtau()), Eigen::MatrixXd(dynamics.dlambda_dtau());
  return blocks;
}

Eigen::MatrixXd stacked(const Eigen::MatrixXd& a, const Eigen::MatrixXd& lambda) {
  Eigen::MatrixXd both(a.rows() + lambda.rows(), a.cols());
  both << a, lambda;
  return both;
}

/// Stacks a above lambda.
Duals stacked(const ConstrainedDynamics<Dual>& dynamics) {
  Duals both = dynamics.a;
  both.insert(both.end(), dynamics.lambda.begin(), dynamics.lambda.begin() + dynamics.rows());
  return both;
}

Blocks by_autodiff(const Model& model, ConstrainedDynamics<Dual>& dynamics, const State& state,
                   bool with_tau) {
  const Duals tau = constant_duals(state.tau);
  const ByState by = differentiate(model, state.q, state.v, [&](const Duals& q, const Duals& v) {
    dynamics.set_state(q.data(), v.data());
    dynamics.forward(tau.data());
    return stacked(dynamics);
  });
  Blocks blocks{by.dq, by.dv, {}};
  if (!with_tau) return blocks;
  const auto n = static_cast<int>(state.tau.size());
  const Seeded by_tau{state.tau, Eigen::MatrixXd::Identity(n, n)};
  const Seeded constant{state.v, Eigen::MatrixXd::Zero(n, n)};
  const Duals q = constant_duals(state.q);
  blocks.dtau = differentiate(by_tau, constant, [&](const Duals& at, const Duals& v) {
    dynamics.set_state(q.data(), v.data());
    dynamics.forward(at.data());
    return stacked(dynamics);
  });
  return blocks;
}

/// States for differences of a block: column 2 k is a step ahead along entry k, column 2 k + 1 a
/// step back.
struct SteppedStates {
  SteppedStates(const State& state, int n)
      : q(state.q.replicate(1, 2 * n)),
        v(state.v.replicate(1, 2 * n)),
        tau(state.tau.replicate(1, 2 * n)) {}

  /// Returns d(a, lambda) by central differences with steps `step`.
  Eigen::MatrixXd differences(ContactDynamicsBatch& batch, double step) const {
    batch.forward(q, v, tau);
    const auto n = v.rows();
    Eigen::MatrixXd block(n + batch.rows(), n);
    for (int k = 0; k < static_cast<int>(n); ++k)
      block.col(k) = (stacked(batch.a(2 * k), batch.lambda(2 * k)) -
                      stacked(batch.a(2 * k + 1), batch.lambda(2 * k + 1))) /
                     (2.0 * step);
    return block;
  }

  Eigen::MatrixXd q, v, tau;
};

/// Differences along q and v. The values come from packs, so this checks their values, too.
Blocks by_differences(const Model& model, ContactDynamicsBatch& batch, const State& state,
                      double step) {
  const int n = model.nv;
  SteppedStates in_q(state, n), in_v(state, n);
  for (int k = 0; k < n; ++k)
    for (const int side : {0, 1}) {
      const double ahead = side == 0 ? step : -step;
      in_q.q.col(2 * k + side) =
          integrate(model, state.q, Eigen::VectorXd(ahead * Eigen::VectorXd::Unit(n, k)));
      in_v.v(k, 2 * k + side) += ahead;
    }
  return {in_q.differences(batch, step), in_v.differences(batch, step), Eigen::MatrixXd()};
}

/// a and lambda are linear in tau: a wide step only reduces rounding errors.
Eigen::MatrixXd differences_in_tau(ContactDynamicsBatch& batch, const State& state) {
  const auto n = static_cast<int>(state.tau.size());
  SteppedStates in_tau(state, n);
  for (int k = 0; k < n; ++k) {
    in_tau.tau(k, 2 * k) += 1.0;
    in_tau.tau(k, 2 * k + 1) -= 1.0;
  }
  return in_tau.differences(batch, 1.0);
}

/// Central differences along q and v at two steps, extrapolated to fourth order.
Blocks extrapolated_differences(const Model& model, ContactDynamicsBatch& batch, const State& state,
                                double step) {
  const Blocks wide = by_differences(model, batch, state, step);
  const Blocks narrow = by_differences(model, batch, state, 0.5 * step);
  return {(4.0 * narrow.dq - wide.dq) / 3.0, (4.0 * narrow.dv - wide.dv) / 3.0, Eigen::MatrixXd()};
}

/// Returns the largest difference relative to the largest entry of the block, separately for rows
/// of a and of lambda. `floor_a` is the smallest reference for a block of a that is exactly zero,
/// such as da/dtau of an arm whose contact has as many directions as the arm has joints.
double relative(const Eigen::MatrixXd& got, const Eigen::MatrixXd& want, int n, double floor_a) {
  const auto block_error = [](const auto& g, const auto& w, double floor) {
    if (w.size() == 0) return 0.0;
    const double error = (g - w).cwiseAbs().maxCoeff();
    if (!std::isfinite(error)) return 1e300;
    return error / std::max(w.cwiseAbs().maxCoeff(), floor);
  };
  const auto m = got.rows() - n;
  return std::max(block_error(got.topRows(n), want.topRows(n), floor_a),
                  block_error(got.bottomRows(m), want.bottomRows(m), 1e-12));
}

/// Whether J M^-1 J^T, scaled to a unit diagonal, has an eigenvalue below the bound. Below 1e-4,
/// both sides of the comparison lose the digits that a comparison to 1e-9 needs.
bool near_singular(ContactDynamics& dynamics, double bound = 1e-4) {
  if (dynamics.rows() == 0) return false;
  const Eigen::MatrixXd J = dynamics.jacobian();
  Eigen::MatrixXd G = J * solve_positive(dynamics.mass_matrix(), J.transpose());
  const Eigen::VectorXd scale = G.diagonal().cwiseSqrt().cwiseInverse();
  G = scale.asDiagonal() * G * scale.asDiagonal();
  const double smallest = symmetric_eigen(G).values.minCoeff();
  return !(smallest > bound);
}

/// Propositions 3 and 4 alone: inverse dynamics at constant a and lambda, contact acceleration at
/// constant a. Returns the worst relative error against automatic differentiation.
double propositions_error(const Model& model, ContactDynamics& dynamics,
                          ConstrainedDynamics<Dual>& dual, const State& state) {
  const int n = model.nv;
  const Eigen::VectorXd a = dynamics.a(), lambda = dynamics.lambda();
  const Duals constant_a = constant_duals(a), constant_lambda = constant_duals(lambda);
  const ByState want = differentiate(model, state.q, state.v, [&](const Duals& q, const Duals& v) {
    dual.set_state(q.data(), v.data());
    dual.inverse(constant_a.data(), constant_lambda.data());
    Duals both = dual.tau;
    dual.acceleration(constant_a.data());
    both.insert(both.end(), dual.alpha.begin(), dual.alpha.begin() + dual.rows());
    return both;
  });
  const ByState tau = want.of(0, n), alpha = want.of(n, dual.rows());
  dynamics.inverse(state.q, state.v, a, lambda);
  dynamics.inverse_derivatives();
  const Eigen::MatrixXd none(0, n);
  double worst = relative(stacked(dynamics.dtau_dq(), none), tau.dq, n, 1e-12);
  worst = std::max(worst, relative(stacked(dynamics.dtau_dv(), none), tau.dv, n, 1e-12));
  dynamics.acceleration(state.q, state.v, a);
  dynamics.acceleration_derivatives();
  worst = std::max(worst, relative(dynamics.dalpha_dq(), alpha.dq, 0, 0.0));
  return std::max(worst, relative(dynamics.dalpha_dv(), alpha.dv, 0, 0.0));
}

/// Whether the state is within 0.1 rad of half a turn from the target, where the logarithm of the
/// rotation error jumps, or a surface's normal is about half a turn from the initial axes.
bool is_near_a_cut(const ContactDynamics& dynamics) {
  const CompiledContact& contact = dynamics.contacts().contacts()[0];
  const ContactForce at = dynamics.force(0);
  if (contact.spec.reference.quadric) {
    const Eigen::Vector3d n0 = at.base_rotation * contact.spec.reference.rotation.col(2);
    if (n0.dot(at.axes().col(2)) < -0.95) return true;
  }
  if (!contact.proportional) return false;
  const Eigen::Matrix3d apart =
      (at.base_rotation * contact.spec.target.linear()).transpose() * at.tool_rotation;
  return Eigen::AngleAxisd(apart).angle() > M_PI - 0.1;
}

/// Whether friction is about to jam the sliding tool: both sides then lose digits, as near a
/// singular contact. Friction leaves less than a tenth of the apparent inertia, so the force is
/// more than ten times the force without friction. This adds to the loss at the contact itself.
bool near_jam(const ContactDynamics& dynamics, ContactDynamics* smooth, const State& state,
              bool compliant) {
  if (smooth == nullptr) return false;
  smooth->forward(state.q, state.v, state.tau);
  return !(smooth->lambda()[0] / dynamics.lambda()[0] > 0.1) ||
         (!compliant && near_singular(*smooth, 1e-2));
}

std::string describe_case(const char* against, const char* block, Acceleration acceleration,
                          Gains gains, int state) {
  const char* stabilised = gains == Gains::None    ? "no gains"
                           : gains == Gains::Split ? "split"
                                                   : "log6";
  return std::string(against) + " " + block + ", " + name_of(acceleration) + ", " + stabilised +
         ", state " + std::to_string(state);
}

/// Number of entries of v that move tool against base. A contact with more rows cannot be rigid.
int relative_freedoms(const ContactSet& set) {
  int count = 0;
  for (const ContactSupport& entry : set.contacts()[0].support)
    count += entry.carries_both() ? 0 : 1;
  return count;
}

/// Whether a rigid contact is possible: its rows must not outnumber the relative freedoms, and must
/// not depend on each other in every posture (as about a point through which all shoulder axes
/// pass).
bool can_be_rigid(const Model& model, const ContactSpec& spec, const ContactSet& set) {
  if (relative_freedoms(set) < set.rows()) return false;
  ContactDynamics dynamics(model, {spec});
  std::mt19937_64 generator(7);
  for (int attempt = 0; attempt < 30; ++attempt) {
    const State state = random_state(model, generator);
    dynamics.forward(state.q, state.v, state.tau);
    if (!near_singular(dynamics)) return true;
  }
  return false;
}

void run_case(const Model& model, const ContactSpec& spec, Acceleration acceleration, Gains gains,
              int states, std::mt19937_64& generator, LawRow& row) {
  ContactSolver solver;
  const ContactSet set(model, {spec});
  const bool compliant = !can_be_rigid(model, spec, set);
  if (compliant) solver.mu = 0.05;
  ContactDynamics dynamics(model, {spec}, solver);
  ContactDynamicsBatch batch(model, {spec}, 2 * model.nv, solver);
  ConstrainedDynamics<Dual> dual(model, set, solver);
  std::optional<ContactDynamics> smooth;
  if (spec.friction) {
    ContactSpec sliding = spec;
    sliding.friction.reset();
    smooth.emplace(model, std::vector{sliding}, solver);
  }
  const auto record = [&](const char* against, const char* block, double error, double& worst,
                          int state) {
    if (error <= worst) return;
    worst = error;
    if (error > 1e-9 || row.worst_case.empty())
      row.worst_case = describe_case(against, block, acceleration, gains, state);
  };
  for (int i = 0; i < states; ++i) {
    State state = random_state(model, generator);
    dynamics.forward(state.q, state.v, state.tau);
    while (is_near_a_cut(dynamics) || (!compliant && near_singular(dynamics)) ||
           near_jam(dynamics, smooth ? &*smooth : nullptr, state, compliant)) {
      ++row.resampled;
      state = random_state(model, generator);
      dynamics.forward(state.q, state.v, state.tau);
    }
    const Blocks got = analytic(dynamics);
    const bool thorough = i % 20 == 0;
    const Blocks want = by_autodiff(model, dual, state, thorough);
    const int n = model.nv;
    // Largest entry of da/dtau without the contact.
    const double unconstrained =
        1e-3 * solve_positive(dynamics.mass_matrix(), Eigen::MatrixXd::Identity(n, n)).maxCoeff();
    record("autodiff", "d/dq", relative(got.dq, want.dq, n, 1e-12), row.autodiff, i);
    record("autodiff", "d/dv", relative(got.dv, want.dv, n, 1e-12), row.autodiff, i);
    ++row.states;
    if (i % 5 == 0)
      record("autodiff", "of inverse dynamics or contact acceleration",
             propositions_error(model, dynamics, dual, state), row.autodiff, i);
    if (!thorough) continue;
    record("autodiff", "d/dtau", relative(got.dtau, want.dtau, n, unconstrained), row.autodiff, i);
    double dq = 1e300, dv = 1e300;
    for (const double step : {1e-3, 1e-4, 1e-5}) {
      const Blocks rough = extrapolated_differences(model, batch, state, step);
      dq = std::min(dq, relative(got.dq, rough.dq, n, 1e-12));
      dv = std::min(dv, relative(got.dv, rough.dv, n, 1e-12));
    }
    record("differences", "d/dq", dq, row.differences, i);
    record("differences", "d/dv", dv, row.differences, i);
    record("differences", "d/dtau",
           relative(got.dtau, differences_in_tau(batch, state), n, unconstrained), row.differences,
           i);
  }
}

}  // namespace

std::vector<LawRow> sweep(const LawRobot& robot, const std::string& reference, int states) {
  const Model model = named_robot(robot.name, robot.stands_on);
  std::mt19937_64 generator(20260);
  std::vector<LawRow> rows;
  for (const Directions& directions : law_directions())
    for (const bool two_bodies : {false, true}) {
      if (reference.starts_with("sliding") && !may_slide_with_friction(directions)) continue;
      LawRow row;
      row.directions = directions;
      row.two_bodies = two_bodies;
      for (const Acceleration acceleration :
           {Acceleration::TimeDerivative, Acceleration::Spatial, Acceleration::Classical})
        for (const Gains gains : {Gains::None, Gains::Split, Gains::Log6})
          run_case(model,
                   contact_of(model, robot, reference, directions, two_bodies, acceleration, gains),
                   acceleration, gains, states, generator, row);
      rows.push_back(row);
    }
  return rows;
}

}  // namespace burnish::test
