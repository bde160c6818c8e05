// Compiles each kind of residual: its rows, targets and Jacobian blocks. Refuses invalid residuals.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "dynamics/reference.hpp"
#include "model/followers.hpp"
#include "ocp/friction_pyramid.hpp"
#include "ocp/position_limits.hpp"
#include "ocp/support_polygon.hpp"
#include "ocp/term_builder.hpp"

namespace burnish::ocp {

namespace {

/// A TermBuilder with one function for each kind of residual.
struct ResidualCompiler : TermBuilder {
  void operator()(const residual::State& r) {
    term.rows = layout().ndx();
    target(r.target, layout().nx(), spec.initial_state);
    unit_configuration();
    StateDifference state{
        &problem.tree, layout().nq, layout().filtered + layout().force_states, {}, problem.blocks};
    std::vector<char> in_block(to_size(layout().ndx()), 0);
    for (const TangentBlock& block : problem.blocks)
      std::fill_n(in_block.begin() + block.first, block.size, char{1});
    // Adds a diagonal block for each group of consecutive entries outside the tangent blocks.
    int row = 0;
    while (row < layout().ndx()) {
      if (in_block[row] != 0) {
        ++row;
        continue;
      }
      JacobianBlock run{row, 0, {}, true};
      for (; row < layout().ndx() && in_block[row] == 0; ++row, ++run.rows) {
        run.columns.push_back(layout().nu + row);
        state.diagonal_rows.push_back(row);
      }
      term.blocks.push_back(run);
    }
    for (const TangentBlock& block : problem.blocks) {
      std::vector<int> columns(to_size(block.size));
      std::iota(columns.begin(), columns.end(), layout().column_q() + block.first);
      term.blocks.push_back({block.first, block.size, columns, false});
    }
    term.residual = state;
  }

  void select(Selection::Source source, std::vector<int> entries, int first_column,
              const std::vector<int>& columns, const Signal& signal) {
    term.rows = static_cast<int>(entries.size());
    if (term.rows == 0) refuse("it has no rows; wanted at least one");
    zero_target(signal, term.rows);
    JacobianBlock block{0, term.rows, {}, true};
    for (const int c : columns) block.columns.push_back(first_column + c);
    term.blocks.push_back(block);
    term.residual = Selection{source, std::move(entries)};
  }

  void operator()(const residual::Control& r) {
    if (stage.nu == 0) refuse("this stage has no controls");
    std::vector<int> entries(to_size(layout().nu));
    std::iota(entries.begin(), entries.end(), 0);
    select(Selection::Source::U, entries, 0, entries, r.target);
  }

  const Joint& joint(const std::string& name) const {
    try {
      const Model& model = problem.model;
      const Joint& found = model.joints[to_size(model.joint_index(name))];
      if (found.follows) refuse(that_it_follows(model, found));
      return found;
    } catch (const Error& error) {
      refuse(error.what());
    }
  }

  void operator()(const residual::JointPosition& r) {
    std::vector<int> entries, columns;
    const auto add = [&](const Joint& j) {
      entries.push_back(j.q_index);
      columns.push_back(j.v_index);
    };
    const auto plain = [](const Joint& j) { return j.nq == 1; };
    for (const std::string& name : r.joints) {
      const Joint& j = joint(name);
      if (!plain(j))
        refuse("joint " + in_quotes(name) + " is " + std::string(name_of(j.kind)) +
               "; wanted a revolute or prismatic joint");
      add(j);
    }
    if (r.joints.empty())
      for (const Joint& j : problem.model.joints)
        if (has_position_limit(problem.model, j)) add(j);
    select(Selection::Source::Q, entries, layout().column_q(), columns, r.target);
  }

  std::vector<int> velocity_entries(const std::vector<std::string>& joints) const {
    std::vector<int> entries;
    const auto add = [&](const Joint& j) {
      for (int k = 0; k < j.nv; ++k) entries.push_back(j.v_index + k);
    };
    for (const std::string& name : joints) add(joint(name));
    if (joints.empty())
      for (const Joint& j : problem.model.joints)
        if (j.kind != JointKind::FreeFlyer) add(j);
    return entries;
  }

  void operator()(const residual::JointVelocity& r) {
    const std::vector<int> entries = velocity_entries(r.joints);
    select(Selection::Source::V, entries, layout().column_v(), entries, r.target);
  }

  /// Returns the actuators of `joints`; all actuators if `joints` is empty.
  std::vector<int> actuators(const std::vector<std::string>& joints) const {
    std::vector<int> entries;
    for (const int k : velocity_entries(joints)) {
      const auto found = std::find(layout().actuated.begin(), layout().actuated.end(), k);
      if (found != layout().actuated.end()) {
        entries.push_back(static_cast<int>(found - layout().actuated.begin()));
      } else if (!joints.empty()) {
        refuse("joint entry " + in_quotes(problem.model.v_name(k)) + " is not driven");
      }
    }
    return entries;
  }

  void operator()(const residual::JointTorque& r) {
    const std::vector<int> entries = actuators(r.joints);
    const bool in_state = layout().acts_from_state();
    if (!in_state && stage.nu == 0) refuse("this stage has no controls");
    select(in_state ? Selection::Source::TorqueState : Selection::Source::U, entries,
           in_state ? layout().column_tau() : 0, entries, r.target);
  }

  void operator()(const residual::JointTorqueRate& r) {
    if (!spec.torque_model)
      refuse(
          "the torques are the control, which has no rate; wanted a torque model ('held' or with a "
          "cut-off), which adds one entry per driven joint to the state");
    if (stage.nu == 0) refuse("this stage has no controls, so torques have no rate");
    const bool held = layout().holds_torque;
    TorqueRate rate{held ? 1.0 / stage.step : spec.torque_model->cutoff, held, actuators(r.joints)};
    term.rows = static_cast<int>(rate.entries.size());
    if (term.rows == 0) refuse("it has no rows; wanted at least one");
    zero_target(r.target, term.rows);
    for (int i = 0; i < term.rows; ++i)
      term.blocks.push_back(
          {i, 1, {rate.entries[i], layout().column_tau() + rate.entries[i]}, false});
    term.residual = std::move(rate);
  }

  /// Returns the position error of a frame. The reference's origin must not be the frame itself.
  FramePositionError position(const std::string& name, const Reference& reference) {
    const int f = frame(name);
    FramePositionError result{f, view(f, asked_for_positions(reference))};
    if (result.view.reference.at_tool)
      refuse(
          "the reference's origin is the frame itself, where the position is always zero; wanted "
          "the world or another frame");
    const CompiledReference& seen = result.view.reference;
    result.is_in_world =
        seen.at_world && seen.axes_body < 0 && to_eigen(seen.fixed_in).isIdentity(0.0);
    return result;
  }

  void operator()(const residual::FramePosition& r) {
    term.rows = 3;
    target(r.target, 3, {});
    const FramePositionError error = position(r.frame, r.reference);
    term.residual = error;
    dense_block(3, columns(layout().column_q(), error.view.entries));
  }

  void operator()(const residual::FrameDistance& r) {
    if (r.directions.bits == 0 || (r.directions.bits & Directions::angular().bits) != 0)
      refuse("directions are '" + r.directions.text() + "'; wanted one or more of x, y and z");
    term.rows = 1;
    const FrameDistance distance{position(r.frame, r.reference), r.directions};
    if (distance.position.view.reference.at_world)
      target(r.target, 3, {});
    else
      zero_target(r.target, 3);
    term.residual = distance;
    dense_block(1, columns(layout().column_q(), distance.position.view.entries));
  }

  void operator()(const residual::FrameRotation& r) {
    term.rows = 3;
    target(r.target, 4, {}, CompiledTerm::Load::Rotation);
    unit_quaternion(0);
    const int f = frame(r.frame);
    const FrameRotationError error{f, turned(f, r.reference)};
    term.residual = error;
    dense_block(3, columns(layout().column_q(), error.view.entries));
  }

  /// Returns the view of a frame in the axes of a reference. Throws Error for the frame's own axes.
  FrameView turned(int frame, Reference reference) {
    reference.origin = Anchor::Tool;  // rotations do not depend on the origin
    const FrameView result = view(frame, reference);
    if (reference.axes == Anchor::Tool)
      refuse(
          "the reference's axes are the frame's own, and relative to them the frame never turns; "
          "wanted axes of the world or of another frame");
    return result;
  }

  void operator()(const residual::FrameInclination& r) {
    if (!r.axis.allFinite() || !(r.axis.norm() > 1e-9))
      refuse("the axis is not finite or has length 0; wanted a direction in the frame's axes");
    term.rows = 2;
    zero_target(r.target, 2);
    const int f = frame(r.frame);
    const FrameInclinationError error{f, turned(f, r.reference),
                                      from_eigen(Eigen::Vector3d(r.axis.normalized()))};
    term.residual = error;
    dense_block(2, columns(layout().column_q(), error.view.entries));
  }

  void operator()(const residual::FrameHeight& r) {
    if (!r.reference.quadric)
      refuse("the reference has no curved surface; wanted a reference from Reference::on");
    term.rows = 1;
    zero_target(r.target, 1);
    const int f = frame(r.frame);
    const FrameHeightError error{f, turned(f, r.reference)};
    term.residual = error;
    dense_block(1, columns(layout().column_q(), error.view.entries));
  }

  void operator()(const residual::FramePlacement& r) {
    term.rows = 6;
    target(r.target, 7, {}, CompiledTerm::Load::Placement);
    unit_quaternion(3);
    const int f = frame(r.frame);
    term.residual = FramePlacementError{f};
    dense_block(6, support_columns(f));
  }

  void operator()(const residual::FrameVelocity& r) {
    term.rows = 6;
    zero_target(r.target, 6);
    const int f = frame(r.frame);
    const FrameVelocityError error{f, view(f, r.reference)};
    term.residual = error;
    std::vector<int> all = columns(layout().column_q(), error.view.entries);
    for (const MovingAxis& k : stage.frames[f].support) all.push_back(layout().column_v() + k.v);
    dense_block(6, all);
  }

  void operator()(const residual::ContactForce& r) {
    const int c = contact(r.contact);
    if (r.reference) {
      term.rows = 6;
      term.residual = WrenchError{wrench(c, r.reference)};
    } else {
      term.rows = static_cast<int>(problem.contacts.contacts()[c].directions.size());
      term.residual = OwnForceError{c, term.rows};
    }
    zero_target(r.target, term.rows);
    dense_block(term.rows, all_columns());
  }

  void operator()(const residual::ContactForceRate& r) {
    const int c = contact(r.contact);
    if (stage.terminal) refuse("the terminal state has no step, so forces have no rate");
    const auto force_states =
        std::find_if(problem.force_states.begin(), problem.force_states.end(),
                     [c](const ForceState& force) { return force.contact == c; });
    const auto rows = problem.contacts.contacts()[c].directions.size();
    if (force_states == problem.force_states.end())
      refuse("the state does not contain the force of the previous step; wanted " +
             in_quotes(r.contact) + " in the problem's force_states, which adds " +
             std::to_string(rows) + (rows == 1 ? " entry" : " entries") + " to the state");
    term.rows = force_states->rows;
    term.residual = ForceRate{c, term.rows, force_states->first, 1.0 / stage.step};
    zero_target(r.target, term.rows);
    dense_block(term.rows, all_columns());
  }

  /// Throws Error unless the contact `c` constrains the direction `normal` (0 to 2), and all or all
  /// but one of the directions `wanted`. The force along an unconstrained direction is zero.
  void require_directions(int c, Directions wanted, int normal) const {
    const Directions held = problem.contacts.contacts()[c].spec.directions;
    const Directions both{static_cast<std::uint8_t>(held.bits & wanted.bits)};
    if (!held.has(normal) || both.count() + 1 < wanted.count())
      refuse("contact " + in_quotes(problem.contacts.contacts()[c].spec.name) + " holds " +
             held.text() + "; wanted directions that include " + wanted.text());
  }

  void operator()(const residual::FrictionCone& r) {
    const int c = contact(r.contact);
    if (!(r.friction > 0.0) || !std::isfinite(r.friction))
      refuse("friction is " + number(r.friction) + "; wanted a number above 0");
    if (r.normal < 0 || r.normal > 2)
      refuse("normal is " + std::to_string(r.normal) + "; wanted 0, 1 or 2");
    require_directions(c, Directions::linear(), r.normal);
    try {
      check_sides(r.sides);
    } catch (const Error& error) {
      refuse(error.what());
    }
    const WrenchView view = wrench(c, r.reference);
    term.rows = r.sides == 0 ? 2 : r.sides;
    if (r.sides == 0)
      term.residual = ConeMargin{view, r.normal};
    else
      term.residual =
          PyramidMargin{view, r.normal, pyramid_inradius(r.sides), pyramid_sides(r.sides)};
    target({}, 1, Eigen::VectorXd::Constant(1, r.friction));
    dense_block(term.rows, all_columns());
  }

  void operator()(const residual::CenterOfPressure& r) {
    const int c = contact(r.contact);
    require_directions(c, Directions::pad_z(), 2);
    if (!(r.half_x > 0.0 && r.half_y > 0.0) || !std::isfinite(r.half_x * r.half_y))
      refuse("half lengths are " + number(r.half_x) + " and " + number(r.half_y) +
             " m; wanted positive numbers");
    if (!(r.friction >= 0.0) || !std::isfinite(r.friction))
      refuse("friction is " + number(r.friction) + "; wanted a number of at least zero");
    const bool has_friction = r.friction > 0.0;
    if (has_friction) require_directions(c, Directions::all(), 2);
    term.rows = has_friction ? 12 : 4;
    term.residual = PressureMargin{wrench(c, Reference::local()), r.half_x, r.half_y, has_friction};
    if (has_friction) target({}, 1, Eigen::VectorXd::Constant(1, r.friction));
    dense_block(term.rows, all_columns());
  }

  void operator()(const residual::CenterOfMass& r) {
    term.rows = 3;
    target(r.target, 3, {});
    stage.has_momentum = true;
    term.residual = ComError{};
    std::vector<int> columns(to_size(layout().nv));
    std::iota(columns.begin(), columns.end(), layout().column_q());
    dense_block(3, columns);
  }

  void operator()(const residual::SupportMargin& r) {
    SupportMargin margin;
    try {
      margin.edges = support_edges(r.points);
    } catch (const Error& error) {
      refuse(error.what());
    }
    term.rows = static_cast<int>(margin.edges.size());
    stage.has_momentum = true;
    term.residual = std::move(margin);
    std::vector<int> columns(to_size(layout().nv));
    std::iota(columns.begin(), columns.end(), layout().column_q());
    dense_block(term.rows, columns);
  }

  void operator()(const residual::CentroidalMomentum& r) {
    term.rows = 6;
    zero_target(r.target, 6);
    stage.has_momentum = true;
    term.residual = MomentumError{};
    std::vector<int> columns(to_size(2 * layout().nv));
    std::iota(columns.begin(), columns.end(), layout().column_q());
    dense_block(6, columns);
  }

  void operator()(const residual::Custom& r) {
    if (r.rows < 1) refuse("it has " + std::to_string(r.rows) + " rows; wanted at least 1");
    if (!r.value) refuse("it has no value function; the function is needed");
    CustomResidual compiled{r, {}, {}};
    for (const std::string& name : r.frames) compiled.frames.push_back(frame(name));
    for (const std::string& name : r.contacts) compiled.contacts.push_back(contact(name));
    term.rows = r.rows;
    term.residual = compiled;
    dense_block(r.rows, all_columns());
  }
};

}  // namespace

void compile_residual(TermBuilder& builder) {
  ResidualCompiler compiler{builder};
  std::visit(compiler, builder.residual);
  builder.term = std::move(compiler.term);
}

}  // namespace burnish::ocp
