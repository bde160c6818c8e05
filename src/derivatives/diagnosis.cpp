#include "burnish/derivatives/diagnosis.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <numeric>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/model/state.hpp"

namespace burnish {
namespace {

/// Rows of J in the metric of M^-1: J L^-1 with M = L L^T, so that Y Y^T = J M^-1 J^T.
Eigen::MatrixXd weighted_rows(ContactDynamics& dynamics, const Model& model,
                              const Eigen::Ref<const Eigen::VectorXd>& q) {
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
  const Status status = dynamics.acceleration(q, rest, rest);
  if (status != Status::Ok) throw Error("diagnose: " + std::string(describe(status)));
  const Eigen::LLT<Eigen::MatrixXd> mass(dynamics.mass_matrix());
  if (mass.info() != Eigen::Success)
    throw Error("diagnose: " + std::string(describe(Status::SingularMass)));
  return mass.matrixL().solve(Eigen::MatrixXd(dynamics.jacobian().transpose())).transpose();
}

/// Gram-Schmidt row by row; rows kept so far are written as combinations of the rows of Y, so that
/// a redundant row can name the ones that imply it.
struct Orthogonalized {
  std::vector<Eigen::VectorXd> basis;         ///< orthonormal
  std::vector<Eigen::VectorXd> combinations;  ///< of rows of Y, per basis vector
};

}  // namespace

ContactDiagnosis diagnose(const Model& model, const ContactSet& set,
                          const Eigen::Ref<const Eigen::VectorXd>& q,
                          const std::vector<int>& active, double tolerance) {
  check_configuration(model, q);
  std::vector<ContactSpec> specs;
  for (const CompiledContact& contact : set.contacts()) specs.push_back(contact.spec);
  ContactDynamics dynamics(model, specs);
  std::vector<int> wanted = active;
  if (wanted.empty()) {
    wanted.resize(static_cast<std::size_t>(set.size()));
    std::iota(wanted.begin(), wanted.end(), 0);
  }
  const Eigen::MatrixXd Y = weighted_rows(dynamics, model, q);
  double longest = 0.0;
  for (Eigen::Index r = 0; r < Y.rows(); ++r) longest = std::max(longest, Y.row(r).norm());
  ContactDiagnosis result{{}, 1.0};
  Orthogonalized done;
  const std::vector<std::string> names = set.row_names();
  std::vector<int> examined;
  int row = 0;
  for (int c = 0; c < set.size(); ++c) {
    const CompiledContact& contact = set.contacts()[c];
    const bool is_wanted = std::find(wanted.begin(), wanted.end(), c) != wanted.end();
    for (const int d : contact.directions) {
      const int r = row++;
      if (!is_wanted) continue;
      examined.push_back(r);
      const Eigen::VectorXd y = Y.row(r).transpose();
      const bool immovable = y.norm() <= tolerance * longest;
      Eigen::VectorXd rest = y;
      Eigen::VectorXd combination = Eigen::VectorXd::Unit(Y.rows(), r);
      // Twice is enough for orthogonality to rounding.
      for (int pass = 0; pass < 2; ++pass)
        for (std::size_t b = 0; b < done.basis.size(); ++b) {
          const double part = done.basis[b].dot(rest);
          rest -= part * done.basis[b];
          combination -= part * done.combinations[b];
        }
      if (!immovable && rest.norm() > tolerance * y.norm()) {
        done.basis.emplace_back(rest / rest.norm());
        done.combinations.emplace_back(combination / rest.norm());
        continue;
      }
      RedundantRow found{contact.spec.name, std::string(direction_names[d]), r, immovable, {}};
      for (int other = 0; !immovable && other < r; ++other)
        if (std::abs(combination[other]) * Y.row(other).norm() > 1e-6 * y.norm())
          found.implied_by.push_back(names[other]);
      result.redundant.push_back(found);
    }
  }
  if (!result.redundant.empty()) {
    result.condition = std::numeric_limits<double>::infinity();
  } else if (!examined.empty()) {
    Eigen::MatrixXd unit(static_cast<Eigen::Index>(examined.size()), Y.cols());
    for (std::size_t i = 0; i < examined.size(); ++i)
      unit.row(static_cast<Eigen::Index>(i)) = Y.row(examined[i]).normalized();
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(unit * unit.transpose()).eigenvalues();
    result.condition = values.maxCoeff() / values.minCoeff();
  }
  return result;
}

std::string RedundantRow::text() const {
  std::string sentence = "contact '" + contact + "', direction " + direction + ": ";
  if (immovable) return sentence + "no joint moves it at this posture";
  sentence += "already held by ";
  for (std::size_t i = 0; i < implied_by.size(); ++i)
    sentence += (i == 0 ? "" : ", ") + implied_by[i];
  return sentence;
}

std::string ContactDiagnosis::text() const {
  if (redundant.empty()) return "the contacts are independent\n";
  std::string lines;
  for (const RedundantRow& row : redundant) lines += row.text() + "\n";
  return lines;
}

}  // namespace burnish
