// A record of a run: named columns with units, one row per sample, preallocated.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/base/error.hpp"
#include "burnish/base/views.hpp"

namespace burnish {

/// What a column holds. Names say frame and axis: `tool_force_z_world`.
struct TraceColumn {
  std::string name;
  std::string unit;  ///< SI, such as "N" or "rad/s"; "-" for counts and flags
};

/// Rows are added without allocation until the capacity is reached; what comes after is counted in
/// dropped() and not kept.
class Trace {
 public:
  using Column = Eigen::Map<const Eigen::VectorXd, Eigen::Unaligned, Eigen::InnerStride<>>;

  Trace() = default;
  /// Throws Error for a negative capacity and for names that are empty, used twice or hold a comma,
  /// a quote, a bracket or a line break.
  Trace(std::vector<TraceColumn> columns, int capacity);

  const std::vector<TraceColumn>& columns() const { return columns_; }
  int rows() const { return rows_; }
  int capacity() const { return capacity_; }
  long dropped() const { return dropped_; }

  /// Number of a column. Throws Error with the nearest known name.
  int index(std::string_view name) const;
  bool has(std::string_view name) const;

  /// The entries of a new row, one per column, zero at first; nullptr when the trace is full.
  double* add_row() noexcept;
  void clear() noexcept;

  double at(int row, int column) const { return values_[offset(row) + column]; }
  /// One column from first to last row; valid while the trace is neither changed nor destroyed.
  Column column(int index) const;
  Column column(std::string_view name) const { return column(index(name)); }

  /// First line `name [unit],...`, then one line per row with every digit that counts, decimal
  /// points whatever the locale. What is NaN is an empty cell.
  void write_csv(std::ostream& out) const;
  /// The same into a file. Throws Error if it cannot be written.
  void write_csv(const std::filesystem::path& file) const;

 private:
  std::ptrdiff_t offset(int row) const {
    return static_cast<std::ptrdiff_t>(row) * static_cast<std::ptrdiff_t>(columns_.size());
  }

  std::vector<TraceColumn> columns_;
  Eigen::VectorXd values_;  ///< row by row
  int rows_ = 0, capacity_ = 0;
  long dropped_ = 0;
};

}  // namespace burnish
