// Tables of public arms: figures per arm and surface, and delays per arm.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/to_size.hpp"
#include "polishing/experiments/aims.hpp"
#include "polishing/experiments/public_arms.hpp"

namespace burnish::polishing {
namespace {

constexpr const char* arm_presets[] = {"mismatch", "joint_friction"};

/// Aim (upper limit) of the rms force error under the disturbances `mismatch`.
const Aim force_aim{"force_rmse", 0.2};

/// Tolerance for the claim that MPC is not worse than the baseline. The value of MPC may exceed the
/// value of the baseline by the factor `times` or by `more`, whichever allows more.
struct Tolerance {
  const char *figure, *name;
  double times, more;  ///< `more` is in the display unit.
};
constexpr Tolerance tolerances[] = {{"force_rmse", "force", 1.1, 0.01},
                                    {"position_rmse", "path", 1.0, 0.005}};

/// Returns the median of a statistic over the runs that polished, in the display unit.
double median(const std::vector<RunFigures>& runs, const char* figure) {
  std::vector<double> values;
  for (const RunFigures& run : runs)
    if (run.succeeded) values.push_back(run[figure]);
  return shown(figure, quantile_of(values, 0.5));
}

/// Returns the largest value of a statistic over all runs, in the display unit. Runs that stopped
/// early are included, with the values until they stopped.
double worst(const std::vector<RunFigures>& runs, const char* figure) {
  return shown(figure, largest_of(collect(runs, figure)));
}

/// Runs of MPC and baseline under one preset of disturbances.
struct Pair {
  std::vector<RunFigures> mpc, baseline;

  bool all_polished() const { return polished_of(mpc) == static_cast<int>(mpc.size()); }
  /// Returns a text on how MPC is worse than the baseline; empty if MPC is not worse.
  std::string worse() const;
};

std::string Pair::worse() const {
  const int count = polished_of(mpc);
  if (count < polished_of(baseline) || count == 0)
    return "polishes " + std::to_string(count) + ", baseline " +
           std::to_string(polished_of(baseline));
  std::string text;
  for (const Tolerance& each : tolerances) {
    const double of_mpc = median(mpc, each.figure), of_baseline = median(baseline, each.figure);
    if (!(of_mpc > std::max(each.times * of_baseline, of_baseline + each.more))) continue;
    char words[64];
    std::snprintf(words, sizeof words, "%s%s +%.3f %s", text.empty() ? "" : " and ", each.name,
                  of_mpc - of_baseline, figure_named(each.figure).unit.shown);
    text += words;
  }
  return text;
}

/// Statistics of all runs of a bench (an arm at a surface), and of the runs under each preset.
struct BenchFigures {
  const ArmBench* bench;
  std::vector<RunFigures> all = {};
  Pair pairs[std::size(arm_presets)] = {};

  std::string refusal() const { return refusal_of(all); }
};

/// Returns the benches of the trials, each once, in order of appearance.
std::vector<BenchFigures> benches_of(const std::vector<ArmTrial>& trials,
                                     const std::vector<RunFigures>& figures) {
  std::vector<BenchFigures> benches;
  for (const ArmTrial& trial : trials) {
    if (benches.empty() || benches.back().bench != trial.bench) benches.push_back({trial.bench});
    BenchFigures& bench = benches.back();
    const std::vector<RunFigures> runs = chosen(figures, trial.runs);
    bench.all.insert(bench.all.end(), runs.begin(), runs.end());
    for (std::size_t i = 0; i < std::size(arm_presets); ++i) {
      if (trial.is(arm_presets[i], ControllerKind::Mpc)) bench.pairs[i].mpc = runs;
      if (trial.is(arm_presets[i], ControllerKind::Baseline)) bench.pairs[i].baseline = runs;
    }
  }
  return benches;
}

/// Returns how many of the runs polished, such as "3 of 3".
std::string polished_text(const std::vector<RunFigures>& runs) {
  return std::to_string(polished_of(runs)) + " of " + std::to_string(runs.size());
}

/// Returns where MPC is worse than the baseline, such as "joint_friction: force +0.030 N".
std::string worse_text(const BenchFigures& bench) {
  std::string text;
  for (std::size_t i = 0; i < std::size(arm_presets); ++i)
    if (const std::string worse = bench.pairs[i].worse(); !worse.empty())
      text += (text.empty() ? "" : "; ") + std::string(arm_presets[i]) + ": " + worse;
  return text;
}

std::vector<ResultCell> cells_of(const BenchFigures& bench) {
  const RunFigures& first = bench.all.front();
  std::vector<ResultCell> row{bench.bench->arm.name, bench.bench->surface,
                              measured(first, public_figures::force), rotors_text(first)};
  for (const Pair& pair : bench.pairs) {
    row.emplace_back(median(pair.mpc, "force_rmse"));
    row.emplace_back(worst(pair.mpc, "force_rmse"));
    row.emplace_back(median(pair.baseline, "force_rmse"));
    row.emplace_back(median(pair.mpc, "position_rmse"));
    row.emplace_back(median(pair.baseline, "position_rmse"));
    row.emplace_back(polished_text(pair.mpc));
    row.emplace_back(polished_text(pair.baseline));
  }
  const std::string worse = worse_text(bench);
  row.emplace_back(std::string(worse.empty() ? "yes" : "no"));
  row.emplace_back(worse.empty() ? ResultCell("-") : ResultCell(worse));
  return row;
}

/// Aims for all arms on one surface.
struct SurfaceAims {
  explicit SurfaceAims(const std::string& surface)
      : polish{.what = "all runs polish", .where = surface},
        force{.what = "force within 0.2 N under mismatch", .where = surface},
        compared{.what = "not worse than the baseline", .where = surface} {}
  PublicAim polish, force, compared;

  void count(const BenchFigures& bench) {
    const std::string& name = bench.bench->arm.name;
    const Pair& mismatch = bench.pairs[0];
    polish.count(name, std::ranges::all_of(bench.pairs, &Pair::all_polished));
    force.count(name, mismatch.all_polished() &&
                          verdict(worst(mismatch.mpc, "force_rmse"), force_aim) == "met");
    compared.count(name, worse_text(bench).empty());
  }
};

SurfaceAims& aims_on(const std::string& surface, std::vector<SurfaceAims>& all) {
  for (SurfaceAims& aims : all)
    if (aims.polish.where == surface) return aims;
  return all.emplace_back(surface);
}

}  // namespace

ResultTable arms_table(const std::vector<ArmTrial>& trials, const std::vector<RunFigures>& figures,
                       PublicReport& common) {
  ResultTable table{.name = "arms",
                    .title = "Arms: rms errors of force and path, median and worst of the seeds"};
  table.columns = {{"arm"}, {"surface"}, {"force", "N", 0}, {"rotors"}};
  for (const char* preset : arm_presets) {
    const std::vector<ResultColumn> of_preset{{std::string(preset) + ": mpc", "N"},
                                              {"worst", "N"},
                                              {"baseline", "N"},
                                              {"path, mpc", "mm"},
                                              {"baseline", "mm"},
                                              {"polished, mpc"},
                                              {"baseline"}};
    table.columns.insert(table.columns.end(), of_preset.begin(), of_preset.end());
  }
  table.columns.push_back({"not worse"});
  table.columns.push_back({"worse by"});
  std::vector<SurfaceAims> aims;
  for (const BenchFigures& bench : benches_of(trials, figures)) {
    if (!all_made(bench.all)) continue;
    aims_on(bench.bench->surface, aims).count(bench);
    if (const std::string reason = bench.refusal(); !reason.empty())
      common.add_untried({bench.bench->arm.name, bench.bench->surface, reason});
    else
      table.add(cells_of(bench));
  }
  for (SurfaceAims& each : aims)
    for (PublicAim* aim : {&each.polish, &each.force, &each.compared})
      common.add_aim(std::move(*aim));
  return table;
}

ResultTable delays_table(const std::vector<ArmTrial>& trials,
                         const std::vector<RunFigures>& figures, PublicReport& common) {
  ResultTable table{.name = "delays", .title = "Arms with delayed commands"};
  table.columns = {{"arm"}, {"surface"}, {"force", "N", 0}, {"predicted", "ms", 1}};
  std::vector<PublicAim> aims;
  std::vector<std::vector<ResultCell>> rows;
  const ArmBench* before = nullptr;
  for (const ArmTrial& trial : trials) {
    const std::vector<RunFigures> runs = chosen(figures, trial.runs);
    if (trial.delay == 0.0 || !all_made(runs)) continue;
    const RunFigures& run = runs.front();
    const std::string what = trial.name() + " delay";
    auto aim = std::ranges::find(aims, what, &PublicAim::what);
    if (aim == aims.end()) {
      aim = aims.insert(aim, {.what = what, .where = trial.bench->surface});
      table.columns.push_back({trial.name(), "N"});
      table.columns.push_back({"outcome"});
    }
    aim->count(trial.bench->arm.name, run.succeeded);
    if (run.refused) continue;
    if (trial.bench != before)
      rows.push_back({trial.bench->arm.name, trial.bench->surface,
                      measured(run, public_figures::force),
                      1e3 * measured(run, public_figures::delay)});
    before = trial.bench;
    const auto at = to_size(4 + 2 * (aim - aims.begin()));
    rows.back().resize(at);  // keeps the cells before the figures, because a stopped run has none
    rows.back().emplace_back(shown("force_rmse", run["force_rmse"]));
    rows.back().emplace_back(run.succeeded ? std::string("polished") : run.outcome);
  }
  for (std::vector<ResultCell>& row : rows) row.resize(table.columns.size());
  for (std::vector<ResultCell>& row : rows) table.add(std::move(row));
  for (PublicAim& aim : aims) common.add_aim(std::move(aim));
  return table;
}

}  // namespace burnish::polishing
