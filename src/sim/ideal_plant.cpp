#include "burnish/sim/ideal_plant.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/sentence.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "dynamics/integration.hpp"
#include "dynamics/springs.hpp"
#include "model/mass_check.hpp"
#include "sim/coulomb.hpp"
#include "sim/descriptions.gen.hpp"
#include "sim/manifold_step.hpp"
#include "sim/small_product.hpp"
#include "sim/state_check.hpp"

namespace burnish {
namespace {

constexpr double min_gap = 1e-6;  // smaller gaps at a reset count as contact [m]; chosen by hand

void check(const IdealPlantOptions& options) {
  check_ranges(description_of(&options), &options,
               [](const std::string& entry) { return "the ideal plant's " + entry; });
}

/// Returns the touch that the plant simulates, or a touch without a frame for an empty scene.
/// Throws Error if the plant cannot simulate the scene.
TouchSpec tip_of(const SceneSpec& scene) {
  for (const TouchSpec& touch : scene.touches)
    if (touch.is_support)
      throw Error("the ideal plant cannot simulate support " + in_quotes(touch.frame) +
                  "; wanted a scene without supports, or MuJoCo as the plant");
  if (scene.touches.size() > 1)
    throw Error("the ideal plant cannot simulate the " + std::to_string(scene.touches.size()) +
                " touches of the scene; wanted at most one, or MuJoCo as the plant");
  if (scene.touches.empty()) return {};
  const SurfaceSpec& surface = scene.tool().surface;
  if (!surface.frame.empty())
    throw Error("the ideal plant does not support a surface that the robot carries (frame " +
                in_quotes(surface.frame) +
                "); wanted a surface in the world, or MuJoCo as the plant");
  if (!surface.motion.is_at_rest())
    throw Error(
        "the ideal plant's surface moves; wanted a surface at rest, or MuJoCo as the plant");
  if (!surface.shape.is_flat())
    throw Error("the ideal plant's surface is a " + surface.shape.text() +
                "; wanted a plane, or MuJoCo as the plant");
  return scene.tool();
}

/// Returns the contact of the tip: one row along the normal, active when the tip's centre is one
/// tip radius above the surface.
ContactSpec contact_of(const TouchSpec& tip, const IdealPlantOptions& options) {
  ContactSpec spec;
  spec.name = "tip";
  spec.tool = tip.frame;
  spec.reference = Reference::surface_with_normal(tip.surface.normal);
  spec.directions = Directions::z();
  spec.target.translation() = tip.surface.point + tip.radius * tip.surface.normal;
  spec.with_gains(options.stabilize_kp, options.stabilize_kd);
  return spec;
}

/// Returns the contacts of the plant: first the contact of the tip, if there is one, then the
/// contacts that close the robot's loops. Loop contacts are always active.
std::vector<ContactSpec> contacts_of(const Model& model, const TouchSpec& tip,
                                     const IdealPlantOptions& options) {
  std::vector<ContactSpec> contacts;
  if (!tip.frame.empty()) contacts.push_back(contact_of(tip, options));
  return with_loops(model, std::move(contacts), {options.stabilize_kp, options.stabilize_kd});
}

/// State and rates at the intermediate stages of a Runge-Kutta step.
struct Workspace {
  explicit Workspace(const Model& model)
      : q(model.q_neutral), tau(Eigen::VectorXd::Zero(model.nv)) {
    for (Eigen::VectorXd* x : {&v, &u, &rate, &u_sum, &a_sum, &v_free, &response, &normal, &total})
      *x = Eigen::VectorXd::Zero(model.nv);
    M = Eigen::MatrixXd::Zero(model.nv, model.nv);
  }
  Eigen::VectorXd q, v;          ///< State at a stage
  Eigen::VectorXd u, rate;       ///< Increment of q since the start of the step, and its rate
  Eigen::VectorXd u_sum, a_sum;  ///< Weighted sums of rates over the stages
  Eigen::VectorXd tau;           ///< Torques during the step, with friction
  Eigen::VectorXd total;         ///< Torques at a stage: tau plus spring torques
  Eigen::VectorXd v_free, response, normal;
  Eigen::MatrixXd M;
};

class IdealPlant final : public Plant {
 public:
  IdealPlant(const Model& model, const SceneSpec& scene, const IdealPlantOptions& options);

  const Model& model() const override { return model_; }
  const SceneSpec& scene() const override { return scene_; }
  double dt() const override { return options_.dt; }
  double time() const override { return static_cast<double>(steps_) * options_.dt; }
  const Eigen::VectorXd& q() const override { return q_; }
  const Eigen::VectorXd& v() const override { return v_; }
  const Wrenches& wrenches() const override { return wrenches_; }
  const Eigen::VectorXd& friction_torque() const override { return friction_; }

  Status reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept override;
  Status step(const ConstVectorRef& tau) noexcept override;
  void save(PlantSnapshot& snapshot) const override;
  Status restore(const PlantSnapshot& snapshot) noexcept override;

 private:
  void start(const ConstVectorRef& q, const ConstVectorRef& v);
  Status advance(const ConstVectorRef& tau);
  Status find_forces(const ConstVectorRef& tau);
  Status find_friction();
  Status forward(const ConstVectorRef& q, const ConstVectorRef& v);
  Status integrate(double h);
  Status stage(double h, double weight);
  Status make_contact();
  Status respond_freely();
  Status respond_with_loops();
  double gap_at(const Eigen::VectorXd& q);
  bool has_friction() const;
  void report(double normal_force);
  void set_touching(bool touching);
  void accept();
  /// Returns the vectors that a snapshot contains after its numbers.
  std::array<const Eigen::VectorXd*, 5> vectors() const {
    return {&q_, &v_, &friction_, &coulomb_.joint_torque(), &coulomb_.torque()};
  }
  /// Count of the numbers before the vectors in a snapshot: steps, contact, sliding force, wrench.
  static constexpr int snapshot_numbers = 10;
  int snapshot_size() const { return snapshot_numbers + model_.nq + 4 * model_.nv; }

  Model model_;
  Tree tree_;
  SceneSpec scene_;
  TouchSpec touch_;  ///< Touch (tool or foot) of the scene; without a frame for an empty scene
  IdealPlantOptions options_;
  Eigen::Matrix3d axes_;  ///< Axes of the surface: two tangents, then the normal
  ContactDynamics dynamics_;
  RigidBody body_;
  int tip_;  ///< Frame of the tip; -1: none
  FrameDerivatives tip_motion_;
  CoulombStep coulomb_;
  Springs springs_;
  Workspace work_;
  Eigen::LLT<Eigen::MatrixXd> factor_;

  long steps_ = 0;
  Eigen::VectorXd q_, v_;
  Eigen::VectorXd q_next_, v_next_;
  bool touching_ = false;   ///< True if the contact is active
  double impulse_ = 0.0;    ///< Normal impulse of an impact in this step [Ns]
  double force_sum_ = 0.0;  ///< Mean normal force over the time of integrate() [N]
  Eigen::Matrix3d R_tip_ = Eigen::Matrix3d::Identity();  ///< Axes of the tip at the step's start.
  Wrenches wrenches_;
  /// Torques of friction, and of springs at the start of the step.
  Eigen::VectorXd friction_, spring_torque_;
  PlantSnapshot before_;
};

IdealPlant::IdealPlant(const Model& model, const SceneSpec& scene, const IdealPlantOptions& options)
    : model_(model),
      tree_(model),
      scene_(checked_scene(model, scene)),
      touch_(tip_of(scene_)),
      options_((check(options), options)),
      axes_(Reference::surface_with_normal(touch_.surface.normal).rotation),
      dynamics_(model, contacts_of(model, touch_, options)),
      body_(model),
      tip_(touch_.frame.empty() ? -1 : body_.frame(touch_.frame)),
      coulomb_(model.nv),
      springs_(model),
      work_(model),
      factor_(model.nv),
      q_(model.q_neutral),
      v_(Eigen::VectorXd::Zero(model.nv)),
      q_next_(q_),
      v_next_(v_),
      wrenches_(6, tip_ < 0 ? 0 : 1),
      friction_(v_),
      spring_torque_(v_) {
  coulomb_.joint_viscous = model.damping;
  coulomb_.joint_coulomb = model.friction;
  if (tip_ >= 0) body_.frame_derivatives(tip_, Reference::centered(), tip_motion_);
  start(q_, v_);
  save(before_);
}

void IdealPlant::start(const ConstVectorRef& q, const ConstVectorRef& v) {
  q_ = q;
  v_ = v;
  steps_ = 0;
  wrenches_.setZero();
  friction_.setZero();
  coulomb_.reset();
  set_touching(gap_at(q_) <= min_gap);
}

Status IdealPlant::reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept {
  const Status status = check_state(model_, q, v);
  if (status == Status::Ok) start(q, v);
  return status;
}

double IdealPlant::gap_at(const Eigen::VectorXd& q) {
  if (tip_ < 0) return std::numeric_limits<double>::infinity();
  work_.v.setZero();
  if (body_.update(q, work_.v) != Status::Ok) return 0.0;
  const Eigen::Vector3d p_tip_world = body_.placement(tip_).translation();
  if (!is_over(touch_, p_tip_world, false)) return std::numeric_limits<double>::infinity();
  return gap(touch_, p_tip_world);
}

bool IdealPlant::has_friction() const {
  const bool tip = touching_ && (touch_.surface.friction > 0.0 || options_.tip_viscous > 0.0);
  return tip || !model_.damping.isZero(0.0) || !model_.friction.isZero(0.0);
}

Status IdealPlant::step(const ConstVectorRef& tau) noexcept {
  if (tau.size() != model_.nv) return Status::WrongSize;
  if (!tau.allFinite()) return Status::NotFinite;
  save(before_);
  const Status status = advance(tau);
  if (is_usable(status)) return status;
  (void)restore(before_);
  return status;
}

/// Simulates one time step. If the tip reaches the surface during the step, the step is divided at
/// the impact.
Status IdealPlant::advance(const ConstVectorRef& tau) {
  const double h = options_.dt;
  impulse_ = 0.0;
  Status status = find_forces(tau);
  status = worst(status, integrate(h));
  if (touching_ && force_sum_ < 0.0) {
    set_touching(false);
    status = find_forces(tau);
    status = worst(status, integrate(h));
  }
  if (!is_usable(status)) return status;
  double normal_force = force_sum_;
  const double gap_before = touching_ ? 0.0 : gap_at(q_);
  const double gap_after = touching_ ? 0.0 : gap_at(q_next_);
  // Contact begins only from above the surface. Beside the surface, the gap is infinite.
  if (gap_after < 0.0 && gap_after < gap_before && std::isfinite(gap_before)) {
    // The time of contact follows from linear interpolation of the gap.
    const double free_time = h * std::clamp(gap_before / (gap_before - gap_after), 0.0, 1.0);
    status = integrate(free_time);
    accept();
    status = worst(status, make_contact());
    status = worst(status, integrate(h - free_time));
    normal_force = force_sum_ * (h - free_time) / h;
  }
  accept();
  ++steps_;
  report(normal_force);
  return worst(status, q_.allFinite() && v_.allFinite() ? Status::Ok : Status::NotFinite);
}

/// Computes the accelerations at (q, v), due to the torques of the step and to those of springs and
/// tendons.
Status IdealPlant::forward(const ConstVectorRef& q, const ConstVectorRef& v) {
  if (springs_.empty()) return dynamics_.forward(q, v, work_.tau);
  work_.total = work_.tau;
  add_spring_torque(springs_, q.data(), v.data(), work_.total.data());
  return dynamics_.forward(q, v, work_.total);
}

/// Computes the torques of friction, which are constant during the step. Ends the contact if its
/// force would pull the tip.
Status IdealPlant::find_forces(const ConstVectorRef& tau) {
  Status status = body_.update(q_, v_);
  if (!is_usable(status)) return status;
  if (touching_ && !is_over(touch_, body_.placement(tip_).translation(), true)) set_touching(false);
  work_.tau = tau + coulomb_.torque();
  if (tip_ >= 0) {
    R_tip_ = body_.placement(tip_).linear();
    body_.frame_derivatives(tip_, Reference::centered(), tip_motion_);
  }
  spring_torque_.setZero();
  add_spring_torque(springs_, q_.data(), v_.data(), spring_torque_.data());
  status = forward(q_, v_);
  if (!is_usable(status)) return status;
  if (touching_ && dynamics_.lambda()[0] < 0.0) {
    set_touching(false);
    status = forward(q_, v_);
    if (!is_usable(status)) return status;
  }
  if (!has_friction()) {
    work_.tau -= coulomb_.torque();
    coulomb_.reset();
    return status;
  }
  return worst(status, find_friction());
}

Status IdealPlant::find_friction() {
  // Friction acts at the contact point, which is one radius below the tip's origin.
  const Eigen::Vector3d arm = -touch_.radius * axes_.col(2);
  for (int t = 0; t < 2 && tip_ >= 0; ++t) {
    const Eigen::Vector3d tangent = axes_.col(t), moment = arm.cross(tangent);
    auto row = coulomb_.tangents.row(t);
    multiply(tangent.transpose(), tip_motion_.jacobian.topRows(3), row);
    add_product(1.0, moment.transpose(), tip_motion_.jacobian.bottomRows(3), row);
  }
  coulomb_.tip_coulomb = touching_ ? touch_.surface.friction * dynamics_.lambda()[0] : 0.0;
  coulomb_.tip_viscous = touching_ ? options_.tip_viscous : 0.0;
  const Status status = dynamics_.forward_derivatives();
  if (!is_usable(status)) return status;
  const MatrixView A = dynamics_.da_dtau();
  const double h = options_.dt;
  work_.v_free = v_ + h * dynamics_.a();
  add_product(-h, A, coulomb_.torque(), work_.v_free);
  work_.tau -= coulomb_.torque();
  coulomb_.solve(work_.v_free, A, h);
  work_.tau += coulomb_.torque();
  return status;
}

/// Integrates the state (q_, v_) over `h` [s]. The result is (q_next_, v_next_).
Status IdealPlant::integrate(double h) {
  work_.u.setZero();
  work_.v = v_;
  work_.u_sum.setZero();
  work_.a_sum.setZero();
  force_sum_ = 0.0;
  Status status = stage(0.5 * h, 1.0 / 6.0);
  status = worst(status, stage(0.5 * h, 1.0 / 3.0));
  status = worst(status, stage(h, 1.0 / 3.0));
  status = worst(status, stage(h, 1.0 / 6.0));
  work_.u_sum *= h;
  integrate_configuration(tree_, q_.data(), work_.u_sum.data(), q_next_.data());
  v_next_ = v_ + h * work_.a_sum;
  return status;
}

/// Adds the weighted rates at the current state of work_ to the sums. Then moves work_ to the next
/// stage, `h` [s] after the start of the step.
Status IdealPlant::stage(double h, double weight) {
  integrate_configuration(tree_, q_.data(), work_.u.data(), work_.q.data());
  increment_rate(model_, work_.u, work_.v, work_.rate);
  const Status status = forward(work_.q, work_.v);
  work_.u_sum += weight * work_.rate;
  work_.a_sum += weight * dynamics_.a();
  if (touching_ && is_usable(status)) force_sum_ += weight * dynamics_.lambda()[0];
  work_.u = h * work_.rate;
  work_.v = v_ + h * dynamics_.a();
  return status;
}

/// Simulates a plastic impact at (q_, v_): applies the normal impulse that makes the normal
/// velocity zero.
Status IdealPlant::make_contact() {
  set_touching(true);
  const Status status = forward(q_, v_);
  if (!is_usable(status)) return status;
  work_.normal = dynamics_.jacobian().row(0);
  work_.response = work_.normal;
  const Status responded = model_.loops.empty() ? respond_freely() : respond_with_loops();
  if (!is_usable(responded)) return responded;
  const double inverse_mass = work_.normal.dot(work_.response);
  if (!(inverse_mass > 0.0)) return Status::SingularContacts;
  impulse_ = std::max(-work_.normal.dot(v_) / inverse_mass, 0.0);
  v_ += impulse_ * work_.response;
  return status;
}

/// Replaces work_.response by M^-1 work_.response, the response of a robot without loops.
Status IdealPlant::respond_freely() {
  work_.M = dynamics_.mass_matrix();
  factor_.compute(work_.M);
  factor_.solveInPlace(work_.response);
  return factor_.info() == Eigen::Success ? Status::Ok : Status::SingularContacts;
}

/// Computes work_.response of a robot with loops: da/dtau without the surface contact, times
/// work_.normal. The response includes impulses in loops.
Status IdealPlant::respond_with_loops() {
  set_touching(false);
  Status status = dynamics_.forward(q_, v_, work_.tau);
  if (is_usable(status)) status = worst(status, dynamics_.forward_derivatives());
  if (is_usable(status)) {
    work_.response.setZero();
    add_product(1.0, dynamics_.da_dtau(), work_.normal, work_.response);
  }
  set_touching(true);
  return status;
}

void IdealPlant::set_touching(bool touching) {
  touching_ = touching;
  if (tip_ >= 0) dynamics_.set_active(0, touching);
}

void IdealPlant::accept() {
  q_ = q_next_;
  v_ = v_next_;
}

void IdealPlant::report(double normal_force) {
  const double total = std::max(normal_force + impulse_ / options_.dt, 0.0);
  const Eigen::Vector2d& sliding = coulomb_.sliding_force();
  Eigen::Vector3d force_world = total * axes_.col(2);
  if (touching_) force_world += sliding[0] * axes_.col(0) + sliding[1] * axes_.col(1);
  // Friction acts one radius below the frame's origin.
  const Eigen::Vector3d moment_world = -touch_.radius * axes_.col(2).cross(force_world);
  if (tip_ >= 0)
    wrenches_.col(0) << R_tip_.transpose() * force_world, R_tip_.transpose() * moment_world;
  friction_ = coulomb_.joint_torque() + spring_torque_;
}

void IdealPlant::save(PlantSnapshot& snapshot) const {
  snapshot.numbers.resize(snapshot_size());
  Eigen::VectorXd& to = snapshot.numbers;
  to[0] = static_cast<double>(steps_);
  to[1] = touching_ ? 1.0 : 0.0;
  to.segment<2>(2) = coulomb_.sliding_force();
  to.segment<6>(4).setZero();
  if (tip_ >= 0) to.segment<6>(4) = wrenches_.col(0);
  Eigen::Index at = snapshot_numbers;
  for (const Eigen::VectorXd* x : vectors()) {
    to.segment(at, x->size()) = *x;
    at += x->size();
  }
}

Status IdealPlant::restore(const PlantSnapshot& snapshot) noexcept {
  const Eigen::VectorXd& from = snapshot.numbers;
  if (from.size() != snapshot_size()) return Status::WrongSize;
  steps_ = std::lround(from[0]);
  set_touching(from[1] != 0.0);
  if (tip_ >= 0) wrenches_.col(0) = from.segment<6>(4);
  constexpr int first = snapshot_numbers;
  const int nq = model_.nq, nv = model_.nv;
  q_ = from.segment(first, nq);
  v_ = from.segment(first + nq, nv);
  friction_ = from.segment(first + nq + nv, nv);
  coulomb_.start_at(from.segment(first + nq + 2 * nv, nv), from.segment<2>(2),
                    from.segment(first + nq + 3 * nv, nv));
  return Status::Ok;
}

}  // namespace

std::unique_ptr<Plant> make_ideal_plant(const Model& model, const SceneSpec& scene,
                                        const IdealPlantOptions& options) {
  require_simulable(model);
  return std::make_unique<IdealPlant>(model, scene, options);
}

}  // namespace burnish
