#include "burnish/derivatives/diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/decomposition.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/model/state.hpp"
#include "derivatives/contact_rows.hpp"

namespace burnish {
ContactRows contact_rows(const Model& model, ContactDynamics& dynamics,
                         const Eigen::Ref<const Eigen::VectorXd>& q) {
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
  const Status status = dynamics.forward(q, rest, rest);
  if (status > Status::SingularContacts) throw Error("diagnose: " + dynamics.explanation());
  const RowMatrix J = dynamics.jacobian();
  ContactRows rows{solve_positive_half(dynamics.mass_matrix(), J.transpose()).transpose(),
                   Eigen::VectorXd(J.rows())};
  Eigen::Index r = 0;
  for (int c = 0; c < dynamics.contacts().size(); ++c) {
    const CompiledContact& contact = dynamics.contacts().contacts()[c];
    const ContactForce force = dynamics.force(c);
    const Vec3<double> p = from_eigen(force.tool_position), origin = from_eigen(force.origin());
    for (const int d : contact.directions) {
      rows.part[r] =
          row_size(contact, d, J.row(r).data(), 1) / could_have_been(contact, d, p, origin);
      ++r;
    }
  }
  return rows;
}

namespace {

/// Gram-Schmidt row by row; rows kept so far are written as combinations of the rows of Y, so that
/// a redundant row can name the ones that imply it.
struct Orthogonalized {
  std::vector<Eigen::VectorXd> basis;         ///< orthonormal
  std::vector<Eigen::VectorXd> combinations;  ///< of rows of Y, per basis vector
  std::vector<double> uncertain;  ///< of the squared length that each was left with, relative

  /// Takes from a row what the basis holds of it. Returns what rounding makes of the squared length
  /// of the rest where it is the pivot of a factorisation (delassus.hpp).
  double reduce(Eigen::VectorXd& row, Eigen::VectorXd& combination) const {
    double rounding = pivot_rounding * row.squaredNorm();
    // Twice is enough for orthogonality to rounding.
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t b = 0; b < basis.size(); ++b) {
        const double part = basis[b].dot(row);
        if (pass == 0) rounding += part * part * uncertain[b];
        row -= part * basis[b];
        combination -= part * combinations[b];
      }
    return rounding;
  }
};

/// Of Y Y^T, whose rows are scaled already; at least that of a row of length 1.
double condition_of(const Eigen::MatrixXd& Y) {
  const Eigen::VectorXd values = symmetric_eigen(Y * Y.transpose()).values;
  return std::max(1.0, values.maxCoeff()) / values.minCoeff();
}

}  // namespace

ContactDiagnosis diagnose(const Model& model, const ContactSet& set,
                          const Eigen::Ref<const Eigen::VectorXd>& q,
                          const std::vector<int>& active, double tolerance) {
  check_configuration(model, q);
  ContactDynamics dynamics(model, set.specs());
  return diagnose_rows(set, contact_rows(model, dynamics, q), active, tolerance);
}

ContactDiagnosis diagnose_rows(const ContactSet& set, const ContactRows& rows,
                               const std::vector<int>& active, double tolerance) {
  const RowMatrix& Y = rows.Y;
  const std::vector<std::string> names = set.row_names();
  const double least_part = tolerance * tolerance;
  ContactDiagnosis result{{}, 1.0};
  Orthogonalized done;
  std::vector<int> examined;
  int row = 0;
  for (int c = 0; c < set.size(); ++c) {
    const CompiledContact& contact = set.contacts()[c];
    const bool is_wanted =
        active.empty() || std::find(active.begin(), active.end(), c) != active.end();
    for (const int d : contact.directions) {
      const int r = row++;
      if (!is_wanted) continue;
      examined.push_back(r);
      const double square = Y.row(r).squaredNorm();
      const double least = least_part * square * (1.0 + 1.0 / rows.part[r]);
      const bool immovable = !(square > least + pivot_rounding * square);
      Eigen::VectorXd rest = Y.row(r).transpose();
      Eigen::VectorXd combination = Eigen::VectorXd::Unit(Y.rows(), r);
      const double rounding = done.reduce(rest, combination);
      if (!immovable && rest.squaredNorm() > least + rounding) {
        done.basis.emplace_back(rest / rest.norm());
        done.uncertain.push_back(rounding / rest.squaredNorm());
        done.combinations.emplace_back(combination / rest.norm());
        continue;
      }
      RedundantRow found{contact.spec.name, std::string(direction_names[d]), r, immovable, {}};
      for (int other = 0; !immovable && other < r; ++other)
        if (std::abs(combination[other]) * Y.row(other).norm() > 1e-6 * std::sqrt(square))
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
    result.condition = condition_of(unit);
  }
  return result;
}

double condition_by_reach(const ContactSet& set, const ContactRows& rows) {
  if (rows.Y.rows() == 0) return 1.0;
  if (!diagnose_rows(set, rows, {}, independence_tolerance).redundant.empty())
    return std::numeric_limits<double>::infinity();
  Eigen::MatrixXd scaled = rows.Y;
  for (Eigen::Index r = 0; r < scaled.rows(); ++r)
    scaled.row(r) *= std::sqrt(std::min(1.0, rows.part[r])) / scaled.row(r).norm();
  return condition_of(scaled);
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
