#include "files/csv_table.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include "base/parse_number.hpp"
#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"

namespace burnish::files {
namespace {

/// Returns the number of cells in a line. Cells are counted before splitting, because a split cell
/// takes more memory than its text.
std::size_t cell_count(const std::string& line) {
  return to_size(std::count(line.begin(), line.end(), ',')) + 1;
}

std::vector<std::string> cells_of(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> cells;
  std::size_t begin = 0;
  while (true) {
    const std::size_t comma = line.find(',', begin);
    cells.push_back(line.substr(begin, comma - begin));
    if (comma == std::string::npos) return cells;
    begin = comma + 1;
  }
}

/// Returns the name of a header cell without its unit: "force_z" for "force_z [N]".
std::string name_of_cell(const std::string& cell) {
  std::string name = cell.substr(0, cell.rfind('['));
  const std::size_t first = name.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return name.substr(first, name.find_last_not_of(' ') - first + 1);
}

}  // namespace

bool CsvTable::has(const std::string& name) const {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Eigen::VectorXd CsvTable::column(const std::string& name, Eigen::Index rows) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error(file + ": column " + in_quotes(name) + " is missing" + did_you_mean(name, names));
  Eigen::VectorXd result = values.col(found - names.begin()).head(rows < 0 ? values.rows() : rows);
  if (!result.allFinite()) throw Error(file + ": column " + in_quotes(name) + " has empty cells");
  return result;
}

CsvTable read_csv(const std::filesystem::path& file) {
  return parse_csv(read_text(file, "table"), file.string());
}

CsvTable parse_csv(const std::string& text, const std::string& file) {
  std::istringstream stream(text);
  std::string line;
  if (!std::getline(stream, line)) refuse(file, "the file is empty; wanted a table");
  constexpr std::size_t max_columns = 10'000;
  const std::size_t columns = cell_count(line);
  if (columns > max_columns)
    refuse(file, "the table has " + std::to_string(columns) + " columns; wanted at most " +
                     std::to_string(max_columns));
  CsvTable table{file, {}, {}};
  for (const std::string& cell : cells_of(line)) table.names.push_back(name_of_cell(cell));
  std::vector<double> values;
  for (int number = 2; std::getline(stream, line); ++number) {
    if (line.empty() || line == "\r") continue;
    const std::string place = file + ": line " + std::to_string(number) + ": ";
    if (cell_count(line) != columns)
      throw Error(place + "the line has " + std::to_string(cell_count(line)) + " cells; wanted " +
                  std::to_string(columns));
    for (const std::string& cell : cells_of(line)) {
      const auto value = cell.empty() ? std::optional(std::numeric_limits<double>::quiet_NaN())
                                      : parse_number(cell);
      if (!value) throw Error(place + in_quotes(cell) + " is not a number");
      values.push_back(*value);
    }
  }
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto rows = static_cast<Eigen::Index>(values.size() / columns);
  table.values = Eigen::Map<const Rows>(values.data(), rows, static_cast<Eigen::Index>(columns));
  return table;
}

}  // namespace burnish::files
