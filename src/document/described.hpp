// Reads described specifications from YAML strictly, and writes them so that they read back.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

#include "base/description.hpp"
#include "document/reader.hpp"

namespace burnish::document {

/// Additions to a description for reading a file: readers of C++ types, checks of names, more keys.
struct Reading {
  /// Readers of values, by C++ type. Values of these types are not read by their description.
  std::map<std::type_index, std::function<void(void* value, const Reader& reader)>> types = {};
  /// Checks of names that a text or a list of texts contains, by Field::name_of ("frame", ...).
  std::map<std::string, std::function<void(const Reader& names)>> names = {};
  /// Further allowed keys of the outermost map; the caller reads them.
  std::vector<std::string> also = {};
};

/// Makes an entry of Reading::types from a function that returns the value that it reads.
template <class Read, class Value = std::invoke_result_t<Read, const Reader&>>
std::pair<const std::type_index, std::function<void(void*, const Reader&)>> read_by(Read read) {
  return {typeid(Value), [read](void* value, const Reader& reader) {
            *static_cast<Value*>(value) = read(reader);
          }};
}

/// Reads the value of one entry into `spec`. Throws Error with the place if it does not fit.
void read_entry(const Field& field, void* spec, const Reader& reader);
/// Reads the stated keys of a map into `spec`; other entries keep their values. Throws Error with
/// the place for an unknown key, a missing key marked `@stated`, or a value that does not fit.
void read_described(const Description& description, void* spec, const Reader& reader,
                    const Reading& reading = {});
/// Returns the value of an entry as YAML on one line. Returns nothing for an empty text, because
/// files omit it.
std::optional<std::string> entry_text(const Field& field, const void* spec);

}  // namespace burnish::document
