// SPDX-License-Identifier: Apache-2.0
#include "record/recorded_configuration.h"

#include <utility>

#include "record/recording.h"

namespace syncline {

NetworkConfig recorded_configuration(const RecordingAbout& about, const ConfigurationParser& parse) {
  for (const auto& document : about.documents) {
    if (document.kind != "configuration") continue;
    auto config = parse(document.body, document.name);
    if (config && config->slaves.size() == about.slaves.size()) return std::move(*config);
  }
  NetworkConfig config;
  for (const auto& slave : about.slaves) {
    auto& configured = config.slaves.emplace_back();
    configured.name = slave.name;
    configured.identity = {slave.vendor_id, slave.product_code, slave.revision_no, 0};
  }
  return config;
}

}  // namespace syncline
