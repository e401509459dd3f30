// SPDX-License-Identifier: Apache-2.0
#include "master/master_service.h"

#include <exception>
#include <utility>

#include "master/cyclic/acyclic_requests.h"
#include "master/exchange/frame_tap.h"
#include "master/operation.h"
#include "reasons/because.h"
#include "support/real_time.h"

namespace syncline {
namespace {

constexpr MacAddress kBroadcastMac{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};

}  // namespace

struct MasterService::Impl {
  Impl(std::unique_ptr<Link> own_link, Clock& own_clock)
      : clock(own_clock),
        link(make_frame_tap(std::move(own_link), own_clock, channels.frames)),
        exchange(*link, own_clock) {}

  void execute(GoOnlineCommand& command);
  void execute(const GoOfflineCommand&);
  void execute(const RequestStateCommand& command);
  void execute(const ClearStatisticsCommand&);
  void execute(const ConfigureDcmCommand& command);
  void execute(const ResetDcmStatusCommand&);
  void execute(const CompensateDelaysCommand& command);
  void execute(const ForceOutputCommand& command);
  void execute(const ReleaseOutputCommand& command);
  void execute(const ReleaseAllOutputsCommand&);
  void execute(const WatchCommand& command);
  bool step();
  void publish_latest();
  void bind_thread(const RealTimeSettings& settings);
  void run_cycle();
  void go_offline();
  void tell(EventDetails what);
  void tell(const Error& error) { tell(events::Failure{error}); }

  Clock& clock;
  MasterChannels channels;
  std::unique_ptr<Link> link;
  FrameExchange exchange;
  std::unique_ptr<Operation> operation;
  DcStartTimeCallback start_time;
  WatchCommand watch;  // the last one
};

void MasterService::Impl::tell(EventDetails what) { channels.events.push({clock.now(), -1, std::move(what)}); }

/// The thread that executes the command is the one that runs the cycle.
void MasterService::Impl::bind_thread(const RealTimeSettings& settings) {
  if (clock.is_virtual() || !settings.cpu) return;
  if (auto refused = bind_to_processor(*settings.cpu); !refused.empty())
    tell(events::RealTimeRefused{std::move(refused)});
}

void MasterService::Impl::execute(GoOnlineCommand& command) {
  if (operation) go_offline();
  bind_thread(command.config.real_time);
  operation = std::make_unique<Operation>(std::move(command.config), exchange, clock, channels);
  operation->set_start_time(start_time);
  operation->watch(watch);
  const auto status = operation->start(command.target);
  if (!status) tell(status.error());
  const bool cancelled = !status && status.error().code == ErrorCode::kCancelled;
  if (!status && (cancelled || !operation->cyclic())) return go_offline();
  // A bus that did not come all the way up stays online, to be looked at.
  tell(events::Online{});
}

void MasterService::Impl::execute(const GoOfflineCommand&) { go_offline(); }

void MasterService::Impl::go_offline() {
  if (operation) operation->stop();
  operation.reset();
  tell(events::Offline{});
}

void MasterService::Impl::execute(const RequestStateCommand& command) {
  if (!operation) return tell(Error{ErrorCode::kConfiguration, "state request", because("the bus is offline")});
  if (auto status = operation->change_to(command.state); !status) tell(status.error());
}

void MasterService::Impl::execute(const ClearStatisticsCommand&) {
  if (operation) operation->clear_statistics();
}

void MasterService::Impl::execute(const ConfigureDcmCommand& command) {
  if (!operation)
    return tell(Error{ErrorCode::kConfiguration, "master synchronisation", because("the bus is offline")});
  if (auto status = operation->configure_dcm(command.settings); !status) tell(status.error());
}

void MasterService::Impl::execute(const ResetDcmStatusCommand&) {
  if (operation) operation->reset_dcm_status();
}

void MasterService::Impl::execute(const CompensateDelaysCommand& command) {
  if (!operation)
    return tell(Error{ErrorCode::kConfiguration, "continuous delay compensation", because("the bus is offline")});
  operation->compensate_delays(command.on);
}

void MasterService::Impl::execute(const ForceOutputCommand& command) {
  if (!operation) return tell(Error{ErrorCode::kConfiguration, "outputs", because("the bus is offline")});
  if (auto status = operation->force(command); !status) tell(status.error());
}

void MasterService::Impl::execute(const ReleaseOutputCommand& command) {
  if (!operation) return;  // nothing is forced any more
  if (auto status = operation->release(command); !status) tell(status.error());
}

void MasterService::Impl::execute(const ReleaseAllOutputsCommand&) {
  if (operation) operation->release_all_outputs();
}

void MasterService::Impl::execute(const WatchCommand& command) {
  watch = command;
  if (operation) operation->watch(watch);
}

void MasterService::Impl::run_cycle() {
  if (!operation->cyclic()) {
    const auto busy = operation->run_requests();
    if (!busy.value_or(false)) clock.sleep_until(clock.now() + kIdlePeriod);
    return;
  }
  if (auto status = operation->run_cycle(); !status) {
    tell(status.error());
    go_offline();
  }
}

MasterService::MasterService(std::unique_ptr<Link> link, Clock& clock)
    : impl_(std::make_unique<Impl>(std::move(link), clock)) {}
MasterService::~MasterService() = default;

MasterChannels& MasterService::channels() { return impl_->channels; }
Clock& MasterService::clock() { return impl_->clock; }
const Link& MasterService::link() const { return *impl_->link; }
bool MasterService::online() const { return impl_->operation != nullptr; }

void MasterService::set_dc_start_time(DcStartTimeCallback callback) { impl_->start_time = std::move(callback); }

bool MasterService::Impl::step() {
  if (auto command = channels.commands.pop()) {
    std::visit([this](auto& what) { execute(what); }, *command);
    // Whatever was to be cancelled is over; the next command starts afresh.
    channels.cancel = false;
    return true;
  }
  if (!operation) {
    refuse_requests(channels, clock.now());
    return false;
  }
  run_cycle();
  return true;
}

/// On the virtual clock whoever looks does so between the steps that he asks for.
void MasterService::Impl::publish_latest() {
  if (operation && clock.is_virtual()) operation->publish_latest();
}

bool MasterService::step() {
  const bool done = impl_->step();
  impl_->publish_latest();
  return done;
}

void MasterService::shut_down() noexcept {
  try {
    if (impl_->operation) impl_->go_offline();
  } catch (...) {
    // Not even for the way down was there memory; nothing is left that could help.
  }
}

bool MasterService::step_guarded() noexcept {
  std::string what;
  try {
    try {
      return step();
    } catch (const std::exception& error) {
      what = error.what();
    }
    impl_->tell(events::MasterStopped{"The master stopped, which should not have happened: " + what});
  } catch (...) {
    // The end is told by the bus going offline.
  }
  shut_down();
  return false;
}

void MasterService::run_for(Nanoseconds duration) {
  auto& clock = impl_->clock;
  const auto end = clock.now() + duration;
  while (clock.now() < end) {
    if (!impl_->step()) clock.sleep_until(end);
  }
  impl_->publish_latest();
}

}  // namespace syncline
