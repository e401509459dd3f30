// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/cyclic_task.h"

#include "channels/cycle_sample.h"
#include "channels/cyclic_application.h"
#include "channels/master_channels.h"
#include "config/frame_time.h"
#include "config/master_settings.h"
#include "master/exchange/narrow.h"
#include "master/exchange/run_state.h"

#include <algorithm>

namespace syncline {
namespace {

/// Nobody looks at a snapshot more often than this.
constexpr Nanoseconds kPublishPeriod = 1 * kMillisecond;
/// Copying what many slaves are takes longer than their cycle: when nobody has looked, the next one can wait. On the
/// virtual clock whoever looks does so between stretches of time, at whose end all is published in any case.
constexpr Nanoseconds kUnreadPeriod = 10 * kMillisecond, kUnreadVirtualPeriod = 100 * kMillisecond;
/// Nobody reads values faster, and who begins to look sees none that is much older.
constexpr Nanoseconds kImagePeriod = 20 * kMillisecond, kUnreadImagePeriod = 100 * kMillisecond;
constexpr int kMostAmendments = 4;

}  // namespace

CyclicTaskRunner::CyclicTaskRunner(FrameExchange& exchange, Clock& clock, RunState& run, SyncWatch& sync)
    : exchange_(exchange),
      clock_(clock),
      run_(run),
      sync_(sync),
      frames_(run.config()),
      forces_(frames_.outputs().size()),
      watched_(frames_, run.snapshot),
      slaves_(run.config(), run.snapshot, run.states, run.teller),
      mailbox_bits_(run.config(), run.snapshot, run.mailboxes, frames_),
      sync_events_(run.config(), run.snapshot, run.states, sync),
      acyclic_(run, mailbox_bits_, sync_events_),
      health_(run.snapshot, run.teller),
      working_counter_(run.snapshot, run.states, run.teller),
      tuning_(run.config(), run.snapshot),
      reference_(run.config(), run.snapshot, run.teller, sync, frames_, tuning_),
      feed_(run.config().cycle_time()),
      without_(run.config().slaves.size()),
      cycle_time_(run.config().cycle_time()),
      slots_(cycle_time_),
      spin_(std::min(run.config().real_time.spin, cycle_time_ / 4), SpinBudget::tolerated(cycle_time_)),
      standstill_(clock) {
  in_flight_.reserve(64);
  image_.input_bytes = frames_.inputs().size();
  image_.bytes.resize(2 * (image_.input_bytes + frames_.outputs().size()));
  run.channels().image.publish_first(image_);
  if (run.config().dc.dcm.mode == DcmMode::kLinkLayerRefClock) {
    frames_.correct_by_link();
    amendment_.correct_by_link();
  }
  if (run.config().dc.dcm.mode == DcmMode::kDcx) {
    if (const auto place = find_external_clock(run.config())) external_clock_.emplace(*place);
  }
}

void CyclicTaskRunner::start(Nanoseconds first_cycle) {
  scheduled_ = first_cycle;
  last_sent_.reset();
  lost_seen_ = exchange_.lost_frames();
}

Status CyclicTaskRunner::run_cycle(std::span<Datagram* const> acyclic) {
  wait_for_slot();
  send_time_ = clock_.now();
  CycleSample sample;
  sample.cycle = run_.snapshot.cycles;
  steering_ = sync_.reference_write(send_time_, scheduled_).has_value();
  calculate_outputs(sample);
  reference_.address(slaves_.settled());
  frames_.prepare(slots_.next(skipped_, since_base()), steering_);
  publish_image(sample.cycle);
  watched_.take_outputs();
  forces_.restore(frames_.outputs());
  fill_acyclic(acyclic, send_time_);
  first_stamp_.reset();
  auto status = note_link(exchange_frames(deadline()));
  acyclic_.adapt(scheduled_, cycle_time_);
  note_sending(sample);
  exchange_.missing().expire(clock_.now());
  const auto missing = exchange_.missing().take_news();
  health_.observe_frames(exchange_.lost_frames() - lost_seen_, missing, send_time_, sample);
  sync_events_.came_late(missing.late_cycles);
  lost_seen_ = exchange_.lost_frames();
  evaluate(sample);
  if (auto amended = amend_clock(); !amended && amended.error().code != ErrorCode::kLinkDown)
    status = std::move(amended);
  health_.tell(send_time_);
  finish_sample(sample);
  scheduled_ += cycle_time_ + adjust_;
  return status;
}

std::optional<Nanoseconds> CyclicTaskRunner::since_base() const {
  if (!sync_.active()) return std::nullopt;
  return sync_.reference_time_at(scheduled_) + run_.snapshot.dcm.set_value_ns - sync_.base();
}

void CyclicTaskRunner::calculate_outputs(const CycleSample& sample) {
  if (auto* application = run_.channels().application.load(std::memory_order_acquire)) {
    application->run({sample.cycle, scheduled_, run_.snapshot.state}, frames_.inputs(), frames_.outputs());
  }
  forces_.apply(frames_.outputs());
}

/// As it stands between two frames: what has come back, and what goes out next.
void CyclicTaskRunner::publish_image(std::uint64_t cycle) {
  auto& box = run_.channels().image;
  if (send_time_ - image_.time < (box.taken() ? kImagePeriod : kUnreadImagePeriod)) return;
  image_.cycle = cycle;
  image_.time = send_time_;
  const auto known = std::ranges::copy(frames_.inputs(), image_.bytes.begin()).out;
  frames_.mark_known_inputs({known, image_.input_bytes});
  const auto outputs = known + static_cast<std::ptrdiff_t>(image_.input_bytes);
  const auto forced = std::ranges::copy(frames_.outputs(), outputs).out;
  std::ranges::copy(forces_.mask(), forced);
  box.publish(image_);
}

/// An adapter that is away is waited for, as slaves are that do not answer.
Status CyclicTaskRunner::note_link(Status status) {
  const bool down = !status && status.error().code == ErrorCode::kLinkDown;
  run_.link.note(!down, clock_.now());
  return down ? Status{} : status;
}

/// A cycle whose time is half over is left out, so that a late frame and the next one never go out together: slaves
/// would see two frames in one SYNC0 period. The phase stays.
void CyclicTaskRunner::wait_for_slot() {
  standstill_.before_wait();
  spin_.observe(clock_.sleep_until(scheduled_, spin_.amount()));
  const auto late = clock_.now() - scheduled_, behind = late - cycle_time_ / 2;
  skipped_ = behind > 0 ? behind / cycle_time_ + 1 : 0;
  if (skipped_ == 0) return;
  standstill_.note(late);
  scheduled_ += skipped_ * cycle_time_;
  spin_.observe(clock_.sleep_until(scheduled_, spin_.amount()));
}

void CyclicTaskRunner::tell_rest() {
  exchange_.missing().give_up();
  health_.tell_rest(exchange_.missing().take_news());
}

void CyclicTaskRunner::stamp(Nanoseconds send_time) {
  if (amendment_.sending()) {
    amendment_stamp_ = send_time;
    const auto steered = steering_ ? sync_.reference_write(send_time, send_time) : std::nullopt;
    amendment_.write(steered.value_or(sync_.reference_time_at(send_time)));
    return;
  }
  if (!first_stamp_) first_stamp_ = send_time;
  if (!sync_.active()) return;
  const auto believed = sync_.reference_time_at(send_time);
  const bool steers = steering_ && sending_ == frames_.write_frame();
  frames_.stamp(sending_, sending_ == frames_.time_frame() ? told_.tell(believed) : believed,
                steers ? sync_.reference_write(send_time, scheduled_) : std::nullopt);
  // One behind the other, whatever the host's clock says when it hands them over.
  feed_.stamp(told_.tell_between(sync_.reference_time_at(std::max(send_time, wire_free_))));
}

void CyclicTaskRunner::note_sending(CycleSample& sample) {
  const auto sent = frames_.frames();
  if (!sent.empty()) {
    const auto& first = *sent.front();
    send_time_ = first.send_time();
    sample.stamped_by = first.stamped_by();
    stamp_doubt_ = 0;
    if (first.answered()) {
      sample.round_trip_ns = to_32(first.arrival_time() - first.send_time());
      const bool known = travel_ != 0;
      learn_travel(first);
      if (known) sample.stamp_doubt_ns = to_32(stamp_doubt_);
    }
  }
  sample.send_time = send_time_;
  sample.wake_lateness_ns = to_32(send_time_ - scheduled_);
  health_.observe_schedule(skipped_, last_sent_ ? send_time_ - *last_sent_ : 0, send_time_, sample);
  last_sent_ = send_time_;
}

void CyclicTaskRunner::fill_acyclic(std::span<Datagram* const> requests, Nanoseconds now) {
  // Short and regular readings first: a long mailbox datagram finds room in the next cycle.
  auto& first = acyclic_.clear({cycle_time_, cyclic_wire_time(), travel_});
  slaves_.add_to(first, sync_.monitored() && !frames_.reads_deviation(), sync_.wants_readings());
  reference_.add_to(first);
  acyclic_.fill(requests, now);
  acyclic_.ride(frames_, sync_events_.room());
}

Nanoseconds CyclicTaskRunner::cyclic_wire_time() {
  Nanoseconds sum = 0;
  for (const auto* frame : frames_.frames()) sum += wire_time_ns(frame->size() + kFrameOverhead);
  return sum;
}

/// Before anybody has been looked for, which takes some cycles where there are many.
void CyclicTaskRunner::change_way(CycleSample& sample) {
  sync_.way_changed();
  travel_ = stamp_doubt_ = 0;
  sample.stamp_doubt_ns = CycleSample{}.stamp_doubt_ns;
}

/// Four fifths of the cycle leave time for what follows; where the segment is so long that its frames need more, they
/// get it.
Nanoseconds CyclicTaskRunner::deadline() {
  const auto needed = travel_ + cyclic_wire_time() + acyclic_.wire_time() + cycle_time_ / 20;
  return scheduled_ + std::clamp(needed, cycle_time_ * 8 / 10, latest_return(cycle_time_));
}

/// The shortest counts, and is forgotten slowly, however much longer the others are: what else a frame waits for is the
/// host's, and may last for many cycles.
void CyclicTaskRunner::learn_travel(const PendingFrame& frame) {
  constexpr Nanoseconds kMost = 40;  // a cycle
  const auto travel = frame.arrival_time() - frame.send_time() - wire_time_ns(frame.size() + kFrameOverhead);
  stamp_doubt_ = travel_ == 0 ? 0 : std::max<Nanoseconds>(travel - travel_, 0);
  travel_ = travel_ == 0 || travel < travel_
                ? std::max<Nanoseconds>(travel, 0)
                : travel_ + std::min({(travel - travel_) / 64, cycle_time_ / 50'000, kMost});
}

Status CyclicTaskRunner::exchange_frames(Nanoseconds deadline) {
  in_flight_.clear();
  Status status;
  const auto note = [&status](Status sent) {
    if (!sent) status = std::move(sent);
  };
  for (auto* frame : frames_.frames()) note(send(*frame));
  for (auto& frame : acyclic_.frames()) {
    if (!frame.empty()) note(send(frame));
  }
  for (auto& frame : feed_.prepare()) note(send(frame));
  // A late wake-up must not leave the frames without time to come back.
  const auto patience = std::max(deadline, clock_.now() + cycle_time_ / 4);
  if (auto collected = exchange_.collect(in_flight_, patience); !collected) return collected;
  return status;
}

Status CyclicTaskRunner::send(PendingFrame& frame) {
  sending_ = &frame;
  if (auto sent = exchange_.send(frame, this); !sent) return sent;
  in_flight_.push_back(&frame);
  wire_free_ = std::max(wire_free_, frame.send_time()) + wire_time_ns(frame.size() + kFrameOverhead);
  return {};
}

/// As often as it takes, but not so late in the cycle that it would meet the next frame.
Status CyclicTaskRunner::amend_clock() {
  const auto station = reference_.station();
  const auto latest = scheduled_ + cycle_time_ * 8 / 10;
  const auto is_time = [&] { return clock_.now() + cycle_time_ / 8 < latest; };
  for (int i = 0; tuning_.pending() && i < kMostAmendments && is_time(); ++i) {
    if (auto sent = tuning_.step(exchange_, latest); !sent) return sent;
  }
  bool again = station && steering_ && sync_.wants_second_write();
  for (int i = 0; again && i < kMostAmendments && is_time(); ++i) {
    if (auto sent = amendment_.run(exchange_, *station, *this, latest); !sent) return sent;
    const auto time = amendment_.reading();
    if (!time) break;
    const auto sent_at = amendment_.send_time();
    dc::DcmObservation found{sent_at, amendment_stamp_, sync_.extend(*time, sent_at)};
    found.way_out = sent_at - amendment_stamp_;
    again = sync_.observe_second_write(found);
  }
  return {};
}

/// Slaves were looked at: what is expected of the bus from now on.
void CyclicTaskRunner::after_sweep() {
  sweeps_seen_ = slaves_.sweeps();
  frames_.take_attendance();
  reference_.look(send_time_);
  if (working_counter_.judging()) expect_present();
}

void CyclicTaskRunner::expect_present(std::optional<std::size_t> leaving) {
  for (std::size_t i = 0; i < without_.size(); ++i) {
    const auto& slave = run_.snapshot.slaves[i];
    const auto state = al_state_of(slave.al_status);
    without_[i] = i == leaving || !slave.present || (state != AlState::kSafeop && state != AlState::kOp);
  }
  const auto before = frames_.wkc_expected();
  frames_.expect_without(without_);
  const auto now = frames_.wkc_expected();
  if (now != before) run_.teller.tell(send_time_, -1, events::WkcExpected{frames_.wkc_configured(), now});
}

std::optional<Nanoseconds> CyclicTaskRunner::reference_time(const CyclicFrameSet::Reading& reading) const {
  if (!reading.reference_time) return std::nullopt;
  if (reading.reference_is_64bit) return static_cast<Nanoseconds>(*reading.reference_time);
  return sync_.extend(static_cast<std::uint32_t>(*reading.reference_time), send_time_);
}

dc::DcmObservation CyclicTaskRunner::observation(const CyclicFrameSet::Reading& reading) {
  dc::DcmObservation result{send_time_, scheduled_, reference_time(reading)};
  if (first_stamp_) result.way_out = send_time_ - *first_stamp_;
  result.stamp_doubt = stamp_doubt_;
  if (external_clock_) {
    const auto& bridge = run_.snapshot.slaves[external_clock_->slave()];
    result.external_expected = bridge.present && al_state_of(bridge.al_status) == AlState::kOp;
    if (result.external_expected) result.external_difference = external_clock_->read(frames_.inputs(), send_time_);
  }
  return result;
}

void CyclicTaskRunner::evaluate(CycleSample& sample) {
  const auto reading = frames_.evaluate();
  const bool up = run_.snapshot.link_up;
  if (up) {
    working_counter_.observe(reading.wkc_expected, reading.wkc_received, send_time_, sample);
  } else {
    working_counter_.pause();
  }
  if (reading.al_status && slaves_.observe_broadcast(*reading.al_status, *reading.al_status_wkc)) change_way(sample);
  const auto all = slaves_.take(send_time_, sample);
  slaves_.observe_silence((!up || (sample.flags & CycleSample::kFrameLost) != 0) && !reading.al_status, send_time_);
  if (slaves_.sweeps() != sweeps_seen_) after_sweep();
  mailbox_bits_.observe();
  const auto observed = observation(reading);
  // A slave that fell behind others that had fallen before says so itself.
  if (acyclic_.take_mailboxes(send_time_, observed.reference_time, sample)) slaves_.refresh_al_status();
  if (frames_.time_frame() != nullptr) told_.observe(observed.reference_time);
  adjust_ = sync_.observe_cycle(observed, sample);
  reference_.watch(send_time_);
  const bool all_back = std::ranges::all_of(frames_.frames(), &PendingFrame::answered);
  acyclic_.take_evidence(send_time_, sample.skipped_cycles == 0);
  sync_events_.observe(sample, {frames_, all_back, stamp_doubt_});
  const auto deviation = reading.deviation_ored ? reading.deviation_ored : all;
  sync_.observe_slaves(send_time_, slaves_.deviations_read(), deviation, sample);
}

void CyclicTaskRunner::finish_sample(CycleSample& sample) {
  auto& snapshot = run_.snapshot;
  sample.master_state = static_cast<std::uint8_t>(snapshot.state);
  watched_.fill(sample);
  snapshot.time = sample.send_time;
  ++snapshot.cycles;
  auto& channels = run_.channels();
  (void)channels.samples.push(sample);
  if (channels.relieve && channels.samples.is_half_full()) channels.relieve();
  const auto unread = clock_.is_virtual() ? kUnreadVirtualPeriod : kUnreadPeriod;
  const auto period = channels.snapshot.taken() ? kPublishPeriod : unread;
  if (sample.send_time - last_published_ >= period) publish();
}

void CyclicTaskRunner::publish_latest() {
  if (run_.snapshot.time != last_published_) publish();
}

void CyclicTaskRunner::publish() {
  run_.snapshot.host = {spin_.amount(),     spin_.mean_spent(),           spin_.wake_p50(),    spin_.wake_p99(),
                        standstill_.held(), standstill_.held_by_others(), standstill_.holder()};
  last_published_ = run_.snapshot.time;
  run_.channels().snapshot.publish(run_.snapshot);
}

}  // namespace syncline
