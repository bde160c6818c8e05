#include "files/read_solver.hpp"

#include "document/described.hpp"
#include "files/read_values.hpp"
#include "solver/descriptions.gen.hpp"

namespace burnish::files {

DdpOptions read_solver(const Reader& reader) {
  DdpOptions options;
  document::read_described(description_of(&options), &options, reader);
  reader.named([&] { options.check(); });
  return options;
}

WarmStart read_guess(const Reader& reader, const std::filesystem::path& folder) {
  if (reader.is_map()) {
    reader.allow_only({"file"});
    return {WarmStart::Kind::File, beside(folder, reader["file"].text())};
  }
  const bool hold = reader.word({"hold", "still"}) == "hold";
  return {hold ? WarmStart::Kind::Hold : WarmStart::Kind::Still, {}};
}

}  // namespace burnish::files
