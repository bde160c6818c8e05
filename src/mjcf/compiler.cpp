#include "mjcf/compiler.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"

namespace burnish::mjcf {
namespace {

constexpr double min_length = 1e-14;  // Length below which a vector counts as zero

Eigen::Vector3d direction(const std::vector<double>& values, std::size_t first, const char* what,
                          const XMLElement& stating) {
  const Eigen::Vector3d stated(values[first], values[first + 1], values[first + 2]);
  if (stated.norm() < min_length)
    refuse_at(stating, std::string(what) + " contains a direction of zero length");
  return stated.normalized();
}

Eigen::Matrix3d from_xyaxes(const std::vector<double>& stated, const XMLElement& at) {
  const Eigen::Vector3d x = direction(stated, 0, "xyaxes", at);
  const Eigen::Vector3d given = direction(stated, 3, "xyaxes", at);
  const Eigen::Vector3d y = given - x.dot(given) * x;
  if (y.norm() < 1e-9) refuse_at(at, "xyaxes states two parallel axes");
  Eigen::Matrix3d axes;
  axes << x, y.normalized(), x.cross(y.normalized());
  return axes;
}

Eigen::Matrix3d from_euler(const std::vector<double>& stated, const Compiler& compiler) {
  Eigen::Quaterniond turned = Eigen::Quaterniond::Identity();
  for (std::size_t i = 0; i < 3; ++i) {
    const char axis = compiler.euler[i];
    const char small = static_cast<char>(axis < 'a' ? axis - 'A' + 'a' : axis);
    const Eigen::Quaterniond turn(
        Eigen::AngleAxisd(compiler.angle(stated[i]), Eigen::Vector3d::Unit(small - 'x')));
    turned = axis == small ? turned * turn : turn * turned;
  }
  return turned.normalized().toRotationMatrix();
}

struct Form {
  const char* attribute;
  std::size_t count;
};
constexpr std::array<Form, 5> forms = {
    {{"quat", 4}, {"axisangle", 4}, {"xyaxes", 6}, {"zaxis", 3}, {"euler", 3}}};

Eigen::Matrix3d rotation_by(const Form& form, const XMLElement& at, const Compiler& compiler) {
  const std::vector<double> stated = *numbers(at, form.attribute, form.count, place_of(at));
  const std::string_view name = form.attribute;
  if (name == "quat") return quaternion_of(stated, at).toRotationMatrix();
  if (name == "xyaxes") return from_xyaxes(stated, at);
  if (name == "zaxis") return rotation_to(direction(stated, 0, "zaxis", at));
  if (name == "euler") return from_euler(stated, compiler);
  return Eigen::AngleAxisd(compiler.angle(stated[3]), direction(stated, 0, "axisangle", at))
      .toRotationMatrix();
}

/// Returns the form in which the element itself states its orientation (such as euler), or nullptr.
const Form* form_of(const XMLElement& at) {
  const Form* found = nullptr;
  for (const Form& form : forms) {
    if (at.Attribute(form.attribute) == nullptr) continue;
    if (found != nullptr)
      refuse_at(at, std::string(found->attribute) + " and " + form.attribute +
                        " both state its orientation; wanted one of them");
    found = &form;
  }
  return found;
}

bool bool_of(const XMLElement& element, const char* attribute, bool otherwise) {
  return Item(element, nullptr).flag(attribute, otherwise);
}

void read_euler(const XMLElement& element, std::string& euler) {
  const char* stated = element.Attribute("eulerseq");
  if (stated == nullptr) return;
  const std::string_view axes = stated;
  if (axes.size() != 3 || axes.find_first_not_of("xyzXYZ") != std::string_view::npos)
    refuse_at(element, "eulerseq is " + in_quotes(axes) + "; wanted three of x, y, z, X, Y, Z");
  euler = axes;
}

}  // namespace

Eigen::Quaterniond quaternion_of(const std::vector<double>& wxyz, const XMLElement& stating) {
  const Eigen::Quaterniond stated(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  if (stated.norm() < min_length) refuse_at(stating, "a zero quaternion is not a rotation");
  return stated.normalized();
}

double Compiler::angle(double stated) const {
  return degrees ? stated / 180.0 * std::numbers::pi : stated;
}

void Compiler::read(const XMLElement& element) {
  const Item item(element, nullptr);
  if (item.text("coordinate").value_or("local") == "global")
    refuse_at(element, "coordinate is 'global', which MuJoCo no longer supports; wanted local");
  if (const auto unit = item.text("angle")) {
    if (*unit != "degree" && *unit != "radian")
      refuse_at(element, "angle is " + in_quotes(*unit) + "; wanted degree or radian");
    degrees = *unit == "degree";
  }
  read_euler(element, euler);
  autolimits = bool_of(element, "autolimits", autolimits);
  strip_paths = bool_of(element, "strippath", strip_paths);
  exact_meshes = bool_of(element, "exactmeshinertia", exact_meshes);
  balance_inertia = bool_of(element, "balanceinertia", balance_inertia);
  if (item.stating("inertiafromgeom") != nullptr) {
    const auto choice = item.choice("inertiafromgeom");
    inertia_from_geom = !choice   ? InertiaFromGeom::Auto
                        : *choice ? InertiaFromGeom::Yes
                                  : InertiaFromGeom::No;
  }
  min_mass = item.number("boundmass", min_mass);
  min_inertia = item.number("boundinertia", min_inertia);
  total_mass = item.number("settotalmass", total_mass);
  if (const auto groups = item.numbers("inertiagrouprange", 2)) {
    first_group = static_cast<int>(std::clamp((*groups)[0], -1e6, 1e6));
    last_group = static_cast<int>(std::clamp((*groups)[1], -1e6, 1e6));
  }
  for (const char* attribute : {"assetdir", "meshdir"})
    if (const auto folder = item.text(attribute)) mesh_folder = *folder;
}

Eigen::Matrix3d orientation_of(const Item& item, const Compiler& compiler) {
  if (const Form* own = form_of(item.xml())) return rotation_by(*own, item.xml(), compiler);
  for (const Form& form : forms)
    if (const XMLElement* at = item.stating(form.attribute))
      return rotation_by(form, *at, compiler);
  return Eigen::Matrix3d::Identity();
}

Eigen::Isometry3d placement_of(const Item& item, const Compiler& compiler) {
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  if (const auto pos = item.numbers("pos", 3))
    placement.translation() = Eigen::Vector3d((*pos)[0], (*pos)[1], (*pos)[2]);
  placement.linear() = orientation_of(item, compiler);
  return placement;
}

Eigen::Matrix3d rotation_to(const Eigen::Vector3d& z) {
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), z)
      .normalized()
      .toRotationMatrix();
}

}  // namespace burnish::mjcf
