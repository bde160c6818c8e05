// Parses XML files, with limits on their size that apply to all formats.
#pragma once

#include <tinyxml2.h>

#include <string>

namespace burnish {

/// Returns the outermost element. `format` and `wanted` name the expected format and element in
/// messages, such as "URDF" and "<robot>". Throws Error if the text is larger than 16 MB, is not
/// valid XML or does not have an element, or if an element has more than 100 attributes.
const tinyxml2::XMLElement& parse_xml(tinyxml2::XMLDocument& document, const std::string& xml,
                                      const std::string& source, const std::string& format,
                                      const std::string& wanted);

/// Returns the outermost element. Throws Error if it is not <robot>, or if parse_xml() throws.
const tinyxml2::XMLElement& parse_robot_xml(tinyxml2::XMLDocument& document, const std::string& xml,
                                            const std::string& source, const std::string& format);

}  // namespace burnish
