// The page of a run: one HTML file with a 3D replay, plots and figures, that any browser shows
// without a network. Here are the values that the page shows, as plain structs.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "burnish/base/trace.hpp"
#include "burnish/base/views.hpp"
#include "burnish/dynamics/surface_shape.hpp"
#include "burnish/model/model.hpp"
#include "burnish/report/metrics.hpp"
#include "burnish/report/plan_record.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish {

/// Triangles to draw, in the axes of the file that they come from, unscaled.
struct Mesh {
  std::vector<float> vertices;           ///< x, y, z of each, m
  std::vector<std::uint32_t> triangles;  ///< three vertices of each
};

/// A robot to draw.
struct RobotDrawing {
  Model model;
  Eigen::VectorXd q = {};  ///< nq, posture at the start; empty: neutral
  std::map<std::string, Eigen::VectorXd> postures = {};
  /// By the uri of MeshShape. Meshes that are not here are drawn as nothing, and named.
  std::map<std::string, Mesh> meshes = {};
};

/// Samples over the rows of a page.
struct PageColumn {
  std::string name, unit;
  Eigen::VectorXd values;
};
/// Smallest and largest of all samples since the row before, over the rows of a page.
struct PageEnvelope {
  std::string name;
  Eigen::VectorXd lower, upper;
};

struct PageMetric {
  std::string name;             ///< such as force_rmse
  std::string label;            ///< such as "force error, rms"
  std::optional<double> value;  ///< none: not available
  std::string unit;
  std::string text;  ///< what it means
};

struct PagePhase {
  std::string name;
  double start = 0.0, end = 0.0;  ///< s
};

/// A piece of a curved surface as points to draw: `side` rows of as many, m, world.
struct PagePatch {
  int side = 0;
  std::vector<float> points;  ///< x, y, z of each, row by row
};

/// The surface that is polished. Columns of axes: two tangents and the normal, towards the robot,
/// of a curved one at its point.
struct PageSurface {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d true_point = Eigen::Vector3d::Zero();  ///< as the plant has it
  Eigen::Matrix3d true_axes = Eigen::Matrix3d::Identity();
  double friction = 0.0;  ///< in the plant
  /// m, half its side about the path's origin; infinite: it has no end.
  double extent = std::numeric_limits<double>::infinity();
  std::optional<PagePatch> patch = {};  ///< of a curved one as the plant has it
  /// A curved one as the controller knows it. The tip touches at its radius along the normal there.
  std::optional<Surface> known = {};
  std::string frame = {};  ///< of the robot, that carries it; empty: the world
};

/// One entry per plan, or the fastest and slowest of a few that follow each other.
struct PageSolver {
  Eigen::VectorXd time = {};      ///< s
  Eigen::VectorXd solve_ms = {};  ///< ms
  Eigen::VectorXd iterations = {}, missed = {};
  double period_ms = 0.0;                  ///< between two plans
  std::optional<double> deadline_ms = {};  ///< none: no deadline
};

struct PageFault {
  std::string kind;  ///< such as "contact lost"
  double time = 0.0;
  std::string text;  ///< one sentence
};

/// A constraint row along a planned motion, one entry per row of the page; NaN where it is absent.
struct PageLimit {
  std::string name;
  Eigen::VectorXd margin;      ///< distance to the nearest limit over the row's scale [-]
  Eigen::VectorXd multiplier;  ///< cost per scale of the row
};

/// What a page shows of a motion that was planned and not run. Columns are those of trajectory.csv.
struct PagePlan {
  std::vector<std::string> frames = {};  ///< whose paths are drawn, with those of their targets
  std::vector<std::string> forces = {};  ///< columns of contact forces
  std::vector<PageLimit> limits = {};
};

/// All that a page shows of a run. SI units, angles in rad.
struct RunPage {
  std::string name;
  std::int64_t created = 0;                                     ///< s since 1970, UTC
  std::string version = {};                                     ///< of the program that made it
  std::vector<std::pair<std::string, std::string>> facts = {};  ///< name and value, as they appear
  std::string command = {};                                     ///< reproduces the run
  std::string outcome = {};
  bool polished = false;
  std::optional<PageFault> fault = {};
  std::vector<PageMetric> metrics = {};
  std::optional<std::pair<double, double>> window = {};  ///< s, over which metrics are taken
  std::string task_file = {};                            ///< its text
  double duration = 0.0;                                 ///< s
  RobotDrawing robot;
  std::string tool_frame = {};
  double tip_radius = 0.0;  ///< m
  PageSurface surface = {};
  Eigen::VectorXd path_u = {}, path_w = {};  ///< m, the path asked for, about path_origin
  Eigen::VectorXd path_h = {};  ///< m, of a curved surface over the tangents there; else empty
  Eigen::Vector3d path_origin_world = Eigen::Vector3d::Zero();
  Eigen::VectorXd time = {};  ///< s, of the rows
  std::vector<PageColumn> columns = {};
  std::vector<PageEnvelope> envelopes = {};
  std::vector<PagePhase> phases = {};
  std::vector<std::string> phase_names = {};  ///< of the numbers in a trace; none: the numbers
  std::optional<PageSolver> solver = {};
  std::optional<PlanRecord> plans = {};
  /// whose momenta are shown, as the plant has it; none: the robot's
  std::optional<Model> plant_model = {};
  std::vector<SupportSpec> supports = {};  ///< that it stands on, as the plant has them
  std::vector<Push> pushes = {};           ///< of which each has its frame
  std::optional<PagePlan> plan = {};       ///< of a planned motion, whose `polished` is convergence
};

/// How large a page may become.
struct PageSize {
  int most_rows = 8000;         ///< rows
  double most_megabytes = 6.0;  ///< of columns and envelopes, as text
  int most_plans = 4000;        ///< entries of PageSolver
};

/// The piece of a surface about the place of it that is nearest to `middle`, m: what stands over a
/// square in its tangent plane there, half a side long, or where that has no end, as much along the
/// surface, at most two radii of its strongest bend there.
PagePatch surface_patch(const Surface& surface, const Eigen::Vector3d& middle, double half);
/// Puts the curved surface of a plant into a page that has the path already: the piece about it,
/// and how high the path is.
void add_curved_surface(RunPage& page, const Surface& surface);

/// Every how many rows of a trace the page has one: a multiple of `record_every`, so that its times
/// are among those of a table that has every `record_every`th row, as large as the size asks for.
int page_stride(const Trace& trace, const Model& model, int record_every,
                const PageSize& size = {});

/// Fills time, columns, envelopes, phases, duration and the solver's entries from a trace of
/// ClosedLoop. Forces are taken along the surface's true axes, the path along its axes as the
/// controller knows them: of the place where the tip touches, seen from the surface, as if one that
/// the robot carries stood where it starts. Robot, surface and path_origin_world have to be there.
/// Throws Error for a column that is missing. Of a robot that stands the supports have to be there
/// too, and columns of their wrenches, of its centre of mass and of its momentum about that come
/// along; where the plant failed and left no state, they are NaN.
void add_trace(RunPage& page, const Trace& trace, int record_every, const PageSize& size = {});

/// The figures of a run with what they mean; all of them, with no value, without metrics.
std::vector<PageMetric> page_metrics(const std::optional<Metrics>& metrics);

}  // namespace burnish
