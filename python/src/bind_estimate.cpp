// Bindings of the estimators of base state, foot contacts and foot forces.
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>

#include "bind.hpp"
#include "burnish/estimate/foot_forces.hpp"
#include "machine.hpp"
#include "specs_estimate.hpp"

namespace burnish::python {

namespace {

// Docstrings.

constexpr const char* foot_contacts_update_doc =
    R"(Updates the contacts from measured normal forces.

Parameters
----------
normal_forces : array_like, shape (feet,)
    Normal forces [N].
dt : float
    Time since the previous call [s].)";

constexpr const char* foot_forces_update_doc = R"(Updates the forces from a state and torques.

Parameters
----------
q : array_like, shape (nq,)
    Configuration.
v : array_like, shape (nv,)
    Velocity [rad/s or m/s].
tau : array_like, shape (nv,)
    Torques since the previous call [Nm or N]; entries of the base are ignored.
dt : float
    Time since the previous call [s].

Raises
------
EvaluationError
    If the input is invalid.)";

constexpr const char* base_estimator_reset_doc =
    R"(Resets the estimate to a state of the whole robot.

Parameters
----------
q : array_like, shape (nq,)
    Configuration.
v : array_like, shape (nv,), optional
    Velocity; default: at rest.
covariance : array_like, shape (15, 15), optional
    Order: rotation vector, velocity, position of the measurement unit in world axes, bias of the
    gyroscope, bias of the accelerometer. Default: the standard deviations of the options.)";

constexpr const char* base_estimator_update_doc = R"(Updates the estimate with measurements.

Parameters
----------
imu : ImuReading
    Means of the measurement unit since the previous call.
q : array_like, shape (nq,)
    Joint positions; entries of the base are ignored.
v : array_like, shape (nv,)
    Joint velocities; entries of the base are ignored.
standing : sequence of bool
    Whether each foot stands.
dt : float
    Time since the previous call [s].

Raises
------
EvaluationError
    If the input is invalid; the estimate does not change.)";

using Vector = Eigen::Ref<const Eigen::VectorXd>;

std::vector<bool> bools_of(std::uint32_t feet, int count) {
  std::vector<bool> result;
  for (int k = 0; k < count; ++k) result.push_back(((feet >> k) & 1U) != 0);
  return result;
}

struct EstimatorMachine {
  EstimatorMachine(const Model& model, const BaseEstimatorOptions& options)
      : estimator(model, options), v_at_rest(Eigen::VectorXd::Zero(model.nv)) {}
  BaseEstimator estimator;
  Eigen::VectorXd v_at_rest;
  Busy busy;

  BaseEstimator::Feet feet_of(const std::vector<bool>& standing) const {
    if (static_cast<int>(standing.size()) != estimator.feet())
      throw Error("BaseEstimator.update: standing has " + std::to_string(standing.size()) +
                  " entries; wanted " + std::to_string(estimator.feet()) + ", one per foot");
    BaseEstimator::Feet feet = 0;
    for (std::size_t k = 0; k < standing.size(); ++k)
      if (standing[k]) feet |= BaseEstimator::Feet{1} << k;
    return feet;
  }
  std::vector<bool> list_of(BaseEstimator::Feet feet) const {
    return bools_of(feet, estimator.feet());
  }
};

struct ContactsMachine {
  ContactsMachine(const Model& model, int feet, const FootContactOptions& options)
      : contacts(model, feet, options) {}
  FootContacts contacts;
  Busy busy;
};

struct ForcesMachine {
  ForcesMachine(const Model& model, const std::vector<FootSpec>& feet, double bandwidth)
      : forces(model, feet, bandwidth) {}
  FootForces forces;
  Busy busy;
};

using EstimatorClass = py::class_<EstimatorMachine>;

void bind_estimates(EstimatorClass& c) {
  c.def_property_readonly(
       "q", [](const EstimatorMachine& self) { return self.estimator.q(); },
       "Estimated configuration, shape (nq,), with the measured joint positions.")
      .def_property_readonly(
          "v", [](const EstimatorMachine& self) { return self.estimator.v(); },
          "Estimated velocity, shape (nv,), with the measured joint velocities.")
      .def_property_readonly(
          "covariance", [](const EstimatorMachine& self) { return self.estimator.covariance(); },
          "Covariance, shape (15, 15), in the order of reset().")
      .def_property_readonly(
          "gyro_bias", [](const EstimatorMachine& self) { return self.estimator.gyro_bias(); },
          "Bias of the gyroscope, shape (3,) [rad/s].")
      .def_property_readonly(
          "accelerometer_bias",
          [](const EstimatorMachine& self) { return self.estimator.accelerometer_bias(); },
          "Bias of the accelerometer, shape (3,) [m/s^2].")
      .def_property_readonly(
          "feet_that_count",
          [](const EstimatorMachine& self) {
            return self.list_of(self.estimator.feet_that_count());
          },
          "One bool per foot.")
      .def_property_readonly(
          "feet_that_slip",
          [](const EstimatorMachine& self) {
            return self.list_of(self.estimator.feet_that_slip());
          },
          "One bool per foot: True if the foot stands but is rejected as an outlier.")
      .def_property_readonly(
          "innovation", [](const EstimatorMachine& self) { return self.estimator.innovation(); },
          "Innovation of the last update, an EstimatorInnovation.");
}

void bind_contacts(py::module_& m) {
  py::class_<ContactsMachine>(m, "FootContacts",
                              "Contact detection of feet from normal forces, with hysteresis.")
      .def(py::init(
               [](const Model& model, int feet, const std::optional<FootContactOptions>& options) {
                 return std::make_unique<ContactsMachine>(model, feet,
                                                          options.value_or(FootContactOptions{}));
               }),
           py::arg("model"), py::arg("feet"), py::arg("options") = py::none(),
           "Raises Error for options out of range, and for noise that is larger than the "
           "hysteresis.")
      .def(
          "update",
          [](ContactsMachine& self, const Vector& normal_forces, double dt) {
            const Busy::Lock lock(self.busy, "FootContacts.update");
            require(self.contacts.update(normal_forces, dt), "FootContacts.update");
          },
          py::arg("normal_forces"), py::arg("dt"), foot_contacts_update_doc)
      .def_property_readonly(
          "standing",
          [](const ContactsMachine& self) {
            return bools_of(self.contacts.standing(),
                            static_cast<int>(self.contacts.forces().size()));
          },
          "One bool per foot.")
      .def_property_readonly(
          "forces", [](const ContactsMachine& self) { return self.contacts.forces(); },
          "Low-pass filtered normal forces [N].");
  py::class_<ForcesMachine>(
      m, "FootForces",
      "Estimator of foot forces without force sensors, from joint torques and the dynamics.")
      .def(py::init([](const Model& model, const std::vector<FootSpec>& feet, double bandwidth) {
             return std::make_unique<ForcesMachine>(model, feet, bandwidth);
           }),
           py::arg("model"), py::arg("feet"), py::arg("bandwidth") = 150.0,
           "`bandwidth` of the estimator [rad/s]. Raises Error for unknown feet, and for feet "
           "that are fixed to the world.")
      .def(
          "update",
          [](ForcesMachine& self, const Vector& q, const Vector& v, const Vector& tau, double dt) {
            const Busy::Lock lock(self.busy, "FootForces.update");
            require(self.forces.update(q, v, tau, dt), "FootForces.update");
          },
          py::arg("q"), py::arg("v"), py::arg("tau"), py::arg("dt"), foot_forces_update_doc)
      .def_property_readonly(
          "forces_world",
          [](const ForcesMachine& self) { return Eigen::MatrixXd(self.forces.forces_world()); },
          "Forces of the ground on the feet, shape (3, feet), in world axes [N].")
      .def_property_readonly(
          "normal_forces", [](const ForcesMachine& self) { return self.forces.normal_forces(); },
          "Vertical forces of the ground on the feet, shape (feet,) [N].");
}

}  // namespace

void bind_estimate(py::module_& m) {
  bind_contacts(m);
  EstimatorClass c(m, "BaseEstimator",
                   "Estimator of the floating base of a robot with feet, from a gyroscope, an "
                   "accelerometer, encoders, and the contacts of the feet. See "
                   "docs/state_estimation.md.");
  c.def(py::init<const Model&, const BaseEstimatorOptions&>(), py::arg("model"), py::arg("options"),
        "Raises Error for a robot without a floating base, unknown frames, and options out of "
        "range.")
      .def(
          "reset",
          [](EstimatorMachine& self, const Vector& q, const std::optional<Eigen::VectorXd>& v,
             const std::optional<Eigen::MatrixXd>& covariance) {
            const Busy::Lock lock(self.busy, "BaseEstimator.reset");
            const Eigen::VectorXd& rate = v ? *v : self.v_at_rest;
            require(covariance ? self.estimator.reset(q, rate, *covariance)
                               : self.estimator.reset(q, rate),
                    "BaseEstimator.reset");
          },
          py::arg("q"), py::arg("v") = py::none(), py::arg("covariance") = py::none(),
          base_estimator_reset_doc)
      .def(
          "update",
          [](EstimatorMachine& self, const ImuReading& imu, const Vector& q, const Vector& v,
             const std::vector<bool>& standing, double dt) {
            const Busy::Lock lock(self.busy, "BaseEstimator.update");
            require(self.estimator.update(imu, q, v, self.feet_of(standing), dt),
                    "BaseEstimator.update");
          },
          py::arg("imu"), py::arg("q"), py::arg("v"), py::arg("standing"), py::arg("dt"),
          base_estimator_update_doc);
  bind_estimates(c);
}

}  // namespace burnish::python
