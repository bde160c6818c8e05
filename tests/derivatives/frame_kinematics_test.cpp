// Velocity, acceleration and placement of frames with derivatives, in every kind of reference.
#include "derivatives/frame_kinematics.tpp"

#include "burnish/base/error.hpp"
#include "dynamics/inverse_dynamics.tpp"
#include "dynamics/kinematics.tpp"
#include "support/kernel_law.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

Eigen::Matrix3d tilted() {
  return Eigen::AngleAxisd(0.8, Eigen::Vector3d(0.3, -1.0, 0.4).normalized()).toRotationMatrix();
}

/// `reference` with axes that follow `surface`, fixed in the same body.
Reference following(Reference reference, const Quadric& surface) {
  reference.rotation = tilted();
  reference.quadric = surface;
  return reference;
}

/// References of all kinds: standard ones, turned ones, some with origin or axes on another body,
/// and some that follow a surface of the world or of another body.
std::vector<Reference> frame_references(const Model& model, const std::string& frame) {
  const std::string other = far_frame(model, {frame});
  const Quadric saddle = Quadric::osculating({0.3, 0.0, 0.2}, tilted(), 0.2, 0.1, -0.15);
  return {Reference::local(),
          Reference::centered(),
          Reference::world(),
          Reference::local(tilted()),
          Reference::world(tilted()),
          {Anchor::Tool, other, tilted()},
          {other, Anchor::Tool},
          {other, other, tilted()},
          {other, Anchor::World},
          {Anchor::World, other},
          following({Anchor::Tool, Anchor::Base}, Quadric::sphere({0.2, -0.3, -4.0}, 0.3)),
          following({Anchor::Tool, other}, Quadric::cylinder({0.2, 4.0, -3.0}, {1, 0.3, 0.2}, 1.0)),
          following({Anchor::World, other}, saddle),
          following({other, Anchor::World}, saddle),
          following({other, other}, Quadric::sphere({0.2, -0.3, 5.0}, 2.0, true))};
}

/// A reference of a frame, with the joint axes that move it.
struct MovingReference {
  MovingReference(const Model& model, const CompiledFrame& frame, const Reference& stated)
      : name(stated.name()),
        compiled(compile_reference(model, stated, frame, world_frame())),
        origin(moving_axes(model, compiled.origin_body)),
        axes(moving_axes(model, compiled.axes_body)) {}
  template <class S>
  FrameReference<S> at(const Kinematics<S>& kinematics) const {
    return {compiled, reference_pose(compiled, kinematics), {origin, axes}};
  }
  std::string name;
  CompiledReference compiled;
  std::vector<MovingAxis> origin, axes;
};

/// A frame at a state, for any scalar.
template <class S>
struct FrameRun {
  FrameRun(const Tree& tree, const CompiledFrame& frame, const S* q, const S* v, const S* a)
      : kinematics(tree), id(tree) {
    update_kinematics(tree, q, v, kinematics);
    accelerate(tree, kinematics, a, id);
    update_frame(frame, kinematics, state);
    update_frame_acceleration(tree, frame, kinematics, id, state);
  }
  Kinematics<S> kinematics;
  InverseDynamics<S> id;
  FrameState<S> state;
};

template <class S>
void append(std::vector<S>& out, const Vec3<S>& x) {
  out.insert(out.end(), {x.x, x.y, x.z});
}
template <class S>
void append(std::vector<S>& out, const Motion<S>& m) {
  append(out, m.linear);
  append(out, m.angular);
}

/// Velocity over acceleration: 12 rows.
struct MotionKernel {
  template <class S>
  std::vector<S> values(const S* q, const S* v, const S* a) const {
    const FrameRun<S> run(tree, frame, q, v, a);
    std::vector<S> out;
    const ReferencePose<S> at = reference_pose(moving.compiled, run.kinematics);
    append(out, frame_velocity(moving.compiled, at, run.state));
    append(out, frame_acceleration(moving.compiled, at, run.kinematics, run.state));
    return out;
  }
  template <class S>
  Blocks<S> derivatives(const S* q, const S* v, const S* a) const {
    const FrameRun<S> run(tree, frame, q, v, a);
    const int n = tree.nv;
    const std::vector<S> zeros(static_cast<std::size_t>(12 * n), S(0.0));
    Blocks<S> out{zeros, zeros};
    const FrameReference<S> at = moving.at(run.kinematics);
    frame_velocity_derivative(frame, at, run.kinematics, run.state, out.dq.data(), n);
    frame_jacobian(frame, moving.compiled, at.pose, run.kinematics, out.dv.data(), n);
    frame_acceleration_derivatives(frame, at, run.kinematics, run.id, run.state,
                                   {out.dq.data() + 6 * n, out.dv.data() + 6 * n, n});
    return out;
  }
  const Tree& tree;
  const CompiledFrame& frame;
  MovingReference moving;
};

/// Position, rotation error and placement error: 12 rows.
struct PlacementKernel {
  template <class S>
  std::vector<S> values(const S* q, const S* v, const S* a) const {
    const FrameRun<S> run(tree, frame, q, v, a);
    const FrameError<S> error = frame_error(run.state, lift<S>(target_R), lift<S>(target_p));
    std::vector<S> out;
    append(out, error.position);
    append(out, error.rotation);
    append(out, error.placement);
    return out;
  }
  template <class S>
  Blocks<S> derivatives(const S* q, const S* v, const S* a) const {
    const FrameRun<S> run(tree, frame, q, v, a);
    const FrameError<S> error = frame_error(run.state, lift<S>(target_R), lift<S>(target_p));
    const int n = tree.nv;
    const std::vector<S> zeros(static_cast<std::size_t>(12 * n), S(0.0));
    Blocks<S> out{zeros, zeros};
    S* const dq = out.dq.data();
    frame_position_derivative(frame, run.kinematics, run.state, dq, n);
    frame_rotation_error_derivative(frame, run.kinematics, run.state, error, dq + 3 * n, n);
    frame_placement_error_derivative(frame, run.kinematics, run.state, error, dq + 6 * n, n);
    return out;
  }
  const Tree& tree;
  const CompiledFrame& frame;
  Mat3<double> target_R;
  Vec3<double> target_p;
};

class FrameKinematics : public OnRobots {
 protected:
  Tree tree{model};
  CompiledFrame frame = compile_frame(model, GetParam().tool);
  std::vector<Reference> references = frame_references(model, GetParam().tool);
};

TEST_P(FrameKinematics, MotionDerivatives_EqualAutodiffAndDifferences) {
  for (const Reference& reference : references) {
    const MotionKernel kernel{tree, frame, MovingReference(model, frame, reference)};
    SCOPED_TRACE(kernel.moving.name);
    expect_kernel_law(model, kernel);
    expect_lanes_alike(model, kernel);
  }
}

TEST_P(FrameKinematics, PlacementDerivatives_EqualAutodiffAndDifferences) {
  const PlacementKernel kernel{tree, frame, from_eigen(tilted()), {0.3, -0.2, 0.9}};
  expect_kernel_law(model, kernel);
  expect_lanes_alike(model, kernel);
}

TEST_P(FrameKinematics, Acceleration_IsTheRateOfTheVelocity) {
  std::mt19937_64 generator(3);
  const KernelState s = random_kernel_state(model, generator);
  const double step = 1e-6;
  for (const Reference& reference : references) {
    const MotionKernel kernel{tree, frame, MovingReference(model, frame, reference)};
    SCOPED_TRACE(kernel.moving.name);
    const auto at = [&](double t) {
      const Eigen::VectorXd q = integrate(model, s.q, s.v * t + s.a * (0.5 * t * t));
      const Eigen::VectorXd v = s.v + s.a * t;
      return as_vector(kernel.values<double>(q.data(), v.data(), s.a.data()));
    };
    const Eigen::VectorXd rate = (at(step) - at(-step)) / (2.0 * step);
    EXPECT_LE(relative_error(at(0.0).tail(6), rate.head(6)), 1e-7);
  }
}

TEST_P(FrameKinematics, Jacobian_MapsVelocitiesAndAccelerations) {
  std::mt19937_64 generator(4);
  const KernelState s = random_kernel_state(model, generator);
  const Eigen::VectorXd other = random_vector(model.nv, 1.0, generator);
  for (const Reference& reference : references) {
    const MotionKernel kernel{tree, frame, MovingReference(model, frame, reference)};
    const Blocks<double> blocks = kernel.derivatives<double>(s.q.data(), s.v.data(), s.a.data());
    const Eigen::MatrixXd J = as_matrix(blocks.dv, model.nv).topRows(6);
    const auto at = [&](const Eigen::VectorXd& a) {
      return as_vector(kernel.values<double>(s.q.data(), s.v.data(), a.data()));
    };
    EXPECT_LE(relative_error(J * s.v, at(s.a).head(6)), 1e-13);
    EXPECT_LE(relative_error(J * (other - s.a), (at(other) - at(s.a)).tail(6)), 1e-12);
  }
}

TEST_P(FrameKinematics, RotationDerivative_TurnsTheFrameInItsOwnAxes) {
  std::mt19937_64 generator(5);
  const KernelState s = random_kernel_state(model, generator);
  const FrameRun<double> run(tree, frame, s.q.data(), s.v.data(), s.a.data());
  std::vector<double> turning(static_cast<std::size_t>(3 * model.nv), 0.0);
  frame_rotation_derivative(frame, run.kinematics, run.state, turning.data(), model.nv);
  const Eigen::MatrixXd local = as_matrix(turning, model.nv);
  const Duals a = constant_duals(s.a);
  const ByState rotation = differentiate(model, s.q, s.v, [&](const Duals& q, const Duals& v) {
    const FrameRun<Dual> dual(tree, frame, q.data(), v.data(), a.data());
    const Mat3<Dual>& R = dual.state.R;
    return entries({column(R, 0), column(R, 1), column(R, 2)});
  });
  for (int column_of_R = 0; column_of_R < 3; ++column_of_R) {
    const Eigen::MatrixXd rate = rotation.dq.middleRows(3 * column_of_R, 3);
    // R (turning x e_j) = -R [e_j x] turning
    const Vec3<double> e = column(Mat3<double>::identity(), column_of_R);
    const Mat3<double> e_cross{{0.0, e.z, -e.y}, {-e.z, 0.0, e.x}, {e.y, -e.x, 0.0}};
    const Eigen::MatrixXd wanted = -to_eigen(run.state.R) * to_eigen(e_cross) * local;
    EXPECT_LE(relative_error(rate, wanted), 1e-13);
  }
}

TEST_P(FrameKinematics, AllReferences_DescribeOneMotion) {
  std::mt19937_64 generator(6);
  const KernelState s = random_kernel_state(model, generator);
  const FrameRun<double> run(tree, frame, s.q.data(), s.v.data(), s.a.data());
  const auto velocity = [&](const Reference& reference) {
    const MovingReference moving(model, frame, reference);
    return frame_velocity(moving.compiled, reference_pose(moving.compiled, run.kinematics),
                          run.state);
  };
  const auto acceleration = [&](const Reference& reference) {
    const MovingReference moving(model, frame, reference);
    return frame_acceleration(moving.compiled, reference_pose(moving.compiled, run.kinematics),
                              run.kinematics, run.state);
  };
  const auto local = velocity(Reference::local());
  const auto centered = velocity(Reference::centered());
  const Eigen::Matrix3d R = to_eigen(run.state.R);
  EXPECT_LE((R * to_eigen(local.linear) - to_eigen(centered.linear)).norm(), 1e-12);
  EXPECT_LE((R * to_eigen(local.angular) - to_eigen(centered.angular)).norm(), 1e-12);
  // The point's acceleration is the spatial one plus w x v.
  const auto spatial = acceleration(Reference::local());
  const auto point = acceleration(Reference::centered());
  const Eigen::Vector3d turning = to_eigen(cross(centered.angular, centered.linear));
  EXPECT_LE((R * to_eigen(spatial.linear) + turning - to_eigen(point.linear)).norm(), 1e-12);
}

TEST_P(FrameKinematics, EntriesBeyondTheSupport_AreNotWritten) {
  std::mt19937_64 generator(7);
  const KernelState s = random_kernel_state(model, generator);
  const FrameRun<double> run(tree, frame, s.q.data(), s.v.data(), s.a.data());
  std::vector<double> out(static_cast<std::size_t>(6 * model.nv), 42.0);
  const MovingReference moving(model, frame, Reference::world());
  frame_jacobian(frame, moving.compiled, reference_pose(moving.compiled, run.kinematics),
                 run.kinematics, out.data(), model.nv);
  for (int k = 0; k < model.nv; ++k) {
    const bool supports = std::any_of(frame.support.begin(), frame.support.end(),
                                      [k](const MovingAxis& entry) { return entry.v == k; });
    EXPECT_EQ(out[static_cast<std::size_t>(k)] == 42.0, !supports) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(robots, FrameKinematics, ::testing::ValuesIn(test_robots()), robot_label);

TEST(CompileFrame, World_IsAcceptedAndUnknownFramesAreRefused) {
  const Model model = TestRobot{"arm7", Base::Fixed, "tool"}.model();
  const CompiledFrame world = compile_frame(model, "world");
  EXPECT_EQ(world.body, -1);
  EXPECT_TRUE(world.support.empty());
  testing::expect_words(testing::refusal([&] { compile_frame(model, "tol"); }),
                        {"'tol'", "'tool'"});
}

}  // namespace
}  // namespace burnish::test
