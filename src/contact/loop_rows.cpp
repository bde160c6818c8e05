#include "contact/loop_rows.hpp"

#include <algorithm>

#include "base/to_size.hpp"
#include "burnish/contact/loops.hpp"
#include "contact/contact_kinematics.tpp"
#include "dynamics/kinematics.hpp"
#include "dynamics/mass_matrix.hpp"

namespace burnish {

LoopRows::LoopRows(const Model& model)
    : tree_(model),
      set_(model, loop_contacts(model, {}, true)),
      kinematics_(tree_),
      states_(to_size(set_.size())),
      at_rest_(Eigen::VectorXd::Zero(model.nv)),
      error_(Eigen::VectorXd::Zero(set_.rows())),
      J_(Eigen::MatrixXd::Zero(set_.rows(), model.nv)) {}

void LoopRows::update(const Eigen::VectorXd& q) {
  update_kinematics(tree_, q.data(), at_rest_.data(), kinematics_);
  int row = 0;
  for (std::size_t c = 0; c < states_.size(); ++c) {
    const CompiledContact& contact = set_.contacts()[c];
    update_contact(contact, contact.reference.axes, CurvedSurface<double>(), 0.0, kinematics_,
                   states_[c]);
    contact_error(contact, states_[c], error_.data() + row);
    // Column-major: entry (row, v) lies at v * rows + row.
    contact_jacobian(contact, kinematics_, states_[c], J_.data() + row, rows());
    row += static_cast<int>(contact.directions.size());
  }
}

Eigen::MatrixXd LoopRows::by_reach() const {
  Eigen::MatrixXd scaled = J_;
  int row = 0;
  for (const CompiledContact& contact : set_.contacts())
    for (const int d : contact.directions) {
      if (d < 3)
        for (const ContactSupport& entry : contact.support) scaled(row, entry.v) *= entry.per_reach;
      ++row;
    }
  return scaled;
}

Eigen::MatrixXd LoopRows::mass_matrix() const {
  MassMatrix<double> mass(tree_);
  update_mass_and_bias(tree_, kinematics_, mass);
  const Eigen::Map<const RowMatrix> lower(mass.mass.data(), tree_.nv, tree_.nv);
  Eigen::MatrixXd M = lower.triangularView<Eigen::Lower>();
  M.triangularView<Eigen::StrictlyUpper>() = M.transpose().triangularView<Eigen::StrictlyUpper>();
  return M;
}

IndependentRows independent_rows(const Eigen::MatrixXd& J, double min_length) {
  IndependentRows result;
  Eigen::MatrixXd rest = J;
  std::vector<char> taken(to_size(J.rows()), 0);
  for (Eigen::Index n = 0; n < J.rows(); ++n) {
    const Eigen::VectorXd lengths = rest.rowwise().norm();
    double longest_row = 0.0;
    for (Eigen::Index r = 0; r < J.rows(); ++r)
      if (!taken[to_size(r)]) longest_row = std::max(longest_row, lengths[r]);
    if (!(longest_row > min_length)) break;
    Eigen::Index chosen = 0;
    while (taken[to_size(chosen)] || lengths[chosen] < 0.5 * longest_row) ++chosen;
    taken[to_size(chosen)] = 1;
    result.rows.push_back(static_cast<int>(chosen));
    result.weakest = std::min(result.weakest, lengths[chosen]);
    const Eigen::RowVectorXd along = rest.row(chosen) / lengths[chosen];
    // Two passes make the rows orthogonal up to rounding.
    for (int pass = 0; pass < 2; ++pass) rest -= (rest * along.transpose()).eval() * along;
  }
  std::sort(result.rows.begin(), result.rows.end());
  return result;
}

}  // namespace burnish
