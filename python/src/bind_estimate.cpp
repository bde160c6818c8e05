// The state of a base on feet.
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
                  " entries; wanted one per foot, " + std::to_string(estimator.feet()));
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
       "(nq,), with the joints as they were read.")
      .def_property_readonly(
          "v", [](const EstimatorMachine& self) { return self.estimator.v(); }, "(nv,), likewise.")
      .def_property_readonly(
          "covariance", [](const EstimatorMachine& self) { return self.estimator.covariance(); },
          "(15, 15), as reset() takes it.")
      .def_property_readonly(
          "gyro_bias", [](const EstimatorMachine& self) { return self.estimator.gyro_bias(); },
          "(3,), rad/s.")
      .def_property_readonly(
          "accelerometer_bias",
          [](const EstimatorMachine& self) { return self.estimator.accelerometer_bias(); },
          "(3,), m/s^2.")
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
          "One bool per foot: it stands and is left out.")
      .def_property_readonly(
          "innovation", [](const EstimatorMachine& self) { return self.estimator.innovation(); },
          "EstimatorInnovation of the last update.");
}

void bind_contacts(py::module_& m) {
  py::class_<ContactsMachine>(m, "FootContacts", "A foot's normal force with hysteresis.")
      .def(py::init(
               [](const Model& model, int feet, const std::optional<FootContactOptions>& options) {
                 return std::make_unique<ContactsMachine>(model, feet,
                                                          options.value_or(FootContactOptions{}));
               }),
           py::arg("model"), py::arg("feet"), py::arg("options") = py::none(),
           "Raises Error for options out of range, and for noise that would reach across the "
           "hysteresis.")
      .def(
          "update",
          [](ContactsMachine& self, const Vector& normal_forces, double dt) {
            const Busy::Lock lock(self.busy, "FootContacts.update");
            require(self.contacts.update(normal_forces, dt), "FootContacts.update");
          },
          py::arg("normal_forces"), py::arg("dt"),
          "Normal forces, N, one per foot, dt s after the last ones.")
      .def_property_readonly(
          "standing",
          [](const ContactsMachine& self) {
            return bools_of(self.contacts.standing(),
                            static_cast<int>(self.contacts.forces().size()));
          },
          "One bool per foot.")
      .def_property_readonly(
          "forces", [](const ContactsMachine& self) { return self.contacts.forces(); },
          "N, behind the low-pass.");
  py::class_<ForcesMachine>(
      m, "FootForces",
      "The force on each foot where no sensor measures it: from joint torques "
      "through the dynamics.")
      .def(py::init([](const Model& model, const std::vector<FootSpec>& feet, double bandwidth) {
             return std::make_unique<ForcesMachine>(model, feet, bandwidth);
           }),
           py::arg("model"), py::arg("feet"), py::arg("bandwidth") = 150.0,
           "bandwidth: rad/s. Raises Error for feet that are unknown or fixed to the world.")
      .def(
          "update",
          [](ForcesMachine& self, const Vector& q, const Vector& v, const Vector& tau, double dt) {
            const Busy::Lock lock(self.busy, "FootForces.update");
            require(self.forces.update(q, v, tau, dt), "FootForces.update");
          },
          py::arg("q"), py::arg("v"), py::arg("tau"), py::arg("dt"),
          "The state and the torques (nv,; Nm or N, none in the base's entries) that acted in the "
          "dt s since the last one. Raises EvaluationError for what cannot be used.")
      .def_property_readonly(
          "forces_world",
          [](const ForcesMachine& self) { return Eigen::MatrixXd(self.forces.forces_world()); },
          "(3, feet), of the ground on each foot, N, world axes.")
      .def_property_readonly(
          "normal_forces", [](const ForcesMachine& self) { return self.forces.normal_forces(); },
          "(feet,), against gravity, N.");
}

}  // namespace

void bind_estimate(py::module_& m) {
  bind_contacts(m);
  EstimatorClass c(m, "BaseEstimator",
                   "Where a robot on its feet is and how it moves: its floating base from a "
                   "gyroscope, an accelerometer, encoders and which feet stand. See "
                   "docs/state_estimation.md.");
  c.def(py::init<const Model&, const BaseEstimatorOptions&>(), py::arg("model"), py::arg("options"),
        "Raises Error for a robot without a floating base, unknown frames and options out of "
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
          "Starts at q (nq,) and v (nv,; None: at rest) of the whole robot; covariance (15, 15), "
          "of the unit, world axes: rotation vector, velocity, position, biases of gyroscope and "
          "accelerometer; None: the options' deviations.")
      .def(
          "update",
          [](EstimatorMachine& self, const ImuReading& imu, const Vector& q, const Vector& v,
             const std::vector<bool>& standing, double dt) {
            const Busy::Lock lock(self.busy, "BaseEstimator.update");
            require(self.estimator.update(imu, q, v, self.feet_of(standing), dt),
                    "BaseEstimator.update");
          },
          py::arg("imu"), py::arg("q"), py::arg("v"), py::arg("standing"), py::arg("dt"),
          "What was read dt s after the last update: the unit's means over that time, and the "
          "joints' entries of q (nq,) and v (nv,) now; entries of the base are passed over. "
          "standing: one bool per foot. Raises EvaluationError for what cannot be used; it then "
          "changes nothing.");
  bind_estimates(c);
}

}  // namespace burnish::python
