#include "files/descriptions.hpp"

namespace burnish {

const Words& words_of(WarmStart::Kind /*of*/) {
  static const Words all{
      "files",
      "WarmStartKind",
      "Where the solver starts from.",
      {{"hold",
        "the initial state at every knot, with the controls that hold it in the knot's stage"},
       {"still", "the initial state at every knot, zero controls"},
       {"file", "a trajectory.csv of an earlier solve"}}};
  return all;
}

const Description& description_of(const WarmStart* /*of*/) {
  using W = WarmStart;
  static const Description all = Describe<W>("files", "WarmStart", "Where the solver starts from.")
                                     .field("kind", &W::kind)
                                     .field("file", &W::file, "File: where it is");
  return all;
}

const Description& description_of(const ProblemFile* /*of*/) {
  using P = ProblemFile;
  static const Description all = Describe<P>("files", "ProblemFile", "What a problem file says.")
                                     .field("description", &P::description)
                                     .required()
                                     .field("robot", &P::robot)
                                     .required()
                                     .field("spec", &P::spec, "compiles: it has been tried")
                                     .required()
                                     .field("solver", &P::solver)
                                     .field("guess", &P::guess);
  return all;
}

const Description& description_of(const TrajectoryGuess* /*of*/) {
  using T = TrajectoryGuess;
  static const Description all =
      Describe<T>("files", "TrajectoryGuess", "States and controls to start from.")
          .result()
          .field("xs", &T::xs, "(N + 1) x nx")
          .field("us", &T::us);
  return all;
}

}  // namespace burnish
