// Keys of a task file: what makes the plant differ from what the controller believes.
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/task_keys.hpp"

namespace burnish::polishing {
namespace {

using files::YamlReader;

TaskKey preset_key() {
  return {"preset", "",
          [](Task& task, const YamlReader& reader) {
            const std::uint64_t seed = task.disturbances.seed;
            task.disturbances = disturbance_preset(reader.word(disturbance_presets()));
            task.disturbances.seed = seed;
          },
          [](const Task& /*task*/) -> std::optional<std::string> { return std::nullopt; }};
}

TaskKey seed_key() {
  return {"seed", "of everything that is drawn at random",
          [](Task& task, const YamlReader& reader) {
            task.disturbances.seed = static_cast<std::uint64_t>(reader.count(0));
          },
          [](const Task& task) -> std::optional<std::string> {
            return std::to_string(task.disturbances.seed);
          }};
}

/// One number per joint, or none.
TaskKey joints_key(const char* name, const char* meaning, Eigen::VectorXd Disturbances::*member) {
  return {name, meaning,
          [member](Task& task, const YamlReader& reader) {
            task.disturbances.*member = reader.is("none") ? Eigen::VectorXd() : reader.numbers();
          },
          [member](const Task& task) -> std::optional<std::string> {
            const Eigen::VectorXd& values = task.disturbances.*member;
            return values.size() == 0 ? "none" : yaml(values);
          }};
}

TaskKey tilt_key() {
  return {"surface_tilt_deg", "degrees about the surface's two tangents, unknown to the controller",
          [](Task& task, const YamlReader& reader) {
            task.disturbances.surface_tilt_deg = reader.numbers(2);
          },
          [](const Task& task) -> std::optional<std::string> {
            return yaml(task.disturbances.surface_tilt_deg);
          }};
}

TaskKey friction_key() {
  return {"surface_friction", "Coulomb coefficient in place of the surface's, or none",
          [](Task& task, const YamlReader& reader) {
            task.disturbances.surface_friction.reset();
            if (!reader.is("none")) task.disturbances.surface_friction = reader.not_negative();
          },
          [](const Task& task) -> std::optional<std::string> {
            const auto& friction = task.disturbances.surface_friction;
            return friction ? yaml(*friction) : "none";
          }};
}

Push read_push(const YamlReader& reader) {
  reader.allow_only({"start", "duration", "force"});
  return {reader["start"].not_negative(), reader["duration"].positive(), reader["force"].vector3()};
}

TaskKey pushes_key() {
  return {"pushes", "on the tool: [{start: s, duration: s, force: [x, y, z] in N, world}, ...]",
          [](Task& task, const YamlReader& reader) {
            task.disturbances.pushes.clear();
            for (const YamlReader& entry : reader.entries())
              task.disturbances.pushes.push_back(read_push(entry));
          },
          [](const Task& task) -> std::optional<std::string> {
            std::string text = "[";
            for (const Push& push : task.disturbances.pushes)
              text += (text.size() > 1 ? ", {start: " : "{start: ") + yaml(push.start) +
                      ", duration: " + yaml(push.duration) + ", force: " + yaml(push.force_world) +
                      "}";
            return text + "]";
          }};
}

std::vector<TaskKey> actuation_keys() {
  using D = Disturbances;
  const auto size = [](const char* name, const char* meaning, double D::*member) {
    return number_key(name, meaning, Range::NotNegative, at(&Task::disturbances, member));
  };
  const auto flag = [](const char* name, const char* meaning, bool D::*member) {
    return flag_key(name, meaning, at(&Task::disturbances, member));
  };
  return {
      size("command_delay", "s from the controller to the motors", &D::command_delay),
      size("torque_cutoff", "rad/s, first-order lag of the motors; 0: none", &D::torque_cutoff),
      size("torque_scale_range", "each joint gives 1 + r times its torque, |r| <= this",
           &D::torque_scale_range),
      joints_key("torque_scale", "factors per joint in place of drawn ones, or none",
                 &D::torque_scale),
      size("torque_bias_range", "Nm: each joint adds b, |b| <= this", &D::torque_bias_range),
      joints_key("torque_bias", "Nm per joint in place of drawn ones, or none", &D::torque_bias),
      size("torque_noise", "Nm, deviation", &D::torque_noise),
      flag("torque_limits", "joints give no more than the robot's effort limits",
           &D::torque_limits),
      flag("torque_loop", "a loop around a torque sensor takes away scale, bias and joint friction",
           &D::torque_loop),
      size("torque_sensor_noise", "Nm, deviation", &D::torque_sensor_noise),
      size("joint_coulomb", "Nm, joint friction", &D::joint_coulomb),
      size("joint_viscous", "Nms/rad, joint friction", &D::joint_viscous)};
}

std::vector<TaskKey> sensing_keys() {
  using D = Disturbances;
  const auto size = [](const char* name, const char* meaning, double D::*member) {
    return number_key(name, meaning, Range::NotNegative, at(&Task::disturbances, member));
  };
  return {
      count_key("encoder_bits", "per turn; 0: exact", 0, at(&Task::disturbances, &D::encoder_bits)),
      size("position_noise", "rad, deviation, before the encoder rounds", &D::position_noise),
      size("velocity_noise", "rad/s, deviation", &D::velocity_noise),
      flag_key("finite_difference_velocity", "velocities from measured positions",
               at(&Task::disturbances, &D::finite_difference_velocity)),
      size("velocity_cutoff", "rad/s, low-pass on those; 0: none", &D::velocity_cutoff),
      size("force_noise", "N, deviation per axis of the force sensor", &D::force_noise),
      size("force_cutoff", "rad/s, low-pass behind the noise; 0: none", &D::force_cutoff)};
}

}  // namespace

TaskSection disturbances_section() {
  using D = Disturbances;
  TaskSection section{"disturbances",
                      "What the controller does not know. Or one word: none, sensors, mismatch, "
                      "joint_friction; or\n"
                      "`preset: word` and keys that differ from it.",
                      {preset_key(), seed_key()},
                      "preset"};
  for (TaskKey& key : actuation_keys()) section.keys.push_back(std::move(key));
  for (TaskKey& key : sensing_keys()) section.keys.push_back(std::move(key));
  section.keys.push_back(number_key("mass_scale", "of all masses and inertias of the plant",
                                    Range::Positive, at(&Task::disturbances, &D::mass_scale)));
  section.keys.push_back(tilt_key());
  section.keys.push_back(number_key("surface_height", "m along the normal", Range::Any,
                                    at(&Task::disturbances, &D::surface_height)));
  section.keys.push_back(friction_key());
  section.keys.push_back(pushes_key());
  return section;
}

}  // namespace burnish::polishing
