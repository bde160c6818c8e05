// A file that says one described specification: read over its defaults, changed by overrides,
// written with every key explained.
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

/// What stands in such a file beyond the description: groups of entries and values that the
/// specification holds are sections. Entries that share a section may be of several values.
class DescribedFile {
 public:
  using Read = std::function<void(void* spec, const Reader& value)>;

  /// `head`: the comment that files begin with. `task`: what their key `task` says, which is
  /// written and has to be there if `says_task`.
  DescribedFile(const Description& description, std::string head, std::string task,
                bool says_task = true);
  /// A key that is read like this: an entry's, in place of its own reading, or one that sets
  /// several entries at once and is not written; the others of its section, "" for none, count
  /// behind.
  template <class Spec>
  DescribedFile& reads(const std::string& section, const std::string& name,
                       void (*reading)(Spec& spec, const Reader& value)) {
    return set(section, name, [reading](void* spec, const Reader& value) {
      reading(*static_cast<Spec*>(spec), value);
    });
  }
  /// One word in place of the section's keys is the value of this one.
  DescribedFile& word(const std::string& section, const std::string& name);
  /// A key that there was: refused with what is in its place.
  DescribedFile& gone(const std::string& section, const std::string& name,
                      const std::string& instead);
  /// Keys of the description that do nothing in this file, neither read nor written: one that is
  /// stated is refused with the reason, such as "the robot stands on no feet".
  DescribedFile& without(const std::string& section, const std::vector<std::string>& names,
                         const std::string& reason);
  /// Called with the specification and the texts that changed it, a file or all overrides of a
  /// command, once all of them are read.
  template <class Spec>
  DescribedFile& settles(std::function<void(Spec& spec, const std::vector<Reader>& texts)> settle) {
    settle_ = [settle = std::move(settle)](void* spec, const std::vector<Reader>& texts) {
      settle(*static_cast<Spec*>(spec), texts);
    };
    return *this;
  }
  /// These keys of the section go before its others.
  DescribedFile& first(const std::string& section, const std::vector<std::string>& names);

  /// "surface.normal", in the order of files.
  std::vector<std::string> keys() const;
  /// Of the keys that have one: {"surface.stiffness", "N/m"}.
  std::map<std::string, std::string> units() const;
  /// Refuses a file of another task.
  void check_task(const Reader& file) const;
  /// Reads what the file, or a change of it, states, over the specification. Throws Error with the
  /// place.
  void read(void* spec, const Reader& file) const;
  /// What settles() asks for, behind read() of all these texts.
  void settle(void* spec, const std::vector<Reader>& texts) const {
    if (settle_) settle_(spec, texts);
  }
  /// The whole specification as such a file.
  std::string text(const void* spec) const;

 private:
  struct Key {
    std::string name, meaning, unit;
    Read reading;
    std::function<std::optional<std::string>(const void*)> writing;  ///< empty: it is not written
  };
  struct Section {
    std::string name, meaning, word = {};
    std::vector<Key> keys = {};
    std::map<std::string, std::string> gone = {};  ///< what is refused, and the end of the sentence
  };
  DescribedFile& set(const std::string& section, const std::string& name, Read reading);
  Section& section_named(const std::string& name);
  static void read_section(void* spec, const Section& section, const Reader& reader);

  std::string head_, task_;
  bool says_task_;
  std::vector<Section> sections_;
  std::function<void(void*, const std::vector<Reader>&)> settle_ = {};
};

/// "key.path=value", and what refusals of it name: the option that stands for it, such as "--robot
/// arm.urdf"; empty: "override 'key.path=value'".
struct Override {
  std::string word, said_by = {};
};

/// Overrides that --set says.
inline std::vector<Override> as_overrides(const std::vector<std::string>& words) {
  std::vector<Override> changes;
  for (const std::string& word : words) changes.push_back({word});
  return changes;
}

/// The override as a text that says it. Throws Error where the word is none.
Reader parse_override(const Override& change);

/// The value of "section.key" where the text states it.
std::optional<Reader> stated(const Reader& text, const std::string& key);

/// A specification and the texts that said it, the one that counts last.
template <class Spec>
struct Said {
  Spec spec = {};
  std::vector<Reader> texts = {};
};

/// Throws Error with the sentence, and where the entry is said in front; otherwise with the first
/// text's name in front.
[[noreturn]] void refuse_at(const EntryError& error, const std::vector<Reader>& texts);

/// Calls `work`: what it refuses about an entry is refused where a text says that entry.
template <class Work>
decltype(auto) placed(const std::vector<Reader>& texts, const Work& work) {
  try {
    return work();
  } catch (const EntryError& error) {
    refuse_at(error, texts);
  }
}

/// Reads overrides over a specification, whose form `const DescribedFile& file_of(const Spec*)`
/// says.
template <class Spec>
void change(Said<Spec>& said, const std::vector<Override>& overrides) {
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
void change(Said<Spec>& said, const std::vector<std::string>& overrides) {
  change(said, as_overrides(overrides));
}
/// Reads a text and then overrides. Throws Error naming file (or override), line, key and what was
/// wanted.
template <class Spec, class Overrides = std::vector<std::string>>
Said<Spec> parse_said(const std::string& text, const std::string& name,
                      const Overrides& overrides = {}) {
  Said<Spec> said{.texts = {Reader::parse(text, name)}};
  const DescribedFile& form = file_of(static_cast<const Spec*>(nullptr));
  form.check_task(said.texts.front());
  form.read(&said.spec, said.texts.front());
  form.settle(&said.spec, said.texts);
  change(said, overrides);
  return said;
}
/// The same of a file.
template <class Spec, class Overrides = std::vector<std::string>>
Said<Spec> read_said(const std::filesystem::path& file, const Overrides& overrides = {}) {
  return parse_said<Spec>(read_text(file, "YAML file"), file.string(), overrides);
}

}  // namespace burnish::files
