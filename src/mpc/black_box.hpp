// The last second of a controller, kept for its fault report.
#pragma once

#include "burnish/mpc/mpc.hpp"
#include "mpc/fault_latch.hpp"

namespace burnish {

class BlackBox {
 public:
  /// Prepares the report's trace too.
  BlackBox(const MpcSpec& spec, FaultLatch& latch);

  void reset() noexcept { count_ = 0; }
  /// A tick at `now` (s) with the last good measurement. With the first fault the ticks until then
  /// go into its report, and nothing is kept any more.
  void record(double now, double schedule_time, const Measurement& m, const Command& command,
              FaultLatch& latch) noexcept;

 private:
  RowMatrix rows_;  ///< a ring
  long count_ = 0;
};

}  // namespace burnish
