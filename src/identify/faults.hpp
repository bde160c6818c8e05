// The fault of a record that explains it far better than the record as it is: units, signs, swapped
// columns, gravity, a lag, an encoder's offset, a payload that changes.
#pragma once

#include <functional>
#include <optional>

#include "identify/estimate.hpp"

namespace burnish::identify_detail {

/// A guess at what is wrong.
struct Fault {
  std::string sentence;
  /// Nothing is wrong with the record: an option explains it, such as joint friction, or the fault
  /// is as small as a calibration's.
  bool is_mild = false;
  double squares = 0.0;  ///< weighted, of what it leaves
};

/// Linear least squares: A x = b, a row per sample and torque.
struct Rows {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;
};

/// Tries faults one after the other on fewer instants of the record. Each is another regression,
/// solved by linear least squares in the ten parameters of each body.
class FaultSearch {
 public:
  FaultSearch(const Model& model, const MotionRecord& record, const Windows& windows,
              std::span<const Unknown> unknowns, const IdentificationSpec& spec);

  /// The fault that leaves least beyond the rms that noise explains (nv), if that is less than a
  /// fifth of what the estimate x leaves.
  std::optional<Fault> best(const Eigen::VectorXd& x, const Eigen::VectorXd& expected);

 private:
  using Change = std::function<void(RowMatrix&)>;  ///< of columns

  void try_negative_mass();
  // faults_of_torques.cpp
  void try_gains();
  void consider_gains(const Eigen::VectorXd& gain, double squares);
  void try_torque_columns();
  void try_lags();
  void try_single_torques();
  // faults_of_motion.cpp
  void try_gravity();
  void try_payload_change();
  void try_position_columns();
  void try_position_units();
  void try_period();
  void try_encoder_offsets();
  void try_options();

  void consider(const std::string& sentence, double squares, bool is_mild = false);
  static Rows rows(const Regression& of);
  /// Weighted squares that are left; `solution` receives the parameters.
  double left(const Rows& rows, Eigen::VectorXd* solution = nullptr) const;
  double weighted(const Eigen::VectorXd& residual) const;
  Regression regression(const Model& model, const MotionRecord& record,
                        const IdentificationSpec& spec) const;
  Regression with_positions(const Change& change) const;
  /// The columns of rows, samples x nv, changed.
  Eigen::VectorXd with_torques(const Eigen::VectorXd& rows, const Change& change) const;
  /// The regression's rows if `change` were made to the torques.
  Rows rows_with_torques(const Regression& of, const Change& change) const;
  Eigen::VectorXd shifted_torque(int joint, Eigen::Index by) const;

  const Model& model_;
  const MotionRecord& record_;
  Windows windows_;
  std::span<const Unknown> unknowns_;
  IdentificationSpec spec_;
  Regression base_;
  Eigen::VectorXd weight_;    ///< of each row
  Eigen::VectorXd solution_;  ///< parameters that fit the record as it is
  double reference_ = 0.0;    ///< squares that are to be undercut
  double noise_ = 0.0;        ///< squares that noise explains
  std::optional<Fault> best_;
};

}  // namespace burnish::identify_detail
