// SPDX-License-Identifier: Apache-2.0
#include "support/brief_error.h"

#include <utility>

namespace syncline {

Error BriefError::about(std::string subject) const {
  Error error{code, std::move(subject), why.in_full()};
  error.expected = expected;
  error.received = received;
  error.extra = extra;
  return error;
}

}  // namespace syncline
