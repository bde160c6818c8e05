#include "record/mesh_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "robots/known_robots.hpp"
#ifdef BURNISH_HAS_ASSIMP
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#endif

namespace burnish {
namespace {

namespace fs = std::filesystem;

/// Maximum number of triangles of a robot's meshes; 400,000 triangles make a page of 18 MB.
constexpr std::size_t max_triangles = 400'000;

std::vector<fs::path> folders_in(const char* variable, const char* below) {
  std::vector<fs::path> folders;
  const char* const listed = std::getenv(variable);
  std::istringstream stream(listed == nullptr ? "" : listed);
  for (std::string folder; std::getline(stream, folder, ':');)
    if (!folder.empty()) folders.push_back(fs::path(folder) / below);
  return folders;
}

bool is_file(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored);
}

/// Returns the existing file with the path `rest` in a package. The folder of the package is in
/// `folder`, or is `folder` itself. Returns an empty path if there is no such file.
fs::path file_in_package(const fs::path& folder, const std::string& package, const fs::path& rest) {
  if (is_file(folder / package / rest)) return folder / package / rest;
  if (folder.filename() == package && is_file(folder / rest)) return folder / rest;
  return {};
}

#ifdef BURNISH_HAS_ASSIMP
Mesh read_mesh(const fs::path& file) {
  Assimp::Importer importer;
  // Robot descriptions assume z up in Collada files, whatever axis the files state.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* const scene =
      importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_PreTransformVertices |
                                           aiProcess_JoinIdenticalVertices | aiProcess_SortByPType |
                                           aiProcess_DropNormals);
  Mesh mesh;
  if (scene == nullptr) return mesh;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& submesh = *scene->mMeshes[m];
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size() / 3);
    for (unsigned v = 0; v < submesh.mNumVertices; ++v)
      for (const float x : {submesh.mVertices[v].x, submesh.mVertices[v].y, submesh.mVertices[v].z})
        mesh.vertices.push_back(x);
    for (unsigned f = 0; f < submesh.mNumFaces; ++f) {
      if (submesh.mFaces[f].mNumIndices != 3) continue;
      for (unsigned k = 0; k < 3; ++k)
        mesh.triangles.push_back(first + submesh.mFaces[f].mIndices[k]);
    }
  }
  return mesh;
}
#else
Mesh read_mesh(const fs::path&) { return {}; }
#endif

}  // namespace

std::vector<fs::path> mesh_folders(const std::string& robot) {
  std::vector<fs::path> folders;
  std::error_code ignored;
  const auto add = [&](const fs::path& file) {
    const fs::path folder =
        fs::weakly_canonical(fs::absolute(file, ignored), ignored).parent_path();
    if (std::find(folders.begin(), folders.end(), folder) == folders.end())
      folders.push_back(folder);
  };
  if (const fs::path file = description_file(robot); !file.empty()) add(file);
  for (const std::string& name : {robot, robot.substr(0, robot.rfind(':'))})
    if (const auto file = robot_file(name)) add(*file);
  return folders;
}

fs::path mesh_file(const std::string& uri, const fs::path& folder) {
  constexpr std::string_view in_package = "package://", in_file = "file://";
  if (uri.starts_with(in_file)) {
    const fs::path file = uri.substr(in_file.size());
    return is_file(file) ? file : fs::path();
  }
  if (!uri.starts_with(in_package)) {
    const fs::path file = folder / uri;  // An absolute path replaces `folder`
    return is_file(file) ? file : fs::path();
  }
  const std::string name = uri.substr(in_package.size());
  const std::size_t slash = name.find('/');
  if (slash == std::string::npos) return {};
  const std::string package = name.substr(0, slash);
  const fs::path rest = name.substr(slash + 1);
  std::vector<fs::path> folders;
  std::error_code ignored;
  for (fs::path above = fs::absolute(folder, ignored); above.has_relative_path();
       above = above.parent_path())
    folders.push_back(above);
  for (fs::path& each : folders_in("ROS_PACKAGE_PATH", "")) folders.push_back(std::move(each));
  for (fs::path& each : folders_in("AMENT_PREFIX_PATH", "share"))
    folders.push_back(std::move(each));
  for (const fs::path& each : folders)
    if (fs::path file = file_in_package(each, package, rest); !file.empty()) return file;
  // Descriptions that were copied out of a package often keep the package's folders. The path is
  // therefore also searched in `levels` folders, from `folder` upwards.
  constexpr int levels = 3;
  fs::path above = fs::absolute(folder, ignored);
  for (int level = 0; level < levels; ++level, above = above.parent_path())
    if (is_file(above / rest)) return above / rest;
  return {};
}

std::map<std::string, Mesh> load_meshes(const Model& model, const std::vector<fs::path>& folders) {
  std::map<std::string, Mesh> meshes;
  std::size_t triangles = 0;
  for (const Visual& visual : model.visuals) {
    const auto* const shape = std::get_if<MeshShape>(&visual.shape);
    if (shape == nullptr || meshes.contains(shape->uri)) continue;
    fs::path file;
    for (std::size_t i = 0; i < folders.size() && file.empty(); ++i)
      file = mesh_file(shape->uri, folders[i]);
    if (file.empty()) continue;
    Mesh mesh = read_mesh(file);
    const std::size_t count = mesh.triangles.size() / 3;
    if (count == 0 || triangles + count > max_triangles) continue;
    triangles += count;
    meshes[shape->uri] = std::move(mesh);
  }
  return meshes;
}

}  // namespace burnish
