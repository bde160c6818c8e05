// Table of the figures of a run: unique names, values by name, and the copy in the docs.
#include "polishing/figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "polishing/experiments/run_figures.hpp"
#include "press_hold/figures.hpp"
#include "push_wall/figures.hpp"
#include "stand/figures.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

using namespace burnish::polishing;

/// Calls `see` with the full name and the entry of every row of the table.
template <class See>
void each_figure(const See& see) {
  const auto under = [&](const std::string& group) {
    return [&see, group](const FigureEntry& entry, auto&&...) { see(group + entry.name, entry); };
  };
  each_metric(under(""));
  each_solver_figure(under("solver."));
  each_standing_figure(under("standing."));
  each_run_figure(under(""));
  each_tick_figure(under("ticks."));
  each_verdict_figure(under("verdict."));
  each_rest_figure(under("rest."));
  press_hold::each_hold_figure(under("hold."));
  push_wall::each_push_figure(under("push."));
  stand::each_sway_figure(under("sway."));
}

/// Returns the table in Markdown, as it appears in the docs.
std::string table_of_figures() {
  std::string text = "| figure | unit | shown in | meaning |\n| --- | --- | --- | --- |\n";
  each_figure([&](const std::string& name, const FigureEntry& entry) {
    std::string meaning = entry.meaning;
    if (const auto at = meaning.find("{mean}"); at != std::string::npos)
      meaning.replace(at, 6, "'s moving mean");
    text += "| `" + name + "` | " + entry.unit.unit + " | " + entry.unit.shown + " | " + meaning +
            " |\n";
  });
  return text;
}

TEST(Figures, Names_AreUnique) {
  std::set<std::string> names;
  each_figure([&](const std::string& name, const FigureEntry& entry) {
    EXPECT_TRUE(names.insert(name).second) << name << " appears in the table twice";
    EXPECT_NE(std::string(entry.meaning), "") << name;
    EXPECT_NE(entry.unit.factor, 0.0) << name;
  });
  EXPECT_TRUE(names.contains("force_rmse"));
}

TEST(Figures, Names_GiveTheirValues) {
  RunFigures run;
  EXPECT_TRUE(std::isnan(run["force_rmse"]))
      << "a run that did not reach the path must not have figures";
  run.metrics = Metrics{};
  run.metrics->force_rmse = 0.25;
  run.metrics->position_rmse = 1e-3;
  run.largest_command = 0.5;
  run.ticks.p99 = 2e-4;
  EXPECT_TRUE(std::isnan(run["standing.slip"]))
      << "a run of a fixed robot must not have figures of standing";
  run.standing = StandingFigures();
  run.standing->slip = 3e-3;
  EXPECT_EQ(run["standing.slip"], 3e-3);
  EXPECT_TRUE(std::isnan(run["standing.pressure_margin"]))
      << "a run without soles must not have a pressure margin";
  EXPECT_EQ(run["force_rmse"], 0.25);
  EXPECT_EQ(run["largest_command"], 0.5);
  EXPECT_EQ(run["ticks.p99"], 2e-4);
  EXPECT_TRUE(std::isnan(run["overshoot"]) && std::isnan(run["solver.p99"]));
  EXPECT_DOUBLE_EQ(shown("position_rmse", run["position_rmse"]), 1.0);
  EXPECT_EQ(figure_column("position_rmse").unit, "mm");
  EXPECT_EQ(figure_column("without_contact", "worst").name, "worst");
  expect_words(refusal([&] { run["force_rsme"]; }),
               {"unknown figure 'force_rsme'", "did you mean 'force_rmse'?"});
}

/// With BURNISH_WRITE=1 in the environment, the test rewrites the table in the docs.
TEST(Figures, DocsTable_MatchesTheFigures) {
  const std::string file = BURNISH_DOCS_DIR "/polishing.md", begin = "<!-- figures -->\n",
                    end = "<!-- end of figures -->";
  std::ostringstream stream;
  stream << std::ifstream(file).rdbuf();
  std::string text = stream.str();
  const std::size_t from = text.find(begin), to = text.find(end);
  ASSERT_TRUE(from != std::string::npos && to != std::string::npos && from < to) << file;
  const std::size_t first = from + begin.size();
  const std::string wanted = table_of_figures();
  if (std::getenv("BURNISH_WRITE") != nullptr)
    std::ofstream(file) << text.replace(first, to - first, wanted);
  EXPECT_EQ(text.substr(first, text.find(end) - first), wanted)
      << "BURNISH_WRITE=1 tasks_test --gtest_filter='Figures*' updates the table";
}

}  // namespace
}  // namespace burnish::testing
