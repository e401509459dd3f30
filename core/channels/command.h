// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

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
using MasterCommand = std::variant<GoOnlineCommand, GoOfflineCommand, RequestStateCommand, ClearStatisticsCommand,
                                   ConfigureDcmCommand, ResetDcmStatusCommand, CompensateDelaysCommand>;

}  // namespace syncline
