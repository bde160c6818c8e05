#include <nlohmann/json.hpp>

#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "document/builder.hpp"
#include "document/reader.hpp"
#include "document/text.hpp"

namespace burnish::document {
namespace {

using nlohmann::json;

/// Iterator over the text that reports the position of the parser.
class ProgressIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  ProgressIterator(const char* at, const char** seen) : at_(at), seen_(seen) {}
  const char& operator*() const { return *at_; }
  ProgressIterator& operator++() {
    *seen_ = ++at_;
    return *this;
  }
  bool operator==(const ProgressIterator& other) const { return at_ == other.at_; }
  bool operator!=(const ProgressIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  const char** seen_;
};

/// Receiver of the parser's events. The parser does not report the place of a token. Each place is
/// found by reading on from the end of the previous token.
class JsonEvents {
 public:
  JsonEvents(const std::string& text, const std::string& name)
      : name_(name),
        tree_(name, 8'000'000),
        at_(text.data()),
        line_begin_(at_),
        end_(at_ + text.size()),
        seen_(at_) {
    if (text.starts_with("\xEF\xBB\xBF")) line_begin_ = at_ += 3;
  }

  bool null() { return add(Kind::Null, word()); }
  bool boolean(bool /*value*/) { return add(Kind::Bool, word()); }
  bool number_integer(json::number_integer_t /*value*/) { return add(Kind::Number, word()); }
  bool number_unsigned(json::number_unsigned_t /*value*/) { return add(Kind::Number, word()); }
  bool number_float(json::number_float_t /*value*/, const std::string& /*text*/) {
    return add(Kind::Number, word());
  }
  bool string(std::string& value) {
    const Place place = next();
    at_ = seen_;
    tree_.add({.kind = Kind::Text, .place = place, .text = std::move(value)});
    return true;
  }
  bool key(std::string& value) { return string(value); }
  static bool binary(json::binary_t& /*value*/) { return false; }
  bool start_object(std::size_t /*size*/) { return begin(Kind::Map); }
  bool start_array(std::size_t /*size*/) { return begin(Kind::List); }
  bool end_object() { return end(); }
  bool end_array() { return end(); }
  bool parse_error(std::size_t /*at*/, const std::string& token, const json::exception& error) {
    if (dynamic_cast<const json::out_of_range*>(&error) != nullptr)
      tree_.refuse(next(), in_quotes(token) + " is too large; wanted a magnitude below 1.8e308");
    // Removes the library's error code before "parse error at line 1, column 2: ...".
    const std::string sentence = error.what();
    const std::size_t bracket = sentence.find("] ");
    refuse(name_, bracket == std::string::npos ? sentence : sentence.substr(bracket + 2));
  }

  ProgressIterator begin() { return {seen_, &seen_}; }
  ProgressIterator end_of_text() { return {end_, &seen_}; }
  Node take() { return tree_.take(); }

 private:
  /// Advances to the next token and returns its place.
  Place next() {
    for (; at_ != end_; ++at_) {
      if (*at_ == '\n') {
        ++line_;
        line_begin_ = at_ + 1;
      } else if (*at_ != ' ' && *at_ != ',' && *at_ != ':' && *at_ != '\t' && *at_ != '\r') {
        break;
      }
    }
    return {line_, static_cast<std::uint32_t>(at_ - line_begin_ + 1)};
  }
  Node word() {
    const Place place = next();
    const char* const begin = at_;
    const auto goes_on = [](char c) {
      return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '.' || c == '-' || c == '+' ||
             c == 'E';
    };
    while (at_ != end_ && goes_on(*at_)) ++at_;
    return {.place = place, .text = std::string(begin, at_)};
  }
  bool add(Kind kind, Node&& node) {
    node.kind = kind;
    if (kind == Kind::Null) node.text.clear();
    tree_.add(std::move(node));
    return true;
  }
  bool begin(Kind kind) {
    tree_.begin(kind, next());
    ++at_;
    return true;
  }
  bool end() {
    next();
    ++at_;
    tree_.end();
    return true;
  }

  const std::string& name_;
  Builder tree_;
  const char* at_;          ///< End of the last token
  const char* line_begin_;  ///< Begin of the current line
  const char* end_;         ///< End of the text
  const char* seen_;        ///< Position of the parser
  std::uint32_t line_ = 1;
};

}  // namespace

Node parse_json(const std::string& text, const std::string& name) {
  constexpr int megabytes = 32;  // a text of this size with only short lists takes 1 GB of memory
  check_size(text, name, megabytes);
  JsonEvents events(text, name);
  json::sax_parse(events.begin(), events.end_of_text(), &events);
  return events.take();
}

Reader Reader::parse_json(const std::string& text, const std::string& name) {
  return {document::parse_json(text, name), name};
}

}  // namespace burnish::document
