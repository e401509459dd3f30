// SPDX-License-Identifier: Apache-2.0
#include "engine/capture_file.h"

#include <utility>

#include "capture/capture_tap.h"
#include "engine/opened_link.h"

namespace syncline {

Result<std::shared_ptr<const CaptureState>> capture_to(const std::string& file, OpenedLink& opened) {
  if (file.empty()) return std::shared_ptr<const CaptureState>();
  auto state = std::make_shared<CaptureState>();
  auto tap = make_capture_tap(std::move(opened.link), file, *opened.clock, state);
  if (!tap) return tl::unexpected(tap.error());
  opened.link = std::move(*tap);
  return state;
}

}  // namespace syncline
