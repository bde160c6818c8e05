// Page of a run as text: its data in JSON, and the HTML that contains them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "record/json_text.hpp"
#include "report/run_page.hpp"

namespace burnish {

/// Name of the format of the data in a page and in run.json.
inline constexpr std::string_view page_format = "burnish-page/1";

/// Returns JSON without blanks. Bytes that are not UTF-8 become U+FFFD.
std::string compact_text(const Json& json);
/// Returns {"n": count, "f32": base64 of little-endian float32}. NaN stays NaN.
Json packed_json(std::span<const float> numbers);
/// Returns {"n": count, "u32": base64 of little-endian uint32}.
Json packed_json(std::span<const std::uint32_t> numbers);
/// Returns [px, py, pz, qx, qy, qz, qw] with qw >= 0.
Json pose_json(const Eigen::Isometry3d& placement);

/// JSON of a robot and of a run, in the format of the page.
Json robot_json(const RobotDrawing& robot);
std::string run_page_json(const RunPage& run);

/// Returns the file names of meshes in the robot's description that could not be loaded.
std::vector<std::string> missing_meshes(const RobotDrawing& robot);

struct PageHead {
  std::string title;
  std::string version = {};  ///< Version of the program
  std::int64_t created = 0;  ///< Time since 1970, UTC [s]
};
/// Returns the data of a page with these runs, each in the format of run_page_json().
std::string page_json(const PageHead& head, const std::vector<std::string>& runs);
/// Returns the data of a page with only a robot.
std::string robot_page_json(const PageHead& head, const RobotDrawing& robot);

/// Returns the page: the template with the data (JSON) inserted. The data may contain any text.
/// Throws Error unless the template has exactly one place for the data.
std::string page_html(std::string_view page_template, std::string_view data);

/// Writes the run's rows as a recording with the topics /joint_states, /force, /task, /tool_pose,
/// /target_pose, /tf and /tf_static (every link), /scene (the robot's solids and the surface),
/// /solver, /costs. Facts and figures are metadata. Frames and poses use the names and fields of
/// Foxglove's schemas. Throws Error if the file cannot be written.
void write_run_mcap(const RunPage& run, const std::filesystem::path& file);

/// Returns a time such as 2026-11-21T14:00:00Z.
std::string utc_text(std::int64_t seconds);

}  // namespace burnish
