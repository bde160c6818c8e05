// What feet hold of a robot, by the directions that do not follow from others.
#pragma once

#include <string>
#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::pressing {

/// One contact per foot, called as its frame: soles hold everything, balls their place. Directions
/// that follow from those of other feet at q (nq) are left out, the last ones first: legs with too
/// few joints, such as those without a roll of the ankle, cannot move one foot along them while the
/// other stands. Throws Error for a q that is no state.
std::vector<ContactSpec> foot_contacts(const Model& model, const Standing& standing,
                                       const Eigen::VectorXd& q);

/// The directions that those contacts leave out, by foot: "rx of r_sole"; none: an empty text.
std::string directions_left_out(const Standing& standing, const std::vector<ContactSpec>& feet);

}  // namespace burnish::pressing
