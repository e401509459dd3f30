// SPDX-License-Identifier: Apache-2.0
#include "app/composition/scan_bus.h"

#include "app/composition/open_link.h"
#include "master/master_service.h"

namespace syncline {

Result<BusScan> scan_bus(std::string_view link, const std::function<void(const Event&)>& on_event) {
  auto opened = open_link(link);
  if (!opened) return tl::unexpected(opened.error());
  MasterService service(std::move(opened->link), *opened->clock);
  service.channels().commands.push(ScanCommand{});
  while (service.step()) {
    for (const auto& event : service.channels().events.drain()) {
      if (on_event) on_event(event);
      if (event.kind == EventKind::kScanFinished && event.scan) return *event.scan;
      if (event.kind == EventKind::kError && event.error) return tl::unexpected(*event.error);
    }
  }
  return fail(ErrorCode::kNoResponse, std::string(link));
}

}  // namespace syncline
