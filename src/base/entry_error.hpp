// Error about one entry of a specification.
#pragma once

#include <string>

#include "burnish/base/error.hpp"

namespace burnish {

/// Error about one entry of a specification. files::placed() adds the file and line of the entry.
class EntryError : public Error {
 public:
  /// `entry` is the path of keys in files, such as "tool.frame". what() then returns
  /// "tool.frame: sentence".
  EntryError(std::string entry, const std::string& sentence)
      : Error(entry + ": " + sentence), entry_(std::move(entry)), sentence_(sentence) {}
  const std::string& entry() const { return entry_; }
  const std::string& sentence() const { return sentence_; }

 private:
  std::string entry_, sentence_;
};

/// Calls `work`. If `work` throws an Error with one sentence, rethrows it as an EntryError about
/// `entry`.
template <class Work>
decltype(auto) about(const std::string& entry, const Work& work) {
  try {
    return work();
  } catch (const EntryError&) {
    throw;
  } catch (const Error& error) {
    if (error.sentences().size() > 1) throw;
    throw EntryError(entry, error.what());
  }
}

}  // namespace burnish
