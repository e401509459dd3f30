// SPDX-License-Identifier: Apache-2.0
#include "engine/open_bus.h"

#include <fmt/format.h>

#include <utility>

#include "engine/capture_file.h"
#include "master/scan/bus_scanner.h"

namespace syncline {

OpenBus::OpenBus(OpenedLink opened, std::shared_ptr<const CaptureState> capture, const std::atomic<bool>* cancel)
    : capture_(std::move(capture)),
      opened_(std::move(opened)),
      exchange_(*opened_.link, *opened_.clock),
      bus_(exchange_, *opened_.clock, cancel) {
  if (!opened_.clock->is_virtual()) driven_.emplace();
  exchange_.set_addresses({0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}, opened_.link->describe().mac);
}

Result<std::unique_ptr<OpenBus>> OpenBus::open(Result<OpenedLink> link, const std::atomic<bool>* cancel,
                                               const std::string& capture) {
  if (!link) return tl::unexpected(link.error());
  auto state = capture_to(capture, *link);
  if (!state) return tl::unexpected(state.error());
  return std::unique_ptr<OpenBus>(new OpenBus(std::move(*link), std::move(*state), cancel));
}

Result<std::unique_ptr<OpenBus>> OpenBus::open_for_slave(Result<OpenedLink> link, std::uint16_t position,
                                                         const std::atomic<bool>* cancel) {
  auto opened = open(std::move(link), cancel);
  if (!opened) return opened;
  const auto count = count_slaves((*opened)->bus());
  if (!count) return tl::unexpected(count.error());
  if (position >= *count) {
    return fail(ErrorCode::kNoResponse, fmt::format("slave {} ({} slaves are there)", position, *count));
  }
  return opened;
}

}  // namespace syncline
