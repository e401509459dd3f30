// SPDX-License-Identifier: Apache-2.0
#include "master/operation.h"

#include <fmt/format.h>

#include <array>
#include <span>
#include <utility>

#include "channels/command.h"
#include "channels/master_channels.h"
#include "compile/dcm_check.h"
#include "master/exchange/slave_name.h"
#include "master/scan/bus_scanner.h"
#include "protocol/dcm_error.h"
#include "protocol/registers.h"
#include "protocol/speed_counter.h"
#include "reasons/because.h"
#include "reasons/brief_reason.h"
#include "settings/dc_check.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

/// As events call it: a simulated one by its file alone, wherever that lies.
std::string adapter_name(const Link& link) {
  const auto described = link.describe();
  if (described.kind != "simulated") return described.name;
  const auto folder = described.name.rfind('/');
  return folder == std::string::npos ? described.name : "sim:" + described.name.substr(folder + 1);
}

/// An adapter that goes away each time is no adapter.
constexpr int kMostOutages = 10;

}  // namespace

Operation::Operation(NetworkConfig config, FrameExchange& exchange, Clock& clock, MasterChannels& channels)
    : config_(std::move(config)),
      exchange_(exchange),
      clock_(clock),
      bus_(exchange, clock, &channels.cancel),
      run_(config_, channels, SharedText(adapter_name(exchange.link()))),
      sync_(config_, run_.snapshot, run_.states, run_.teller, channels.timer_adjust_permil),
      task_(exchange, clock, run_, sync_),
      delays_(config_, run_.snapshot, run_.states, run_.teller),
      esm_(bus_, run_, task_, sync_, delays_),
      recovery_(bus_, run_, task_, esm_),
      renewal_(bus_, config_, run_.snapshot, run_.teller, task_, delays_),
      history_(bus_, run_.mailboxes, run_.teller, task_) {
  bus_.set_link_observer([this](bool up) { run_.link.note(up, clock_.now()); });
  task_.acyclic().requests().set_positions([this](std::size_t slave) { return esm_.commands().position(slave); });
  bus_.set_interrupt([this] { return unasked_ && !run_.channels().commands.empty(); });
}

Status Operation::check() const {
  if (config_.slaves.empty()) return fail(ErrorCode::kConfiguration, "network", because("it has no slaves"));
  if (config_.cyclic.empty()) return fail(ErrorCode::kConfiguration, "network", because("it has no cyclic frames"));
  if (config_.dc.dcm.mode == DcmMode::kLinkLayerRefClock && !exchange_.link().describe().corrects_send_time) {
    return fail(Error{.code = ErrorCode::kNotSupported,
                      .subject = "master.dc.mode",
                      .detail = because("link-layer-ref-clock: this link cannot put its send time into frames"),
                      .received = dc::kDcmErrorInvalidHardwareLayer});
  }
  if (auto status = check_dc(config_); !status) return status;
  return check_dcm(config_);
}

Status Operation::start(AlState target) {
  if (auto status = check(); !status) return status;
  // The configuration's source address is that of the machine it was made on.
  exchange_.set_addresses(config_.master.destination_mac, exchange_.link().describe().mac);
  auto& snapshot = run_.snapshot;
  snapshot.time = clock_.now();
  snapshot.online = true;
  snapshot.link_up = exchange_.link().describe().up;
  snapshot.requested = target;
  run_.channels().snapshot.publish_first(run_.snapshot);
  auto status = through_outages(target, [&](bool again) {
    if (again) {
      esm_.abandon();
    } else {
      tell_whether_it_runs();
    }
    return bring_up(target);
  });
  snapshot.time = clock_.now();  // also where it ended without a cycle
  run_.channels().snapshot.publish(run_.snapshot);
  return status;
}

/// Nobody has led these slaves up for us.
void Operation::tell_whether_it_runs() {
  std::array<std::uint8_t, 2> al_status{};
  const auto answered = bus_.exchange(Command::kBrd, 0, reg::kAlStatus, al_status);
  // Or-ed: the bit of SAFEOP, or of OP.
  if (answered && *answered > 0 && (al_status[0] & 0x0C) != 0)
    run_.teller.tell(clock_.now(), -1, events::BusWasRunning{});
}

/// From INIT, whatever the slaves are doing.
Status Operation::bring_up(AlState target) {
  if (auto status = esm_.reset(); !status) return status;
  run_.snapshot.link_up = true;  // frames have come back, whatever the adapter says
  return target == AlState::kInit ? Status{} : esm_.change_to(target);
}

/// What fails because the adapter was away, or everybody behind it, is begun again when they are back: nobody knows who
/// has got what of it.
Status Operation::through_outages(AlState target, const std::function<Status(bool again)>& lead) {
  for (int count = 0;; ++count) {
    const auto before = run_.link.outages();
    auto status = lead(count > 0);
    if (!status && status.error().code == ErrorCode::kLinkDown) run_.link.note(false, clock_.now());
    if (run_.link.outages() == before && !lost_its_ground(status)) return status;
    if (status) status = see_whether_reached(target);
    const bool ended = status || status.error().code == ErrorCode::kCancelled;
    if (ended || count == kMostOutages || !await_link()) return status;
    run_.teller.tell(clock_.now(), -1, events::BringUpAgain{});
  }
}

/// The cable at the master, everybody's supply, or that of the only clock that could lead. An acyclic frame may be
/// given up some cycles before the slaves are.
bool Operation::lost_its_ground(const Status& status) {
  constexpr int kCycles = 10;
  if (status || status.error().code == ErrorCode::kCancelled || !cyclic()) return false;
  const auto holds = [this] {
    return run_.states.somebody_present() && (!sync_.active() || task_.reference().leader());
  };
  for (int i = 0; i < kCycles && holds(); ++i) {
    if (!bus_.wait_a_little()) return false;
  }
  return !holds();
}

/// Slaves that did not answer in the middle of it may have been left out.
Status Operation::see_whether_reached(AlState target) {
  if (!cyclic()) return {};
  if (auto status = esm_.commands().read_all(); !status) return status;
  return run_.snapshot.state == target ? Status{} : fail(ErrorCode::kNoResponse, exchange_.link().describe().name);
}

/// True when slaves answer again.
bool Operation::await_link() {
  const auto end = run_.link.away_since().value_or(clock_.now()) + Bus::kLinkPatience;
  do {
    if (bus_.cyclic()) {
      if (!bus_.wait_a_little()) return false;
      if (!run_.link.away_since() && run_.states.somebody_present()) return true;
      continue;
    }
    const auto count = count_slaves(bus_);
    if (count && *count > 0) return true;
    const bool silent =
        count || count.error().code == ErrorCode::kNoResponse || count.error().code == ErrorCode::kLinkDown;
    if (!silent || !bus_.wait_a_little()) return false;
  } while (clock_.now() < end);
  return false;
}

Status Operation::run_cycle() {
  run_.states.watch_for_others(true);
  auto cycle = task_.run_cycle(delays_.requests(clock_.now()));
  run_.states.watch_for_others(false);
  if (!cycle) return cycle;
  delays_.take(clock_.now(), task_.reference().leader());
  unasked_ = true;
  auto status = recovery_.after_cycle();
  if (status) status = renewal_.after_cycle();
  if (status) status = history_.after_cycle();
  unasked_ = false;
  (void)serve_state_request();
  if (status) return {};
  // What interrupts or stops such work is no reason to go offline: the cycles say whether the bus is alive.
  const bool ours = status.error().code == ErrorCode::kCancelled || status.error().code == ErrorCode::kNoResponse;
  return ours ? Status{} : status;
}

Status Operation::change_to(AlState target) {
  const bool from_rest = !cyclic();
  auto status = through_outages(target, [&](bool again) {
    if (!again || !from_rest) return lead_to(target);
    esm_.abandon();
    return bring_up(target);
  });
  run_.channels().snapshot.publish(run_.snapshot);
  return status;
}

Status Operation::lead_to(AlState target) {
  if (cyclic() && target != AlState::kInit) {
    if (auto status = recovery_.bring_all_back(); !status) return status;
  }
  return esm_.change_to(target);
}

Result<bool> Operation::run_requests() {
  auto done = task_.acyclic().requests().run_round(bus_);
  if (!done) return done;
  return serve_state_request() || *done;
}

/// True when there was one. It takes cycles, as what the state machine does with all slaves.
bool Operation::serve_state_request() {
  auto& requests = task_.acyclic().requests();
  auto* ticket = requests.state_request();
  if (ticket == nullptr) return false;
  const auto slave = slave_of(ticket->request);
  const auto* change = std::get_if<requests::StateChange>(&ticket->request);
  const auto status = change != nullptr ? esm_.lead(slave, change->state) : esm_.acknowledge(slave);
  if (!status) ticket->error = status.error();
  requests.answer(*ticket, clock_.now());
  return true;
}

/// What is begun in an EEPROM is put back before the bus is left, files are told; nothing new is begun.
void Operation::end_requests() {
  constexpr Nanoseconds kPatience = 2 * kSecond;
  auto& requests = task_.acyclic().requests();
  constexpr BriefError kOffline{.code = ErrorCode::kCancelled, .why = brief("the bus goes offline{which}")};
  requests.cancel_all(kOffline, clock_.now());
  const auto end = clock_.now() + kPatience;
  while (requests.busy() && clock_.now() < end) {
    const auto done = cyclic() ? task_.run_cycle({}).map([] { return true; }) : requests.run_round(bus_);
    if (!done) break;
    if (!*done && !bus_.wait_a_little()) break;
  }
  requests.end_all(kOffline, clock_.now());
}

void Operation::stop() {
  bus_.set_cancellable(false);
  end_requests();
  if (cyclic()) {
    task_.tell_rest();
    // A slave that does not come down, or a link that is gone, must not keep us.
    const auto down = esm_.change_to(AlState::kInit);
    bus_.set_pump(nullptr);
    task_.tell_rest();
    if (!down) tell_left_behind(down.error());
  }
  run_.snapshot.online = false;
  run_.snapshot.forced_bits = 0;
  run_.snapshot.time = clock_.now();
  run_.channels().snapshot.publish(run_.snapshot);
}

/// Who did not come to INIT is named: he goes on driving until somebody else stops him.
void Operation::tell_left_behind(const Error& why) {
  constexpr std::size_t kNamed = 4;  // more are counted
  std::string names;
  std::uint16_t al_status = 0;
  std::size_t left = 0;
  for (std::size_t i = 0; i < run_.snapshot.slaves.size(); ++i) {
    const auto& slave = run_.snapshot.slaves[i];
    if (!slave.present || al_state_of(slave.al_status) == AlState::kInit) continue;
    if (left == 0) al_status = slave.al_status;
    if (left++ < kNamed) names += (names.empty() ? "" : ", ") + slave_name(run_.config(), i);
  }
  if (left == 0) return;
  if (left > kNamed) names += fmt::format(" and {} more", left - kNamed);
  Error error{.code = ErrorCode::kAlTimeout, .subject = std::move(names)};
  error.expected = static_cast<std::int64_t>(AlState::kInit);
  error.received = al_status;
  run_.teller.error(why.code == ErrorCode::kAlState || why.code == ErrorCode::kAlTimeout ? error : why, clock_.now());
  if (why.code != ErrorCode::kAlState && why.code != ErrorCode::kAlTimeout) run_.teller.error(error, clock_.now());
}

Status Operation::configure_dcm(const DcmSettings& change) {
  const bool steered = sync_.steers();
  if (auto status = sync_.configure(change); !status) return status;
  return steered && !sync_.steers() && cyclic() ? note_learned_rate() : Status{};
}

/// A clock that is steered no more keeps the rate that it was taught; what it was taught belongs to its natural drift.
Status Operation::note_learned_rate() {
  const auto leader = task_.reference().leader();
  if (!leader) return {};
  std::array<std::uint8_t, 4> loop{};
  Datagram read{Command::kFprd, device_address(config_.slaves[*leader].station_address, reg::kSpeedCounterStart), loop};
  if (auto status = bus_.transact({&read, 1}); !status) return status;
  const std::span<const std::uint8_t> bytes(loop);
  const auto counts = static_cast<std::int16_t>(load_le<std::uint16_t>(bytes.subspan(2)));
  if (read.done()) sync_.set_learned_rate(speed_counter_rate(load_le<std::uint16_t>(bytes), counts) * 1e6);
  return {};
}

void Operation::compensate_delays(bool on) { delays_.set_enabled(on, clock_.now()); }

Status Operation::force(const ForceOutputCommand& wanted) {
  if (!task_.forces().force(wanted))
    return fail(ErrorCode::kConfiguration, "outputs", because("the process image has no such bits"));
  tell_forced();
  return {};
}

Status Operation::release(const ReleaseOutputCommand& wanted) {
  if (!task_.forces().release(wanted))
    return fail(ErrorCode::kConfiguration, "outputs", because("the process image has no such bits"));
  tell_forced();
  return {};
}

void Operation::release_all_outputs() {
  task_.forces().release_all();
  tell_forced();
}

void Operation::tell_forced() {
  const auto bits = task_.forces().count();
  if (bits == run_.snapshot.forced_bits) return;
  run_.snapshot.forced_bits = bits;
  run_.teller.tell(clock_.now(), -1, events::OutputsForced{bits});
}

void Operation::clear_statistics() {
  auto& snapshot = run_.snapshot;
  snapshot.lost_frames = snapshot.late_frames = snapshot.wkc_errors = snapshot.overruns = snapshot.skipped_cycles = 0;
  sync_.clear_statistics();
}

}  // namespace syncline
