// The right-invariant extended Kalman filter of a unit with a gyroscope and an accelerometer whose
// robot stands on feet (Hartley, Ghaffari, Eustice, Grizzle, "Contact-aided invariant extended
// Kalman filtering for robot state estimation", 2020), extended to soles. It knows no robot: feet
// come as places seen from the unit.
//
// The state is X = (R, v, p, d_1 ... d_N) of SE_(N+2)(3): the unit's rotation, velocity and
// position, and the feet's positions, all in the world; the rotations C_k of feet that are soles,
// each in SO(3); and the biases b of both sensors. The error is right-invariant: with the truth X
// and the estimate X^,
//   X = exp(xi) X^,  C_k = exp(xi_Ck) C^_k,  b = b^ + zeta,
// so that rotating the world about the vertical and moving it is one constant direction of xi, in
// which the filter learns nothing (section on observability): its covariance never shrinks there,
// which that of an error-state filter does where it linearises anew at each estimate.
//
// Over a tick, with phi = (w - b_g) dt and f = a - b_a (own derivation; to first order in dt it is
// A of the paper's section on biases):
//   xi_R' = xi_R                                     - R Gamma_1 dt zeta_g                     (1)
//   xi_v' = xi_v + dt g x xi_R                       + (v' x B_Rg - R D_1 dt^2) zeta_g
//                                                    - R Gamma_1 dt zeta_a                     (2)
//   xi_p' = xi_p + dt xi_v + dt^2/2 g x xi_R         + (p' x B_Rg - R D_2 dt^3) zeta_g
//                                                    - R Gamma_2 dt^2 zeta_a                   (3)
//   xi_dk' = xi_dk                                   + d_k x B_Rg zeta_g                       (4)
//   xi_Ck' = xi_Ck                                                                             (5)
// B_Rg = -R Gamma_1 dt being (1)'s factor of zeta_g and D_m = d(Gamma_m(phi) f)/d(phi). The noise
// of readings enters as biases do, and a foot's slip adds to (4) and (5).
//
// A foot seen at h, with the rotation Q, from the unit (noise n_h, n_Q in the unit's axes; Q =
// exp(n_Q) R^T C) gives, to first order,
//   R^ h - (d^ - p^)       = xi_d - xi_p + R n_h                                               (6)
//   log(R^ Q C^^T)         = xi_C - xi_R + R n_Q                                               (7)
// and a foot that is put down there, d^ = p^ + R^ h and C^ = R^ Q, has the errors
//   xi_d = xi_p - R n_h,  xi_C = xi_R - R n_Q.                                                 (8)
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "burnish/estimate/imu.hpp"
#include "estimate/strapdown.hpp"

namespace burnish {

/// A foot as joints and links say it is, seen from the unit.
struct SeenFoot {
  Vec3<double> p;  ///< m, in the unit's axes
  Mat3<double> R;  ///< foot -> unit
};

/// Densities of white noise, per square root of Hz.
struct FilterNoise {
  double gyro = 0.0, accelerometer = 0.0;            ///< rad/s, m/s^2
  double gyro_bias = 0.0, accelerometer_bias = 0.0;  ///< rad/s^2, m/s^3
  double slip = 0.0, sole_turn = 0.0;                ///< m/s, rad/s
};

/// Sets of feet: bit k is foot k.
using FootSet = std::uint32_t;
constexpr FootSet foot_bit(int k) { return FootSet{1} << k; }

/// Allocates nothing after construction.
class ContactFilter {
 public:
  /// First entries of xi; those of feet follow.
  enum : int { R = 0, v = 3, p = 6, gyro_bias = 9, accelerometer_bias = 12, unit_size = 15 };

  /// Per foot, whether it is a sole; gravity in the world, m/s^2.
  ContactFilter(const std::vector<char>& soles, const FilterNoise& noise,
                const Eigen::Vector3d& gravity);

  /// No foot stands. `covariance` (15 x 15) of xi and zeta without feet.
  void reset(const InertialState<double>& state, const Eigen::Vector3d& b_gyro,
             const Eigen::Vector3d& b_accelerometer, const Eigen::MatrixXd& covariance) noexcept;

  void propagate(const ImuReading& reading, double dt) noexcept;

  /// What feet that stand say by where they are seen. `seen` has an entry for each foot of the
  /// filter, `noise` is the covariance of (n_h, n_Q) of all of them, seen_size() rows. Feet whose
  /// own innovation, squared, is beyond gates[k] are left out: it returns them. `good` is false
  /// where the numbers do not allow an update, which then changes nothing.
  FootSet update(FootSet asked, const std::vector<SeenFoot>& seen, const Eigen::MatrixXd& noise,
                 const Eigen::VectorXd& gates, bool& good) noexcept;
  /// Puts feet down where they are seen.
  void add(FootSet added, const std::vector<SeenFoot>& seen, const Eigen::MatrixXd& noise) noexcept;
  void remove(FootSet feet_to_remove) noexcept;

  /// The unit's velocity is known that much less, m/s.
  void doubt_velocity(double deviation) noexcept;

  const InertialState<double>& state() const { return state_; }
  const Eigen::Vector3d& b_gyro() const { return b_gyro_; }                    ///< rad/s
  const Eigen::Vector3d& b_accelerometer() const { return b_accelerometer_; }  ///< m/s^2
  FootSet standing() const { return standing_; }
  const Vec3<double>& foot_position(int k) const { return feet_[index(k)].d; }  ///< world, m
  const Mat3<double>& foot_rotation(int k) const { return feet_[index(k)].C; }
  /// Of all of xi and zeta; zero for feet that do not stand.
  const Eigen::MatrixXd& covariance() const { return P_; }

  int feet() const { return static_cast<int>(feet_.size()); }
  int size() const { return static_cast<int>(P_.rows()); }        ///< of xi and zeta
  int seen_size() const { return seen_size_; }                    ///< rows of all feet
  int rows(int k) const { return feet_[index(k)].sole ? 6 : 3; }  ///< that a foot is seen with
  int first_seen(int k) const { return feet_[index(k)].row; }     ///< of them
  /// First entry of a foot in xi: of d, then of C.
  int at(int k) const { return feet_[index(k)].at; }

  /// Of the last update: r^T S^-1 r of all rows together, and how many there were.
  double squared_innovation() const { return squared_innovation_; }
  int innovation_rows() const { return innovation_rows_; }
  double squared_innovation(int k) const { return feet_[index(k)].squared; }  ///< of a foot alone

  /// All numbers are some, and no variance is negative.
  bool is_finite() const noexcept;
  /// Keeps the estimate to go back to.
  void save() noexcept;
  void restore() noexcept;

 private:
  static std::size_t index(int k) { return static_cast<std::size_t>(k); }
  struct Foot {
    bool sole;
    int at, row;  ///< first entries in xi, and in what is seen
    Vec3<double> d;
    Mat3<double> C;
    double squared;
  };
  /// Three rows of H: +1 at `plus`, -1 at `minus`, and where they stand in what is seen.
  struct Rows {
    int plus, minus, seen;
  };
  void fill_bias_factors(const Eigen::Matrix3d& R_before, const Vec3<double>& phi,
                         const RotationSeries<double>& c, const Vec3<double>& f,
                         double dt) noexcept;
  void carry_rows(Eigen::MatrixXd& P, const Eigen::Matrix3d& g, double dt) const noexcept;
  void innovate(int k, const SeenFoot& seen, int row) noexcept;
  Eigen::Matrix3d between(int a, int b, int c, int d) const noexcept;
  double squared_alone(int k) const noexcept;
  bool correct_by_chosen() noexcept;
  void correct() noexcept;

  FilterNoise noise_;
  Vec3<double> gravity_;
  InertialState<double> state_;
  Eigen::Vector3d b_gyro_ = Eigen::Vector3d::Zero(), b_accelerometer_ = Eigen::Vector3d::Zero();
  std::vector<Foot> feet_;
  FootSet standing_ = 0;
  int seen_size_ = 0;
  Eigen::MatrixXd P_;
  Eigen::Matrix<double, Eigen::Dynamic, 6> B_;  ///< d(xi')/d(zeta)
  Eigen::VectorXd r_, change_;
  Eigen::MatrixXd AP_, PHt_, APHt_, K_, S_, N_, turned_;
  std::vector<Rows> chosen_;
  double squared_innovation_ = 0.0;
  int innovation_rows_ = 0;
  InertialState<double> saved_state_;
  Eigen::Vector3d saved_b_gyro_, saved_b_accelerometer_;
  std::vector<Foot> saved_feet_;
  FootSet saved_standing_ = 0;
  Eigen::MatrixXd saved_P_;
};

}  // namespace burnish
