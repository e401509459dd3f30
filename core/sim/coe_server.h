// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "protocol/coe.h"
#include "protocol/mailbox.h"
#include "sim/object_dictionary.h"

namespace syncline::sim {

/// The slave's side of the mailbox: CoE SDO server on an object dictionary; other protocols get the
/// mailbox error "unsupported protocol".
class CoeServer {
 public:
  explicit CoeServer(ObjectDictionary& dictionary) : dictionary_(dictionary) {}
  /// Answers one mailbox message; nothing for a repeated one. `mailbox_size` of the send mailbox.
  std::optional<MailboxMessage> answer(const MailboxMessage& request, std::size_t mailbox_size, bool in_preop);
  void reset();

 private:
  struct Segmented {
    coe::ObjectAddress object;
    std::vector<std::uint8_t> data;
    std::size_t position = 0, size = 0;
    bool toggle = false, download = false;
  };
  coe::Response respond(const coe::Request& request);
  coe::Response upload(const coe::UploadRequest& request);
  coe::Response upload_segment(const coe::UploadSegmentRequest& request);
  coe::Response download(const coe::DownloadRequest& request);
  coe::Response download_segment(const coe::DownloadSegmentRequest& request);
  coe::Response store(const coe::ObjectAddress& object, std::span<const std::uint8_t> data);

  ObjectDictionary& dictionary_;
  std::optional<Segmented> transfer_;
  std::size_t mailbox_size_ = 0;
  bool in_preop_ = false;
  std::uint8_t last_counter_ = 0, counter_ = 0;
};

}  // namespace syncline::sim
