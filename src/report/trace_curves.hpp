// Signals of a trace for the curves of a plot.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "burnish/base/trace.hpp"
#include "burnish/report/svg_plot.hpp"

namespace burnish {

/// Returns the component of the vector in columns `what`_x_world, `what`_y_world and `what`_z_world
/// along `direction`, in world axes.
inline Eigen::VectorXd along(const Trace& trace, const std::string& what,
                             const Eigen::Vector3d& direction) {
  return trace.column(what + "_x_world") * direction.x() +
         trace.column(what + "_y_world") * direction.y() +
         trace.column(what + "_z_world") * direction.z();
}

/// Returns the component of the vector in columns `what`_x_world, `what`_y_world and `what`_z_world
/// along the surface's true normal in each row.
inline Eigen::VectorXd along_normal(const Trace& trace, const std::string& what) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(trace.rows());
  for (const char* axis : {"_x_world", "_y_world", "_z_world"})
    sum +=
        trace.column(what + axis).cwiseProduct(trace.column(std::string("surface_normal") + axis));
  return sum;
}

/// Distance of the tool from its target, perpendicular to the surface's true normal in each row
/// [m].
inline Eigen::VectorXd off_target(const Trace& trace) {
  Eigen::ArrayXd off = Eigen::ArrayXd::Zero(trace.rows());
  for (const char* axis : {"_x_world", "_y_world", "_z_world"})
    off += (trace.column(std::string("tool") + axis) - trace.column(std::string("target") + axis))
               .array()
               .square();
  const Eigen::ArrayXd above =
      (along_normal(trace, "tool") - along_normal(trace, "target")).array();
  return (off - above.square()).max(0.0).sqrt();
}

/// Returns the first row of a phase and the row after its last row. Both are equal if the trace
/// does not have this phase.
inline std::pair<Eigen::Index, Eigen::Index> rows_of_phase(const Trace& trace, double phase) {
  const Eigen::VectorXd phases = trace.column("phase");
  Eigen::Index first = 0, last = phases.size();
  while (first < last && phases[first] != phase) ++first;
  while (last > first && phases[last - 1] != phase) --last;
  return {first, last};
}

/// Reduces a curve to about `count` pieces of equal length. For each piece, the result has the
/// smallest and the largest value in their order, so that peaks are kept.
inline Curve extremes(const Eigen::VectorXd& x, const Eigen::VectorXd& y, Eigen::Index count) {
  const Eigen::Index n = x.size(), piece = std::max<Eigen::Index>(1, n / count);
  const Eigen::Index pieces = (n + piece - 1) / piece;
  Curve curve{.x = Eigen::VectorXd(2 * pieces), .y = Eigen::VectorXd(2 * pieces)};
  for (Eigen::Index i = 0; i < pieces; ++i) {
    const auto values = y.segment(i * piece, std::min(piece, n - i * piece));
    Eigen::Index low = 0, high = 0;
    values.minCoeff(&low);
    values.maxCoeff(&high);
    for (const Eigen::Index side : {Eigen::Index{0}, Eigen::Index{1}}) {
      const Eigen::Index at = i * piece + (side == 0 ? std::min(low, high) : std::max(low, high));
      curve.x[2 * i + side] = x[at];
      curve.y[2 * i + side] = y[at];
    }
  }
  return curve;
}

}  // namespace burnish
