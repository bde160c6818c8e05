#include "push_wall/descriptions.hpp"

#include "pressing/task_form.hpp"

namespace burnish::push_wall {

const files::DescribedFile& file_of(const Task* /*of*/) {
  static const files::DescribedFile all = [] {
    files::DescribedFile form(
        description_of(static_cast<const Task*>(nullptr)),
        "Push with both hands against a wall, and search for the largest force: `burnish run`.\nSI "
        "units, angles in rad. A key that is left out has its default.",
        "push_wall");
    pressing::read_presets<Task>(form, "wall.friction");
    form.without("disturbances", {"surface_curvature", "surface_shape", "surface_motion"},
                 "the wall is plane and fixed")
        .without("model_error", {"sliding_bandwidth"}, "the forces of the hands are measured")
        .without("constraints", {"joint_torque_rate"},
                 "plans of this task do not model the lag of torques");
    return form;
  }();
  return all;
}

}  // namespace burnish::push_wall
