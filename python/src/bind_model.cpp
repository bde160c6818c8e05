// Bindings of robots: descriptions, compiled models, configurations.
#include "bind.hpp"
#include "burnish/mjcf/mjcf.hpp"
#include "burnish/model/joint_order.hpp"
#include "burnish/model/state.hpp"
#include "burnish/urdf/urdf.hpp"
#include "specs_model.hpp"

namespace burnish::python {

namespace {

// Docstrings.

constexpr const char* load_robot_doc = R"(Loads a robot.

Parameters
----------
name : str
    One of: a URDF or MJCF file ("arm.urdf", "arm.xml") or a pipe; a settings file
    ("robots/talos/robot.yaml") or its folder; the name of a robot of the library ("talos", "arm7",
    "crane", "quadruped", "pendulum"). A variant is appended as in "talos:right_arm".
overrides : RobotOverrides, optional
    Changes to the settings.

Returns
-------
Robot
    Robot; its `warnings` has one sentence for each suspicious value.

Raises
------
Error
    If a file is invalid; the message has all problems of a URDF file. With strict overrides, also
    for warnings.)";

constexpr const char* configuration_doc = R"(Makes a configuration from a posture.

Parameters
----------
model : Model
posture : dict of str to list of float
    Joint coordinates by joint name. Other joints have their neutral values.

Returns
-------
ndarray, shape (nq,)

Raises
------
Error
    If a name is unknown, or a joint has the wrong number of coordinates.)";

constexpr const char* integrate_doc =
    R"(Computes q (+) dq: each joint moves with its velocity dq for unit time.

Parameters
----------
model : Model
q : array_like, shape (nq,) or (n, nq)
    Configuration, or one per row.
dq : array_like, shape (nv,) or (n, nv)
    Tangent vector, or one per row.

Returns
-------
ndarray, shape (nq,) or (n, nq)

Raises
------
Error
    If the sizes are wrong.)";

constexpr const char* difference_doc =
    R"(Computes the dq with q0 (+) dq = q1, the shortest one for rotations.

Parameters
----------
model : Model
q0, q1 : array_like, shape (nq,) or (n, nq)
    Configurations, or one per row.

Returns
-------
ndarray, shape (nv,) or (n, nv)

Raises
------
Error
    If the sizes are wrong.)";

constexpr const char* tangent_map_doc = R"(Computes d(q (+) dq)/d(dq) at dq = 0.

Parameters
----------
model : Model
q : array_like, shape (nq,)
    Configuration.

Returns
-------
ndarray, shape (nq, nv))";

constexpr const char* normalized_doc = R"(Scales quaternions and (cos, sin) pairs to unit length.

Parameters
----------
model : Model
q : array_like, shape (nq,)
    Configuration.

Returns
-------
ndarray, shape (nq,))";

constexpr const char* random_configuration_doc =
    R"(Draws random configurations, uniform within position limits.

Joints without limits use +-pi or +-1 m. Rotations are uniform.

Parameters
----------
model : Model
seed : int
    Seed; the result is equal on every machine.
count : int, optional
    Number of configurations.

Returns
-------
ndarray, shape (nq,) or (count, nq))";

constexpr const char* check_configuration_doc = R"(Checks a configuration.

Parameters
----------
model : Model
q : array_like, shape (nq,)
argument : str
    Name of q in messages.

Raises
------
Error
    If q has a wrong size, an entry that is not finite, or a quaternion that is not normalized.)";

constexpr const char* check_tangent_doc = R"(Checks a tangent vector.

Parameters
----------
model : Model
v : array_like, shape (nv,)
argument : str
    Name of v in messages.

Raises
------
Error
    If v does not have nv finite entries.)";

constexpr const char* build_model_doc = R"(Compiles a tree.

Parameters
----------
tree : TreeSpec
options : ModelOptions, optional

Returns
-------
Model
    Model; its `warnings` has one sentence for each suspicious value.

Raises
------
Error
    If the tree is invalid; the message has the source, the element and the reason of each problem.
    With strict options, also for warnings.)";

constexpr const char* read_urdf_doc = R"(Reads a URDF file.

Parameters
----------
file : str or Path

Returns
-------
TreeSpec

Raises
------
Error
    If the file is invalid.)";

constexpr const char* parse_urdf_doc = R"(Reads a URDF text.

Parameters
----------
xml : str
source : str
    Name of the text in messages.

Returns
-------
TreeSpec

Raises
------
Error
    If the text is invalid.)";

constexpr const char* read_mjcf_doc = R"(Reads an MJCF file and the files that it includes.

Parameters
----------
file : str or Path

Returns
-------
TreeSpec
    Tree with the root link "world".

Raises
------
Error
    If the file is invalid.)";

constexpr const char* parse_mjcf_doc = R"(Reads an MJCF text, without opening other files.

Parameters
----------
xml : str
source : str
    Name of the text in messages.

Returns
-------
TreeSpec

Raises
------
Error
    If the text is invalid.)";

/// Calls visit(name, member) for all members of a model, for pickling.
template <class Visit>
void for_each_member(Visit&& visit) {
  visit("name", &Model::name);
  visit("joints", &Model::joints);
  visit("frames", &Model::frames);
  visit("visuals", &Model::visuals);
  visit("loops", &Model::loops);
  visit("nq", &Model::nq);
  visit("nv", &Model::nv);
  visit("gravity", &Model::gravity);
  visit("q_neutral", &Model::q_neutral);
  visit("q_lower", &Model::q_lower);
  visit("q_upper", &Model::q_upper);
  visit("velocity_limit", &Model::velocity_limit);
  visit("effort_limit", &Model::effort_limit);
  visit("damping", &Model::damping);
  visit("friction", &Model::friction);
  visit("armature", &Model::armature);
  visit("stiffness", &Model::stiffness);
  visit("spring_rest", &Model::spring_rest);
  visit("tendons", &Model::tendons);
  visit("joint_of_v", &Model::joint_of_v);
  visit("parent_of_v", &Model::parent_of_v);
  visit("locked_joints", &Model::locked_joints);
  visit("file_joints", &Model::file_joints);
  visit("warnings", &Model::warnings);
  visit("notes", &Model::notes);
  visit("support_entries", &Model::support_entries);
  visit("support_begin", &Model::support_begin);
}

py::dict model_state(const Model& model) {
  py::dict state;
  for_each_member([&](const char* name, auto member) { state[name] = py::cast(model.*member); });
  return state;
}

Model model_of(const py::dict& state) {
  Model model;
  for_each_member([&](const char* name, auto member) {
    using Value = std::remove_reference_t<decltype(model.*member)>;
    model.*member = py::cast<Value>(state[name]);
  });
  return model;
}

/// Returns whether all members of two objects are equal.
bool same(const py::object& a, const py::object& b) {
  return py::module_::import("burnish._spec").attr("_same")(a, b).cast<bool>();
}
bool equal(const Model& a, const Model& b) {
  return &a == &b || (a.name == b.name && a.nq == b.nq && same(model_state(a), model_state(b)));
}
bool equal(const Robot& a, const Robot& b) {
  return equal(a.model, b.model) && a.postures == b.postures &&
         a.default_posture == b.default_posture &&
         same(py::cast(a.collisions), py::cast(b.collisions)) && a.warnings == b.warnings &&
         a.notes == b.notes;
}
/// Returns whether two objects of one class are equal; NotImplemented for an object of another
/// class.
template <class Machine>
py::object equals(const Machine& self, const py::object& other) {
  if (!py::isinstance<Machine>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
  return py::bool_(equal(self, py::cast<const Machine&>(other)));
}

/// Returns f(a, b) (`size` entries) for two vectors, or for each pair of rows of two arrays.
template <class Function>
py::array_t<double> by_rows(const py::array_t<double, py::array::c_style | py::array::forcecast>& a,
                            const py::array_t<double, py::array::c_style | py::array::forcecast>& b,
                            Eigen::Index size, const char* what, Function&& f) {
  const auto vector = [](const auto& array, py::ssize_t row) {
    const py::ssize_t entries = array.shape(array.ndim() - 1);
    return Eigen::Map<const Eigen::VectorXd>(array.data() + row * entries, entries);
  };
  if (a.ndim() == 1 && b.ndim() == 1)
    return py::cast(Eigen::VectorXd(f(vector(a, 0), vector(b, 0))));
  if (a.ndim() != 2 || b.ndim() != 2 || a.shape(0) != b.shape(0))
    throw Error(
        std::string(what) +
        ": the arrays do not match; wanted two vectors, or two arrays with equal numbers of rows");
  py::array_t<double> result({a.shape(0), static_cast<py::ssize_t>(size)});
  for (py::ssize_t row = 0; row < a.shape(0); ++row)
    Eigen::Map<Eigen::VectorXd>(result.mutable_data(row), size) = f(vector(a, row), vector(b, row));
  return result;
}

py::array_t<double> random_rows(const Model& model, std::uint64_t seed, std::optional<int> count) {
  std::mt19937_64 generator(seed);
  if (!count) return py::cast(random_configuration(model, generator));
  if (*count < 0)
    throw Error("random_configuration: count is " + std::to_string(*count) +
                "; wanted a number of at least 0");
  py::array_t<double> states(
      {static_cast<py::ssize_t>(*count), static_cast<py::ssize_t>(model.nq)});
  for (int row = 0; row < *count; ++row)
    Eigen::Map<Eigen::VectorXd>(states.mutable_data(row), model.nq) =
        random_configuration(model, generator);
  return states;
}

void bind_robot(py::module_& m) {
  py::class_<Robot>(m, "Robot", "Compiled robot with its named postures.")
      .def_property_readonly(
          "model", [](const Robot& robot) -> const Model& { return robot.model; },
          py::return_value_policy::reference_internal, "Compiled model.")
      .def_property_readonly(
          "postures", [](const Robot& robot) { return robot.postures; },
          "Named postures: joint coordinates by joint name.")
      .def_property_readonly(
          "default_posture", [](const Robot& robot) { return robot.default_posture; },
          "Name of the default posture, or empty.")
      .def_property_readonly(
          "collisions", [](const Robot& robot) { return robot.collisions; },
          "Collision geometry of a URDF file; dynamics does not use it.")
      .def_property_readonly(
          "warnings", [](const Robot& robot) { return robot.warnings; },
          "Warnings about the files of the robot, one sentence each.")
      .def_property_readonly(
          "notes", [](const Robot& robot) { return robot.notes; },
          "Notes about content of the files that dynamics does not need, one sentence each. "
          "Strict overrides do not reject them.")
      .def("posture", &Robot::posture, py::arg("name"),
           "Returns the configuration (nq,) of a named posture, with closed loops. Raises Error "
           "for an unknown name, with the nearest name, and if loops cannot be closed.")
      .def("reference_configuration", &Robot::reference_configuration,
           "Returns the configuration (nq,) of the default posture, or else the neutral one, with "
           "closed loops.")
      .def("__repr__",
           [](const Robot& robot) {
             return "<Robot '" + robot.model.name + "': " + std::to_string(robot.postures.size()) +
                    " postures>";
           })
      .def("__eq__", &equals<Robot>)
      .def("__copy__", [](const Robot& robot) { return robot; })
      .def("__deepcopy__", [](const Robot& robot, const py::dict&) { return robot; })
      .def(py::pickle(
          [](const Robot& robot) {
            return py::make_tuple(model_state(robot.model), robot.postures, robot.default_posture,
                                  robot.collisions, robot.warnings, robot.notes);
          },
          [](const py::tuple& state) {
            return Robot{model_of(state[0]),
                         py::cast<std::map<std::string, Posture>>(state[1]),
                         py::cast<std::string>(state[2]),
                         py::cast<std::vector<Visual>>(state[3]),
                         py::cast<std::vector<std::string>>(state[4]),
                         py::cast<std::vector<std::string>>(state[5])};
          }));
}

void bind_loading(py::module_& m) {
  m.def(
      "load_robot",
      [](const std::string& name, const std::optional<RobotOverrides>& overrides) {
        return load_robot(name, overrides.value_or(RobotOverrides{}));
      },
      py::arg("name"), py::arg("overrides") = py::none(), py::call_guard<py::gil_scoped_release>(),
      load_robot_doc);
  m.def("robot_search_path", &robot_search_path,
        "Returns the folders in which load_robot() searches for names, in order.");
}

void bind_configurations(py::module_& m) {
  m.def("configuration", &configuration, py::arg("model"), py::arg("posture"), configuration_doc);
  m.def(
      "integrate",
      [](const Model& model,
         const py::array_t<double, py::array::c_style | py::array::forcecast>& q,
         const py::array_t<double, py::array::c_style | py::array::forcecast>& dq) {
        return by_rows(q, dq, model.nq, "integrate",
                       [&](const auto& a, const auto& b) { return integrate(model, a, b); });
      },
      py::arg("model"), py::arg("q"), py::arg("dq"), integrate_doc);
  m.def(
      "difference",
      [](const Model& model,
         const py::array_t<double, py::array::c_style | py::array::forcecast>& q0,
         const py::array_t<double, py::array::c_style | py::array::forcecast>& q1) {
        return by_rows(q0, q1, model.nv, "difference",
                       [&](const auto& a, const auto& b) { return difference(model, a, b); });
      },
      py::arg("model"), py::arg("q0"), py::arg("q1"), difference_doc);
  m.def("tangent_map", &tangent_map, py::arg("model"), py::arg("q"), tangent_map_doc);
  m.def("normalized", &normalized, py::arg("model"), py::arg("q"), normalized_doc);
  m.def("random_configuration", &random_rows, py::arg("model"), py::arg("seed") = 0,
        py::arg("count") = py::none(), random_configuration_doc);
  m.def(
      "check_configuration",
      [](const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
         const std::string& argument) { check_configuration(model, q, argument); },
      py::arg("model"), py::arg("q"), py::arg("argument") = "q", check_configuration_doc);
  m.def(
      "check_tangent",
      [](const Model& model, const Eigen::Ref<const Eigen::VectorXd>& v,
         const std::string& argument) { check_tangent(model, v, argument); },
      py::arg("model"), py::arg("v"), py::arg("argument") = "v", check_tangent_doc);
}

void bind_joint_order(py::module_& m) {
  py::class_<JointOrder>(
      m, "JointOrder",
      "Maps q, v and tau of another program, in the order of its joint names, to those of a "
      "model, and back. The names may include mimic joints and locked joints, for which the model "
      "has no entries.")
      .def(py::init([](const Model& model, std::vector<std::string> names,
                       std::optional<JointConvention> convention) {
             return JointOrder(model, std::move(names),
                               convention.value_or(JointConvention::Angles));
           }),
           py::arg("model"), py::arg("names"), py::arg("convention") = py::none(),
           "`names` has the joints in order. `convention` is \"angles\" (None), \"same\" or "
           "\"mujoco\". Raises Error for an unknown joint, with the nearest name, and for an "
           "empty or repeated name.")
      .def_static("mujoco", &JointOrder::mujoco, py::arg("model"),
                  "Makes the order and values of MuJoCo's qpos, qvel and qfrc for a model from "
                  "MJCF.")
      .def_property_readonly("names", &JointOrder::names, "Names of the joints, in order.")
      .def_property_readonly("nq", &JointOrder::nq, "Number of entries of a position vector.")
      .def_property_readonly("nv", &JointOrder::nv,
                             "Number of entries of a velocity or torque vector.")
      .def("q_from", &JointOrder::q_from, py::arg("positions"),
           py::arg("tolerance") = coupling_tolerance,
           "Returns q of the model (nq,). Raises Error for a wrong size, an entry that is not "
           "finite, a missing joint of the model, and a mimic or locked joint that differs from "
           "its value in the model by more than `tolerance` [rad or m].")
      .def("q_to", &JointOrder::q_to, py::arg("q"),
           "Returns positions in this order. Mimic joints and locked joints have their values in "
           "the model.")
      .def("v_from", &JointOrder::v_from, py::arg("velocities"), py::arg("q"),
           "Returns v of the model (nv,) at its configuration q. Velocities of mimic joints and "
           "locked joints are ignored.")
      .def("v_to", &JointOrder::v_to, py::arg("v"), py::arg("q"),
           "Returns velocities in this order. Velocities of locked joints are zero; those of "
           "mimic joints follow their leading joints.")
      .def("tau_from", &JointOrder::tau_from, py::arg("torques"), py::arg("q"),
           "Returns tau of the model (nv,) at its configuration q; missing joints have zero "
           "torque. The torque of a mimic joint, times its multiplier, is added to that of its "
           "leading joint.")
      .def("tau_to", &JointOrder::tau_to, py::arg("tau"), py::arg("q"),
           "Returns torques in this order. Torques of mimic joints and locked joints are zero.")
      .def("__repr__", [](const JointOrder& order) {
        return "<JointOrder: " + std::to_string(order.names().size()) +
               " joints, nq = " + std::to_string(order.nq()) +
               ", nv = " + std::to_string(order.nv()) + ">";
      });
}

void bind_descriptions(py::module_& m) {
  m.def(
      "build_model",
      [](const TreeSpec& tree, const std::optional<ModelOptions>& options) {
        return build_model(tree, options.value_or(ModelOptions{}));
      },
      py::arg("tree"), py::arg("options") = py::none(), py::call_guard<py::gil_scoped_release>(),
      build_model_doc);
  m.def("read_urdf", &read_urdf, py::arg("file"), read_urdf_doc);
  m.def("parse_urdf", &parse_urdf, py::arg("xml"), py::arg("source") = "<string>", parse_urdf_doc);
  m.def("read_mjcf", &read_mjcf, py::arg("file"), read_mjcf_doc);
  m.def("parse_mjcf", &parse_mjcf, py::arg("xml"), py::arg("source") = "<string>", parse_mjcf_doc);
}

void bind_vectors(py::class_<Model>& model) {
  const auto vector = [&](const char* name, Eigen::VectorXd Model::*member, const char* text) {
    model.def_property_readonly(
        name, [member](const Model& self) { return self.*member; }, text);
  };
  vector("q_neutral", &Model::q_neutral,
         "Neutral configuration, shape (nq,): zero angles, unit quaternions, base at its "
         "placement.");
  vector("q_lower", &Model::q_lower, "(nq,): position limits, infinite where there are none.");
  vector("q_upper", &Model::q_upper, "(nq,): position limits, infinite where there are none.");
  vector("velocity_limit", &Model::velocity_limit,
         "Velocity limits, shape (nv,) [rad/s or m/s]; infinite without a limit.");
  vector("effort_limit", &Model::effort_limit,
         "Effort limits, shape (nv,) [Nm or N]; infinite without a limit.");
  vector("damping", &Model::damping, "Viscous joint friction, shape (nv,) [Nms/rad or Ns/m].");
  vector("friction", &Model::friction, "Coulomb joint friction, shape (nv,) [Nm or N].");
  vector("armature", &Model::armature, "Armature, shape (nv,) [kg m^2 or kg].");
  vector("stiffness", &Model::stiffness,
         "Stiffness of joint springs, shape (nv,) [Nm/rad or N/m].");
  vector("spring_rest", &Model::spring_rest,
         "Rest positions of joint springs, shape (nv,) [rad or m].");
}

void bind_look_up(py::class_<Model>& model) {
  model
      .def(
          "support",
          [](const Model& self, int body) {
            if (body < -1 || body >= static_cast<int>(self.joints.size()))
              throw Error("support: there is no body " + std::to_string(body) +
                          "; wanted the index of a body of the robot, or -1 for the world");
            const auto entries = self.support(body);
            return std::vector<int>(entries.begin(), entries.end());
          },
          py::arg("body"),
          "Returns the indices of the entries of v that move a body, ascending; empty for the "
          "world (-1).")
      .def("frame_index", &Model::frame_index, py::arg("name"),
           "Index by name. Raises Error with the nearest known name.")
      .def("joint_index", &Model::joint_index, py::arg("name"),
           "Index by name. Raises Error with the nearest known name.")
      .def("has_frame", &Model::has_frame, py::arg("name"),
           "Returns whether the model has a frame of this name.");
}

void bind_names(py::class_<Model>& model) {
  model
      .def_property_readonly(
          "v_names",
          [](const Model& self) {
            std::vector<std::string> names;
            for (int k = 0; k < self.nv; ++k) names.push_back(self.v_name(k));
            return names;
          },
          "Names of the entries of v.")
      .def_property_readonly(
          "q_names",
          [](const Model& self) {
            std::vector<std::string> names;
            for (int k = 0; k < self.nq; ++k) names.push_back(self.q_name(k));
            return names;
          },
          "Names of the entries of q.");
}

}  // namespace

void bind_model(py::module_& m) {
  py::class_<Model> model(
      m, "Model",
      "Compiled robot: joints in depth-first order, bodies, frames, limits. A model is constant, "
      "and can be shared between threads, copied and pickled.");
  model.def_readonly("name", &Model::name, "Name of the robot.")
      .def_readonly("nq", &Model::nq, "Number of entries of a configuration.")
      .def_readonly("nv", &Model::nv, "Number of entries of a velocity.")
      .def_property_readonly(
          "joints", [](const Model& self) { return self.joints; },
          "Moving joints, in depth-first order.")
      .def_property_readonly(
          "frames", [](const Model& self) { return self.frames; }, "Frames of the model.")
      .def_property_readonly(
          "tendons", [](const Model& self) { return self.tendons; },
          "Tendons with a spring or a damper on a moving joint.")
      .def_property_readonly(
          "visuals", [](const Model& self) { return self.visuals; }, "Visual geometry.")
      .def_property_readonly(
          "loops", [](const Model& self) { return self.loops; }, "Loop closures.")
      .def_property_readonly(
          "gravity", [](const Model& self) { return self.gravity; },
          "Gravity in the world, shape (3,) [m/s^2].")
      .def_readonly("locked_joints", &Model::locked_joints,
                    "Names of joints of the description that are locked.")
      .def_property_readonly(
          "file_joints", [](const Model& self) { return self.file_joints; },
          "All joints of the description with a position, including mimic joints and locked "
          "joints, in the order of `joints`.")
      .def_readonly("warnings", &Model::warnings,
                    "Warnings about the description, one sentence each.")
      .def_readonly("notes", &Model::notes,
                    "Notes about content of the description that dynamics does not need, one "
                    "sentence each.")
      .def_property_readonly("total_mass", &Model::total_mass,
                             "Total mass of the moving bodies [kg].");
  bind_names(model);
  bind_look_up(model);
  bind_vectors(model);
  model
      .def("__repr__",
           [](const Model& self) {
             return "<Model '" + self.name + "': " + std::to_string(self.joints.size()) +
                    " joints, nq = " + std::to_string(self.nq) +
                    ", nv = " + std::to_string(self.nv) + ">";
           })
      .def("__eq__", &equals<Model>)
      .def("__copy__", [](const Model& self) { return self; })
      .def("__deepcopy__", [](const Model& self, const py::dict&) { return self; })
      .def(py::pickle(&model_state, &model_of));

  bind_descriptions(m);
  bind_configurations(m);
  bind_joint_order(m);
  bind_robot(m);
  bind_loading(m);
}

}  // namespace burnish::python
