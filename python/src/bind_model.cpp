// Robots: descriptions, compiled models, configurations.
#include "bind.hpp"
#include "burnish/mjcf/mjcf.hpp"
#include "burnish/model/joint_order.hpp"
#include "burnish/model/state.hpp"
#include "burnish/urdf/urdf.hpp"
#include "specs_model.hpp"

namespace burnish::python {

namespace {

/// Everything of a model by name, for pickling.
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
  visit("stated_joints", &Model::stated_joints);
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

/// Everything is equal, entry by entry.
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
/// Against another of the class; Python decides about the rest.
template <class Machine>
py::object equals(const Machine& self, const py::object& other) {
  if (!py::isinstance<Machine>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
  return py::bool_(equal(self, py::cast<const Machine&>(other)));
}

/// f(row of a, row of b) for one state or for rows of states; `size` entries each.
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
    throw Error(std::string(what) +
                ": wanted are two vectors, or two arrays with the same number of rows");
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
                "; wanted is a number of states");
  py::array_t<double> states(
      {static_cast<py::ssize_t>(*count), static_cast<py::ssize_t>(model.nq)});
  for (int row = 0; row < *count; ++row)
    Eigen::Map<Eigen::VectorXd>(states.mutable_data(row), model.nq) =
        random_configuration(model, generator);
  return states;
}

void bind_robot(py::module_& m) {
  py::class_<Robot>(m, "Robot", "A compiled robot with its named postures.")
      .def_property_readonly(
          "model", [](const Robot& robot) -> const Model& { return robot.model; },
          py::return_value_policy::reference_internal, "The compiled robot.")
      .def_property_readonly(
          "postures", [](const Robot& robot) { return robot.postures; },
          "Named postures: values by joint.")
      .def_property_readonly(
          "default_posture", [](const Robot& robot) { return robot.default_posture; },
          "Name in postures, or empty.")
      .def_property_readonly(
          "collisions", [](const Robot& robot) { return robot.collisions; },
          "Collision geometry of a URDF file; no dynamics uses it.")
      .def_property_readonly(
          "warnings", [](const Robot& robot) { return robot.warnings; },
          "What is odd about its files but computes, one sentence each.")
      .def_property_readonly(
          "notes", [](const Robot& robot) { return robot.notes; },
          "What its files hold that dynamics does not need, one sentence each: never refused.")
      .def("posture", &Robot::posture, py::arg("name"),
           "Configuration (nq,) of a named posture, loops closed. Raises Error with the nearest "
           "known "
           "name, and where loops cannot be closed.")
      .def("reference_configuration", &Robot::reference_configuration,
           "Configuration (nq,) of the default posture, or the neutral one when there is none, "
           "loops "
           "closed.")
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
      "Loads a robot by a URDF or MJCF file ('arm.urdf', 'arm.xml'), a settings file "
      "('robots/talos/robot.yaml'), a "
      "folder that holds one, or the name of a robot that came with the library ('talos', "
      "'talos:right_arm', 'arm7', 'crane', 'quadruped', 'pendulum'), with ':variant' behind it if "
      "wanted. A path may also be a pipe. Raises Error, with all problems of a URDF file at once; "
      "what "
      "is odd but computes is in the robot's `warnings`, and refused with strict overrides.");
  m.def("robot_search_path", &robot_search_path, "Folders searched for robots by name, in order.");
}

void bind_configurations(py::module_& m) {
  m.def("configuration", &configuration, py::arg("model"), py::arg("posture"),
        "The posture (values by joint) as a configuration (nq,): joints it doesn't name stay "
        "neutral. Raises Error for unknown names and wrong sizes.");
  m.def(
      "integrate",
      [](const Model& model,
         const py::array_t<double, py::array::c_style | py::array::forcecast>& q,
         const py::array_t<double, py::array::c_style | py::array::forcecast>& dq) {
        return by_rows(q, dq, model.nq, "integrate",
                       [&](const auto& a, const auto& b) { return integrate(model, a, b); });
      },
      py::arg("model"), py::arg("q"), py::arg("dq"),
      "q (+) dq: moves every joint along its own twist dq for unit time. q: (nq,), dq: (nv,), or "
      "(n, nq) and (n, nv). Raises Error on wrong sizes.");
  m.def(
      "difference",
      [](const Model& model,
         const py::array_t<double, py::array::c_style | py::array::forcecast>& q0,
         const py::array_t<double, py::array::c_style | py::array::forcecast>& q1) {
        return by_rows(q0, q1, model.nv, "difference",
                       [&](const auto& a, const auto& b) { return difference(model, a, b); });
      },
      py::arg("model"), py::arg("q0"), py::arg("q1"),
      "The dq with q0 (+) dq = q1, shortest for rotations: (nv,), or (n, nv) for rows of states.");
  m.def("tangent_map", &tangent_map, py::arg("model"), py::arg("q"),
        "d(q (+) dq)/d(dq) at dq = 0: (nq, nv).");
  m.def("normalized", &normalized, py::arg("model"), py::arg("q"),
        "Scales quaternions and (cos, sin) pairs to unit length.");
  m.def("random_configuration", &random_rows, py::arg("model"), py::arg("seed") = 0,
        py::arg("count") = py::none(),
        "A random configuration (nq,), or `count` of them (count, nq): uniform within position "
        "limits (+-pi or +-1 m where there are none), uniform rotations; the same for a seed on "
        "every machine.");
  m.def(
      "check_configuration",
      [](const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
         const std::string& argument) { check_configuration(model, q, argument); },
      py::arg("model"), py::arg("q"), py::arg("argument") = "q",
      "Raises Error with a sentence if q (nq,) is no configuration.");
  m.def(
      "check_tangent",
      [](const Model& model, const Eigen::Ref<const Eigen::VectorXd>& v,
         const std::string& argument) { check_tangent(model, v, argument); },
      py::arg("model"), py::arg("v"), py::arg("argument") = "v",
      "Raises Error with a sentence if v has not nv finite entries.");
}

void bind_joint_order(py::module_& m) {
  py::class_<JointOrder>(
      m, "JointOrder",
      "Maps vectors between a list of joint names and a model: q, v and tau of another program to "
      "those of the model, and back. Followers and held joints may be in the list; the model has "
      "no entries for them.")
      .def(
          py::init([](const Model& model, std::vector<std::string> names,
                      std::optional<JointConvention> convention) {
            return JointOrder(model, std::move(names),
                              convention.value_or(JointConvention::Angles));
          }),
          py::arg("model"), py::arg("names"), py::arg("convention") = py::none(),
          "Order of `names`; `convention` is \"angles\" (None), \"same\" or \"mujoco\". Raises "
          "Error with "
          "the nearest known name for a joint that the model does not have, and for a name that is "
          "empty or listed twice.")
      .def_static("mujoco", &JointOrder::mujoco, py::arg("model"),
                  "Order and values of MuJoCo's qpos, qvel and qfrc for a model that was read from "
                  "MJCF.")
      .def_property_readonly("names", &JointOrder::names, "As given.")
      .def_property_readonly("nq", &JointOrder::nq, "Entries of a vector of positions.")
      .def_property_readonly("nv", &JointOrder::nv, "Entries of a vector of velocities or torques.")
      .def("q_from", &JointOrder::q_from, py::arg("positions"),
           py::arg("tolerance") = coupling_tolerance,
           "q of the model (nq,). Raises Error for a wrong size, a number that is not finite, a "
           "joint of the model that the names leave out, and a follower or held joint that is "
           "further than `tolerance` (rad or m) from where the model has it.")
      .def("q_to", &JointOrder::q_to, py::arg("q"),
           "Positions in this order; of followers and held joints where the model has them.")
      .def("v_from", &JointOrder::v_from, py::arg("velocities"), py::arg("q"),
           "v of the model (nv,) at its configuration q. Velocities of followers and held joints "
           "are passed over.")
      .def(
          "v_to", &JointOrder::v_to, py::arg("v"), py::arg("q"),
          "Velocities in this order: of held joints zero, of followers as their leaders move them.")
      .def("tau_from", &JointOrder::tau_from, py::arg("torques"), py::arg("q"),
           "tau of the model (nv,) at its configuration q: zero for joints that the names leave "
           "out. "
           "The torque of a follower, times its multiplier, is added to its leader's.")
      .def("tau_to", &JointOrder::tau_to, py::arg("tau"), py::arg("q"),
           "Torques in this order: of followers and held joints zero.")
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
      "Compiles a tree. Raises Error naming the source, the element and the reason, with all "
      "problems "
      "at once; what is odd but computes is in the model's `warnings`, and refused with strict "
      "options.");
  m.def("read_urdf", &read_urdf, py::arg("file"), "Reads a URDF file into a TreeSpec.");
  m.def("parse_urdf", &parse_urdf, py::arg("xml"), py::arg("source") = "<string>",
        "Reads URDF from a text; `source` stands for the file's name in error sentences.");
  m.def("read_mjcf", &read_mjcf, py::arg("file"),
        "Reads an MJCF file into a TreeSpec, with what it includes; the root link is 'world'.");
  m.def("parse_mjcf", &parse_mjcf, py::arg("xml"), py::arg("source") = "<string>",
        "Reads MJCF from a text, which opens no file; `source` stands for the file's name in error "
        "sentences.");
}

void bind_vectors(py::class_<Model>& model) {
  const auto vector = [&](const char* name, Eigen::VectorXd Model::*member, const char* text) {
    model.def_property_readonly(
        name, [member](const Model& self) { return self.*member; }, text);
  };
  vector("q_neutral", &Model::q_neutral,
         "(nq,): zero angles, unit quaternions, base at its placement.");
  vector("q_lower", &Model::q_lower, "(nq,): position limits, infinite where there are none.");
  vector("q_upper", &Model::q_upper, "(nq,): position limits, infinite where there are none.");
  vector("velocity_limit", &Model::velocity_limit,
         "(nv,): rad/s or m/s, infinite where there is none.");
  vector("effort_limit", &Model::effort_limit, "(nv,): Nm or N, infinite where there is none.");
  vector("damping", &Model::damping, "(nv,): viscous, Nms/rad or Ns/m.");
  vector("friction", &Model::friction, "(nv,): Coulomb, Nm or N.");
  vector("armature", &Model::armature, "(nv,): kg m^2 or kg.");
  vector("stiffness", &Model::stiffness, "(nv,): of springs in joints, Nm/rad or N/m.");
  vector("spring_rest", &Model::spring_rest, "(nv,): where they are at rest, rad or m.");
}

void bind_look_up(py::class_<Model>& model) {
  model
      .def(
          "support",
          [](const Model& self, int body) {
            if (body < -1 || body >= static_cast<int>(self.joints.size()))
              throw Error("support: there is no body " + std::to_string(body));
            const auto entries = self.support(body);
            return std::vector<int>(entries.begin(), entries.end());
          },
          py::arg("body"), "Entries of v that move a body, ascending; none for the world (-1).")
      .def("frame_index", &Model::frame_index, py::arg("name"),
           "Index by name. Raises Error with the nearest known name.")
      .def("joint_index", &Model::joint_index, py::arg("name"),
           "Index by name. Raises Error with the nearest known name.")
      .def("has_frame", &Model::has_frame, py::arg("name"),
           "Whether there is a frame of that name.");
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
      "A compiled robot: joints in depth-first order, bodies, frames, limits. It cannot be "
      "changed; it can be shared between threads, copied and pickled.");
  model.def_readonly("name", &Model::name, "Of the robot.")
      .def_readonly("nq", &Model::nq, "Entries of a configuration.")
      .def_readonly("nv", &Model::nv, "Entries of a velocity.")
      .def_property_readonly(
          "joints", [](const Model& self) { return self.joints; }, "Moving joints, depth-first.")
      .def_property_readonly(
          "frames", [](const Model& self) { return self.frames; }, "Named frames.")
      .def_property_readonly(
          "tendons", [](const Model& self) { return self.tendons; },
          "Those with a spring or a damper on a joint that moves.")
      .def_property_readonly(
          "visuals", [](const Model& self) { return self.visuals; }, "Solids to draw.")
      .def_property_readonly(
          "loops", [](const Model& self) { return self.loops; }, "Loops that close chains.")
      .def_property_readonly(
          "gravity", [](const Model& self) { return self.gravity; }, "(3,), m/s^2, world.")
      .def_readonly("locked_joints", &Model::locked_joints,
                    "Moving joints of the description that were locked.")
      .def_property_readonly(
          "stated_joints", [](const Model& self) { return self.stated_joints; },
          "All joints with a position in the description, followers and held ones too, in the "
          "order of `joints`.")
      .def_readonly("warnings", &Model::warnings,
                    "What is odd about the description but computes, one sentence each.")
      .def_readonly("notes", &Model::notes,
                    "What the description holds that dynamics does not need, one sentence each.")
      .def_property_readonly("total_mass", &Model::total_mass, "Of all moving bodies, kg.");
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
