// Tests of mass distributions: moved, combined, as parameters, and refused.
#include "burnish/model/inertia.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

#include "support/built_robots.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

InertiaSpec random_solid(std::mt19937_64& generator) { return testing::random_inertia(generator); }

/// Point masses, whose inertia follows from the definition.
struct Points {
  std::vector<std::pair<double, Eigen::Vector3d>> masses;
  InertiaSpec inertia() const {
    InertiaSpec result;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (const auto& [m, p] : masses) result.mass += m, moment += m * p;
    result.com = moment / result.mass;
    for (const auto& [m, p] : masses) {
      const Eigen::Vector3d r = p - result.com;
      result.inertia_at_com +=
          m * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
    }
    return result;
  }
};
Points random_points(std::mt19937_64& generator) {
  Points result;
  for (int i = 0; i < 6; ++i)
    result.masses.emplace_back(testing::uniform(generator, 0.1, 1.0),
                               testing::random_vector(generator));
  return result;
}
void expect_same(const InertiaSpec& got, const InertiaSpec& want) {
  EXPECT_NEAR(got.mass, want.mass, 1e-12);
  EXPECT_TRUE(got.com.isApprox(want.com, 1e-12));
  EXPECT_TRUE(got.inertia_at_com.isApprox(want.inertia_at_com, 1e-11));
}

TEST(Inertia, PlacedAndCombined_EqualsPointMasses) {
  std::mt19937_64 generator(3);
  const Points a = random_points(generator), b = random_points(generator);
  const Eigen::Isometry3d placement = testing::random_placement(generator);
  Points both = a;
  for (const auto& [m, p] : b.masses) both.masses.emplace_back(m, placement * p);
  expect_same(together(a.inertia(), placed(b.inertia(), placement)), both.inertia());
  expect_same(together(a.inertia(), {}), a.inertia());
}

TEST(Inertia, Parameters_ConvertBackAndAddUp) {
  std::mt19937_64 generator(4);
  const InertiaSpec solid = random_solid(generator);
  const Vector10 theta = inertia_parameters(solid);
  expect_same(inertia_of(theta), solid);
  // Parameters of combined bodies add up.
  const InertiaSpec other = random_solid(generator);
  EXPECT_TRUE(inertia_parameters(together(solid, other))
                  .isApprox(theta + inertia_parameters(other), 1e-12));
}

TEST(Inertia, ParametersInAnotherFrame_AreALinearMap) {
  std::mt19937_64 generator(6);
  const InertiaSpec solid = random_solid(generator);
  const Eigen::Isometry3d placement = testing::random_placement(generator);
  const Vector10 theta = inertia_parameters(solid);
  EXPECT_TRUE((inertia_transform(placement) * theta)
                  .isApprox(inertia_parameters(placed(solid, placement)), 1e-12));
  EXPECT_TRUE(parameters_of_pseudo_inertia(pseudo_inertia(theta)).isApprox(theta, 1e-13));
  EXPECT_GT(Eigen::Matrix4d(pseudo_inertia(theta)).determinant(), 0.0);
}

TEST(Inertia, UnphysicalInertia_IsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [](double mass, const Eigen::Vector3d& moments) {
    InertiaSpec inertia;
    inertia.mass = mass;
    inertia.inertia_at_com = moments.asDiagonal();
    return inertia;
  };
  InertiaSpec skewed = with(1.0, {1.0, 1.0, 1.0}), far = skewed;
  skewed.inertia_at_com(0, 1) = 0.1;
  far.com[2] = nan;
  const std::vector<std::pair<InertiaSpec, Status>> cases = {
      {with(1.0, {0.1, 0.1, 0.1}), Status::Ok},
      {with(0.0, {0.0, 0.0, 0.0}), Status::Ok},
      {with(2.0, {0.0, 0.0, 0.0}), Status::Ok},
      {with(1.0, {1.0, 1.0, 2.04}), Status::Ok},
      {with(-0.1, {1.0, 1.0, 1.0}), Status::NotFinite},
      {with(nan, {1.0, 1.0, 1.0}), Status::NotFinite},
      {far, Status::NotFinite},
      {skewed, Status::NotPhysical},
      {with(1.0, {1.0, 1.0, 2.2}), Status::NotPhysical},
      {with(1.0, {-0.1, 0.1, 0.1}), Status::NotPhysical},
      {with(0.0, {1.0, 1.0, 1.0}), Status::NotPhysical}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(check_inertia(cases[i].first), cases[i].second);
    EXPECT_EQ(inertia_problem(cases[i].first).empty(), cases[i].second == Status::Ok);
  }
}

TEST(Inertia, Payload_IsAddedToItsBody) {
  const Model model = built_robots().front().model(Base::Fixed);
  std::mt19937_64 generator(5);
  Payload payload{built_robots().front().tool, random_solid(generator)};
  const Model loaded = with_payload(model, payload);
  EXPECT_NEAR(loaded.total_mass(), model.total_mass() + payload.inertia.mass, 1e-12);
  payload.inertia.mass = -1.0;
  EXPECT_THROW(with_payload(model, payload), Error);
  payload.frame = "tooool";
  EXPECT_THROW(with_payload(model, payload), Error);
}

}  // namespace
}  // namespace burnish::test
