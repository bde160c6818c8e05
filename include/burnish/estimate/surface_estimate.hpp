// Online estimate of the surface under a sliding tool, from the path of the tool. The estimate
// starts from an initial surface.
#pragma once

#include <Eigen/Core>

#include "burnish/dynamics/surface_shape.hpp"

namespace burnish {

/// Settings of the Kalman filter that estimates the surface under a sliding tool from the path of
/// the tool: uncertainty of the initial surface, and noise.
/// @described pressing
struct SurfaceEstimateOptions {
  /// Estimate the surface; if false, the initial surface is used unchanged
  bool enabled = true;
  /// Standard deviation of the initial surface's height [m], > 0
  double height = 0.02;
  /// Standard deviation of the initial normal's tilt about each tangent [rad], > 0
  double tilt = 0.1;
  /// Standard deviation of the initial curvatures [1/m], > 0
  /// @more The filter adds a quarter of the magnitude of the initial curvatures to this value
  double curvature = 0.3;
  /// Random-walk intensity of the curvatures over the travelled distance [1/m/sqrt(m)], > 0
  double curvature_change = 0.5;
  /// Standard deviation of position noise that is correlated along the path [m], > 0
  /// @more The noise is along the surface normal. The filter itself estimates the additional noise
  /// that is uncorrelated from tick to tick
  double position_noise = 3e-5;
  /// Correlation length of position noise, such as the tip motion per encoder step [m], > 0
  double noise_length = 1e-4;
  /// Standard deviation of the force along the normal [N], > 0
  double force_noise = 0.3;
  /// Standard deviation of the initial compliance of the surface under the tip [m/N], > 0
  /// @more The initial compliance is 0
  double compliance = 1e-3;
  /// Standard deviation of the surface's velocity along its normal (0: surface at rest) [m/s], >= 0
  /// @more A moving surface can be distinguished from a slope only after the tip has changed
  /// direction
  double rate = 0.0;
};

/// Kalman filter that corrects an initial surface from the path of a tip that touches the surface.
/// States are the errors h, s and K of the initial surface's height, slope and curvature, and the
/// compliance c. The measurement equation is
///   phi = h + s . t + t . K t / 2 - c f,
/// where phi is the distance of the tip from the initial surface, negative inside the material. t
/// is the tip's displacement along the tangents and f the force along the normal. If the surface
/// may move, h changes at the rate r. While the tip travels, state and covariance are predicted
/// over the travelled distance. Slope and curvature at the tip are extrapolated to the surface
/// ahead of the tip.
class SurfaceEstimator {
 public:
  /// `nominal`: initial surface. `tip_radius`: radius of the tip [m]. `tick_period`: time between
  /// updates [s]. Throws Error if an option is out of range.
  SurfaceEstimator(Surface nominal, double tip_radius, const SurfaceEstimateOptions& options,
                   double tick_period);

  void reset() noexcept;
  /// Processes one tick. `p`: position of the tip's centre [m]. `force`: normal force of the
  /// surface on the tip [N]. If `touches` is false, the estimate is not updated, only evaluated at
  /// `p`. Does not allocate.
  void update(const Eigen::Vector3d& p, double force, bool touches) noexcept;

  /// Returns the estimated surface as a quadratic function of the position of the tip's centre. The
  /// function is zero where the tip touches without load. The function is valid near the position
  /// at the last tick.
  const Quadric& surface() const { return surface_; }
  /// Returns the estimated surface normal at the tip, a unit vector.
  const Eigen::Vector3d& normal() const { return normal_; }
  /// Returns the largest standard deviation, over all tangents, of the estimated normal's tilt
  /// about a tangent [rad].
  double normal_deviation() const;
  /// Returns the estimated compliance [m/N].
  double compliance() const { return x_[c_]; }
  /// Returns the estimated velocity of the surface along its normal [m/s].
  double rate() const { return x_[r_]; }

 private:
  static constexpr int n_ = 8;  ///< States: h, s (2), K (uu, uw, ww), c, r
  static constexpr int h_ = 0, s_ = 1, k_ = 3, c_ = 6, r_ = 7;
  using State = Eigen::Matrix<double, n_, 1>;
  using Covariance = Eigen::Matrix<double, n_, n_>;

  void learn() noexcept;
  void follow_noise(const Eigen::Vector3d& p) noexcept;
  void start(const Eigen::Vector3d& p, const SurfaceDistance& nominal) noexcept;
  void wait(double dt) noexcept;
  void move_to(const Eigen::Vector3d& p, const Eigen::Vector2d& d,
               const SurfaceDistance& nominal) noexcept;
  void measure(double distance, double force, double travel) noexcept;
  void begin_anew() noexcept;
  void recover(double travel) noexcept;
  void update_estimate(const Eigen::Vector3d& p) noexcept;

  Surface nominal_;
  double radius_;
  SurfaceEstimateOptions options_;
  /// Number of ticks averaged into one measurement
  int window_;
  /// Time between ticks [s]
  double tick_period_;
  /// Time since the last measurement [s]
  double time_ = 0.0;
  /// Weight of one tick in the running means white_ and spread_
  double noise_share_;
  /// Variance of tick-to-tick position noise along the normal [m^2]
  double white_ = 0.0;
  /// Variance of tick-to-tick position noise, sum of all directions [m^2]
  double spread_ = 0.0;
  /// Number of ticks so far, at most 2^20
  int seen_ = 0;
  /// Tip positions at the last two ticks [m]
  Eigen::Vector3d before_, before_that_;
  /// Tangents t_u, t_w and normal of the initial surface at the position place_, as columns
  Eigen::Matrix3d tangents_;
  State x_;
  Covariance P_;
  /// Tip positions [m]: place_ is the position to which the state x_ refers, last_ is the mean of
  /// the last window, and sum_p_ is the sum over the current window
  Eigen::Vector3d place_, last_, sum_p_;
  double sum_f_ = 0.0;
  int ticks_ = 0;
  bool placed_ = false;
  /// Factor on the initial standard deviations of slope and curvature, at most 1
  double trust_ = 1.0;
  /// Standard deviation of the curvatures when contact begins [1/m]
  double curvature_ = 0.0;
  Quadric surface_;
  Eigen::Vector3d normal_;
};

}  // namespace burnish
