// A model written in MuJoCo's language, and loaded with exactly the model's figures.
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

/// What stands in the text besides the robot.
struct Additions {
  std::string options;                ///< attributes of <option>
  std::string world;                  ///< elements of the world's body
  std::map<int, std::string> bodies;  ///< elements of a body, by joint index
  std::string sections;               ///< after the bodies
  bool joint_stops = false;           ///< of revolute and prismatic joints with limits
};

/// Values between blanks, with all digits.
template <class... Values>
std::string numbers(Values... values) {
  std::string text;
  char one[40];
  ((std::snprintf(one, sizeof one, "%.17g ", static_cast<double>(values)), text += one), ...);
  text.pop_back();
  return text;
}
/// The attributes pos and quat.
std::string pose_attributes(const Eigen::Isometry3d& placement);

/// Names in the text: of the body that joint `body` carries ("world" for -1), of a joint of one
/// entry, of a frame's site.
std::string body_name(int body);
std::string joint_name(int joint);
std::string site_name(int frame);

/// The robot with one site per frame; followers move by themselves. MuJoCo refuses moments that
/// published figures round past the triangle inequality, so the text has a ball's, and
/// load_figures() puts in the true ones.
std::string describe(const Model& model, const Additions& additions = {});

/// Compiles a text. Throws Error with MuJoCo's sentence.
ModelPointer compile(const std::string& text);

/// Masses, inertias and armature to the last digit: MuJoCo's own reading of an inertia is good to
/// seven. Principal axes come from Eigen.
void load_figures(const Model& model, mjModel& theirs, mjData& data);

}  // namespace burnish::mujoco
