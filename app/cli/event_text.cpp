// SPDX-License-Identifier: Apache-2.0
#include "app/cli/event_text.h"

#include <fmt/format.h>

#include "app/cli/run_json.h"
#include "protocol/error_text.h"

namespace syncline::cli {
namespace {

std::string who(int slave) { return slave < 0 ? "master" : fmt::format("slave {}", slave); }

std::string_view state_name(std::int64_t state) { return al_state_name(static_cast<AlState>(state & 0x0F)); }

std::string words(const Event& e) {
  switch (e.kind) {
    case EventKind::kScanProgress: return {};
    case EventKind::kScanFinished: return "scan finished";
    case EventKind::kOnline: return "online";
    case EventKind::kOffline: return "offline";
    case EventKind::kStateChanged: return fmt::format("{}: {} -> {}", who(e.slave), state_name(e.a), state_name(e.b));
    case EventKind::kAlStatusError: {
      const auto text = al_status_code_text(static_cast<std::uint16_t>(e.b));
      return fmt::format("{}: {} with AL status code 0x{:04x}: {}. {}", who(e.slave),
                         state_text(static_cast<std::uint16_t>(e.a)), e.b, text.meaning, text.check);
    }
    case EventKind::kDcInitialised: return fmt::format("distributed clocks initialised: {} slaves, reference clock is slave {}", e.a, e.b);
    case EventKind::kReferenceClock: return fmt::format("reference clock {}: {}", who(e.slave), e.a != 0 ? "present" : "LOST");
    case EventKind::kDcSlaveSync:
      if (e.a == 2) return "slaves not monitored";
      return e.a != 0 ? fmt::format("slaves in sync, deviation {} ns", e.b)
                      : fmt::format("slaves OUT OF SYNC, deviation {} ns{}", e.b, e.slave < 0 ? "" : " at " + who(e.slave));
    case EventKind::kDcmSync: return fmt::format("master {}, error {} ns", e.a != 0 ? "in sync" : "OUT OF SYNC", e.b);
    case EventKind::kDcmError: return fmt::format("DCM error 0x{:08x}, drift {} ppm", e.a, e.b);
    case EventKind::kWkcError: return fmt::format("working counter {} instead of {} ({} times)", e.b, e.a, e.c);
    case EventKind::kFramesLost: return fmt::format("{} frames lost", e.a);
    case EventKind::kSlaveLost: return fmt::format("{} does not answer", who(e.slave));
    case EventKind::kSlaveFound: return fmt::format("{} answers again", who(e.slave));
    case EventKind::kEmergency: return fmt::format("{}: emergency 0x{:04x}, error register 0x{:02x}", who(e.slave), e.a, e.b);
    case EventKind::kRealTime: return "real time: " + e.text;
    case EventKind::kError: return e.error ? describe(*e.error) : e.text;
    case EventKind::kEventsLost: return fmt::format("{} events were lost", e.a);
    default: return e.text;
  }
}

}  // namespace

std::string event_text(const Event& event, Nanoseconds start) {
  const auto text = words(event);
  if (text.empty()) return {};
  return fmt::format("{:>10.3f} s  {}", static_cast<double>(event.time - start) / 1e9, text);
}

}  // namespace syncline::cli
