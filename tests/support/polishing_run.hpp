// Baseline polishing with pressing_arm(): surfaces, disturbances, and a run.
#pragma once

#include <functional>
#include <memory>
#include <numbers>
#include <string>

#include "burnish/report/metrics.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/tasks/pressing/impedance_controller.hpp"
#include "support/plant_touch.hpp"
#include "support/pressing_arm.hpp"

namespace burnish::test {

/// Posture of the robot, and the normal of the surface under its tool.
struct PolishingSurface {
  std::string posture;
  Eigen::Vector3d normal;
};

inline PolishingSurface table() { return {"table", {0.0, 0.0, 1.0}}; }
inline PolishingSurface board_x() { return {"board_x", {-1.0, 0.0, 0.0}}; }
inline PolishingSurface board_y() { return {"board_y", {0.0, 1.0, 0.0}}; }

struct PolishingCase;

/// Impedance controller with the gains of the reference measurements, independent of the defaults.
inline std::unique_ptr<Controller> reference_impedance(const Model& model, const PressingPath& path,
                                                       const PolishingCase& test_case);

/// Settings of a run.
struct PolishingCase {
  PolishingSurface surface = table();
  double friction = 0.0;
  double ki = 0.0;                ///< force integral gain of the controller [1/s]
  double assumed_friction = 0.0;  ///< friction coefficient that the controller assumes
  double clearance = 1e-3;        ///< distance of the tip from the surface at the start [m]
  Disturbances disturbances = {};
  std::function<std::unique_ptr<Controller>(const Model&, const PressingPath&,
                                            const PolishingCase&)>
      make_controller = reference_impedance;
};

inline std::unique_ptr<Controller> reference_impedance(const Model& model, const PressingPath& path,
                                                       const PolishingCase& test_case) {
  ImpedanceGains gains;
  gains.kp = 900.0;
  gains.kd = 60.0;
  gains.ki_position = 0.0;
  gains.kd_normal = 30.0;
  gains.ki = test_case.ki;
  gains.posture_kp = 20.0;
  gains.posture_kd = 6.0;
  return make_impedance_controller(model, {path, gains, test_case.assumed_friction});
}

/// 17 bit encoders, differentiated positions and force filtered at 50 Hz, noise of 0.3 N and 0.05
/// Nm, delay of 1 ms.
inline Disturbances sensor_noise(double mass_scale) {
  constexpr double cutoff = 100.0 * std::numbers::pi;  // 50 Hz, rad/s
  Disturbances result;
  result.seed = 7;
  result.command_delay = 1e-3;
  result.torque_noise = 0.05;
  result.encoder_bits = 17;
  result.finite_difference_velocity = true;
  result.velocity_cutoff = cutoff;
  result.force_noise = 0.3;
  result.force_cutoff = cutoff;
  result.mass_scale = mass_scale;
  return result;
}

inline Model right_arm(Eigen::VectorXd* posture = nullptr, const std::string& name = "table") {
  const PressingArm arm = pressing_arm(name);
  if (posture != nullptr) *posture = arm.posture;
  return arm.model;
}

/// Plant, controller and loop of a case, at its start. The pieces live as long as the run.
class PolishingRun {
 public:
  /// make_plant(model, scene) -> std::unique_ptr<Plant>
  template <class MakePlant>
  PolishingRun(const PolishingCase& test_case, MakePlant&& make_plant)
      : nominal_(right_arm(&q_, test_case.surface.posture)) {
    const SceneSpec scene = plane_under_tip(nominal_, q_, test_case.surface.normal,
                                            test_case.clearance, test_case.friction);
    plant_ = make_plant(plant_model(nominal_, test_case.disturbances),
                        plant_scene(scene, test_case.disturbances));
    CirclePath circle;
    const TouchSpec& tip = scene.tool();
    circle.center_world = tip.surface.point + tip.radius * tip.surface.normal;
    circle.normal_world = tip.surface.normal;
    PressingPath path;
    path.normal_world = tip.surface.normal;
    path.task = [circle](double t) { return circle.at(t); };
    path.posture = q_;
    controller_ = test_case.make_controller(nominal_, path, test_case);
    loop_ = std::make_unique<ClosedLoop>(*plant_, *controller_, test_case.disturbances);
    status_ = loop_->reset(q_, Eigen::VectorXd::Zero(nominal_.nv));
  }

  Status run(double duration) {
    if (is_usable(status_)) status_ = loop_->run(duration);
    return status_;
  }
  Metrics metrics(double start) const {
    MetricsSpec spec;
    spec.start = start;
    spec.normal_world = plant_->scene().tool().surface.normal;
    return measure(loop_->trace(), nominal_, spec);
  }
  ClosedLoop& loop() { return *loop_; }
  Plant& plant() { return *plant_; }
  Controller& controller() { return *controller_; }
  const Eigen::VectorXd& start() const { return q_; }

 private:
  Eigen::VectorXd q_;
  Model nominal_;
  std::unique_ptr<Plant> plant_;
  std::unique_ptr<Controller> controller_;
  std::unique_ptr<ClosedLoop> loop_;
  Status status_ = Status::Ok;
};

}  // namespace burnish::test
