#include "burnish/contact/contact.hpp"

#include "burnish/base/error.hpp"

namespace burnish {

std::string name_of(Acceleration acceleration) {
  switch (acceleration) {
    case Acceleration::TimeDerivative:
      return "time_derivative";
    case Acceleration::Spatial:
      return "spatial";
    case Acceleration::Classical:
      return "classical";
  }
  return "unknown";
}

std::string name_of(PoseError error) { return error == PoseError::Split ? "split" : "log6"; }

Acceleration parse_acceleration(const std::string& name) {
  if (name == "time_derivative") return Acceleration::TimeDerivative;
  if (name == "spatial") return Acceleration::Spatial;
  if (name == "classical") return Acceleration::Classical;
  throw Error("acceleration: unknown name '" + name +
              "'; wanted time_derivative, spatial or classical" +
              did_you_mean(name, {"time_derivative", "spatial", "classical"}));
}

PoseError parse_pose_error(const std::string& name) {
  if (name == "split") return PoseError::Split;
  if (name == "log6") return PoseError::Log6;
  throw Error("error: unknown name '" + name + "'; wanted split or log6" +
              did_you_mean(name, {"split", "log6"}));
}

ContactSpec& ContactSpec::with_gains(double kp_all, double kd_all) {
  kp.setConstant(kp_all);
  kd.setConstant(kd_all);
  return *this;
}

}  // namespace burnish
