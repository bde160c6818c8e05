// Conversion of counts and indices to std::size_t, the index type of standard containers.
#pragma once

#include <cstddef>
#include <type_traits>

namespace burnish {

/// Returns a count, an index or an enumerator, which must not be negative, as std::size_t.
template <class N>
requires(std::is_arithmetic_v<N> || std::is_enum_v<N>) constexpr std::size_t to_size(N n) {
  return static_cast<std::size_t>(n);
}

}  // namespace burnish
