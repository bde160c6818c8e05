// Sentences with which calls are refused.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "burnish/base/error.hpp"

namespace burnish::testing {

/// Returns the sentence of the Error that `call` throws, or "" if it throws none.
template <class Call>
std::string refusal(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Expects every word in the sentence, and the sentence on one line.
inline void expect_words(const std::string& sentence, const std::vector<std::string>& words) {
  EXPECT_NE(sentence, "") << "the call must be refused";
  EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  for (const std::string& word : words) {
    EXPECT_NE(sentence.find(word), std::string::npos) << "'" << word << "' is not in: " << sentence;
  }
}

}  // namespace burnish::testing
