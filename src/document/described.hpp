// Described specifications as YAML: read strictly, written as they read back.
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

/// What descriptions alone do not know of values in files.
struct Reading {
  /// Values of these types are read like this, in place of what their description says.
  std::map<std::type_index, std::function<void(void* value, const Reader& reader)>> types = {};
  /// Checks of names, or of lists of them, by Field::name_of.
  std::map<std::string, std::function<void(const Reader& names)>> names = {};
  /// Keys of the outermost value that somebody else reads.
  std::vector<std::string> also = {};
};

/// Of Reading::types: values that `read` makes.
template <class Read, class Value = std::invoke_result_t<Read, const Reader&>>
std::pair<const std::type_index, std::function<void(void*, const Reader&)>> read_by(Read read) {
  return {typeid(Value), [read](void* value, const Reader& reader) {
            *static_cast<Value*>(value) = read(reader);
          }};
}

/// Refuses what the entry does not take, with the place.
void read_entry(const Field& field, void* spec, const Reader& reader);
/// The keys that are there; what no key can state is left as it is.
void read_described(const Description& description, void* spec, const Reader& reader,
                    const Reading& reading = {});
/// On one line; nothing for an empty text, which is not written.
std::optional<std::string> entry_text(const Field& field, const void* spec);

}  // namespace burnish::document
