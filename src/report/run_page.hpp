// Content of the page of a run, as plain structs. The page is one HTML file with a 3D replay, plots
// and figures, which browsers show without a network.
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

/// Triangle mesh to draw, unscaled and in the axes of its file.
struct Mesh {
  std::vector<float> vertices;           ///< x, y, z of each vertex [m]
  std::vector<std::uint32_t> triangles;  ///< Indices of the three vertices of each triangle
};

/// Robot to draw.
struct RobotDrawing {
  Model model;
  Eigen::VectorXd q = {};  ///< Initial posture, nq; empty: neutral
  std::map<std::string, Eigen::VectorXd> postures = {};
  /// Meshes by the uri of MeshShape. The page lists missing meshes and does not draw them.
  std::map<std::string, Mesh> meshes = {};
};

/// Samples of a signal at the rows of a page.
struct PageColumn {
  std::string name, unit;
  Eigen::VectorXd values;
};
/// Minimum and maximum of a signal since the previous row, at the rows of a page.
struct PageEnvelope {
  std::string name;
  Eigen::VectorXd lower, upper;
};

/// Figure of a run.
struct PageMetric {
  std::string name;             ///< Name, such as force_rmse
  std::string label;            ///< Label, such as "force error, rms"
  std::optional<double> value;  ///< Value; none: not available
  std::string unit;
  std::string text;  ///< Meaning in words
};

/// Phase of a run.
struct PagePhase {
  std::string name;
  double start = 0.0, end = 0.0;  ///< Times of the start and the end [s]
};

/// Part of a curved surface to draw: a grid of side x side points, in world axes.
struct PagePatch {
  int side = 0;
  std::vector<float> points;  ///< x, y, z of each point, row by row [m]
};

/// Surface of the workpiece. The columns of `axes` are two tangents and the normal towards the
/// robot. On a curved surface, these are the axes at `point`.
struct PageSurface {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d true_point = Eigen::Vector3d::Zero();     ///< Surface point in the plant
  Eigen::Matrix3d true_axes = Eigen::Matrix3d::Identity();  ///< Surface axes in the plant
  double friction = 0.0;  ///< Coefficient of friction in the plant
  /// Half the side length of the square surface around the path's origin; infinite: no edges [m]
  double extent = std::numeric_limits<double>::infinity();
  std::optional<PagePatch> patch = {};  ///< Part of a curved surface in the plant
  /// Curved surface of the controller's model. The contact point is at the tip's radius from the
  /// tip's centre, along the normal.
  std::optional<Surface> nominal = {};
  std::string frame = {};  ///< Frame of the robot that carries the surface; empty: the world
};

/// Solver statistics: one entry per plan, or the fastest and the slowest plan of each group of
/// consecutive plans.
struct PageSolver {
  Eigen::VectorXd time = {};      ///< Times of the plans [s]
  Eigen::VectorXd solve_ms = {};  ///< Durations of the computations of plans [ms]
  Eigen::VectorXd iterations = {}, missed = {};
  double period_ms = 0.0;                  ///< Time between two plans [ms]
  std::optional<double> deadline_ms = {};  ///< Deadline; none: no deadline [ms]
};

/// Fault that ended a run.
struct PageFault {
  std::string kind;  ///< Kind, such as "contact lost"
  double time = 0.0;
  std::string text;  ///< Description in one sentence
};

/// Scalar constraint along a planned motion, with an entry per row of the page. NaN: no constraint.
struct PageLimit {
  std::string name;
  Eigen::VectorXd margin;      ///< Distance to the nearest limit, divided by the scale [-]
  Eigen::VectorXd multiplier;  ///< Multiplier: cost per scale of the constraint
};

/// Content of the page of a planned motion that was not run. Columns are those of trajectory.csv.
struct PagePlan {
  std::vector<std::string> frames = {};  ///< Frames whose paths and target paths are drawn
  std::vector<std::string> forces = {};  ///< Columns of contact forces
  std::vector<PageLimit> limits = {};
};

/// Content of the page of a run. SI units, angles in rad.
struct RunPage {
  std::string name;
  std::int64_t created = 0;                                     ///< Time since 1970, UTC [s]
  std::string version = {};                                     ///< Version of the program
  std::vector<std::pair<std::string, std::string>> facts = {};  ///< Names and values to show
  std::string command = {};                                     ///< Command that repeats the run
  std::string outcome = {};
  /// Whether the run met all requirements of its task; for a planned motion: the solver converged
  bool succeeded = false;
  std::optional<PageFault> fault = {};
  std::vector<PageMetric> metrics = {};
  std::optional<std::pair<double, double>> window = {};  ///< Time window of the metrics [s]
  std::string task_file = {};                            ///< Text of the task file
  double duration = 0.0;                                 ///< Duration of the run [s]
  RobotDrawing robot;
  std::string tool_frame = {};  ///< Frame of the tool; empty: the robot has no tool
  double tip_radius = 0.0;      ///< Radius of the tip [m]
  PageSurface surface = {};
  /// Commanded path along the two tangents, from its origin [m]
  Eigen::VectorXd path_u = {}, path_w = {};
  Eigen::VectorXd path_h = {};  ///< Height of a curved surface along the path; else empty [m]
  Eigen::Vector3d path_origin_world = Eigen::Vector3d::Zero();
  Eigen::VectorXd time = {};  ///< Times of the rows [s]
  std::vector<PageColumn> columns = {};
  std::vector<PageEnvelope> envelopes = {};
  std::vector<PagePhase> phases = {};
  /// Names of the phase numbers in a trace. Phases without a name are shown as numbers.
  std::vector<std::string> phase_names = {};
  std::optional<PageSolver> solver = {};
  std::optional<PlanRecord> plans = {};
  /// Model of the robot in the plant, for its momenta; none: `robot`
  std::optional<Model> plant_model = {};
  std::vector<TouchSpec> supports = {};  ///< Supports of a standing robot in the plant
  std::vector<Push> pushes = {};         ///< Pushes; each names its frame
  std::optional<PagePlan> plan = {};     ///< Set for a planned motion that was not run
};

/// Maximum size of a page.
struct PageSize {
  int max_rows = 8000;         ///< Number of rows
  double max_megabytes = 6.0;  ///< Size of columns and envelopes as text [MB]
  int max_plans = 4000;        ///< Number of entries of PageSolver
};

/// Returns the part of a surface around the surface point nearest to `middle` [m]. The part is a
/// square in the tangent plane, with sides of 2 `half`, projected onto the surface. If the square
/// cannot be projected, the part is measured along the surface, up to at most two radii of
/// curvature from that point.
PagePatch surface_patch(const Surface& surface, const Eigen::Vector3d& middle, double half);
/// Adds the curved surface of a plant to a page with a path: the part around the path, and the
/// heights of the path.
void add_curved_surface(RunPage& page, const Surface& surface);

/// Returns n such that the page has every nth row of a trace and does not exceed `size`. n is a
/// multiple of `record_every`, so that every row of the page is also in a table of every
/// `record_every`th row.
int page_stride(const Trace& trace, const Model& model, int record_every,
                const PageSize& size = {});

/// Fills time, columns, envelopes, phases, duration and solver of a page from a trace of
/// ClosedLoop. Robot, tool_frame, surface and path_origin_world must be set before; for a standing
/// robot, also supports.
///  - Forces on the tool are along the true axes of the surface.
///  - The path is that of the contact point, along the surface axes of the controller's model.
///    It is relative to the surface if the robot carries the surface.
///  - For a standing robot, adds columns of the supports' wrenches, the centre of mass and the
///    centroidal momentum. They are NaN in rows without a valid state of the plant.
/// Throws Error if a column is missing.
void add_trace(RunPage& page, const Trace& trace, int record_every, const PageSize& size = {});

/// Returns the figures of a run with their meanings. Without metrics, they have no values.
std::vector<PageMetric> page_metrics(const std::optional<Metrics>& metrics);

}  // namespace burnish
