// Writes a model as MJCF text for MuJoCo, and loads it with the model's exact inertias.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <string>

#include "burnish/model/model.hpp"

namespace burnish::mujoco {

struct Free {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using ModelPointer = std::unique_ptr<mjModel, Free>;
using DataPointer = std::unique_ptr<mjData, Free>;

/// Parts of the MJCF text other than the robot.
struct Additions {
  std::string options;                ///< Attributes of <option>
  std::string world;                  ///< Elements of the world body
  std::map<int, std::string> bodies;  ///< Elements of a body, by joint index
  std::string sections;               ///< Sections after <worldbody>
  bool joint_stops = false;           ///< Whether joints stop at their limits
};

/// Returns the values with all digits, separated by blanks.
template <class... Values>
std::string numbers(Values... values) {
  std::string text;
  char one[40];
  ((std::snprintf(one, sizeof one, "%.17g ", static_cast<double>(values)), text += one), ...);
  text.pop_back();
  return text;
}
/// Returns the attributes pos and quat of a placement.
std::string pose_attributes(const Eigen::Isometry3d& placement);

/// Return names in the text: of the body that joint `body` moves ("world" for -1), of a joint, and
/// of a frame's site.
std::string body_name(int body);
std::string joint_name(int joint);
std::string site_name(int frame);

/// Returns the text of a robot with one site for each frame. Followers are independent joints. The
/// moments of inertia are those of spheres, because MuJoCo rejects moments that violate the
/// triangle inequality by rounding. load_figures() sets the true moments.
std::string describe(const Model& model, const Additions& additions = {});

/// Compiles a text. Throws Error with MuJoCo's message.
ModelPointer compile(const std::string& text);

/// Sets masses, inertias and armatures with all digits; MuJoCo's own reading of an inertia has an
/// accuracy of seven digits. Eigen computes the principal axes.
void load_figures(const Model& model, mjModel& theirs, mjData& data);

}  // namespace burnish::mujoco
