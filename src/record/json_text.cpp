#include "record/json_text.hpp"

#include <cmath>

namespace burnish {
namespace {

bool fits_one_line(const Json& value) {
  if (!value.is_structured() || value.empty()) return true;
  if (value.is_object()) return false;
  for (const Json& entry : value)
    if (entry.is_structured()) return false;
  return true;
}

void write(const Json& value, const std::string& indent, std::string& out) {
  if (value.is_structured() && !fits_one_line(value)) {
    const std::string deeper = indent + "  ";
    const bool object = value.is_object();
    out += object ? "{" : "[";
    bool first = true;
    for (const auto& item : value.items()) {
      out += (first ? "\n" : ",\n") + deeper;
      if (object) out += Json(item.key()).dump() + ": ";
      write(item.value(), deeper, out);
      first = false;
    }
    out += "\n" + indent + (object ? "}" : "]");
  } else if (value.is_array()) {
    out += "[";
    for (std::size_t i = 0; i < value.size(); ++i) out += (i == 0 ? "" : ", ") + value[i].dump();
    out += "]";
  } else {
    out += value.dump();
  }
}

}  // namespace

Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json number_json(const std::optional<double>& value) {
  return value ? number_json(*value) : Json(nullptr);
}

Json numbers_json(const Eigen::Ref<const Eigen::VectorXd>& values) {
  Json list = Json::array();
  for (const double x : values) list.push_back(number_json(x));
  return list;
}

Json matrix_json(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    rows.push_back(numbers_json(matrix.row(i).transpose()));
  }
  return rows;
}

Json placement_json(const Eigen::Isometry3d& placement) {
  Eigen::Quaterniond rotation(placement.linear());
  if (rotation.w() < 0.0) rotation.coeffs() *= -1.0;
  return {{"xyz", numbers_json(placement.translation())},
          {"quaternion", numbers_json(rotation.normalized().coeffs())}};
}

std::string json_text(const Json& value) {
  std::string out;
  write(value, "", out);
  return out;
}

}  // namespace burnish
