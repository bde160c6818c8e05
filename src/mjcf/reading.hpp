// An MJCF model while it is read: what its sections share.
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
#include "mjcf/said.hpp"

namespace burnish::mjcf {

inline const std::string world_name = "world";
inline const std::string uneven_forces =
    "ranges of forces that are not symmetric are taken by their larger end";

struct MeshAsset {
  const XMLElement* xml = nullptr;
  std::string file;  ///< from the main file's folder; empty: its vertices are not in a file
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  Eigen::Isometry3d reference = Eigen::Isometry3d::Identity();  ///< put at the origin, then scaled
  MeshInertia inertia = MeshInertia::Legacy;
  bool is_hull = false;  ///< the hull's inertia is wanted
  bool was_opened = false;
  std::optional<InertiaSpec> of_density_one;  ///< of a mesh that was opened and could be read
};

/// A joint as MuJoCo's qpos has it: in the order of the file, at its reference.
struct Coordinate {
  std::size_t joint;          ///< index in tree.joints
  std::vector<double> start;  ///< qpos0 in the order of a Posture
};

/// Something fixed to a link.
struct Placed {
  std::string link;
  Eigen::Isometry3d in_link = Eigen::Isometry3d::Identity();
};

/// A solid to draw, of a geom's group.
struct Drawn {
  std::size_t link;
  int group;
  VisualSpec visual;
};

/// Names of one kind that are taken; a new one gets a number behind it.
class Names {
 public:
  void take(const std::string& name) { taken_.insert(name); }
  bool is_taken(const std::string& name) const { return taken_.contains(name); }
  std::string unique(const std::string& wanted);

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> numbers_;
};

/// Sections of a model by name, each in its own order, whatever the order of the sections is.
using Sections = std::map<std::string, std::vector<const XMLElement*>, std::less<>>;

/// A model by itself: the file's own, or one that is attached.
struct Part {
  Compiler compiler;
  std::filesystem::path folder;  ///< of its file, from that of the main one
  Sections sections;
  /// Of sections that name bodies, joints or sites what they hold, by section. Copies of what is
  /// named bring copies of them.
  Sections elements;
};

struct Reading {
  Source source;
  std::map<const XMLElement*, Part> parts;  ///< by root
  DefaultClasses classes;
  std::map<std::string, MeshAsset> meshes;
  std::map<std::string, Eigen::Vector4d> colours;  ///< by material
  TreeSpec tree;
  Findings findings;
  Said said;   ///< what changes dynamics: warnings
  Said aside;  ///< what does not: notes
  Names links, joints, frames, loops;
  std::map<std::string, Placed> sites;
  std::map<std::string, Eigen::Isometry3d> link_at_start;  ///< in the world at qpos0
  std::map<std::string, std::size_t> joint_by_name;
  std::vector<Coordinate> coordinates;
  std::vector<Drawn> drawn;
  std::map<std::string, int> passed_over;  ///< elements that say nothing here, by name

  std::set<std::pair<const XMLElement*, std::string>> attached;  ///< roots and prefixes
  bool has_composed = false;  ///< a <composite> or <flexcomp>, whose bodies are not read
  int expanding_depth = 0;
  std::set<const XMLElement*> expanding;  ///< of <attach> and <replicate> those that were met

  Reading(const std::string& xml, const std::string& name,
          std::optional<std::filesystem::path> folder);
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  /// The model that an element belongs to; copies belong to that of what they are copied from.
  Part& part_of(const XMLElement& element);
  const Compiler& compiler_of(const XMLElement& element) { return part_of(element).compiler; }

  /// The element under its own class, or else under `around`. Throws Error for an unknown class.
  Item item(const XMLElement& xml, const DefaultClass* around = nullptr) const;
  /// The class of elements inside: `childclass`, or else `around`.
  const DefaultClass* class_inside(const XMLElement& xml, const DefaultClass* around) const;
  /// Why something named may be missing: "; what <composite> and <flexcomp> make is not read", or
  /// the nearest known name.
  std::string hint(const std::string& name, const std::vector<std::string>& known) const;
  /// A joint's entry, by name. Throws Error with the nearest known name.
  Coordinate& coordinate(const std::string& joint, const XMLElement& asking);
};

/// A model's own settings and sections, as its root has them.
Part read_part(const XMLElement& root, Reading& reading);

/// What stands for an <attach> or a <replicate>: copies of bodies, joints, geoms and sites under
/// other names. Elements of other sections that name some of it are copied with them. Throws Error
/// where that cannot be read.
std::vector<const XMLElement*> expand(const XMLElement& element, Reading& reading);

/// Of <asset>: a mesh, or the colour of a material. Nothing is opened.
void read_asset(const XMLElement& asset, Reading& reading);

/// <worldbody>: links, joints, sites and what is drawn.
void read_world(const XMLElement& section, Reading& reading);

struct Geom {
  const Item* item;
  Eigen::Isometry3d around;  ///< placement of the frame that holds it in the body's
};
enum class Weigh {
  No,
  Yes,
  Silently,  ///< of what never moves a mass that is not known is no loss
};
/// What the geoms of a body weigh together, in the body's frame, and what of them is drawn.
InertiaSpec read_geoms(const std::vector<Geom>& geoms, std::size_t link, Weigh how,
                       Reading& reading);

/// <actuator>: effort limits of joints.
void read_actuators(const std::vector<const XMLElement*>& elements, Reading& reading);
/// <tendon>: fixed tendons.
void read_tendons(const std::vector<const XMLElement*>& elements, Reading& reading);
/// <equality>: loops, followers, joints and tendons that are held.
void read_equalities(const std::vector<const XMLElement*>& elements, Reading& reading);
/// <keyframe>: postures. Joints that follow others or are held have no values in them.
void read_keyframes(const std::vector<const XMLElement*>& elements, Reading& reading);

}  // namespace burnish::mjcf
