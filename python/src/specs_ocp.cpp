#include "specs_ocp.hpp"

#include "node_handle.hpp"

namespace burnish::python {

namespace {

/// A function of a residual that Python gave.
struct PythonResidual {
  Kept function;
  std::shared_ptr<const residual::Custom> names;  ///< its name, frames and contacts

  /// Under the interpreter's lock.
  Numbers call(const NodeView& at, bool with_derivatives) const {
    const NodeLease lease(at, *names, with_derivatives);
    return numbers_of(function.get()(lease.object()));
  }
  [[noreturn]] void refuse(const char* what, const Numbers& numbers,
                           const std::string& wanted_shape) const {
    throw Error("residual '" + names->name + "': " + what + " gave " + what_came(numbers) +
                "; wanted is " + wanted_shape);
  }
};

struct PythonValue : PythonResidual {
  void operator()(const NodeView& at, Eigen::Ref<Eigen::VectorXd> out) const {
    const py::gil_scoped_acquire lock;
    const Numbers numbers = call(at, false);
    const bool fits = numbers && numbers.size() == out.size() && numbers.ndim() <= 1;
    if (!fits) refuse("value", numbers, "(" + std::to_string(out.size()) + ",)");
    out = Eigen::Map<const Eigen::VectorXd>(numbers.data(), out.size());
  }
};

struct PythonJacobian : PythonResidual {
  void operator()(const NodeView& at, Eigen::Ref<RowMatrix> out) const {
    const py::gil_scoped_acquire lock;
    const Numbers numbers = call(at, true);
    const bool row = numbers && numbers.ndim() == 1 && out.rows() == 1;
    const bool fits = numbers && numbers.size() == out.size() &&
                      (row || (numbers.ndim() == 2 && numbers.shape(0) == out.rows()));
    if (!fits)
      refuse("jacobian", numbers,
             "(" + std::to_string(out.rows()) + ", " + std::to_string(out.cols()) + ")");
    out = Eigen::Map<const RowMatrix>(numbers.data(), out.rows(), out.cols());
  }
};

std::string wanted_function() { return "a function of a NodeView, or None"; }

/// A residual's function: the one that Python gave, or one of Python's around C++'s. `empty` makes
/// what C++'s writes to.
template <class Given, class Function, class Empty>
py::object function_for_python(const Function& function, Empty empty) {
  if (!function) return py::none();
  if (const auto* ours = function.template target<Given>()) return ours->function.get();
  return py::cpp_function([function, empty](const NodeHandle& at) {
    auto out = empty(at);
    function(at.view(), out);
    return out;
  });
}

/// Into `function` a Given of what came from Python, or nothing for None.
template <class Given, class Function>
bool function_from_python(const residual::Custom& custom, py::handle value, Function& function) {
  if (value.is_none()) {
    function = nullptr;
  } else if (PyCallable_Check(value.ptr()) != 0) {
    auto names = std::make_shared<residual::Custom>();
    names->name = custom.name;
    names->frames = custom.frames;
    names->contacts = custom.contacts;
    function = Given{Kept(py::reinterpret_borrow<py::object>(value)), names};
  } else {
    return false;
  }
  return true;
}

}  // namespace

template <>
const SpecTable& AsDataclass<residual::Custom>::table() {
  using residual::Custom;
  static const SpecTable fields =
      SpecTable("burnish.residual", "Custom")
          .field("name", &Custom::name)
          .field("rows", &Custom::rows)
          .field("frames", &Custom::frames)
          .field("contacts", &Custom::contacts)
          .field<Custom>(
              "value", wanted_function,
              [](const Custom& custom) {
                return function_for_python<PythonValue>(
                    custom.value, [rows = custom.rows](const NodeHandle& /*at*/) {
                      return Eigen::VectorXd(Eigen::VectorXd::Zero(rows));
                    });
              },
              [](Custom& custom, py::handle value) {
                return function_from_python<PythonValue>(custom, value, custom.value);
              })
          .field<Custom>(
              "jacobian", wanted_function,
              [](const Custom& custom) {
                return function_for_python<PythonJacobian>(
                    custom.jacobian, [rows = custom.rows](const NodeHandle& at) {
                      return RowMatrix(RowMatrix::Zero(rows, at.view().layout().nz()));
                    });
              },
              [](Custom& custom, py::handle value) {
                return function_from_python<PythonJacobian>(custom, value, custom.jacobian);
              });
  return fields;
}
template <>
const EnumTable& AsEnum<Penalty::Kind>::table() {
  static const EnumTable words("burnish.ocp", "PenaltyKind",
                               {"square", "barrier", "smooth_absolute", "log_barrier"});
  return words;
}
template <>
const EnumTable& AsEnum<Integrator>::table() {
  static const EnumTable words("burnish.ocp", "Integrator",
                               {"semi_implicit_euler", "runge_kutta4"});
  return words;
}
template <>
const EnumTable& AsEnum<TorqueModel::Discretization>::table() {
  static const EnumTable words("burnish.ocp", "Discretization", {"exact", "euler"});
  return words;
}
template <>
const SpecTable& AsDataclass<Penalty>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "Penalty")
                                      .field("kind", &Penalty::kind)
                                      .numbers("lower", &Penalty::lower)
                                      .numbers("upper", &Penalty::upper)
                                      .field("width", &Penalty::width);
  return fields;
}
template <>
const SpecTable& AsDataclass<residual::State>::table() {
  static const SpecTable fields =
      SpecTable("burnish.residual", "State").field("target", &residual::State::target);
  return fields;
}
template <>
const SpecTable& AsDataclass<residual::Control>::table() {
  static const SpecTable fields =
      SpecTable("burnish.residual", "Control").field("target", &residual::Control::target);
  return fields;
}
template <>
const SpecTable& AsDataclass<residual::JointPosition>::table() {
  static const SpecTable fields = SpecTable("burnish.residual", "JointPosition")
                                      .field("joints", &residual::JointPosition::joints)
                                      .field("target", &residual::JointPosition::target);
  return fields;
}
template <>
const SpecTable& AsDataclass<residual::JointVelocity>::table() {
  static const SpecTable fields = SpecTable("burnish.residual", "JointVelocity")
                                      .field("joints", &residual::JointVelocity::joints)
                                      .field("target", &residual::JointVelocity::target);
  return fields;
}
template <>
const SpecTable& AsDataclass<residual::JointTorque>::table() {
  static const SpecTable fields = SpecTable("burnish.residual", "JointTorque")
                                      .field("joints", &residual::JointTorque::joints)
                                      .field("target", &residual::JointTorque::target);
  return fields;
}
template <>
const SpecTable& AsDataclass<residual::FramePosition>::table() {
  static const SpecTable fields = SpecTable("burnish.residual", "FramePosition")
                                      .field("frame", &residual::FramePosition::frame)
                                      .field("target", &residual::FramePosition::target)
                                      .field("reference", &residual::FramePosition::reference);
  return fields;
}
template <>
const SpecTable& AsDataclass<residual::FrameRotation>::table() {
  static const SpecTable fields = SpecTable("burnish.residual", "FrameRotation")
                                      .field("frame", &residual::FrameRotation::frame)
                                      .field("target", &residual::FrameRotation::target);
  return fields;
}
template <>
const SpecTable& AsDataclass<residual::FramePlacement>::table() {
  static const SpecTable fields = SpecTable("burnish.residual", "FramePlacement")
                                      .field("frame", &residual::FramePlacement::frame)
                                      .field("target", &residual::FramePlacement::target);
  return fields;
}
template <>
const SpecTable& AsDataclass<residual::FrameVelocity>::table() {
  static const SpecTable fields = SpecTable("burnish.residual", "FrameVelocity")
                                      .field("frame", &residual::FrameVelocity::frame)
                                      .field("reference", &residual::FrameVelocity::reference)
                                      .field("target", &residual::FrameVelocity::target);
  return fields;
}
template <>
const SpecTable& AsDataclass<residual::ContactForce>::table() {
  static const SpecTable fields = SpecTable("burnish.residual", "ContactForce")
                                      .field("contact", &residual::ContactForce::contact)
                                      .field("reference", &residual::ContactForce::reference)
                                      .field("target", &residual::ContactForce::target);
  return fields;
}
template <>
const SpecTable& AsDataclass<residual::FrictionCone>::table() {
  static const SpecTable fields = SpecTable("burnish.residual", "FrictionCone")
                                      .field("contact", &residual::FrictionCone::contact)
                                      .field("friction", &residual::FrictionCone::friction)
                                      .field("normal", &residual::FrictionCone::normal)
                                      .field("reference", &residual::FrictionCone::reference);
  return fields;
}
template <>
const SpecTable& AsDataclass<residual::CenterOfPressure>::table() {
  static const SpecTable fields = SpecTable("burnish.residual", "CenterOfPressure")
                                      .field("contact", &residual::CenterOfPressure::contact)
                                      .field("half_x", &residual::CenterOfPressure::half_x)
                                      .field("half_y", &residual::CenterOfPressure::half_y);
  return fields;
}
template <>
const SpecTable& AsDataclass<residual::CenterOfMass>::table() {
  static const SpecTable fields = SpecTable("burnish.residual", "CenterOfMass")
                                      .field("target", &residual::CenterOfMass::target);
  return fields;
}
template <>
const SpecTable& AsDataclass<residual::CentroidalMomentum>::table() {
  static const SpecTable fields = SpecTable("burnish.residual", "CentroidalMomentum")
                                      .field("target", &residual::CentroidalMomentum::target);
  return fields;
}
template <>
const SpecTable& AsDataclass<Constraint>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "Constraint")
                                      .field("name", &Constraint::name)
                                      .field("residual", &Constraint::residual)
                                      .numbers("lower", &Constraint::lower)
                                      .numbers("upper", &Constraint::upper);
  return fields;
}
template <>
const SpecTable& AsDataclass<CostTerm>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "CostTerm")
                                      .field("name", &CostTerm::name)
                                      .field("residual", &CostTerm::residual)
                                      .field("weight", &CostTerm::weight)
                                      .field("weights", &CostTerm::weights)
                                      .field("penalty", &CostTerm::penalty);
  return fields;
}
template <>
const SpecTable& AsDataclass<TorqueModel>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "TorqueModel")
                                      .field("cutoff", &TorqueModel::cutoff)
                                      .field("discretization", &TorqueModel::discretization);
  return fields;
}
template <>
const SpecTable& AsDataclass<ActuationSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "ActuationSpec")
                                      .field("joints", &ActuationSpec::joints)
                                      .field("passive_torques", &ActuationSpec::passive_torques)
                                      .field("slip_velocity", &ActuationSpec::slip_velocity);
  return fields;
}
template <>
const SpecTable& AsDataclass<Stage>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "Stage")
                                      .field("name", &Stage::name)
                                      .field("contacts", &Stage::contacts)
                                      .field("costs", &Stage::costs)
                                      .field("constraints", &Stage::constraints)
                                      .field("step", &Stage::step)
                                      .field("integrator", &Stage::integrator)
                                      .field("impact", &Stage::impact);
  return fields;
}
template <>
const SpecTable& AsDataclass<HorizonSegment>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "HorizonSegment")
                                      .field("stage", &HorizonSegment::stage)
                                      .field("knots", &HorizonSegment::knots);
  return fields;
}
template <>
const SpecTable& AsDataclass<ProblemSpec>::table() {
  static const SpecTable fields =
      SpecTable("burnish.ocp", "ProblemSpec")
          .field("model", &ProblemSpec::model)
          .field("contacts", &ProblemSpec::contacts)
          .field("contact_solver", &ProblemSpec::contact_solver)
          .field("actuation", &ProblemSpec::actuation)
          .field("torque_model", &ProblemSpec::torque_model)
          .numbers("control_lower", &ProblemSpec::control_lower)
          .numbers("control_upper", &ProblemSpec::control_upper)
          .field("stages", &ProblemSpec::stages)
          .field("horizon", &ProblemSpec::horizon)
          .field("terminal", &ProblemSpec::terminal)
          .field("terminal_constraints", &ProblemSpec::terminal_constraints)
          .field("initial_state", &ProblemSpec::initial_state)
          .field("start_time", &ProblemSpec::start_time);
  return fields;
}
template <>
const SpecTable& AsDataclass<StateLayout>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "StateLayout")
                                      .field("nq", &StateLayout::nq)
                                      .field("nv", &StateLayout::nv)
                                      .field("filtered", &StateLayout::filtered)
                                      .field("nu", &StateLayout::nu)
                                      .field("actuated", &StateLayout::actuated);
  return fields;
}
template <>
const SpecTable& AsDataclass<Problem::QuasiStatic>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "QuasiStatic")
                                      .field("control", &Problem::QuasiStatic::control)
                                      .field("force", &Problem::QuasiStatic::force)
                                      .field("residual", &Problem::QuasiStatic::residual);
  return fields;
}
template <>
const SpecTable& AsDataclass<ProblemCheckOptions>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "ProblemCheckOptions")
                                      .field("states", &ProblemCheckOptions::states)
                                      .field("seed", &ProblemCheckOptions::seed)
                                      .field("tolerance", &ProblemCheckOptions::tolerance)
                                      .field("x", &ProblemCheckOptions::x)
                                      .field("u", &ProblemCheckOptions::u)
                                      .field("position", &ProblemCheckOptions::position)
                                      .field("velocity", &ProblemCheckOptions::velocity)
                                      .field("torque", &ProblemCheckOptions::torque)
                                      .field("progress", &ProblemCheckOptions::progress);
  return fields;
}
template <>
const SpecTable& AsDataclass<ProblemCheckRow>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "ProblemCheckRow")
                                      .field("stage", &ProblemCheckRow::stage)
                                      .field("term", &ProblemCheckRow::term)
                                      .field("states", &ProblemCheckRow::states)
                                      .field("worst_error", &ProblemCheckRow::worst_error)
                                      .field("worst", &ProblemCheckRow::worst)
                                      .field("pass_", &ProblemCheckRow::pass);
  return fields;
}
template <>
const SpecTable& AsDataclass<ProblemReport>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "ProblemReport")
                                      .field("robot", &ProblemReport::robot)
                                      .field("rows", &ProblemReport::rows)
                                      .field("tolerance", &ProblemReport::tolerance)
                                      .field("pass_", &ProblemReport::pass);
  return fields;
}
template <>
const SpecTable& AsDataclass<TrajectoryValues>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "TrajectoryValues")
                                      .field("costs", &TrajectoryValues::costs)
                                      .field("next_states", &TrajectoryValues::next_states)
                                      .field("statuses", &TrajectoryValues::statuses)
                                      .field("terms", &TrajectoryValues::terms);
  return fields;
}

template <>
const SpecTable& AsDataclass<TrajectoryExpansion>::table() {
  static const SpecTable fields = SpecTable("burnish.ocp", "TrajectoryExpansion")
                                      .field("costs", &TrajectoryExpansion::costs)
                                      .field("next_states", &TrajectoryExpansion::next_states)
                                      .field("statuses", &TrajectoryExpansion::statuses)
                                      .field("terms", &TrajectoryExpansion::terms)
                                      .field("gradients", &TrajectoryExpansion::gradients)
                                      .field("hessians", &TrajectoryExpansion::hessians)
                                      .field("dynamics", &TrajectoryExpansion::dynamics);
  return fields;
}

}  // namespace burnish::python
