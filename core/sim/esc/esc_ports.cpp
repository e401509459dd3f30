// SPDX-License-Identifier: Apache-2.0
#include "sim/esc/esc_ports.h"

#include "protocol/dl_status.h"
#include "protocol/registers.h"
#include "sim/esc/esc_events.h"
#include "sim/registers/esc_memory.h"

namespace syncline::sim {
namespace {

constexpr std::uint32_t kResetControl = 0x0007'0001;  // largest FIFO, forwarding rule on, all loops auto
constexpr std::uint32_t kTemporary = 0x0000'0002;
constexpr Nanoseconds kTemporaryTime = kSecond;
constexpr unsigned kNotPorts = 0x000F;

}  // namespace

EscPorts::EscPorts(EscMemory& memory) : memory_(memory), permanent_control_(kResetControl) {
  memory_.set<std::uint32_t>(reg::kDlControl, kResetControl);
  memory_.set<std::uint16_t>(reg::kDlStatus, 0x5503);  // EEPROM loaded, PDI watchdog fine, loops closed
}

EscPorts::Control EscPorts::control(unsigned port) const {
  return static_cast<Control>((memory_.u8(reg::kDlControlLoop) >> (2 * port)) & 0x03U);
}

void EscPorts::set_link(unsigned port, bool up) {
  if (link_[port] == up) return;
  link_[port] = up;
  const auto mode = control(port);
  if (!up && open_[port] && mode <= Control::kAutoClose) {
    memory_.count(static_cast<std::uint16_t>(reg::kLostLinkCounter + port));
  }
  update(port, mode == Control::kOpen || (up && mode == Control::kAuto));  // "auto close" waits to be opened
}

void EscPorts::control_written(Nanoseconds time) {
  const auto written = memory_.u32(reg::kDlControl);
  temporary_until_.reset();
  if ((written & kTemporary) != 0) {
    temporary_until_ = time + kTemporaryTime;
  } else {
    permanent_control_ = written;
  }
  for (unsigned port = 0; port < kCount; ++port) {
    const auto mode = control(port);
    update(port, mode == Control::kOpen || (mode != Control::kClosed && link_[port]));
  }
}

void EscPorts::frame_at_closed_port(unsigned port) {
  if (control(port) == Control::kAutoClose && link_[port]) update(port, true);
}

void EscPorts::advance_to(Nanoseconds time) {
  if (!temporary_until_ || time < *temporary_until_) return;
  memory_.set<std::uint32_t>(reg::kDlControl, permanent_control_);
  control_written(*temporary_until_);
}

void EscPorts::update(unsigned port, bool open) {
  changed_ = changed_ || open_[port] != open;
  open_[port] = open;
  write_status();
}

void EscPorts::write_status() {
  const auto before = memory_.u16(reg::kDlStatus);
  unsigned status = before & kNotPorts;
  for (unsigned port = 0; port < kCount; ++port) {
    if (link_[port]) status |= 1U << (4 + port);
    status |= (open_[port] ? (link_[port] ? 2U : 0U) : 1U) << (8 + 2 * port);
  }
  if (status == before) return;
  memory_.set<std::uint16_t>(reg::kDlStatus, static_cast<std::uint16_t>(status));
  const auto request = memory_.u16(reg::kEcatEventRequest) | esc_events::kEventDlStatus;
  memory_.set<std::uint16_t>(reg::kEcatEventRequest, static_cast<std::uint16_t>(request));
}

void EscPorts::count_invalid_frame(unsigned port) {
  memory_.count(static_cast<std::uint16_t>(reg::kRxErrorCounter + 2 * port));
  memory_.count(static_cast<std::uint16_t>(reg::kRxErrorCounter + 2 * port + 1));  // a bad symbol is both
}

void EscPorts::count_forwarded_error(unsigned port) {
  memory_.count(static_cast<std::uint16_t>(reg::kForwardedErrorCounter + port));
}

void EscPorts::count_processing_unit_error() { memory_.count(reg::kProcessingUnitErrorCounter); }

}  // namespace syncline::sim
