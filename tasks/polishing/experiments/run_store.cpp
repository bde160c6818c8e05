#include "polishing/experiments/run_store.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "base/whole_file.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "document/reader.hpp"
#include "document/text.hpp"
#include "polishing/figures.hpp"

namespace burnish::polishing {
namespace {

namespace fs = std::filesystem;
using document::Kind;
using document::Node;
using document::Reader;

// Conversion of values to nodes. JSON cannot represent infinity and NaN, so these are written as
// words.

Node text_node(const std::string& text) { return {.kind = Kind::Text, .text = text}; }
Node flag_node(bool value) { return {.kind = Kind::Bool, .text = value ? "true" : "false"}; }
Node number_node(double value) {
  if (std::isfinite(value)) return {.kind = Kind::Number, .text = document::number_text(value)};
  return text_node(std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf");
}
Node numbers_node(const Eigen::Ref<const Eigen::VectorXd>& values) {
  Node list{.kind = Kind::List};
  for (const double value : values) list.values.push_back(number_node(value));
  return list;
}
void put(Node& map, const std::string& key, Node value) {
  map.values.push_back(text_node(key));
  map.values.push_back(std::move(value));
}

double number_in(const Reader& value) {
  if (value.is_number()) return value.number();
  const std::string word = value.word({"nan", "inf", "-inf"});
  const double infinity = std::numeric_limits<double>::infinity();
  if (word == "nan") return RunFigures::none;
  return word == "inf" ? infinity : -infinity;
}
/// Returns a text that may be empty. Reader::text() rejects empty texts.
std::string text_in(const Reader& value) {
  return value.is_text() && value.node().text.empty() ? std::string() : value.text();
}
Eigen::VectorXd numbers_in(const Reader& value) {
  const std::vector<Reader> entries = value.entries();
  Eigen::VectorXd result(static_cast<Eigen::Index>(entries.size()));
  for (std::size_t i = 0; i < entries.size(); ++i)
    result[static_cast<Eigen::Index>(i)] = number_in(entries[i]);
  return result;
}

// A figure is stored as a number, a count, a word, or an optional value.

Node node_of(double value) { return number_node(value); }
Node node_of(int value) { return number_node(value); }
Node node_of(const std::string& value) { return text_node(value); }
Node node_of(const std::optional<double>& value) { return value ? number_node(*value) : Node{}; }

void read_into(const Reader& value, double& to) { to = number_in(value); }
void read_into(const Reader& value, int& to) { to = value.count(0); }
void read_into(const Reader& value, std::string& to) { to = text_in(value); }
void read_into(const Reader& value, std::optional<double>& to) {
  if (!value.is_null()) to = number_in(value);
}

const auto metric_table = [](const auto& see) { each_metric(see); };
const auto solver_table = [](const auto& see) { each_solver_figure(see); };
const auto standing_of_run = [](const auto& see) { each_standing_figure(see); };
const auto tick_table = [](const auto& see) { each_tick_figure(see); };
const auto run_table = [](const auto& see) { each_run_figure(see); };

template <class Values, class Table>
Node figures_node(const Values& values, const Table& table) {
  Node map{.kind = Kind::Map};
  table([&](const FigureEntry& entry, auto member) {
    put(map, entry.name, node_of(values.*member));
  });
  return map;
}

template <class Values, class Table>
void read_figures(const Reader& map, Values& values, const Table& table) {
  table([&](const FigureEntry& entry, auto member) { read_into(map[entry.name], values.*member); });
}

constexpr std::array curves_of_a_run{
    std::pair{"force", &RunCurves::force}, std::pair{"path", &RunCurves::path},
    std::pair{"target", &RunCurves::target}, std::pair{"distance", &RunCurves::distance}};

Node curves_node(const RunCurves& curves) {
  Node map{.kind = Kind::Map};
  for (const auto& [name, member] : curves_of_a_run) {
    const Curve& curve = curves.*member;
    Node node{.kind = Kind::Map};
    put(node, "name", text_node(curve.name));
    put(node, "x", numbers_node(curve.x));
    put(node, "y", numbers_node(curve.y));
    put(node, "color", number_node(curve.color));
    put(node, "dashed", flag_node(curve.dashed));
    put(map, name, std::move(node));
  }
  return map;
}

RunCurves curves_in(const Reader& map) {
  RunCurves curves;
  for (const auto& [name, member] : curves_of_a_run) {
    const Reader node = map[name];
    curves.*member = {.name = text_in(node["name"]),
                      .x = numbers_in(node["x"]),
                      .y = numbers_in(node["y"]),
                      .color = static_cast<int>(node["color"].number(-1.0, 100.0)),
                      .dashed = node["dashed"].yes_or_no()};
  }
  return curves;
}

Node measured_node(const std::vector<MeasuredFigure>& measured) {
  Node list{.kind = Kind::List};
  for (const MeasuredFigure& figure : measured) {
    Node map{.kind = Kind::Map};
    put(map, "test", text_node(figure.test));
    put(map, "figure", text_node(figure.figure));
    put(map, "value", number_node(figure.value));
    list.values.push_back(std::move(map));
  }
  return list;
}

std::vector<MeasuredFigure> measured_in(const Reader& list) {
  std::vector<MeasuredFigure> measured;
  for (const Reader& map : list.entries())
    measured.push_back({text_in(map["test"]), text_in(map["figure"]), number_in(map["value"])});
  return measured;
}

FaultKind fault_named(const Reader& value) {
  std::vector<std::string> names;
  for (int kind = 0; kind <= static_cast<int>(FaultKind::Watched); ++kind) {
    names.emplace_back(burnish::name_of(static_cast<FaultKind>(kind)));
    if (value.text() == names.back()) return static_cast<FaultKind>(kind);
  }
  value.refuse("wanted one of " + document::either(names));
}

/// Returns the part of a result that is identical on all machines that use the same kernels.
Node result_node(const RunFigures& run) {
  Node map{.kind = Kind::Map};
  put(map, "run", text_node(run.name));
  put(map, "seed", text_node(std::to_string(run.seed)));
  put(map, "outcome", text_node(run.outcome));
  put(map, "succeeded", flag_node(run.succeeded));
  put(map, "refused", flag_node(run.refused));
  put(map, "late", flag_node(run.late));
  put(map, "fault", text_node(std::string(burnish::name_of(run.fault))));
  put(map, "finite", flag_node(run.finite));
  put(map, "q_start", numbers_node(run.q_start));
  put(map, "p_center", numbers_node(run.p_center));
  put(map, "figures", figures_node(run, run_table));
  if (run.metrics) put(map, "metrics", figures_node(*run.metrics, metric_table));
  if (run.standing) put(map, "standing", figures_node(*run.standing, standing_of_run));
  if (run.curves) put(map, "curves", curves_node(*run.curves));
  if (!run.measured.empty()) put(map, "measured", measured_node(run.measured));
  return map;
}

/// Returns the part of a result that differs between machines: measured times, and the kernels.
Node times_node(const RunFigures& run) {
  Node map{.kind = Kind::Map};
  put(map, "kernels", text_node(run.kernels));
  put(map, "computing", number_node(run.computing));
  put(map, "ticks", figures_node(run.ticks, tick_table));
  if (run.metrics && run.metrics->solver)
    put(map, "solver", figures_node(*run.metrics->solver, solver_table));
  return map;
}

RunFigures read_result(const fs::path& result, const fs::path& times) {
  RunFigures run;
  const Reader map = Reader::load(result);
  run.made = true;
  run.name = text_in(map["run"]);
  map["seed"].named([&] { run.seed = std::stoull(map["seed"].text()); });
  run.outcome = text_in(map["outcome"]);
  run.succeeded = map["succeeded"].yes_or_no();
  run.refused = map["refused"].yes_or_no();
  run.late = map["late"].yes_or_no();
  run.fault = fault_named(map["fault"]);
  run.finite = map["finite"].yes_or_no();
  run.q_start = numbers_in(map["q_start"]);
  run.p_center = numbers_in(map["p_center"]);
  read_figures(map["figures"], run, run_table);
  if (map.has("metrics")) read_figures(map["metrics"], run.metrics.emplace(), metric_table);
  if (map.has("standing")) read_figures(map["standing"], run.standing.emplace(), standing_of_run);
  if (map.has("curves")) run.curves = curves_in(map["curves"]);
  if (map.has("measured")) run.measured = measured_in(map["measured"]);
  const Reader measured = Reader::load(times);
  run.kernels = text_in(measured["kernels"]);
  run.computing = number_in(measured["computing"]);
  read_figures(measured["ticks"], run.ticks, tick_table);
  if (run.metrics && measured.has("solver"))
    read_figures(measured["solver"], run.metrics->solver.emplace(), solver_table);
  return run;
}

std::string numbers_text(const Eigen::Ref<const Eigen::MatrixXd>& values) {
  std::string text;
  for (const double value : values.reshaped()) text += ' ' + document::number_text(value);
  return text + '\n';
}

/// Returns all numbers of a model that affect a run, as text.
std::string model_text(const Model& model) {
  std::string text;
  for (const Joint& joint : model.joints) {
    text += joint.name + ' ' + std::string(burnish::name_of(joint.kind)) + ' ' +
            std::to_string(joint.parent) + numbers_text(joint.placement.matrix()) +
            document::number_text(joint.mass) + numbers_text(joint.com) +
            numbers_text(joint.inertia_at_com);
    if (joint.follows)
      text += std::to_string(joint.follows->leader) +
              numbers_text(Eigen::Vector2d(joint.follows->multiplier, joint.follows->offset));
  }
  for (const Frame& frame : model.frames)
    text += frame.name + ' ' + std::to_string(frame.body) + numbers_text(frame.placement.matrix());
  for (const auto* values : {&model.q_lower, &model.q_upper, &model.velocity_limit,
                             &model.effort_limit, &model.damping, &model.friction, &model.armature})
    text += numbers_text(*values);
  if (!model.stiffness.isZero(0.0))
    text += numbers_text(model.stiffness) + numbers_text(model.spring_rest);
  for (const Tendon& tendon : model.tendons) {
    text += numbers_text(Eigen::Vector3d(tendon.rest, tendon.stiffness, tendon.damping));
    for (const Tendon::Entry& part : tendon.parts)
      text += std::to_string(part.v) + numbers_text(Eigen::VectorXd::Constant(1, part.coefficient));
  }
  return text + numbers_text(model.gravity);
}

/// Returns all numbers that define the run's robot, as text. If the robot cannot be loaded, returns
/// the error message; the run then reports the error.
std::string robot_text(const RunSpec& spec) {
  try {
    return numbers_of(spec.robot ? *spec.robot : load_task_robot(spec.task));
  } catch (const Error& error) {
    return error.what();
  }
}

/// Returns the 128-bit FNV-1a hash of the parts; the lengths of the parts are hashed too.
std::string hash_of(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += std::to_string(part.size()) + ':' + part + '\n';
  __extension__ using Wide = unsigned __int128;
  const Wide prime = (Wide{1} << 88) + 0x13B;
  Wide hash = (Wide{0x6C62272E07BB0142ULL} << 64) + 0x62B821756295C58DULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * prime;
  std::string digits;
  for (int shift = 124; shift >= 0; shift -= 4)
    digits += "0123456789abcdef"[static_cast<unsigned>(hash >> shift) & 15U];
  return digits;
}

}  // namespace

std::string numbers_of(const Robot& robot) {
  std::string text = model_text(robot.model) + robot.default_posture + '\n';
  for (const auto& [posture, values] : robot.postures)
    for (const auto& [joint, value] : values)
      text += posture + ' ' + joint +
              numbers_text(Eigen::Map<const Eigen::VectorXd>(
                  value.data(), static_cast<Eigen::Index>(value.size())));
  return text;
}

RunStore::RunStore(std::string experiment, std::string version, std::vector<fs::path> folders)
    : experiment_(std::move(experiment)),
      version_(std::move(version)),
      folders_(std::move(folders)) {}

std::string RunStore::name_of(const std::string& run, const RunSpec& spec) const {
  return hash_of({version_, experiment_, run, polishing::name_of(spec.controller),
                  std::string(burnish::name_of(spec.plant)), spec.check_reach ? "checked" : "",
                  task_text(spec.task), robot_text(spec)});
}

std::string RunStore::name_of(const std::string& run, const std::string& depends_on) const {
  return hash_of({version_, experiment_, run, depends_on});
}

std::optional<RunFigures> RunStore::find(const std::string& name) const {
  for (const fs::path& folder : folders_) {
    const fs::path result = folder / (name + ".json");
    std::error_code ignored;
    if (fs::exists(result, ignored)) return read_result(result, folder / (name + ".times.json"));
  }
  return std::nullopt;
}

void RunStore::keep(const std::string& name, const RunFigures& run) const {
  const fs::path& folder = folders_.front();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw Error("cannot create the folder '" + folder.string() + "': " + error.message());
  // The times are written first: if the file of the result exists, so does the file of its times.
  write_whole_file(folder / (name + ".times.json"), document::json_text(times_node(run)) + '\n');
  write_whole_file(folder / (name + ".json"), document::json_text(result_node(run)) + '\n');
}

}  // namespace burnish::polishing
