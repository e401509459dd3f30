// SPDX-License-Identifier: Apache-2.0
#include "link/link.h"

#include "reasons/because.h"

namespace syncline {

Result<Nanoseconds> Link::send_corrected(std::span<const std::uint8_t>, const SendTimeField&) {
  return fail(ErrorCode::kNotSupported, describe().name, because("it cannot put its send time into frames"));
}

}  // namespace syncline
