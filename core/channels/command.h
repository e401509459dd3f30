// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <variant>

#include "channels/watch_command.h"
#include "config/dcm_settings.h"
#include "config/network_config.h"
#include "protocol/al_state.h"

namespace syncline {

struct GoOnlineCommand {
  NetworkConfig config;
  AlState target = AlState::kOp;
};
struct GoOfflineCommand {};
struct RequestStateCommand {
  AlState state = AlState::kInit;
};
struct ClearStatisticsCommand {};
/// Parameters of the running master synchronisation; zeros leave what is. The mode cannot change while online: it is
/// part of the cyclic frames. Refused with events::Failure when a parameter is outside its range.
struct ConfigureDcmCommand {
  DcmSettings settings;
};
/// Forgets mean, rms and largest control error, and an error that is over.
struct ResetDcmStatusCommand {};
/// Continuous compensation of the propagation delays, on or off while the bus runs.
struct CompensateDelaysCommand {
  bool on = false;
};
/// Holds 1 to 64 bits of the outputs at a value, whatever the application calculates, until they are released or the
/// bus goes offline. `bit_offset`: in the process image, as Variable::bit_offset; bit 0 of `value` stands there.
struct ForceOutputCommand {
  std::uint32_t bit_offset = 0, bit_size = 0;
  std::uint64_t value = 0;
};
/// What the application calculates goes out again; without one, what it was before: 0.
struct ReleaseOutputCommand {
  std::uint32_t bit_offset = 0, bit_size = 0;
};
struct ReleaseAllOutputsCommand {};
using MasterCommand = std::variant<GoOnlineCommand, GoOfflineCommand, RequestStateCommand, ClearStatisticsCommand,
                                   ConfigureDcmCommand, ResetDcmStatusCommand, CompensateDelaysCommand,
                                   ForceOutputCommand, ReleaseOutputCommand, ReleaseAllOutputsCommand, WatchCommand>;

}  // namespace syncline
