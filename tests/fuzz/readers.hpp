// Readers of external text: each reader takes any text and either returns or refuses it.
#pragma once

#include <string>
#include <vector>

namespace burnish::fuzz {

/// Reader with all of its checks. It opens no file that the text names.
struct Reader {
  const char* name;  ///< name of its folders in tests/fuzz/corpus and tests/fuzz/regressions
  void (*read)(const std::string& text);
};

extern const Reader urdf;     ///< robot description, compiled to a model
extern const Reader mjcf;     ///< robot description in MuJoCo's format
extern const Reader srdf;     ///< postures of a robot
extern const Reader robot;    ///< robot settings with their variants
extern const Reader problem;  ///< optimal control problem, compiled
extern const Reader task;     ///< task of any kind; writing it must reproduce it
extern const Reader request;  ///< requests of `burnish eval`
extern const Reader table;    ///< numbers in CSV

/// Calls the reader. Returns the sentence of its refusal, or an empty string. Throws
/// std::logic_error if the refusal is anything but one sentence of an Error, and if reading takes
/// more than a second of processor time.
std::string run(const Reader& reader, const std::string& text);

}  // namespace burnish::fuzz
