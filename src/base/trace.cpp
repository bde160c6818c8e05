#include "burnish/base/trace.hpp"

#include <algorithm>
#include <ostream>

#include "base/csv_cell.hpp"
#include "base/whole_file.hpp"

namespace burnish {
namespace {

void check_name(const std::vector<TraceColumn>& columns, std::size_t i) {
  const std::string& name = columns[i].name;
  if (name.empty() || name.find_first_of(",\"[]\n\r") != std::string::npos)
    throw Error("column " + std::to_string(i) + " of a trace is named '" + name +
                "'; wanted a name without commas, quotes, brackets and line breaks");
  for (std::size_t j = 0; j < i; ++j)
    if (columns[j].name == name) throw Error("two columns of a trace are named '" + name + "'");
}

}  // namespace

Trace::Trace(std::vector<TraceColumn> columns, int capacity)
    : columns_(std::move(columns)), capacity_(capacity) {
  if (capacity < 0)
    throw Error("the capacity of a trace is " + std::to_string(capacity) +
                "; wanted a number of rows, at least 0");
  for (std::size_t i = 0; i < columns_.size(); ++i) check_name(columns_, i);
  values_ = Eigen::VectorXd::Zero(offset(capacity));
}

int Trace::index(std::string_view name) const {
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (columns_[i].name == name) return static_cast<int>(i);
  std::vector<std::string> names;
  for (const TraceColumn& column : columns_) names.push_back(column.name);
  throw Error("the trace has no column '" + std::string(name) + "'" + did_you_mean(name, names));
}

bool Trace::has(std::string_view name) const {
  return std::any_of(columns_.begin(), columns_.end(),
                     [&](const TraceColumn& column) { return column.name == name; });
}

double* Trace::add_row() noexcept {
  if (rows_ == capacity_) {
    ++dropped_;
    return nullptr;
  }
  double* row = values_.data() + offset(rows_++);
  std::fill(row, row + columns_.size(), 0.0);
  return row;
}

void Trace::clear() noexcept {
  rows_ = 0;
  dropped_ = 0;
}

Trace::Column Trace::column(int index) const {
  return {values_.data() + index, rows_,
          Eigen::InnerStride<>(static_cast<Eigen::Index>(columns_.size()))};
}

void Trace::write_csv(std::ostream& out) const {
  std::string line;
  for (const TraceColumn& column : columns_)
    line += (line.empty() ? "" : ",") + column.name + " [" + column.unit + "]";
  out << line << '\n';
  for (int row = 0; row < rows_; ++row) {
    line.clear();
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (i > 0) line += ',';
      append_cell(line, at(row, static_cast<int>(i)));
    }
    out << line << '\n';
  }
}

void Trace::write_csv(const std::filesystem::path& file) const {
  WholeFile whole(file);
  write_csv(whole.stream());
  whole.keep();
}

}  // namespace burnish
