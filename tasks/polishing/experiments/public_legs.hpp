// Experiment on public robots with legs: the task `stand` with default settings.
#pragma once

#include "polishing/experiments/batch.hpp"
#include "polishing/experiments/public_aims.hpp"

namespace burnish::polishing {

class PublicLegs {
 public:
  /// `spec` must outlive this object.
  explicit PublicLegs(const ExperimentSpec& spec) : spec_(spec) {}
  /// Adds the runs of a robot whose description is `file`.
  void add(const PublicRobot& robot, const std::filesystem::path& file,
           std::vector<BatchRun>& runs);
  /// Adds tables of the results to the report. `figures`: statistics of all runs.
  void report(const std::vector<RunFigures>& figures, PublicReport& common,
              ExperimentReport& report) const;

 private:
  struct Stander {
    PublicRobot robot;
    std::vector<std::size_t> runs = {};
  };

  const ExperimentSpec& spec_;
  std::vector<Stander> standers_;
  std::vector<UntriedRobot> unread_;  ///< Robots whose descriptions were rejected.
};

}  // namespace burnish::polishing
