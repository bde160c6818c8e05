#include "files/csv_table.hpp"
#include "fuzz/readers.hpp"

namespace burnish::fuzz {
namespace {

void read(const std::string& text) {
  const files::CsvTable table = files::parse_csv(text, "input.csv");
  table.column("time");
  table.column(table.names.back());
}

}  // namespace

const Reader table{"table", read};

}  // namespace burnish::fuzz
