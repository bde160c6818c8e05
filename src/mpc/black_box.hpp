// Flight recorder: keeps the ticks of a controller's last second for its fault report.
#pragma once

#include "burnish/mpc/controller.hpp"
#include "mpc/fault_latch.hpp"
#include "mpc/measurement_gate.hpp"

namespace burnish {

class BlackBox {
 public:
  /// Reserves memory for one second of ticks with the period `tick_period` [s], in the ring buffer
  /// and in the trace of `latch.report`. `tools`: frames of the tools.
  BlackBox(const Model& model, const std::vector<ToolSpec>& tools, double tick_period,
           FaultLatch& latch);

  void reset() noexcept { count_ = 0; }
  /// Records a tick with the last valid measurement of `gate`. At the first fault, the recorded
  /// ticks are copied into the fault report; later calls have no effect.
  void record(const MeasurementGate& gate, double schedule_time, const Command& command,
              FaultLatch& latch) noexcept;

 private:
  RowMatrix rows_;  ///< Ring buffer, one row per tick.
  long count_ = 0;
};

}  // namespace burnish
