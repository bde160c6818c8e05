// Costs and constraints compiled: rows, targets, columns, and what is refused.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "burnish/model/state.hpp"
#include "dynamics/reference.hpp"
#include "model/followers.hpp"
#include "ocp/compiled_problem.hpp"
#include "ocp/position_limits.hpp"
#include "ocp/row_prices.hpp"
#include "ocp/support_polygon.hpp"

namespace burnish::ocp {
namespace {

/// One term on its way; knows where it stands for messages.
struct TermBuilder {
  const ProblemSpec& spec;
  const CompiledProblem& problem;
  const Residual& residual;
  CompiledStage& stage;
  CompiledTerm term;
  std::string where;

  [[noreturn]] void refuse(const std::string& what) const { throw Error(where + ": " + what); }

  const StateLayout& layout() const { return problem.layout; }

  void target(const Signal& signal, int size, const Eigen::VectorXd& fallback,
              CompiledTerm::Load load = CompiledTerm::Load::Plain) {
    term.signal = signal;
    if (signal.empty()) {
      if (fallback.size() == 0)
        refuse("has no target; wanted " + std::to_string(size) + " entries");
      term.signal = Signal(fallback);
    }
    if (term.signal.size() == 1 && size > 1 && term.signal.is_constant()) {
      Eigen::VectorXd one(1);
      term.signal.at(0.0, one);
      term.signal = Signal(Eigen::VectorXd::Constant(size, one[0]));
    }
    if (term.signal.size() != size)
      refuse("the target has " + std::to_string(term.signal.size()) + " entries; wanted " +
             std::to_string(size));
    if (term.signal.is_constant()) {
      Eigen::VectorXd value(size);
      term.signal.at(0.0, value);
      if (!value.allFinite()) refuse("the target holds a NaN or an infinity");
    }
    term.signal_size = size;
    term.load = load;
    term.target_size = load == CompiledTerm::Load::Rotation    ? 9
                       : load == CompiledTerm::Load::Placement ? 12
                                                               : size;
  }
  void zero_target(const Signal& signal, int size) {
    target(signal, size, Eigen::VectorXd::Zero(size));
  }
  void dense_block(int rows, std::vector<int> columns) {
    if (!columns.empty()) term.blocks.push_back({0, rows, std::move(columns), false});
  }
  std::vector<int> all_columns() const {
    std::vector<int> columns(static_cast<std::size_t>(layout().nz()));
    std::iota(columns.begin(), columns.end(), 0);
    return columns;
  }
  static std::vector<int> columns(int first, const std::vector<int>& entries) {
    std::vector<int> result;
    for (const int k : entries) result.push_back(first + k);
    return result;
  }
  std::vector<int> support_columns(int frame) const {
    std::vector<int> result;
    for (const MovingAxis& k : stage.frames[frame].support)
      result.push_back(layout().column_q() + k.v);
    return result;
  }

  int frame(const std::string& name) {
    const auto known = std::find(stage.frame_names.begin(), stage.frame_names.end(), name);
    if (known != stage.frame_names.end())
      return static_cast<int>(known - stage.frame_names.begin());
    try {
      stage.frames.push_back(compile_frame(problem.model, name));
    } catch (const Error& error) {
      refuse(error.what());
    }
    stage.frame_names.push_back(name);
    return static_cast<int>(stage.frames.size()) - 1;
  }
  /// As compile_reference makes it of the reference at the start, and where the stage's targets
  /// have the rotation of one that turns.
  TurningReference turning(const Reference& reference, const CompiledFrame& tool,
                           const CompiledFrame& base) {
    reference.check(where);
    try {
      TurningReference result{
          compile_reference(problem.model, reference.at(spec.start_time), tool, base)};
      result.turning = add_turning(reference, -1, "reference", stage);
      if (result.turning >= 0) result.is_aligned = false;
      return result;
    } catch (const Error& error) {
      refuse("reference: " + std::string(error.what()));
    }
  }
  /// Of a reference whose tool is the frame and whose base is the world.
  FrameView view(int frame, const Reference& reference) {
    const CompiledFrame& seen = stage.frames[frame];
    FrameView result;
    result.reference = turning(reference, seen, world_frame());
    const auto others = [&](int body) {
      return body == seen.body ? std::vector<MovingAxis>{} : moving_axes(problem.model, body);
    };
    result.origin = others(result.reference.origin_body);
    result.axes = others(result.reference.axes_body);
    std::set<int> entries;
    for (const std::span<const MovingAxis> moved :
         {std::span<const MovingAxis>(seen.support), std::span<const MovingAxis>(result.origin),
          std::span<const MovingAxis>(result.axes)})
      for (const MovingAxis& k : moved) entries.insert(k.v);
    result.entries.assign(entries.begin(), entries.end());
    return result;
  }
  WrenchView wrench(int contact, const std::optional<Reference>& reference) {
    WrenchView result{contact, {}, {}};
    if (!reference) return result;
    const CompiledContact& compiled = problem.contacts.contacts()[contact];
    result.reference = turning(*reference, tool_of(compiled), base_of(compiled));
    wrench_entries(problem.tree, compiled, *result.reference, result.entries);
    return result;
  }
  int contact(const std::string& name) {
    int index = -1;
    try {
      index = problem.contacts.index(name);
    } catch (const Error& error) {
      refuse(error.what());
    }
    if (stage.impact) refuse("an impact stage has no contact forces, only impulses");
    if (stage.terminal && layout().filtered == 0)
      refuse(
          "the terminal state has no control, so contact forces are unknown there; they are "
          "known with a torque model, which puts the torques into the state");
    if (stage.active[static_cast<std::size_t>(index)] == 0)
      refuse("contact " + in_quotes(name) + " does not hold in this stage, so it has no force");
    stage.solves_contacts = true;
    return index;
  }
  void unit_quaternion(int first) const {
    if (!term.signal.is_constant()) return;
    Eigen::VectorXd value(term.signal.size());
    term.signal.at(0.0, value);
    const double length = value.segment(first, 4).norm();
    if (std::abs(length - 1.0) > 1e-6)
      refuse("the target's quaternion has length " + number(length) + "; wanted 1");
  }

  void unit_configuration() const {
    if (!term.signal.is_constant()) return;
    Eigen::VectorXd value(term.signal.size());
    term.signal.at(0.0, value);
    try {
      check_configuration(problem.model, value.head(layout().nq), "the target");
    } catch (const Error& error) {
      refuse(error.what());
    }
  }

  void operator()(const residual::State& r) {
    term.rows = layout().ndx();
    target(r.target, layout().nx(), spec.initial_state);
    unit_configuration();
    StateDifference state{&problem.tree, layout().nq, layout().filtered, {}, problem.blocks};
    std::vector<char> in_block(static_cast<std::size_t>(layout().ndx()), 0);
    for (const TangentBlock& block : problem.blocks)
      std::fill_n(in_block.begin() + block.first, block.size, char{1});
    // One diagonal run between each two blocks, in the order that evaluate writes them.
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
      std::vector<int> columns(static_cast<std::size_t>(block.size));
      std::iota(columns.begin(), columns.end(), layout().column_q() + block.first);
      term.blocks.push_back({block.first, block.size, columns, false});
    }
    term.residual = state;
  }

  void select(Selection::Source source, std::vector<int> entries, int first_column,
              const std::vector<int>& columns, const Signal& signal) {
    term.rows = static_cast<int>(entries.size());
    if (term.rows == 0) refuse("has no rows");
    zero_target(signal, term.rows);
    JacobianBlock block{0, term.rows, {}, true};
    for (const int c : columns) block.columns.push_back(first_column + c);
    term.blocks.push_back(block);
    term.residual = Selection{source, std::move(entries)};
  }
  void operator()(const residual::Control& r) {
    if (stage.nu == 0) refuse("there is no control here");
    std::vector<int> entries(static_cast<std::size_t>(layout().nu));
    std::iota(entries.begin(), entries.end(), 0);
    select(Selection::Source::U, entries, 0, entries, r.target);
  }
  const Joint& joint(const std::string& name) const {
    try {
      const Model& model = problem.model;
      const Joint& found = model.joints[static_cast<std::size_t>(model.joint_index(name))];
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
               "; wanted a revolute or prismatic one");
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
  /// Of these joints, or of all that have one.
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
    const bool in_state = layout().filtered > 0;
    if (!in_state && stage.nu == 0) refuse("there is no control here");
    select(in_state ? Selection::Source::TorqueState : Selection::Source::U, entries,
           in_state ? layout().column_tau() : 0, entries, r.target);
  }
  void operator()(const residual::JointTorqueRate& r) {
    if (!spec.torque_model)
      refuse(
          "torques that are the control have no rate; wanted a torque model in the problem, which "
          "puts them into the state, one more entry per driven joint");
    if (stage.nu == 0) refuse("there is no control here, so torques have no rate");
    TorqueRate rate{spec.torque_model->cutoff, actuators(r.joints)};
    term.rows = static_cast<int>(rate.entries.size());
    if (term.rows == 0) refuse("has no rows");
    zero_target(r.target, term.rows);
    for (int i = 0; i < term.rows; ++i)
      term.blocks.push_back(
          {i, 1, {rate.entries[i], layout().column_tau() + rate.entries[i]}, false});
    term.residual = std::move(rate);
  }

  /// Of a frame in a reference with another origin.
  FramePositionError position(const std::string& name, const Reference& reference) {
    const int f = frame(name);
    FramePositionError result{f, view(f, reference)};
    if (result.view.reference.at_tool)
      refuse(
          "the reference's origin is the frame itself, which is nowhere else; wanted the world or "
          "another frame");
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
    term.residual = FrameRotationError{f};
    dense_block(3, support_columns(f));
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
  void needs(int c, Directions wanted) const {
    const Directions held = problem.contacts.contacts()[c].spec.directions;
    if ((held.bits & wanted.bits) != wanted.bits)
      refuse("contact " + in_quotes(problem.contacts.contacts()[c].spec.name) + " holds " +
             held.text() + "; wanted " + wanted.text() + " among them");
  }
  void operator()(const residual::FrictionCone& r) {
    const int c = contact(r.contact);
    needs(c, Directions::linear());
    if (!(r.friction > 0.0) || !std::isfinite(r.friction))
      refuse("friction is " + number(r.friction) + "; wanted a number above 0");
    if (r.normal < 0 || r.normal > 2)
      refuse("normal is " + std::to_string(r.normal) + "; wanted 0, 1 or 2");
    term.rows = 2;
    term.residual = ConeMargin{wrench(c, r.reference), r.friction, r.normal};
    dense_block(2, all_columns());
  }
  void operator()(const residual::CenterOfPressure& r) {
    const int c = contact(r.contact);
    needs(c, Directions::pad_z());
    if (!(r.half_x > 0.0 && r.half_y > 0.0) || !std::isfinite(r.half_x * r.half_y))
      refuse("half lengths are " + number(r.half_x) + " and " + number(r.half_y) +
             " m; wanted positive numbers");
    term.rows = 4;
    term.residual = PressureMargin{wrench(c, Reference::local()), r.half_x, r.half_y};
    dense_block(4, all_columns());
  }

  void operator()(const residual::CenterOfMass& r) {
    term.rows = 3;
    target(r.target, 3, {});
    stage.has_momentum = true;
    term.residual = ComError{};
    std::vector<int> columns(static_cast<std::size_t>(layout().nv));
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
    std::vector<int> columns(static_cast<std::size_t>(layout().nv));
    std::iota(columns.begin(), columns.end(), layout().column_q());
    dense_block(term.rows, columns);
  }
  void operator()(const residual::CentroidalMomentum& r) {
    term.rows = 6;
    zero_target(r.target, 6);
    stage.has_momentum = true;
    term.residual = MomentumError{};
    std::vector<int> columns(static_cast<std::size_t>(2 * layout().nv));
    std::iota(columns.begin(), columns.end(), layout().column_q());
    dense_block(6, columns);
  }
  void operator()(const residual::Custom& r) {
    if (r.rows < 1) refuse("has " + std::to_string(r.rows) + " rows; wanted at least 1");
    if (!r.value) refuse("has no value function");
    CustomResidual compiled{r, {}, {}};
    for (const std::string& name : r.frames) compiled.frames.push_back(frame(name));
    for (const std::string& name : r.contacts) compiled.contacts.push_back(contact(name));
    term.rows = r.rows;
    term.residual = compiled;
    dense_block(r.rows, all_columns());
  }

  bool is_margin() const {
    return std::holds_alternative<residual::FrictionCone>(residual) ||
           std::holds_alternative<residual::CenterOfPressure>(residual) ||
           std::holds_alternative<residual::SupportMargin>(residual);
  }
  void finish_penalty(const CostTerm& cost) {
    const Penalty penalty =
        cost.penalty.value_or(is_margin() ? Penalty::at_least(0.0) : Penalty::square());
    term.penalty = penalty.kind;
    term.width = penalty.width;
    if (!(penalty.width > 0.0) || !std::isfinite(penalty.width))
      refuse("the penalty's width is " + number(penalty.width) + "; wanted a positive number");
    finish_limits(penalty.lower, penalty.upper, "the penalty's ");
  }
  /// Lower and upper per row; `of` whose they are, for messages.
  void finish_limits(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                     const std::string& of) {
    const auto rows = static_cast<std::size_t>(term.rows);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto limits = [&](const Eigen::VectorXd& given, double none, const char* name) {
      if (given.size() > 1 && given.size() != term.rows)
        refuse(of + std::string(name) + " limit has " + std::to_string(given.size()) +
               " entries; wanted 1 or " + std::to_string(term.rows));
      std::vector<double> result(rows, given.size() == 1 ? given[0] : none);
      if (given.size() == term.rows) result.assign(given.begin(), given.end());
      if (std::any_of(result.begin(), result.end(), [](double x) { return std::isnan(x); }))
        refuse(of + std::string(name) + " limit holds a NaN");
      return result;
    };
    term.lower = limits(lower, -infinity, "lower");
    term.upper = limits(upper, infinity, "upper");
    for (std::size_t i = 0; i < rows; ++i) {
      if (term.lower[i] == infinity || term.upper[i] == -infinity)
        refuse(of + "limits of row " + std::to_string(i) + " leave nothing inside");
      if (term.lower[i] > term.upper[i])
        refuse(of + "lower limit " + number(term.lower[i]) + " is above the upper one " +
               number(term.upper[i]));
    }
  }
  void finish_constraint(const Constraint& constraint) {
    Eigen::VectorXd lower = constraint.lower;
    if (lower.size() == 0 && constraint.upper.size() == 0) {
      if (!is_margin()) refuse("has no limits; wanted a lower or an upper one, or both");
      lower = Eigen::VectorXd::Zero(1);
    }
    finish_limits(lower, constraint.upper, "the ");
    term.first_row = stage.rows();
    stage.row_lower.insert(stage.row_lower.end(), term.lower.begin(), term.lower.end());
    stage.row_upper.insert(stage.row_upper.end(), term.upper.begin(), term.upper.end());
    find_entries();
    add_row_prices(constraint, residual, term, problem, where, stage);
  }
  /// Rows that are entries of z each, another than those before: they need no coefficients.
  void find_entries() {
    std::vector<int> entries(static_cast<std::size_t>(term.rows), -1);
    const auto* selected = std::get_if<Selection>(&term.residual);
    const bool is_bounded = spec.control_lower.size() > 0 || spec.control_upper.size() > 0;
    bool alone = selected != nullptr && !(selected->source == Selection::Source::U && is_bounded);
    for (int i = 0; alone && i < term.rows; ++i) {
      const int entry =
          term.blocks[0].columns[static_cast<std::size_t>(i)] - layout().nu + stage.nu;
      const auto taken = [&](const std::vector<int>& all) {
        return std::find(all.begin(), all.end(), entry) != all.end();
      };
      alone = !taken(stage.row_entry) && !taken(entries);
      entries[static_cast<std::size_t>(i)] = entry;
    }
    if (!alone) std::fill(entries.begin(), entries.end(), -1);
    stage.row_entry.insert(stage.row_entry.end(), entries.begin(), entries.end());
    term.first_coefficients = alone ? -1 : stage.coefficient_rows;
    if (!alone) stage.coefficient_rows += term.rows;
  }
  void finish_weights(const CostTerm& cost) {
    if (!(cost.weight >= 0.0) || !std::isfinite(cost.weight))
      refuse("weight is " + number(cost.weight) + "; wanted a number of at least 0");
    if (cost.weights.size() != 0 && cost.weights.size() != term.rows)
      refuse("has " + std::to_string(cost.weights.size()) + " row weights; wanted " +
             std::to_string(term.rows));
    const double scale = cost.weight * (stage.terminal || stage.impact ? 1.0 : stage.step);
    for (int i = 0; i < term.rows; ++i) {
      const double w = cost.weights.size() == 0 ? 1.0 : cost.weights[i];
      if (!(w >= 0.0) || !std::isfinite(w))
        refuse("row weight " + std::to_string(i) + " is " + number(w) +
               "; wanted a number of at least 0");
      term.weights.push_back(scale * w);
    }
  }
};

}  // namespace

void compile_terms(const ProblemSpec& spec, const CompiledProblem& problem,
                   const std::vector<CostTerm>& costs, const std::vector<Constraint>& constraints,
                   const std::string& place, CompiledStage& stage) {
  const auto add = [&](const auto& given, const char* kind, const auto& finish) {
    std::string name = given.name.empty() ? name_of(given.residual) : given.name;
    TermBuilder builder{spec,  problem, given.residual,
                        stage, {},      place + ", " + kind + " " + in_quotes(name)};
    for (const CompiledTerm& other : stage.terms)
      if (other.name == name) builder.refuse("the name is used twice in this stage");
    builder.term.name = std::move(name);
    std::visit(builder, given.residual);
    finish(builder);
    CompiledTerm& term = builder.term;
    for (const JacobianBlock& block : term.blocks) term.jacobian_size += block.size();
    term.target = stage.targets;
    stage.targets += term.target_size;
    stage.terms.push_back(std::move(term));
  };
  for (const CostTerm& cost : costs)
    add(cost, "term", [&](TermBuilder& builder) {
      builder.finish_penalty(cost);
      builder.finish_weights(cost);
    });
  stage.costs = stage.terms.size();
  for (const Constraint& constraint : constraints)
    add(constraint, "constraint",
        [&](TermBuilder& builder) { builder.finish_constraint(constraint); });
}

}  // namespace burnish::ocp
