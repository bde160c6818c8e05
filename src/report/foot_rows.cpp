#include "report/foot_rows.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"

namespace burnish {

StateRows::StateRows(const Trace& trace, const Model& model)
    : trace_(&trace), q_(model.nq), v_(model.nv), body_(model) {
  for (int k = 0; k < model.nq; ++k) q_columns_.push_back(trace.index("q_" + model.q_name(k)));
  for (int k = 0; k < model.nv; ++k) v_columns_.push_back(trace.index("v_" + model.v_name(k)));
}

Status StateRows::look(int row) {
  for (Eigen::Index k = 0; k < q_.size(); ++k) q_[k] = trace_->at(row, q_columns_[to_size(k)]);
  for (Eigen::Index k = 0; k < v_.size(); ++k) v_[k] = trace_->at(row, v_columns_[to_size(k)]);
  return body_.update(q_, v_);
}

FootRows::FootRows(const Trace& trace, const RigidBody& body, const TouchSpec& support)
    : trace_(&trace), support_(support), frame_(body.frame(support.frame)), columns_{} {
  if (!(support.surface.normal.allFinite() && support.surface.normal.norm() > 1e-9))
    throw Error("the normal under " + in_quotes(support.frame) +
                " has no direction; wanted a direction out of the ground");
  support_.surface.normal.normalize();
  const char* const axes[] = {"fx", "fy", "fz", "mx", "my", "mz"};
  for (std::size_t i = 0; i < 6; ++i)
    columns_[i] = trace.index("support_" + support.frame + "_" + axes[i]);
}

FootLoad FootRows::load(int row, const Eigen::Isometry3d& foot) const {
  const auto entry = [&](std::size_t i) { return trace_->at(row, columns_[i]); };
  const Eigen::Vector3d force(entry(0), entry(1), entry(2));
  const Eigen::Vector3d normal_foot = foot.linear().transpose() * support_.surface.normal;
  FootLoad load;
  load.normal = normal_foot.dot(force);
  load.tangential = (force - load.normal * normal_foot).norm();
  // A force f at a point p of the sole (z = 0) has the moment m = p x f, so that m_x = p_y f_z and
  // m_y = -p_x f_z.
  if (support_.is_rectangle() && std::abs(force.z()) > 1e-9)
    load.pressure = {-entry(4) / force.z(), entry(3) / force.z()};
  return load;
}

std::vector<Eigen::Vector3d> FootRows::points(const Eigen::Isometry3d& foot) const {
  if (!support_.is_rectangle()) return {foot.translation()};
  std::vector<Eigen::Vector3d> corners;
  for (const double x : {-support_.half_x, support_.half_x})
    for (const double y : {-support_.half_y, support_.half_y})
      corners.push_back(foot * Eigen::Vector3d(x, y, 0.0));
  return corners;
}

double FootRows::friction_used(const FootLoad& load) const {
  // Without friction, any tangential force gives an infinite ratio.
  return load.tangential > 0.0 ? load.tangential / (support_.surface.friction * load.normal) : 0.0;
}

double FootRows::margin(const FootLoad& load) const {
  return std::min(support_.half_x - std::abs(load.pressure.x()),
                  support_.half_y - std::abs(load.pressure.y()));
}

}  // namespace burnish
