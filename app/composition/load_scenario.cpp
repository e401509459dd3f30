// SPDX-License-Identifier: Apache-2.0
#include "app/composition/load_scenario.h"

#include <map>

#include "eni/esi_reader.h"
#include "sim/scenario_loader.h"

namespace syncline {
namespace {

/// Reads each ESI file once however many devices of it a scenario names.
class EsiDeviceSource {
 public:
  Result<DeviceDescription> operator()(const std::string& path, const std::string& type) {
    auto found = files_.find(path);
    if (found == files_.end()) {
      auto file = eni::read_esi(path);
      if (!file) return tl::unexpected(file.error());
      found = files_.emplace(path, std::move(*file)).first;
    }
    const auto& devices = found->second.devices;
    const DeviceDescription* match = nullptr;
    for (const auto& device : devices) {
      if (!type.empty() && device.type != type) continue;
      if (match == nullptr || device.identity.revision_no > match->identity.revision_no) match = &device;
    }
    if (match == nullptr) {
      return fail(ErrorCode::kUnknownDevice, type.empty() ? path : type, "not in " + path);
    }
    return *match;
  }

 private:
  std::map<std::string, eni::EsiFile> files_;
};

}  // namespace

Result<SimConfig> load_scenario_file(const std::string& path) {
  EsiDeviceSource source;
  return sim::load_scenario(
      path, [&source](const std::string& esi, const std::string& type) { return source(esi, type); });
}

}  // namespace syncline
