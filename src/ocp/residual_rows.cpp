#include "ocp/residual_rows.hpp"

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "model/followers.hpp"
#include "ocp/friction_pyramid.hpp"
#include "ocp/position_limits.hpp"

namespace burnish::ocp {
namespace {

std::vector<RowGroup> single_rows(const std::vector<std::string>& names) {
  std::vector<RowGroup> rows;
  for (const std::string& name : names) rows.push_back({name, 1});
  return rows;
}

struct RowsOf {
  const ProblemSpec& spec;

  const Model& model() const { return spec.model; }
  std::vector<const Joint*> joints(const std::vector<std::string>& names) const {
    std::vector<const Joint*> result;
    for (const std::string& name : names)
      result.push_back(&model().joints[to_size(model().joint_index(name))]);
    return result;
  }
  std::vector<const Joint*> driven(const std::vector<std::string>& names) const {
    return names.empty() ? driven_joints(model(), spec.actuation) : joints(names);
  }
  static std::vector<RowGroup> entries(const std::vector<const Joint*>& joints) {
    std::vector<RowGroup> rows;
    for (const Joint* joint : joints) rows.push_back({joint->name, joint->nv});
    return rows;
  }
  /// Returns one row per entry of v of these joints, with the limits -`largest` and `largest`.
  static ResidualRows limited(const std::vector<const Joint*>& joints,
                              const Eigen::VectorXd& largest) {
    std::vector<double> upper;
    for (const Joint* joint : joints)
      for (int k = 0; k < joint->nv; ++k) upper.push_back(largest[joint->v_index + k]);
    const Eigen::VectorXd limits =
        Eigen::Map<const Eigen::VectorXd>(upper.data(), static_cast<Eigen::Index>(upper.size()));
    return {entries(joints), -limits, limits};
  }

  ResidualRows operator()(const residual::State& /*of*/) const { return {}; }
  ResidualRows operator()(const residual::Control& /*of*/) const {
    return limited(driven({}), model().effort_limit);
  }
  ResidualRows operator()(const residual::JointPosition& r) const {
    std::vector<const Joint*> rows = joints(r.joints);
    if (r.joints.empty())
      for (const Joint& joint : model().joints)
        if (!joint.follows && has_position_limit(model(), joint)) rows.push_back(&joint);
    ResidualRows result;
    result.lower = result.upper = Eigen::VectorXd(static_cast<Eigen::Index>(rows.size()));
    Eigen::Index i = 0;
    for (const Joint* joint : rows) {
      result.groups.push_back({joint->name, 1});
      result.lower[i] = model().q_lower[joint->q_index];
      result.upper[i++] = model().q_upper[joint->q_index];
    }
    return result;
  }
  ResidualRows operator()(const residual::JointVelocity& r) const {
    std::vector<const Joint*> rows = joints(r.joints);
    if (r.joints.empty())
      for (const Joint& joint : model().joints)
        if (!joint.follows && joint.kind != JointKind::FreeFlyer) rows.push_back(&joint);
    return limited(rows, model().velocity_limit);
  }
  ResidualRows operator()(const residual::JointTorque& r) const {
    return limited(driven(r.joints), model().effort_limit);
  }
  ResidualRows operator()(const residual::JointTorqueRate& r) const {
    return {entries(driven(r.joints))};
  }
  ResidualRows operator()(const residual::FramePosition& /*of*/) const {
    return {direction_rows(Directions::linear())};
  }
  ResidualRows operator()(const residual::FrameDistance& /*of*/) const { return {{{"distance"}}}; }
  ResidualRows operator()(const residual::FrameRotation& /*of*/) const {
    return {direction_rows(Directions::angular())};
  }
  ResidualRows operator()(const residual::FrameInclination& /*of*/) const {
    return {{{"lead"}, {"tilt"}}};
  }
  ResidualRows operator()(const residual::FrameHeight& /*of*/) const { return {{{"height"}}}; }
  ResidualRows operator()(const residual::ContactForce& r) const {
    return {direction_rows(r.reference ? Directions::all()
                                       : contact_named(spec, r.contact).directions)};
  }
  ResidualRows operator()(const residual::ContactForceRate& r) const {
    return {direction_rows(contact_named(spec, r.contact).directions)};
  }
  ResidualRows operator()(const residual::FrictionCone& r) const {
    return {single_rows(cone_row_names(r.sides))};
  }
  ResidualRows operator()(const residual::CenterOfPressure& r) const {
    std::vector<RowGroup> rows = single_rows({"x_above", "x_below", "y_below", "y_above"});
    if (r.friction > 0.0)
      for (const std::string& name : turning_row_names()) rows.push_back({name});
    return {rows};
  }
  ResidualRows operator()(const residual::CenterOfMass& /*of*/) const {
    return {direction_rows(Directions::linear())};
  }
  ResidualRows operator()(const residual::SupportMargin& r) const {
    std::vector<RowGroup> rows;
    for (std::size_t i = 0; i < r.points.size(); ++i) rows.push_back({"edge_" + std::to_string(i)});
    return {rows};
  }
  ResidualRows operator()(const residual::Custom& r) const {
    std::vector<RowGroup> rows;
    for (int i = 0; i < r.rows; ++i) rows.push_back({"row " + std::to_string(i)});
    return {rows};
  }
  /// Returns the six directions as rows, for residuals without an overload of their own.
  ResidualRows operator()(const auto& /*of*/) const { return {direction_rows(Directions::all())}; }
};

}  // namespace

ResidualRows residual_rows(const ProblemSpec& spec, const Residual& residual) {
  return std::visit(RowsOf{spec}, residual);
}

std::vector<std::string> row_names(const Model& model, const std::vector<RowGroup>& groups) {
  std::vector<std::string> names;
  for (const RowGroup& group : groups) {
    if (group.size == 1) names.push_back(group.name);
    if (group.size <= 1) continue;
    const Joint& joint = model.joints[to_size(model.joint_index(group.name))];
    for (int k = 0; k < group.size; ++k) names.push_back(model.v_name(joint.v_index + k));
  }
  return names;
}

std::vector<RowGroup> direction_rows(Directions directions) {
  std::vector<RowGroup> rows;
  for (int d = 0; d < 6; ++d)
    if (directions.has(d)) rows.push_back({std::string(direction_names[to_size(d)])});
  return rows;
}

const ContactSpec& contact_named(const ProblemSpec& spec, const std::string& name) {
  std::vector<std::string> known;
  for (const ContactSpec& contact : spec.contacts) {
    known.push_back(contact.name.empty() ? contact.tool : contact.name);
    if (known.back() == name) return contact;
  }
  throw Error("unknown contact " + in_quotes(name) +
              (known.empty() ? "; the problem has no contacts" : did_you_mean(name, known)));
}

}  // namespace burnish::ocp
