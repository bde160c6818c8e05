#include "mjcf/mesh.hpp"

#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "base/parse_number.hpp"
#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "base/to_size.hpp"
#include "base/words_in.hpp"

namespace burnish::mjcf {
namespace {

using Eigen::Vector3d;

static_assert(std::endian::native == std::endian::little, "mesh files are little-endian");

constexpr std::size_t max_vertices = 5'000'000;  // Limit of vertices and of faces; chosen by hand

/// Reader of consecutive numbers in a binary file.
class Bytes {
 public:
  Bytes(const std::string& bytes, const std::string& source) : bytes_(bytes), source_(source) {}

  template <class Number>
  Number next() {
    Number value;
    if (bytes_.size() - at_ < sizeof value) refuse(source_, "the mesh file ends too early");
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }
  Vector3d vector() {
    const double x = next<float>(), y = next<float>(), z = next<float>();
    return {x, y, z};
  }
  void skip(std::size_t count) {
    if (bytes_.size() - at_ < count) refuse(source_, "the mesh file ends too early");
    at_ += count;
  }
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  const std::string& bytes_;
  const std::string& source_;
  std::size_t at_ = 0;
};

void add_triangle(const std::array<Vector3d, 3>& corners, Triangles& mesh) {
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.faces.push_back({first, first + 1, first + 2});
}

constexpr std::size_t stl_header = 80, stl_facet = 50;

Triangles from_binary_stl(const std::string& bytes, const std::string& source) {
  Bytes file(bytes, source);
  file.skip(stl_header);
  const auto count = file.next<std::uint32_t>();
  if (file.left() / stl_facet < count) refuse(source, "the mesh file ends too early");
  Triangles mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    file.vector();  // Skips the normal, which follows from the corners
    std::array<Vector3d, 3> corners;
    for (Vector3d& corner : corners) corner = file.vector();
    file.next<std::uint16_t>();
    add_triangle(corners, mesh);
  }
  return mesh;
}

/// Reader of the words of a text, line by line.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}
  /// Returns the next word of the current line; empty at the end of the line.
  std::string_view next() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r'))
      ++at_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) == 0) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  bool next_line() {
    at_ = text_.find('\n', at_);
    if (at_ == std::string_view::npos) at_ = text_.size();
    return ++at_ < text_.size();
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

Vector3d vertex_of(Words& words, const std::string& source) {
  Vector3d vertex;
  for (double& x : vertex) {
    const std::string_view word = words.next();
    const auto value = parse_number(word);
    if (!value || !std::isfinite(*value))
      refuse(source, "the mesh has the coordinate " + in_quotes(word) + "; wanted a number");
    x = *value;
  }
  return vertex;
}

Triangles from_ascii_stl(const std::string& text, const std::string& source) {
  Triangles mesh;
  std::array<Vector3d, 3> corners;
  std::size_t corner = 0;
  Words words(text);
  do {
    const std::string_view word = words.next();
    if (word == "facet") corner = 0;
    if (word != "vertex" || corner == 3) continue;
    corners[corner++] = vertex_of(words, source);
    if (corner == 3) add_triangle(corners, mesh);
  } while (words.next_line());
  return mesh;
}

/// Returns the index of the vertex that an OBJ face names as "7", "7/1" or "-2//3". Positive
/// numbers in the file count from 1, negative numbers from the end.
int index_of(std::string_view word, std::size_t vertices, const std::string& source) {
  long stated = 0;
  std::from_chars(word.data(), word.data() + word.size(), stated);
  const long count = static_cast<long>(vertices);
  const long index = stated < 0 ? count + stated : stated - 1;
  if (stated == 0 || index < 0 || index >= count)
    refuse(source, "the mesh has a face with vertex number " + in_quotes(word) +
                       "; wanted at most " + std::to_string(vertices) + ", the number of vertices");
  return static_cast<int>(index);
}

Triangles from_obj(const std::string& text, const std::string& source) {
  Triangles mesh;
  Words words(text);
  do {
    const std::string_view kind = words.next();
    if (kind == "v") mesh.vertices.push_back(vertex_of(words, source));
    if (kind != "f") continue;
    std::vector<int> corners;
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
      corners.push_back(index_of(word, mesh.vertices.size(), source));
    for (std::size_t i = 2; i < corners.size(); ++i)
      mesh.faces.push_back({corners[0], corners[i - 1], corners[i]});
  } while (words.next_line());
  return mesh;
}

Triangles from_msh(const std::string& bytes, const std::string& source) {
  Bytes file(bytes, source);
  std::array<std::size_t, 4> counts{};  // vertices, normals, texture coordinates, faces
  for (std::size_t& count : counts) {
    const auto stated = file.next<std::int32_t>();
    if (stated < 0 || to_size(stated) > max_vertices)
      refuse(source, "the mesh states " + std::to_string(stated) +
                         " vertices or faces; wanted 0 to " + std::to_string(max_vertices));
    count = to_size(stated);
  }
  Triangles mesh;
  for (std::size_t i = 0; i < counts[0]; ++i) mesh.vertices.push_back(file.vector());
  file.skip(sizeof(float) * (3 * counts[1] + 2 * counts[2]));
  for (std::size_t i = 0; i < counts[3]; ++i) {
    std::array<int, 3> face{};
    for (int& corner : face) {
      corner = file.next<std::int32_t>();
      if (corner < 0 || to_size(corner) >= counts[0])
        refuse(source, "the mesh has a face with a vertex that does not exist");
    }
    mesh.faces.push_back(face);
  }
  return mesh;
}

/// Integrals over the tetrahedron between a face and the origin; for a shell, over the face.
struct Piece {
  double measure;  // Signed volume [m^3], or area of a shell's face [m^2]
  Vector3d centre;
  Eigen::Matrix3d second_moment;  // Integral of x x^T over all points x
};

Piece piece_of(const Vector3d& a, const Vector3d& b, const Vector3d& c, MeshInertia how) {
  const bool shell = how == MeshInertia::Shell;
  double measure = shell ? 0.5 * (b - a).cross(c - a).norm() : a.dot(b.cross(c)) / 6.0;
  if (how == MeshInertia::Legacy) measure = std::abs(measure);
  const Vector3d sum = a + b + c;
  // Integral of x x^T over a simplex with n corners p_i (for a tetrahedron, p_1 is the origin):
  // measure / (n (n + 1)) (sum p_i p_i^T + sum p_i sum p_i^T).
  const Eigen::Matrix3d squares =
      a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose();
  return {measure, sum / (shell ? 3.0 : 4.0), measure / (shell ? 12.0 : 20.0) * squares};
}

/// Returns the centroid of the surface, the apex of the tetrahedra in the legacy method.
Vector3d surface_centre(const Triangles& mesh) {
  Vector3d sum = Vector3d::Zero();
  double area = 0.0;
  for (const auto& [i, j, k] : mesh.faces) {
    const auto at = [&](int index) { return mesh.vertices[to_size(index)]; };
    const Piece piece = piece_of(at(i), at(j), at(k), MeshInertia::Shell);
    area += piece.measure;
    sum += piece.measure * piece.centre;
  }
  return area > 0.0 ? Vector3d(sum / area) : Vector3d::Zero();
}

struct Sum {
  double measure = 0.0;
  Vector3d centre = Vector3d::Zero();
  Eigen::Matrix3d second_moment = Eigen::Matrix3d::Zero();  // About the point `from`
};

Sum sum_of(const Triangles& mesh, MeshInertia how, const Vector3d& from) {
  Sum sum;
  for (const auto& [i, j, k] : mesh.faces) {
    const auto at = [&](int index) { return Vector3d(mesh.vertices[to_size(index)] - from); };
    const Piece piece = piece_of(at(i), at(j), at(k), how);
    sum.measure += piece.measure;
    sum.centre += piece.measure * piece.centre;
    sum.second_moment += piece.second_moment;
  }
  if (sum.measure > 0.0) sum.centre = from + sum.centre / sum.measure;
  return sum;
}

}  // namespace

Triangles parse_triangles(const std::string& bytes, const std::string& ending,
                          const std::string& source) {
  const std::string kind = lower_case(ending);
  Triangles mesh;
  if (kind == ".stl") {
    // Binary files may also begin with "solid", so the number of facets decides.
    std::uint32_t count = 0;
    if (bytes.size() >= stl_header + sizeof count)
      std::memcpy(&count, bytes.data() + stl_header, sizeof count);
    const bool binary = bytes.size() == stl_header + sizeof count + stl_facet * count ||
                        !bytes.starts_with("solid");
    mesh = binary ? from_binary_stl(bytes, source) : from_ascii_stl(bytes, source);
  } else if (kind == ".obj") {
    mesh = from_obj(bytes, source);
  } else if (kind == ".msh") {
    mesh = from_msh(bytes, source);
  } else {
    refuse(source,
           "the mesh file has the ending " + in_quotes(ending) + "; wanted .stl, .obj or .msh");
  }
  if (mesh.faces.empty()) refuse(source, "the mesh has no triangle");
  return mesh;
}

Triangles read_triangles(const std::filesystem::path& file) {
  return parse_triangles(read_text(file, "mesh"), file.extension().string(), file.string());
}

InertiaSpec inertia_of(const Triangles& mesh, MeshInertia how, const std::string& source) {
  // Sums about the surface's centroid give the centre of mass; the inertia is summed about the
  // centre of mass.
  const Sum about_surface = sum_of(mesh, how, surface_centre(mesh));
  const Sum sum = sum_of(mesh, how, about_surface.centre);
  constexpr double no_volume = 1e-15;
  if (!(about_surface.measure > no_volume) || !(sum.measure > no_volume) ||
      !sum.second_moment.allFinite())
    refuse(source, "the mesh encloses no volume, or its triangles point inwards");
  InertiaSpec result;
  result.mass = sum.measure;
  result.com = about_surface.centre;
  result.inertia_at_com =
      sum.second_moment.trace() * Eigen::Matrix3d::Identity() - sum.second_moment;
  return result;
}

}  // namespace burnish::mjcf
