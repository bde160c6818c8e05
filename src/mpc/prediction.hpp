// Where a policy leads in a while, for plans that are used later than they are begun.
#pragma once

#include "mpc/horizon.hpp"
#include "mpc/policy.hpp"

namespace burnish {

class Prediction {
 public:
  explicit Prediction(const Problem& problem);
  /// Moves x (nx) to where the policy leads within `duration` s from now on, by knots as they are
  /// at the schedule's time; the first knot is then to be placed anew. False and x as it was where
  /// there is no prediction. May throw what targets throw.
  bool advance(Problem& problem, Horizon& horizon, Policy& policy, double now, double schedule_time,
               double duration, Eigen::VectorXd& x);

 private:
  Eigen::VectorXd start_, next_, dx_, u_;
};

}  // namespace burnish
