#include "solver/interior_rows.hpp"

#include <utility>

namespace burnish {

using dense::Lane;
using dense::load;
using dense::store;

namespace {

constexpr double far_away = 1e299;   // a limit from here on is none
constexpr double least_share = 0.1;  // of a price that is left at the start

Lane zero() { return {0.0}; }

/// 1 where a row's limits meet.
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
/// 1 where there is this side: a limit, of a row that has any, that does not meet the other.
Lane exists(const RowArrays& rows, double sign, int r) {
  const Lane weighted = select(less(zero(), load(rows.weight + r)), Lane(1.0), zero());
  const Lane limited =
      select(less(absolute(limit_of(rows, sign, r)), Lane(far_away)), weighted, zero());
  return select(less(zero(), meets(rows, r)), zero(), limited);
}
/// The square of a violation's cost: row_force.hpp has it as a share.
Lane square_of(const RowArrays& rows, int r) {
  const Lane beyond = load(rows.beyond + r), weight = load(rows.weight + r), one(1.0);
  const auto shared = less(beyond, one);
  return select(shared, weight * beyond / select(shared, one - beyond, one), weight);
}

}  // namespace

InteriorRows::InteriorRows(int rows)
    : memory_(static_cast<std::size_t>(18) * static_cast<std::size_t>(dense::round_up(rows))) {
  double* next = memory_.data();
  const auto take = [&] { return std::exchange(next, next + dense::round_up(rows)); };
  for (Side& side : sides_)
    side = {take(), take(), take(), take(), take(), take(), take(), take(), 1.0};
  sides_[1].sign = -1.0;
  equality_ = take();
  equality_step_ = take();
}

void InteriorRows::start(int at, const RowArrays& rows, int r, const Lane& scale, const Lane& y,
                         double mu, bool outside) {
  const Lane price = load(rows.price + r), target(mu), one(1.0);
  const auto priced = less(zero(), price);
  const Lane square = square_of(rows, r);
  for (const Side& side : sides_) {
    const auto there = less(zero(), exists(rows, side.sign, r));
    const auto elastic = mask_and(there, less(price, Lane(no_price)));
    const Lane d = distance(rows, side.sign, r, y), s = larger(d, scale);
    const Lane wanted = target / select(there, s, one), most = (one - Lane(least_share)) * price;
    // A square without a price has no multiplier but that of its violation.
    const Lane m = select(priced, select(less(wanted, most), wanted, most), wanted);
    const Lane n = select(priced, price - m, target / scale);
    // In balance with the cost of the violation.
    const Lane violation = s - d, most_outside = outside ? zero() : Lane(-no_price);
    const auto begins = mask_and(mask_and(elastic, priced), less(d, most_outside));
    const Lane rest = clip(target / violation, Lane(least_share) * price, most);
    const Lane balanced = price + square * violation - rest;
    store(side.s + at, select(there, s, zero()));
    store(side.m + at, select(there, select(begins, balanced, m), zero()));
    store(side.n + at, select(elastic, select(begins, rest, n), zero()));
    const Lane small = target / select(elastic, n, one);
    store(side.v + at, select(elastic, select(begins, violation, small), zero()));
  }
  store(equality_ + at, zero());
}

/// A side's step by the change dy of its row: dm = weight sign dy + rest.
struct InteriorRows::Step {
  Lane weight, rest;
  Lane violation, by_multiplier;  ///< dv = violation + by_multiplier dm
  Lane primal, dual;              ///< what s and n are off
};

InteriorRows::Step InteriorRows::step_of(const Side& side, int at, const RowArrays& rows, int r,
                                         const Lane& y, const Target& target) {
  const Lane s = load(side.s + at), m = load(side.m + at), v = load(side.v + at),
             n = load(side.n + at), one(1.0);
  const Lane square = square_of(rows, r), share(target.corrected ? 1.0 : 0.0);
  const auto there = less(zero(), s), elastic = less(zero(), n);
  const Lane first = Lane(target.mu) - s * m - share * load(side.ds + at) * load(side.dm + at);
  const Lane second = Lane(target.mu) - v * n - share * load(side.dv + at) * load(side.dn + at);
  Step step;
  step.primal = select(there, distance(rows, side.sign, r, y) + v - s, zero());
  step.dual = select(elastic, load(rows.price + r) + square * v - m - n, zero());
  const Lane stiffness = select(elastic, v * square + n, one);
  step.violation = select(elastic, (second - v * step.dual) / stiffness, zero());
  step.by_multiplier = select(elastic, v / stiffness, zero());
  const Lane give = select(there, s + m * step.by_multiplier, one);
  step.weight = m / give;
  step.rest = select(there, (first - m * (step.primal + step.violation)) / give, zero());
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
    store(side.dn + at, select(elastic, step.dual + square_of(rows, r) * dv - dm, zero()));
  }
  store(equality_step_ + at, meets(rows, r) * load(rows.weight + r) * Lane(target.equality) *
                                 (next - load(rows.upper + r)));
}

Lane InteriorRows::steepest(int at) const {
  Lane most = zero();
  for (const Side& side : sides_)
    for (const auto& [value, step] : {std::pair(side.s, side.ds), std::pair(side.m, side.dm),
                                      std::pair(side.v, side.dv), std::pair(side.n, side.dn)}) {
      const Lane x = load(value + at);
      const auto there = less(zero(), x);
      most = larger(most, select(there, -load(step + at) / select(there, x, Lane(1.0)), zero()));
    }
  return most;
}

InteriorRows::Products InteriorRows::products(int at, double length) const {
  Products all{zero(), zero()};
  const Lane share(length);
  for (const Side& side : sides_)
    for (const auto& [a, da, b, db] : {std::array{side.s, side.ds, side.m, side.dm},
                                       std::array{side.v, side.dv, side.n, side.dn}}) {
      const Lane first = load(a + at) + share * load(da + at);
      const Lane second = load(b + at) + share * load(db + at);
      const auto there = less(zero(), load(a + at));
      all.sum += select(there, absolute(first * second), zero());
      all.count += select(there, Lane(1.0), zero());
    }
  return all;
}

void InteriorRows::advance(int at, double length) {
  const Lane share(length);
  const auto move = [&](double* value, const double* step) {
    store(value + at, load(value + at) + share * load(step + at));
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
  const Lane share(length), price = load(rows.price + r);
  // A row whose limits meet pushes whichever way its multiplier does.
  const Lane equal = multiplier(at);
  Lane all = select(less(zero(), meets(rows, r)),
                    select(less(zero(), equal), Lane(1.0), Lane(-1.0)), zero());
  all = select(less(zero(), load(rows.weight + r)),
               select(less(absolute(equal), price), all, all + all), zero());
  for (const Side& side : sides_) {
    const Lane s = load(side.s + at), m = load(side.m + at), v = load(side.v + at),
               n = load(side.n + at);
    const auto stays = [&](const Lane& x, const double* dx, const Lane& y, const double* dy) {
      return less(y * (x - share * load(dx + at)), x * (y - share * load(dy + at)));
    };
    const auto pushes = mask_and(less(zero(), s), stays(m, side.dm, s, side.ds));
    const auto broken = mask_and(less(zero(), n), stays(v, side.dv, n, side.dn));
    const Lane most = select(broken, Lane(2.0), select(less(zero(), price), Lane(1.0), Lane(2.0)));
    all += Lane(side.sign) * select(pushes, most, zero());
  }
  return all;
}

Lane InteriorRows::multiplier(int at) const {
  return load(sides_[0].m + at) - load(sides_[1].m + at) + load(equality_ + at);
}

}  // namespace burnish
