// Published robots: dynamics, contacts and all derivatives against reference values computed in
// extended precision. The files stay outside the repository.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/urdf/urdf.hpp"

namespace burnish::test {
namespace {

using nlohmann::json;

Eigen::VectorXd vector_of(const json& stated) {
  Eigen::VectorXd x(static_cast<Eigen::Index>(stated.size()));
  for (std::size_t i = 0; i < stated.size(); ++i) x[static_cast<Eigen::Index>(i)] = stated[i];
  return x;
}

/// Matrix from a list of rows, or column from a list of numbers.
Eigen::MatrixXd matrix_of(const json& stated) {
  if (!stated.at(0).is_array()) return vector_of(stated);
  Eigen::MatrixXd x(static_cast<Eigen::Index>(stated.size()),
                    static_cast<Eigen::Index>(stated[0].size()));
  for (std::size_t i = 0; i < stated.size(); ++i)
    x.row(static_cast<Eigen::Index>(i)) = vector_of(stated[i]).transpose();
  return x;
}

Eigen::Isometry3d placement_of(const json& stated) {
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  placement.linear() = matrix_of(stated["R"]);
  placement.translation() = vector_of(stated["p"]);
  return placement;
}

/// Number of compared blocks, and the block with the largest error relative to its tolerance.
struct Comparison {
  int blocks = 0;
  double worst = 0.0;  ///< error / tolerance
  std::string worst_block;

  /// `floor` stands in for the largest entry of a block that is zero in exact arithmetic.
  void add(const std::string& what, const Eigen::Ref<const Eigen::MatrixXd>& got,
           const Eigen::Ref<const Eigen::MatrixXd>& want, double tolerance, double floor = 1e-12) {
    ASSERT_EQ(got.rows(), want.rows()) << what;
    ASSERT_EQ(got.cols(), want.cols()) << what;
    ++blocks;
    const double scale = std::max(want.cwiseAbs().maxCoeff(), floor);
    const double error = (got - want).cwiseAbs().maxCoeff() / scale / tolerance;
    if (std::isfinite(error) && error <= worst) return;
    worst = std::isfinite(error) ? error : 1e300;
    worst_block = what;
  }
};

struct Published {
  std::string name;
  ModelOptions options;
};

void PrintTo(const Published& robot, std::ostream* out) { *out << robot.name; }

class DynamicsReference : public ::testing::TestWithParam<Published> {
 protected:
  void SetUp() override {
    const std::string shared = BURNISH_SHARED_DIR;
    const std::string file = shared + "/reference/" + GetParam().name + ".json";
    const std::string urdf = shared + "/robots/" + GetParam().name + ".urdf";
    if (!std::filesystem::exists(file) || !std::filesystem::exists(urdf))
      GTEST_SKIP() << "the published robot " << GetParam().name << " and its reference are not in "
                   << shared;
    std::ifstream(file) >> reference_;
    model_ = build_model(read_urdf(urdf), GetParam().options);
    ASSERT_EQ(model_.nq, reference_["nq"]);
  }

  Eigen::VectorXd of_state(std::size_t i, const char* what) const {
    return vector_of(reference_["states"][i][what]);
  }

  void report(const Comparison& comparison) {
    RecordProperty("blocks", comparison.blocks);
    RecordProperty("worst_error_over_tolerance", std::to_string(comparison.worst));
    EXPECT_GT(comparison.blocks, 0);
    EXPECT_LE(comparison.worst, 1.0)
        << comparison.blocks << " blocks compared, the worst is " << comparison.worst_block;
    std::printf("%d blocks compared, worst error / tolerance %.2g in %s\n", comparison.blocks,
                comparison.worst, comparison.worst_block.c_str());
  }

  json reference_;
  Model model_;
};

TEST_P(DynamicsReference, FreeMotionAndDerivatives_EqualTheReference) {
  Comparison comparison;
  ContactDynamics dynamics(model_);
  const Eigen::VectorXd none, rest = Eigen::VectorXd::Zero(model_.nv);
  for (std::size_t i = 0; i < reference_["free"].size(); ++i) {
    const json& want = reference_["free"][i];
    const Eigen::VectorXd q = of_state(i, "q"), v = of_state(i, "v"), tau = of_state(i, "tau");
    const auto add = [&](const char* what, const Eigen::Ref<const Eigen::MatrixXd>& got) {
      comparison.add(std::string(what) + ", state " + std::to_string(i), got, matrix_of(want[what]),
                     1e-8);
    };
    ASSERT_EQ(dynamics.forward(q, rest, tau), Status::Ok);
    add("g", dynamics.bias());
    ASSERT_EQ(dynamics.forward(q, v, tau), Status::Ok);
    dynamics.forward_derivatives();
    add("M", dynamics.mass_matrix());
    add("b", dynamics.bias());
    add("fd_acc", dynamics.a());
    add("dfd_dq", dynamics.da_dq());
    add("dfd_dv", dynamics.da_dv());
    add("dfd_dtau", dynamics.da_dtau());
    ASSERT_EQ(dynamics.inverse(q, v, vector_of(want["id_acc"]), none), Status::Ok);
    dynamics.inverse_derivatives();
    add("id_tau", dynamics.tau());
    add("did_dq", dynamics.dtau_dq());
    add("did_dv", dynamics.dtau_dv());
  }
  report(comparison);
}

TEST_P(DynamicsReference, FramesVelocitiesAndDrifts_EqualTheReference) {
  Comparison comparison;
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model_.nv);
  for (std::size_t i = 0; i < reference_["free"].size(); ++i)
    for (const auto& [frame, want] : reference_["free"][i]["frames"].items()) {
      const Eigen::VectorXd q = of_state(i, "q"), v = of_state(i, "v");
      const auto add = [&, &f = frame](const char* what, const Eigen::MatrixXd& got,
                                       const Eigen::Ref<const Eigen::MatrixXd>& stated) {
        comparison.add(f + ": " + what + ", state " + std::to_string(i), got, stated, 1e-8);
      };
      const Eigen::Isometry3d placed = frame_placement(model_, q, frame);
      add("placement", placed.matrix(), placement_of(want["oMf"]).matrix());
      ContactSpec contact;
      contact.tool = frame;
      contact.reference = Reference::local();
      for (const Acceleration kind : {Acceleration::Spatial, Acceleration::Classical}) {
        contact.acceleration = kind;
        ContactDynamics dynamics(model_, {contact});
        ASSERT_EQ(dynamics.acceleration(q, v, rest), Status::Ok);
        add("jacobian", dynamics.jacobian(), matrix_of(want["J_local"]));
        add("velocity", dynamics.contact_velocity(), matrix_of(want["v_local"]));
        const bool spatial = kind == Acceleration::Spatial;
        add("drift", dynamics.alpha(),
            matrix_of(want[spatial ? "drift_spatial_local" : "drift_classical_local"]));
      }
    }
  report(comparison);
}

/// A rotation whose z column is `axis`.
Eigen::Matrix3d along(const Eigen::Vector3d& axis) {
  const Eigen::Vector3d x = axis.unitOrthogonal();
  Eigen::Matrix3d rotation;
  rotation << x, axis.normalized().cross(x), axis.normalized();
  return rotation;
}

/// In the file WORLD means the centred frame, except for spatial accelerations.
Reference reference_of(const json& contact, bool spatial) {
  const std::string frame = contact["reference_frame"];
  const bool one = contact["kind"] == "1D";
  const Eigen::Matrix3d axes =
      one ? along(vector_of(contact["axis"])) : Eigen::Matrix3d::Identity();
  if (frame == "LOCAL") return Reference::local(axes);
  if (frame == "WORLD" && spatial) return Reference::world();
  return one ? Reference::surface(axes) : Reference::centered();
}

ContactSpec contact_of(const json& stated, std::size_t index) {
  const std::string kind = stated["kind"];
  const bool spatial = kind == "6D" || kind == "3D_spatial";
  ContactSpec contact;
  contact.tool = stated["frame"];
  contact.name = contact.tool + " " + std::to_string(index);
  contact.reference = reference_of(stated, spatial);
  contact.directions = kind == "1D"             ? Directions::z()
                       : kind.starts_with("3D") ? Directions::linear()
                                                : Directions::all();
  contact.acceleration = spatial ? Acceleration::Spatial : Acceleration::Classical;
  contact.error = kind.starts_with("6D") ? PoseError::Log6 : PoseError::Split;
  contact.with_gains(stated["kp"], stated["kd"]);
  contact.target = placement_of(stated["ref"]);
  return contact;
}

TEST_P(DynamicsReference, ContactsAndDerivatives_EqualTheReference) {
  Comparison comparison;
  for (const json& stated : reference_["cases"]) {
    std::vector<ContactSpec> contacts;
    for (const json& contact : stated["contacts"])
      contacts.push_back(contact_of(contact, contacts.size()));
    ContactSolver solver;
    solver.mu = stated["mu"];
    ContactDynamics dynamics(model_, contacts, solver);
    const double tolerance = std::max(1e-8, 10.0 * double(stated["fd_relative_error_estimate"]));
    for (std::size_t i = 0; i < stated["results"].size(); ++i) {
      const json& want = stated["results"][i];
      // Size of da/d... without the contact. A robot with as many constraints as joints leaves a
      // block of zeros.
      const json& free = reference_["free"][i];
      const auto floor = [&](const char* block) {
        return 1e-3 * matrix_of(free[block]).cwiseAbs().maxCoeff();
      };
      const auto add = [&](const char* what, const Eigen::Ref<const Eigen::MatrixXd>& got,
                           double min_scale = 1e-12) {
        comparison.add(std::string(stated["id"]) + ": " + what + ", state " + std::to_string(i),
                       got, matrix_of(want[what]), tolerance, min_scale);
      };
      const Status status =
          dynamics.forward(of_state(i, "q"), of_state(i, "v"), of_state(i, "tau"));
      ASSERT_EQ(status, Status::Ok) << stated["id"];
      dynamics.forward_derivatives();
      add("a", dynamics.a());
      add("lambda", dynamics.lambda());
      add("da_dq", dynamics.da_dq());
      add("da_dv", dynamics.da_dv());
      add("da_dtau", dynamics.da_dtau(), floor("dfd_dtau"));
      add("dlambda_dq", dynamics.dlambda_dq());
      add("dlambda_dv", dynamics.dlambda_dv());
      add("dlambda_dtau", dynamics.dlambda_dtau());
    }
  }
  report(comparison);
}

ModelOptions without(std::vector<std::string> locked) {
  ModelOptions options;
  options.locked = std::move(locked);
  return options;
}
ModelOptions floating() {
  ModelOptions options;
  options.base = Base::FreeFlyer;
  return options;
}

INSTANTIATE_TEST_SUITE_P(robots, DynamicsReference,
                         ::testing::Values(Published{"panda", without({"panda_finger_joint1",
                                                                       "panda_finger_joint2"})},
                                           Published{"ur10", {}}, Published{"solo12", floating()}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace burnish::test
