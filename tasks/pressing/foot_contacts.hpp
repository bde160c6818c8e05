// Contacts of the feet of a standing robot, without redundant directions.
#pragma once

#include <string>
#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::pressing {

/// Returns one contact per foot, named as the frame of the foot. Soles hold six directions, point
/// feet three. Some legs have few joints, for example no ankle roll, and cannot move a foot in some
/// directions while the other feet stand. A direction is left out if it depends on preceding
/// directions at the configuration `q` (nq). Throws Error if `q` is not a configuration.
std::vector<ContactSpec> foot_contacts(const Model& model, const Standing& standing,
                                       const Eigen::VectorXd& q);

/// Returns the list of directions that `feet` leave out, such as "turning about x of 'r_sole'";
/// empty if there are none.
std::string directions_left_out(const Standing& standing, const std::vector<ContactSpec>& feet);

}  // namespace burnish::pressing
