// Files of one described specification. Reading starts from the defaults, overrides change single
// keys, and writing explains every key in a comment.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/description.hpp"
#include "base/entry_error.hpp"
#include "base/text_file.hpp"
#include "files/reader.hpp"

namespace burnish::files {

/// Form of the files of a specification: its sections and keys, and how they are read and written.
/// Each group of entries of the description is a section, and so is each member that is itself a
/// described specification. Several members may share a section.
class DescribedFile {
 public:
  using Read = std::function<void(void* spec, const Reader& value)>;

  /// `head` is the comment at the start of a written file. `task` is the value of the key `task`.
  /// If `says_task` is true, files are written with this key, and files without it are rejected.
  DescribedFile(const Description& description, std::string head, std::string task,
                bool says_task = true);
  /// Reads a key of a section with the function `reading`. If an entry of the description has this
  /// key, `reading` replaces the usual reading of the entry. Any other key is new: it can set
  /// several entries at once, is read before the other keys of its section, and is not written.
  /// Section "" is the top level of the file.
  template <class Spec>
  DescribedFile& reads(const std::string& section, const std::string& name,
                       void (*reading)(Spec& spec, const Reader& value)) {
    return set(section, name, [reading](void* spec, const Reader& value) {
      reading(*static_cast<Spec*>(spec), value);
    });
  }
  /// Accepts a single word in place of the section's map. The word is the value of the key `name`.
  DescribedFile& word(const std::string& section, const std::string& name);
  /// Refuses a key that was removed. The message names its replacement.
  DescribedFile& gone(const std::string& section, const std::string& name,
                      const std::string& instead);
  /// Excludes keys of the description that have no effect in this file. Written files omit the
  /// keys. A file that states such a key is refused with `reason`: "the robot stands on no feet".
  DescribedFile& without(const std::string& section, const std::vector<std::string>& names,
                         const std::string& reason);
  /// Calls `settle` after reading, with the specification and the texts that changed it: a file, or
  /// all overrides of a command.
  template <class Spec>
  DescribedFile& settles(std::function<void(Spec& spec, const std::vector<Reader>& texts)> settle) {
    settle_ = [settle = std::move(settle)](void* spec, const std::vector<Reader>& texts) {
      settle(*static_cast<Spec*>(spec), texts);
    };
    return *this;
  }
  /// Moves these keys of a section before its other keys.
  DescribedFile& first(const std::string& section, const std::vector<std::string>& names);

  /// Returns all keys, such as "surface.normal", in the order of the file.
  std::vector<std::string> keys() const;
  /// Returns the units of the keys with a unit: {"surface.stiffness", "N/m"}.
  std::map<std::string, std::string> units() const;
  /// Refuses files of another task.
  void check_task(const Reader& file) const;
  /// Sets those entries of the specification that the file or override states. Throws Error with
  /// the place in the text.
  void read(void* spec, const Reader& file) const;
  /// Calls the function from settles(). read() must have read all `texts` before.
  void settle(void* spec, const std::vector<Reader>& texts) const {
    if (settle_) settle_(spec, texts);
  }
  /// Returns the specification as the text of a file.
  std::string text(const void* spec) const;

 private:
  struct Key {
    std::string name, meaning, unit;
    Read reading;
    std::function<std::optional<std::string>(const void*)> writing;  ///< Empty if not written
  };
  struct Section {
    std::string name, meaning, word = {};
    std::vector<Key> keys = {};
    std::map<std::string, std::string> gone = {};  ///< Removed keys, with their messages
  };
  DescribedFile& set(const std::string& section, const std::string& name, Read reading);
  Section& section_named(const std::string& name);
  static void read_section(void* spec, const Section& section, const Reader& reader);

  std::string head_, task_;
  bool says_task_;
  std::vector<Section> sections_;
  std::function<void(void*, const std::vector<Reader>&)> settle_ = {};
};

/// Override of a key: the word "key.path=value". Messages name the override by `said_by`, such as
/// "--robot arm.urdf". If `said_by` is empty, the name is "override 'key.path=value'".
struct Override {
  std::string word, said_by = {};
};

/// Converts words "key.path=value", such as arguments of the option --set, to overrides.
inline std::vector<Override> as_overrides(const std::vector<std::string>& words) {
  std::vector<Override> changes;
  for (const std::string& word : words) changes.push_back({word});
  return changes;
}

/// Parses an override. Throws Error if the word is not of the form key.path=value.
Reader parse_override(const Override& change);

/// Returns the value of "section.key" if the text states it.
std::optional<Reader> stated(const Reader& text, const std::string& key);

/// A specification and the texts from which it was read. Later texts override earlier ones.
template <class Spec>
struct SpecTexts {
  Spec spec = {};
  std::vector<Reader> texts = {};
};

/// Throws Error with the message of `error`, preceded by the place of the entry in the last text
/// that states it. If no text states it, the message is preceded by the name of the first text.
[[noreturn]] void refuse_at(const EntryError& error, const std::vector<Reader>& texts);

/// Calls `work`. If it throws an EntryError, throws Error with the place of the entry in the texts.
template <class Work>
decltype(auto) placed(const std::vector<Reader>& texts, const Work& work) {
  try {
    return work();
  } catch (const EntryError& error) {
    refuse_at(error, texts);
  }
}

/// Applies overrides to a specification. `const DescribedFile& file_of(const Spec*)` must return
/// the form of the files of this specification.
template <class Spec>
void change(SpecTexts<Spec>& said, const std::vector<Override>& overrides) {
  const DescribedFile& form = file_of(static_cast<const Spec*>(nullptr));
  std::vector<Reader> changes;
  for (const Override& stated : overrides) {
    changes.push_back(parse_override(stated));
    said.texts.push_back(changes.back());
    form.read(&said.spec, changes.back());
  }
  form.settle(&said.spec, changes);
}
template <class Spec>
void change(SpecTexts<Spec>& said, const std::vector<std::string>& overrides) {
  change(said, as_overrides(overrides));
}
/// Reads a text, then applies overrides. Throws Error with the file (or override), line, key and
/// requirement.
template <class Spec, class Overrides = std::vector<std::string>>
SpecTexts<Spec> parse_said(const std::string& text, const std::string& name,
                           const Overrides& overrides = {}) {
  SpecTexts<Spec> said{.texts = {Reader::parse(text, name)}};
  const DescribedFile& form = file_of(static_cast<const Spec*>(nullptr));
  form.check_task(said.texts.front());
  form.read(&said.spec, said.texts.front());
  form.settle(&said.spec, said.texts);
  change(said, overrides);
  return said;
}
/// Reads a file, then applies overrides.
template <class Spec, class Overrides = std::vector<std::string>>
SpecTexts<Spec> read_said(const std::filesystem::path& file, const Overrides& overrides = {}) {
  return parse_said<Spec>(read_text(file, "YAML file"), file.string(), overrides);
}

}  // namespace burnish::files
