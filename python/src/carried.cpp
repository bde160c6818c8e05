// Types of entries that descriptions do not support, with their annotations and defaults in Python.
#include "specs_files.hpp"
#include "specs_polishing.hpp"

namespace burnish::python {
namespace {

template <class Answer, class... Given>
using Function = std::function<Answer(Given...)>;

/// Returns the Python code of a dataclass field whose default is a named reference, such as
/// Reference.world().
std::string named_reference(const void* at) {
  return "field(default_factory=lambda: Reference." + static_cast<const Reference*>(at)->name() +
         "())";
}
std::string directions_text(const void* at) {
  return "\"" + static_cast<const Directions*>(at)->text() + "\"";
}

[[maybe_unused]] const bool all_are_carried = [] {
  const bool all[] = {
      carry<Eigen::Isometry3d>("ArrayLike", "identity(4)"),
      carry<Posture>("Posture", "field(default_factory=dict)"),
      carry<Shape>("Shape"),
      carry<Model>("Model"),
      carry<Robot>("Robot"),
      carry<Reference>("Reference", "field(default_factory=lambda: Reference())", named_reference),
      carry<Directions>("str", "\"x,y,z,rx,ry,rz\"", directions_text),
      carry<Signal>("Signal", "None"),
      carry<Residual>("Residual"),
      carry<std::filesystem::path>("Union[str, Path]", "Path()"),
      carry<Trace>("Trace", "field(default_factory=lambda: Trace())"),
      carry<MakeTask>("Optional[PressingTask]", "None"),
      carry<polishing::ResultCell>("ResultCell"),
      carry<DdpCallback>("Optional[Callable[[DdpProgress], Optional[bool]]]", "None"),
      carry<Function<TaskTarget, double>>("Optional[Callable[[float], TaskTarget]]", "None"),
      carry<Function<TaskPoint, double>>("Optional[Callable[[float], TaskPoint]]", "None"),
      carry<Function<void, int, int>>("Optional[Callable[[int, int], None]]", "None"),
      carry<Function<bool, double, double>>("Optional[Callable[[float, float], Optional[bool]]]",
                                            "None"),
      carry<Function<void, double, const std::string&>>(
          "Optional[Callable[[float, str], Optional[bool]]]", "None"),
  };
  return std::find(std::begin(all), std::end(all), false) == std::end(all);
}();

}  // namespace
}  // namespace burnish::python
