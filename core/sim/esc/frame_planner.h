// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "sim/esc/fmmu_unit.h"
#include "sim/esc/frame_plan.h"

namespace syncline::sim {

class EscMemory;
class PassingFrame;
class StationAddresses;
class SyncManagers;
class WriteProtection;
struct PassingDatagram;

/// Finds out once what a frame of every cycle does to an ESC with the settings that its units have now.
class FramePlanner {
 public:
  /// Units of one ESC, which outlive it. `logical_read_write`: it knows LRW.
  FramePlanner(const EscMemory& memory, const SyncManagers& managers, const FmmuUnit& fmmus,
               const WriteProtection& protection, const StationAddresses& addresses, bool logical_read_write)
      : memory_(memory),
        managers_(managers),
        fmmus_(fmmus),
        protection_(protection),
        addresses_(addresses),
        logical_read_write_(logical_read_write) {}

  /// Completes an empty plan; FramePlan::executed stays where somebody must look at the frame each time.
  void make(FramePlan& plan, PassingFrame& frame) const;

 private:
  // False: somebody must look at it each time. `offset`: of the datagram's data in the frame.
  [[nodiscard]] bool add_datagram(FramePlan& plan, const PassingDatagram& datagram, std::size_t number,
                                  std::size_t offset) const;
  [[nodiscard]] bool add_reading(FramePlan& plan, const PassingDatagram& datagram, std::size_t number,
                                 std::size_t offset) const;
  [[nodiscard]] bool add_time(FramePlan& plan, const PassingDatagram& datagram, std::size_t number,
                              std::size_t offset) const;
  [[nodiscard]] bool add_logical(FramePlan& plan, const PassingDatagram& datagram, std::size_t number,
                                 std::size_t offset) const;
  [[nodiscard]] bool add_mapping(FramePlan& plan, const PassingDatagram& datagram, const FmmuUnit::Mapping& mapping,
                                 bool writing, std::size_t offset) const;

  const EscMemory& memory_;
  const SyncManagers& managers_;
  const FmmuUnit& fmmus_;
  const WriteProtection& protection_;
  const StationAddresses& addresses_;
  bool logical_read_write_;
};

}  // namespace syncline::sim
