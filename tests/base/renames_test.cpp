// Old names of keys, words and columns: each is refused with the name that replaced it.
#include "base/renames.hpp"

#include <gtest/gtest.h>

#include <string>

#include "burnish/base/error.hpp"

namespace burnish {
namespace {

TEST(Renames, OldNameBesideItsReplacement_IsRefusedWithTheNewName) {
  ASSERT_GT(renames().size(), 30u);
  for (const auto& [old_name, new_name] : renames()) {
    const std::string was(old_name), now(new_name);
    EXPECT_EQ(did_you_mean(was, {"frame", now, was + "s"}),
              "; '" + was + "' is now called '" + now + "'");
  }
}

TEST(Renames, OldNameWithSeveralMeanings_GivesTheAvailableName) {
  EXPECT_EQ(replacement("give", {"stiffness", "saturation_fraction"}), "saturation_fraction");
  EXPECT_EQ(replacement("give", {"rate", "force_tolerance"}), "force_tolerance");
}

TEST(Renames, OldNameWithoutItsReplacement_IsTreatedAsUnknown) {
  EXPECT_EQ(replacement("boost", {"bandwidth", "boots"}), "");
  EXPECT_EQ(did_you_mean("boost", {"bandwidth", "boots"}), "; did you mean 'boots'?");
}

TEST(Renames, NewNames_AreNotThemselvesOld) {
  for (const auto& [old_name, new_name] : renames())
    EXPECT_EQ(replacement(new_name, {std::string(old_name)}), "") << new_name;
}

TEST(CurrentColumn, ColumnOfAnOldRun_HasTheNewName) {
  EXPECT_EQ(current_column("limits_pushing"), "active_constraints");
  EXPECT_EQ(current_column("believed_normal_z_world"), "estimated_normal_z_world");
  EXPECT_EQ(current_column("tau_elbow"), "tau_elbow");
}

}  // namespace
}  // namespace burnish
