// Prediction of the state under a feedback policy. Plans that come into use after a delay start at
// this state.
#pragma once

#include "mpc/horizon.hpp"
#include "mpc/policy.hpp"

namespace burnish {

class Prediction {
 public:
  explicit Prediction(const Problem& problem);
  /// Replaces x (nx) by the state that the policy reaches after `duration` [s]. `now`: time at
  /// which the policy starts [s]. `schedule_time`: time of the schedule that determines the
  /// contacts [s]. The call overwrites the first knot of the problem, which must be placed again
  /// afterwards. Returns false and leaves x unchanged if the dynamics cannot be evaluated.
  /// Exceptions from functions in targets are passed on.
  bool advance(Problem& problem, Horizon& horizon, Policy& policy, double now, double schedule_time,
               double duration, Eigen::VectorXd& x);

 private:
  Eigen::VectorXd start_, next_, dx_, u_;
};

}  // namespace burnish
