// Controller with a constant torque.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "burnish/model/model.hpp"
#include "burnish/mpc/controller.hpp"

namespace burnish::test {

class ConstantTorque final : public Controller {
 public:
  using Touches = std::optional<std::vector<TouchSensor>>;
  /// `touches`: touches whose wrenches the controller reads; by default all touches of the plant.
  explicit ConstantTorque(const Eigen::VectorXd& tau, Touches touches = std::nullopt)
      : touches_(std::move(touches)) {
    command_.tau = tau;
  }
  int nv() const override { return static_cast<int>(command_.tau.size()); }
  Touches touches() const override { return touches_; }
  void reset() noexcept override {}
  const Command& tick(const Measurement& /*measurement*/) noexcept override { return command_; }

 private:
  Command command_;
  Touches touches_;
};

/// Returns touches at frames, of which the controller reads what is measured.
inline std::vector<TouchSensor> touches_at(const std::vector<std::string>& frames) {
  std::vector<TouchSensor> result;
  for (const std::string& frame : frames) result.push_back({frame});
  return result;
}

/// Controller without torque.
inline ConstantTorque no_torque(const Model& model) {
  return ConstantTorque(Eigen::VectorXd::Zero(model.nv));
}

}  // namespace burnish::test
