// Tests of the data of a page: encoding, columns, envelopes, robots, and the HTML around them.
#include <gtest/gtest.h>

#include <map>

#include "burnish/dynamics/reference.hpp"
#include "record/page_data.hpp"
#include "record/page_json.hpp"
#include "support/refusal.hpp"
#include "support/standing_trace.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;

TEST(PageJson, NumbersAndTexts_AreReadBack) {
  const std::string awkward = "a \"quote\" \\ \n\t\x01 </script> <!-- \xC3\xA9 \xE2\x82\xAC";
  const Json read = Json::parse(compact_text(
      {{"third", 1.0 / 3.0},
       {"tiny", 5e-324},
       {"large", std::int64_t{1} << 62U},
       {"infinite", std::numeric_limits<double>::infinity()},
       {"text", awkward},
       {"broken", std::string("a\xFF\xC3") + "b\xED\xA0\x80"},
       {"list", burnish::Json::array({nullptr, numbers_json(Eigen::Vector2d(1.5, -2.0))})}}));
  EXPECT_EQ(read["third"].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(read["tiny"].get<double>(), 5e-324);
  EXPECT_EQ(read["large"].get<std::int64_t>(), std::int64_t{1} << 62U);
  EXPECT_TRUE(read["infinite"].is_null());
  EXPECT_EQ(read["text"], awkward);
  EXPECT_EQ(read["broken"],
            "a\uFFFD\uFFFD"
            "b\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(read["list"], Json::parse("[null, [1.5, -2]]"));
}

TEST(PageJson, PackedNumbers_KeepTheirBits) {
  const std::vector<float> numbers{0.1F, -0.0F, std::nanf(""), 3.4e38F};
  const Json read = packed_json(numbers);
  EXPECT_EQ(read["f32"].get<std::string>().substr(0, 6), "zczMPQ");  // 0x3DCCCCCD
  const std::vector<float> back = floats_of(read);
  ASSERT_EQ(back.size(), 4U);
  EXPECT_EQ(back[0], 0.1F);
  EXPECT_TRUE(std::signbit(back[1]));
  EXPECT_TRUE(std::isnan(back[2]));
  EXPECT_EQ(back[3], 3.4e38F);
  const std::vector<std::uint32_t> whole{1, 0x01020304};
  const Json packed = packed_json(whole);
  EXPECT_EQ(packed["n"], 2);
  EXPECT_EQ(packed["u32"], "AQAAAAQDAgE=");  // from Python's base64
  EXPECT_EQ(Json(packed_json(std::span(whole).first(1)))["u32"], "AQAAAA==");
  const std::vector<std::uint32_t> three{0xFFFBu, 0, 0xFF000000u};
  EXPECT_EQ(Json(packed_json(three))["u32"], "+/8AAAAAAAAAAAD/");
}

TEST(RunPage, ThinnedRows_KeepPeaksInEnvelopes) {
  PageSize size;
  size.max_rows = 60;  // values below 100 act like 100
  RunPage page = page_of_run(1005, 4);
  const Trace trace = page_trace(page.robot.model, 1005);
  add_trace(page, trace, 4, size);
  EXPECT_EQ(page_stride(trace, page.robot.model, 4, size) % 4, 0);
  const Json run = Json::parse(run_page_json(page));
  const std::vector<float> time = floats_of(run["series"]["time"]);
  EXPECT_LE(time.size(), 102U);
  EXPECT_GT(time.size(), 60U);
  EXPECT_FLOAT_EQ(time.back(), 1.004F);
  for (std::size_t i = 0; i + 1 < time.size(); ++i) {
    const long row = std::lround(time[i] / page_dt);
    EXPECT_EQ(row % 4, 0);
    EXPECT_EQ(time[i], static_cast<float>(trace.at(static_cast<int>(row), 0)));
  }
  const Json force = named(run["envelopes"]["columns"], "force_normal");
  const std::vector<float> lower = floats_of(force["min"]), upper = floats_of(force["max"]);
  const std::vector<float> shown =
      floats_of(named(run["series"]["columns"], "force_normal")["data"]);
  ASSERT_EQ(upper.size(), time.size());
  ASSERT_EQ(shown.size(), time.size());
  for (std::size_t i = 1; i < time.size(); ++i) {
    const bool peak = time[i - 1] < 0.105F && time[i] >= 0.105F;
    EXPECT_EQ(upper[i], peak ? 99.0F : 30.0F) << time[i];
    EXPECT_EQ(lower[i], 30.0F);
    EXPECT_EQ(shown[i], 30.0F);
  }
}

TEST(RunPage, Columns_HaveTheValuesOfTheTrace) {
  RunPage page = page_of_run();
  const Json run = Json::parse(run_page_json(page));
  const auto at_end = [&](const char* name) {
    return floats_of(named(run["series"]["columns"], name)["data"]).back();
  };
  EXPECT_FLOAT_EQ(at_end("force_normal"), 30.0F);
  EXPECT_FLOAT_EQ(at_end("force_estimated"), 31.0F);
  EXPECT_FLOAT_EQ(at_end("force_t1"), 4.0F);
  EXPECT_FLOAT_EQ(at_end("tool_y"), 0.201F);
  EXPECT_NEAR(at_end("path_u"), 0.0999F, 1e-6F);
  EXPECT_NEAR(at_end("path_w"), 1e-3F, 1e-6F);
  EXPECT_NEAR(at_end("target_w"), 0.0F, 1e-6F);
  EXPECT_NEAR(at_end("path_error"), 1e-3F, 1e-6F);
  EXPECT_FLOAT_EQ(at_end("tool_turned"), 0.5F);
  EXPECT_FLOAT_EQ(at_end("q_hinge"), 0.4995F);
  EXPECT_FLOAT_EQ(at_end("tau_hinge"), -2.0F);
  EXPECT_FLOAT_EQ(at_end("tau_command_hinge"), -2.5F);
  EXPECT_EQ(run["phases"].size(), 2U);
  EXPECT_EQ(run["phases"][1]["name"], "track");
  EXPECT_DOUBLE_EQ(run["phases"][0]["end"].get<double>(), 0.05);
  EXPECT_EQ(run["limits"]["tau"], Json::parse("[[-10, 10], [null, null]]"));
  EXPECT_EQ(run["limits"]["q"], Json::parse("[[-1, 2], [null, null]]"));
  EXPECT_EQ(run["created"], "2023-11-14T22:13:20Z");
  for (const char* name : {"fault", "costs", "horizon", "window"})
    EXPECT_TRUE(run.at(name).is_null()) << name;
  EXPECT_TRUE(named(run["metrics"], "force_rmse")["value"].is_null());
}

TEST(RunPage, ForceNormal_IsAlongTheNormalOfEachRow) {
  RunPage page = page_of_run();
  // The normal is rotated about y: it gets a component of the tangential force along x.
  constexpr double angle = 0.1;
  const Trace level = page_trace(page.robot.model, 1000);
  Trace trace(level.columns(), level.rows());
  for (int row = 0; row < level.rows(); ++row) {
    double* const values = trace.add_row();
    for (std::size_t c = 0; c < level.columns().size(); ++c)
      values[c] = level.at(row, static_cast<int>(c));
    values[trace.index("surface_normal_x_world")] = row < 500 ? 0.0 : std::sin(angle);
    values[trace.index("surface_normal_z_world")] = row < 500 ? 1.0 : std::cos(angle);
  }
  add_trace(page, trace, 10);
  for (const PageColumn& column : page.columns) {
    if (column.name == "force_normal") {
      EXPECT_NEAR(column.values[0], 30.0, 1e-12);
      EXPECT_NEAR(column.values[99], 30.0 * std::cos(angle) + 4.0 * std::sin(angle), 1e-12);
    }
    if (column.name == "normal_error") {
      EXPECT_NEAR(column.values[0], 0.0, 1e-7);
      EXPECT_NEAR(column.values[99], angle, 1e-9);
    }
  }
}

bool has_column(const RunPage& page, const std::string& name) {
  return std::any_of(page.columns.begin(), page.columns.end(),
                     [&](const PageColumn& column) { return column.name == name; });
}

TEST(RunPage, NormalsOffTheAxes_AreColumns) {
  RunPage page = page_of_run();
  for (const char* name : {"surface_normal_x", "estimated_normal_z"})
    EXPECT_FALSE(has_column(page, name)) << name;
  page.surface.axes = Reference::surface_with_normal({0.1, 0.0, 1.0}).rotation;
  add_trace(page, page_trace(page.robot.model, 1000), 10);
  EXPECT_FALSE(has_column(page, "surface_normal_x"));
  ASSERT_TRUE(has_column(page, "estimated_normal_x"));
  const Json run = Json::parse(run_page_json(page));
  EXPECT_EQ(floats_of(named(run["series"]["columns"], "estimated_normal_z")["data"])[5], 1.0F);
}

TEST(RunPage, CurvedSurface_IsAGridOfItsPoints) {
  const Eigen::Vector3d point(0.3, 0.2, -0.02), up(0.1, -0.2, 1.0);
  for (const char* text :
       {"sphere:0.3", "sphere:0.06:hollow", "cylinder:0.2", "cylinder:0.05", "cone:0.2:0.3",
        "torus:0.1:0.5", "ellipsoid:0.4:0.3:0.3", "saddle:1:-2"}) {
    SCOPED_TRACE(text);
    const Surface surface(SurfaceShape::parse(text), point, up);
    RunPage page = page_of_run();
    page.surface.axes = Reference::surface_with_normal(up).rotation;
    add_curved_surface(page, surface);
    const Json run = Json::parse(run_page_json(page));
    const int side = run["surface"]["patch"]["side"];
    const std::vector<float> points = floats_of(run["surface"]["patch"]["points"]);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(3 * side * side));
    double max_distance = 0.0, max_edge = 0.0;
    const auto at = [&](int i, int k) -> Eigen::Vector3d {
      return Eigen::Vector3f(points.data() + 3 * (i * side + k)).cast<double>();
    };
    for (int i = 0; i < side; ++i)
      for (int k = 0; k < side; ++k) {
        EXPECT_NEAR(surface.at(at(i, k)).distance, 0.0, 1e-6) << i << " " << k;
        if (k > 0) max_edge = std::max(max_edge, (at(i, k) - at(i, k - 1)).norm());
        max_distance = std::max(max_distance, (at(i, k) - at(side / 2, side / 2)).norm());
      }
    EXPECT_LT(max_edge, 0.08) << "neighbouring points must be close";
    EXPECT_GT(max_distance, 0.05);
    // The path lies on the surface.
    const std::vector<float> heights = floats_of(run["path"]["h"]);
    ASSERT_EQ(heights.size(), 5U);
    const Eigen::Matrix3d& axes = page.surface.axes;
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const Eigen::Vector3d p = page.path_origin_world - page.tip_radius * axes.col(2) +
                                page.path_u[static_cast<Eigen::Index>(i)] * axes.col(0) +
                                static_cast<double>(heights[i]) * axes.col(2);
      if (std::string(text) == "cylinder:0.05" || std::string(text) == "sphere:0.06:hollow")
        continue;  // the path is wider than these surfaces
      EXPECT_NEAR(surface.at(p).distance, 0.0, 1e-6);
    }
  }
  EXPECT_TRUE(Json::parse(run_page_json(page_of_run()))["surface"]["patch"].is_null());
}

/// Returns a copy of a trace with further columns; `change` sets vectors of each row.
template <class Change>
Trace changed_trace(const Trace& trace, const std::vector<std::string>& more,
                    const Change& change) {
  std::vector<TraceColumn> columns = trace.columns();
  for (const std::string& name : more) columns.push_back({name, "m"});
  Trace changed(columns, trace.rows());
  for (int row = 0; row < trace.rows(); ++row) {
    double* const values = changed.add_row();
    for (std::size_t c = 0; c < trace.columns().size(); ++c)
      values[c] = trace.at(row, static_cast<int>(c));
    const auto set = [&](const std::string& name, const Eigen::Vector3d& v) {
      Eigen::Map<Eigen::Vector3d>(values + changed.index(name)) = v;
    };
    change(row, set);
  }
  return changed;
}

/// Returns the largest distance of a page's rows from a 50 mm circle about the path's origin [m].
double max_off_circle(const RunPage& page, const char* u, const char* w) {
  const Json run = Json::parse(run_page_json(page));
  const std::vector<float> along = floats_of(named(run["series"]["columns"], u)["data"]);
  const std::vector<float> across = floats_of(named(run["series"]["columns"], w)["data"]);
  double max_distance = 0.0;
  for (std::size_t i = 0; i < along.size(); ++i)
    max_distance = std::max(max_distance, std::abs(std::hypot(along[i], across[i]) - 0.05));
  return max_distance;
}

TEST(RunPage, CurvedSurface_TipOverItsPath_IsDrawnOnThePath) {
  for (const char* text :
       {"plane", "sphere:0.3", "sphere:0.2:hollow", "cylinder:0.2", "cylinder:0.2:hollow",
        "cone:0.2:0.3", "torus:0.1:0.5", "ellipsoid:0.4:0.3:0.3", "saddle:1:-2", "ridge"}) {
    SCOPED_TRACE(text);
    RunPage page = page_of_run();
    const Eigen::Vector3d up = Eigen::Vector3d(0.1, -0.2, 1.0).normalized();
    page.surface.axes = Reference::surface_with_normal(up).rotation;
    const Eigen::Vector3d point = page.path_origin_world - page.tip_radius * up;
    const Surface surface(SurfaceShape::parse(text), point, up);
    if (!surface.shape().is_flat()) page.surface.nominal = surface;
    const Trace trace =
        changed_trace(page_trace(page.robot.model, 500), {}, [&](int row, const auto& set) {
          const Eigen::Vector2d circle(0.05 * std::cos(0.02 * row), 0.05 * std::sin(0.02 * row));
          const Eigen::Vector3d on =
              surface.along_normal(point + page.surface.axes.leftCols<2>() * circle);
          const Eigen::Vector3d center = on + page.tip_radius * surface.at(on).normal;
          set("tool_x_world", center);
          set("target_x_world", center);
        });
    add_trace(page, trace, 1);
    EXPECT_LT(max_off_circle(page, "path_u", "path_w"), 1e-7);
    EXPECT_LT(max_off_circle(page, "target_u", "target_w"), 1e-7);
  }
}

TEST(RunPage, CarriedSurface_TipOverItsPath_IsDrawnOnThePath) {
  RunPage page = page_of_run();
  const Eigen::Vector3d origin = page.path_origin_world;
  const Trace trace = changed_trace(
      page_trace(page.robot.model, 500),
      {"surface_x_world", "surface_y_world", "surface_z_world", "surface_rx_world",
       "surface_ry_world", "surface_rz_world", "push_x_world", "push_y_world", "push_z_world"},
      [&](int row, const auto& set) {
        const Eigen::Vector3d turned(0.0, 0.3, 0.2 + 1e-3 * row);
        const Eigen::Vector3d place(0.1, 1e-3 * row, 0.2);
        const auto rotation = [](const Eigen::Vector3d& v) {
          return Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix();
        };
        const Eigen::Vector3d at_start =
            origin + Eigen::Vector3d(0.05 * std::cos(0.02 * row), 0.05 * std::sin(0.02 * row), 0.0);
        const Eigen::Vector3d local = rotation(Eigen::Vector3d(0.0, 0.3, 0.2)).transpose() *
                                      (at_start - Eigen::Vector3d(0.1, 0.0, 0.2));
        set("surface_x_world", place);
        set("surface_rx_world", turned);
        set("tool_x_world", place + rotation(turned) * local);
        set("target_x_world", place + rotation(turned) * local);
      });
  add_trace(page, trace, 1);
  EXPECT_LT(max_off_circle(page, "path_u", "path_w"), 1e-7);
  EXPECT_LT(max_off_circle(page, "target_u", "target_w"), 1e-7);
}

TEST(RunPage, FurtherTool_HasItsForceAndTarget) {
  RunPage page = page_of_run();
  const Trace plain = page_trace(page.robot.model, 100);
  std::vector<TraceColumn> columns = plain.columns();
  for (const char* what : {"force", "surface_normal"})
    for (const char* axis : {"x", "y", "z"})
      columns.push_back({std::string("tool_left_") + what + "_" + axis + "_world", "N"});
  columns.push_back({"tool_left_target_force", "N"});
  Trace trace(columns, 100);
  for (int row = 0; row < 100; ++row) {
    double* const values = trace.add_row();
    for (std::size_t c = 0; c < plain.columns().size(); ++c)
      values[c] = plain.at(row, static_cast<int>(c));
    values[trace.index("tool_left_force_y_world")] = -12.0;
    values[trace.index("tool_left_surface_normal_y_world")] = -1.0;
    values[trace.index("tool_left_target_force")] = 10.0;
  }
  add_trace(page, trace, 1);
  std::map<std::string, double> first;
  for (const PageColumn& column : page.columns) first[column.name] = column.values[0];
  EXPECT_EQ(first.at("signal_force_left"), 12.0);
  EXPECT_EQ(first.at("signal_target_force_left"), 10.0);
}

TEST(RunPage, SignalsOfTheController_AreTheSevenLargestOfEachUnit) {
  RunPage page = page_of_run();
  const Trace plain = page_trace(page.robot.model, 100);
  std::vector<TraceColumn> columns = plain.columns();
  for (int i = 0; i < 9; ++i) columns.push_back({"signal_" + std::to_string(i), "Nm"});
  columns.push_back({"signal_ratio", "-"});
  Trace trace(columns, 100);
  for (int row = 0; row < 100; ++row) {
    double* const values = trace.add_row();
    for (std::size_t c = 0; c < plain.columns().size(); ++c)
      values[c] = plain.at(row, static_cast<int>(c));
    for (int i = 0; i < 9; ++i) values[trace.index("signal_" + std::to_string(i))] = -i * row;
    values[trace.index("signal_ratio")] = row == 3 ? std::nan("") : 0.5;
  }
  add_trace(page, trace, 1);
  std::vector<std::string> names;
  for (const PageColumn& column : page.columns)
    if (column.name.starts_with("signal_")) names.push_back(column.name);
  EXPECT_EQ(names, (std::vector<std::string>{"signal_ratio", "signal_8", "signal_7", "signal_6",
                                             "signal_5", "signal_4", "signal_3", "signal_2"}));
}

/// Adds the trace of a standing robot to a page, with the tool's columns of page_trace().
void fill_that_stands(RunPage& page, const StandingTrace& standing,
                      const StandingTrace::Change& change) {
  const Trace feet = standing.trace(change), tool = page_trace(page_model(), feet.rows());
  std::vector<TraceColumn> columns = feet.columns();
  for (const TraceColumn& column : tool.columns())
    if (!feet.has(column.name)) columns.push_back(column);
  for (int k = 0; k < standing.model.nv; ++k)
    for (const char* what : {"tau_applied_", "tau_command_"})
      columns.push_back({what + standing.model.v_name(k), "Nm"});
  Trace trace(columns, feet.rows());
  for (int row = 0; row < feet.rows(); ++row) {
    double* const values = trace.add_row();
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const Trace& source = feet.has(columns[c].name) ? feet : tool;
      if (source.has(columns[c].name)) values[c] = source.at(row, source.index(columns[c].name));
    }
  }
  page.robot.model = standing.model;
  page.supports = standing.supports;
  add_trace(page, trace, 1);
}
RunPage page_that_stands(const StandingTrace& standing, const StandingTrace::Change& change) {
  RunPage page = page_of_run();
  fill_that_stands(page, standing, change);
  return page;
}

TEST(RunPage, StandingRobot_HasColumnsOfFeetAndMomentum) {
  const StandingTrace standing;
  RunPage page = page_that_stands(standing, [](int row, const StandingTrace::Set& set) {
    set("support_left_fx", 40.0);
    set("support_left_my", -2.0);
    if (row == 3) set("support_right_fz", 10.0);
    if (row == 4) set("v_root_joint.vx", 0.5);
    if (row == 4) set("v_root_joint.wz", 0.25);
  });
  page.pushes = {{.start = 1.0, .duration = 0.2, .force_world = {0.0, 9.0, 0.0}, .frame = "body"}};
  const Json run = Json::parse(run_page_json(page));
  ASSERT_EQ(run["supports"].size(), 2U);
  EXPECT_EQ(run["supports"][0],
            Json::parse(R"({"frame": "left", "half_x": 0.1, "half_y": 0.05, "radius": 0.02,
                            "point": [0, 0, 0], "normal": [0, 0, 1], "friction": 0.8})"));
  EXPECT_EQ(run["pushes"], Json::parse(R"([{"frame": "body", "start": 1, "duration": 0.2,
                                           "force": [0, 9, 0]}])"));
  const auto value = [&](const std::string& name, std::size_t row) {
    return floats_of(named(run["series"]["columns"], name)["data"]).at(row);
  };
  EXPECT_FLOAT_EQ(value("support_left_fx", 2), 40.0F);
  EXPECT_FLOAT_EQ(value("support_left_load", 2), 100.0F);
  EXPECT_FLOAT_EQ(value("support_left_friction_used", 2), 0.5F);
  EXPECT_NEAR(value("support_left_pressure_margin", 2), 0.05, 1e-7);  // half_y, the nearer edge
  EXPECT_FLOAT_EQ(value("support_right_load", 3), 10.0);
  EXPECT_TRUE(std::isnan(value("support_right_friction_used", 3)));
  EXPECT_TRUE(std::isnan(value("support_right_pressure_margin", 3)));
  EXPECT_FLOAT_EQ(value("com_z", 2), 0.5F);
  EXPECT_FLOAT_EQ(value("momentum_x", 4), 10.0);
  EXPECT_FLOAT_EQ(value("angular_momentum_z", 4), 0.25F);
  EXPECT_FLOAT_EQ(value("momentum_x", 2), 0.0F);
  EXPECT_EQ(named(run["series"]["columns"], "angular_momentum_z")["unit"], "kg m^2/s");
}

TEST(RunPage, Momentum_UsesThePlantModel) {
  const StandingTrace standing;
  const auto moves = [](int, const StandingTrace::Set& set) { set("v_root_joint.vx", 0.5); };
  Disturbances heavier;
  heavier.mass_scale = 2.0;
  for (const bool nominal : {true, false}) {
    RunPage page = page_of_run();
    if (!nominal) page.plant_model = plant_model(standing.model, heavier);
    fill_that_stands(page, standing, moves);
    for (const PageColumn& column : page.columns)
      if (column.name == "momentum_x") {
        EXPECT_DOUBLE_EQ(column.values[2], nominal ? 10.0 : 20.0);
      }
    EXPECT_TRUE(has_column(page, "momentum_x"));
  }
}

TEST(RunPage, RowsAfterAPlantFailure_AreNan) {
  const StandingTrace standing;
  const RunPage page = page_that_stands(standing, [](int row, const StandingTrace::Set& set) {
    if (row >= 4) set("q_root_joint.x", std::nan(""));
  });
  for (const PageColumn& column : page.columns)
    if (column.name == "com_x" || column.name == "support_left_load") {
      EXPECT_FALSE(std::isnan(column.values[3])) << column.name;
      EXPECT_TRUE(std::isnan(column.values[4])) << column.name;
    }
}

TEST(RunPage, FixedRobot_HasNoFeet) {
  const Json run = Json::parse(run_page_json(page_of_run()));
  EXPECT_FALSE(run.contains("supports"));
  EXPECT_FALSE(run.contains("pushes"));
  EXPECT_FALSE(has_column(page_of_run(), "com_x"));
}

TEST(RunPage, MissingMeasurement_IsNan) {
  RunPage page = page_of_run(100, 1);
  const Json run = Json::parse(run_page_json(page));
  const std::vector<float> measured =
      floats_of(named(run["series"]["columns"], "force_measured")["data"]);
  EXPECT_TRUE(std::isnan(measured[7]));
  EXPECT_EQ(measured[8], 29.0F);
}

TEST(RunPage, ThinnedPlans_KeepTheSlowest) {
  PageSize size;
  size.max_plans = 100;
  RunPage page = page_of_run(1000, 10);
  add_trace(page, page_trace(page.robot.model, 1000), 10, size);
  ASSERT_TRUE(page.solver);
  EXPECT_LE(page.solver->time.size(), 102);
  EXPECT_DOUBLE_EQ(page.solver->solve_ms.maxCoeff(), 7.0);
  EXPECT_DOUBLE_EQ(page.solver->missed.sum(), 1.0);
  Eigen::Index slowest = 0;
  page.solver->solve_ms.maxCoeff(&slowest);
  EXPECT_DOUBLE_EQ(page.solver->time[slowest], 0.205);
  EXPECT_DOUBLE_EQ(page.solver->missed[slowest], 1.0);
}

TEST(RunPage, OneMinuteAtTwoKilohertz_StaysBelowTenMegabytes) {
  Trace trace = page_trace(page_model(), 120'000);  // at 2 kHz
  RunPage page = page_of_run();
  add_trace(page, trace, 1);
  EXPECT_LE(page.time.size(), 8001);
  EXPECT_GT(page.time.size(), 6000);
  EXPECT_LT(run_page_json(page).size(), 10'000'000U);
}

TEST(RunPage, TraceWithoutToolColumns_IsRefused) {
  RunPage page = page_of_run();
  const Trace poor({{"time", "s"}, {"phase", "-"}}, 1);
  EXPECT_THROW(add_trace(page, poor, 1), Error);
}

TEST(RobotJson, MimicJoint_HasLeaderMultiplierAndOffset) {
  TreeSpec tree = page_tree();
  tree.joints[1].mimic = MimicSpec{"hinge", -2.0, 0.5};
  const Json json = robot_json(RobotDrawing{.model = build_model(tree)});
  EXPECT_EQ(json["moving"], Json::parse(R"(["hinge"])"));
  EXPECT_EQ(json["nq"], 1);
  EXPECT_TRUE(json["bodies"][0]["joint"]["follows"].is_null());
  const Json& spin = json["bodies"][1]["joint"];
  EXPECT_EQ(spin["follows"], Json::parse(R"({"leader": 0, "multiplier": -2, "offset": 0.5})"));
  EXPECT_EQ(spin["nq"], 0);
}

TEST(RobotJson, Robot_HasBodiesJointsPosturesAndMeshes) {
  RobotDrawing robot{.model = page_model()};
  robot.postures["bent"] = Eigen::Vector3d(1.0, 0.0, 1.0);
  const Json json = robot_json(robot);
  EXPECT_EQ(json["name"], "two");
  EXPECT_EQ(json["moving"], Json::parse(R"(["hinge", "spin"])"));
  EXPECT_EQ(json["nq"], 3);
  EXPECT_EQ(json["q"], Json::parse("[0, 1, 0]"));  // neutral
  const Json& wheel = json["bodies"][1];
  EXPECT_EQ(wheel["parent"], 0);
  EXPECT_EQ(wheel["joint"]["kind"], "continuous");
  EXPECT_EQ(wheel["joint"]["q_index"], 1);
  EXPECT_TRUE(wheel["joint"]["lower"].is_null());
  EXPECT_EQ(json["bodies"][0]["joint"]["upper"], 2);
  EXPECT_EQ(wheel["mass"], 2);
  const Model model = page_model();
  EXPECT_DOUBLE_EQ(wheel["inertia"][1].get<double>(), model.joints[1].inertia_at_com(1, 1));
  EXPECT_DOUBLE_EQ(wheel["placement"][0].get<double>(),
                   model.joints[1].placement.translation().x());
  EXPECT_EQ(json["visuals"][0]["shape"],
            Json::parse(R"({"kind": "box", "size": [0.1, 0.2, 0.3]})"));
  EXPECT_EQ(json["postures"][0], Json::parse(R"({"name": "bent", "q": [1, 0, 1]})"));
  EXPECT_EQ(named(json["frames"], "wheel")["kind"], "link");
  // A missing mesh is named; a loaded one is scaled.
  EXPECT_EQ(json["visuals"][1]["shape"], Json::parse(R"({"kind": "mesh", "name": "wheel.stl"})"));
  EXPECT_EQ(missing_meshes(robot), std::vector<std::string>{"wheel.stl"});
  robot.meshes["package://parts/meshes/wheel.stl"] = {{1, 1, 1, 0, 0, 0, 2, 0, 0}, {0, 1, 2}};
  const Json shape = Json(robot_json(robot))["visuals"][1]["shape"];
  EXPECT_EQ(floats_of(shape["vertices"])[0], 2.0F);
  EXPECT_EQ(floats_of(shape["vertices"])[1], 1.0F);
  EXPECT_EQ(decoded(shape["triangles"]["u32"]).size(), 12U);
  EXPECT_TRUE(missing_meshes(robot).empty());
}

TEST(PageHtml, ScriptEndInTheData_DoesNotEndTheScript) {
  const std::string html_template =
      "<html><script type=\"application/json\" id=\"burnish-data\">null</script></html>\n";
  RunPage run = page_of_run(200, 10);
  run.task_file = "note: </script><script>alert(1)</script><!-- & \"quotes\"\n";
  const std::string text = run_page_json(run);
  // Another program may write '<' unescaped.
  const std::string plain = Json::parse(text).dump();
  EXPECT_NE(plain.find("</script>"), std::string::npos);
  for (const std::string& data : {text, plain}) {
    const std::string html = page_html(html_template, page_json({.title = "a <b>"}, {data}));
    const std::string before = "id=\"burnish-data\">";
    const std::size_t begin = html.find(before) + before.size(), end = html.find("</script>");
    EXPECT_EQ(html.substr(end), "</script></html>\n");
    const Json page = Json::parse(html.substr(begin, end - begin));
    EXPECT_EQ(page["format"], "burnish-page/1");
    EXPECT_EQ(page["kind"], "run");
    EXPECT_EQ(page["title"], "a <b>");
    EXPECT_EQ(page["runs"][0]["task_file"], run.task_file);
  }
}

TEST(PageHtml, TemplateWithoutOnePlace_IsRefused) {
  const std::string place = "<script id=\"burnish-data\">null</script>";
  EXPECT_NO_THROW(page_html(place, "{}"));
  expect_words(refusal([] { (void)page_html("<html>", "{}"); }), {"no place"});
  expect_words(refusal([&] { (void)page_html(place + place, "{}"); }), {"several places"});
}

TEST(PageHtml, RobotAlone_HasNoRuns) {
  const Json page =
      Json::parse(robot_page_json({.title = "two"}, RobotDrawing{.model = page_model()}));
  EXPECT_EQ(page["kind"], "robot");
  EXPECT_EQ(page["runs"].size(), 0U);
  EXPECT_EQ(page["robot"]["name"], "two");
}

TEST(UtcText, UnixTimes_AreCivilDates) {
  EXPECT_EQ(utc_text(0), "1970-01-01T00:00:00Z");
  EXPECT_EQ(utc_text(951'782'399), "2000-02-28T23:59:59Z");
  EXPECT_EQ(utc_text(951'868'799), "2000-02-29T23:59:59Z");
  EXPECT_EQ(utc_text(1'795'269'600), "2026-11-21T14:00:00Z");
}

}  // namespace
}  // namespace burnish::testing
