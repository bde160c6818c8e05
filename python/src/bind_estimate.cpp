// The state of a base on feet.
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "bind.hpp"
#include "machine.hpp"
#include "specs_estimate.hpp"

namespace burnish::python {

namespace {

using Vector = Eigen::Ref<const Eigen::VectorXd>;

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
    std::vector<bool> result;
    for (int k = 0; k < estimator.feet(); ++k) result.push_back(((feet >> k) & 1U) != 0);
    return result;
  }
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

}  // namespace

void bind_estimate(py::module_& m) {
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
