// SPDX-License-Identifier: Apache-2.0
#include "app/composition/load_scenario.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>

#include "config/device_from_sii.h"
#include "config/project.h"
#include "config/sim_config.h"
#include "eni/esi/esi_reader.h"
#include "eni/format/eni_file.h"
#include "eni/project/project_file.h"
#include "eni/xml/xml_text.h"
#include "protocol/sii.h"
#include "reasons/because.h"
#include "recover/simulated_network.h"
#include "sim/scenario/scenario_loader.h"

namespace syncline {
namespace {

/// Reads each file once however many devices of it a scenario names.
class DeviceFiles {
 public:
  Result<sim::ScenarioDevice> operator()(const sim::DeviceQuery& query) {
    files_.insert(query.path);
    return query.kind == sim::DeviceQuery::Kind::kSii ? from_sii(query) : from_esi(query);
  }
  [[nodiscard]] const std::set<std::string>& files() const { return files_; }

 private:
  Result<sim::ScenarioDevice> from_esi(const sim::DeviceQuery& query) {
    auto found = esi_.find(query.path);
    if (found == esi_.end()) {
      auto file = eni::read_esi(query.path);
      if (!file) return tl::unexpected(file.error());
      found = esi_.emplace(query.path, std::move(*file)).first;
    }
    const DeviceDescription* match = nullptr;
    for (const auto& device : found->second.devices) {
      if (!query.type.empty() && device.type != query.type) continue;
      if (query.product_code && device.identity.product_code != *query.product_code) continue;
      if (query.revision_no && device.identity.revision_no != *query.revision_no) continue;
      if (match == nullptr || device.identity.revision_no > match->identity.revision_no) match = &device;
    }
    if (match == nullptr) {
      return fail(ErrorCode::kUnknownDevice, wanted(query), because("not in {file}", query.path));
    }
    return sim::ScenarioDevice{*match, {}};
  }

  static std::string wanted(const sim::DeviceQuery& query) {
    auto text = query.type.empty() ? std::string("device") : query.type;
    if (query.product_code) text += fmt::format(" product code 0x{:08X}", *query.product_code);
    if (query.revision_no) text += fmt::format(" revision 0x{:08X}", *query.revision_no);
    return text;
  }

  static Result<sim::ScenarioDevice> from_sii(const sim::DeviceQuery& query) {
    const auto bytes = eni::read_file(query.path);
    if (!bytes) return tl::unexpected(bytes.error());
    sim::ScenarioDevice found;
    found.sii_image.assign(bytes->begin(), bytes->end());
    const auto image = sii::decode(found.sii_image);
    if (!image) {
      auto error = image.error();
      error.file = query.path;
      return tl::unexpected(error);
    }
    found.device = device_from_sii(*image);
    found.device.identity.serial_no = image->serial_no;
    if (!query.type.empty() && query.type != found.device.type) {
      return fail(ErrorCode::kUnknownDevice, query.type,
                  because("{file} is the EEPROM of {device}", query.path, found.device.type));
    }
    return found;
  }

  std::map<std::string, eni::EsiFile> esi_;
  std::set<std::string> files_;
};

/// Scenarios are TOML; what is XML says by its root element what it is.
bool describes_network(const std::string& path) {
  const auto extension = std::filesystem::path(path).extension();
  return extension == ".xml" || extension == ".syncline";
}

/// The bus that a project or an ENI describes.
Result<SimConfig> simulated_file(const std::string& path, const std::string& network) {
  const auto project = eni::load_project(path, network);
  if (project) return simulated_network(*project);
  if (project.error().code != ErrorCode::kNotThatKindOfFile) return tl::unexpected(project.error());
  const auto config = eni::read_eni(path);
  if (!config) return tl::unexpected(config.error());
  if (config->slaves.empty()) {
    return fail(
        Error{.code = ErrorCode::kBadValue, .subject = path, .detail = because("it has no slaves to simulate")});
  }
  return simulated_network(*config);
}

}  // namespace

Result<SimConfig> load_scenario_file(const std::string& path) {
  if (describes_network(path)) return simulated_file(path, "");
  DeviceFiles files;
  auto config = sim::load_scenario(path, [&files](const sim::DeviceQuery& query) { return files(query); });
  if (config) config->files.insert(config->files.end(), files.files().begin(), files.files().end());
  return config;
}

Result<SimConfig> load_network(const std::string& path, unsigned network, const std::optional<std::uint64_t>& seed) {
  const bool is_project = std::filesystem::path(path).extension() == ".syncline";
  auto config = is_project ? simulated_file(path, std::to_string(network)) : load_scenario_file(path);
  if (!config) return config;
  if (seed) config->seed = *seed;
  if (is_project) return config;
  if (network >= config->networks) {
    return fail(ErrorCode::kBadValue, fmt::format("network={}", network),
                because("{file} has {count}, counted from 0", path, config->networks));
  }
  return config->of_network(network);
}

}  // namespace syncline
