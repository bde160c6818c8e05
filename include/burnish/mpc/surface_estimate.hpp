// The surface under a sliding tool, estimated from the tool's own path: what is known of it stays
// as believed where the tool has not been.
#pragma once

#include <Eigen/Core>

#include "burnish/dynamics/surface_shape.hpp"

namespace burnish {

/// How the surface under a sliding tool is estimated from the tool's own path: deviations of what
/// is believed at first, and of what is measured.
/// @described pressing
struct SurfaceEstimateOptions {
  bool enabled = true;     ///< estimate it; else what is believed is what is known
  double height = 0.02;    ///< [m], of the surface, > 0
  double tilt = 0.1;       ///< [rad], of the normal about each tangent, > 0
  double curvature = 0.3;  ///< [1/m], and a quarter of what the surface is believed to bend by, > 0
  /// [1/m] per square root of a metre of way, by which curvatures wander, > 0
  double bend_change = 0.5;
  /// [m], of the tip's position along the normal, beside what differs from tick to tick, which is
  /// found out, > 0
  double position_noise = 3e-5;
  /// [m] of way after which that noise is another: an encoder's step seen from the tip, > 0
  double noise_length = 1e-4;
  double force_noise = 0.3;  ///< [N], of the force along the normal, > 0
  double compliance = 1e-3;  ///< [m/N], of the surface under the tip, > 0
  /// [m/s], of the surface along its normal; 0: it stands. What may move is told from a slope only
  /// once the tip has turned, >= 0
  double rate = 0.0;
};

/// A Kalman filter over the way of the tip. With phi the distance to the surface as believed (that
/// of the tip's centre: `tip_radius` outside of it), t the way along its tangents and f the force
/// along the normal, the tip is at
///   phi = h + s . t + t . K t / 2 - c f,
/// h, s and K being what height, slope and curvature of the surface differ by from what is believed
/// and c its compliance; h changes by the rate r where the surface may move. Slope and curvature of
/// places to come follow from those here.
class SurfaceEstimator {
 public:
  /// Throws Error for deviations that are not positive numbers.
  SurfaceEstimator(Surface believed, double tip_radius, const SurfaceEstimateOptions& options,
                   double tick_period);

  void reset() noexcept;
  /// A tick: the tip's centre, m, and the surface's force on it, N, along its normal. Where it does
  /// not touch nothing is learnt, but the surface is known for where the tip is. No allocation.
  void update(const Eigen::Vector3d& p, double force, bool touches) noexcept;

  /// Of the tip's centre, near the last tick's: zero on the surface that the tip slides on,
  /// unloaded.
  const Quadric& surface() const { return surface_; }
  const Eigen::Vector3d& normal() const { return normal_; }  ///< at the tip, of length one
  /// Deviation of the normal's angle, rad, about the tangent that is known worst.
  double normal_deviation() const;
  double compliance() const { return x_[c_]; }  ///< m/N
  double rate() const { return x_[r_]; }        ///< m/s, of the surface along its normal

 private:
  static constexpr int n_ = 8;  ///< h, s (2), K (uu, uw, ww), c, r
  static constexpr int h_ = 0, s_ = 1, k_ = 3, c_ = 6, r_ = 7;
  using State = Eigen::Matrix<double, n_, 1>;
  using Covariance = Eigen::Matrix<double, n_, n_>;

  void learn() noexcept;
  void follow_noise(const Eigen::Vector3d& p) noexcept;
  void start(const Eigen::Vector3d& p, const SurfaceDistance& believed) noexcept;
  void wait(double dt) noexcept;
  void move_to(const Eigen::Vector3d& p, const Eigen::Vector2d& d,
               const SurfaceDistance& believed) noexcept;
  void measure(double distance, double force, double way) noexcept;
  void begin_anew() noexcept;
  void recover(double way) noexcept;
  void tell(const Eigen::Vector3d& p) noexcept;

  Surface believed_;
  double radius_;
  SurfaceEstimateOptions options_;
  int window_;           ///< ticks that are averaged into a measurement, at least
  double tick_period_;   ///< s
  double time_ = 0.0;    ///< s since the last measurement
  double noise_share_;   ///< of a tick, in the mean of white_
  double white_ = 0.0;   ///< m^2, variance of places along the normal from tick to tick
  double spread_ = 0.0;  ///< m^2, in all directions
  int seen_ = 0;         ///< ticks, up to a million
  Eigen::Vector3d before_, before_that_;  ///< m, the last two ticks' places
  Eigen::Matrix3d tangents_;              ///< columns: t_u, t_w and the believed normal, at place_
  State x_;
  Covariance P_;
  /// m, of the state; of the last window; of the ticks of this one
  Eigen::Vector3d place_, last_, sum_p_;
  double sum_f_ = 0.0;
  int ticks_ = 0;
  bool placed_ = false;
  double trust_ = 1.0;  ///< share of the deviations of slope and curvature that may be
  double bend_ = 0.0;   ///< 1/m, deviation of curvatures where the tip touched first
  Quadric surface_;
  Eigen::Vector3d normal_;
};

}  // namespace burnish
