// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "protocol/registers.h"
#include "sim/registers/esc_memory.h"
#include "support/types.h"

namespace syncline::sim {

/// Ports of an ESC: physical links, loop control 0x0100, DL status 0x0110 and the error counters 0x0300 to
/// 0x0313 (ESC data sheet I, 3.2 and chapter 14). A closed port is not passed; one that is held open without
/// a link swallows frames.
class EscPorts {
 public:
  static constexpr unsigned kCount = 4;

  explicit EscPorts(EscMemory& memory);

  void implement_registers() {
    memory_.implement(reg::kDlControl, 4, EscMemory::kReadWrite);
    memory_.implement(reg::kDlStatus, 2, EscMemory::kRead);
    memory_.implement(reg::kRxErrorCounter, 0x0E, EscMemory::kReadWrite);
    memory_.implement(reg::kLostLinkCounter, 4, EscMemory::kReadWrite);
  }
  void set_link(unsigned port, bool up);
  /// 0x0100 was written: loop control, and whether it is for one second only.
  void control_written(Nanoseconds time);
  /// A valid frame came to a port whose loop is closed: a port in "auto close" opens.
  void frame_at_closed_port(unsigned port);
  /// The temporary setting of 0x0100 ends.
  void advance_to(Nanoseconds time);
  /// When it does; the end of time: there is none.
  [[nodiscard]] Nanoseconds due() const { return temporary_until_.value_or(INT64_MAX); }

  [[nodiscard]] bool link(unsigned port) const { return link_[port]; }
  [[nodiscard]] bool open(unsigned port) const { return open_[port]; }
  /// Frames turn round at port 0 because its link is gone, not because somebody closed it.
  [[nodiscard]] bool port0_automatically_closed() const { return !open_[0] && control(0) <= Control::kAutoClose; }
  /// Destroys what is no EtherCAT frame and marks the source address of the others (0x0100.0).
  [[nodiscard]] bool destroys_foreign_frames() const { return (memory_.u8(reg::kDlControl) & 0x01) != 0; }
  /// True once after a change of which ports are open.
  [[nodiscard]] bool take_changed() {
    const bool changed = changed_;
    changed_ = false;
    return changed;
  }
  [[nodiscard]] bool changed() const { return changed_; }

  void count_invalid_frame(unsigned port);
  void count_forwarded_error(unsigned port);
  void count_processing_unit_error();

 private:
  enum class Control : std::uint8_t { kAuto = 0, kAutoClose = 1, kOpen = 2, kClosed = 3 };
  [[nodiscard]] Control control(unsigned port) const;
  void update(unsigned port, bool open);
  void write_status();

  EscMemory& memory_;
  std::array<bool, kCount> link_{}, open_{};
  bool changed_ = false;
  std::uint32_t permanent_control_;
  std::optional<Nanoseconds> temporary_until_;
};

}  // namespace syncline::sim
