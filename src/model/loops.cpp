#include "model/loops.hpp"

#include <cmath>
#include <set>

#include "base/degrees.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "model/tree_sentence.hpp"

namespace burnish {
namespace {

std::string label_of(const LoopSpec& loop) {
  return (loop.line > 0 ? "line " + std::to_string(loop.line) + ": " : "") + "loop " +
         in_quotes(loop.name);
}

void check_placement(const LoopSpec& loop, const Eigen::Isometry3d& placement, const char* which,
                     Findings& findings) {
  const Eigen::Matrix3d R = placement.linear();
  if (placement.matrix().allFinite() && (R * R.transpose()).isIdentity(1e-6) &&
      R.determinant() > 0.0)
    return;
  findings.problem(
      label_of(loop) + ": the placement of its " + which +
      " frame is not a rigid transformation; wanted a finite position and a rotation matrix");
}

/// Returns an unnamed frame at `placement` in a link.
Frame frame_of(const Model& model, const std::string& link, const Eigen::Isometry3d& placement) {
  if (link == "world" && !model.has_frame(link)) return {"", FrameKind::User, -1, placement};
  const Frame& parent = model.frames[to_size(model.frame_index(link))];
  return {"", FrameKind::User, parent.body, parent.placement * placement};
}

}  // namespace

void check_loops(const TreeSpec& tree, Findings& findings) {
  std::set<std::string> links, names;
  for (const LinkSpec& link : tree.links) links.insert(link.name);
  for (const LoopSpec& loop : tree.loops) {
    if (loop.name.empty()) {
      findings.problem("a loop has no name; wanted a name for every loop");
      continue;
    }
    if (!names.insert(loop.name).second)
      findings.problem(label_of(loop) + " is defined twice; wanted unique names of loops");
    for (const std::string* link : {&loop.first_link, &loop.second_link}) {
      if (*link == "world" || links.contains(*link)) continue;
      const std::vector<std::string> existing(links.begin(), links.end());
      findings.problem(label_of(loop) + ": link " + in_quotes(*link) + " does not exist" +
                       (findings.are_few() ? did_you_mean(*link, existing) : ""));
    }
    if (loop.first_link == loop.second_link)
      findings.problem(label_of(loop) + " connects link " + in_quotes(loop.first_link) +
                       " to itself; wanted two links");
    if (loop.directions.bits == 0 || loop.directions.bits > Directions::all().bits)
      findings.problem(label_of(loop) +
                       " holds no direction; wanted at least one of x,y,z,rx,ry,rz");
    check_placement(loop, loop.first, "first", findings);
    check_placement(loop, loop.second, "second", findings);
  }
}

void add_loops(const TreeSpec& tree, Model& model) {
  for (const LoopSpec& spec : tree.loops) {
    Frame first = frame_of(model, spec.first_link, spec.first);
    Frame second = frame_of(model, spec.second_link, spec.second);
    if (first.body == second.body) {
      const LoopDistance miss =
          loop_distance(spec.directions, first.placement.inverse() * second.placement);
      if (miss.closes()) continue;
      refuse(tree, label_of(spec) + ": links " + in_quotes(spec.first_link) + " and " +
                       in_quotes(spec.second_link) +
                       " are one body, because all joints between them are locked, but the loop "
                       "is open by " +
                       miss.text() +
                       "; wanted a posture that closes the loop, or one of these joints free");
    }
    first.name = spec.name + "/first";
    second.name = spec.name + "/second";
    for (const Frame* frame : {&first, &second})
      if (model.has_frame(frame->name))
        refuse(tree, label_of(spec) + ": its frame " + in_quotes(frame->name) +
                         " has the name of another frame; wanted unique names");
    model.loops.push_back({spec.name, first.name, second.name, spec.directions});
    model.frames.push_back(std::move(first));
    model.frames.push_back(std::move(second));
  }
}

LoopDistance loop_distance(const Directions& directions, const Eigen::Isometry3d& second_in_first) {
  const Eigen::AngleAxisd turned(Eigen::Matrix3d(second_in_first.linear()));
  const Eigen::Vector3d rotation = turned.angle() * turned.axis();
  LoopDistance miss;
  for (int d = 0; d < 3; ++d) {
    if (directions.has(d))
      miss.translation = std::hypot(miss.translation, second_in_first.translation()[d]);
    if (directions.has(3 + d)) miss.rotation = std::hypot(miss.rotation, rotation[d]);
  }
  return miss;
}

std::string LoopDistance::text() const {
  const std::string length = number(1e3 * translation) + " mm";
  constexpr double negligible = 1e-6;  // messages omit smaller errors; chosen by hand [rad, m]
  if (rotation < negligible) return length;
  const std::string angle = number(degrees_per_radian * rotation) + " degrees";
  return translation < negligible ? angle : length + " and " + angle;
}

}  // namespace burnish
