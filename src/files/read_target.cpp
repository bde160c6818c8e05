#include "files/read_target.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "files/csv_table.hpp"

namespace burnish::files {
namespace {

using Out = Eigen::Ref<Eigen::VectorXd>;

Eigen::VectorXd here_of(const TargetSpace& space, const Reader& reader) {
  if (!space.here) reader.refuse("'here' is not defined for this residual; wanted numbers");
  return *space.here;
}

Eigen::VectorXd coefficients(const Eigen::Quaterniond& rotation) { return rotation.coeffs(); }

bool starts_here(const Reader& reader) {
  return reader.is("here") || (reader.is_map() && reader.has("here"));
}

/// Converts offsets (columns) to the coordinates of targets. Offsets from `here` are along the axes
/// of the residual. Offsets from numbers are in the coordinates of targets already.
Eigen::MatrixXd offsets_from(const Reader& origin, const TargetSpace& space,
                             const Eigen::MatrixXd& offsets) {
  if (!space.offsets || !starts_here(origin)) return offsets;
  return *space.offsets * offsets;
}

/// Reads a constant target: numbers, `here`, {here: offset}, a rotation or a placement.
Eigen::VectorXd read_point(const TargetSpace& space, const Reader& reader) {
  if (reader.is("here")) return here_of(space, reader);
  if (space.kind == TargetSpace::Kind::Rotation) return coefficients(read_rotation(reader));
  if (space.kind == TargetSpace::Kind::Placement) {
    const Eigen::Isometry3d placement = read_placement(reader);
    Eigen::VectorXd seven(7);
    seven << placement.translation(), coefficients(Eigen::Quaterniond(placement.linear()));
    return seven;
  }
  if (reader.is_number()) return Eigen::VectorXd::Constant(space.size(), reader.number());
  if (reader.is_list()) return reader.numbers(space.size());
  if (reader.has("here")) {
    reader.allow_only({"here"});
    return here_of(space, reader) + offsets_from(reader, space, read_point(space, reader["here"]));
  }
  return read_rows(reader, space.rows, 0.0);
}

double number_at(const Reader& reader, const char* key, double otherwise) {
  const auto found = reader.find(key);
  return found ? found->number() : otherwise;
}

Signal read_circle(const TargetSpace& space, const Reader& reader) {
  if (space.size() != 3)
    reader.refuse("the path is a circle, but the target has " + std::to_string(space.size()) +
                  (space.size() == 1 ? " entry" : " entries") +
                  "; wanted a target with 3 entries, or another path");
  reader.allow_only({"center", "start", "radius", "rate", "axes", "phase"});
  Eigen::Vector3d a = Eigen::Vector3d::UnitX(), b = Eigen::Vector3d::UnitY();
  if (const auto axes = reader.find("axes")) {
    const std::vector<Reader> two = axes->entries();
    if (two.size() != 2)
      axes->refuse("it has " + std::to_string(two.size()) +
                   (two.size() == 1 ? " entry" : " entries") +
                   "; wanted two axes of 3 numbers each");
    a = two[0].vector3();
    b = two[1].vector3();
    if (std::abs(a.norm() - 1.0) > 1e-3 || std::abs(b.norm() - 1.0) > 1e-3 ||
        std::abs(a.dot(b)) > 1e-3)
      axes->refuse(
          "the axes do not have length 1 or are not at a right angle; wanted two axes of length 1 "
          "at a right angle");
  }
  const double radius = reader["radius"].positive(), rate = reader["rate"].number();
  const double phase = number_at(reader, "phase", 0.0);
  if (reader.has("center") == reader.has("start"))
    reader.refuse(std::string("keys 'center' and 'start' (the point at time 0) are both ") +
                  (reader.has("start") ? "stated; state one" : "missing; wanted one of them"));
  const bool from_center = reader.has("center");
  const Reader origin = reader[from_center ? "center" : "start"];
  a = offsets_from(origin, space, a);
  b = offsets_from(origin, space, b);
  Eigen::Vector3d center = read_point(space, origin);
  if (!from_center) center -= radius * (std::cos(phase) * a + std::sin(phase) * b);
  return Signal::over_time(3, [=](double t, Out p) {
    const double angle = rate * t + phase;
    p = center + radius * (std::cos(angle) * a + std::sin(angle) * b);
  });
}

Signal read_line(const TargetSpace& space, const Reader& reader) {
  reader.allow_only({"from", "to", "start", "duration", "profile"});
  const Eigen::VectorXd from = read_point(space, reader["from"]);
  const Eigen::VectorXd to = read_point(space, reader["to"]);
  const double start = number_at(reader, "start", 0.0);
  const double duration = reader["duration"].positive();
  const auto profile = reader.find("profile");
  const bool smooth = !profile || profile->word({"smooth", "constant_speed"}) == "smooth";
  const Eigen::Index quaternion = space.quaternion_entries();
  return Signal::over_time(space.size(), [=](double t, Out p) {
    double s = std::clamp((t - start) / duration, 0.0, 1.0);
    // The smooth profile has zero velocity and acceleration at both ends.
    if (smooth) s = s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
    const Eigen::Index plain = p.size() - quaternion;
    p.head(plain) = from.head(plain) + s * (to - from).head(plain);
    if (quaternion == 0) return;
    // Slerp: rotation about one axis through the smaller angle.
    const Eigen::Quaterniond first(Eigen::Vector4d(from.tail(4))),
        last(Eigen::Vector4d(to.tail(4)));
    p.tail(4) = first.slerp(s, last).coeffs();
  });
}

Signal read_sine(const TargetSpace& space, const Reader& reader) {
  reader.allow_only({"center", "amplitude", "rate", "phase"});
  const Eigen::VectorXd center = read_point(space, reader["center"]);
  const Eigen::VectorXd amplitude =
      offsets_from(reader["center"], space, read_rows(reader["amplitude"], space.rows, 0.0));
  const double rate = reader["rate"].number(), phase = number_at(reader, "phase", 0.0);
  return Signal::over_time(
      space.size(), [=](double t, Out p) { p = center + std::sin(rate * t + phase) * amplitude; });
}

/// Returns the row before `time`, and the place of `time` between this row and the next, from 0 to
/// 1.
std::pair<Eigen::Index, double> between(const Eigen::VectorXd& times, double time) {
  const auto after = std::upper_bound(times.begin(), times.end(), time) - times.begin();
  if (after == 0) return {0, 0.0};
  if (after == times.size()) return {times.size() - 2, 1.0};
  return {after - 1, (time - times[after - 1]) / (times[after] - times[after - 1])};
}

/// Normalizes quaternions, whose length in tables can differ from 1 by rounding. Replaces q by -q,
/// which is the same rotation, if -q is closer to the quaternion of the previous row. Interpolation
/// then turns through the smaller angle.
void align_quaternions(const Reader& file, const Eigen::VectorXd& times, Eigen::MatrixXd& points) {
  for (Eigen::Index i = 0; i < times.size(); ++i) {
    auto xyzw = points.col(i).tail<4>();
    const double length = xyzw.norm();
    if (std::abs(length - 1.0) > 1e-3)
      file.refuse("the quaternion at " + number(times[i]) + " s has length " + number(length) +
                  "; wanted 1");
    xyzw /= length;
    if (i > 0 && xyzw.dot(points.col(i - 1).tail<4>()) < 0.0) xyzw = -xyzw;
  }
}

Signal read_points(const std::filesystem::path& folder, const TargetSpace& space,
                   const Reader& reader) {
  reader.allow_only({"file", "columns", "relative_to"});
  const Reader file = reader["file"];
  const CsvTable table = file.named([&] { return read_csv(beside(folder, file.text())); });
  const Reader columns = reader["columns"];
  const std::vector<std::string> names = columns.texts();
  if (static_cast<int>(names.size()) != space.size())
    columns.refuse("the list names " + std::to_string(names.size()) + " columns; wanted " +
                   std::to_string(space.size()));
  const Eigen::VectorXd times = file.named([&] { return table.column("time"); });
  if (times.size() < 2)
    file.refuse("the table has " + std::to_string(times.size()) + " rows; wanted at least 2");
  for (Eigen::Index i = 1; i < times.size(); ++i)
    if (!(times[i] > times[i - 1]))
      file.refuse("the times in column 'time' do not increase from row to row");
  Eigen::MatrixXd points(space.size(), times.size());
  for (int i = 0; i < space.size(); ++i)
    points.row(i) = columns.named([&] { return table.column(names[to_size(i)]); }).transpose();
  if (const auto origin = reader.find("relative_to")) {
    if (space.kind != TargetSpace::Kind::Plain)
      origin->refuse(
          "'relative_to' adds an offset to the target, which rotations do not support; wanted no "
          "key 'relative_to'");
    points = offsets_from(*origin, space, points).colwise() + read_point(space, *origin);
  }
  const Eigen::Index quaternion = space.quaternion_entries();
  if (quaternion > 0) align_quaternions(file, times, points);
  return Signal::over_time(space.size(), [=](double t, Out p) {
    const auto [row, fraction] = between(times, t);
    p = points.col(row) + fraction * (points.col(row + 1) - points.col(row));
    if (quaternion > 0) p.tail(4).normalize();
  });
}

}  // namespace

Signal read_rotation_over_time(const std::filesystem::path& folder, const Reader& reader) {
  reader.allow_only({"line", "points"});
  if (reader.has("line") == reader.has("points"))
    reader.refuse(std::string("keys 'line' and 'points' are both ") +
                  (reader.has("line") ? "stated; state one" : "missing; wanted one of them"));
  return read_target(folder, {{{"quaternion", 4}}, {}, TargetSpace::Kind::Rotation}, reader);
}

Signal read_target(const std::filesystem::path& folder, const TargetSpace& space,
                   const Reader& reader) {
  static const std::vector<std::string> paths{"circle", "line", "sine", "points"};
  if (reader.is("here")) return here_of(space, reader);
  for (const std::string& name : paths) {
    const auto path = reader.find(name);
    if (!path) continue;
    reader.allow_only({name});
    if (name == "points") return read_points(folder, space, *path);
    if (name == "line") return read_line(space, *path);
    if (space.kind != TargetSpace::Kind::Plain)
      path->refuse(
          "a rotation cannot follow this path; wanted a constant, 'here', 'line' or 'points'");
    return name == "circle" ? read_circle(space, *path) : read_sine(space, *path);
  }
  if (reader.is_text())
    reader.refuse(in_quotes(reader.text()) +
                  " is not a target; wanted numbers, 'here' or a path (" + either(paths) + ")");
  if (reader.is_map() && space.kind == TargetSpace::Kind::Plain && !reader.has("here")) {
    std::vector<std::string> known = paths;
    known.insert(known.end(), {"here", "other"});
    for (const RowGroup& group : space.rows) known.push_back(group.name);
    reader.allow_only(known);
  }
  return read_point(space, reader);
}

}  // namespace burnish::files
