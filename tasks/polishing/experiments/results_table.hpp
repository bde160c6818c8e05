// Results as tables: named columns with units, cells of text or numbers, as Markdown and CSV.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace burnish::polishing {

/// What stands in a column of a table.
/// @described polishing
struct ResultColumn {
  std::string name;       ///< @required
  std::string unit = {};  ///< empty for text and counts
  int digits = 3;         ///< behind the point, in Markdown; CSV has all of them
};

/// Nothing, a number or text. A number that is not finite is written as nothing.
using ResultCell = std::variant<std::monostate, double, std::string>;

/// Results as a table: named columns with units, cells of text or numbers.
/// pandas.DataFrame(table.rows, columns=table.names) makes a data frame of it.
/// @described polishing
struct ResultTable {
  std::string name;   ///< of one word, such as "runs" @required
  std::string title;  ///< for people
  std::vector<ResultColumn> columns = {};
  std::vector<std::vector<ResultCell>> rows = {};
  bool for_people = true;  ///< False: too long to be read

  /// Throws Error unless there is a cell for every column.
  void add(std::vector<ResultCell> row);
};

/// A Markdown table: units below names, numbers to the right. No heading.
std::string markdown(const ResultTable& table);
/// First line `name [unit],...`; text with commas or quotes is quoted.
std::string csv(const ResultTable& table);

}  // namespace burnish::polishing
