// Prints the table of docs/derivative_accuracy.md: the worst relative error of every derivative
// block, by robot, reference, directions and number of moving bodies.
//   contact_law_table [STATES]
#include <cstdio>
#include <cstdlib>

#include "support/contact_laws.hpp"

int main(int argc, char** argv) {
  using namespace burnish::test;
  const int states = argc > 1 ? std::atoi(argv[1]) : law_states();
  if (states < 1) {
    std::fprintf(stderr, "contact_law_table: wanted a positive number of states\n");
    return 2;
  }
  std::printf(
      "| robot | reference | directions | bodies | states | resampled | automatic differentiation "
      "| "
      "differences |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const LawRobot& robot : law_robots())
    for (const std::string& reference : law_references())
      for (const LawRow& row : sweep(robot, reference, states))
        std::printf("| %s | %s | %s | %d | %d | %d | %.1e | %.1e |\n", robot.name.c_str(),
                    reference.c_str(), row.directions.text().c_str(), row.two_bodies ? 2 : 1,
                    row.states, row.resampled, row.autodiff, row.differences);
  return 0;
}
