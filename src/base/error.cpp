#include "burnish/base/error.hpp"

#include <algorithm>
#include <numeric>

#include "base/renames.hpp"

namespace burnish {
namespace {

/// Returns the number of bytes of the UTF-8 character at `at`, or 0 for invalid UTF-8.
std::size_t character_size(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x80) return 1;
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || at + size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
  }
  // Overlong encodings, surrogate halves, and codes beyond the last code point are invalid.
  const unsigned char second = byte(at + 1);
  const bool valid = !(first == 0xE0 && second < 0xA0) && !(first == 0xED && second > 0x9F) &&
                     !(first == 0xF0 && second < 0x90) && !(first == 0xF4 && second > 0x8F);
  return valid ? size : 0;
}

std::string one_line(std::string_view text) {
  constexpr std::size_t max_length = 4000;
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    if (result.size() > max_length) return result + "...";
    const std::size_t size = character_size(text, at);
    if (size == 0) {
      result += '?';
    } else if (static_cast<unsigned char>(text[at]) < 0x20 || text[at] == 0x7F) {
      result += ' ';
    } else {
      result += text.substr(at, size);
    }
    at += std::max<std::size_t>(size, 1);
  }
  return result;
}

/// Maximum number of problems in a message, chosen by hand.
constexpr std::size_t max_problems = 50;

/// Returns the sentences for Error::sentences(): one per problem, each beginning with `origin`.
std::vector<std::string> sentences_of(const std::string& origin,
                                      const std::vector<std::string>& problems) {
  const std::string start = origin.empty() ? "" : origin + ": ";
  std::vector<std::string> sentences;
  for (const std::string& problem : problems) {
    if (sentences.size() == max_problems) {
      sentences.push_back(
          one_line(start + "and " + std::to_string(problems.size() - max_problems) + " more"));
      break;
    }
    sentences.push_back(one_line(start + problem));
  }
  return sentences;
}

/// Joins problems into one message and numbers them: "<origin>: 2 problems: (1) ... (2) ...".
std::string numbered(const std::string& origin, const std::vector<std::string>& problems) {
  std::string text = origin.empty() ? "" : one_line(origin) + ": ";
  if (problems.size() == 1) return text + one_line(problems.front());
  text += std::to_string(problems.size()) + " problems:";
  for (std::size_t i = 0; i < std::min(problems.size(), max_problems); ++i) {
    text += " (" + std::to_string(i + 1) + ") " + one_line(problems[i]);
  }
  if (problems.size() > max_problems) {
    text += " and " + std::to_string(problems.size() - max_problems) + " more";
  }
  return text;
}

/// Number of edits between two texts: insertions, deletions, replacements and swaps of neighbours
/// (optimal string alignment distance).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] =
          std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

Error::Error(const std::string& sentence)
    : Error(std::vector{one_line(sentence)}, one_line(sentence)) {}

Error::Error(const std::string& origin, const std::vector<std::string>& problems)
    : Error(sentences_of(origin, problems), numbered(origin, problems)) {}

Error::Error(std::vector<std::string> sentences, const std::string& joined)
    : std::runtime_error(joined),
      sentences_(std::make_shared<const std::vector<std::string>>(std::move(sentences))) {}

std::string nearest_name(std::string_view name, const std::vector<std::string>& known) {
  // The time to compute an edit distance grows with the product of the two lengths. A file may
  // contain a text of any length in place of a name.
  constexpr std::size_t max_length = 200;
  if (name.size() > max_length) return "";
  std::string best;
  // Accepts at most one edit plus one for every three letters. With more edits, the name is another
  // word.
  std::size_t best_distance = 1 + name.size() / 3 + 1;
  for (const std::string& candidate : known) {
    const std::size_t longer = std::max(name.size(), candidate.size());
    if (longer - std::min(name.size(), candidate.size()) >= best_distance) continue;
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& known) {
  if (const std::string_view now = replacement(name, known); !now.empty())
    return "; '" + std::string(name) + "' is now called '" + std::string(now) + "'";
  const std::string best = nearest_name(name, known);
  return best.empty() ? "" : "; did you mean '" + best + "'?";
}

}  // namespace burnish
