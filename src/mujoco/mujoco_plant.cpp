#include "burnish/mujoco/mujoco_plant.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/to_size.hpp"
#include "dynamics/springs.hpp"
#include "model/mass_check.hpp"
#include "mujoco/exact_contact.hpp"
#include "mujoco/mujoco_engine.hpp"
#include "sim/state_check.hpp"

namespace burnish {
namespace {

using mujoco::Engine;
using mujoco::ExactContact;

/// Bound of valid numbers. For larger numbers, MuJoCo would write a log file and reset the state.
constexpr double max_number = 1e9;

bool usable(const mjtNum* x, int n) {
  return std::all_of(x, x + n, [](mjtNum value) { return std::abs(value) < max_number; });
}

class MujocoPlant final : public Plant {
 public:
  MujocoPlant(const Model& model, const SceneSpec& scene, const MujocoPlantOptions& options)
      : engine_(model, scene, options),
        q_(model.q_neutral),
        v_(Eigen::VectorXd::Zero(model.nv)),
        friction_(Eigen::VectorXd::Zero(model.nv)),
        springs_(model),
        spring_torque_(friction_),
        total_(friction_),
        theirs_(Eigen::VectorXd::Zero(engine_.m->nv)),
        wrenches_(Wrenches::Zero(6, static_cast<Eigen::Index>(engine_.touches.size()))),
        before_(Eigen::VectorXd::Zero(moment_size())) {
    for (std::size_t i = 0; i < engine_.touches.size(); ++i)
      if (const TouchSpec& touch = engine_.scene.touches[i]; !engine_.computes(touch))
        exact_.emplace(static_cast<Eigen::Index>(i),
                       ExactContact(touch, engine_.touches[i], *engine_.m));
    start(q_, v_);
  }

  const Model& model() const override { return engine_.model; }
  const SceneSpec& scene() const override { return engine_.scene; }
  double dt() const override { return engine_.m->opt.timestep; }
  double time() const override { return static_cast<double>(steps_) * dt(); }
  const Eigen::VectorXd& q() const override { return q_; }
  const Eigen::VectorXd& v() const override { return v_; }
  const Eigen::VectorXd& friction_torque() const override { return friction_; }
  const Wrenches& wrenches() const override { return wrenches_; }

  Status reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept override;
  Status step(const ConstVectorRef& tau) noexcept override;
  void save(PlantSnapshot& snapshot) const override;
  Status restore(const PlantSnapshot& snapshot) noexcept override;

 private:
  void start(const ConstVectorRef& q, const ConstVectorRef& v);
  void load_forces(const ConstVectorRef& tau);
  void apply_exact_contacts();
  void read();
  void store_moment(double* to) const;
  void load_moment(const double* from) const;
  int moment_size() const { return engine_.m->nq + 3 * engine_.m->nv; }
  int readings_size() const { return 1 + engine_.model.nv + static_cast<int>(wrenches_.size()); }

  Engine engine_;
  std::map<Eigen::Index, ExactContact> exact_;  ///< Contacts that MuJoCo does not compute
  long steps_ = 0;
  Eigen::VectorXd q_, v_;
  Eigen::VectorXd friction_;
  Springs springs_;
  Eigen::VectorXd spring_torque_;  ///< Torques of springs at the start of the step [Nm or N]
  Eigen::VectorXd total_;          ///< Torques of motors and springs [Nm or N]
  Eigen::VectorXd theirs_;         ///< Damping and friction torques, in MuJoCo's entries
  Wrenches wrenches_;
  Eigen::VectorXd before_;  ///< State of MuJoCo before a step, see store_moment()
};

void MujocoPlant::start(const ConstVectorRef& q, const ConstVectorRef& v) {
  mj_resetData(engine_.m.get(), engine_.d.get());
  engine_.coordinates.store(q, v, *engine_.d);
  q_ = q;
  v_ = v;
  steps_ = 0;
  friction_.setZero();
  wrenches_.setZero();
}

Status MujocoPlant::reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept {
  const Status status = check_state(engine_.model, q, v);
  if (status != Status::Ok) return status;
  if (!usable(q.data(), engine_.model.nq) || !usable(v.data(), engine_.model.nv))
    return Status::NotFinite;
  start(q, v);
  return Status::Ok;
}

/// Implements mj_step1 and mj_step2 without their checks, which write files and reset the state.
/// Invalid numbers give a status instead.
Status MujocoPlant::step(const ConstVectorRef& tau) noexcept {
  mjModel* m = engine_.m.get();
  mjData* d = engine_.d.get();
  if (tau.size() != engine_.model.nv) return Status::WrongSize;
  if (!usable(tau.data(), engine_.model.nv)) return Status::NotFinite;
  store_moment(before_.data());
  engine_.update_surface_extents(wrenches_);
  engine_.update_ground_friction(time());
  mj_fwdPosition(m, d);
  engine_.stiffen_equalities();
  mj_fwdVelocity(m, d);
  load_forces(tau);
  mj_fwdActuation(m, d);
  mj_fwdAcceleration(m, d);
  apply_exact_contacts();
  mj_fwdConstraint(m, d);
  if (!usable(d->qacc, m->nv)) {
    load_moment(before_.data());
    return Status::NotFinite;
  }
  read();
  mj_Euler(m, d);
  engine_.coordinates.load(*d, q_, v_);
  if (m->neq > 0) engine_.coordinates.store(q_, v_, *d);  // exact positions of followers
  ++steps_;
  return Status::Ok;
}

/// Applies motor torques and springs. Springs are computed by add_spring_torque(), because MuJoCo's
/// own springs do not support angles on a circle.
void MujocoPlant::load_forces(const ConstVectorRef& tau) {
  spring_torque_.setZero();
  add_spring_torque(springs_, q_.data(), v_.data(), spring_torque_.data());
  total_ = tau + spring_torque_;
  engine_.coordinates.torque_to(total_, engine_.d->qfrc_applied);
}

void MujocoPlant::apply_exact_contacts() {
  for (auto& [touch, contact] : exact_) {
    auto wrench = wrenches_.col(touch);
    const bool touched = !wrench.isZero(0.0);
    const Vector6 wrench_world = contact.apply_force(*engine_.m, *engine_.d, time(), touched);
    const auto axes = engine_.axes_of(engine_.touches[to_size(touch)]);
    wrench << axes.transpose() * wrench_world.head<3>(), axes.transpose() * wrench_world.tail<3>();
  }
}

void MujocoPlant::read() {
  const mjModel* m = engine_.m.get();
  const mjData* d = engine_.d.get();
  for (std::size_t i = 0; i < engine_.touches.size(); ++i)
    if (engine_.computes(engine_.scene.touches[i]))
      wrenches_.col(static_cast<Eigen::Index>(i)) = engine_.contact_wrench(engine_.touches[i]);
  theirs_ = Eigen::Map<const Eigen::VectorXd>(d->qfrc_passive, m->nv);
  for (int row = 0; row < d->nefc; ++row)
    if (d->efc_type[row] == mjCNSTR_FRICTION_DOF) theirs_[d->efc_id[row]] += d->efc_force[row];
  engine_.coordinates.torque_from(theirs_.data(), friction_);
  friction_ += spring_torque_;
}

/// Saves all data on which MuJoCo's next steps depend. The warm start affects the last digits.
void MujocoPlant::store_moment(double* to) const {
  const mjModel* m = engine_.m.get();
  const mjData* d = engine_.d.get();
  mju_copy(to, d->qpos, m->nq);
  mju_copy(to + m->nq, d->qvel, m->nv);
  mju_copy(to + m->nq + m->nv, d->qacc_warmstart, m->nv);
  mju_copy(to + m->nq + 2 * m->nv, d->qfrc_constraint, m->nv);
}

void MujocoPlant::load_moment(const double* from) const {
  const mjModel* m = engine_.m.get();
  mjData* d = engine_.d.get();
  mju_copy(d->qpos, from, m->nq);
  mju_copy(d->qvel, from + m->nq, m->nv);
  mju_copy(d->qacc_warmstart, from + m->nq + m->nv, m->nv);
  mju_copy(d->qfrc_constraint, from + m->nq + 2 * m->nv, m->nv);
}

void MujocoPlant::save(PlantSnapshot& snapshot) const {
  snapshot.numbers.resize(moment_size() + readings_size());
  double* readings = snapshot.numbers.data() + moment_size();
  store_moment(snapshot.numbers.data());
  readings[0] = static_cast<double>(steps_);
  mju_copy(readings + 1, friction_.data(), static_cast<int>(friction_.size()));
  mju_copy(readings + 1 + friction_.size(), wrenches_.data(), static_cast<int>(wrenches_.size()));
}

Status MujocoPlant::restore(const PlantSnapshot& snapshot) noexcept {
  if (snapshot.numbers.size() != moment_size() + readings_size()) return Status::WrongSize;
  const double* readings = snapshot.numbers.data() + moment_size();
  load_moment(snapshot.numbers.data());
  steps_ = std::lround(readings[0]);
  mju_copy(friction_.data(), readings + 1, static_cast<int>(friction_.size()));
  mju_copy(wrenches_.data(), readings + 1 + friction_.size(), static_cast<int>(wrenches_.size()));
  engine_.coordinates.load(*engine_.d, q_, v_);
  return Status::Ok;
}

}  // namespace

std::unique_ptr<Plant> make_mujoco_plant(const Model& model, const SceneSpec& scene,
                                         const MujocoPlantOptions& options) {
  require_simulable(model);
  return std::make_unique<MujocoPlant>(model, scene, options);
}

}  // namespace burnish
