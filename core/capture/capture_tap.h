// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "support/result.h"

namespace syncline {

class Clock;
class Link;

/// How a capture fares: written by the link's thread, read by any.
class CaptureState {
 public:
  /// The file is lost: writing failed, and the rest of the frames is not written. The link goes on.
  [[nodiscard]] bool failed() const { return failed_.load(std::memory_order_acquire); }
  /// Why, once it has failed. kFileNotWritable.
  [[nodiscard]] const Error& error() const { return error_; }
  void fail_with(Error error);

 private:
  Error error_;
  std::atomic<bool> failed_{false};
};

/// A Link around `inner` that writes every frame sent and received into a pcapng file; the file is
/// complete when the tap is destroyed and `state` (may be null) has not failed. Writing allocates: not for a cyclic
/// thread with a deadline.
[[nodiscard]] Result<std::unique_ptr<Link>> make_capture_tap(std::unique_ptr<Link> inner, const std::string& path,
                                                             Clock& clock,
                                                             std::shared_ptr<CaptureState> state = nullptr);

}  // namespace syncline
