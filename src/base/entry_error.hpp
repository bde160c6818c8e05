// A refusal that knows which entry of a specification it is about.
#pragma once

#include <string>

#include "burnish/base/error.hpp"

namespace burnish {

/// Whoever has read the specification from a file says where the entry stands: see files::placed().
class EntryError : public Error {
 public:
  /// `entry`: its keys in files, "tool.frame". what() is "tool.frame: sentence".
  EntryError(std::string entry, const std::string& sentence)
      : Error(entry + ": " + sentence), entry_(std::move(entry)), sentence_(sentence) {}
  const std::string& entry() const { return entry_; }
  const std::string& sentence() const { return sentence_; }

 private:
  std::string entry_, sentence_;
};

/// Calls `work`; an Error of one sentence is one about the entry.
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
