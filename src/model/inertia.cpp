#include "burnish/model/inertia.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"

namespace burnish {
namespace {

/// Rounding error of published inertias, relative to the largest moment; chosen by hand.
constexpr double rounding = 0.05;

/// Returns the inertia of a unit mass at x: |x|^2 1 - x x^T.
Eigen::Matrix3d of_unit_mass(const Eigen::Vector3d& x) {
  return x.squaredNorm() * Eigen::Matrix3d::Identity() - x * x.transpose();
}

/// Slack of the triangle inequalities of principal moments.
struct Slack {
  double smallest;        ///< Smallest slack, or smallest moment if that is less [kg m^2]
  double largest_moment;  ///< Largest absolute value of a principal moment [kg m^2]
};
Slack slack_of(const Eigen::Matrix3d& inertia_at_com) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(inertia_at_com, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& moments = solver.eigenvalues();  // ascending
  return {std::min(moments[0] + moments[1] - moments[2], moments[0]),
          moments.cwiseAbs().maxCoeff()};
}

bool is_finite(const InertiaSpec& inertia) {
  return std::isfinite(inertia.mass) && inertia.com.allFinite() &&
         inertia.inertia_at_com.allFinite();
}
bool is_symmetric(const Eigen::Matrix3d& I) {
  return (I - I.transpose()).cwiseAbs().maxCoeff() <= 1e-9 * I.cwiseAbs().maxCoeff();
}
bool is_physical(const Eigen::Matrix3d& I) {
  const Slack slack = slack_of(I);
  return slack.smallest >= -rounding * slack.largest_moment;
}

}  // namespace

Vector10 inertia_parameters(const InertiaSpec& inertia) {
  const Eigen::Matrix3d I = inertia.inertia_at_com + inertia.mass * of_unit_mass(inertia.com);
  Vector10 result;
  result << inertia.mass, inertia.mass * inertia.com, I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2),
      I(2, 2);
  return result;
}

InertiaSpec inertia_of(const Vector10& p) {
  InertiaSpec result;
  result.mass = p[0];
  if (p[0] != 0.0) result.com = p.segment<3>(1) / p[0];
  Eigen::Matrix3d I;
  I << p[4], p[5], p[6], p[5], p[7], p[8], p[6], p[8], p[9];
  result.inertia_at_com = I - p[0] * of_unit_mass(result.com);
  return result;
}

Eigen::Matrix4d pseudo_inertia(const Vector10& p) {
  Eigen::Matrix3d I;
  I << p[4], p[5], p[6], p[5], p[7], p[8], p[6], p[8], p[9];
  Eigen::Matrix4d J;
  J << 0.5 * I.trace() * Eigen::Matrix3d::Identity() - I, p.segment<3>(1),
      p.segment<3>(1).transpose(), p[0];
  return J;
}

Vector10 parameters_of_pseudo_inertia(const Eigen::Matrix4d& pseudo_inertia) {
  const Eigen::Matrix4d& J = pseudo_inertia;
  const Eigen::Matrix3d S = J.topLeftCorner<3, 3>();
  const Eigen::Matrix3d I = S.trace() * Eigen::Matrix3d::Identity() - S;
  Vector10 p;
  p << J(3, 3), J.block<3, 1>(0, 3), I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2);
  return p;
}

Eigen::Matrix<double, 10, 10> inertia_transform(const Eigen::Isometry3d& placement) {
  const Eigen::Matrix4d& E = placement.matrix();
  Eigen::Matrix<double, 10, 10> T;
  for (int k = 0; k < 10; ++k)
    T.col(k) = parameters_of_pseudo_inertia(E * pseudo_inertia(Vector10::Unit(k)) * E.transpose());
  return T;
}

InertiaSpec placed(const InertiaSpec& inertia, const Eigen::Isometry3d& placement) {
  const Eigen::Matrix3d R = placement.linear();
  const Eigen::Matrix3d turned = R * inertia.inertia_at_com * R.transpose();
  return {inertia.mass, placement * inertia.com, 0.5 * (turned + turned.transpose())};
}

InertiaSpec together(const InertiaSpec& a, const InertiaSpec& b) {
  InertiaSpec result;
  result.mass = a.mass + b.mass;
  if (result.mass != 0.0) result.com = (a.mass * a.com + b.mass * b.com) / result.mass;
  const double shared = result.mass != 0.0 ? a.mass * b.mass / result.mass : 0.0;
  result.inertia_at_com =
      a.inertia_at_com + b.inertia_at_com + shared * of_unit_mass(a.com - b.com);
  return result;
}

Status check_inertia(const InertiaSpec& inertia) noexcept {
  if (!is_finite(inertia) || inertia.mass < 0.0) return Status::NotFinite;
  const Eigen::Matrix3d& I = inertia.inertia_at_com;
  if (!is_symmetric(I) || !is_physical(I)) return Status::NotPhysical;
  return inertia.mass == 0.0 && !I.isZero(0.0) ? Status::NotPhysical : Status::Ok;
}

std::string inertia_problem(const InertiaSpec& inertia) {
  if (check_inertia(inertia) == Status::Ok) return "";
  if (!std::isfinite(inertia.mass) || inertia.mass < 0.0)
    return "the mass is " + number(inertia.mass) + "; wanted a finite number of at least 0";
  if (!inertia.com.allFinite()) return "the centre of mass is not finite; wanted finite numbers";
  const Eigen::Matrix3d& I = inertia.inertia_at_com;
  if (!I.allFinite()) return "the inertia is not finite; wanted finite numbers";
  if (!is_symmetric(I)) return "the inertia is not symmetric; wanted a symmetric matrix";
  if (!is_physical(I))
    return "the inertia about the centre of mass belongs to no solid: its principal moments "
           "violate a bound by " +
           number(-slack_of(I).smallest) +
           " kg m^2; wanted each at least 0 and at most the sum of the two others";
  return "the mass is 0 but the inertia is not; wanted a mass above 0";
}

InertiaSpec inertia_of_body(const Model& model, int body) {
  const Joint& joint = model.joints.at(to_size(body));
  return {joint.mass, joint.com, joint.inertia_at_com};
}

void set_inertia_of_body(Model& model, int body, const InertiaSpec& inertia) {
  Joint& joint = model.joints.at(to_size(body));
  joint.mass = inertia.mass;
  joint.com = inertia.com;
  joint.inertia_at_com = inertia.inertia_at_com;
}

const Frame& frame_on_body(std::string_view call, const Model& model, std::string_view frame) {
  if (!model.has_frame(frame)) {
    std::vector<std::string> existing;
    for (const Frame& one : model.frames) existing.push_back(one.name);
    throw Error(std::string(call) + ": frame " + in_quotes(frame) + " does not exist" +
                did_you_mean(std::string(frame), existing));
  }
  const Frame& found = model.frames[to_size(model.frame_index(frame))];
  if (found.body < 0)
    throw Error(std::string(call) + ": frame " + in_quotes(frame) +
                " is fixed to the world; wanted a frame that a joint moves");
  return found;
}

Model with_payload(Model model, const Payload& payload) {
  const Frame& frame = frame_on_body("payload", model, payload.frame);
  if (const std::string problem = inertia_problem(payload.inertia); !problem.empty())
    throw Error("payload at " + in_quotes(payload.frame) + ": " + problem);
  set_inertia_of_body(
      model, frame.body,
      together(inertia_of_body(model, frame.body), placed(payload.inertia, frame.placement)));
  return model;
}

}  // namespace burnish
