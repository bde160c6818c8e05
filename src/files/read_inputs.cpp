#include "files/read_inputs.hpp"

#include <algorithm>

#include "base/sentence.hpp"
#include "burnish/model/inertia.hpp"
#include "files/read_target.hpp"
#include "ocp/descriptions.gen.hpp"

namespace burnish::files {
namespace {

/// Reads the value of a scalar: a number, or a path over time.
Signal read_scalar(const std::filesystem::path& folder, const Reader& reader) {
  if (!reader.is_map()) return reader.number();
  reader.allow_only({"line", "sine", "points"});
  return read_target(folder, {{{"value", 1}}}, reader);
}

/// Reads the value of a rotation: constant, or a path over time.
Signal read_turn(const std::filesystem::path& folder, const Reader& reader) {
  if (reader.has("line") || reader.has("points")) return read_rotation_over_time(folder, reader);
  return Eigen::VectorXd(document::read_rotation(reader).coeffs());
}

Signal read_value(InputKind kind, const std::filesystem::path& folder, const Reader& reader) {
  switch (kind) {
    case InputKind::Scalar:
      return read_scalar(folder, reader);
    case InputKind::Vector:
      return reader.numbers();
    case InputKind::Rotation:
      return read_turn(folder, reader);
    case InputKind::Surface:
    case InputKind::Inertia:
      break;
  }
  reader.refuse(
      "a surface or an inertia gets its value from set_input(); wanted no value in the file");
}

InputSpec read_input(const std::string& name, const Reader& reader, const Model& model,
                     const std::filesystem::path& folder) {
  if (reader.is_number()) return {.name = name, .value = reader.number()};
  if (reader.is_list()) return {.name = name, .kind = InputKind::Vector, .value = reader.numbers()};
  if (!reader.is_map())
    reader.refuse("it is not an input; wanted a number, a list of numbers, or keys such as 'kind'");
  reader.allow_only({"kind", "value", "frame"});
  InputSpec input{.name = name};
  const Words& words = words_of(input.kind);
  if (const auto kind = reader.find("kind"))
    input.kind = static_cast<InputKind>(words.value_of(kind->word(words.list())));
  if (input.kind == InputKind::Vector)
    input.value = read_value(input.kind, folder, reader["value"]);
  else if (const auto value = reader.find("value"))
    input.value = read_value(input.kind, folder, *value);
  if (input.kind == InputKind::Inertia) {
    const Reader frame = reader["frame"];
    input.frame = frame.text();
    frame.named([&] { (void)frame_on_body("inertia", model, input.frame); });
  } else if (const auto frame = reader.find("frame")) {
    frame->refuse("only an input of the kind 'inertia' has a frame; wanted no frame");
  }
  return input;
}

}  // namespace

std::vector<InputSpec> read_inputs(const Reader& reader, const Model& model,
                                   const std::filesystem::path& folder) {
  std::vector<InputSpec> inputs;
  for (const auto& [name, input] : reader.items())
    inputs.push_back(read_input(name, input, model, folder));
  return inputs;
}

std::string read_input_name(const Reader& reader, const char* key, const ProblemSpec& spec) {
  const auto stated = reader.find(key);
  if (!stated) return "";
  const std::string name = stated->text();
  std::vector<std::string> known;
  for (const InputSpec& input : spec.inputs) known.push_back(input.name);
  if (std::find(known.begin(), known.end(), name) != known.end()) return name;
  stated->refuse("unknown input " + in_quotes(name) +
                 (known.empty() ? "; the file has no 'inputs'" : did_you_mean(name, known)));
}

std::vector<std::string> with_input_keys(std::vector<std::string> keys) {
  keys.insert(keys.end(), {"offset_input", "friction_ratio_input", "surface_input"});
  return keys;
}

}  // namespace burnish::files
