// Mass distributions as texts state them.
#pragma once

#include "burnish/model/inertia.hpp"
#include "document/reader.hpp"

namespace burnish {

/// {mass: kg, com: [m], inertia: [xx, xy, xz, yy, yz, zz], kg m^2 about com}; inertia may be three
/// numbers, along the axes. `also`: further keys that the map may have. Refuses what no solid has.
InertiaSpec read_inertia(const document::Reader& reader, const std::vector<std::string>& also = {});
/// The same with the frame that it is fixed to and written in: {frame: tool, mass: ...}.
Payload read_payload(const document::Reader& reader);

}  // namespace burnish
