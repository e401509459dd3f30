// SPDX-License-Identifier: Apache-2.0
#include "engine/scan_bus.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "channels/event.h"
#include "engine/open_bus.h"
#include "findings/scan_words.h"
#include "findings/sentence.h"
#include "reasons/because.h"

namespace syncline {
namespace {

/// What the scan found in a capture and what it only seems to have found.
void mark_unknown(BusScan& scan, const ReplayNotes& notes, const std::string& file) {
  for (auto& slave : scan.slaves) {
    if (slave.position >= notes.slaves.size()) continue;
    const auto& note = notes.slaves[slave.position];
    slave.unknown = {!note.vendor_id, !note.product_code, !note.revision_no, !note.serial_no,
                     !note.alias,     !note.state,        !note.ports,       !note.dc};
    if (slave.sii_error) {
      slave.sii_error = Error{ErrorCode::kScanScope, fmt::format("slave {}", slave.position),
                              because("its EEPROM, of which the capture holds {words} words", note.sii_words)};
    }
  }
  // Of wiring that nobody recorded nothing can be wrong.
  const bool no_ports = std::ranges::any_of(notes.slaves, [](const auto& note) { return !note.ports; });
  if (no_ports)
    std::erase_if(scan.findings, [](const Finding& finding) { return finding.code.starts_with("scan-wiring-"); });
  if (notes.cut_frames > 0) {
    scan.findings.push_back(make_finding<words::kScan>("scan-frames-cut", {}, fig::text<"file">(file),
                                                       fig::count<"cut">(notes.cut_frames),
                                                       fig::count<"frames">(notes.frames)));
  }
  if (notes.broken_off) {
    scan.findings.push_back(make_finding<words::kScan>("scan-capture-broken-off", {}, fig::text<"file">(file),
                                                       fig::count<"frames">(notes.frames),
                                                       fig::reason<"reason">(notes.broken_off->detail)));
  }
}

}  // namespace

Result<BusScan> scan_bus(Result<OpenedLink> link, const ScanRequest& request) {
  const auto file = link ? link->link->describe().name : std::string();
  auto opened = OpenBus::open(std::move(link), request.cancel, request.capture);
  if (!opened) return tl::unexpected(opened.error());
  auto& bus = (*opened)->bus();
  const auto tell = [&](EventDetails what) {
    if (request.on_event) request.on_event({bus.clock().now(), -1, std::move(what)});
  };
  ScanObserver observer;
  observer.progress = [&](std::size_t done, std::size_t found) { tell(events::ScanProgress{done, found}); };
  observer.touching = [&](std::size_t running, std::size_t eeproms) {
    tell(events::ScanTouchesRunning{running, eeproms});
  };
  auto found = scan_slaves(bus, request.options, observer);
  if (const auto notes = (*opened)->replay(); found && notes) mark_unknown(*found, *notes, file);
  const auto capture = (*opened)->capture();
  opened->reset();  // completes it
  if (capture && capture->failed() && request.on_capture_lost) request.on_capture_lost(capture->error());
  return found;
}

}  // namespace syncline
