// Tests of the spatial algebra of motions, forces and inertias, and of Gram products.
#include "math/spatial.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "math/gram.hpp"

namespace burnish {
namespace {

using V = Vec3<double>;
using M6 = Motion<double>;
using F6 = Force<double>;

class SpatialAlgebra : public ::testing::Test {
 protected:
  double draw() { return uniform_(generator_); }
  V vector() { return {draw(), draw(), draw()}; }
  M6 motion() { return {vector(), vector()}; }
  F6 force() { return {vector(), vector()}; }
  Inertia<double> inertia() {
    // Five point masses always make a physical body.
    Inertia<double> I{0.0, V::zero(), {0, 0, 0, 0, 0, 0}};
    for (int i = 0; i < 5; ++i) {
      const V c = vector();
      const double m = 1.0 + draw();
      I += Inertia<double>{
          m,
          c * m,
          {m * (c.y * c.y + c.z * c.z), -m * c.x * c.y, -m * c.x * c.z, m * (c.x * c.x + c.z * c.z),
           -m * c.y * c.z, m * (c.x * c.x + c.y * c.y)}};
    }
    return I;
  }
  std::mt19937_64 generator_{11};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

TEST_F(SpatialAlgebra, MotionAndForceCrossProducts_AreDual) {
  for (int i = 0; i < 20; ++i) {
    const M6 m = motion(), n = motion();
    const F6 f = force();
    EXPECT_NEAR(dot(cross(m, n), f), -dot(n, cross(m, f)), 1e-14);
  }
}

TEST_F(SpatialAlgebra, Power_DoesNotDependOnThePoint) {
  const M6 m = motion();
  const F6 f = force();
  const V p = vector();
  EXPECT_NEAR(dot(at_point(m, p), at_point(f, p)), dot(m, f), 1e-14);
}

TEST_F(SpatialAlgebra, Inertia_IsSymmetricAndPositive) {
  const Inertia<double> I = inertia();
  const M6 m = motion(), n = motion();
  EXPECT_NEAR(dot(m, I * n), dot(n, I * m), 1e-13);
  EXPECT_GT(dot(m, I * m), 0.0);
}

TEST_F(SpatialAlgebra, CoriolisOperator_EqualsItsCrossProductForm) {
  // 2 B(v) u = u x* (I v) + v x* (I u) - I (v x u)
  for (int i = 0; i < 20; ++i) {
    const Inertia<double> I = inertia();
    const M6 v = motion(), u = motion();
    const Coriolis<double> B = coriolis(I, v, (I * v).linear);
    const F6 want = cross(u, I * v) + cross(v, I * u) - I * cross(v, u);
    const F6 got = B * u * 2.0;
    const F6 difference = got - want;
    for (const double x : {difference.linear.x, difference.linear.y, difference.linear.z,
                           difference.angular.x, difference.angular.y, difference.angular.z})
      EXPECT_NEAR(x, 0.0, 1e-12);
    const M6 w = motion();
    EXPECT_NEAR(dot(w, B * u), dot(B.transpose_times_angular(w), u.angular), 1e-12);
  }
}

TEST(GramProduct, AnySizeAndSelectedRows_EqualThePlainSum) {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  const int n = 14, rows = 9;
  std::vector<double> a(rows * n), b(rows * n);
  for (double& x : a) x = draw(generator);
  for (double& x : b) x = draw(generator);
  const std::vector<int> selected{0, 2, 3, 7};
  for (int ni = 0; ni <= n; ++ni)
    for (int nj = 0; nj <= n; ++nj) {
      std::vector<double> c(n * n, 1.0), d(n * n, 1.0), e(n * n, 1.0);
      const StridedView<const double> A{a.data(), n}, B{b.data(), n};
      gram<Gram::Set>(A, B, selected, 0, ni, 0, nj, StridedView<double>{c.data(), n});
      gram<Gram::Add>(A, B, selected, 0, ni, 0, nj, StridedView<double>{d.data(), n});
      gram<Gram::SetNegative>(A, B, selected, 0, ni, 0, nj, StridedView<double>{e.data(), n});
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          double sum = 0.0;
          for (const int k : selected) sum += a[k * n + i] * b[k * n + j];
          const bool inside = i < ni && j < nj;
          EXPECT_NEAR(c[i * n + j], inside ? sum : 1.0, 1e-14);
          EXPECT_NEAR(d[i * n + j], inside ? 1.0 + sum : 1.0, 1e-14);
          EXPECT_NEAR(e[i * n + j], inside ? -sum : 1.0, 1e-14);
        }
    }
}

}  // namespace
}  // namespace burnish
