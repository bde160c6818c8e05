#include "press_hold/descriptions.hpp"

#include "pressing/task_form.hpp"

namespace burnish::press_hold {

const files::DescribedFile& file_of(const Task* /*of*/) {
  static const files::DescribedFile all = [] {
    files::DescribedFile form(
        description_of(static_cast<const Task*>(nullptr)),
        "Press at a point and hold the force while the rest of the arm moves aside: `burnish "
        "run`.\nSI units, angles in rad. A key that is left out has its default.",
        "press_hold");
    pressing::read_presets<Task>(form, "surface.friction");
    const std::string fixed = "the robot's base is fixed";
    form.without("disturbances", pressing::disturbances_of_standing(), fixed)
        .without("limits", {"base_lost", "support_slip"}, fixed)
        .without("constraints", {"joint_torque_rate"},
                 "plans of this task do not model the lag of torques");
    form.first("limits", {"force", "slip"});
    return form;
  }();
  return all;
}

}  // namespace burnish::press_hold
