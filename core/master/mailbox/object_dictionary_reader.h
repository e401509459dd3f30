// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "master/mailbox/sdo_info_client.h"

namespace syncline {

/// One object of a device with its entries, in the device's own words.
struct DictionaryObject {
  coe::ObjectDescription object;
  std::vector<coe::EntryDescription> entries;  // those that the device describes, ascending
  std::optional<Error> error;                  // the device lists the object but does not describe it
};

/// Reads a device's whole dictionary by SDO information. An object or entry that the device refuses to describe is
/// noted or left out; what ends the reading are a dead mailbox, a lying device and the user.
class ObjectDictionaryReader {
 public:
  using Progress = std::function<void(std::size_t done, std::size_t all)>;

  explicit ObjectDictionaryReader(MailboxClient& mailbox, Progress progress = {})
      : client_(mailbox), progress_(std::move(progress)) {}

  Result<std::vector<DictionaryObject>> read(coe::ObjectListType list = coe::ObjectListType::kAll);
  Result<DictionaryObject> read_object(std::uint16_t index);

 private:
  SdoInfoClient client_;
  Progress progress_;
};

}  // namespace syncline
