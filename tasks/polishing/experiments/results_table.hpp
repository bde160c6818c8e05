// Tables of results: named columns with units, cells of text or numbers, as Markdown and CSV.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace burnish::polishing {

/// Column of a table.
/// @described polishing
struct ResultColumn {
  std::string name;       ///< @required
  std::string unit = {};  ///< Unit; empty for text and counts.
  int digits = 3;         ///< Digits after the decimal point in Markdown; CSV has all digits.
};

/// Cell of a table: empty, a number or text. A number that is not finite is written as an empty
/// cell.
using ResultCell = std::variant<std::monostate, double, std::string>;

/// Table of results: named columns with units, cells of text or numbers.
/// pandas.DataFrame(table.rows, columns=table.names) makes a data frame of it.
/// @described polishing
struct ResultTable {
  std::string name;   ///< Name in one word, such as "runs". @required
  std::string title;  ///< Heading.
  std::vector<ResultColumn> columns = {};
  std::vector<std::vector<ResultCell>> rows = {};
  bool for_people = true;  ///< False for long tables, which results.md omits.

  /// Adds a row. Throws Error unless it has a cell for every column.
  void add(std::vector<ResultCell> row);
};

/// Returns a Markdown table without heading; numbers are aligned to the right.
std::string markdown(const ResultTable& table);
/// Returns CSV with the first line `name [unit],...`; text with commas or quotes is quoted.
std::string csv(const ResultTable& table);

}  // namespace burnish::polishing
