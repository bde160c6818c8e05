// What reads text that others wrote: each reader takes any text, and either returns or refuses it.
#pragma once

#include <string>
#include <vector>

namespace burnish::fuzz {

/// A reader with everything that it checks. It opens no file that the text names.
struct Reader {
  const char* name;  ///< of its folders in tests/fuzz/corpus and tests/fuzz/regressions
  void (*read)(const std::string& text);
};

extern const Reader urdf;     ///< a robot's description, compiled to a model
extern const Reader mjcf;     ///< the same in MuJoCo's format
extern const Reader srdf;     ///< postures of a robot
extern const Reader robot;    ///< a robot's settings, with its variants
extern const Reader problem;  ///< an optimal control problem, compiled
extern const Reader task;     ///< a task of either kind, which must be written as it was read
extern const Reader request;  ///< of `burnish eval`
extern const Reader table;    ///< numbers in CSV

/// Calls the reader, and returns the sentence of its refusal, or an empty one. Throws
/// std::logic_error where the text is refused by anything but one sentence of an Error, and where
/// that or reading it takes more than a second of processor time.
std::string run(const Reader& reader, const std::string& text);

}  // namespace burnish::fuzz
