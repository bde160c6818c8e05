// <asset>: files of meshes and colours of materials.
#include "base/sentence.hpp"
#include "mjcf/reading.hpp"

namespace burnish::mjcf {
namespace {

namespace fs = std::filesystem;

MeshInertia inertia_kind(const Item& item, const Compiler& compiler, MeshAsset& mesh) {
  const std::string word =
      item.text("inertia").value_or(compiler.exact_meshes ? "exact" : "legacy");
  mesh.is_hull = word == "convex";
  if (word == "exact" || word == "convex") return MeshInertia::Exact;
  if (word == "shell") return MeshInertia::Shell;
  if (word == "legacy") return MeshInertia::Legacy;
  refuse_at(item.xml(),
            "inertia is " + in_quotes(word) + "; wanted legacy, exact, convex or shell");
}

void read_mesh(const Item& item, Reading& reading) {
  MeshAsset mesh;
  mesh.xml = &item.xml();
  const std::string stated = item.text("file").value_or("");
  fs::path file = stated;
  std::string name = item.name();
  if (name.empty()) name = file.stem().string();
  if (name.empty()) refuse_at(item.xml(), "it has neither a name nor a file; wanted one of them");
  const Part& part = reading.part_of(item.xml());
  if (part.compiler.strip_paths) file = file.filename();
  // If `file` is an absolute path, the operator / ignores the folders.
  if (!stated.empty()) mesh.file = (part.folder / part.compiler.mesh_folder / file).string();
  if (const auto scale = item.numbers("scale", 3))
    mesh.scale = Eigen::Vector3d((*scale)[0], (*scale)[1], (*scale)[2]);
  if (const auto at = item.numbers("refpos", 3))
    mesh.reference.translation() = Eigen::Vector3d((*at)[0], (*at)[1], (*at)[2]);
  if (const auto turned = item.numbers("refquat", 4))
    mesh.reference.linear() = quaternion_of(*turned, item.xml()).toRotationMatrix();
  mesh.inertia = inertia_kind(item, part.compiler, mesh);
  if (!reading.meshes.emplace(name, mesh).second)
    refuse_at(item.xml(), "mesh " + in_quotes(name) + " is defined twice");
}

void read_material(const Item& item, Reading& reading) {
  Eigen::Vector4d colour = Eigen::Vector4d::Ones();
  if (const auto rgba = item.numbers("rgba", 4))
    colour = Eigen::Vector4d((*rgba)[0], (*rgba)[1], (*rgba)[2], (*rgba)[3]);
  reading.colours.emplace(item.name(), colour);
}

}  // namespace

void read_asset(const XMLElement& asset, Reading& reading) {
  const std::string_view kind = asset.Name();
  if (kind == "mesh")
    reading.findings.attempt([&] { read_mesh(reading.item(asset), reading); });
  else if (kind == "material")
    reading.findings.attempt_or_warn([&] { read_material(reading.item(asset), reading); },
                                     "; it is drawn in grey");
  else if (kind != "model")  // attached models are read on demand
    ++reading.ignored_elements[std::string(kind)];
}

}  // namespace burnish::mjcf
