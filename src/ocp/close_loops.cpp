// Adds the contacts of kinematic loops to all stages of a problem, and finds the driven joints.
#include <algorithm>

#include "base/to_size.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/ocp/problem_spec.hpp"

namespace burnish {

ProblemSpec with_loops(ProblemSpec spec) {
  if (spec.model.loops.empty()) return spec;
  double step = 0.0;
  for (const Stage& stage : spec.stages)
    if (!stage.impact && stage.step > step) step = stage.step;
  const LoopGains gains = step > 0.0 ? LoopGains::for_step(step) : LoopGains();
  spec.contacts = with_loops(spec.model, std::move(spec.contacts), gains);
  for (const ContactSpec& contact : spec.contacts) {
    if (!is_loop(spec.model, contact)) continue;
    for (Stage& stage : spec.stages)
      if (std::find(stage.contacts.begin(), stage.contacts.end(), contact.name) ==
          stage.contacts.end())
        stage.contacts.push_back(contact.name);
  }
  return spec;
}

std::vector<const Joint*> driven_joints(const Model& model, const ActuationSpec& actuation) {
  std::vector<const Joint*> result;
  for (const std::string& name : actuation.joints)
    result.push_back(&model.joints[to_size(model.joint_index(name))]);
  if (!actuation.joints.empty()) return result;
  for (const Joint& joint : model.joints) {
    if (joint.kind == JointKind::FreeFlyer || joint.follows) continue;
    // In a robot with loops, a joint with an effort limit of zero has no motor. In other robots, a
    // limit of zero often means that the description states no limit.
    const auto effort = model.effort_limit.segment(joint.v_index, joint.nv);
    if (!model.loops.empty() && effort.isZero(0.0)) continue;
    result.push_back(&joint);
  }
  return result;
}

}  // namespace burnish
