// State of the MJCF reader, shared by the readers of all sections.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/findings.hpp"
#include "burnish/model/tree_spec.hpp"
#include "mjcf/compiler.hpp"
#include "mjcf/item.hpp"
#include "mjcf/mesh.hpp"
#include "mjcf/mjcf_source.hpp"
#include "mjcf/omission_notes.hpp"

namespace burnish::mjcf {

inline const std::string world_name = "world";
inline const std::string uneven_forces =
    "asymmetric force ranges are replaced by their larger bound";

struct MeshAsset {
  const XMLElement* xml = nullptr;
  std::string file;  ///< Relative to the main file's folder; empty: the mesh does not have a file
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  /// Pose in the axes of the file that becomes the frame of the mesh; applied before `scale`
  Eigen::Isometry3d reference = Eigen::Isometry3d::Identity();
  MeshInertia inertia = MeshInertia::Legacy;
  bool is_hull = false;  ///< The file asks for the inertia of the convex hull
  bool was_opened = false;
  std::optional<InertiaSpec> of_density_one;  ///< Inertia for density 1, if the file could be read
};

/// Entries of a joint in MuJoCo's qpos, in the order of the file.
struct Coordinate {
  std::size_t joint;          ///< Index in tree.joints
  std::vector<double> start;  ///< Values of qpos0, in the order of a Posture
};

/// Placement relative to a link.
struct LinkPlacement {
  std::string link;
  Eigen::Isometry3d in_link = Eigen::Isometry3d::Identity();
};

/// Shape to draw, with the group of its geom.
struct LinkVisual {
  std::size_t link;
  int group;
  VisualSpec visual;
};

/// Used names of one kind. A new name that already exists gets a number as suffix.
class Names {
 public:
  void take(const std::string& name) { taken_.insert(name); }
  bool is_taken(const std::string& name) const { return taken_.contains(name); }
  std::string unique(const std::string& wanted);

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> numbers_;
};

/// Sections of a model by name. Sections of one name keep their order.
using Sections = std::map<std::string, std::vector<const XMLElement*>, std::less<>>;

/// A model: the main model or an attached one.
struct Part {
  Compiler compiler;
  std::filesystem::path folder;  ///< Folder of the part's file, relative to the main file's folder
  Sections sections;
  /// Tendons, equalities and actuators by section. Copying a body, joint, geom or site adds copies
  /// of the elements that refer to it.
  Sections elements;
};

struct Reading {
  Source source;
  std::map<const XMLElement*, Part> parts;  ///< Models by root element
  DefaultClasses classes;
  std::map<std::string, MeshAsset> meshes;
  std::map<std::string, Eigen::Vector4d> colours;  ///< Colours by material
  TreeSpec tree;
  Findings findings;
  OmissionNotes warning_notes;  ///< Ignored content that changes the dynamics (warnings)
  OmissionNotes info_notes;     ///< Ignored content without effect on the dynamics (notes)
  Names links, joints, frames, loops;
  std::map<std::string, LinkPlacement> sites;
  /// Placement of links in the world at qpos0
  std::map<std::string, Eigen::Isometry3d> link_at_start;
  std::map<std::string, std::size_t> joint_by_name;
  std::vector<Coordinate> coordinates;
  std::vector<LinkVisual> drawn;
  std::map<std::string, int> ignored_elements;  ///< Number of ignored elements, by element name

  std::set<std::pair<const XMLElement*, std::string>> attached;  ///< Root and prefix of each model
  bool has_composed = false;  ///< A <composite> or <flexcomp> exists, whose bodies are not read
  int expanding_depth = 0;
  /// <attach> and <replicate> elements whose expansion has begun
  std::set<const XMLElement*> expanding;

  Reading(const std::string& xml, const std::string& name,
          std::optional<std::filesystem::path> folder);
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  /// Returns the model that an element belongs to. A copy belongs to the model of its original.
  Part& part_of(const XMLElement& element);
  const Compiler& compiler_of(const XMLElement& element) { return part_of(element).compiler; }

  /// Returns the element with its own class, or else with class `around`. Throws Error if the class
  /// does not exist.
  Item item(const XMLElement& xml, const DefaultClass* around = nullptr) const;
  /// Returns the class for the children of an element: `childclass`, or else `around`.
  const DefaultClass* class_inside(const XMLElement& xml, const DefaultClass* around) const;
  /// Returns the end of a message about a missing name: the nearest known name, or else
  /// a hint that bodies of <composite> and <flexcomp> are not read.
  std::string hint(const std::string& name, const std::vector<std::string>& known) const;
  /// Returns the entry of a joint. Throws Error with the nearest known name.
  Coordinate& coordinate(const std::string& joint, const XMLElement& asking);
};

/// Reads the settings and sections of a model from its root.
Part read_part(const XMLElement& root, Reading& reading);

/// Returns the copies that replace an <attach> or <replicate>: bodies, joints, geoms and sites with
/// new names. Also copies the elements of other sections that refer to copied elements. Throws
/// Error if `element` is invalid.
std::vector<const XMLElement*> expand(const XMLElement& element, Reading& reading);

/// Reads an element of <asset>: a mesh, or the colour of a material. Does not open files.
void read_asset(const XMLElement& asset, Reading& reading);

/// Reads <worldbody>: links, joints, sites and visuals.
void read_world(const XMLElement& section, Reading& reading);

struct Geom {
  const Item* item;
  Eigen::Isometry3d around;  ///< Placement of the enclosing frame in the body
};
enum class Weigh {
  No,
  Yes,
  Silently,  ///< For bodies that never move: a missing mass does not matter, so no warning
};
/// Returns the combined inertia of a body's geoms, in the body's frame. Adds the geoms to `drawn`.
InertiaSpec read_geoms(const std::vector<Geom>& geoms, std::size_t link, Weigh how,
                       Reading& reading);

/// Reads <actuator>: effort limits of joints.
void read_actuators(const std::vector<const XMLElement*>& elements, Reading& reading);
/// Reads <tendon>: fixed tendons.
void read_tendons(const std::vector<const XMLElement*>& elements, Reading& reading);
/// Reads <equality>: loops, followers, and held joints and tendons.
void read_equalities(const std::vector<const XMLElement*>& elements, Reading& reading);
/// Reads <keyframe>: postures, without values for followers and held joints.
void read_keyframes(const std::vector<const XMLElement*>& elements, Reading& reading);

}  // namespace burnish::mjcf
