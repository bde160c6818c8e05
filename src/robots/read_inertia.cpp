#include "robots/read_inertia.hpp"

namespace burnish {

InertiaSpec read_inertia(const document::Reader& reader, const std::vector<std::string>& also) {
  std::vector<std::string> keys{"mass", "com", "inertia"};
  keys.insert(keys.end(), also.begin(), also.end());
  reader.allow_only(keys);
  InertiaSpec result;
  result.mass = reader["mass"].not_negative();
  if (const auto com = reader.find("com")) result.com = com->vector3();
  if (const auto inertia = reader.find("inertia")) {
    const Eigen::VectorXd I = inertia->numbers();
    if (I.size() == 3) {
      result.inertia_at_com = I.head<3>().asDiagonal();
    } else if (I.size() == 6) {
      result.inertia_at_com << I[0], I[1], I[2], I[1], I[3], I[4], I[2], I[4], I[5];
    } else {
      inertia->refuse("it has " + std::to_string(I.size()) +
                      " numbers; wanted six (xx, xy, xz, yy, yz and zz) or three (xx, yy and zz)");
    }
  }
  if (const std::string problem = inertia_problem(result); !problem.empty()) reader.refuse(problem);
  return result;
}

Payload read_payload(const document::Reader& reader) {
  Payload result;
  result.inertia = read_inertia(reader, {"frame"});
  if (const auto frame = reader.find("frame")) result.frame = frame->text();
  return result;
}

}  // namespace burnish
