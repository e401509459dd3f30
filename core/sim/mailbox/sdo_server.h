// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "protocol/coe.h"
#include "sim/objects/object_dictionary.h"

namespace syncline::sim {

/// SDO server of a slave: expedited, normal and segmented transfers in both directions, single entries and
/// complete access (ETG.1000.6, 5.6.2). One transfer at a time; a new request ends the one under way.
class SdoServer {
 public:
  struct Options {
    bool complete_access = false;
  };
  SdoServer(ObjectDictionary& dictionary, Options options) : dictionary_(dictionary), options_(options) {}

  /// `mailbox_size`: of the send mailbox. `in_preop`: objects that configure may be written.
  coe::Response respond(const coe::Request& request, std::size_t mailbox_size, bool in_preop);
  void reset() { transfer_.reset(); }

 private:
  struct Transfer {
    coe::ObjectAddress object;
    bool complete_access = false;
    std::vector<std::uint8_t> data;
    std::size_t position = 0, size = 0;
    bool toggle = false, download = false;
  };
  coe::Response upload(const coe::UploadRequest& request);
  coe::Response upload_segment(const coe::UploadSegmentRequest& request);
  coe::Response download(const coe::DownloadRequest& request);
  coe::Response download_segment(const coe::DownloadSegmentRequest& request);
  std::uint32_t store(const Transfer& transfer);
  /// An abort code when complete access is not possible like this, or 0.
  [[nodiscard]] std::uint32_t check_complete_access(const coe::ObjectAddress& object) const;

  ObjectDictionary& dictionary_;
  Options options_;
  std::optional<Transfer> transfer_;
  std::size_t mailbox_size_ = 0;
  bool in_preop_ = false;
};

}  // namespace syncline::sim
