#include "mjcf/tied_comparison.hpp"

#include <algorithm>

#include "burnish/contact/loops.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/model/state.hpp"
#include "mjcf/joint_map.hpp"
#include "support/contact_states.hpp"

namespace burnish::testing {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// ---- Equalities of MuJoCo that the tree contains

bool is_linear(const mjtNum* data) { return data[2] == 0.0 && data[3] == 0.0 && data[4] == 0.0; }

/// Returns the number of joints of a fixed tendon with a coefficient other than zero.
int parts_of(const mjModel& model, int tendon) {
  int parts = 0;
  for (int w = 0; w < model.tendon_num[tendon]; ++w)
    parts += model.wrap_prm[model.tendon_adr[tendon] + w] != 0.0 ? 1 : 0;
  return parts;
}

bool is_carried(const mjModel& model, int equality) {
  const mjtNum* data = model.eq_data + mjNEQDATA * equality;
  const bool alone = model.eq_obj2id[equality] < 0;
  switch (model.eq_type[equality]) {
    case mjEQ_JOINT:
      return alone || is_linear(data);
    case mjEQ_TENDON:
      return alone && parts_of(model, model.eq_obj1id[equality]) <= 2;
    default:
      return model.eq_type[equality] == mjEQ_CONNECT || model.eq_type[equality] == mjEQ_WELD;
  }
}

int rows_of(const mjModel& model, int equality) {
  return model.eq_type[equality] == mjEQ_CONNECT ? 3 : model.eq_type[equality] == mjEQ_WELD ? 6 : 1;
}

// ---- dJ/dt qvel of the equalities

/// A point of a body, in world axes.
struct Point {
  int body;
  Vector3d at;  ///< position [m]
};

Point point_of(const mjData& data, int body, const mjtNum* in_body) {
  const Eigen::Map<const RowMajor> axes(data.xmat + 9 * body, 3, 3);
  return {body, Eigen::Map<const Vector3d>(data.xpos + 3 * body) +
                    axes * Eigen::Map<const Vector3d>(in_body)};
}

/// Returns the Jacobian of a point in world axes, 6 x nv, with the linear rows first.
MatrixXd jacobian(const mjModel& model, mjData& data, const Point& point) {
  RowMajor linear(3, model.nv), angular(3, model.nv);
  mj_jac(&model, &data, linear.data(), angular.data(), point.at.data(), point.body);
  MatrixXd both(6, model.nv);
  both << linear, angular;
  return both;
}

/// Returns the acceleration of a point and of its body's axes at qacc = 0, in world axes. It
/// includes MuJoCo's gravity, which cancels between two points. Needs mj_rnePostConstraint.
Eigen::Matrix<double, 6, 1> drift(const mjModel& model, mjData& data, const Point& point) {
  double twist[6], rate[6];
  mj_objectVelocity(&model, &data, mjOBJ_XBODY, point.body, twist, 0);
  mj_objectAcceleration(&model, &data, mjOBJ_XBODY, point.body, rate, 0);
  const Vector3d w(twist[0], twist[1], twist[2]), dw(rate[0], rate[1], rate[2]);
  const Vector3d arm = point.at - Eigen::Map<const Vector3d>(data.xpos + 3 * point.body);
  Eigen::Matrix<double, 6, 1> result;
  result << Vector3d(rate[3], rate[4], rate[5]) + dw.cross(arm) + w.cross(w.cross(arm)), dw;
  return result;
}

/// Returns dJ/dt qvel of a connect or weld at zero constraint velocity. MuJoCo's rows are S times
/// the relative motion of two points, so that axes and scale of a weld's rotation do not matter.
VectorXd loop_drift(const mjModel& model, mjData& data, int equality, const MatrixXd& J) {
  const bool is_weld = model.eq_type[equality] == mjEQ_WELD;
  const mjtNum* stated = model.eq_data + mjNEQDATA * equality;
  const mjtNum *in_first = stated, *in_second = stated + 3;
  if (is_weld) std::swap(in_first, in_second);
  const Point first = point_of(data, model.eq_obj1id[equality], in_first);
  const Point second = point_of(data, model.eq_obj2id[equality], in_second);
  const MatrixXd relative =
      (jacobian(model, data, first) - jacobian(model, data, second)).topRows(J.rows());
  const MatrixXd S =
      relative.transpose().completeOrthogonalDecomposition().solve(J.transpose()).transpose();
  if ((S * relative - J).norm() > 1e-9 * (1.0 + J.norm()))
    throw Error("MuJoCo's rows use other points in equality " + std::to_string(equality));
  return S * (drift(model, data, first) - drift(model, data, second)).head(J.rows());
}

struct Rows {
  MatrixXd J;
  VectorXd drift;
};

/// Returns the rows of all equalities at the state in `data`. Couplings are linear: no drift.
Rows equality_rows(const mjModel& model, mjData& data) {
  mju_zero(data.qacc, model.nv);
  mj_rnePostConstraint(&model, &data);
  const MatrixXd J = Eigen::Map<const RowMajor>(data.efc_J, data.nefc, model.nv);
  Rows rows{J, VectorXd::Zero(data.nefc)};
  int row = 0;
  for (int e = 0; e < model.neq; ++e) {
    if (!model.eq_active[e]) continue;
    const int n = rows_of(model, e);
    if (n > 1) rows.drift.segment(row, n) = loop_drift(model, data, e, J.middleRows(row, n));
    row += n;
  }
  if (row != data.nefc) throw Error("MuJoCo has constraints other than equalities");
  return rows;
}

/// Returns the acceleration by Gauss's principle. With M = L L^T and y = L^T (a - free), it has the
/// shortest y for which J a = -drift. Redundant rows change nothing.
VectorXd constrained(const MatrixXd& M, const VectorXd& force, const Rows& rows) {
  const Eigen::LLT<MatrixXd> factor(M);
  const VectorXd free = factor.solve(force);
  if (rows.J.rows() == 0) return free;
  const MatrixXd A = factor.matrixL().solve(rows.J.transpose()).transpose();
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> orthogonal;
  orthogonal.setThreshold(1e-8);
  orthogonal.compute(A);
  const VectorXd y = orthogonal.solve(-rows.drift - rows.J * free);
  return free + factor.matrixU().solve(y);
}

/// Returns MuJoCo's acceleration of the state in `data`. As in burnish, the armature of floating
/// bodies multiplies the rate of v, along rotating axes.
VectorXd their_acceleration(const mjModel& model, mjData& data, const VectorXd& tau,
                            const VectorXd& axes_turn) {
  mj_fwdPosition(&model, &data);
  mj_fwdVelocity(&model, &data);
  RowMajor M(model.nv, model.nv);
  mj_fullM(&model, M.data(), data.qM);
  const auto entries = [&](const mjtNum* from) {
    return Eigen::Map<const VectorXd>(from, model.nv);
  };
  const VectorXd force = tau + entries(data.qfrc_passive) - entries(data.qfrc_bias) +
                         entries(model.dof_armature).cwiseProduct(axes_turn);
  return constrained(M, force, equality_rows(model, data));
}

/// The burnish model: states on the loops, and their accelerations.
class OurSide {
 public:
  explicit OurSide(const TreeSpec& tree)
      : model_(built(tree)),
        dynamics_(model_, loop_contacts(model_, {0.0, 0.0})),
        passive_(without_friction(model_)) {}

  const Model& model() const { return model_; }

  /// Returns a posture on the loops with independent rows, if one is near a random posture.
  std::optional<VectorXd> posture(std::mt19937_64& generator) {
    VectorXd q = random_configuration(model_, generator);
    if (model_.loops.empty()) return q;
    LoopProjectionOptions options;
    options.tolerance = 1e-12;
    const LoopProjection onto = project_onto_loops(model_, q, options);
    const VectorXd none = VectorXd::Zero(model_.nv);
    if (onto.status != Status::Ok || dynamics_.forward(onto.q, none, none) != Status::Ok ||
        test::independence(dynamics_) < 1e-3)
      return std::nullopt;
    return onto.q;
  }

  VectorXd velocity(const VectorXd& q, std::mt19937_64& generator) const {
    return project_velocity_onto_loops(model_, q, test::uniform(model_.nv, 1.5, generator));
  }

  VectorXd acceleration(const VectorXd& q, const VectorXd& v, const VectorXd& tau) {
    passive_.update(q, v);
    const VectorXd all = tau + passive_.passive_torque();
    if (const Status status = dynamics_.forward(q, v, all); status != Status::Ok)
      throw Error(dynamics_.explanation());
    return dynamics_.a();
  }

 private:
  static Model built(const TreeSpec& tree) {
    ModelOptions options;
    options.gravity = tree.gravity.value_or(options.gravity);
    return build_model(tree, options);
  }
  /// MuJoCo treats Coulomb friction as a constraint, not as a passive torque.
  static Model without_friction(Model model) {
    model.friction.setZero();
    return model;
  }

  Model model_;
  ContactDynamics dynamics_;
  RigidBody passive_;
};

}  // namespace

TiedAgreement compare_tied(const TreeSpec& tree, mjModel& theirs, int states) {
  TiedAgreement worst;
  theirs.opt.jacobian = mjJAC_DENSE;
  for (int e = 0; e < theirs.neq; ++e) {
    if (!theirs.eq_active[e]) continue;
    if (!is_carried(theirs, e))
      theirs.eq_active[e] = 0, ++worst.left_out;
    else
      worst.rows += rows_of(theirs, e);
  }
  if (worst.rows == 0) return worst;
  OurSide ours(tree);
  if (ours.model().nv > 300) states = std::min(states, 2);  // large models, as of soft bodies
  const mujoco::DataPointer data(mj_makeData(&theirs));
  const JointMap map(tree, ours.model(), theirs);
  std::mt19937_64 generator(4);
  MatrixXd B;
  VectorXd axes_turn;
  for (int tried = 0; worst.states < states && tried < 50 * states; ++tried) {
    const std::optional<VectorXd> q = ours.posture(generator);
    if (!q) continue;
    ++worst.states;
    const VectorXd tau = test::uniform(theirs.nv, 5.0, generator);
    const VectorXd none = VectorXd::Zero(ours.model().nv);
    for (const bool moves : {false, true}) {
      const VectorXd v = moves ? ours.velocity(*q, generator) : none;
      map.store(*q, v, *data, B, axes_turn);
      const VectorXd want = their_acceleration(theirs, *data, tau, axes_turn);
      const VectorXd a = ours.acceleration(*q, v, B.transpose() * tau);
      double& error = moves ? worst.moving : worst.rest;
      error = std::max(error, test::relative_error(B * a + axes_turn, want));
    }
  }
  return worst;
}

}  // namespace burnish::testing
