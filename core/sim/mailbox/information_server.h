// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "protocol/sdo_information.h"
#include "sim/objects/object_dictionary.h"

namespace syncline::sim {

/// Answers SDO information requests from an object dictionary (ETG.1000.6, 5.6.3).
class InformationServer {
 public:
  explicit InformationServer(ObjectDictionary& dictionary) : dictionary_(dictionary) {}
  [[nodiscard]] coe::InformationResponse respond(const coe::InformationRequest& request);

 private:
  [[nodiscard]] std::vector<std::uint16_t> list(coe::ObjectListType type);
  coe::InformationResponse object_list(coe::ObjectListType type);
  coe::InformationResponse object(std::uint16_t index);
  coe::InformationResponse entry(const coe::EntryDescriptionRequest& request);

  ObjectDictionary& dictionary_;
};

}  // namespace syncline::sim
