// SPDX-License-Identifier: Apache-2.0
#include "engine/visit_slave.h"

#include <utility>

#include "engine/open_bus.h"
#include "master/startup/slave_visit.h"

namespace syncline {

Status visit_slave(Result<OpenedLink> link, const VisitRequest& request, const std::function<Status(SlaveVisit&)>& work,
                   bool keep_state) {
  auto opened = OpenBus::open_for_slave(std::move(link), request.position, request.cancel);
  if (!opened) return tl::unexpected(opened.error());
  auto& bus = (*opened)->bus();
  SlaveVisit visit(bus, request.position);
  if (auto status = visit.look(); !status) return status;
  Status done;
  try {
    done = work(visit);
  } catch (...) {
    (void)visit.leave();
    throw;
  }
  if (keep_state && done) return done;
  auto left = visit.leave();
  if (done) return left;
  if (!left && request.on_left) request.on_left(left.error());
  return done;
}

}  // namespace syncline
