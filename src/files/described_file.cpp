#include "files/described_file.hpp"

#include <algorithm>
#include <sstream>

#include "base/sentence.hpp"
#include "document/described.hpp"

namespace burnish::files {
namespace {

/// Returns the lines of a text as YAML comments.
std::string comment(const std::string& text, const std::string& indent) {
  std::istringstream lines(text);
  std::string result, line;
  while (std::getline(lines, line)) result += indent + "# " + line + "\n";
  return result;
}

/// Returns a key with its value and comment. The comment follows the value if the line is short
/// enough, and precedes the line otherwise.
std::string line_of(const std::string& indent, const std::string& name, const std::string& value,
                    const std::string& meaning) {
  constexpr std::size_t column = 34, width = 118;
  std::string line = indent + name + ": " + value;
  if (meaning.empty()) return line + "\n";
  const std::size_t before = std::max(line.size() + 2, column);
  if (before + 2 + meaning.size() > width) return comment(meaning, indent) + line + "\n";
  line.resize(before, ' ');
  return line + "# " + meaning + "\n";
}

}  // namespace

DescribedFile::DescribedFile(const Description& description, std::string head, std::string task,
                             bool says_task)
    : head_(std::move(head)), task_(std::move(task)), says_task_(says_task), sections_{{"", ""}} {
  const auto key = [](const Field& field, std::size_t offset) {
    return Key{field.key, field.comment(), field.unit(),
               [&field, offset](void* spec, const Reader& reader) {
                 document::read_entry(field, static_cast<char*>(spec) + offset, reader);
               },
               [&field, offset](const void* spec) {
                 return document::entry_text(field, static_cast<const char*>(spec) + offset);
               }};
  };
  auto group = description.groups.begin();
  for (std::size_t i = 0; i < description.fields.size(); ++i) {
    const Field& field = description.fields[i];
    if (group != description.groups.end() && group->begin == i) {
      if (!group->key.empty()) sections_.push_back({group->key, group->meaning});
      ++group;
    }
    if (field.type->kind == ValueType::Kind::Struct) {
      if (sections_.back().name != field.key) sections_.push_back({field.key, field.comment()});
      for (const Field& entry : field.type->description().fields)
        sections_.back().keys.push_back(key(entry, field.offset));
    } else {
      sections_.back().keys.push_back(key(field, 0));
    }
  }
}

DescribedFile::Section& DescribedFile::section_named(const std::string& name) {
  return *std::find_if(sections_.begin(), sections_.end(),
                       [&](const Section& section) { return section.name == name; });
}

DescribedFile& DescribedFile::set(const std::string& section, const std::string& name,
                                  Read reading) {
  std::vector<Key>& keys = section_named(section).keys;
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
  if (found != keys.end())
    found->reading = std::move(reading);
  else
    keys.insert(keys.begin(), {name, "", "", std::move(reading), nullptr});
  return *this;
}

DescribedFile& DescribedFile::word(const std::string& section, const std::string& name) {
  section_named(section).word = name;
  return *this;
}

DescribedFile& DescribedFile::gone(const std::string& section, const std::string& name,
                                   const std::string& instead) {
  section_named(section).gone[name] = "was removed; wanted " + instead;
  return *this;
}

DescribedFile& DescribedFile::without(const std::string& section,
                                      const std::vector<std::string>& names,
                                      const std::string& reason) {
  Section& found = section_named(section);
  for (const std::string& name : names) {
    std::erase_if(found.keys, [&](const Key& key) { return key.name == name; });
    found.gone[name] = "has no effect in this task: " + reason + "; wanted no such key";
  }
  return *this;
}

DescribedFile& DescribedFile::first(const std::string& section,
                                    const std::vector<std::string>& names) {
  std::vector<Key>& keys = section_named(section).keys;
  const auto place = [&](const Key& key) {
    return std::find(names.begin(), names.end(), key.name);
  };
  std::stable_sort(keys.begin(), keys.end(),
                   [&](const Key& a, const Key& b) { return place(a) < place(b); });
  return *this;
}

std::vector<std::string> DescribedFile::keys() const {
  std::vector<std::string> names;
  for (const Section& section : sections_)
    for (const Key& key : section.keys)
      names.push_back((section.name.empty() ? "" : section.name + ".") + key.name);
  return names;
}

std::map<std::string, std::string> DescribedFile::units() const {
  std::map<std::string, std::string> units;
  for (const Section& section : sections_)
    for (const Key& key : section.keys)
      if (!key.unit.empty())
        units[(section.name.empty() ? "" : section.name + ".") + key.name] = key.unit;
  return units;
}

void DescribedFile::check_task(const Reader& file) const {
  const auto task = file.find("task");
  if (!task && says_task_)
    file.refuse("key 'task' is missing; wanted 'task: " + task_ +
                "' (optional only in files for 'burnish polish')");
  if (task && !task->is(task_))
    task->refuse("the task is " + in_quotes(task->node().text) + "; wanted " + task_);
}

void DescribedFile::read_section(void* spec, const Section& section, const Reader& reader) {
  if (!section.word.empty() && !reader.is_map()) {
    std::find_if(section.keys.begin(), section.keys.end(), [&](const Key& key) {
      return key.name == section.word;
    })->reading(spec, reader);
    return;
  }
  for (const auto& [name, sentence] : section.gone)
    if (const auto value = reader.find(name))
      value->refuse("key " + in_quotes(name) + " " + sentence);
  std::vector<std::string> names;
  for (const Key& key : section.keys) names.push_back(key.name);
  reader.allow_only(names);
  for (const Key& key : section.keys)
    if (const auto value = reader.find(key.name)) key.reading(spec, *value);
}

void DescribedFile::read(void* spec, const Reader& file) const {
  std::vector<std::string> names{"task"};
  for (const Section& section : sections_) {
    if (!section.name.empty()) names.push_back(section.name);
    if (section.name.empty())
      for (const Key& key : section.keys) names.push_back(key.name);
  }
  file.allow_only(names);
  // Sections are read before top-level keys. A key that a function from reads() reads can also set
  // top-level entries, but a top-level key for such an entry must have priority.
  for (const Section& section : sections_)
    if (!section.name.empty())
      if (const auto value = file.find(section.name)) read_section(spec, section, *value);
  for (const Section& section : sections_)
    if (section.name.empty())
      for (const Key& key : section.keys)
        if (const auto value = file.find(key.name)) key.reading(spec, *value);
}

std::string DescribedFile::text(const void* spec) const {
  std::string text = comment(head_, "");
  if (says_task_) text += "task: " + task_ + "\n";
  for (const Section& section : sections_) {
    std::string lines, indent;
    if (!section.name.empty()) {
      lines = "\n" + comment(section.meaning, "") + section.name + ":\n";
      indent = "  ";
    }
    for (const Key& key : section.keys)
      if (const auto value = key.writing ? key.writing(spec) : std::nullopt)
        lines += line_of(indent, key.name, *value, key.meaning);
    text += lines;
  }
  return text;
}

std::optional<Reader> stated(const Reader& text, const std::string& key) {
  std::optional<Reader> value = text;
  std::istringstream names(key);
  for (std::string name; value && std::getline(names, name, '.');)
    value = value->is_map() ? value->find(name) : std::nullopt;
  return value;
}

Reader parse_override(const Override& change) {
  const std::string& word = change.word;
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == word.size())
    throw Error(in_quotes(word) + " is not an override; wanted key.path=value");
  return Reader::parse_override(
      word.substr(0, equals), word.substr(equals + 1),
      change.said_by.empty() ? "override " + in_quotes(word) : change.said_by);
}

void refuse_at(const EntryError& error, const std::vector<Reader>& texts) {
  for (auto text = texts.rbegin(); text != texts.rend(); ++text) {
    std::optional<Reader> value = *text;
    std::istringstream keys(error.entry());
    for (std::string key; value && std::getline(keys, key, '.');)
      if (value->is_map()) value = value->find(key);
    if (value) value->refuse(error.sentence());
  }
  if (texts.empty()) throw Error(error.what());
  texts.front().refuse(error.what());
}

}  // namespace burnish::files
