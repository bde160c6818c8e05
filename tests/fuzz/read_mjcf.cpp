#include "burnish/mjcf/mjcf.hpp"
#include "burnish/model/model.hpp"
#include "fuzz/readers.hpp"
#include "mjcf/mesh.hpp"

namespace burnish::fuzz {
namespace {

/// Reads a mesh from a text "mesh .obj" followed by the contents of the file.
void read_mesh(const std::string& text) {
  constexpr std::size_t header = 9;  // "mesh .obj"
  mjcf::inertia_of(mjcf::parse_triangles(text.substr(header), text.substr(5, 4), "input"),
                   mjcf::MeshInertia::Legacy, "input");
}

void read(const std::string& text) {
  if (text.starts_with("mesh .") && text.size() > 9) return read_mesh(text);
  build_model(parse_mjcf(text, "input.xml"), {});
}

}  // namespace

const Reader mjcf{"mjcf", read};

}  // namespace burnish::fuzz
