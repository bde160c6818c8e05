// Recording of a run's rows in MCAP format.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "burnish/dynamics/placement.hpp"
#include "record/mcap.hpp"
#include "record/mcap_schemas.hpp"
#include "record/page_json.hpp"

namespace burnish {
namespace {

constexpr double transform_period = 0.01;  // Time between two messages of /tf, chosen by hand [s]

/// Links of a robot, grouped by body. The first link of a body is its main link and represents the
/// body.
class LinkTree {
 public:
  explicit LinkTree(const Model& model) : model_(model), main_(model.joints.size(), -1) {
    for (std::size_t i = 0; i < model.frames.size(); ++i) {
      const Frame& frame = model.frames[i];
      if (frame.kind != FrameKind::Link || frame.body < 0) continue;
      int& main = main_[to_size(frame.body)];
      if (main < 0) main = static_cast<int>(i);
    }
  }
  const std::vector<int>& main() const { return main_; }
  /// Returns the name of a body's main link; "world" for body -1.
  std::string name(int body) const {
    return body < 0 || at(body) < 0 ? "world" : model_.frames[index(body)].name;
  }
  /// Returns the placement of a body in its main link.
  Eigen::Isometry3d body_in_link(int body) const {
    if (body < 0 || at(body) < 0) return Eigen::Isometry3d::Identity();
    return model_.frames[index(body)].placement.inverse();
  }

 private:
  int at(int body) const { return main_[to_size(body)]; }
  std::size_t index(int body) const { return to_size(at(body)); }
  const Model& model_;
  std::vector<int> main_;
};

Json moment_json(std::uint64_t time) {
  constexpr std::uint64_t second = 1'000'000'000;
  return {{"sec", time / second}, {"nsec", time % second}};
}
/// Returns an object with one number per letter of `letters`.
Json named_json(const char* letters, const double* values) {
  Json json;
  for (; *letters != '\0'; ++letters) json[std::string(1, *letters)] = *values++;
  return json;
}
/// Adds the position of a placement as entry `where`, and its rotation as entry `how`.
void add_placement(Json& json, const char* where, const char* how,
                   const Eigen::Isometry3d& placement) {
  const Eigen::Vector3d p = placement.translation();
  const Eigen::Quaterniond rotation = Eigen::Quaterniond(placement.linear()).normalized();
  json[where] = named_json("xyz", p.data());
  json[how] = named_json("xyzw", rotation.coeffs().data());
}
Json pose_of(const Eigen::Isometry3d& placement) {
  Json json;
  add_placement(json, "position", "orientation", placement);
  return json;
}
Json transform_json(std::uint64_t time, const std::string& parent, const std::string& child,
                    const Eigen::Isometry3d& placement) {
  Json json{
      {"timestamp", moment_json(time)}, {"parent_frame_id", parent}, {"child_frame_id", child}};
  add_placement(json, "translation", "rotation", placement);
  return json;
}

/// Kind and size of a shape in foxglove.SceneEntity. Recordings do not contain meshes.
struct Solid {
  const char* kind;  ///< Field of foxglove.SceneEntity; null: shape not supported
  Eigen::Vector3d size;
};
Solid solid_of(const Shape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return {"cubes", box->size};
  if (const auto* sphere = std::get_if<SphereShape>(&shape))
    return {"spheres", Eigen::Vector3d::Constant(2.0 * sphere->radius)};
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) {
    const double width = 2.0 * cylinder->radius;
    return {"cylinders", {width, width, cylinder->length}};
  }
  return {nullptr, Eigen::Vector3d::Zero()};
}

Json entity_json(std::uint64_t time, const std::string& frame, const std::string& id,
                 const Solid& solid, const Eigen::Isometry3d& placement,
                 const Eigen::Vector4d& rgba) {
  Json shape{{"pose", pose_of(placement)},
             {"size", named_json("xyz", solid.size.data())},
             {"color", named_json("rgba", rgba.data())}};
  if (std::string_view(solid.kind) == "cylinders") {
    shape["bottom_scale"] = 1.0;
    shape["top_scale"] = 1.0;
  }
  return {{"timestamp", moment_json(time)},
          {"frame_id", frame},
          {"id", id},
          {"frame_locked", true},
          {solid.kind, Json::array({std::move(shape)})}};
}

/// Writer of a run's messages.
class Recorder {
 public:
  Recorder(const RunPage& run, const std::filesystem::path& file)
      : run_(run),
        model_(run.robot.model),
        has_tool_(!run.tool_frame.empty()),
        links_(model_),
        out_(file, "burnish " + run.version) {
    joints_ = channel("/joint_states", "burnish.JointStates", mcap::joint_states());
    if (has_tool_) add_tool();
    const std::uint16_t tf = out_.add_schema("foxglove.FrameTransforms", mcap::frame_transforms());
    transforms_ = out_.add_channel(tf, "/tf");
    fixed_ = out_.add_channel(tf, "/tf_static");
    scene_ = channel("/scene", "foxglove.SceneUpdate", mcap::scene_update());
    if (run.solver)
      solver_ =
          channel("/solver", "burnish.Solver", mcap::numbers({"solve_ms", "iterations", "missed"}));
    if (run.plans) costs_ = channel("/costs", "burnish.Costs", mcap::numbers(run.plans->terms));
    for (int k = 0; k < model_.nq; ++k) q_.push_back(column("q_" + model_.q_name(k)));
    for (int k = 0; k < model_.nv; ++k) {
      v_.push_back(column("v_" + model_.v_name(k)));
      tau_.push_back(column("tau_" + model_.v_name(k)));
    }
  }

  void record() {
    if (run_.time.size() == 0) return out_.finish();
    write_fixed(moment(run_.time[0]));
    write_scene(moment(run_.time[0]));
    double next_transform = run_.time[0];
    for (Eigen::Index row = 0; row < run_.time.size(); ++row) {
      const std::uint64_t time = moment(run_.time[row]);
      write_until(run_.time[row]);
      write_joints(row, time);
      if (has_tool_) write_table(forces_, row, time);
      if (has_tool_) write_table(task_, row, time);
      write_placements(row, time, run_.time[row] >= next_transform);
      if (run_.time[row] >= next_transform) next_transform = run_.time[row] + transform_period;
    }
    write_metadata();
    out_.finish();
  }

 private:
  struct Table {
    std::uint16_t channel = 0;
    std::vector<std::string> names;
    std::vector<const Eigen::VectorXd*> columns;
  };

  /// Adds the channels of a tool, its forces and its path.
  void add_tool() {
    forces_ = table("/force", "burnish.Force",
                    {"force_normal", "force_normal_mean", "force_estimated", "force_measured",
                     "force_target", "force_t1", "force_t2", "in_contact"});
    task_ =
        table("/task", "burnish.Task",
              {"phase", "path_u", "path_w", "target_u", "target_w", "path_error", "tool_turned"});
    const std::uint16_t pose = out_.add_schema("foxglove.PoseInFrame", mcap::pose_in_frame());
    tool_ = out_.add_channel(pose, "/tool_pose");
    target_ = out_.add_channel(pose, "/target_pose");
  }
  std::uint64_t moment(double seconds) const {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(0, run_.created)) * 1'000'000'000 +
           static_cast<std::uint64_t>(std::llround(1e9 * std::max(0.0, seconds)));
  }
  std::uint16_t channel(const char* topic, const char* name, const std::string& schema) {
    return out_.add_channel(out_.add_schema(name, schema), topic);
  }
  const Eigen::VectorXd* column(const std::string& name) const {
    for (const PageColumn& column : run_.columns)
      if (column.name == name) return &column.values;
    throw Error("the run has no column '" + name + "', which the recording needs");
  }
  Table table(const char* topic, const char* name, std::vector<std::string> names) {
    Table result{channel(topic, name, mcap::numbers(names)), std::move(names), {}};
    for (const std::string& each : result.names) result.columns.push_back(column(each));
    return result;
  }

  void write(std::uint16_t channel, std::uint64_t time, const Json& message) {
    out_.write(channel, time, compact_text(message));
  }
  void write_table(const Table& table, Eigen::Index row, std::uint64_t time) {
    Json message{{"timestamp", moment_json(time)}};
    for (std::size_t i = 0; i < table.names.size(); ++i)
      message[table.names[i]] = (*table.columns[i])[row];
    write(table.channel, time, message);
  }
  void write_joints(Eigen::Index row, std::uint64_t time) {
    Json names = Json::array(), position = names, velocity = names, effort = names;
    const auto at = [row](const auto& columns, int index) {
      return (*columns[to_size(index)])[row];
    };
    // A follower moves with its leader; the motor of the leader drives it, so its effort is 0.
    for (const Joint& joint : model_.joints) {
      const Following following = joint.follows.value_or(Following());
      names.push_back(joint.name);
      position.push_back(following.multiplier * at(q_, joint.q_index) + following.offset);
      velocity.push_back(following.multiplier * at(v_, joint.v_index));
      effort.push_back(joint.follows ? 0.0 : at(tau_, joint.v_index));
    }
    write(joints_, time,
          {{"timestamp", moment_json(time)},
           {"name", std::move(names)},
           {"position", std::move(position)},
           {"velocity", std::move(velocity)},
           {"effort", std::move(effort)}});
  }
  void write_pose(std::uint16_t channel, std::uint64_t time, const Eigen::Isometry3d& placement) {
    write(channel, time,
          {{"timestamp", moment_json(time)}, {"frame_id", "world"}, {"pose", pose_of(placement)}});
  }
  /// Writes the poses of tool and target, and the transforms of the main links.
  void write_placements(Eigen::Index row, std::uint64_t time, bool with_links) {
    if (!with_links) return;
    Eigen::VectorXd q(model_.nq);
    for (int k = 0; k < model_.nq; ++k) q[k] = (*q_[to_size(k)])[row];
    const std::vector<Eigen::Isometry3d> frames = frame_placements(model_, q);
    if (has_tool_) {
      write_pose(tool_, time, frames[to_size(model_.frame_index(run_.tool_frame))]);
      write_pose(target_, time,
                 moved(frames) * target_at({(*task_.columns[3])[row], (*task_.columns[4])[row]}));
    }
    Json transforms = Json::array();
    for (const int main : links_.main())
      if (main >= 0)
        transforms.push_back(transform_json(time, "world", model_.frames[to_size(main)].name,
                                            frames[to_size(main)]));
    write(transforms_, time, {{"transforms", std::move(transforms)}});
  }
  /// Returns the target pose of the tip's centre for a point of the path, with the surface at its
  /// initial placement.
  Eigen::Isometry3d target_at(const Eigen::Vector2d& place) const {
    Eigen::Isometry3d target = Eigen::Isometry3d::Identity();
    target.linear() = run_.surface.axes;
    target.translation() = run_.path_origin_world + run_.surface.axes.leftCols<2>() * place;
    if (const auto& surface = run_.surface.nominal) {
      const Eigen::Vector3d n = run_.surface.axes.col(2);
      const Eigen::Vector3d on = surface->along_normal(target.translation() - run_.tip_radius * n);
      target.translation() = on + run_.tip_radius * surface->at(on).normal;
    }
    return target;
  }
  /// Returns the motion of a surface that the robot carries, since the start of the run.
  Eigen::Isometry3d moved(const std::vector<Eigen::Isometry3d>& frames) const {
    if (run_.surface.frame.empty()) return Eigen::Isometry3d::Identity();
    const auto carrier = to_size(model_.frame_index(run_.surface.frame));
    return frames[carrier] * frame_placements(model_, run_.robot.q)[carrier].inverse();
  }
  /// Writes the links that are fixed relative to the main link of their body or to the world.
  void write_fixed(std::uint64_t time) {
    Json transforms = Json::array();
    for (const Frame& frame : model_.frames) {
      const std::string parent = links_.name(frame.body);
      if (frame.kind == FrameKind::Joint || frame.name == parent) continue;
      transforms.push_back(transform_json(time, parent, frame.name,
                                          links_.body_in_link(frame.body) * frame.placement));
    }
    write(fixed_, time, {{"transforms", std::move(transforms)}});
  }
  void write_scene(std::uint64_t time) {
    Json entities = Json::array();
    int count = 0;
    for (const Visual& visual : model_.visuals) {
      const Solid solid = solid_of(visual.shape);
      const std::string id = visual.link + " " + std::to_string(count++);
      if (solid.kind == nullptr) continue;
      entities.push_back(entity_json(time, links_.name(visual.body), id, solid,
                                     links_.body_in_link(visual.body) * visual.placement,
                                     visual.rgba));
    }
    constexpr double side = 0.6, thickness = 0.005;  // Size of the surface in the drawing [m]
    Eigen::Isometry3d plate = Eigen::Isometry3d::Identity();
    plate.linear() = run_.surface.true_axes;
    const Eigen::Vector3d n = run_.surface.true_axes.col(2);
    plate.translation() =
        run_.path_origin_world -
        n * (n.dot(run_.path_origin_world - run_.surface.true_point) + 0.5 * thickness);
    entities.push_back(entity_json(time, "world", "surface", {"cubes", {side, side, thickness}},
                                   plate, {0.6, 0.7, 0.8, 0.5}));
    write(scene_, time, {{"deletions", Json::array()}, {"entities", std::move(entities)}});
  }
  /// Writes the plans up to a time, so that the messages are in the order of their times.
  void write_until(double now) {
    while (run_.solver && next_solve_ < run_.solver->time.size() &&
           run_.solver->time[next_solve_] <= now) {
      const PageSolver& solver = *run_.solver;
      const std::uint64_t time = moment(solver.time[next_solve_]);
      write(solver_, time,
            {{"timestamp", moment_json(time)},
             {"solve_ms", solver.solve_ms[next_solve_]},
             {"iterations", solver.iterations[next_solve_]},
             {"missed", solver.missed[next_solve_]}});
      ++next_solve_;
    }
    while (run_.plans && next_plan_ < run_.plans->time.size() &&
           run_.plans->time[next_plan_] <= now) {
      const PlanRecord& plans = *run_.plans;
      const std::uint64_t time = moment(plans.time[next_plan_]);
      Json message{{"timestamp", moment_json(time)}};
      for (std::size_t i = 0; i < plans.terms.size(); ++i)
        message[plans.terms[i]] = plans.costs[i][next_plan_];
      write(costs_, time, message);
      ++next_plan_;
    }
  }
  void write_metadata() {
    std::map<std::string, std::string> facts(run_.facts.begin(), run_.facts.end()), metrics;
    facts["name"] = run_.name;
    facts["outcome"] = run_.outcome;
    facts["command"] = run_.command;
    out_.add_metadata("run", facts);
    for (const PageMetric& metric : run_.metrics) {
      const std::string number = metric.value ? fmt::format("{}", *metric.value) : "null";
      metrics[metric.name] = number + (metric.unit == "1" ? "" : " " + metric.unit);
    }
    out_.add_metadata("metrics", metrics);
  }

  const RunPage& run_;
  const Model& model_;
  bool has_tool_;
  LinkTree links_;
  McapWriter out_;
  std::uint16_t joints_ = 0, tool_ = 0, target_ = 0, transforms_ = 0, fixed_ = 0, scene_ = 0,
                solver_ = 0, costs_ = 0;
  Table forces_, task_;
  std::vector<const Eigen::VectorXd*> q_, v_, tau_;
  Eigen::Index next_solve_ = 0;
  std::size_t next_plan_ = 0;
};

}  // namespace

void write_run_mcap(const RunPage& run, const std::filesystem::path& file) {
  Recorder(run, file).record();
}

}  // namespace burnish
