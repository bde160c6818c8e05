#include "burnish/report/standing_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "report/foot_rows.hpp"

namespace burnish {
namespace {

/// Time at the start of a run in which the compliant ground takes up the robot's load, chosen by
/// hand [s].
constexpr double settling = 0.05;

/// Evaluation of one foot over the rows of a run.
class FootWatch {
 public:
  FootWatch(const FootRows& rows, const RigidBody& first)
      : rows_(rows), start_(rows.points(rows.placement(first))) {}

  void look_at_place(const RigidBody& body, StandingFigures& figures) const {
    const Eigen::Isometry3d foot = rows_.placement(body);
    const std::vector<Eigen::Vector3d> points = rows_.points(foot);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d moved = points[i] - start_[i];
      const Eigen::Vector3d along = moved - rows_.normal().dot(moved) * rows_.normal();
      figures.slip = std::max(figures.slip, along.norm());
    }
  }
  void look_at_load(int row, const RigidBody& body, StandingFigures& figures) const {
    const FootLoad load = rows_.load(row, rows_.placement(body));
    figures.min_load = std::min(figures.min_load, load.normal);
    if (!(load.normal >= min_pressure_load)) return;
    figures.friction_used = std::max(figures.friction_used, rows_.friction_used(load));
    if (rows_.support().is_rectangle())
      figures.pressure_margin =
          std::min(figures.pressure_margin.value_or(std::numeric_limits<double>::infinity()),
                   rows_.margin(load));
  }

 private:
  const FootRows& rows_;
  std::vector<Eigen::Vector3d> start_;
};

/// Returns a frame on the body of the floating base, or the world without a floating base.
int base_frame(const Model& model, const RigidBody& body) {
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    if (model.joints[i].kind != JointKind::FreeFlyer) continue;
    for (const Frame& frame : model.frames)
      if (frame.body == static_cast<int>(i)) return body.frame(frame.name);
  }
  return body.frame("world");
}

}  // namespace

StandingFigures measure_standing(const Trace& trace, const Model& model,
                                 const std::vector<TouchSpec>& supports) {
  if (trace.rows() == 0) throw Error("the trace has no rows; wanted the trace of a run");
  if (supports.empty())
    throw Error("there are no supports; wanted at least one support of the robot");
  const Trace::Column time = trace.column("time");
  StateRows states(trace, model);
  const RigidBody& body = states.body();
  if (const Status status = states.look(0); !is_usable(status))
    throw Error("the first row of the trace is not a valid state: " +
                std::string(describe(status)));
  std::vector<FootRows> feet;
  for (const TouchSpec& support : supports) feet.emplace_back(trace, body, support);
  std::vector<FootWatch> watches;
  for (const FootRows& foot : feet) watches.emplace_back(foot, body);
  const int base = base_frame(model, body);
  const Eigen::Vector3d up_base =
      body.placement(base).linear().transpose() * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d com_start = body.com();
  StandingFigures figures;
  figures.min_load = std::numeric_limits<double>::infinity();
  for (int row = 0; row < trace.rows(); ++row) {
    if (!is_usable(states.look(row))) break;
    for (const FootWatch& watch : watches) {
      watch.look_at_place(body, figures);
      if (time[row] >= time[0] + settling) watch.look_at_load(row, body, figures);
    }
    const Eigen::Vector3d up = body.placement(base).linear() * up_base;
    figures.base_tilt = std::max(figures.base_tilt, std::atan2(up.head<2>().norm(), up.z()));
    figures.com_moved = std::max(figures.com_moved, (body.com() - com_start).norm());
  }
  if (!std::isfinite(figures.min_load)) figures.min_load = 0.0;  // run shorter than `settling`
  return figures;
}

bool fell(const StandingFigures& figures) {
  constexpr double max_tilt = std::numbers::pi / 6.0, max_displacement = 0.25;  // [rad], [m]
  return !(figures.base_tilt <= max_tilt && figures.com_moved <= max_displacement);
}

}  // namespace burnish
