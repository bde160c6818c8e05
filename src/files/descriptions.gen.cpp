// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "files/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const WarmStart* /*of*/) {
  using S = WarmStart;
  static const Description all =
      Describe<S>("files", "WarmStart",
                  "Where the solver starts from.")
          .field("kind", &S::kind)
          .field("file", &S::file,
                 "File: where it is");
  return all;
}

const Words& words_of(WarmStart::Kind /*of*/) {
  static const Words all{
      "files",
      "WarmStartKind",
      "Where the solver starts from.",
      {{"hold", "the initial state at every knot, with the controls that hold it in the knot's stage"},
       {"still", "the initial state at every knot, zero controls"},
       {"file", "a trajectory.csv of an earlier solve"}}};
  return all;
}

const Description& description_of(const ProblemFile* /*of*/) {
  using S = ProblemFile;
  static const Description all =
      Describe<S>("files", "ProblemFile",
                  "What a problem file says.")
          .field("description", &S::description)
          .required()
          .field("robot", &S::robot)
          .required()
          .field("spec", &S::spec,
                 "compiles: it has been tried")
          .required()
          .field("solver", &S::solver)
          .field("guess", &S::guess);
  return all;
}

const Description& description_of(const TrajectoryGuess* /*of*/) {
  using S = TrajectoryGuess;
  static const Description all =
      Describe<S>("files", "TrajectoryGuess",
                  "States and controls to start from.")
          .result()
          .field("xs", &S::xs,
                 "(N + 1) x nx")
          .field("us", &S::us,
                 "N x max_controls");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
