// Statistics of a hand that rests on a plane, computed from the trace of a run.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "polishing/resting_hand.hpp"
#include "pressing/sliding.hpp"
#include "report/foot_rows.hpp"
#include "report/moving_mean.hpp"

namespace burnish::polishing {

RestFigures rest_figures(const RestingHand& rest, const Setting& setting, const Trace& trace,
                         double begin, double end) {
  constexpr double average = 0.01;  // averaging time of the force, as in VerdictFigures [s]
  const Trace::Column time = trace.column("time");
  StateRows states(trace, setting.robot.model);
  const FootRows hand(trace, states.body(), setting.scene.touch(rest.frame));
  const auto first =
      static_cast<int>(std::lower_bound(time.begin(), time.end(), begin - 1e-9) - time.begin());
  std::vector<double> forces;
  RestFigures figures;
  Eigen::Isometry3d contact = Eigen::Isometry3d::Identity();
  for (int row = first; row < trace.rows() && time[row] <= end + 1e-9; ++row) {
    if (!is_usable(states.look(row))) break;
    const Eigen::Isometry3d now = hand.placement(states.body());
    if (forces.empty()) contact = now;
    forces.push_back(hand.load(row, now).normal);
    figures.slip =
        std::max(figures.slip, pressing::slid(contact, now, hand.normal(), rest.radius).norm());
  }
  if (forces.size() < 2) return figures;
  const Eigen::VectorXd measured =
      Eigen::Map<const Eigen::VectorXd>(forces.data(), static_cast<Eigen::Index>(forces.size()));
  const Eigen::VectorXd force =
      moving_mean(measured, samples_in(average, time[first + 1] - time[first]));
  const Eigen::ArrayXd error = force.array() - rest.force;
  figures.force_mean = force.mean();
  figures.force_rmse = std::sqrt(error.square().mean());
  figures.force_peak = error.abs().maxCoeff();
  return figures;
}

std::string rest_failure(const Task& task, const RestFigures& figures) {
  const double force = task.rest.force, allowed = task.verdict.force_rmse;
  if (figures.force_rmse <= allowed * force) return {};
  char text[160];
  std::snprintf(text, sizeof text,
                "the force of the resting hand was off by %.3g N rms, %.3g %% of %.4g N "
                "(verdict.force_rmse allows %.3g %%)",
                figures.force_rmse, 100.0 * figures.force_rmse / force, force, 100.0 * allowed);
  return text;
}

std::string rest_text(const RestingHand& rest, const RestFigures& figures) {
  char text[120];
  std::snprintf(text, sizeof text,
                " rested with %.1f N on the path, rms error %.2f N, slip %.1f mm",
                figures.force_mean, figures.force_rmse, 1e3 * figures.slip);
  return rest.frame + text;
}

}  // namespace burnish::polishing
