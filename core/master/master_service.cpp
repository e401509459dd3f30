// SPDX-License-Identifier: Apache-2.0
#include "master/master_service.h"

#include <exception>
#include <utility>

#include "channels/command.h"
#include "channels/master_channels.h"
#include "master/cyclic/acyclic_requests.h"
#include "master/exchange/frame_tap.h"
#include "master/operation.h"
#include "reasons/because.h"
#include "support/real_time.h"

namespace syncline {
namespace {

Status offline(const char* what) { return fail(ErrorCode::kConfiguration, what, because("the bus is offline")); }

}  // namespace

struct MasterService::Impl {
  Impl(std::unique_ptr<Link> own_link, Clock& own_clock)
      : clock(own_clock), link(make_frame_tap(std::move(own_link), own_clock, channels)), exchange(*link, own_clock) {}

  Status execute(GoOnlineCommand& command);
  Status execute(const GoOfflineCommand&);
  Status execute(const RequestStateCommand& command);
  Status execute(const ClearStatisticsCommand&);
  Status execute(const ConfigureDcmCommand& command);
  Status execute(const ResetDcmStatusCommand&);
  Status execute(const CompensateDelaysCommand& command);
  Status execute(const ForceOutputCommand& command);
  Status execute(const ReleaseOutputCommand& command);
  Status execute(const ReleaseAllOutputsCommand&);
  Status execute(const WatchCommand& command);
  bool step();
  void publish_latest();
  void bind_thread(const RealTimeSettings& settings);
  void run_cycle();
  void go_offline();
  void tell(EventDetails what);
  void tell(const Error& error) { tell(events::Failure{error}); }
  Status told(Status status);

  Clock& clock;
  MasterChannels channels;
  std::unique_ptr<Link> link;
  FrameExchange exchange;
  std::unique_ptr<Operation> operation;
  DcStartTimeCallback start_time;
  WatchCommand watch;  // the last one
};

void MasterService::Impl::tell(EventDetails what) { channels.events.push({clock.now(), -1, std::move(what)}); }

/// What is refused is an event for all, and the answer for who asked.
Status MasterService::Impl::told(Status status) {
  if (!status) tell(status.error());
  return status;
}

/// The thread that executes the command is the one that runs the cycle.
void MasterService::Impl::bind_thread(const RealTimeSettings& settings) {
  if (clock.is_virtual() || !settings.cpu) return;
  if (auto refused = bind_to_processor(*settings.cpu); !refused.empty())
    tell(events::RealTimeRefused{std::move(refused)});
}

Status MasterService::Impl::execute(GoOnlineCommand& command) {
  if (operation) go_offline();
  bind_thread(command.config.real_time);
  operation = std::make_unique<Operation>(std::move(command.config), exchange, clock, channels);
  operation->set_start_time(start_time);
  operation->watch(watch);
  auto status = told(operation->start(command.target));
  const bool cancelled = !status && status.error().code == ErrorCode::kCancelled;
  if (!status && (cancelled || !operation->cyclic())) {
    go_offline();
    return status;
  }
  // A bus that did not come all the way up stays online, to be looked at.
  tell(events::Online{});
  return status;
}

Status MasterService::Impl::execute(const GoOfflineCommand&) {
  go_offline();
  return {};
}

void MasterService::Impl::go_offline() {
  if (operation) operation->stop();
  operation.reset();
  tell(events::Offline{});
}

Status MasterService::Impl::execute(const RequestStateCommand& command) {
  if (!operation) return told(offline("state request"));
  return told(operation->change_to(command.state));
}

Status MasterService::Impl::execute(const ClearStatisticsCommand&) {
  if (operation) operation->clear_statistics();
  return {};
}

Status MasterService::Impl::execute(const ConfigureDcmCommand& command) {
  if (!operation) return told(offline("master synchronisation"));
  return told(operation->configure_dcm(command.settings));
}

Status MasterService::Impl::execute(const ResetDcmStatusCommand&) {
  if (operation) operation->reset_dcm_status();
  return {};
}

Status MasterService::Impl::execute(const CompensateDelaysCommand& command) {
  if (!operation) return told(offline("continuous delay compensation"));
  operation->compensate_delays(command.on);
  return {};
}

Status MasterService::Impl::execute(const ForceOutputCommand& command) {
  return told(operation ? operation->force(command) : offline("outputs"));
}

Status MasterService::Impl::execute(const ReleaseOutputCommand& command) {
  return operation ? told(operation->release(command)) : Status{};  // offline nothing is forced any more
}

Status MasterService::Impl::execute(const ReleaseAllOutputsCommand&) {
  if (operation) operation->release_all_outputs();
  return {};
}

Status MasterService::Impl::execute(const WatchCommand& command) {
  watch = command;
  if (operation) operation->watch(watch);
  return {};
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
  channels.beat();
  if (auto entry = channels.commands.pop()) {
    auto status = std::visit([this](auto& what) { return execute(what); }, entry->command);
    // Whatever was to be cancelled is over; the next command starts afresh.
    channels.cancel = false;
    channels.commands.answer(entry->id, status ? std::nullopt : std::optional(std::move(status.error())), clock.now());
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
