#include "polish_page.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "burnish/contact/reference.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "mesh_file.hpp"
#include "page/page_template.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;
using polishing::ControllerKind;
using polishing::RunResult;
using polishing::Task;

constexpr const char* no_page =
    "this program was built without the page of runs (Node or its packages were not there)";
/// Bytes: browsers open what is larger, but slowly.
constexpr std::size_t largest_comparison = 100'000'000;

std::int64_t now() {
  using namespace std::chrono;
  return duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
}

std::string vector_text(const Eigen::Vector3d& v) {
  const auto plain = [](double x) { return std::abs(x) < 5e-4 ? 0.0 : x; };
  return fmt::format("({:.3g}, {:.3g}, {:.3g})", plain(v.x()), plain(v.y()), plain(v.z()));
}

std::vector<std::pair<std::string, std::string>> facts_of(const PolishJob& job,
                                                          const RunResult& result) {
  const Task& task = job.spec.task;
  std::vector<std::pair<std::string, std::string>> facts{
      {"task", job.place},
      {"robot", task.robot},
      {"surface", "normal " + vector_text(result.setting.scene.surface.normal)},
      {"force", fmt::format("{:g} N", task.force)},
      {"path", fmt::format("{}, {:g} s", name_of(task.path.kind), task.polish_duration)},
      {"controller", name_of(job.spec.controller)}};
  if (job.spec.controller == ControllerKind::Mpc)
    facts.emplace_back("plans", fmt::format("{:g} Hz, horizon {:g} s in steps of {:g} s",
                                            task.update_rate, task.horizon, task.step));
  facts.emplace_back("plant", name_of(job.spec.plant));
  facts.emplace_back("seed", std::to_string(task.disturbances.seed));
  return facts;
}

void add_scene(RunPage& page, const Task& task, const polishing::Setting& setting) {
  const SurfaceSpec plant = plant_scene(setting.scene, task.disturbances).surface;
  page.tool_frame = setting.scene.tip.frame;
  page.tip_radius = setting.scene.tip.radius;
  page.surface = {.point = setting.scene.surface.point,
                  .axes = setting.surface_axes,
                  .true_point = plant.point,
                  .true_axes = Reference::surface_with_normal(plant.normal).rotation,
                  .friction = plant.friction,
                  .extent = plant.extent};
  page.path_origin_world = setting.p_center;
  const polishing::Path path(task.path);
  constexpr int most_points = 4000;
  const int points = std::clamp(static_cast<int>(task.polish_duration / 0.01), 2, most_points);
  page.path_u.resize(points);
  page.path_w.resize(points);
  for (int i = 0; i < points; ++i) {
    const Eigen::Vector2d p = path.at(task.polish_duration * i / (points - 1)).p;
    page.path_u[i] = p.x();
    page.path_w[i] = p.y();
  }
}

PagePlans plans_of(const polishing::PlanRecord& record) {
  PagePlans plans{.terms = record.terms,
                  .knots = record.knots,
                  .nq = record.nq,
                  .step = record.step,
                  .q = record.q};
  const auto count = static_cast<Eigen::Index>(record.time.size());
  plans.time = Eigen::Map<const Eigen::VectorXd>(record.time.data(), count);
  plans.costs.resize(count, static_cast<Eigen::Index>(record.terms.size()));
  for (std::size_t term = 0; term < record.terms.size(); ++term)
    plans.costs.col(static_cast<Eigen::Index>(term)) =
        Eigen::Map<const Eigen::VectorXd>(record.costs[term].data(), count);
  return plans;
}

void check_page() {
  if (page_template().empty()) throw Error(no_page);
}

}  // namespace

RunPage make_run_page(const PolishJob& job, const RunResult& result, int record_every) {
  const Task& task = job.spec.task;
  const Robot& robot = result.setting.robot;
  RunPage page{.name = job.name,
               .created = now(),
               .version = BURNISH_VERSION,
               .facts = facts_of(job, result),
               .command = job.command,
               .outcome = result.outcome,
               .polished = result.polished,
               .metrics = page_metrics(result.metrics),
               .task_file = polishing::task_text(task),
               .robot = {.model = robot.model, .q = result.setting.q_start}};
  for (const auto& [name, posture] : robot.postures)
    page.robot.postures[name] = configuration(robot.model, posture);
  page.robot.meshes = load_meshes(robot.model, robot_folder(task.robot));
  if (result.fault.kind != FaultKind::None)
    page.fault =
        PageFault{std::string(name_of(result.fault.kind)), result.fault.time, result.fault.text()};
  if (result.metrics) page.window = {result.metrics->start, result.metrics->end};
  add_scene(page, task, result.setting);
  if (job.spec.controller == ControllerKind::Mpc) {
    page.solver = PageSolver{.period_ms = 1e3 / task.update_rate};
    if (std::isfinite(task.limits.deadline)) page.solver->deadline_ms = 1e3 * task.limits.deadline;
  }
  if (!result.plans.time.empty()) page.plans = plans_of(result.plans);
  add_trace(page, result.trace, record_every);
  return page;
}

std::vector<std::string> PageWriter::write(const PolishJob& job, const RunResult& result,
                                           int record_every, const fs::path& folder) {
  std::vector<std::string> written;
  std::error_code ignored;  // of a run before in the same folder
  for (const char* name : {"run.json", "run.html", "run.mcap"}) fs::remove(folder / name, ignored);
  if ((!pages_ && !recordings_) || result.trace.rows() == 0) return written;
  const RunPage page = make_run_page(job, result, record_every);
  if (pages_) {
    std::string run = run_page_json(page);
    const std::string data =
        page_json({.title = page.name, .version = page.version, .created = page.created}, {run});
    write_text(folder / "run.json", data);
    written.emplace_back("run.json");
    if (!page_template().empty()) {
      write_text(folder / "run.html", page_html(page_template(), data));
      written.emplace_back("run.html");
    }
    names_.push_back(job.name);
    size_ += run.size();
    if (size_ > largest_comparison) run.clear();
    runs_.push_back(std::move(run));
  }
  if (recordings_) {
    write_run_mcap(page, folder / "run.mcap");
    written.emplace_back("run.mcap");
  }
  return written;
}

std::string PageWriter::finish(const fs::path& folder) const {
  std::error_code ignored;
  const fs::path file = folder / "comparison.html";
  fs::remove(file, ignored);
  if (!pages_ || runs_.empty()) return "";
  if (page_template().empty()) return std::string("no run.html: ") + no_page;
  if (runs_.size() < 2) return "";
  if (size_ > largest_comparison)
    return "no comparison.html: the runs are too many for one page; burnish report makes one of "
           "some of them";
  write_runs_page(names_, runs_, file);
  return "all runs on one page: " + file.string();
}

void write_runs_page(const std::vector<std::string>& names, const std::vector<std::string>& runs,
                     const fs::path& file) {
  check_page();
  const PageHead head{.title = joined_names(names), .version = BURNISH_VERSION, .created = now()};
  write_text(file, page_html(page_template(), page_json(head, runs)));
}

void write_robot_page(const RobotDrawing& robot, const fs::path& file) {
  check_page();
  const PageHead head{.title = robot.model.name, .version = BURNISH_VERSION, .created = now()};
  write_text(file, page_html(page_template(), robot_page_json(head, robot)));
}

std::string joined_names(const std::vector<std::string>& names) {
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return text;
}

}  // namespace burnish::app
