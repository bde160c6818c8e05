#include "solver/interior_rows.hpp"

#include <utility>

#include "base/to_size.hpp"

namespace burnish {

using dense::Lane;
using dense::load;
using dense::store;

namespace {

constexpr double infinite_limit = 1e299;  // Limits of at least this size are infinite
// Smallest initial multiplier n (interior_rows.hpp), as a fraction of the L1 weight; chosen by hand
constexpr double min_fraction = 0.1;

Lane zero() { return {0.0}; }

/// Returns 1 for rows whose lower and upper limits are equal.
Lane meets(const RowArrays& rows, int r) {
  const auto apart = less(load(rows.lower + r), load(rows.upper + r));
  return select(apart, zero(), Lane(1.0));
}
Lane limit_of(const RowArrays& rows, double sign, int r) {
  return load((sign > 0.0 ? rows.upper : rows.lower) + r);
}
Lane distance(const RowArrays& rows, double sign, int r, const Lane& y) {
  return Lane(sign) * (limit_of(rows, sign, r) - y);
}
/// Returns 1 for rows with a weight, unequal limits, and a finite limit on the side `sign`.
Lane exists(const RowArrays& rows, double sign, int r) {
  const Lane weighted = select(less(zero(), load(rows.weight + r)), Lane(1.0), zero());
  const Lane limited =
      select(less(absolute(limit_of(rows, sign, r)), Lane(infinite_limit)), weighted, zero());
  return select(less(zero(), meets(rows, r)), zero(), limited);
}
/// Returns the quadratic weight S, computed from `beyond`, which is S / (weight + S).
Lane quadratic_weight_of(const RowArrays& rows, int r) {
  const Lane beyond = load(rows.beyond + r), weight = load(rows.weight + r), one(1.0);
  const auto is_fraction = less(beyond, one);
  return select(is_fraction, weight * beyond / select(is_fraction, one - beyond, one), weight);
}

}  // namespace

InteriorRows::InteriorRows(int rows) : memory_(to_size(18) * to_size(dense::round_up(rows))) {
  double* next = memory_.data();
  const auto take = [&] { return std::exchange(next, next + dense::round_up(rows)); };
  for (Side& side : sides_)
    side = {take(), take(), take(), take(), take(), take(), take(), take(), 1.0};
  sides_[1].sign = -1.0;
  equality_ = take();
  equality_step_ = take();
}

void InteriorRows::start(int at, const RowArrays& rows, int r, const Lane& scale, const Lane& y,
                         const Start& from) {
  const Lane l1_weight = load(rows.l1_weight + r), target(from.mu), one(1.0);
  const auto has_l1_weight = less(zero(), l1_weight);
  const Lane quadratic_weight = quadratic_weight_of(rows, r);
  for (const Side& side : sides_) {
    const auto there = less(zero(), exists(rows, side.sign, r));
    const auto elastic = mask_and(there, less(l1_weight, Lane(infinite_l1_weight)));
    const Lane d = distance(rows, side.sign, r, y), s = larger(d, scale);
    const Lane wanted = target / select(there, s, one),
               max_multiplier = (one - Lane(min_fraction)) * l1_weight;
    // A row without an L1 weight has only the multiplier of its quadratic penalty.
    const Lane m =
        select(has_l1_weight, select(less(wanted, max_multiplier), wanted, max_multiplier), wanted);
    const Lane n = select(has_l1_weight, l1_weight - m, target / scale);
    // If `infeasible`, the sum m + n of the initial multipliers of a violated row is the derivative
    // of the row's penalty by the violation.
    const Lane violation = s - d, lowest = from.infeasible ? zero() : Lane(-infinite_l1_weight);
    const auto begins = mask_and(mask_and(elastic, has_l1_weight), less(d, lowest));
    const Lane rest = clip(target / violation, Lane(min_fraction) * l1_weight, max_multiplier);
    const Lane balanced = l1_weight + quadratic_weight * violation - rest;
    store(side.s + at, select(there, s, zero()));
    store(side.m + at, select(there, select(begins, balanced, m), zero()));
    store(side.n + at, select(elastic, select(begins, rest, n), zero()));
    const Lane small = target / select(elastic, n, one);
    store(side.v + at, select(elastic, select(begins, violation, small), zero()));
  }
  store(equality_ + at, zero());
}

/// Newton step of one side of a row, as a function of the change dy of the row's value. The step of
/// the multiplier is dm = weight sign dy + rest.
struct InteriorRows::Step {
  Lane weight, rest;
  Lane violation, by_multiplier;  ///< dv = violation + by_multiplier dm
  Lane primal, dual;              ///< Residuals of the equations for s and n
};

InteriorRows::Step InteriorRows::step_of(const Side& side, int at, const RowArrays& rows, int r,
                                         const Lane& y, const Target& target) {
  const Lane s = load(side.s + at), m = load(side.m + at), v = load(side.v + at),
             n = load(side.n + at), one(1.0);
  const Lane quadratic_weight = quadratic_weight_of(rows, r),
             correction(target.corrected ? 1.0 : 0.0);
  const auto there = less(zero(), s), elastic = less(zero(), n);
  const Lane first = Lane(target.mu) - s * m - correction * load(side.ds + at) * load(side.dm + at);
  const Lane second =
      Lane(target.mu) - v * n - correction * load(side.dv + at) * load(side.dn + at);
  Step step;
  step.primal = select(there, distance(rows, side.sign, r, y) + v - s, zero());
  step.dual = select(elastic, load(rows.l1_weight + r) + quadratic_weight * v - m - n, zero());
  const Lane stiffness = select(elastic, v * quadratic_weight + n, one);
  step.violation = select(elastic, (second - v * step.dual) / stiffness, zero());
  step.by_multiplier = select(elastic, v / stiffness, zero());
  const Lane compliance = select(there, s + m * step.by_multiplier, one);
  step.weight = m / compliance;
  step.rest = select(there, (first - m * (step.primal + step.violation)) / compliance, zero());
  return step;
}

RowLines InteriorRows::lines(int at, const RowArrays& rows, int r, const Lane& y,
                             const Target& target) const {
  RowLines sum{zero(), zero()};
  for (const Side& side : sides_) {
    const Step step = step_of(side, at, rows, r, y, target);
    sum.slope += step.weight;
    sum.offset += Lane(side.sign) * (load(side.m + at) + step.rest) - step.weight * y;
  }
  const Lane weight = meets(rows, r) * load(rows.weight + r) * Lane(target.equality);
  sum.slope += weight;
  sum.offset += load(equality_ + at) - weight * load(rows.upper + r);
  return sum;
}

void InteriorRows::take_direction(int at, const RowArrays& rows, int r, const Lane& y,
                                  const Lane& next, const Target& target) {
  const Lane change = next - y;
  for (const Side& side : sides_) {
    const Step step = step_of(side, at, rows, r, y, target);
    const Lane towards = Lane(side.sign) * change;
    const auto there = less(zero(), load(side.s + at)), elastic = less(zero(), load(side.n + at));
    const Lane dm = step.weight * towards + step.rest;
    const Lane dv = step.violation + step.by_multiplier * dm;
    store(side.dm + at, dm);
    store(side.dv + at, dv);
    store(side.ds + at, select(there, step.primal - towards + dv, zero()));
    store(side.dn + at,
          select(elastic, step.dual + quadratic_weight_of(rows, r) * dv - dm, zero()));
  }
  store(equality_step_ + at, meets(rows, r) * load(rows.weight + r) * Lane(target.equality) *
                                 (next - load(rows.upper + r)));
}

Lane InteriorRows::steepest(int at) const {
  Lane result = zero();
  for (const Side& side : sides_)
    for (const auto& [value, step] : {std::pair(side.s, side.ds), std::pair(side.m, side.dm),
                                      std::pair(side.v, side.dv), std::pair(side.n, side.dn)}) {
      const Lane x = load(value + at);
      const auto there = less(zero(), x);
      result =
          larger(result, select(there, -load(step + at) / select(there, x, Lane(1.0)), zero()));
    }
  return result;
}

InteriorRows::Products InteriorRows::products(int at, double length) const {
  Products all{zero(), zero()};
  const Lane fraction(length);
  for (const Side& side : sides_)
    for (const auto& [a, da, b, db] : {std::array{side.s, side.ds, side.m, side.dm},
                                       std::array{side.v, side.dv, side.n, side.dn}}) {
      const Lane first = load(a + at) + fraction * load(da + at);
      const Lane second = load(b + at) + fraction * load(db + at);
      const auto there = less(zero(), load(a + at));
      all.sum += select(there, absolute(first * second), zero());
      all.count += select(there, Lane(1.0), zero());
    }
  return all;
}

void InteriorRows::advance(int at, double length) {
  const Lane fraction(length);
  const auto move = [&](double* value, const double* step) {
    store(value + at, load(value + at) + fraction * load(step + at));
  };
  for (const Side& side : sides_) {
    move(side.s, side.ds);
    move(side.m, side.dm);
    move(side.v, side.dv);
    move(side.n, side.dn);
  }
  move(equality_, equality_step_);
}

Lane InteriorRows::piece(int at, const RowArrays& rows, int r, double length) const {
  const Lane fraction(length), l1_weight = load(rows.l1_weight + r);
  // The multiplier of an equality row gives the side on which the row is active.
  const Lane equal = multiplier(at);
  Lane all = select(less(zero(), meets(rows, r)),
                    select(less(zero(), equal), Lane(1.0), Lane(-1.0)), zero());
  all = select(less(zero(), load(rows.weight + r)),
               select(less(absolute(equal), l1_weight), all, all + all), zero());
  for (const Side& side : sides_) {
    const Lane s = load(side.s + at), m = load(side.m + at), v = load(side.v + at),
               n = load(side.n + at);
    const auto stays = [&](const Lane& x, const double* dx, const Lane& y, const double* dy) {
      return less(y * (x - fraction * load(dx + at)), x * (y - fraction * load(dy + at)));
    };
    const auto active = mask_and(less(zero(), s), stays(m, side.dm, s, side.ds));
    const auto broken = mask_and(less(zero(), n), stays(v, side.dv, n, side.dn));
    const Lane outer_piece =
        select(broken, Lane(2.0), select(less(zero(), l1_weight), Lane(1.0), Lane(2.0)));
    all += Lane(side.sign) * select(active, outer_piece, zero());
  }
  return all;
}

Lane InteriorRows::multiplier(int at) const {
  return load(sides_[0].m + at) - load(sides_[1].m + at) + load(equality_ + at);
}

}  // namespace burnish
