// Comparison of a simulated IMU with MuJoCo's accelerometer and gyroscope.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <memory>

#include "burnish/mjcf/mjcf.hpp"
#include "burnish/sim/imu_sensor.hpp"
#include "support/robots.hpp"
#include "support/scratch.hpp"

namespace burnish::test {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// Floating body with an IMU at an oblique pose on its arm.
const char* const floating_arm = R"(
<mujoco>
  <option timestep="1e-5" gravity="0.3 -0.2 -9.81"/>
  <worldbody>
    <body name="trunk" pos="0 0 1">
      <freejoint/>
      <geom type="box" size="0.2 0.1 0.05" mass="6"/>
      <body name="arm" pos="0.2 0 0.05">
        <joint name="elbow" axis="0.3 0.9 0.1"/>
        <geom type="capsule" fromto="0 0 0 0.3 0.1 0" size="0.03" mass="2"/>
        <site name="unit" pos="0.25 0.05 0.02" euler="20 -35 60"/>
      </body>
    </body>
  </worldbody>
  <sensor>
    <accelerometer site="unit"/>
    <gyro site="unit"/>
  </sensor>
</mujoco>)";

struct Delete {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

/// Converts MuJoCo's state to burnish's conventions: quaternions x y z w, velocity of the base in
/// its own axes.
void state_of(const mjModel& model, const mjData& data, VectorXd& q, VectorXd& v) {
  q = Eigen::Map<const VectorXd>(data.qpos, model.nq);
  v = Eigen::Map<const VectorXd>(data.qvel, model.nv);
  const Eigen::Quaterniond turn(q[3], q[4], q[5], q[6]);
  q.segment<4>(3) = turn.coeffs();
  v.head<3>() = turn.conjugate() * Vector3d(v.head<3>());
}

TEST(ImuSensor, Readings_EqualMujocosSensors) {
  const testing::Scratch scratch;
  const std::string file = scratch.write("floating_arm.xml", floating_arm).string();
  char error[500] = "";
  const std::unique_ptr<mjModel, Delete> simulated(
      mj_loadXML(file.c_str(), nullptr, error, sizeof error));
  ASSERT_NE(simulated, nullptr) << error;
  const std::unique_ptr<mjData, Delete> data(mj_makeData(simulated.get()));
  ModelOptions options;
  options.gravity = {0.3, -0.2, -9.81};
  const Model model = build_model(parse_mjcf(floating_arm), options);
  ASSERT_EQ(model.nv, simulated->nv);

  std::mt19937_64 generator(5);
  for (int trial = 0; trial < 10; ++trial) {
    const VectorXd q_start = random_configuration(model, generator);
    const VectorXd v_start = random_vector(model.nv, 2.0, generator);
    mj_resetData(simulated.get(), data.get());
    for (int k = 0; k < model.nq; ++k) data->qpos[k] = q_start[k];
    data->qpos[3] = q_start[6];
    for (int k = 0; k < 3; ++k) data->qpos[4 + k] = q_start[3 + k];
    for (int k = 0; k < model.nv; ++k) data->qvel[k] = v_start[k];

    ImuSensor sensor(model, "unit", {});
    VectorXd q, v;
    state_of(*simulated, *data, q, v);
    (void)sensor.measure(q, v, simulated->opt.timestep);
    mj_step(simulated.get(), data.get());  // MuJoCo's sensors refer to the start of the step
    state_of(*simulated, *data, q, v);
    const ImuReading& reading = sensor.measure(q, v, simulated->opt.timestep);
    const Eigen::Map<const Vector3d> acceleration(data->sensordata), turning(data->sensordata + 3);
    EXPECT_LT((reading.accelerometer - acceleration).norm(), 2e-3) << acceleration.transpose();
    EXPECT_LT((reading.gyro - turning).norm(), 1e-3) << turning.transpose();
    EXPECT_GT(acceleration.norm(), 0.1);
  }
}

}  // namespace
}  // namespace burnish::test
