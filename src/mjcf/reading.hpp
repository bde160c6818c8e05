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

struct Reading {
  Source source;
  Compiler compiler;
  DefaultClasses classes;
  std::map<std::string, MeshAsset> meshes;
  std::map<std::string, Eigen::Vector4d> colours;  ///< by material
  TreeSpec tree;
  Findings findings;
  Said said;
  Names links, joints, frames, loops;
  std::map<std::string, Placed> sites;
  std::map<std::string, Eigen::Isometry3d> link_at_start;  ///< in the world at qpos0
  std::map<std::string, std::size_t> joint_by_name;
  std::vector<Coordinate> coordinates;
  std::map<std::string, double> held_at;  ///< values of joints that equalities hold
  std::vector<Drawn> drawn;
  std::map<std::string, int> passed_over;  ///< elements that say nothing here, by name

  Reading(const std::string& xml, const std::string& name,
          std::optional<std::filesystem::path> folder)
      : source(xml, name, std::move(folder)), findings(name) {}

  /// The element under its own class, or else under `around`. Throws Error for an unknown class.
  Item item(const XMLElement& xml, const DefaultClass* around = nullptr) const;
  /// The class of elements inside: `childclass`, or else `around`.
  const DefaultClass* class_inside(const XMLElement& xml, const DefaultClass* around) const;
  /// A joint's entry, by name. Throws Error with the nearest known name.
  Coordinate& coordinate(const std::string& joint, const XMLElement& asking);
};

/// <asset>: meshes and the colours of materials. Nothing is opened.
void read_assets(const XMLElement& section, Reading& reading);

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
