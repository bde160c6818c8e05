#include "robots/description.hpp"

#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "burnish/urdf/urdf.hpp"
#include "mjcf/read_model.hpp"

namespace burnish {
namespace {

/// Returns the name of the first element of an XML text, empty without elements. Does not check the
/// text; the reader of URDF rejects texts that are not XML.
std::string_view outermost_element(std::string_view text) {
  std::size_t at = text.find('<');
  while (at != std::string_view::npos) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) {
      at = text.find("-->", at);
    } else if (!rest.starts_with("<?") && !rest.starts_with("<!")) {
      return rest.substr(1, rest.find_first_of(" \t\r\n/>", 1) - 1);
    }
    if (at != std::string_view::npos) at = text.find('<', at + 1);
  }
  return {};
}

}  // namespace

TreeSpec read_description(const std::filesystem::path& file) {
  return read_robot_description(file).tree;
}

RobotDescription read_robot_description(const std::filesystem::path& file) {
  const std::string text = read_text(file, "URDF or MJCF file");
  const std::string name = file.string();
  if (text.starts_with("#usda") || text.starts_with("PXR-USDC"))
    refuse(name, "the file is in USD, which is not supported; wanted URDF or MJCF");
  const std::string_view outermost = outermost_element(text);
  if (outermost == "sdf")
    refuse(name,
           "its outermost element is <sdf>, which is not supported; wanted <robot> (URDF) or "
           "<mujoco> (MJCF)");
  if (outermost == "mujocoinclude")
    refuse(name,
           "its outermost element is <mujocoinclude>, which contains only a part of a model; "
           "wanted the file that includes it");
  if (outermost == "mujoco") return {mjcf::read_model(text, name, file.parent_path())};
  return {parse_urdf(text, name), parse_collisions(text, name)};
}

std::string description_key(const std::filesystem::path& file) {
  return outermost_element(read_text(file, "URDF or MJCF file")) == "mujoco" ? "mjcf" : "urdf";
}

}  // namespace burnish
