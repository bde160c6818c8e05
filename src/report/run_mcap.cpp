// A run's rows as a recording in MCAP.
#include <algorithm>
#include <cmath>

#include "burnish/dynamics/placement.hpp"
#include "report/json_writer.hpp"
#include "report/mcap.hpp"
#include "report/mcap_schemas.hpp"
#include "report/run_page.hpp"

namespace burnish {
namespace {

constexpr double transform_period = 0.01;  // s, between two messages of /tf

/// Links by the body that carries them: the first one stands for the body.
class LinkTree {
 public:
  explicit LinkTree(const Model& model) : model_(model), main_(model.joints.size(), -1) {
    for (std::size_t i = 0; i < model.frames.size(); ++i) {
      const Frame& frame = model.frames[i];
      if (frame.kind != FrameKind::Link || frame.body < 0) continue;
      int& main = main_[static_cast<std::size_t>(frame.body)];
      if (main < 0) main = static_cast<int>(i);
    }
  }
  const std::vector<int>& main() const { return main_; }
  /// Of the main link of a body; "world" for -1.
  std::string name(int body) const {
    return body < 0 || at(body) < 0 ? "world" : model_.frames[index(body)].name;
  }
  /// Of the body in its main link.
  Eigen::Isometry3d body_in_link(int body) const {
    if (body < 0 || at(body) < 0) return Eigen::Isometry3d::Identity();
    return model_.frames[index(body)].placement.inverse();
  }

 private:
  int at(int body) const { return main_[static_cast<std::size_t>(body)]; }
  std::size_t index(int body) const { return static_cast<std::size_t>(at(body)); }
  const Model& model_;
  std::vector<int> main_;
};

void write_moment(JsonWriter& json, std::uint64_t time) {
  constexpr std::uint64_t second = 1'000'000'000;
  json.key("timestamp");
  json.begin_object();
  json.field("sec", static_cast<std::int64_t>(time / second));
  json.field("nsec", static_cast<std::int64_t>(time % second));
  json.end_object();
}
void write_named(JsonWriter& json, const char* name, const char* letters, const double* values) {
  json.key(name);
  json.begin_object();
  for (; *letters != '\0'; ++letters) json.field(std::string(1, *letters), *values++);
  json.end_object();
}
void write_placement(JsonWriter& json, const char* where, const char* how,
                     const Eigen::Isometry3d& placement) {
  const Eigen::Vector3d p = placement.translation();
  const Eigen::Quaterniond rotation = Eigen::Quaterniond(placement.linear()).normalized();
  write_named(json, where, "xyz", p.data());
  write_named(json, how, "xyzw", rotation.coeffs().data());
}
void write_transform(JsonWriter& json, std::uint64_t time, const std::string& parent,
                     const std::string& child, const Eigen::Isometry3d& placement) {
  json.begin_object();
  write_moment(json, time);
  json.field("parent_frame_id", parent);
  json.field("child_frame_id", child);
  write_placement(json, "translation", "rotation", placement);
  json.end_object();
}

/// Size and kind of what a scene can show; meshes it cannot.
struct Solid {
  const char* kind;  ///< of foxglove.SceneEntity; null: nothing
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

void write_entity(JsonWriter& json, std::uint64_t time, const std::string& frame,
                  const std::string& id, const Solid& solid, const Eigen::Isometry3d& placement,
                  const Eigen::Vector4d& rgba) {
  json.begin_object();
  write_moment(json, time);
  json.field("frame_id", frame);
  json.field("id", id);
  json.field("frame_locked", true);
  json.key(solid.kind);
  json.begin_array();
  json.begin_object();
  json.key("pose");
  json.begin_object();
  write_placement(json, "position", "orientation", placement);
  json.end_object();
  write_named(json, "size", "xyz", solid.size.data());
  write_named(json, "color", "rgba", rgba.data());
  if (std::string_view(solid.kind) == "cylinders") {
    json.field("bottom_scale", 1.0);
    json.field("top_scale", 1.0);
  }
  json.end_object();
  json.end_array();
  json.end_object();
}

/// Writes the messages of a run.
class Recorder {
 public:
  Recorder(const RunPage& run, const std::filesystem::path& file)
      : run_(run), model_(run.robot.model), links_(model_), out_(file, "burnish " + run.version) {
    joints_ = channel("/joint_states", "burnish.JointStates", mcap::joint_states());
    forces_ = table("/force", "burnish.Force",
                    {"force_normal", "force_normal_mean", "force_estimated", "force_measured",
                     "force_target", "force_t1", "force_t2", "in_contact"});
    task_ =
        table("/task", "burnish.Task",
              {"phase", "path_u", "path_w", "target_u", "target_w", "path_error", "tool_turned"});
    const std::uint16_t pose = out_.add_schema("foxglove.PoseInFrame", mcap::pose_in_frame());
    tool_ = out_.add_channel(pose, "/tool_pose");
    target_ = out_.add_channel(pose, "/target_pose");
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
      write_table(forces_, row, time);
      write_table(task_, row, time);
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
    throw Error("the recording needs the column '" + name + "', which the run does not have");
  }
  Table table(const char* topic, const char* name, std::vector<std::string> names) {
    Table result{channel(topic, name, mcap::numbers(names)), std::move(names), {}};
    for (const std::string& each : result.names) result.columns.push_back(column(each));
    return result;
  }

  void write_table(const Table& table, Eigen::Index row, std::uint64_t time) {
    json_.begin_object();
    write_moment(json_, time);
    for (std::size_t i = 0; i < table.names.size(); ++i)
      json_.field(table.names[i], (*table.columns[i])[row]);
    json_.end_object();
    out_.write(table.channel, time, json_.take());
  }
  void write_joints(Eigen::Index row, std::uint64_t time) {
    json_.begin_object();
    write_moment(json_, time);
    json_.key("name");
    json_.begin_array();
    for (const Joint& joint : model_.joints) json_.value(joint.name);
    json_.end_array();
    const auto entries = [&](const char* name, const auto& value_of) {
      json_.key(name);
      json_.begin_array();
      for (const Joint& joint : model_.joints) json_.value(value_of(joint));
      json_.end_array();
    };
    const auto at = [row](const auto& columns, int index) {
      return (*columns[static_cast<std::size_t>(index)])[row];
    };
    // A follower moves with its leader, whose motor drives it.
    const Following itself;
    const auto following = [&](const Joint& joint) { return joint.follows.value_or(itself); };
    entries("position", [&](const Joint& joint) {
      return following(joint).multiplier * at(q_, joint.q_index) + following(joint).offset;
    });
    entries("velocity", [&](const Joint& joint) {
      return following(joint).multiplier * at(v_, joint.v_index);
    });
    entries("effort",
            [&](const Joint& joint) { return joint.follows ? 0.0 : at(tau_, joint.v_index); });
    json_.end_object();
    out_.write(joints_, time, json_.take());
  }
  void write_pose(std::uint16_t channel, std::uint64_t time, const Eigen::Isometry3d& placement) {
    json_.begin_object();
    write_moment(json_, time);
    json_.field("frame_id", "world");
    json_.key("pose");
    json_.begin_object();
    write_placement(json_, "position", "orientation", placement);
    json_.end_object();
    json_.end_object();
    out_.write(channel, time, json_.take());
  }
  /// Tool, target and, where they are due, the main links.
  void write_placements(Eigen::Index row, std::uint64_t time, bool with_links) {
    if (!with_links) return;
    Eigen::VectorXd q(model_.nq);
    for (int k = 0; k < model_.nq; ++k) q[k] = (*q_[static_cast<std::size_t>(k)])[row];
    const std::vector<Eigen::Isometry3d> frames = frame_placements(model_, q);
    Eigen::Isometry3d tool = frames[static_cast<std::size_t>(model_.frame_index(run_.tool_frame))];
    write_pose(tool_, time, tool);
    const auto tangents = run_.surface.axes.leftCols<2>();
    tool.translation() =
        run_.path_origin_world +
        tangents * Eigen::Vector2d((*task_.columns[3])[row], (*task_.columns[4])[row]);
    tool.linear() = run_.surface.axes;
    write_pose(target_, time, tool);
    json_.begin_object();
    json_.key("transforms");
    json_.begin_array();
    for (const int main : links_.main())
      if (main >= 0)
        write_transform(json_, time, "world", model_.frames[static_cast<std::size_t>(main)].name,
                        frames[static_cast<std::size_t>(main)]);
    json_.end_array();
    json_.end_object();
    out_.write(transforms_, time, json_.take());
  }
  /// Links that do not move against the main one of their body, or against the world.
  void write_fixed(std::uint64_t time) {
    json_.begin_object();
    json_.key("transforms");
    json_.begin_array();
    for (const Frame& frame : model_.frames) {
      const std::string parent = links_.name(frame.body);
      if (frame.kind == FrameKind::Joint || frame.name == parent) continue;
      write_transform(json_, time, parent, frame.name,
                      links_.body_in_link(frame.body) * frame.placement);
    }
    json_.end_array();
    json_.end_object();
    out_.write(fixed_, time, json_.take());
  }
  void write_scene(std::uint64_t time) {
    json_.begin_object();
    json_.key("deletions");
    json_.begin_array();
    json_.end_array();
    json_.key("entities");
    json_.begin_array();
    int count = 0;
    for (const Visual& visual : model_.visuals) {
      const Solid solid = solid_of(visual.shape);
      const std::string id = visual.link + " " + std::to_string(count++);
      if (solid.kind == nullptr) continue;
      write_entity(json_, time, links_.name(visual.body), id, solid,
                   links_.body_in_link(visual.body) * visual.placement, visual.rgba);
    }
    constexpr double side = 0.6, thickness = 0.005;  // m, of the surface as it is drawn
    Eigen::Isometry3d plate = Eigen::Isometry3d::Identity();
    plate.linear() = run_.surface.true_axes;
    const Eigen::Vector3d n = run_.surface.true_axes.col(2);
    plate.translation() =
        run_.path_origin_world -
        n * (n.dot(run_.path_origin_world - run_.surface.true_point) + 0.5 * thickness);
    write_entity(json_, time, "world", "surface", {"cubes", {side, side, thickness}}, plate,
                 {0.6, 0.7, 0.8, 0.5});
    json_.end_array();
    json_.end_object();
    out_.write(scene_, time, json_.take());
  }
  /// Plans up to a time, so that messages come in the order of their times.
  void write_until(double now) {
    while (run_.solver && next_solve_ < run_.solver->time.size() &&
           run_.solver->time[next_solve_] <= now) {
      const PageSolver& solver = *run_.solver;
      const std::uint64_t time = moment(solver.time[next_solve_]);
      json_.begin_object();
      write_moment(json_, time);
      json_.field("solve_ms", solver.solve_ms[next_solve_]);
      json_.field("iterations", solver.iterations[next_solve_]);
      json_.field("missed", solver.missed[next_solve_]);
      json_.end_object();
      out_.write(solver_, time, json_.take());
      ++next_solve_;
    }
    while (run_.plans && next_plan_ < run_.plans->time.size() &&
           run_.plans->time[next_plan_] <= now) {
      const PlanRecord& plans = *run_.plans;
      const std::uint64_t time = moment(plans.time[next_plan_]);
      json_.begin_object();
      write_moment(json_, time);
      for (std::size_t i = 0; i < plans.terms.size(); ++i)
        json_.field(plans.terms[i], plans.costs[i][next_plan_]);
      json_.end_object();
      out_.write(costs_, time, json_.take());
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
      json_.value(metric.value.value_or(std::nan("")));
      const std::string number = json_.take();
      metrics[metric.name] = number + (metric.unit == "1" ? "" : " " + metric.unit);
    }
    out_.add_metadata("metrics", metrics);
  }

  const RunPage& run_;
  const Model& model_;
  LinkTree links_;
  McapWriter out_;
  JsonWriter json_;
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
