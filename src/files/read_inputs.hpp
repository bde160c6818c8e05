// Reads the inputs of a problem file, and the names by which other parts of the file use them.
#pragma once

#include "files/problem_scope.hpp"

namespace burnish::files {

/// Reads {name: input, ...}. An input is {kind: ..., value: ..., frame: ...}, or a number or a list
/// for a constant scalar or vector. Tables of values over time are in `folder`.
std::vector<InputSpec> read_inputs(const Reader& reader, const Model& model,
                                   const std::filesystem::path& folder);
/// Returns the name of the input that the key `key` of a map states; empty if the map lacks this
/// key. Throws Error with the place and the nearest known name if there is no such input.
std::string read_input_name(const Reader& reader, const char* key, const ProblemSpec& spec);

/// Reads the keys of a cost or a constraint that name inputs.
template <class Term>
void read_term_inputs(const Reader& reader, const ProblemSpec& spec, Term& term) {
  term.offset_input = read_input_name(reader, "offset_input", spec);
  term.friction_ratio_input = read_input_name(reader, "friction_ratio_input", spec);
  term.surface_input = read_input_name(reader, "surface_input", spec);
}
/// Returns `keys`, and the keys with which a cost or constraint refers to inputs.
std::vector<std::string> with_input_keys(std::vector<std::string> keys);

}  // namespace burnish::files
