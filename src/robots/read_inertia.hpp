// Readers of inertias and payloads from settings.
#pragma once

#include "burnish/model/inertia.hpp"
#include "document/reader.hpp"

namespace burnish {

/// Reads {mass, com, inertia} [kg, m, kg m^2]. The inertia is about com: [xx, xy, xz, yy, yz, zz],
/// or three moments along the axes. `also`: further keys of the map. Throws Error for an
/// inertia that no solid has.
InertiaSpec read_inertia(const document::Reader& reader, const std::vector<std::string>& also = {});
/// Reads {frame, mass, com, inertia}. The payload is fixed to the frame, and its values are in the
/// axes of the frame.
Payload read_payload(const document::Reader& reader);

}  // namespace burnish
