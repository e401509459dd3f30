// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/cyclic_frame_set.h"

#include <algorithm>

#include "config/command_data.h"
#include "config/cyclic_frame.h"
#include "config/network_config.h"
#include "config/process_image.h"
#include "protocol/datagram.h"
#include "protocol/registers.h"
#include "protocol/system_time_difference.h"
#include "support/bits.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

/// Inputs of a datagram that did not come back for so long are no present ones.
constexpr Nanoseconds kOldInputs = 100 * kMillisecond;
/// Cycles by which it is known who has gone; what stays away longer is no slave that has gone.
constexpr int kMostDoubted = 20;

/// How many bits of the image there are from `bit` on.
std::size_t bits_from(std::span<const std::uint8_t> image, std::uint32_t bit) {
  return image.size() * 8 > bit ? image.size() * 8 - bit : 0;
}

}  // namespace

CyclicFrameSet::CyclicFrameSet(const NetworkConfig& config) : data_offset_(config.image.command_data_offset) {
  for (const auto& task : config.cyclic) add_task(task, config.cycle_time());
  active_.reserve(frames_.size());
  for (auto& entry : entries_) {
    entry.data.resize(entry.command->length());
    entry.datagram.data = entry.data;
  }
  size_images(config);
  share_counters(config);
}

/// By the ranges of the slaves in the process image: a slave that reads counts 1, one that writes 1, or 2 in an LRW.
void CyclicFrameSet::share_counters(const NetworkConfig& config) {
  writers_.resize(config.slaves.size());
  readers_.resize(config.slaves.size());
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    const auto& command = *entries_[e].command;
    if (entries_[e].role != Role::kProcessData) continue;
    for (std::size_t i = 0; i < config.slaves.size(); ++i) {
      const auto& slave = config.slaves[i];
      unsigned wkc = 0;
      if (writes_outputs(command, slave.send, config.image)) {
        wkc += command.command == Command::kLrw ? 2 : 1;
        writers_[i].push_back(static_cast<std::uint16_t>(e));
      }
      if (reads_inputs(command, slave.receive, config.image)) {
        ++wkc;
        readers_[i].push_back(static_cast<std::uint16_t>(e));
      }
      if (wkc > 0) shares_.push_back({i, e, static_cast<std::uint16_t>(wkc)});
    }
  }
}

void CyclicFrameSet::expect_without(const std::vector<bool>& slaves) {
  for (auto& entry : entries_) entry.wkc_without = 0;
  for (const auto& share : shares_) {
    if (!slaves[share.slave]) continue;
    auto& entry = entries_[share.entry];
    const auto left = static_cast<unsigned>(entry.command->expected_wkc.value_or(0)) - entry.wkc_without;
    entry.wkc_without = static_cast<std::uint16_t>(entry.wkc_without + std::min<unsigned>(share.wkc, left));
  }
}

std::uint16_t CyclicFrameSet::wkc_configured() const {
  std::uint16_t sum = 0;
  for (const auto& entry : entries_) {
    if (entry.role == Role::kProcessData)
      sum = static_cast<std::uint16_t>(sum + entry.command->expected_wkc.value_or(0));
  }
  return sum;
}

std::uint16_t CyclicFrameSet::wkc_expected() const {
  std::uint16_t without = 0;
  for (const auto& entry : entries_) without = static_cast<std::uint16_t>(without + entry.wkc_without);
  return static_cast<std::uint16_t>(wkc_configured() - without);
}

void CyclicFrameSet::follow(Leader leader) {
  leader_ = leader;
  for (auto& entry : entries_) {
    if (entry.role == Role::kReferenceTime || entry.role == Role::kReferenceWrite) address_leader(entry);
  }
}

bool CyclicFrameSet::configured_for(std::uint16_t position, std::uint16_t station) const {
  return std::ranges::all_of(entries_, [&](const Entry& entry) {
    if (entry.role != Role::kReferenceTime && entry.role != Role::kReferenceWrite) return true;
    const auto& command = *entry.command;
    const bool by_place = command.command == Command::kArmw || command.command == Command::kApwr;
    return command.adp == (by_place ? Position{position}.auto_increment_address() : station);
  });
}

void CyclicFrameSet::address_leader(Entry& entry) {
  const auto& command = *entry.command;
  const bool reads = entry.role == Role::kReferenceTime;
  entry.datagram.command = command.command;
  entry.datagram.address = device_address(command.adp, command.ado);
  if (leader_.who == Leader::Who::kNobody) {
    entry.datagram.command = Command::kNop;
  } else if (leader_.who == Leader::Who::kOther) {
    entry.datagram.command = reads ? Command::kFrmw : Command::kFpwr;
    entry.datagram.address = device_address(leader_.station, command.ado);
  }
}

void CyclicFrameSet::add_task(const CyclicTask& task, Nanoseconds base_cycle) {
  const auto divider = std::max<Nanoseconds>(1, (task.cycle_time + base_cycle / 2) / base_cycle);
  tasks_.push_back({TaskTurn(divider)});
  for (const auto& frame : task.frames) {
    for (const auto& command : frame.commands) {
      Entry entry;
      entry.command = &command;
      entry.role = role_of(command);
      entry.frame = frames_.size();
      entry.task = tasks_.size() - 1;
      entry.period = divider * base_cycle;
      // This master latches by itself (DelayCompensation); a latch in every cycle would spoil what it is reading.
      const bool latches = command.command == Command::kBwr && command.ado == reg::kReceiveTimePort0;
      entry.datagram.command = latches ? Command::kNop : command.command;
      entry.datagram.stamped = entry.role == Role::kReferenceTime || entry.role == Role::kReferenceWrite;
      entry.datagram.address =
          is_logical(command.command) ? command.logical_address : device_address(command.adp, command.ado);
      entries_.push_back(std::move(entry));
    }
    frames_.emplace_back().set_cyclic();
  }
}

void CyclicFrameSet::size_images(const NetworkConfig& config) {
  // Foreign files place commands behind the size that they declare.
  std::size_t inputs = config.image.input_bytes, outputs = config.image.output_bytes;
  for (const auto& entry : entries_) {
    inputs = std::max<std::size_t>(inputs, entry.command->input_offset + data_offset_ + entry.command->length());
    outputs = std::max<std::size_t>(outputs, entry.command->output_offset + data_offset_ + entry.command->length());
  }
  inputs_.resize(inputs);
  outputs_.resize(outputs);
}

CyclicFrameSet::Role CyclicFrameSet::role_of(const CyclicCmd& command) {
  if (is_logical(command.command)) return command.expected_wkc ? Role::kProcessData : Role::kOther;
  const bool system_time = command.ado == reg::kSystemTime && command.length() >= 4;
  switch (command.command) {
    case Command::kArmw:
    case Command::kFrmw:
      return system_time ? Role::kReferenceTime : Role::kOther;
    case Command::kApwr:
    case Command::kFpwr:
      return system_time ? Role::kReferenceWrite : Role::kOther;
    case Command::kBrd:
      if (command.ado == reg::kAlStatus && command.length() >= 2) return Role::kAlStatus;
      if (command.ado == reg::kSystemTimeDifference && command.length() >= 4) return Role::kDeviation;
      return Role::kOther;
    default:
      return Role::kOther;
  }
}

std::optional<CyclicFrameSet::LogicalByte> CyclicFrameSet::find_logical(std::uint32_t address) const {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto& command = *entries_[i].command;
    const bool reads = command.command == Command::kLrd || command.command == Command::kLrw;
    if (!reads || address < command.logical_address || address - command.logical_address >= command.length()) continue;
    return LogicalByte{i, address - command.logical_address};
  }
  return std::nullopt;
}

std::span<const std::uint8_t> CyclicFrameSet::read_logical(std::size_t number) const {
  const auto& entry = entries_[number];
  if (!entry.sent || !entry.datagram.done()) return {};
  return entry.data;
}

void CyclicFrameSet::correct_by_link() {
  for (auto& entry : entries_) entry.datagram.corrected_by_link = entry.role == Role::kReferenceWrite;
}

void CyclicFrameSet::select(AlState state) {
  for (auto& entry : entries_) {
    entry.selected = std::ranges::find(entry.command->states, state) != entry.command->states.end();
    if (!entry.selected) entry.read = false;
  }
}

bool CyclicFrameSet::reads_deviation() const {
  return std::ranges::any_of(entries_, [](const Entry& e) { return e.selected && e.role == Role::kDeviation; });
}

void CyclicFrameSet::prepare(std::int64_t slot, bool steer) {
  for (auto& frame : frames_) frame.clear();
  active_.clear();
  time_frame_ = write_frame_ = nullptr;
  for (auto& task : tasks_) task.due = task.turn.take(slot);
  for (auto& entry : entries_) {
    entry.sent = entry.selected && tasks_[entry.task].due;
    if (!entry.sent) continue;
    fill(entry, steer);
    entry.sent = frames_[entry.frame].add(entry.datagram);
    if (entry.sent && entry.role == Role::kReferenceTime) time_frame_ = &frames_[entry.frame];
    if (entry.sent && entry.role == Role::kReferenceWrite) write_frame_ = &frames_[entry.frame];
  }
  for (auto& frame : frames_) {
    if (!frame.empty()) active_.push_back(&frame);
  }
}

void CyclicFrameSet::fill(Entry& entry, bool steer) {
  const auto& command = *entry.command;
  std::ranges::fill(entry.data, std::uint8_t{0});
  if (entry.role == Role::kReferenceWrite) {
    address_leader(entry);
    if (!steer) entry.datagram.command = Command::kNop;
  } else if (command.command == Command::kLwr || command.command == Command::kLrw) {
    const auto begin = outputs_.begin() + command.output_offset + data_offset_;
    std::copy_n(begin, entry.data.size(), entry.data.begin());
  } else if (entry.role != Role::kReferenceTime) {
    std::ranges::copy(command.data, entry.data.begin());
  }
}

void CyclicFrameSet::stamp(const PendingFrame* frame, Nanoseconds reference_time,
                           std::optional<Nanoseconds> reference_write) {
  for (auto& entry : entries_) {
    if (&frames_[entry.frame] != frame) continue;
    if (entry.role == Role::kReferenceTime) fill_time(entry, reference_time);
    if (entry.role == Role::kReferenceWrite && reference_write) fill_time(entry, *reference_write);
  }
}

void CyclicFrameSet::fill_time(Entry& entry, Nanoseconds time) {
  if (entry.data.size() >= 8) {
    store_le(entry.data, static_cast<std::uint64_t>(time));
  } else {
    store_le(entry.data, static_cast<std::uint32_t>(time));
  }
  entry.told = static_cast<std::uint32_t>(time);
}

bool CyclicFrameSet::brought_outputs(std::size_t slave) const {
  if (writers_[slave].empty()) return std::ranges::all_of(active_, &PendingFrame::answered);
  return std::ranges::all_of(writers_[slave], [this](std::uint16_t entry) {
    return !entries_[entry].sent || entries_[entry].datagram.answered;
  });
}

PendingFrame* CyclicFrameSet::frame_with(bool outputs, std::size_t slave) {
  std::optional<std::size_t> found;
  for (const auto number : (outputs ? writers_ : readers_)[slave]) {
    const auto& entry = entries_[number];
    if (!entry.sent) continue;
    if (found && *found != entry.frame) return nullptr;
    found = entry.frame;
  }
  return found ? &frames_[*found] : nullptr;
}

CyclicFrameSet::Reading CyclicFrameSet::evaluate() {
  Reading reading;
  for (auto& entry : entries_) {
    if (!entry.sent) continue;
    if (entry.role == Role::kProcessData) {
      reading.wkc_expected = static_cast<std::uint16_t>(reading.wkc_expected + entry.command->expected_wkc.value_or(0) -
                                                        entry.wkc_without);
    }
    ++entry.unread;
    if (entry.datagram.answered) read(entry, reading);
  }
  return reading;
}

void CyclicFrameSet::take_attendance() {
  for (auto& entry : entries_) {
    entry.wkc_of_all = 0;
    entry.doubted = 0;
  }
}

/// Where somebody does not answer any more, it may be the clock that leads: then the time is the one that the master
/// has sent, or of the one who has its place now.
bool CyclicFrameSet::answered_by_leader(Entry& entry) {
  const auto wkc = entry.datagram.wkc;
  if (wkc == 0) return false;
  if (wkc < entry.wkc_of_all) {
    // By its station address nobody else puts a time into the datagram.
    const bool by_station = entry.datagram.command == Command::kFrmw;
    if (by_station && load_le<std::uint32_t>(entry.data) != entry.told) return true;
    if (++entry.doubted <= kMostDoubted) return false;
  }
  entry.wkc_of_all = wkc;
  entry.doubted = 0;
  return true;
}

void CyclicFrameSet::read(Entry& entry, Reading& reading) {
  const auto& datagram = entry.datagram;
  switch (entry.role) {
    case Role::kProcessData:
      reading.wkc_received = static_cast<std::uint16_t>(reading.wkc_received + datagram.wkc);
      // A wrong counter means that some slave's inputs are old: none are taken.
      if (datagram.wkc != *entry.command->expected_wkc - entry.wkc_without) return;
      break;
    case Role::kAlStatus:
      reading.al_status = load_le<std::uint16_t>(entry.data);
      reading.al_status_wkc = datagram.wkc;
      break;
    case Role::kReferenceTime:
      if (!answered_by_leader(entry)) return;
      reading.reference_is_64bit = entry.data.size() >= 8;
      reading.reference_time =
          reading.reference_is_64bit ? load_le<std::uint64_t>(entry.data) : load_le<std::uint32_t>(entry.data);
      break;
    case Role::kDeviation:
      if (datagram.wkc == 0) return;
      reading.deviation_ored = {SystemTimeDifference{load_le<std::uint32_t>(entry.data)}.magnitude(), datagram.wkc};
      break;
    case Role::kReferenceWrite:
      return;
    case Role::kOther:
      break;
  }
  entry.read = true;
  entry.unread = 0;
  store_inputs(entry);
  copy_slave_to_slave(entry);
}

void CyclicFrameSet::mark_known_inputs(std::span<std::uint8_t> known) const {
  std::ranges::fill(known, std::uint8_t{0});
  for (const auto& entry : entries_) {
    if (entry.command->command == Command::kLwr || !entry.read) continue;
    if (static_cast<Nanoseconds>(entry.unread) * entry.period > kOldInputs) continue;
    const auto begin = known.begin() + entry.command->input_offset + data_offset_;
    std::fill_n(begin, entry.data.size(), std::uint8_t{0xFF});
  }
}

std::size_t CyclicFrameSet::find_carriers(bool output, std::size_t first_byte, std::size_t count,
                                          std::span<Carrier> out) const {
  std::size_t found = 0;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto& command = *entries_[i].command;
    const bool carries = output ? command.command == Command::kLwr || command.command == Command::kLrw
                                : command.command != Command::kLwr;
    if (!carries) continue;
    const auto begin = std::size_t{output ? command.output_offset : command.input_offset} + data_offset_;
    unsigned bytes = 0;
    for (std::size_t byte = 0; byte < count; ++byte) {
      const auto place = first_byte + byte;
      if (place >= begin && place < begin + command.length()) bytes |= 1U << byte;
    }
    if (bytes == 0) continue;
    if (found < out.size()) out[found] = {static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(bytes)};
    ++found;
  }
  return found;
}

void CyclicFrameSet::store_inputs(const Entry& entry) {
  if (entry.command->command == Command::kLwr) return;
  std::ranges::copy(entry.data, inputs_.begin() + entry.command->input_offset + data_offset_);
}

void CyclicFrameSet::copy_slave_to_slave(const Entry& entry) {
  for (const auto& copy : entry.command->copy_infos) {
    const auto bits = std::min<std::size_t>(
        {copy.bit_size, bits_from(inputs_, copy.source_bit), bits_from(outputs_, copy.destination_bit)});
    copy_bits(outputs_, copy.destination_bit, inputs_, copy.source_bit, bits);
  }
}

}  // namespace syncline
