// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>

#include "support/result.h"

namespace syncline {

struct OpenedLink;
class SlaveVisit;

/// A slave on a bus, for work that needs no configuration.
struct VisitRequest {
  std::uint16_t position = 0;
  const std::atomic<bool>* cancel = nullptr;
  std::function<void(const Error&)> on_left{};  // the slave could not be left as it was found, and the work failed, too
};

/// Looks at the slave, does `work`, and leaves the slave as it was found unless `keep_state`.
/// When the work fails, or throws, or keep_state is not reached, it is left as it was found, too. The first error
/// counts. kNoResponse when there is no such slave.
[[nodiscard]] Status visit_slave(Result<OpenedLink> link, const VisitRequest& request,
                                 const std::function<Status(SlaveVisit&)>& work, bool keep_state = false);

}  // namespace syncline
