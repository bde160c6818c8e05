// Prints the tables of docs/derivative_accuracy.md: the worst relative error of every derivative
// block, by robot, directions, number of moving bodies and reference.
//   contact_law_table [STATES]
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "support/contact_laws.hpp"

namespace {

using namespace burnish::test;

void print_robot(const LawRobot& robot, int states) {
  std::vector<std::vector<LawRow>> by_reference;
  for (const std::string& reference : law_references())
    by_reference.push_back(sweep(robot, reference, states));
  std::printf("\n## %s\n\nTool `%s`; with two bodies, base `%s`.\n\n", robot.name.c_str(),
              robot.tool.c_str(), robot.base.c_str());
  std::printf("| directions | bodies |");
  for (const std::string& reference : law_references()) std::printf(" %s |", reference.c_str());
  std::printf(" differences | states | resampled |\n| --- | --- |");
  for (std::size_t i = 0; i < law_references().size() + 3; ++i) std::printf(" --- |");
  std::printf("\n");
  for (std::size_t row = 0; row < by_reference[0].size(); ++row) {
    const LawRow& first = by_reference[0][row];
    std::printf("| %s | %d |", first.directions.text().c_str(), first.two_bodies ? 2 : 1);
    double differences = 0.0;
    int evaluated = 0, resampled = 0;
    for (const auto& rows : by_reference) {
      std::printf(" %.1e |", rows[row].autodiff);
      differences = std::max(differences, rows[row].differences);
      evaluated += rows[row].states;
      resampled += rows[row].resampled;
    }
    std::printf(" %.1e | %d | %d |\n", differences, evaluated, resampled);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int states = argc > 1 ? std::atoi(argv[1]) : law_states();
  if (states < 1) {
    std::fprintf(stderr, "contact_law_table: wanted a positive number of states\n");
    return 2;
  }
  for (const LawRobot& robot : law_robots()) print_robot(robot, states);
  return 0;
}
