#include "stand/descriptions.hpp"

#include "pressing/task_form.hpp"

namespace burnish::stand {

const files::DescribedFile& file_of(const Task* /*of*/) {
  static const files::DescribedFile all = [] {
    files::DescribedFile form(
        description_of(static_cast<const Task*>(nullptr)),
        "Stand on feet, sway with the trunk and come back to rest: `burnish run`.\nSI units, "
        "angles in rad. A key that is left out has its default.",
        "stand");
    pressing::read_presets<Task>(form);
    const std::string nothing = "the task has no surface to press on";
    form.without("disturbances",
                 {"surface_tilt_deg", "surface_height", "surface_curvature", "surface_shape",
                  "surface_motion", "surface_friction"},
                 nothing)
        .without("model_error", {"sliding_bandwidth", "force_gain"}, nothing)
        .without("constraints", {"force_band"}, nothing)
        .without("constraints", {"joint_torque_rate"},
                 "plans of this task do not model the lag of torques");
    return form;
  }();
  return all;
}

}  // namespace burnish::stand
