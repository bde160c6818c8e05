// Robots with legs of public descriptions: whether each stands and sways as tasks/stand has it.
#pragma once

#include "polishing/experiments/batch.hpp"
#include "polishing/experiments/public_aims.hpp"

namespace burnish::polishing {

class PublicLegs {
 public:
  /// The specification outlives it.
  explicit PublicLegs(const ExperimentSpec& spec) : spec_(spec) {}
  /// Adds the runs of a robot whose description is that file.
  void add(const PublicRobot& robot, const std::filesystem::path& file,
           std::vector<BatchRun>& runs);
  /// Adds tables of what came of them, by the figures of all runs.
  void report(const std::vector<RunFigures>& figures, PublicReport& common,
              ExperimentReport& report) const;

 private:
  struct Stander {
    PublicRobot robot;
    std::vector<std::size_t> runs = {};
  };

  const ExperimentSpec& spec_;
  std::vector<Stander> standers_;
  std::vector<UntriedRobot> unread_;  ///< whose description is refused
};

}  // namespace burnish::polishing
