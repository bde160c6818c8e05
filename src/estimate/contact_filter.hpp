// Right-invariant extended Kalman filter for an inertial measurement unit (IMU) whose robot stands
// on feet. The IMU has a gyroscope and an accelerometer. The filter follows Hartley, Ghaffari,
// Eustice, Grizzle, "Contact-aided invariant extended Kalman filtering for robot state estimation",
// 2020 ("the paper"). This version also handles planar feet (soles). The filter does not use a
// robot model: its inputs are the poses of the feet seen from the IMU.
//
// The state is X = (R, v, p, d_1 ... d_N) in SE_(N+2)(3). R, v and p are the IMU's rotation,
// velocity and position, and d_k is the position of foot k, all in the world. Further states are
// the rotation C_k in SO(3) of each sole and the biases b of both sensors. The error is
// right-invariant: with the true state X and the estimate X^,
//   X = exp(xi) X^,  C_k = exp(xi_Ck) C^_k,  b = b^ + zeta.
// A rotation of the world about the vertical, or a translation of the world, is then one constant
// direction of xi. The measurements contain no information along these directions, and the
// covariance never shrinks along them (section on observability). In an ordinary error-state
// filter, the covariance does shrink along them, because that filter linearizes at each new
// estimate.
//
// The error is propagated over a tick, with phi = (w - b_g) dt and f = a - b_a. The following
// equations were derived for this filter. To first order in dt, they equal the matrix A of the
// paper's section on biases:
//   xi_R' = xi_R                                     - R Gamma_1 dt zeta_g                     (1)
//   xi_v' = xi_v + dt g x xi_R                       + (v' x B_Rg - R D_1 dt^2) zeta_g
//                                                    - R Gamma_1 dt zeta_a                     (2)
//   xi_p' = xi_p + dt xi_v + dt^2/2 g x xi_R         + (p' x B_Rg - R D_2 dt^3) zeta_g
//                                                    - R Gamma_2 dt^2 zeta_a                   (3)
//   xi_dk' = xi_dk                                   + d_k x B_Rg zeta_g                       (4)
//   xi_Ck' = xi_Ck                                                                             (5)
// where B_Rg = -R Gamma_1 dt is the coefficient of zeta_g in (1) and D_m = d(Gamma_m(phi)
// f)/d(phi). Noise of the readings has the same coefficients as the biases. The slip of a foot is
// added to (4) and (5).
//
// The measurement of a foot is its position h and its rotation Q, seen from the IMU. n_h and n_Q
// are the noise of h and Q in the axes of the IMU, with Q = exp(n_Q) R^T C. To first order,
//   R^ h - (d^ - p^)       = xi_d - xi_p + R n_h                                               (6)
//   log(R^ Q C^^T)         = xi_C - xi_R + R n_Q                                               (7)
// A foot that is added at this pose, d^ = p^ + R^ h and C^ = R^ Q, has the errors
//   xi_d = xi_p - R n_h,  xi_C = xi_R - R n_Q.                                                 (8)
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "base/to_size.hpp"
#include "burnish/estimate/imu.hpp"
#include "estimate/strapdown.hpp"

namespace burnish {

/// Pose of a foot seen from the IMU, from joint positions and links.
struct SeenFoot {
  Vec3<double> p;  ///< Position in the axes of the IMU [m].
  Mat3<double> R;  ///< Rotation from the foot's axes to the axes of the IMU.
};

/// Densities of the white noise that the filter assumes, per sqrt(Hz).
struct FilterNoise {
  double gyro = 0.0, accelerometer = 0.0;            ///< Noise of readings [rad/s, m/s^2].
  double gyro_bias = 0.0, accelerometer_bias = 0.0;  ///< Random walk of biases [rad/s^2, m/s^3].
  double slip = 0.0, sole_turn = 0.0;                ///< Slip of standing feet [m/s, rad/s].
};

/// Set of feet: bit k is foot k.
using FootSet = std::uint32_t;
constexpr FootSet foot_bit(int k) { return FootSet{1} << k; }

/// Contact-aided filter of one IMU with a fixed list of feet. Allocates nothing after construction.
class ContactFilter {
 public:
  /// First entry of each part of the error (xi, zeta). The entries of feet come last.
  enum : int { R = 0, v = 3, p = 6, gyro_bias = 9, accelerometer_bias = 12, unit_size = 15 };

  /// `soles`: one entry per foot, nonzero for a planar foot. `gravity`: gravity vector in the world
  /// [m/s^2].
  ContactFilter(const std::vector<char>& soles, const FilterNoise& noise,
                const Eigen::Vector3d& gravity);

  /// Starts the filter without standing feet. `covariance`: covariance of the error (xi, zeta)
  /// without feet, 15 x 15.
  void reset(const InertialState<double>& state, const Eigen::Vector3d& b_gyro,
             const Eigen::Vector3d& b_accelerometer, const Eigen::MatrixXd& covariance) noexcept;

  /// Propagates state and covariance over the last `dt` [s], in which the reading was constant.
  void propagate(const ImuReading& reading, double dt) noexcept;

  /// Corrects the estimate with the poses of the standing feet in `asked`. `seen`: pose of each
  /// foot, seen from the IMU. `noise`: covariance of the noise (n_h, n_Q) of all foot poses, with
  /// seen_size() rows. Rejects each foot k whose own squared innovation exceeds gates[k], and
  /// returns the rejected feet. If an update is numerically impossible, the estimate stays
  /// unchanged and `good` becomes false.
  FootSet update(FootSet asked, const std::vector<SeenFoot>& seen, const Eigen::MatrixXd& noise,
                 const Eigen::VectorXd& gates, bool& good) noexcept;
  /// Adds standing feet at their poses in `seen`.
  void add(FootSet added, const std::vector<SeenFoot>& seen, const Eigen::MatrixXd& noise) noexcept;
  void remove(FootSet feet_to_remove) noexcept;

  /// Adds the variance `deviation`^2 to each component of the IMU's velocity. `deviation`: standard
  /// deviation [m/s].
  void doubt_velocity(double deviation) noexcept;

  const InertialState<double>& state() const { return state_; }
  const Eigen::Vector3d& b_gyro() const { return b_gyro_; }  ///< Bias of the gyroscope [rad/s].
  /// Returns the bias of the accelerometer [m/s^2].
  const Eigen::Vector3d& b_accelerometer() const { return b_accelerometer_; }
  FootSet standing() const { return standing_; }
  /// Returns the position of a standing foot in the world [m].
  const Vec3<double>& foot_position(int k) const { return feet_[index(k)].d; }
  const Mat3<double>& foot_rotation(int k) const { return feet_[index(k)].C; }
  /// Returns the covariance of the error (xi, zeta); zero for feet that do not stand.
  const Eigen::MatrixXd& covariance() const { return P_; }

  int feet() const { return static_cast<int>(feet_.size()); }
  int size() const { return static_cast<int>(P_.rows()); }        ///< Size of (xi, zeta).
  int seen_size() const { return seen_size_; }                    ///< Measurement rows of all feet.
  int rows(int k) const { return feet_[index(k)].sole ? 6 : 3; }  ///< Measurement rows of a foot.
  int first_seen(int k) const { return feet_[index(k)].row; }  ///< First measurement row of a foot.
  /// Returns the index in xi of a foot's first entry. The position d precedes the rotation C.
  int at(int k) const { return feet_[index(k)].at; }

  /// Returns the squared innovation r^T S^-1 r of the last update; innovation_rows() returns its
  /// number of rows.
  double squared_innovation() const { return squared_innovation_; }
  int innovation_rows() const { return innovation_rows_; }
  /// Returns the squared innovation of one foot, computed without the other feet.
  double squared_innovation(int k) const { return feet_[index(k)].squared; }

  /// Returns true if all numbers are finite and no variance is negative.
  bool is_finite() const noexcept;
  /// Saves the estimate for restore().
  void save() noexcept;
  void restore() noexcept;

 private:
  static std::size_t index(int k) { return to_size(k); }
  struct Foot {
    bool sole;
    int at, row;  ///< Index of the foot's first entry in xi, and of its first measurement row.
    Vec3<double> d;
    Mat3<double> C;
    double squared;
  };
  /// Three rows of the measurement matrix H, with +1 at the entry `plus` and -1 at the entry
  /// `minus`. `seen`: index of the first of these rows among the measurement rows of all feet.
  struct Rows {
    int plus, minus, seen;
  };
  void fill_bias_jacobian(const Eigen::Matrix3d& R_before, const Vec3<double>& phi,
                          const RotationSeries<double>& c, const Vec3<double>& f,
                          double dt) noexcept;
  void propagate_rows(Eigen::MatrixXd& P, const Eigen::Matrix3d& g, double dt) const noexcept;
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
  /// Derivative of the propagated error, d(xi')/d(zeta).
  Eigen::Matrix<double, Eigen::Dynamic, 6> B_;
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
