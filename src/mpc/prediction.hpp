// Prediction of the state under a feedback policy. Plans that come into use after a delay start at
// this state.
#pragma once

#include "mpc/horizon.hpp"
#include "mpc/policy.hpp"

namespace burnish {

class Prediction {
 public:
  explicit Prediction(const Problem& problem);
  /// Interval of a prediction.
  struct Interval {
    double start = 0.0;           ///< Time at which the policy starts [s]
    double schedule_start = 0.0;  ///< Time of the schedule at `start`; determines the contacts [s]
    double duration = 0.0;        ///< Duration [s]
  };
  /// Replaces x (nx) by the state that the policy reaches at the end of an interval. The call
  /// overwrites the first knot of the problem, which must be placed again afterwards. Returns false
  /// and leaves x unchanged if the dynamics cannot be evaluated. Exceptions from functions in
  /// targets are passed on.
  bool advance(Problem& problem, Horizon& horizon, Policy& policy, const Interval& over,
               Eigen::VectorXd& x);

 private:
  Eigen::VectorXd start_, next_, dx_, u_;
};

}  // namespace burnish
