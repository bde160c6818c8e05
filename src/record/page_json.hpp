// The page of a run as text: its data in JSON, and the HTML that holds them.
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

/// The format of the data within a page, and of a run's run.json.
inline constexpr std::string_view page_format = "burnish-page/1";

/// Without blanks; bytes that are no UTF-8 become U+FFFD.
std::string compact_text(const Json& json);
/// {"n": count, "f32": base64 of little-endian float32}; NaN stays NaN.
Json packed_json(std::span<const float> numbers);
/// {"n": count, "u32": base64 of little-endian uint32}.
Json packed_json(std::span<const std::uint32_t> numbers);
/// [px, py, pz, qx, qy, qz, qw], w not negative.
Json pose_json(const Eigen::Isometry3d& placement);

/// A robot and a run, as the page reads them.
Json robot_json(const RobotDrawing& robot);
std::string run_page_json(const RunPage& run);

/// Meshes that the robot's description names and that are not there, by their file names.
std::vector<std::string> missing_meshes(const RobotDrawing& robot);

struct PageHead {
  std::string title;
  std::string version = {};  ///< of the program
  std::int64_t created = 0;  ///< s since 1970, UTC
};
/// The data of a page with these runs, each as run_page_json() gives it.
std::string page_json(const PageHead& head, const std::vector<std::string>& runs);
/// The data of a page with a robot alone.
std::string robot_page_json(const PageHead& head, const RobotDrawing& robot);

/// The page: its template with the data (JSON) in place, whatever texts that holds. Throws Error
/// for a template that has no place or several.
std::string page_html(std::string_view page_template, std::string_view data);

/// The run's rows as a recording: /joint_states, /force, /task, /tool_pose, /target_pose, /tf and
/// /tf_static (every link), /scene (the robot's solids and the surface), /solver, /costs; facts and
/// figures as metadata. Frames and poses have the names and fields of Foxglove's schemas. Throws
/// Error if the file cannot be written.
void write_run_mcap(const RunPage& run, const std::filesystem::path& file);

/// Such as 2026-11-21T14:00:00Z.
std::string utc_text(std::int64_t seconds);

}  // namespace burnish
