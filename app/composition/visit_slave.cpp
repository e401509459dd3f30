// SPDX-License-Identifier: Apache-2.0
#include "app/composition/visit_slave.h"

#include <fmt/format.h>

#include "master/bus_scanner.h"

namespace syncline {

Status visit_slave(const VisitRequest& request, const std::function<Status(SlaveVisit&)>& work, bool keep_state) {
  auto opened = OpenBus::open(request.link, request.cancel);
  if (!opened) return tl::unexpected(opened.error());
  auto& bus = (*opened)->bus();
  const auto count = count_slaves(bus);
  if (!count) return tl::unexpected(count.error());
  if (request.position >= *count) {
    return fail(ErrorCode::kNoResponse, fmt::format("slave {} ({} slaves are there)", request.position, *count));
  }
  SlaveVisit visit(bus, request.position);
  if (auto status = visit.look(); !status) return status;
  const auto done = work(visit);
  if (keep_state) return done;
  const auto left = visit.leave();
  return done ? left : done;
}

}  // namespace syncline
