// A record of a run: named columns with units, one row per sample, in memory allocated up front.
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

/// Name and unit of a column. The name states quantity, axis and frame, as in `tool_force_z_world`.
struct TraceColumn {
  std::string name;
  std::string unit;  ///< SI unit such as "N" or "rad/s"; "-" for counts and flags
};

/// Table with named columns and a fixed capacity of rows. Rows are added without memory allocation.
/// If the table is full, further rows are counted in dropped() but not stored.
class Trace {
 public:
  using Column = Eigen::Map<const Eigen::VectorXd, Eigen::Unaligned, Eigen::InnerStride<>>;

  Trace() = default;
  /// Creates an empty table with room for `capacity` rows. Throws Error if the capacity is
  /// negative. Also throws Error if the name of a column is empty or used twice, or if it contains
  /// a comma, a quote, a bracket or a line break.
  Trace(std::vector<TraceColumn> columns, int capacity);

  const std::vector<TraceColumn>& columns() const { return columns_; }
  int rows() const { return rows_; }
  int capacity() const { return capacity_; }
  long dropped() const { return dropped_; }

  /// Returns the index of a column. Throws Error with the nearest known name if no column has this
  /// name.
  int index(std::string_view name) const;
  bool has(std::string_view name) const;

  /// Appends a row of zeros, one per column. Returns a pointer to the first entry of the row, or
  /// nullptr if the table is full.
  double* add_row() noexcept;
  void clear() noexcept;

  double at(int row, int column) const { return values_[offset(row) + column]; }
  /// Returns all rows of one column. The view is valid until the trace is changed or destroyed.
  Column column(int index) const;
  Column column(std::string_view name) const { return column(index(name)); }

  /// Writes CSV text: a header line `name [unit],...`, then one line per row. Numbers have enough
  /// digits to be read back exactly. The decimal separator is a point in every locale. A NaN is
  /// written as an empty cell.
  void write_csv(std::ostream& out) const;
  /// Writes CSV text to a file, as the overload for streams does. Throws Error if the file cannot
  /// be written.
  void write_csv(const std::filesystem::path& file) const;

 private:
  std::ptrdiff_t offset(int row) const {
    return static_cast<std::ptrdiff_t>(row) * static_cast<std::ptrdiff_t>(columns_.size());
  }

  std::vector<TraceColumn> columns_;
  Eigen::VectorXd values_;  ///< Entries of the table, row by row
  int rows_ = 0, capacity_ = 0;
  long dropped_ = 0;
};

}  // namespace burnish
