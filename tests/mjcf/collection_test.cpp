// Compares public collections of MJCF files with MuJoCo, if BURNISH_MJCF names a folder with some.
// Prints the table of docs/robots.md.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "burnish/mjcf/mjcf.hpp"
#include "burnish/model/model.hpp"
#include "mjcf/comparison.hpp"
#include "mjcf/tied_comparison.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {
namespace {

namespace fs = std::filesystem;

constexpr int states_tried = 20;

std::vector<fs::path> models_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".xml" || !entry.is_regular_file()) continue;
    if (contents(entry.path()).find("<worldbody") != std::string::npos)
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

struct Counts {
  int read = 0, refused = 0, agreed = 0;
};

/// Returns the error against MuJoCo's reading of the file itself, or "-" where MuJoCo refuses it.
/// MuJoCo computes inertias of geoms to seven digits and rounds meshes to floats.
std::string by_file(const fs::path& file, const TreeSpec& tree) {
  try {
    char text[32];
    std::snprintf(text, sizeof text, "%.0e", compare(tree, *load(file), states_tried).worst());
    return text;
  } catch (const Error&) {
    return "-";
  }
}

/// Returns rows and error of the equalities, of MuJoCo's copy of the file; "-" without equalities.
std::string under_equalities(const fs::path& file, const TreeSpec& tree, mjModel& copy) {
  const TiedAgreement tied = compare_tied(tree, copy, states_tried);
  EXPECT_LE(tied.worst(), 1e-9) << file;
  if (tied.rows == 0) return "-";
  EXPECT_GT(tied.states, 0) << file;
  char text[80];
  std::snprintf(text, sizeof text, "%d row%s, %.0e", tied.rows, tied.rows == 1 ? "" : "s",
                tied.worst());
  return text;
}

void look_at(const fs::path& file, const fs::path& folder, Counts& counts) {
  const std::string name = fs::relative(file, folder).string();
  TreeSpec tree;
  Model model;
  try {
    tree = read_mjcf(file);
    model = build_model(tree, {});
  } catch (const Error& error) {
    ++counts.refused;
    std::printf("| %s | refused: %.200s |\n", name.c_str(), error.what());
    return;
  }
  ++counts.read;
  std::string error, tied = "-";
  try {
    const auto theirs = mujoco::compile(plain_copy(file, tree));
    load_masses(tree, *theirs);
    const Agreement agreement = compare(tree, *theirs, states_tried);
    const double worst = agreement.worst();
    EXPECT_LE(worst, 1e-10) << file;
    // The copy may lack tendons of the file.
    if (tree.tendons.empty()) {
      EXPECT_LE(agreement.passive, 1e-9) << file;
    }
    counts.agreed += worst <= 1e-10 ? 1 : 0;
    char text[32];
    std::snprintf(text, sizeof text, "%.0e", worst);
    error = text;
    tied = under_equalities(file, tree, *theirs);
  } catch (const Error& reason) {
    error = reason.what();
  }
  std::printf("| %s | %d | %d | %zu | %zu | %s | %s | %s |\n", name.c_str(), model.nq, model.nv,
              tree.loops.size(), tree.warnings.size(), error.c_str(), by_file(file, tree).c_str(),
              tied.c_str());
}

TEST(MjcfCollection, PublicFiles_AgreeWithMujoco) {
  const char* folder = std::getenv("BURNISH_MJCF");
  if (folder == nullptr || !fs::is_directory(folder))
    GTEST_SKIP() << "BURNISH_MJCF names no folder with MJCF files";
  mju_user_warning = [](const char*) {};
  Counts counts;
  std::printf(
      "| model | nq | nv | loops | warnings | error | error by the file itself | under equalities "
      "|\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const fs::path& file : models_in(folder)) look_at(file, folder, counts);
  std::printf("%d read, %d refused, %d agree with MuJoCo to 1e-10\n", counts.read, counts.refused,
              counts.agreed);
  EXPECT_GT(counts.agreed, 0);
}

}  // namespace
}  // namespace burnish::testing
