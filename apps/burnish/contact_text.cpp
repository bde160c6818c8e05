#include "contact_text.hpp"

#include <sstream>
#include <utility>
#include <vector>

#include "base/sentence.hpp"
#include "document/builder.hpp"
#include "document/reader.hpp"
#include "document/text.hpp"
#include "files/read_parts.hpp"

namespace burnish::app {
namespace {

using document::Kind;

/// Pairs of a key and its values; on the command line, commas separate the values.
using Pairs = std::vector<std::pair<std::string, std::vector<std::string>>>;

Pairs pairs_in(const std::string& text, const std::string& name) {
  Pairs pairs;
  std::istringstream stream(text);
  for (std::string piece; std::getline(stream, piece, ',');) {
    const std::size_t equals = piece.find('=');
    if (equals != std::string::npos) {
      pairs.push_back({piece.substr(0, equals), {}});
      piece.erase(0, equals + 1);
    } else if (pairs.empty()) {
      refuse(name,
             in_quotes(piece) +
                 " is not of the form key=value; wanted, for example, tool=flange,directions=z");
    }
    pairs.back().second.push_back(piece);
  }
  return pairs;
}

/// Converts the pairs to the notation of files. If a normal is given, the pair reference=surface
/// may be omitted.
document::Reader contact_of(Pairs pairs, const std::string& name) {
  const auto is_normal = [](const auto& pair) { return pair.first == "normal"; };
  if (std::any_of(pairs.begin(), pairs.end(), is_normal)) {
    std::erase(pairs, Pairs::value_type{"reference", {"surface"}});
    for (const auto& [key, values] : pairs)
      if (key == "reference")
        refuse(name,
               "key 'normal' is given without reference=surface; wanted reference=surface, or no "
               "'normal'");
  }
  document::Builder tree(name, 1000);
  const auto key = [&](const char* text) { tree.add({.kind = Kind::Text, .text = text}); };
  tree.begin(Kind::Map, {});
  for (const auto& pair : pairs) {
    if (is_normal(pair)) {
      for (const char* above : {"reference", "surface"}) {
        key(above);
        tree.begin(Kind::Map, {});
      }
    }
    key(pair.first.c_str());
    if (pair.second.size() != 1) tree.begin(Kind::List, {});
    for (const std::string& value : pair.second)
      tree.add({.kind = document::kind_of_plain(value), .text = value});
    if (pair.second.size() != 1) tree.end();
    for (int i = 0; is_normal(pair) && i < 2; ++i) tree.end();
  }
  tree.end();
  return {tree.take(), name};
}

}  // namespace

ContactSpec parse_contact(const std::string& text, const Model& model, const Eigen::VectorXd& q) {
  const std::string name = "--contact " + text;
  const document::Reader contact = text.starts_with('{') ? document::Reader::parse(text, name)
                                                         : contact_of(pairs_in(text, name), name);
  return files::read_contact("", contact, model, q);
}

}  // namespace burnish::app
