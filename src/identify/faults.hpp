// Search for faults of a record that explain the torques much better than no fault: wrong units or
// signs, swapped columns, wrong gravity, a lag, an encoder offset, or a payload that changes.
#pragma once

#include <functional>
#include <optional>

#include "identify/estimate.hpp"

namespace burnish::identify_detail {

/// Possible fault of a record.
struct Fault {
  std::string sentence;
  /// True if the record can be right: an option such as joint friction explains the residual, or
  /// the fault is as small as a calibration error.
  bool is_mild = false;
  double squares = 0.0;  ///< Weighted sum of squared residuals with this fault
};

/// Linear least squares A x = b, with one row per sample and torque.
struct Rows {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;
};

/// Search over faults, one after the other, on a subset of the record's instants. Each fault gives
/// another regression, solved by linear least squares in the ten parameters of each body.
class FaultSearch {
 public:
  FaultSearch(const Model& model, const MotionRecord& record, const Windows& windows,
              std::span<const Unknown> unknowns, const IdentificationSpec& spec);

  /// Returns the fault that explains the residual of estimate x best, if it reduces the rms of the
  /// residual beyond noise to less than a fifth (to less than a half for a mild fault). `expected`:
  /// rms of the residual that noise explains, nv entries.
  std::optional<Fault> best(const Eigen::VectorXd& x, const Eigen::VectorXd& expected);

 private:
  using Change = std::function<void(RowMatrix&)>;  ///< Function that changes columns of a record

  void try_negative_mass();
  // Defined in faults_of_torques.cpp:
  void try_gains();
  void consider_gains(const Eigen::VectorXd& gain, double squares);
  void try_torque_columns();
  void try_lags();
  void try_single_torques();
  // Defined in faults_of_motion.cpp:
  void try_gravity();
  void try_payload_change();
  void try_position_columns();
  void try_position_units();
  void try_period();
  void try_encoder_offsets();
  void try_options();

  void consider(const std::string& sentence, double squares, bool is_mild = false);
  static Rows rows(const Regression& of);
  /// Fits the rows. Returns the weighted sum of squared residuals; `solution` gets the parameters.
  double left(const Rows& rows, Eigen::VectorXd* solution = nullptr) const;
  double weighted(const Eigen::VectorXd& residual) const;
  Regression regression(const Model& model, const MotionRecord& record,
                        const IdentificationSpec& spec) const;
  Regression with_positions(const Change& change) const;
  /// Returns `rows` (samples x nv) with their columns changed by `change`.
  Eigen::VectorXd with_torques(const Eigen::VectorXd& rows, const Change& change) const;
  /// Returns the rows of the regression for torques whose columns are changed by `change`.
  Rows rows_with_torques(const Regression& of, const Change& change) const;
  Eigen::VectorXd shifted_torque(int joint, Eigen::Index by) const;

  const Model& model_;
  const MotionRecord& record_;
  Windows windows_;
  std::span<const Unknown> unknowns_;
  IdentificationSpec spec_;
  Regression base_;
  Eigen::VectorXd weight_;    ///< Weight of each row
  Eigen::VectorXd solution_;  ///< Parameters that fit the record without changes
  double reference_ = 0.0;    ///< Sum of squares that a fault must reduce
  double noise_ = 0.0;        ///< Sum of squares that noise explains
  std::optional<Fault> best_;
};

}  // namespace burnish::identify_detail
