// SPDX-License-Identifier: Apache-2.0
#include "master/startup/hot_connect.h"

#include <utility>

#include "config/network_config.h"
#include "master/exchange/bus.h"
#include "master/exchange/slave_batch.h"
#include "master/scan/bus_match.h"
#include "master/startup/bus_survey.h"
#include "master/startup/init_cmd_runner.h"

namespace syncline {
namespace {

/// kCancelled and errors of the bus end all; anything else says that it is another device.
Result<bool> answers_as(Bus& bus, const std::vector<InitCmd>& commands, std::uint16_t position) {
  std::vector<const InitCmd*> list;
  for (const auto& command : commands) list.push_back(&command);
  InitCmdContext context{{}, init_cmd_pause(bus), Position{position}.auto_increment_address(), {}};
  InitCmdWork work(std::move(list), std::move(context));
  SlaveWork* const works[] = {&work};
  if (auto status = run_side_by_side(bus, works); !status) return tl::unexpected(status.error());
  return work.result().has_value();
}

}  // namespace

Status identify_groups(Bus& bus, const NetworkConfig& config, std::vector<FoundDevice>& devices,
                       const std::function<bool(std::uint16_t)>& known) {
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    const auto& group = config.slaves[i].hot_connect;
    if (!group || group->alias() || group->identify_cmds.empty()) continue;
    const auto wanted = wanted_device(config, i);
    for (std::size_t position = 0; position < devices.size(); ++position) {
      auto& device = devices[position];
      if (device.identified_as || (known && known(device.station_address)) || !is_same_device(wanted, device)) continue;
      const auto answers = answers_as(bus, group->identify_cmds, static_cast<std::uint16_t>(position));
      if (!answers) return tl::unexpected(answers.error());
      if (*answers) device.identified_as = static_cast<std::uint16_t>(i);
    }
  }
  return {};
}

}  // namespace syncline
