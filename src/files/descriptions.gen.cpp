// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "files/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const WarmStart* /*of*/) {
  using S = WarmStart;
  static const Description all =
      Describe<S>("files", "WarmStart",
                  "Trajectory that the solver starts from (warm start).")
          .field("kind", &S::kind)
          .field("file", &S::file,
                 "Path of the trajectory file, if `kind` is file");
  return all;
}

const Words& words_of(WarmStart::Kind /*of*/) {
  static const Words all{
      "files",
      "WarmStartKind",
      "Kind of warm start.",
      {{"hold", "Initial state at every knot; the controls hold the robot at rest in the contacts of each"
        " knot"},
       {"still", "Initial state at every knot, with zero controls"},
       {"file", "Trajectory from a file trajectory.csv of an earlier solve"}}};
  return all;
}

const Description& description_of(const ProblemFile* /*of*/) {
  using S = ProblemFile;
  static const Description all =
      Describe<S>("files", "ProblemFile",
                  "Content of a problem file.")
          .field("description", &S::description)
          .required()
          .field("robot", &S::robot)
          .required()
          .field("spec", &S::spec,
                 "Specification of the problem; read_problem_file() has checked that a Problem "
                 "can be built")
          .required()
          .field("solver", &S::solver)
          .field("guess", &S::guess);
  return all;
}

const Description& description_of(const TrajectoryGuess* /*of*/) {
  using S = TrajectoryGuess;
  static const Description all =
      Describe<S>("files", "TrajectoryGuess",
                  "Trajectory of states and controls that the solver starts from.")
          .result()
          .field("xs", &S::xs,
                 "States, (N + 1) x nx for N knots")
          .field("us", &S::us,
                 "Controls, N x max_controls for N knots");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
