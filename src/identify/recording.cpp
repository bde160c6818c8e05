// Simulated record: computed-torque control along an excitation, on the ideal plant.
#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/identify/excitation.hpp"
#include "burnish/model/state.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/sim/ideal_plant.hpp"

namespace burnish {
namespace {

/// Time before the motion, at rest and not recorded [s]. The arm first sags under the payload,
/// which the controller does not model.
constexpr double settling = 1.5;

/// Computed-torque controller, tau = M (a + kd e' + kp e) + b, with the nominal mass matrix M and
/// bias b, the planned acceleration a, and the tracking error e with the rate e'.
class FollowMotion final : public Controller {
 public:
  FollowMotion(const Model& model, const Excitation& motion)
      : model_(model), motion_(motion), dynamics_(model) {
    command_.tau.setZero(model.nv);
  }
  int nv() const override { return model_.nv; }
  void reset() noexcept override {}
  const Command& tick(const Measurement& m) noexcept override {
    motion_.at(m.time - settling, q_, v_, a_);
    constexpr double kp = 144.0, kd = 24.0;  // [1/s^2, 1/s]
    a_ += kd * (v_ - m.v) + kp * difference(model_, normalized(model_, m.q), q_);
    command_.status = dynamics_.inverse(normalized(model_, m.q), m.v, a_, none_);
    if (is_usable(command_.status)) command_.tau = dynamics_.tau();
    return command_;
  }

 private:
  const Model& model_;
  const Excitation& motion_;
  ContactDynamics dynamics_;
  Command command_;
  Eigen::VectorXd q_, v_, a_, none_;
};

/// Returns the trace without its first rows, with time zero at the start of the motion.
Trace without_start(const Trace& trace, int rows) {
  Trace result(trace.columns(), trace.rows() - rows);
  const auto columns = static_cast<int>(trace.columns().size());
  for (int i = rows; i < trace.rows(); ++i) {
    double* const row = result.add_row();
    for (int k = 0; k < columns; ++k) row[k] = trace.at(i, k);
    row[0] -= settling;  // time
  }
  return result;
}

}  // namespace

Trace record_motion(Plant& plant, const Model& known, const Excitation& motion,
                    const Disturbances& disturbances) {
  FollowMotion controller(known, motion);
  ClosedLoopOptions options;
  options.control_period = 1e-3;
  options.max_duration = motion.duration() + settling + 1.0;
  options.record_every = std::max(1, static_cast<int>(std::lround(1e-3 / plant.dt())));
  ClosedLoop loop(plant, controller, disturbances, options);
  Eigen::VectorXd q, v, a;
  motion.at(0.0, q, v, a);
  Status status = loop.reset(q, v);
  if (status == Status::Ok) status = loop.run(settling + motion.duration());
  if (!is_usable(status))
    throw Error("the simulated motion ended at " + number(plant.time()) +
                " s: " + std::string(describe(status)));
  return without_start(loop.trace(), static_cast<int>(std::lround(settling / 1e-3)));
}

Trace record_motion(const Model& model, const Payload& payload, const Excitation& motion,
                    const Disturbances& disturbances) {
  IdealPlantOptions options;
  options.dt = 1e-3;
  const auto plant =
      make_ideal_plant(plant_model(with_payload(model, payload), disturbances), {}, options);
  return record_motion(*plant, model, motion, disturbances);
}

}  // namespace burnish
