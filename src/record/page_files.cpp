#include "record/page_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "burnish/base/error.hpp"
#include "record/page/page_template.hpp"
#include "record/page_json.hpp"
#include "record/run_folder.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr const char* no_page =
    "this program was built without the web page of runs, because Node or its packages were "
    "missing";
/// Maximum size of the runs in comparison.html, chosen by hand [bytes]. Larger pages open slowly.
constexpr std::size_t largest_comparison = 100'000'000;

std::int64_t now() {
  using namespace std::chrono;
  return duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
}

void check_page() {
  if (page_template().empty()) throw Error(no_page);
}

}  // namespace

std::vector<std::string> PageWriter::write(const fs::path& folder,
                                           const std::function<RunPage()>& make) {
  std::vector<std::string> written;
  std::error_code ignored;  // Errors in removing files of an earlier run
  for (const char* name : {"run.json", "run.html", "run.mcap"}) fs::remove(folder / name, ignored);
  if ((!pages_ && !recordings_) || !make) return written;
  RunPage page = make();
  page.created = now();
  page.version = BURNISH_VERSION;
  for (std::string& mesh : burnish::missing_meshes(page.robot))
    missing_meshes_.insert(std::move(mesh));
  if (pages_) {
    std::string run = run_page_json(page);
    const std::string data =
        page_json({.title = page.name, .version = page.version, .created = page.created}, {run});
    write_text(folder / "run.json", data);
    written.emplace_back("run.json");
    if (makes_pages()) {
      write_text(folder / "run.html", page_html(page_template(), data));
      written.emplace_back("run.html");
    }
    names_.push_back(page.name);
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

std::string PageWriter::missing_meshes() const {
  if (missing_meshes_.empty()) return "";
  return fmt::format(
      "the page shows the robot without {} of its meshes, which were not found or could not be "
      "read: {}; docs/run_page.md lists the search folders",
      missing_meshes_.size(), joined_names({missing_meshes_.begin(), missing_meshes_.end()}));
}

bool PageWriter::makes_pages() const { return pages_ && !page_template().empty(); }

std::string PageWriter::finish(const fs::path& folder) const {
  std::error_code ignored;
  const fs::path file = folder / "comparison.html";
  fs::remove(file, ignored);
  if (!pages_ || runs_.empty()) return "";
  if (page_template().empty()) return std::string("no run.html: ") + no_page;
  if (runs_.size() < 2) return "";
  if (size_ > largest_comparison)
    return "no comparison.html: the runs take more than 100 MB, too much for one page; `burnish "
           "report` makes a page of selected runs";
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
  constexpr std::size_t max_names = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(max_names, names.size()); ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > max_names) text += fmt::format(" and {} more", names.size() - max_names);
  return text;
}

}  // namespace burnish
