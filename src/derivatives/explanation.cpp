#include "derivatives/explanation.hpp"

#include <algorithm>

#include "base/sentence.hpp"

namespace burnish {
std::string explain(Status status, const std::vector<std::string>& joints,
                    const std::vector<std::string>& rows, const std::vector<std::string>& jammed) {
  if (status == Status::SingularMass && !joints.empty()) {
    std::vector<std::string> once = joints;
    once.erase(std::unique(once.begin(), once.end()), once.end());
    const bool one = once.size() == 1;
    return listed("joint", once) + (one ? " moves" : " move") + " no mass of " +
           (one ? "its" : "their") +
           " own at this posture, so that the mass matrix is not positive definite: give the " +
           (one ? "link a mass or the joint" : "links a mass or the joints") +
           " an armature, or lock " + (one ? "it" : "them");
  }
  if (status == Status::SingularContacts && !rows.empty()) {
    const std::string them = rows.size() == 1 ? "it" : "them";
    return listed("contact row", rows) + (rows.size() == 1 ? " is" : " are") +
           " redundant or cannot be held: at this posture no " + "joint moves along " + them +
           ", or the rows before hold " + them +
           " already; call diagnose() for which, or set mu > 0";
  }
  if (status == Status::SingularContacts && !jammed.empty())
    return listed("the tool of contact", jammed) + (jammed.size() == 1 ? " jams" : " jam") +
           ": pressing harder, sliding as it does, friction would press it harder than its inertia "
           "holds against; only less friction or another posture lets it slide";
  return std::string(describe(status));
}

}  // namespace burnish
