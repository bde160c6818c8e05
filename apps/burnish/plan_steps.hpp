// Warnings about the steps of a task's plans, before it runs.
#pragma once

#include <fmt/format.h>

#include "burnish/mpc/plan_check.hpp"

namespace burnish::app {

inline void print_step_complaints(const std::string& task, const MpcSpec& mpc) {
  for (const std::string& sentence : step_complaints(mpc))
    fmt::print(stderr,
               "burnish: {}: warning: {} (controller.step, controller.knots and "
               "controller.horizon make them)\n",
               task, sentence);
}

}  // namespace burnish::app
