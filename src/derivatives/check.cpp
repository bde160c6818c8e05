#include "burnish/derivatives/check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/sentence.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/model/state.hpp"
#include "derivatives/check_run.hpp"

namespace burnish {

std::string default_tool(const Model& model) {
  if (model.has_frame("tool") && model.frames[model.frame_index("tool")].body >= 0) return "tool";
  std::vector<char> has_child(model.joints.size(), 0);
  for (const Joint& joint : model.joints)
    if (joint.parent >= 0) has_child[joint.parent] = 1;
  const auto closes = [&](const std::string& frame) {
    return std::any_of(model.loops.begin(), model.loops.end(), [&](const Loop& loop) {
      return loop.first == frame || loop.second == frame;
    });
  };
  std::string last;
  for (const Frame& frame : model.frames)
    if (frame.body >= 0 && !has_child[frame.body] && !closes(frame.name)) last = frame.name;
  if (last.empty())
    throw Error("the robot has no moving frame that could be the tool; wanted at least one joint");
  return last;
}

namespace {

/// Contacts that one row of the report checks.
struct CheckSubject {
  std::vector<ContactSpec> contacts;
  std::optional<SurfaceShape> surface = {};  ///< Surface that the only contact follows
};

/// Normal of the report's tilted reference, and of each curved surface at the tool's position in
/// the neutral posture.
const Eigen::Vector3d tilted_normal(-0.4, 0.3, 0.8);

/// Returns the contacts of each row of the report.
std::vector<CheckSubject> sweep(const Model& model, const CheckOptions& options) {
  if (!options.contacts.empty()) return {{options.contacts}};
  ContactSpec spec;
  spec.tool = options.tool.empty() ? default_tool(model) : options.tool;
  spec.base = options.base.empty() ? "world" : options.base;
  const auto at = [&](const std::string& frame) {
    return frame_placement(model, model.q_neutral, frame);
  };
  spec.target = at(spec.base).inverse() * at(spec.tool);
  std::vector<CheckSubject> rows;
  const auto add = [&](const Reference& reference, const std::optional<SurfaceShape>& surface) {
    spec.reference = reference;
    for (const Directions& directions : options.directions)
      for (const Acceleration acceleration : options.accelerations)
        for (const CheckGains& gains : options.gains) {
          spec.directions = directions;
          spec.acceleration = acceleration;
          spec.kp = gains.kp;
          spec.kd = gains.kd;
          spec.error = gains.error;
          rows.push_back({{spec}, surface});
        }
  };
  for (const Reference& reference : options.references) add(reference, {});
  const Eigen::Vector3d tool = spec.target.translation();
  for (const SurfaceShape& shape : options.surfaces) {
    const Surface there(shape, tool, tilted_normal);  // throws Error for an invalid shape
    add(Reference::on(there.at(tool).quadric(tool, 0.0), tool), shape);
  }
  if (rows.empty())
    throw Error(
        "check: one of these lists is empty: references and surfaces, directions, accelerations, "
        "gains; wanted at least one entry in each list");
  return rows;
}

/// Returns "kp 10", or "kp 7..12" if the gains of the constrained directions differ.
std::string gain_text(const char* name, const ContactSpec& spec, const Vector6& gains) {
  double lowest = std::numeric_limits<double>::infinity(), highest = 0.0;
  for (int d = 0; d < 6; ++d) {
    if (!spec.directions.has(d)) continue;
    lowest = std::min(lowest, gains[d]);
    highest = std::max(highest, gains[d]);
  }
  if (highest == 0.0) return "";
  return std::string(name) + " " + (lowest == highest ? "" : number(lowest) + "..") +
         number(highest);
}

std::string gains_text(const ContactSpec& spec) {
  const std::string kp = gain_text("kp", spec, spec.kp), kd = gain_text("kd", spec, spec.kd);
  if (kp.empty() && kd.empty()) return "none";
  return kp + (kp.empty() || kd.empty() ? "" : ", ") + kd;
}

/// Joins the texts word(contact) of all contacts with " + ". Returns one text if all are equal.
std::string joined(const std::vector<ContactSpec>& contacts,
                   const std::function<std::string(const ContactSpec&)>& word) {
  const std::string first = word(contacts.front());
  std::string text = first;
  bool same = true;
  for (std::size_t i = 1; i < contacts.size(); ++i) {
    const std::string next = word(contacts[i]);
    same = same && next == first;
    text += " + " + next;
  }
  return same ? first : text;
}

CheckRow describe_row(const CheckSubject& checked) {
  const std::vector<ContactSpec>& contacts = checked.contacts;
  CheckRow row;
  row.reference = joined(contacts, [](const auto& spec) {
    return (spec.reference.quadric ? "curved " : "") + spec.reference.name();
  });
  if (checked.surface) row.reference = checked.surface->text();
  row.directions = joined(contacts, [](const auto& spec) { return spec.directions.text(); });
  row.bodies = joined(contacts, [](const auto& spec) { return spec.tool + " on " + spec.base; });
  row.acceleration = joined(contacts, [](const auto& spec) { return name_of(spec.acceleration); });
  row.error = joined(contacts, [](const auto& spec) -> std::string {
    return gain_text("kp", spec, spec.kp).empty() ? "-" : name_of(spec.error);
  });
  row.gains = joined(contacts, gains_text);
  return row;
}

/// Returns a sentence with the names of the joints that make the mass matrix singular, or an empty
/// text if the matrix is regular.
std::string singular_mass(const Model& model, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const Eigen::VectorXd q = random_configuration(model, generator);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
  ContactDynamics dynamics(model);
  if (dynamics.forward(q, rest, rest) != Status::SingularMass) return "";
  return dynamics.explanation();
}

CheckRow check_row(const Model& model, const CheckOptions& options, const CheckSubject& checked,
                   bool forward, const TamperWithBlocks& tamper) {
  // The contacts include the loops of the robot. Random postures do not close the loops, so the
  // gains of the loops must be small.
  const std::vector<ContactSpec> contacts = with_loops(model, checked.contacts, {100.0, 20.0});
  CheckRow row = describe_row(checked);
  ContactDynamics dynamics(model, contacts);
  CheckStates source(model, options.seed, checked.surface);
  std::optional<std::vector<CheckState>> states = source.draw(dynamics, options.states, forward);
  if (!states && forward) {
    row.mu = source.compliance(dynamics);
    states = source.draw(dynamics, options.states, false);
    dynamics = ContactDynamics(model, contacts, {.mu = row.mu});
  }
  if (!states) {
    throw Error("check: contact '" + contacts.front().tool +
                "': too few random postures turn the tool by less than pi - 0.1 rad from the "
                "target and the surface's normal at the tool by less than 154 degrees from the "
                "normal at the start; wanted another target or surface");
  }
  CheckValues values(model, dynamics.contacts(), {.mu = row.mu});
  row.states = options.states;
  for (int i = 0; i < options.states; ++i) {
    std::vector<DerivativeBlock> blocks = derivative_blocks(model, dynamics, values, (*states)[i]);
    if (tamper) tamper(blocks);
    for (const DerivativeBlock& block : blocks) {
      const BlockMismatch mismatch = compare(block);
      if (!row.worst.block.empty() && !(mismatch.error > row.worst_error)) continue;
      row.worst_error = mismatch.error;
      row.worst = mismatch.entry;
      row.worst.state = i;
    }
  }
  row.pass = row.worst_error <= options.tolerance;
  return row;
}

void check_options(const Model& model, const CheckOptions& options) {
  if (model.nv == 0)
    throw Error("check: the robot has no moving joint; wanted at least one degree of freedom");
  if (options.states < 1) {
    throw Error("check: states is " + std::to_string(options.states) + "; wanted at least 1");
  }
  if (!(options.tolerance > 0.0) || !std::isfinite(options.tolerance)) {
    throw Error("check: tolerance is " + number(options.tolerance) + "; wanted a positive number");
  }
}

}  // namespace

std::vector<Reference> default_check_references() {
  return {Reference::local(), Reference::centered(), Reference::surface_with_normal(tilted_normal),
          Reference::world()};
}

std::vector<SurfaceShape> default_check_surfaces() {
  return {{.kind = SurfaceShape::Kind::Saddle, .curvature = {2.0, -3.0}}};
}

std::vector<Directions> default_check_directions() {
  return {Directions::x(),
          Directions::y(),
          Directions::z(),
          Directions::x() | Directions::y(),
          Directions::linear(),
          Directions::pad_z(),
          Directions::parse("x,y,z,rx,ry"),
          Directions::all()};
}

std::vector<CheckGains> default_check_gains() {
  // Unequal gains reveal a gain that is applied to the wrong direction.
  CheckGains split;
  split.kp << 9.0, 11.0, 8.0, 12.0, 10.0, 7.0;
  split.kd << 3.0, 5.0, 4.0, 6.0, 2.0, 7.0;
  CheckGains log6 = split;
  log6.error = PoseError::Log6;
  return {CheckGains(), split, log6};
}

CheckReport run_check(const Model& model, const CheckOptions& options,
                      const TamperWithBlocks& tamper) {
  check_options(model, options);
  const std::vector<CheckSubject> rows = sweep(model, options);
  CheckReport report;
  report.robot = model.name;
  report.tolerance = options.tolerance;
  report.singular_mass = singular_mass(model, options.seed);
  report.pass = report.singular_mass.empty();
  for (const CheckSubject& checked : rows) {
    report.rows.push_back(check_row(model, options, checked, report.singular_mass.empty(), tamper));
    report.pass = report.pass && report.rows.back().pass;
    if (options.progress) {
      options.progress(static_cast<int>(report.rows.size()), static_cast<int>(rows.size()));
    }
  }
  return report;
}

CheckReport check_derivatives(const Model& model, const CheckOptions& options) {
  return run_check(model, options);
}

}  // namespace burnish
