#include "derivatives/check_units.hpp"

#include <cmath>

#include "contact/row_size.hpp"
#include "model/joint_entries.hpp"

namespace burnish {

namespace {

/// Returns the power of ten nearest to `size` [m], or 1 m if the size is zero.
double decade_of(double size) {
  return size > 0.0 ? std::pow(10.0, std::round(std::log10(size))) : 1.0;
}

}  // namespace

CheckUnits::CheckUnits(const Model& model, const ContactSet& set)
    : length(decade_of(robot_size(model))),
      motion(Eigen::VectorXd::Ones(model.nv)),
      row(Eigen::VectorXd::Ones(set.rows())) {
  constexpr double earth = 9.81;  // gravity on Earth [m/s^2]
  const double gravity = model.gravity.norm(), mass = model.total_mass();
  force = (mass > 0.0 ? mass : 1.0) * (gravity > 0.0 ? gravity : earth);
  torque = Eigen::VectorXd::Constant(model.nv, force * length);
  row_force = Eigen::VectorXd::Constant(set.rows(), force * length);
  for (const Joint& joint : model.joints) {
    if (joint.follows) continue;
    const int sliding = sliding_entries(joint.kind);
    motion.segment(joint.v_index, sliding).setConstant(length);
    torque.segment(joint.v_index, sliding).setConstant(force);
  }
  Eigen::Index r = 0;
  for (const CompiledContact& contact : set.contacts())
    for (const int direction : contact.directions) {
      if (direction < 3) {
        row[r] = length;
        row_force[r] = force;
      }
      ++r;
    }
}

}  // namespace burnish
