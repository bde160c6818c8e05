// Torques that joints feel by where they are: springs in joints, springs and dampers of tendons,
//   tau = tau_0 - K q - D v
// over joints of one coordinate, with K and D the sums of k c c^T and d c c^T over springs and
// dampers on a length c^T q; -k times the angle from rest, the short way, on a circle; -k log(q) of
// a ball. As damping and friction they are in no dynamics unless the caller adds them to tau.
#pragma once

#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

struct Springs {
  explicit Springs(const Model& model);

  /// A place of d(tau)/dq and d(tau)/dv that is not zero: no place comes twice.
  struct Place {
    int row, column;  ///< entries of v
    double by_v;      ///< constant, Nms/rad (Ns/m)
  };
  /// Where the law is linear, with the entries of q of row and column.
  struct Linear {
    int row, column;
    int q_row, q_column;
    double by_q, by_v;
  };
  /// A torque at q = 0, Nm or N.
  struct Pull {
    int row, q;
    double torque;
  };
  struct Circle {
    int row, q;
    double stiffness;
    double cosine, sine;  ///< of the rest
  };
  struct Ball {
    int row, q;
    double stiffness;
  };

  bool empty() const { return places.empty(); }

  std::vector<Place> places;  ///< of `linear`, of `circles`, and of each ball nine, row by row
  std::vector<Linear> linear;
  std::vector<Pull> pulls;
  std::vector<Circle> circles;
  std::vector<Ball> balls;
  double energy_at_zero = 0.0;  ///< of the linear ones, J
};

/// Adds the torques at (q, v) (nq, nv) to tau (nv: Nm or N).
template <class S>
void add_spring_torque(const Springs& springs, const S* q, const S* v, S* tau);

/// d(tau)/dq by the right tangent increment at every place, into by_q (as many as there are
/// places). d(tau)/dv is constant: Place::by_v.
template <class S>
void spring_slopes(const Springs& springs, const S* q, S* by_q);

/// Energy in the springs, J. Springs of a joint and of its followers that pull against each other
/// count as the one that they make together: their energy at its rest is left out.
template <class S>
S spring_energy(const Springs& springs, const S* q);

}  // namespace burnish
