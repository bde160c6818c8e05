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
    refuse(source, "the file is empty; wanted a description in " + format);
  }
  if (document.Parse(xml.data(), xml.size()) == tinyxml2::XML_SUCCESS) return;
  std::string reason = document.ErrorName();
  if (document.ErrorID() == tinyxml2::XML_ERROR_MISMATCHED_ELEMENT) {
    reason = "an element is not closed, or is closed by the tag of another element";
  } else if (document.ErrorID() == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    reason = "elements are nested too deeply";
  } else if (document.ErrorID() == tinyxml2::XML_ERROR_PARSING ||
             document.ErrorID() == tinyxml2::XML_ERROR_PARSING_ELEMENT ||
             document.ErrorID() == tinyxml2::XML_ERROR_PARSING_ATTRIBUTE) {
    reason = "an element is cut off or misspelt";
  } else if (document.ErrorID() == tinyxml2::XML_ERROR_PARSING_TEXT) {
    reason = "there is text in place of an element";
  }
  refuse(source, "line " + std::to_string(document.ErrorLineNum()) +
                     ": the XML is not well formed: " + reason);
}

/// Limits the number of attributes of an element. Readers search attributes one by one from the
/// first, so their time would grow with the square of this number.
class FewAttributes : public tinyxml2::XMLVisitor {
 public:
  explicit FewAttributes(const std::string& source) : source_(source) {}

  bool VisitEnter(const XMLElement& element, const tinyxml2::XMLAttribute* attribute) override {
    constexpr int max_attributes = 100;
    int count = 0;
    for (; attribute != nullptr; attribute = attribute->Next()) {
      if (++count > max_attributes) {
        refuse(source_, line_text(element) + "<" + element.Name() + "> has more than " +
                            std::to_string(max_attributes) + " attributes, the maximum number");
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
  constexpr int megabytes = 16;  // a text of this size with short elements takes 1 GB of memory
  check_size(xml, source, megabytes);
  parse_text(document, xml, source, format);
  const XMLElement* outermost = document.RootElement();
  if (outermost == nullptr) {
    refuse(source, "the outermost element is missing; wanted " + wanted);
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
