// SPDX-License-Identifier: Apache-2.0
#include "app/composition/scan_bus.h"

#include "app/composition/open_bus.h"

namespace syncline {

Result<BusScan> scan_bus(std::string_view link, const ScanRequest& request) {
  auto opened = OpenBus::open(link, request.cancel, request.capture);
  if (!opened) return tl::unexpected(opened.error());
  auto& bus = (*opened)->bus();
  const auto tell = [&](EventKind kind, std::size_t a, std::size_t b) {
    if (!request.on_event) return;
    Event event;
    event.kind = kind;
    event.time = bus.clock().now();
    event.a = static_cast<std::int64_t>(a);
    event.b = static_cast<std::int64_t>(b);
    request.on_event(event);
  };
  ScanObserver observer;
  observer.progress = [&](std::size_t done, std::size_t found) { tell(EventKind::kScanProgress, done, found); };
  observer.touching = [&](std::size_t running, std::size_t eeproms) {
    tell(EventKind::kScanTouchesRunning, running, eeproms);
  };
  auto found = scan_slaves(bus, request.options, observer);
  const auto capture = (*opened)->capture();
  opened->reset();  // completes it
  if (capture && capture->failed() && request.on_capture_lost) request.on_capture_lost(capture->error());
  return found;
}

}  // namespace syncline
