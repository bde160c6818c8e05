#include "files/read_solver.hpp"

#include "files/read_values.hpp"

namespace burnish::files {
namespace {

void set(const Reader& reader, const char* key, double& value) {
  if (const auto given = reader.find(key)) value = given->number();
}

}  // namespace

DdpOptions read_solver(const Reader& reader) {
  DdpOptions options;
  reader.allow_only({"update", "max_iterations", "time_budget", "threads", "pin_threads",
                     "share_knots", "segments", "stop_tolerance", "gap_tolerance", "line_search",
                     "regularization"});
  if (const auto update = reader.find("update"))
    options.update = update->word({"rollout", "multiple_shooting"}) == "rollout"
                         ? StepUpdate::Rollout
                         : StepUpdate::MultipleShooting;
  if (const auto most = reader.find("max_iterations")) options.max_iterations = most->count(0);
  if (const auto threads = reader.find("threads")) options.threads = threads->count(1);
  if (const auto pin = reader.find("pin_threads")) options.pin_threads = pin->yes_or_no();
  if (const auto share = reader.find("share_knots")) options.share_knots = share->yes_or_no();
  if (const auto segments = reader.find("segments")) options.segments = segments->count(1);
  set(reader, "time_budget", options.time_budget);
  set(reader, "stop_tolerance", options.stop_tolerance);
  set(reader, "gap_tolerance", options.gap_tolerance);
  if (const auto search = reader.find("line_search")) {
    search->allow_only({"halvings", "sufficient_decrease", "allowed_increase", "merit_decrease",
                        "merit_share", "rounding"});
    LineSearch& line = options.line_search;
    if (const auto halvings = search->find("halvings")) line.halvings = halvings->count(0);
    set(*search, "sufficient_decrease", line.sufficient_decrease);
    set(*search, "allowed_increase", line.allowed_increase);
    set(*search, "merit_decrease", line.merit_decrease);
    set(*search, "merit_share", line.merit_share);
    set(*search, "rounding", line.rounding);
  }
  if (const auto levenberg = reader.find("regularization")) {
    levenberg->allow_only(
        {"initial", "smallest", "largest", "factor", "decrease_above", "increase_at_or_below"});
    Regularization& r = options.regularization;
    set(*levenberg, "initial", r.initial);
    set(*levenberg, "smallest", r.smallest);
    set(*levenberg, "largest", r.largest);
    set(*levenberg, "factor", r.factor);
    set(*levenberg, "decrease_above", r.decrease_above);
    set(*levenberg, "increase_at_or_below", r.increase_at_or_below);
  }
  reader.named([&] { options.check(); });
  return options;
}

WarmStart read_guess(const Reader& reader, const std::filesystem::path& folder) {
  if (reader.is_map()) {
    reader.allow_only({"file"});
    return {WarmStart::Kind::File, beside(folder, reader["file"].text())};
  }
  const bool hold = reader.word({"hold", "still"}) == "hold";
  return {hold ? WarmStart::Kind::Hold : WarmStart::Kind::Still, {}};
}

}  // namespace burnish::files
