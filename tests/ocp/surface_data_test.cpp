// Tests of surfaces and friction coefficients as data of each knot: each knot equals that of a
// problem that is built with its surface or coefficient.
#include <gtest/gtest.h>

#include <functional>

#include "support/ocp_cases.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

Quadric surface_at(double time) {
  return Quadric::osculating(Eigen::Vector3d(0.1, 0.2 * time, -0.4), turned_at(0.2 * time),
                             0.3 + time, -0.1, -0.4 * time);
}

ProblemSpec pressed(const OcpCase& test, const Model& model, const Quadric& surface) {
  ProblemSpec spec = bare_problem(test, model);
  for (ContactSpec& contact : spec.contacts) {
    if (contact.name != "pad") continue;
    contact.base = "world";
    contact.reference = Reference::on(surface_at(0.0), {0.3, 0.1, 0.2});
    contact.reference.quadric = surface;
    contact.with_gains(0.0, 5.0);
  }
  Stage go{.name = "go", .contacts = {"brace", "pad"}};
  go.costs = {{.name = "own", .residual = residual::ContactForce{"pad", {}, 1.0}}};
  Stage touch{.name = "touch", .contacts = {"pad"}, .costs = {{.residual = residual::State{}}}};
  touch.impact = true;
  Stage free{.name = "free", .costs = {{.residual = residual::State{}}}};
  spec.stages = {go, touch, free};
  spec.horizon = {{"go", native_lanes + 1}, {"touch", 1}, {"free", 1}};
  return spec;
}

/// Returns the problem of pressed() with a pad that slides with friction and constrains the normal.
ProblemSpec sliding(const OcpCase& test, const Model& model, double coefficient) {
  ProblemSpec spec = pressed(test, model, surface_at(0.0));
  for (ContactSpec& contact : spec.contacts) {
    if (contact.name != "pad") continue;
    contact.directions = Directions::z();
    contact.friction = SlidingFriction{coefficient, 0.1, 0.02};
  }
  return spec;
}

int number_of_pad(const ProblemSpec& spec) {
  const auto named = std::find_if(spec.contacts.begin(), spec.contacts.end(),
                                  [](const ContactSpec& c) { return c.name == "pad"; });
  return static_cast<int>(named - spec.contacts.begin());
}

/// Expects that each of the first `knots` knots (0: all) equals, to the last bit, the knot of the
/// problem that `made` builds for it. Returns the compared horizon.
OcpHorizon expect_same(Problem& problem, const std::function<ProblemSpec(int knot)>& made,
                       int knots = 0) {
  std::mt19937_64 generator(31);
  OcpHorizon horizon(problem, generator);
  horizon.expand(problem);
  for (int k = 0; k < (knots > 0 ? knots : problem.knots()); ++k) {
    SCOPED_TRACE(problem.knot_name(k));
    Problem still(made(k));
    OcpHorizon wanted = horizon;
    for (std::size_t i = 0; i < wanted.out.size(); ++i) wanted.point_at(i);
    wanted.expand(still);
    const auto at = static_cast<std::size_t>(k);
    EXPECT_EQ(horizon.values[at].status, Status::Ok);
    EXPECT_EQ(horizon.values[at].cost, wanted.values[at].cost);
    const int nz = problem.controls(k) + problem.state().ndx, rows = problem.state().nv;
    EXPECT_EQ(horizon.gradient[at].head(nz), wanted.gradient[at].head(nz));
    EXPECT_EQ(horizon.dynamics[at].topLeftCorner(rows, nz),
              wanted.dynamics[at].topLeftCorner(rows, nz));
  }
  return horizon;
}

class KnotData : public ::testing::TestWithParam<OcpCase> {
 protected:
  Model model = GetParam().robot.model();
};

TEST_P(KnotData, SetSurface_EqualsAProblemWithThatSurface) {
  const ProblemSpec spec = pressed(GetParam(), model, surface_at(0.0));
  const int pad = number_of_pad(spec);
  Problem problem(spec);
  for (int k = 0; k <= problem.knots(); ++k)
    ASSERT_EQ(problem.set_surface(k, pad, surface_at(1.0 + k)), Status::Ok);
  const OcpHorizon horizon =
      expect_same(problem, [&](int k) { return pressed(GetParam(), model, surface_at(1.0 + k)); });
  // The data last until the knot is set again.
  problem.set_knot(0, 0, 0.0);
  const Eigen::VectorXd x = horizon.x_of(problem, 0), u = horizon.u_of(problem, 0);
  const Eigen::VectorXd first = problem.forces(0, x, u);
  ASSERT_EQ(problem.set_surface(0, pad, surface_at(0.0)), Status::Ok);
  EXPECT_EQ(problem.forces(0, x, u), first);
  ASSERT_EQ(problem.set_surface(0, pad, surface_at(1.0)), Status::Ok);
  EXPECT_NE(problem.forces(0, x, u), first);
}

TEST_P(KnotData, SetFriction_EqualsAProblemWithThatCoefficient) {
  const ProblemSpec spec = sliding(GetParam(), model, 0.1);
  const int pad = number_of_pad(spec);
  Problem problem(spec);
  for (int k = 0; k <= problem.knots(); ++k)
    ASSERT_EQ(problem.set_friction(k, pad, 0.02 * (1 + k)), Status::Ok);
  const OcpHorizon horizon =
      expect_same(problem, [&](int k) { return sliding(GetParam(), model, 0.02 * (1 + k)); });
  const Eigen::VectorXd x = horizon.x_of(problem, 0), u = horizon.u_of(problem, 0);
  const Eigen::VectorXd first = problem.forces(0, x, u);
  ASSERT_EQ(problem.set_friction(0, pad, 0.6), Status::Ok);
  EXPECT_NE(problem.forces(0, x, u), first);
  EXPECT_EQ(problem.set_friction(0, pad, -1.0), Status::NotFinite);
  testing::expect_words(testing::refusal([&] { problem.set_friction(0, pad == 0 ? 1 : 0, 0.1); }),
                        {"set_friction", "has no friction"});
}

/// The reference of a cost also has its own surface at each knot, in each lane of a pack.
TEST_P(KnotData, SetTermSurface_EqualsAProblemWithThatSurface) {
  const auto over = [&](const Quadric& surface) {
    ProblemSpec spec = pressed(GetParam(), model, surface_at(0.0));
    Reference reference = Reference::on(surface_at(0.0), {0.3, 0.1, 0.2});
    reference.quadric = surface;
    spec.stages[0].costs = {
        {.name = "height", .residual = residual::FrameHeight{"tool", reference}},
        {.name = "incline", .residual = residual::FrameInclination{"tool", reference}},
        {.name = "force", .residual = residual::ContactForce{"pad", reference, 1.0}}};
    return spec;
  };
  Problem problem(over(surface_at(0.0)));
  const int knots = native_lanes + 1;
  for (int k = 0; k < knots; ++k)
    for (int term = 0; term < 3; ++term)
      ASSERT_EQ(problem.set_term_surface(k, term, surface_at(1.0 + k)), Status::Ok);
  const auto made = [&](int k) { return over(surface_at(1.0 + k)); };
  const OcpHorizon horizon = expect_same(problem, made, knots);
  for (int k = 0; k < knots; ++k) {
    Problem still(made(k));
    const Eigen::VectorXd x = horizon.x_of(problem, k), u = horizon.u_of(problem, k);
    for (int term = 0; term < 3; ++term)
      EXPECT_EQ(problem.residual(k, term, x, u), still.residual(k, term, x, u));
  }
  Quadric bad = surface_at(1.0);
  bad.c = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(problem.set_term_surface(0, 0, bad), Status::NotFinite);
  testing::expect_words(testing::refusal([&] {
                          Problem own(pressed(GetParam(), model, surface_at(0.0)));
                          own.set_term_surface(0, 0, surface_at(1.0));
                        }),
                        {"set_term_surface", "'own'", "has no curved surface"});
}

TEST_P(KnotData, SurfaceOfAFlatContact_IsRefused) {
  Problem problem(pressed(GetParam(), model, surface_at(0.0)));
  const auto words = [](auto&& call, const std::vector<std::string>& wanted) {
    testing::expect_words(testing::refusal(call), wanted);
  };
  const Quadric surface = surface_at(1.0);
  words([&] { problem.set_surface(-1, 0, surface); }, {"set_surface", "knot -1"});
  words([&] { problem.set_surface(0, 7, surface); }, {"set_surface", "contact 7 does not exist"});
  int flat = 0;
  while (problem.spec().contacts[static_cast<std::size_t>(flat)].name == "pad") ++flat;
  words([&] { problem.set_surface(0, flat, surface); }, {"has no curved surface", "Reference::on"});
}

INSTANTIATE_TEST_SUITE_P(Robots, KnotData,
                         ::testing::Values(OcpCase{{"arm7", Base::Fixed, "tool"}},
                                           OcpCase{{"arm7", Base::FreeFlyer, "tool"}}),
                         [](const auto& test) { return test.param.label(); });

}  // namespace
}  // namespace burnish::test
