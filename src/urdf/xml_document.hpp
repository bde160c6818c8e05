// A file in XML, within bounds that every reader keeps.
#pragma once

#include <tinyxml2.h>

#include <string>

namespace burnish {

/// The outermost element. Throws Error where the text is larger than 16 MB, is no XML, has no
/// element, or one with more than 100 attributes. `format` and `wanted` say in sentences what
/// was wanted, e.g. "URDF" and "<robot>".
const tinyxml2::XMLElement& parse_xml(tinyxml2::XMLDocument& document, const std::string& xml,
                                      const std::string& source, const std::string& format,
                                      const std::string& wanted);

/// The same, of a text that must have <robot> around it.
const tinyxml2::XMLElement& parse_robot_xml(tinyxml2::XMLDocument& document, const std::string& xml,
                                            const std::string& source, const std::string& format);

}  // namespace burnish
