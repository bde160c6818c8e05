// Reading JSON with sentences that name the place: "contacts[0].kp: has 3 numbers; wanted 6".
#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "burnish/base/error.hpp"

namespace burnish::app {

/// Text as JSON; `source` is the file's name. Throws Error for what is no JSON, and for keys that
/// an object has twice.
nlohmann::json parse_json(const std::string& text, const std::string& source);

/// A value and where it stands. Reading what is not there throws Error.
class JsonReader {
 public:
  JsonReader(const nlohmann::json& value, std::string place)
      : value_(value), place_(std::move(place)) {}

  [[noreturn]] void refuse(const std::string& what) const;
  /// Refuses keys that are not listed, with the nearest one.
  void allow_only(const std::vector<std::string>& keys) const;

  bool has(const std::string& key) const { return value_.contains(key); }
  JsonReader operator[](const std::string& key) const;  ///< refuses where it is missing
  std::vector<JsonReader> entries() const;              ///< of a list

  bool is_text() const { return value_.is_string(); }
  bool is_list() const { return value_.is_array(); }
  bool is_object() const { return value_.is_object(); }
  bool is_number() const { return value_.is_number(); }
  const nlohmann::json& json() const { return value_; }
  const std::string& place() const { return place_; }

  std::string text() const;
  double number() const;                    ///< finite
  int count() const;                        ///< an integer, not negative
  bool yes_or_no() const;                   ///< true or false
  std::vector<std::string> texts() const;   ///< of a list, or one text
  Eigen::VectorXd numbers() const;          ///< of a list
  Eigen::VectorXd numbers(int size) const;  ///< refuses another size
  Eigen::Matrix3d matrix3() const;          ///< a list of three rows
  /// {"xyz": [m], and "quaternion": [x, y, z, w], "rpy": [rad] or "matrix": 3 rows}: none is zero.
  /// `also`: further keys that the object may have.
  Eigen::Isometry3d placement(const std::vector<std::string>& also = {}) const;

  /// What `read` returns, with this place put before the sentence of an Error that it throws.
  template <class Read>
  auto named(Read&& read) const {
    try {
      return read();
    } catch (const Error& error) {
      refuse(error.what());
    }
  }

 private:
  const nlohmann::json& value_;
  std::string place_;
};

}  // namespace burnish::app
