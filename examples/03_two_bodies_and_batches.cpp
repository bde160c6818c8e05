// A contact between two moving bodies: the two arms of a crane hold one another by their tips.
// Then the same dynamics and all derivatives for 1000 states at once, one state per SIMD lane.
#include <chrono>
#include <cstdio>

#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "burnish/model/state.hpp"
#include "burnish/robots/robot.hpp"

using Clock = std::chrono::steady_clock;

int main() {
  const burnish::Robot crane = burnish::load_robot("crane");
  const burnish::Model& model = crane.model;

  burnish::ContactSpec grip;
  grip.name = "grip";
  grip.tool = "left_tip";
  grip.base = "right_tip";  // a moving body: it receives the opposite force, at the same point
  grip.directions = burnish::Directions::linear();
  burnish::ContactDynamics dynamics(model, {grip});

  const Eigen::VectorXd q = crane.reference_configuration();
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.nv);
  if (dynamics.forward(q, zero, zero) != burnish::Status::Ok) return 1;
  std::printf("%s\n", dynamics.force("grip").text().c_str());

  constexpr int states = 1000;
  Eigen::MatrixXd Q(model.nq, states), V(model.nv, states), Tau(model.nv, states);
  std::mt19937_64 generator(1);
  for (int i = 0; i < states; ++i) Q.col(i) = burnish::random_configuration(model, generator);
  V.setRandom();
  Tau.setRandom();

  burnish::ContactDynamicsBatch batch(model, {grip}, states);
  const auto start = Clock::now();
  const burnish::Status status = batch.forward_with_derivatives(Q, V, Tau);
  const std::chrono::duration<double, std::micro> batched = Clock::now() - start;
  if (status != burnish::Status::Ok) return 1;

  const auto again = Clock::now();
  double difference = 0.0;
  for (int i = 0; i < states; ++i) {
    if (dynamics.forward(Q.col(i), V.col(i), Tau.col(i)) != burnish::Status::Ok) return 1;
    if (dynamics.forward_derivatives() != burnish::Status::Ok) return 1;
    const double scale = 1.0 + dynamics.da_dq().cwiseAbs().maxCoeff();
    difference =
        std::max(difference, (batch.da_dq(i) - dynamics.da_dq()).cwiseAbs().maxCoeff() / scale);
  }
  const std::chrono::duration<double, std::micro> single = Clock::now() - again;
  std::printf("%d states, all derivatives: %.2f us per state in packs of %d, %.2f us one by one\n",
              states, batched.count() / states, burnish::pack_width(), single.count() / states);
  std::printf("batch and single %s\n", difference < 1e-9 ? "agree" : "differ");
}
