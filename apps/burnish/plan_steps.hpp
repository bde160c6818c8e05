// Warnings about the time steps of a task's plans, printed before the task runs.
#pragma once

#include <fmt/format.h>

#include "burnish/mpc/plan_check.hpp"

namespace burnish::app {

inline void print_step_complaints(const std::string& task, const MpcSpec& mpc) {
  for (const std::string& sentence : step_complaints(mpc))
    fmt::print(stderr,
               "burnish: {}: warning: {} (controller.step, controller.knots and controller.horizon "
               "determine the steps)\n",
               task, sentence);
}

}  // namespace burnish::app
