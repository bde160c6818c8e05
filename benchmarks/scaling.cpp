// Computing time over size: a solver iteration for horizons of 10 to 1000 knots, and dynamics with
// all derivatives for chains of 6 to 100 joints. Prints tables and growth exponents. With a folder
// as argument, draws scaling_horizon.svg and scaling_chain.svg there.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>

#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "burnish/report/svg_plot.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/solver/ddp.hpp"
#include "chain.hpp"
#include "polishing/reference_problem.hpp"

namespace burnish::bench {
namespace {

/// Returns the CPU time of this thread, which excludes other load of the machine [s].
double core_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Returns the median time of at least seven repetitions within about 0.5 s [s].
double median_time(const std::function<void()>& work) {
  work();
  std::vector<double> times;
  const double start = core_time();
  while (times.size() < 7 || core_time() - start < 0.5) {
    const double before = core_time();
    work();
    times.push_back(core_time() - before);
  }
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2),
                   times.end());
  return times[times.size() / 2];
}

/// Sizes and times, with the growth exponent between the middle and the largest size.
struct Growth {
  std::string name;
  std::vector<double> size, time;

  void add(double n, double seconds) {
    size.push_back(n);
    time.push_back(seconds);
  }
  double exponent() const {
    const std::size_t first = size.size() / 2, last = size.size() - 1;
    return std::log(time[last] / time[first]) / std::log(size[last] / size[first]);
  }
};

void print(const char* title, const char* unit, double scale, const std::vector<Growth>& lines) {
  std::printf("%s\n%8s", title, "size");
  for (const Growth& line : lines) std::printf(" %24s", line.name.c_str());
  std::printf("   [%s]\n", unit);
  for (std::size_t i = 0; i < lines.front().size.size(); ++i) {
    std::printf("%8.0f", lines.front().size[i]);
    for (const Growth& line : lines) std::printf(" %24.3f", scale * line.time[i]);
    std::printf("\n");
  }
  std::printf("%8s", "power");
  for (const Growth& line : lines) std::printf(" %24.2f", line.exponent());
  std::printf("\n\n");
}

void draw(const std::filesystem::path& file, const char* title, const char* x, const char* y,
          double scale, const std::vector<Growth>& lines) {
  Panel panel{.title = title, .x_label = x, .y_label = y};
  for (const Growth& line : lines) {
    const auto count = static_cast<Eigen::Index>(line.size.size());
    panel.curves.push_back(
        {.name = line.name,
         .x = Eigen::Map<const Eigen::VectorXd>(line.size.data(), count),
         .y = scale * Eigen::Map<const Eigen::VectorXd>(line.time.data(), count)});
  }
  write_svg_plot({.panels = {panel}}, file);
}

std::vector<Growth> horizons() {
  const Robot robot = load_robot("talos:right_arm");
  std::vector<Growth> lines{{"multiple shooting", {}, {}}, {"rollout", {}, {}}};
  for (const int knots : {10, 20, 50, 100, 200, 500, 1000}) {
    Problem problem(
        polishing::reference_problem(robot.model, "tool", robot.posture("table"), knots));
    const Eigen::Map<const Eigen::VectorXd> x0(problem.initial_state(), problem.state().nx);
    const RowMatrix xs = x0.transpose().replicate(knots + 1, 1);
    const RowMatrix us = polishing::static_control(problem).transpose().replicate(knots, 1);
    for (const StepUpdate update : {StepUpdate::MultipleShooting, StepUpdate::Rollout}) {
      DdpSolver solver(problem, {.update = update, .max_iterations = 1});
      lines[update == StepUpdate::Rollout ? 1 : 0].add(knots, median_time([&] {
                                                         solver.set_guess({xs.data(), us.data()});
                                                         solver.solve();
                                                       }));
    }
  }
  return lines;
}

std::vector<Growth> chains() {
  constexpr int states = 64;
  std::vector<Growth> lines{{"dynamics", {}, {}}, {"and all derivatives", {}, {}}};
  for (const int joints : {6, 9, 12, 18, 25, 35, 50, 70, 100}) {
    const Model model = chain(joints);
    const Eigen::MatrixXd q = chain_configurations(model, states);
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(model.nv, states);
    ContactDynamicsBatch batch(model, {chain_tip(joints)}, states);
    const auto require = [&](Status status) {
      if (status != Status::Ok)
        throw Error("chain of " + std::to_string(joints) + ": " + std::string(describe(status)));
    };
    lines[0].add(joints, median_time([&] { require(batch.forward(q, zero, zero)); }) / states);
    lines[1].add(joints, median_time([&] {
                           require(batch.forward_with_derivatives(q, zero, zero));
                         }) / states);
  }
  return lines;
}

void measure(const char* folder) {
  const std::vector<Growth> by_knots = horizons(), by_joints = chains();
  print("One iteration of the polishing problem, by knots of the horizon", "ms", 1e3, by_knots);
  print("One state of a chain with its tip in contact, in packs, by joints", "us", 1e6, by_joints);
  if (folder == nullptr) return;
  const std::filesystem::path to(folder);
  draw(to / "scaling_horizon.svg", "one iteration, Talos' right arm", "knots of the horizon",
       "time [ms]", 1e3, by_knots);
  draw(to / "scaling_chain.svg", "one state of a chain, tip in contact, in packs", "joints",
       "time [us]", 1e6, by_joints);
}

}  // namespace
}  // namespace burnish::bench

int main(int count, char** words) {
  try {
    burnish::bench::measure(count > 1 ? words[1] : nullptr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "scaling: %s\n", error.what());
    return 1;
  }
}
