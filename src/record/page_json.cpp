#include "record/page_json.hpp"

#include <bit>
#include <chrono>
#include <cstdio>
#include <limits>

#include "base/to_size.hpp"
#include "burnish/base/error.hpp"

namespace burnish {
namespace {

/// Returns bytes in base64 (RFC 4648, section 4).
std::string base64(const std::string& bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = (group << 8U) | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      result += k <= count ? letters[(group >> (18 - 6 * k)) & 63U] : '=';
  }
  return result;
}

/// Packs words of 32 bits, little-endian.
template <class Word>
Json packed(const char* kind, std::span<const Word> words) {
  std::string bytes;
  bytes.reserve(4 * words.size());
  for (const Word word : words)
    for (int shift = 0; shift < 32; shift += 8)
      bytes += static_cast<char>(std::bit_cast<std::uint32_t>(word) >> shift & 0xFFU);
  return {{"n", words.size()}, {kind, base64(bytes)}};
}

Json floats_json(const ConstVectorRef& numbers) {
  const Eigen::VectorXf rounded = numbers.cast<float>();
  return packed_json({rounded.data(), to_size(rounded.size())});
}
Json floats_json(const std::vector<double>& numbers) {
  return floats_json(VectorView(numbers.data(), static_cast<Eigen::Index>(numbers.size())));
}

/// Returns the list of json_of(entry) for every entry.
template <class List, class JsonOf>
Json list_json(const List& list, JsonOf&& json_of) {
  Json json = Json::array();
  for (const auto& entry : list) json.push_back(json_of(entry));
  return json;
}

Json about_json(const RunPage& run) {
  Json json{{"name", run.name},
            {"created", utc_text(run.created)},
            {"version", run.version},
            {"facts", list_json(run.facts,
                                [](const auto& fact) {
                                  return Json::array({fact.first, fact.second});
                                })},
            {"command", run.command},
            {"outcome", run.outcome},
            {"succeeded", run.succeeded},
            {"fault", nullptr},
            {"task_file", run.task_file},
            {"duration", number_json(run.duration)}};
  if (run.fault)
    json["fault"] = {{"kind", run.fault->kind},
                     {"time", number_json(run.fault->time)},
                     {"text", run.fault->text}};
  return json;
}

void add_metrics(Json& json, const RunPage& run) {
  json["metrics"] = list_json(run.metrics, [](const PageMetric& metric) {
    return Json{{"name", metric.name},
                {"label", metric.label},
                {"value", number_json(metric.value)},
                {"unit", metric.unit},
                {"text", metric.text}};
  });
  json["window"] = nullptr;
  if (run.window)
    json["window"] = Json::array({number_json(run.window->first), number_json(run.window->second)});
}

void add_scene(Json& json, const RunPage& run) {
  const auto axes_json = [](const Eigen::Matrix3d& axes) {  // column by column
    return numbers_json(Eigen::Map<const Eigen::VectorXd>(axes.data(), 9));
  };
  json["tool"] = {{"frame", run.tool_frame}, {"tip_radius", number_json(run.tip_radius)}};
  json["surface"] = {{"point", numbers_json(run.surface.point)},
                     {"axes", axes_json(run.surface.axes)},
                     {"true_point", numbers_json(run.surface.true_point)},
                     {"true_axes", axes_json(run.surface.true_axes)},
                     {"friction", number_json(run.surface.friction)},
                     {"extent", number_json(run.surface.extent)}};
  json["surface"]["patch"] = nullptr;
  if (run.surface.patch)
    json["surface"]["patch"] = {{"side", run.surface.patch->side},
                                {"points", packed_json(run.surface.patch->points)}};
  json["path"] = {{"u", floats_json(run.path_u)}, {"w", floats_json(run.path_w)}};
  if (run.path_h.size() > 0) json["path"]["h"] = floats_json(run.path_h);
  json["path_origin"] = numbers_json(run.path_origin_world);
}

/// Adds the supports of a robot and the pushes on it, if there are any.
void add_supports(Json& json, const RunPage& run) {
  if (!run.supports.empty())
    json["supports"] = list_json(run.supports, [](const TouchSpec& support) {
      return Json{{"frame", support.frame},
                  {"half_x", number_json(support.half_x)},
                  {"half_y", number_json(support.half_y)},
                  {"radius", number_json(support.radius)},
                  {"point", numbers_json(support.surface.point)},
                  {"normal", numbers_json(support.surface.normal.normalized())},
                  {"friction", number_json(support.surface.friction)}};
    });
  if (!run.pushes.empty())
    json["pushes"] = list_json(run.pushes, [](const Push& push) {
      return Json{{"frame", push.frame},
                  {"start", number_json(push.start)},
                  {"duration", number_json(push.duration)},
                  {"force", numbers_json(push.force_world)}};
    });
}

/// Adds the frames, forces and constraint rows of a planned motion.
void add_planned(Json& json, const RunPage& run) {
  if (!run.plan) return;
  json["plan"] = {{"frames", run.plan->frames},
                  {"forces", run.plan->forces},
                  {"limits", list_json(run.plan->limits, [](const PageLimit& limit) {
                     return Json{{"name", limit.name},
                                 {"margin", floats_json(limit.margin)},
                                 {"multiplier", floats_json(limit.multiplier)}};
                   })}};
}

void add_series(Json& json, const RunPage& run) {
  const auto column_json = [](const PageColumn& column) {
    return Json{{"name", column.name}, {"unit", column.unit}, {"data", floats_json(column.values)}};
  };
  const auto envelope_json = [](const PageEnvelope& envelope) {
    return Json{{"name", envelope.name},
                {"min", floats_json(envelope.lower)},
                {"max", floats_json(envelope.upper)}};
  };
  json["series"] = {{"time", floats_json(run.time)},
                    {"columns", list_json(run.columns, column_json)}};
  json["envelopes"] = {{"columns", list_json(run.envelopes, envelope_json)}};
}

/// Returns [lower, upper] per joint; null without a limit and for joints with several entries.
Json limits_json(const Model& model) {
  const double none = std::numeric_limits<double>::infinity();
  const auto list = [&](const auto& limit_of) {
    Json json = Json::array();
    for (const Joint& joint : model.joints)
      if (!joint.follows) json.push_back(numbers_json(limit_of(joint)));
    return json;
  };
  const auto about_zero = [&](const Eigen::VectorXd& limits) {
    return list([&](const Joint& joint) {
      const double limit = joint.nv == 1 ? limits[joint.v_index] : none;
      return Eigen::Vector2d(-limit, limit);
    });
  };
  const auto position = [&](const Joint& joint) {
    if (joint.nq != 1) return Eigen::Vector2d(-none, none);
    return Eigen::Vector2d(model.q_lower[joint.q_index], model.q_upper[joint.q_index]);
  };
  return {{"tau", about_zero(model.effort_limit)},
          {"v", about_zero(model.velocity_limit)},
          {"q", list(position)}};
}

void add_solver(Json& json, const std::optional<PageSolver>& solver) {
  json["solver"] = nullptr;
  if (solver)
    json["solver"] = {{"time", floats_json(solver->time)},
                      {"solve_ms", floats_json(solver->solve_ms)},
                      {"iterations", floats_json(solver->iterations)},
                      {"missed", floats_json(solver->missed)},
                      {"period_ms", number_json(solver->period_ms)},
                      {"deadline_ms", number_json(solver->deadline_ms)}};
}

void add_plans(Json& json, const std::optional<PlanRecord>& plans) {
  json["costs"] = nullptr;
  json["horizon"] = nullptr;
  if (!plans) return;
  Json terms = Json::array();
  for (std::size_t i = 0; i < plans->terms.size(); ++i)
    terms.push_back({{"name", plans->terms[i]}, {"value", floats_json(plans->costs[i])}});
  json["costs"] = {{"time", floats_json(plans->time)}, {"terms", std::move(terms)}};
  json["horizon"] = {{"time", floats_json(plans->time)},
                     {"knots", plans->knots},
                     {"step", number_json(plans->step)},
                     {"nq", plans->nq},
                     {"q", packed_json(plans->q)}};
}

/// Returns the data of a page. `runs` and `robot` are JSON texts; `robot` is "null" without a
/// robot.
std::string page_text(const PageHead& head, const char* kind, const std::vector<std::string>& runs,
                      const std::string& robot) {
  std::string text = compact_text({{"format", page_format},
                                   {"kind", kind},
                                   {"title", head.title},
                                   {"version", head.version},
                                   {"created", utc_text(head.created)}});
  text.back() = ',';
  text += "\"runs\":[";
  for (std::size_t i = 0; i < runs.size(); ++i) text += (i == 0 ? "" : ",") + runs[i];
  return text + "],\"robot\":" + robot + '}';
}

}  // namespace

std::string compact_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json packed_json(std::span<const float> numbers) { return packed("f32", numbers); }
Json packed_json(std::span<const std::uint32_t> numbers) { return packed("u32", numbers); }

Json pose_json(const Eigen::Isometry3d& placement) {
  Eigen::Quaterniond rotation(placement.linear());
  if (rotation.w() < 0.0) rotation.coeffs() *= -1.0;
  Eigen::Matrix<double, 7, 1> numbers;
  numbers << placement.translation(), rotation.normalized().coeffs();
  return numbers_json(numbers);
}

std::string run_page_json(const RunPage& run) {
  Json json = about_json(run);
  add_metrics(json, run);
  json["robot"] = robot_json(run.robot);
  add_scene(json, run);
  add_supports(json, run);
  add_planned(json, run);
  add_series(json, run);
  json["limits"] = limits_json(run.robot.model);
  json["phases"] = list_json(run.phases, [](const PagePhase& phase) {
    return Json{
        {"name", phase.name}, {"start", number_json(phase.start)}, {"end", number_json(phase.end)}};
  });
  add_solver(json, run.solver);
  add_plans(json, run.plans);
  return compact_text(json);
}

std::string page_json(const PageHead& head, const std::vector<std::string>& runs) {
  return page_text(head, "run", runs, "null");
}

std::string robot_page_json(const PageHead& head, const RobotDrawing& robot) {
  return page_text(head, "robot", {}, compact_text(robot_json(robot)));
}

std::string page_html(std::string_view page_template, std::string_view data) {
  constexpr std::string_view before = "id=\"burnish-data\">", after = "null</script>";
  const std::string place = std::string(before) + std::string(after);
  const std::size_t at = page_template.find(place);
  if (at == std::string_view::npos || page_template.find(place, at + 1) != std::string_view::npos)
    throw Error("the page template has " +
                std::string(at == std::string_view::npos ? "no place" : "several places") +
                " for its data; wanted one <script> element with the id burnish-data and the "
                "content null");
  std::string html;
  html.reserve(page_template.size() + data.size());
  html += page_template.substr(0, at + before.size());
  // Texts in the data could end the script element or begin a comment in it.
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
