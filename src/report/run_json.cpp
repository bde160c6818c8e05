#include <chrono>
#include <cstdio>
#include <limits>

#include "burnish/base/error.hpp"
#include "burnish/base/views.hpp"
#include "report/json_writer.hpp"
#include "report/run_page.hpp"

namespace burnish {
namespace {

void write_floats(JsonWriter& json, const char* name, const ConstVectorRef& values) {
  json.key(name);
  json.floats(values);
}

VectorView mapped(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

void write_about(JsonWriter& json, const RunPage& run) {
  json.field("name", run.name);
  json.field("created", utc_text(run.created));
  json.field("version", run.version);
  json.key("facts");
  json.begin_array();
  for (const auto& [name, value] : run.facts) {
    json.begin_array();
    json.value(name);
    json.value(value);
    json.end_array();
  }
  json.end_array();
  json.field("command", run.command);
  json.field("outcome", run.outcome);
  json.field("polished", run.polished);
  json.key("fault");
  if (run.fault) {
    json.begin_object();
    json.field("kind", run.fault->kind);
    json.field("time", run.fault->time);
    json.field("text", run.fault->text);
    json.end_object();
  } else {
    json.null();
  }
  json.field("task_file", run.task_file);
  json.field("duration", run.duration);
}

void write_metrics(JsonWriter& json, const RunPage& run) {
  json.key("metrics");
  json.begin_array();
  for (const PageMetric& metric : run.metrics) {
    json.begin_object();
    json.field("name", metric.name);
    json.field("label", metric.label);
    json.key("value");
    metric.value ? json.value(*metric.value) : json.null();
    json.field("unit", metric.unit);
    json.field("text", metric.text);
    json.end_object();
  }
  json.end_array();
  json.key("window");
  if (!run.window) return json.null();
  json.value(Eigen::Vector2d(run.window->first, run.window->second));
}

void write_axes(JsonWriter& json, const char* name, const Eigen::Matrix3d& axes) {
  json.field(name, Eigen::Map<const Eigen::VectorXd>(axes.data(), 9));  // column by column
}

void write_scene(JsonWriter& json, const RunPage& run) {
  json.key("tool");
  json.begin_object();
  json.field("frame", run.tool_frame);
  json.field("tip_radius", run.tip_radius);
  json.end_object();
  json.key("surface");
  json.begin_object();
  json.field("point", run.surface.point);
  write_axes(json, "axes", run.surface.axes);
  json.field("true_point", run.surface.true_point);
  write_axes(json, "true_axes", run.surface.true_axes);
  json.field("friction", run.surface.friction);
  json.field("extent", run.surface.extent);
  json.end_object();
  json.key("path");
  json.begin_object();
  write_floats(json, "u", run.path_u);
  write_floats(json, "w", run.path_w);
  json.end_object();
  json.field("path_origin", run.path_origin_world);
}

void write_series(JsonWriter& json, const RunPage& run) {
  json.key("series");
  json.begin_object();
  write_floats(json, "time", run.time);
  json.key("columns");
  json.begin_array();
  for (const PageColumn& column : run.columns) {
    json.begin_object();
    json.field("name", column.name);
    json.field("unit", column.unit);
    write_floats(json, "data", column.values);
    json.end_object();
  }
  json.end_array();
  json.end_object();
  json.key("envelopes");
  json.begin_object();
  json.key("columns");
  json.begin_array();
  for (const PageEnvelope& envelope : run.envelopes) {
    json.begin_object();
    json.field("name", envelope.name);
    write_floats(json, "min", envelope.lower);
    write_floats(json, "max", envelope.upper);
    json.end_object();
  }
  json.end_array();
  json.end_object();
}

/// [lower, upper] per joint; joints of several entries have none.
void write_limits(JsonWriter& json, const Model& model) {
  const auto list = [&](const char* name, const auto& limit_of) {
    json.key(name);
    json.begin_array();
    for (const Joint& joint : model.joints)
      if (!joint.follows) json.value(limit_of(joint));
    json.end_array();
  };
  const double none = std::numeric_limits<double>::infinity();
  const auto about_zero = [&](const Eigen::VectorXd& limits) {
    return [&](const Joint& joint) {
      const double limit = joint.nv == 1 ? limits[joint.v_index] : none;
      return Eigen::Vector2d(-limit, limit);
    };
  };
  json.key("limits");
  json.begin_object();
  list("tau", about_zero(model.effort_limit));
  list("v", about_zero(model.velocity_limit));
  list("q", [&](const Joint& joint) {
    if (joint.nq != 1) return Eigen::Vector2d(-none, none);
    return Eigen::Vector2d(model.q_lower[joint.q_index], model.q_upper[joint.q_index]);
  });
  json.end_object();
}

void write_phases(JsonWriter& json, const RunPage& run) {
  json.key("phases");
  json.begin_array();
  for (const PagePhase& phase : run.phases) {
    json.begin_object();
    json.field("name", phase.name);
    json.field("start", phase.start);
    json.field("end", phase.end);
    json.end_object();
  }
  json.end_array();
}

void write_solver(JsonWriter& json, const std::optional<PageSolver>& solver) {
  json.key("solver");
  if (!solver) return json.null();
  json.begin_object();
  write_floats(json, "time", solver->time);
  write_floats(json, "solve_ms", solver->solve_ms);
  write_floats(json, "iterations", solver->iterations);
  write_floats(json, "missed", solver->missed);
  json.field("period_ms", solver->period_ms);
  json.key("deadline_ms");
  solver->deadline_ms ? json.value(*solver->deadline_ms) : json.null();
  json.end_object();
}

void write_plans(JsonWriter& json, const std::optional<PlanRecord>& plans) {
  json.key("costs");
  if (plans) {
    json.begin_object();
    write_floats(json, "time", mapped(plans->time));
    json.key("terms");
    json.begin_array();
    for (std::size_t i = 0; i < plans->terms.size(); ++i) {
      json.begin_object();
      json.field("name", plans->terms[i]);
      write_floats(json, "value", mapped(plans->costs[i]));
      json.end_object();
    }
    json.end_array();
    json.end_object();
  } else {
    json.null();
  }
  json.key("horizon");
  if (!plans) return json.null();
  json.begin_object();
  write_floats(json, "time", mapped(plans->time));
  json.field("knots", plans->knots);
  json.field("step", plans->step);
  json.field("nq", plans->nq);
  json.key("q");
  json.floats(plans->q);
  json.end_object();
}

void write_head(JsonWriter& json, const PageHead& head, const char* kind) {
  json.field("format", page_format);
  json.field("kind", kind);
  json.field("title", head.title);
  json.field("version", head.version);
  json.field("created", utc_text(head.created));
}

}  // namespace

std::string run_page_json(const RunPage& run) {
  JsonWriter json;
  json.begin_object();
  write_about(json, run);
  write_metrics(json, run);
  json.key("robot");
  json.raw(robot_json(run.robot));
  write_scene(json, run);
  write_series(json, run);
  write_limits(json, run.robot.model);
  write_phases(json, run);
  write_solver(json, run.solver);
  write_plans(json, run.plans);
  json.end_object();
  return json.take();
}

std::string page_json(const PageHead& head, const std::vector<std::string>& runs) {
  JsonWriter json;
  json.begin_object();
  write_head(json, head, "run");
  json.key("runs");
  json.begin_array();
  for (const std::string& run : runs) json.raw(run);
  json.end_array();
  json.key("robot");
  json.null();
  json.end_object();
  return json.take();
}

std::string robot_page_json(const PageHead& head, const RobotDrawing& robot) {
  JsonWriter json;
  json.begin_object();
  write_head(json, head, "robot");
  json.key("runs");
  json.begin_array();
  json.end_array();
  json.key("robot");
  json.raw(robot_json(robot));
  json.end_object();
  return json.take();
}

std::string page_html(std::string_view page_template, std::string_view data) {
  constexpr std::string_view before = "id=\"burnish-data\">", after = "null</script>";
  const std::string place = std::string(before) + std::string(after);
  const std::size_t at = page_template.find(place);
  if (at == std::string_view::npos || page_template.find(place, at + 1) != std::string_view::npos)
    throw Error("the page's template has " +
                std::string(at == std::string_view::npos ? "no place" : "several places") +
                " for its data; wanted one script element burnish-data that holds null");
  std::string html;
  html.reserve(page_template.size() + data.size());
  html += page_template.substr(0, at + before.size());
  // Texts in the data could end the script element, or begin a comment in it.
  for (const char letter : data) letter == '<' ? html += "\\u003c" : html += letter;
  html += page_template.substr(at + before.size() + std::string_view("null").size());
  return html;
}

std::string utc_text(std::int64_t seconds) {
  using std::chrono::days;
  const std::chrono::sys_seconds moment{std::chrono::seconds(seconds)};
  const auto midnight = std::chrono::floor<days>(moment);
  const std::chrono::year_month_day date(midnight);
  const auto second = static_cast<int>((moment - midnight).count());
  char text[64];
  std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02d:%02d:%02dZ", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                second / 3600, second / 60 % 60, second % 60);
  return text;
}

}  // namespace burnish
