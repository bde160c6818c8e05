#include "burnish/sim/imu_sensor.hpp"

#include <Eigen/LU>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "dynamics/frame.hpp"
#include "dynamics/kinematics.hpp"
#include "estimate/strapdown.hpp"
#include "math/logarithm.hpp"
#include "sim/random.hpp"

namespace burnish {
namespace {

using Eigen::Vector3d;

CompiledFrame unit_frame(const Model& model, const std::string& name) {
  CompiledFrame frame = name.empty()
                            ? CompiledFrame{0, Mat3<double>::identity(), Vec3<double>::zero(), {}}
                            : compile_frame(model, name);
  if (frame.body < 0)
    throw Error("the measurement unit's frame " + in_quotes(name) +
                " is fixed to the world; wanted a frame on a moving body of the robot");
  return frame;
}

/// Errors of a gyroscope or an accelerometer: bias, noise, random walk and resolution.
struct Errors {
  Errors(std::uint64_t seed, std::uint64_t stream, double bias_range, double noise_density,
         double walk_density, double converter_step)
      : random(seed, stream), noise(noise_density), walk(walk_density), step(converter_step) {
    for (double& entry : bias) entry = bias_range * random.uniform(-1.0, 1.0);
  }
  void add_to(Vector3d& reading, double elapsed) noexcept {
    const double root = std::sqrt(elapsed);
    for (int k = 0; k < 3; ++k) {
      reading[k] += bias[k];
      if (noise > 0.0) reading[k] += noise / root * random.normal();
      if (walk > 0.0) bias[k] += walk * root * random.normal();
      if (step > 0.0) reading[k] = step * std::round(reading[k] / step);
    }
  }
  RandomStream random;
  double noise, walk, step;
  Vector3d bias;
};

}  // namespace

struct ImuSensor::Impl {
  Impl(const Model& model, const std::string& name, const Disturbances& d)
      : tree(model),
        frame(unit_frame(model, name)),
        kinematics(tree),
        gyro(d.seed, streams::gyro, d.gyro_bias_range, d.gyro_noise, d.gyro_bias_walk, d.gyro_step),
        accelerometer(d.seed, streams::accelerometer, d.accelerometer_bias_range,
                      d.accelerometer_noise, d.accelerometer_bias_walk, d.accelerometer_step),
        first_gyro(gyro),
        first_accelerometer(accelerometer),
        faults(d.imu_faults) {}

  void spoil(const ImuReading& before, bool is_first, double time) noexcept;

  Tree tree;
  CompiledFrame frame;
  Kinematics<double> kinematics;
  Errors gyro, accelerometer, first_gyro, first_accelerometer;
  bool started = false;
  Mat3<double> R_before = Mat3<double>::identity();
  Vec3<double> v_before = Vec3<double>::zero();
  ImuReading reading;
  std::vector<ImuFault> faults;
  bool silent = false;
};

/// Applies the faults to the reading. Random errors have already been drawn, so that a fault does
/// not change the random errors of later readings.
void ImuSensor::Impl::spoil(const ImuReading& before, bool is_first, double time) noexcept {
  silent = false;
  for (const ImuFault& fault : faults) {
    if (!acts_at(fault, time)) continue;
    reading.gyro += fault.gyro_offset;
    reading.accelerometer += fault.accelerometer_offset;
    silent = silent || fault.silent;
  }
  for (const ImuFault& fault : faults)
    if (fault.frozen && !is_first && acts_at(fault, time)) reading = before;
}

ImuSensor::ImuSensor(const Model& model, const std::string& frame, const Disturbances& disturbances)
    : impl_((check_disturbances(model, disturbances),
             std::make_unique<Impl>(model, frame, disturbances))) {}
ImuSensor::~ImuSensor() = default;
ImuSensor::ImuSensor(ImuSensor&&) noexcept = default;
ImuSensor& ImuSensor::operator=(ImuSensor&&) noexcept = default;

void ImuSensor::reset() noexcept {
  impl_->gyro = impl_->first_gyro;
  impl_->accelerometer = impl_->first_accelerometer;
  impl_->started = impl_->silent = false;
}

const ImuReading& ImuSensor::measure(const ConstVectorRef& q, const ConstVectorRef& v,
                                     double elapsed, double time) noexcept {
  Impl& d = *impl_;
  const ImuReading before = d.reading;
  const bool is_first = !d.started;
  update_kinematics(d.tree, q.data(), v.data(), d.kinematics);
  const BodyState<double>& body = d.kinematics.bodies[to_size(d.frame.body)];
  const Mat3<double> R = body.R * d.frame.R;
  const Motion<double> twist = at_point(body.v, body.p + body.R * d.frame.p);
  const Vec3<double> gravity = d.tree.gravity;
  if (d.started) {
    double angle = 0.0;
    const Vec3<double> phi = log_rotation(transpose_times(d.R_before, R), angle);
    const Vec3<double> change = (twist.linear - d.v_before) * (1.0 / elapsed) - gravity;
    const Eigen::Matrix3d mean = to_eigen(gamma_1(phi, rotation_series(phi)));
    d.reading.gyro = to_eigen(phi) / elapsed;
    d.reading.accelerometer = mean.inverse() * to_eigen(transpose_times(d.R_before, change));
  } else {
    d.reading.gyro = to_eigen(transpose_times(R, twist.angular));
    d.reading.accelerometer = to_eigen(transpose_times(R, -gravity));
  }
  d.started = true;
  d.R_before = R;
  d.v_before = twist.linear;
  d.gyro.add_to(d.reading.gyro, elapsed);
  d.accelerometer.add_to(d.reading.accelerometer, elapsed);
  d.spoil(before, is_first, time);
  return d.reading;
}

const ImuReading& ImuSensor::reading() const { return impl_->reading; }
bool ImuSensor::is_silent() const { return impl_->silent; }
const Eigen::Vector3d& ImuSensor::gyro_bias() const { return impl_->gyro.bias; }
const Eigen::Vector3d& ImuSensor::accelerometer_bias() const { return impl_->accelerometer.bias; }

}  // namespace burnish
