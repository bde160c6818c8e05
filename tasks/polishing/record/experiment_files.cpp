#include "polishing/record/experiment_files.hpp"

#include <fmt/format.h>

#include <cmath>

#include "burnish/tasks/polishing/task_file.hpp"
#include "record/json_text.hpp"
#include "record/run_folder.hpp"

namespace burnish::polishing {
namespace {

namespace fs = std::filesystem;

Json cell_json(const ResultCell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  const auto* value = std::get_if<double>(&cell);
  return value != nullptr && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

/// Returns the table as JSON. Rows are lists, because several columns may have the same name, such
/// as "worst".
Json table_json(const ResultTable& table) {
  Json json{{"name", table.name}, {"title", table.title}};
  json["columns"] = Json::array();
  for (const auto& column : table.columns)
    json["columns"].push_back({{"name", column.name}, {"unit", column.unit}});
  json["rows"] = Json::array();
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (const ResultCell& cell : row) cells.push_back(cell_json(cell));
    json["rows"].push_back(std::move(cells));
  }
  return json;
}

Json report_json(const ExperimentReport& report, const std::string& name,
                 const std::string& command) {
  Json json{{"experiment", name},          {"title", report.title},
            {"command", command},          {"interrupted", report.interrupted},
            {"findings", report.findings}, {"failures", report.failures}};
  json["tables"] = Json::array();
  for (const ResultTable& table : report.tables) json["tables"].push_back(table_json(table));
  return json;
}

}  // namespace

std::string experiment_text(const ExperimentReport& report, const std::string& command) {
  std::string text = fmt::format("# {}\n\n`{}`\n", report.title, command);
  if (report.interrupted) text += "\nInterrupted: not all runs were made.\n";
  if (!report.findings.empty()) text += "\n";
  for (const std::string& finding : report.findings) text += fmt::format("- {}\n", finding);
  for (const ResultTable& table : report.tables)
    if (table.for_people) text += fmt::format("\n## {}\n\n{}", table.title, markdown(table));
  if (!report.failures.empty()) text += "\n## Runs that did not polish\n\n";
  for (const std::string& failure : report.failures) text += fmt::format("- {}\n", failure);
  return text;
}

std::vector<std::string> experiment_files(const ExperimentReport& report) {
  std::vector<std::string> names{"results.md", "results.json"};
  if (!report.tables.empty()) names.emplace_back("results.csv");
  for (const Figure& figure : report.figures) names.push_back(figure.name + ".svg");
  for (const NamedTask& task : report.tasks) names.push_back(task.name + ".yaml");
  return names;
}

void write_experiment(const ExperimentReport& report, const std::string& name,
                      const std::string& command, const fs::path& folder) {
  std::string text = experiment_text(report, command);
  text.pop_back();  // removes the newline, because write_text() adds one
  write_text(folder / "results.md", text);
  write_text(folder / "results.json", json_text(report_json(report, name, command)));
  if (!report.tables.empty()) {
    std::string rows = csv(report.tables.front());
    rows.pop_back();
    write_text(folder / "results.csv", rows);
  }
  for (const Figure& figure : report.figures)
    write_svg_plot(figure.plot, folder / (figure.name + ".svg"));
  for (const NamedTask& task : report.tasks) write_task(task.task, folder / (task.name + ".yaml"));
}

}  // namespace burnish::polishing
