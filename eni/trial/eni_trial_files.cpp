// SPDX-License-Identifier: Apache-2.0
#include "eni/trial/eni_trial_files.h"

#include <utility>

#include "config/network_config.h"
#include "engine/trial_files.h"
#include "eni/check/eni_check.h"
#include "eni/esi/esi_reader.h"
#include "eni/format/eni_file.h"

namespace syncline::eni {
namespace {

class EniTrialFiles final : public TrialFiles {
 public:
  [[nodiscard]] Result<TrialDevices> read_devices(const std::string& path) const override {
    auto file = read_esi(path);
    if (!file) return tl::unexpected(file.error());
    return TrialDevices{std::move(file->devices), std::move(file->rejected)};
  }
  [[nodiscard]] std::string eni_of(const NetworkConfig& config) const override { return write_eni(config); }
  [[nodiscard]] Status save_eni(const NetworkConfig& config, const std::string& path) const override {
    return eni::save_eni(config, path);
  }
  [[nodiscard]] Result<NetworkConfig> read_eni(const std::string& text, const std::string& name) const override {
    return parse_eni(text, name);
  }
  [[nodiscard]] Result<std::vector<Finding>> check_eni(const std::string& text,
                                                       const std::string& name) const override {
    auto check = check_eni_text(text, name);
    if (!check) return tl::unexpected(check.error());
    return std::move(check->findings);
  }
};

}  // namespace

const TrialFiles& trial_files() {
  static const EniTrialFiles kFiles;
  return kFiles;
}

}  // namespace syncline::eni
