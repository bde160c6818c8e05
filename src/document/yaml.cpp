#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <map>
#include <sstream>

#include "base/parse_number.hpp"
#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "document/builder.hpp"
#include "document/text.hpp"

namespace burnish::document {
namespace {

Place place_of(const YAML::Mark& mark) {
  return {static_cast<std::uint32_t>(mark.line + 1), static_cast<std::uint32_t>(mark.column + 1)};
}

class YamlEvents final : public YAML::EventHandler {
 public:
  explicit YamlEvents(const std::string& name) : tree_(name, 1'000'000) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ > 0)
      tree_.refuse(place_of(mark), "a second document begins here; wanted one document in a file");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    scalar({.place = place_of(mark)}, anchor);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    const bool quoted = tag == "!" || tag == "tag:yaml.org,2002:str";
    if (!quoted && value == "<<" && tree_.expects_key())
      tree_.refuse(place_of(mark),
                   "the merge key '<<' is not supported; wanted the keys themselves");
    scalar({.kind = quoted ? Kind::Text : kind_of_plain(value),
            .place = place_of(mark),
            .text = value},
           anchor);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    begin(Kind::List, mark, anchor);
  }
  void OnSequenceEnd() override { end(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    begin(Kind::Map, mark, anchor);
  }
  void OnMapEnd() override { end(); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchored_.find(anchor);
    if (found == anchored_.end())
      tree_.refuse(place_of(mark), "an alias refers to a value that contains it");
    tree_.add_copy(found->second, place_of(mark));
  }

  Node take() { return tree_.take(); }

 private:
  void scalar(Node node, YAML::anchor_t anchor) {
    note(node, anchor);
    tree_.add(std::move(node));
  }
  void begin(Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor) {
    tree_.begin(kind, place_of(mark));
    anchors_.push_back(anchor);
  }
  void end() {
    const YAML::anchor_t anchor = anchors_.back();
    anchors_.pop_back();
    tree_.end([&](const Node& node) { note(node, anchor); });
  }
  void note(const Node& node, YAML::anchor_t anchor) {
    if (anchor == YAML::NullAnchor) return;
    tree_.count_copy(node, node.place);
    anchored_[anchor] = node;
  }

  Builder tree_;
  int documents_ = 0;
  std::vector<YAML::anchor_t> anchors_;  ///< Anchors of the open lists and maps
  std::map<YAML::anchor_t, Node> anchored_;
};

}  // namespace

Kind kind_of_plain(const std::string& text) {
  for (const char* word : {"", "~", "null", "Null", "NULL"})
    if (text == word) return Kind::Null;
  if (text == "true" || text == "false") return Kind::Bool;
  return parse_number(text) ? Kind::Number : Kind::Text;
}

Node parse_yaml(const std::string& text, const std::string& name) {
  constexpr int megabytes = 4;  // a text of this size that only opens lists takes 1 GB of memory
  check_size(text, name, megabytes);
  std::istringstream stream(text);
  YamlEvents events(name);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(events)) {
    }
  } catch (const YAML::Exception& error) {
    const std::string line = "line " + std::to_string(error.mark.line + 1);
    refuse(name, line + ": this is not valid YAML: " + error.msg);
  }
  return events.take();
}

}  // namespace burnish::document
