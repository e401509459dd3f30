// SPDX-License-Identifier: Apache-2.0
#include "app/composition/open_bus.h"

#include <utility>

#include "app/composition/capture_file.h"

namespace syncline {

OpenBus::OpenBus(OpenedLink opened, const std::atomic<bool>* cancel)
    : opened_(std::move(opened)), exchange_(*opened_.link, *opened_.clock), bus_(exchange_, *opened_.clock, cancel) {
  exchange_.set_addresses({0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}, opened_.link->describe().mac);
}

Result<std::unique_ptr<OpenBus>> OpenBus::open(std::string_view link, const std::atomic<bool>* cancel,
                                               const std::string& capture) {
  auto opened = open_link(link);
  if (!opened) return tl::unexpected(opened.error());
  if (auto status = capture_to(capture, *opened); !status) return tl::unexpected(status.error());
  return std::unique_ptr<OpenBus>(new OpenBus(std::move(*opened), cancel));
}

}  // namespace syncline
