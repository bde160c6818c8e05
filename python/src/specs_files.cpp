#include "specs_files.hpp"

namespace burnish::python {

template <>
const EnumTable& AsEnum<WarmStart::Kind>::table() {
  static const EnumTable words("burnish.files", "WarmStartKind", {"hold", "still", "file"});
  return words;
}
template <>
const SpecTable& AsDataclass<WarmStart>::table() {
  static const SpecTable fields = SpecTable("burnish.files", "WarmStart")
                                      .field("kind", &WarmStart::kind)
                                      .field("file", &WarmStart::file);
  return fields;
}
template <>
const SpecTable& AsDataclass<ProblemFile>::table() {
  static const SpecTable fields = SpecTable("burnish.files", "ProblemFile")
                                      .field("description", &ProblemFile::description)
                                      .field("robot", &ProblemFile::robot)
                                      .field("spec", &ProblemFile::spec)
                                      .field("solver", &ProblemFile::solver)
                                      .field("guess", &ProblemFile::guess);
  return fields;
}
template <>
const SpecTable& AsDataclass<TrajectoryGuess>::table() {
  static const SpecTable fields = SpecTable("burnish.files", "TrajectoryGuess")
                                      .field("xs", &TrajectoryGuess::xs)
                                      .field("us", &TrajectoryGuess::us);
  return fields;
}

}  // namespace burnish::python
