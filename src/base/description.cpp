#include "base/description.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"

namespace burnish {

using Kind = ValueType::Kind;

bool Range::holds(double value) const {
  if (std::isinf(value)) return infinite && (value > 0.0 || std::isinf(least));
  if (std::isnan(value)) return false;
  if (below && value == most) return false;
  return open ? value > least && value < most : value >= least && value <= most;
}

std::string Range::text() const {
  const bool from = std::isfinite(least), to = std::isfinite(most);
  const std::string low = (open ? "more than " : "at least ") + number(least),
                    high = (open || below ? "less than " : "at most ") + number(most);
  if (direction) return "a vector that is not zero";
  if (least == 0.0 && most == 1.0 && !open && !below) return "a fraction between 0 and 1";
  if (from && to)
    return open || below ? low + " and " + high : number(least) + " to " + number(most);
  return from ? low : to ? high : "";
}

std::vector<std::string> Words::list() const {
  std::vector<std::string> result;
  for (const Word& word : words) result.push_back(word.word);
  return result;
}

int Words::value_of(const std::string& word) const {
  const std::vector<std::string> all = list();
  const auto found = std::find(all.begin(), all.end(), word);
  if (found == all.end())
    throw Error(name + ": there is no " + in_quotes(word) + did_you_mean(word, all));
  return static_cast<int>(found - all.begin());
}

namespace {

/// Returns the begin and end indices of the unit in the braces of `meaning`, or {0, 0}.
std::pair<std::size_t, std::size_t> place_of_unit(const std::string& meaning) {
  const std::size_t begin = meaning.find('{'), end = meaning.find('}');
  const std::string inside =
      begin < end && end != std::string::npos ? meaning.substr(begin + 1, end - begin - 1) : "";
  if (inside.empty() || inside.find(':') != std::string::npos) return {0, 0};
  return {begin + 1, end};
}

}  // namespace

std::string Field::unit() const {
  const auto [begin, end] = place_of_unit(meaning);
  return meaning.substr(begin, end - begin);
}

std::string Field::comment() const {
  const auto [begin, end] = place_of_unit(meaning);
  if (begin == end) return meaning;
  return meaning.substr(0, begin - 1) + meaning.substr(begin, end - begin) +
         meaning.substr(end + 1);
}

std::string Field::text() const {
  const std::string brief = in_code.empty() ? comment() : in_code;
  if (more.empty() || brief.empty()) return brief + more;
  return brief + (std::isupper(static_cast<unsigned char>(more.front())) ? ". " : "; ") + more;
}

const Field& Description::field(const std::string& name_of_field) const {
  for (const Field& candidate : fields)
    if (candidate.name == name_of_field) return candidate;
  throw Error(name + " has no entry " + in_quotes(name_of_field));
}

namespace {

using Subject = std::function<std::string(const std::string&)>;

[[noreturn]] void refuse_value(const std::string& subject, double value, const Range& range) {
  const std::string wanted = range.text();
  throw Error(subject + " is " + number(value) + "; wanted " +
              (!wanted.empty() ? wanted : "a finite number"));
}

void check_value(const Field& field, const ValueType& type, const void* at, const std::string& path,
                 const Subject& subject) {
  const Range& range = field.range;
  const auto check = [&](double value) {
    if (!range.holds(value)) refuse_value(subject(path), value, range);
  };
  if (type.kind == Kind::Number) {
    check(*static_cast<const double*>(at));
  } else if (type.kind == Kind::Count && !type.is_unsigned) {
    check(static_cast<double>(type.get(at)));
  } else if (type.kind == Kind::Array) {
    const double* numbers = type.numbers(to_read(at));
    const Eigen::Index size = type.rows_of(at) * type.columns_of(at);
    std::for_each(numbers, numbers + size, check);
    constexpr double min_length = 1e-9;  // length that counts as zero; chosen by hand
    if (range.direction && !(Eigen::Map<const Eigen::VectorXd>(numbers, size).norm() > min_length))
      throw Error(subject(path) + " has no direction; wanted " + range.text());
  } else if (type.kind == Kind::List || type.kind == Kind::Map || type.kind == Kind::Optional) {
    for (std::size_t i = 0; i < type.size(at); ++i)
      check_value(field, type.element(), type.entry(to_read(at), i),
                  path + (type.kind == Kind::List  ? "[" + std::to_string(i) + "]"
                          : type.kind == Kind::Map ? "." + type.name(at, i)
                                                   : ""),
                  subject);
  } else if (type.kind == Kind::Struct) {
    check_ranges(type.description(), at,
                 [&](const std::string& entry) { return subject(path + "." + entry); });
  }
}

}  // namespace

void check_ranges(const Description& description, const void* spec, const Subject& subject) {
  for (const Field& field : description.fields)
    check_value(field, *field.type, field.in(spec), field.name, subject);
}

namespace {

void put_named(const ValueType& list, void* all, const void* added) {
  const ValueType& type = list.element();
  const auto name_in = [&](void* entry) -> const std::string& {
    return *static_cast<const std::string*>(type.description().field("name").in(entry));
  };
  for (std::size_t i = 0; i < list.size(added); ++i) {
    void* entry = list.entry(to_read(added), i);
    std::size_t same = 0;
    while (same < list.size(all) && name_in(list.entry(all, same)) != name_in(entry)) ++same;
    if (same == list.size(all)) list.resize(all, same + 1);
    type.assign(list.entry(all, same), entry);
  }
}

}  // namespace

void put_over(const Description& description, void* spec, const void* changes) {
  for (const Field& field : description.fields) {
    const ValueType& type = *field.type;
    void* all = field.in(spec);
    const void* added = field.in(changes);
    if (type.kind == Kind::Optional && type.size(added) > 0) type.assign(all, added);
    if (type.kind == Kind::List && type.element().kind == Kind::Struct) put_named(type, all, added);
    if (type.kind == Kind::Map)
      for (std::size_t i = 0; i < type.size(added); ++i)
        type.element().assign(type.named(all, type.name(added, i)), type.entry(to_read(added), i));
  }
}

namespace detail {

void add_field(Description& description, const char* name, const char* means, const Range& numbers,
               std::size_t offset, const ValueType& type) {
  Field field{name, name, means, "", "", "", numbers, offset, &type};
  if (numbers.infinite && type.kind != Kind::Optional) field.word = "never";
  description.fields.push_back(std::move(field));
}

void add_group(Description& description, const char* means, const char* section) {
  description.groups.push_back({description.fields.size(), section, means});
}

Field& last_field(Description& description) { return description.fields.back(); }

void set_text(std::string& of, const char* text) { of = text; }

}  // namespace detail
}  // namespace burnish
