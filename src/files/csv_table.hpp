// CSV tables of numbers: a header line "name [unit],...", then rows.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace burnish::files {

struct CsvTable {
  std::string file;                ///< File name for messages
  std::vector<std::string> names;  ///< Column names without units
  Eigen::MatrixXd values;          ///< Rows x columns; an empty cell is a NaN

  bool has(const std::string& name) const;
  /// Returns the first `rows` cells of a column; -1: all cells. Throws Error for an empty cell
  /// among the results, and for an unknown column (with the nearest known name).
  Eigen::VectorXd column(const std::string& name, Eigen::Index rows = -1) const;
};

/// Reads a table. Throws Error with the file and the line of the mistake.
CsvTable read_csv(const std::filesystem::path& file);
/// Reads a table from a text. `file` is the file name for messages.
CsvTable parse_csv(const std::string& text, const std::string& file);

}  // namespace burnish::files
