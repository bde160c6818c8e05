#include "urdf/xml_document.hpp"

#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "urdf/xml_element.hpp"

namespace burnish {
namespace {

using tinyxml2::XMLElement;

void parse_text(tinyxml2::XMLDocument& document, const std::string& xml, const std::string& source,
                const std::string& format) {
  if (xml.find_first_not_of(" \t\r\n") == std::string::npos) {
    refuse(source, "it is empty; a description in " + format + " was wanted");
  }
  if (document.Parse(xml.data(), xml.size()) == tinyxml2::XML_SUCCESS) return;
  std::string reason = document.ErrorName();
  if (document.ErrorID() == tinyxml2::XML_ERROR_MISMATCHED_ELEMENT) {
    reason = "an element is closed by another one's tag or not at all";
  } else if (document.ErrorID() == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    reason = "elements are nested too deeply";
  } else if (document.ErrorID() == tinyxml2::XML_ERROR_PARSING ||
             document.ErrorID() == tinyxml2::XML_ERROR_PARSING_ELEMENT ||
             document.ErrorID() == tinyxml2::XML_ERROR_PARSING_ATTRIBUTE) {
    reason = "an element is cut off or misspelt";
  } else if (document.ErrorID() == tinyxml2::XML_ERROR_PARSING_TEXT) {
    reason = "text stands where an element belongs";
  }
  refuse(source, "line " + std::to_string(document.ErrorLineNum()) +
                     ": the XML is not well formed: " + reason);
}

/// The readers look attributes up one by one, each time from the first.
class FewAttributes : public tinyxml2::XMLVisitor {
 public:
  explicit FewAttributes(const std::string& source) : source_(source) {}

  bool VisitEnter(const XMLElement& element, const tinyxml2::XMLAttribute* attribute) override {
    constexpr int most = 100;
    int count = 0;
    for (; attribute != nullptr; attribute = attribute->Next()) {
      if (++count > most) {
        refuse(source_, line_text(element) + "<" + element.Name() + "> has more than " +
                            std::to_string(most) + " attributes; at most that many are read");
      }
    }
    return true;
  }

 private:
  const std::string& source_;
};

}  // namespace

const XMLElement& parse_xml(tinyxml2::XMLDocument& document, const std::string& xml,
                            const std::string& source, const std::string& format,
                            const std::string& wanted) {
  constexpr int megabytes = 16;  // of the shortest elements 1 GB in memory
  check_size(xml, source, megabytes);
  parse_text(document, xml, source, format);
  const XMLElement* outermost = document.RootElement();
  if (outermost == nullptr) {
    refuse(source, "its outermost element is missing; wanted " + wanted);
  }
  FewAttributes check(source);
  outermost->Accept(&check);
  return *outermost;
}

const XMLElement& parse_robot_xml(tinyxml2::XMLDocument& document, const std::string& xml,
                                  const std::string& source, const std::string& format) {
  const XMLElement& robot = parse_xml(document, xml, source, format, "<robot>");
  if (std::string_view(robot.Name()) == "robot") return robot;
  refuse(source, "its outermost element is <" + std::string(robot.Name()) + ">; wanted <robot>");
}

}  // namespace burnish
