// A table of numbers with named columns: "name [unit],..." and then rows.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace burnish::files {

struct CsvTable {
  std::string file;
  std::vector<std::string> names;  ///< without units
  Eigen::MatrixXd values;          ///< rows x columns; an empty cell is a NaN

  bool has(const std::string& name) const;
  /// The first `rows` cells, or all. Throws Error with the nearest known name, or where one of them
  /// is no finite number.
  Eigen::VectorXd column(const std::string& name, Eigen::Index rows = -1) const;
};

/// Throws Error naming the file and the line.
CsvTable read_csv(const std::filesystem::path& file);
/// The same from a text; `file` stands for its name in error sentences.
CsvTable parse_csv(const std::string& text, const std::string& file);

}  // namespace burnish::files
