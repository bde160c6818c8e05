// Torques of springs in joints, and of springs and dampers of tendons.
//  - For joints with one coordinate, tau = tau_0 - K q - D v. K and D are the sums of k c c^T and
//    d c c^T over all springs and dampers that act on a length c^T q.
//  - For continuous joints, the torque is -k times the angle from rest, within [-pi, pi].
//  - For balls, the torque is -k log(q).
// Forward and inverse dynamics do not include these torques; the caller adds them to tau.
#pragma once

#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// Springs and dampers of a model.
struct Springs {
  explicit Springs(const Model& model);

  /// Place of an entry of d(tau)/dq and d(tau)/dv that can be nonzero. Each place occurs once.
  struct Place {
    int row, column;  ///< Entries of v
    double by_v;      ///< Entry of d(tau)/dv, a constant [Nms/rad or Ns/m]
  };
  /// Entry (row, column) of -K (by_q) and -D (by_v) in the linear law tau = tau_0 - K q - D v.
  /// `row` and `column` are indices in v; q_row and q_column are their counterparts in q.
  struct Linear {
    int row, column;
    int q_row, q_column;
    double by_q, by_v;
  };
  /// Torque of the linear law at q = 0 [Nm or N].
  struct Pull {
    int row, q;
    double torque;
  };
  /// Spring of a continuous joint.
  struct Circle {
    int row, q;
    double stiffness;
    double cosine, sine;  ///< Cosine and sine of the rest angle
  };
  /// Spring of a ball.
  struct Ball {
    int row, q;
    double stiffness;
  };

  bool empty() const { return places.empty(); }

  /// Places of `linear`, then of `circles`, then of `balls` (3 x 3 for each ball, row by row)
  std::vector<Place> places;
  std::vector<Linear> linear;
  std::vector<Pull> pulls;
  std::vector<Circle> circles;
  std::vector<Ball> balls;
  double energy_at_zero = 0.0;  ///< Energy of the linear law at q = 0 [J]
};

/// Adds the torques at q (nq) and v (nv) to tau (nv) [Nm or N].
template <class S>
void add_spring_torque(const Springs& springs, const S* q, const S* v, S* tau);

/// Computes d(tau)/dq by right tangent increments. Writes one number into by_q for each of
/// `places`. (d(tau)/dv is the constant Place::by_v.)
template <class S>
void spring_slopes(const Springs& springs, const S* q, S* by_q);

/// Energy in the springs [J]. If springs of a joint and its followers pull in opposite directions,
/// they count as one combined spring, whose energy is zero at its rest position.
template <class S>
S spring_energy(const Springs& springs, const S* q);

}  // namespace burnish
