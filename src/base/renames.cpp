#include "base/renames.hpp"

#include <algorithm>
#include <string>

namespace burnish {
namespace {

/// Renamed keys, words, keywords and attributes. docs/renames.md explains each row.
constexpr Rename names[] = {
    // controller: model error, limits of the solver, safety
    {"boost", "transient_scale"},
    {"calm", "quiescent_scale"},
    {"fading", "decay_time"},
    {"max_factors", "max_factorizations"},
    {"first_factors", "first_max_factorizations"},
    {"support_way", "support_slip"},
    {"give", "saturation_fraction"},
    {"way", "distance"},
    {"share", "friction_fraction"},
    {"least", "min_friction"},
    {"bend_change", "curvature_change"},
    {"normal_world", "normal_base"},
    {"point_world", "point_base"},
    {"tool_force_world", "wrenches"},
    {"tool_wrench", "wrenches"},
    {"support_wrenches", "wrenches"},
    {"support_sensors", "touches"},
    {"force_sensor", "touches"},
    // solver
    {"price", "l1_weight"},
    {"largest_price", "max_l1_weight"},
    {"bends", "curvature"},
    {"merit_share", "merit_fraction"},
    {"outside", "violation"},
    {"factors", "factorizations"},
    // optimal control problems
    {"square", "quadratic_weight"},
    {"square", "quadratic"},
    {"remembered_forces", "force_states"},
    {"remembered", "force_states"},
    {"step_enough", "sufficient_step"},
    // tasks
    {"lean", "force_search"},
    {"give", "force_tolerance"},
    {"share", "hold_fraction"},
    {"rubbing", "internal_forces"},
    {"least_load", "min_load"},
    {"bend", "body_distance_fraction"},
    // robots
    {"stated_joints", "file_joints"},
    // simulation
    {"tip", "touches"},
    {"surface", "touches"},
    // Python: entries of results, classes, members of enumerations
    {"outside_knot", "violation_knot"},
    {"outside_row", "violation_row"},
    {"start_outside", "start_violations"},
    {"pushing", "active_constraints"},
    {"given_way", "unsatisfiable_rows"},
    {"lean_end", "search_end"},
    {"contact_force_world", "wrenches"},
    {"scene_under_tip", "with_surface_at"},
    {"ToolTipSpec", "TouchSpec"},
    {"SupportSpec", "TouchSpec"},
    {"StatedJoint", "FileJoint"},
    {"Lean", "ForceSearch"},
    {"SQUARE", "QUADRATIC"},
    {"MOST", "FORCE_MAX"},
    {"BEAR", "STATICS"},
    {"GIVE", "TRACKING"},
};

/// Renamed columns of traces, and renamed statistics in reports of runs.
constexpr Rename columns[] = {
    {"believed_normal_x_world", "estimated_normal_x_world"},
    {"believed_normal_y_world", "estimated_normal_y_world"},
    {"believed_normal_z_world", "estimated_normal_z_world"},
    {"believed_normal_x", "estimated_normal_x"},
    {"believed_normal_y", "estimated_normal_y"},
    {"believed_normal_z", "estimated_normal_z"},
    {"believed_friction", "estimated_friction"},
    {"limits_outside", "constraint_violation"},
    {"limits_open", "constraint_residual"},
    {"limits_pushing", "active_constraints"},
    {"limits_infeasible", "constraints_infeasible"},
    {"limits_p99", "violation_p99"},
    {"least_load", "min_load"},
    {"believed_place", "position_estimate_rmse"},
    {"believed_turn", "orientation_estimate_rmse"},
    {"lean_force", "search_force"},
    {"lean", "com_displacement"},
};

std::vector<Rename> all_renames() {
  std::vector<Rename> all(std::begin(names), std::end(names));
  all.insert(all.end(), std::begin(columns), std::end(columns));
  return all;
}

}  // namespace

std::span<const Rename> renames() {
  static const std::vector<Rename> all = all_renames();
  return all;
}

std::string_view replacement(std::string_view old_name, const std::vector<std::string>& known) {
  for (const Rename& rename : renames())
    if (rename.old_name == old_name &&
        std::find(known.begin(), known.end(), rename.new_name) != known.end())
      return rename.new_name;
  return {};
}

std::string_view current_column(std::string_view name) {
  for (const Rename& rename : columns)
    if (rename.old_name == name) return rename.new_name;
  return name;
}

std::string_view current_phase(std::string_view name) {
  return name == "lean" ? "force_search" : name;
}

}  // namespace burnish
