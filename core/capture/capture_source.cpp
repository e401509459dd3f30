// SPDX-License-Identifier: Apache-2.0
#include "capture/capture_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "findings/recording_words.h"
#include "findings/sentence.h"
#include "link/link.h"

namespace syncline {
namespace {

constexpr std::size_t kAddresses = 12, kTag = 4;
constexpr std::uint16_t kEtherCat = 0x88A4, kVlan = 0x8100;
/// A mirror port that is given both what comes into a port and what leaves another one sends a frame twice in a row. A
/// master does not: a frame of the shortest length and its gap last 6.7 us at 100 Mbit/s, and its next one is a cycle
/// away.
constexpr Nanoseconds kTwice = 20 * kMicrosecond;

/// Destinations of frames that bridges send for themselves: spanning tree (IEEE 802.1D), and Cisco's CDP and PVST.
constexpr std::array<std::array<std::uint8_t, 6>, 3> kOfSwitches{
    {{0x01, 0x80, 0xC2, 0x00, 0x00, 0x00}, {0x01, 0x00, 0x0C, 0xCC, 0xCC, 0xCC}, {0x01, 0x00, 0x0C, 0xCC, 0xCC, 0xCD}}};

/// First bytes of the addresses that hypervisors give to their adapters (IEEE's list of organisations; 52:54:00 by
/// custom), without the bit that the first slave sets.
constexpr std::array<std::array<std::uint8_t, 3>, 8> kOfMachines{{{0x00, 0x0C, 0x29},    // VMware
                                                                  {0x00, 0x50, 0x56},    // VMware
                                                                  {0x00, 0x05, 0x69},    // VMware
                                                                  {0x08, 0x00, 0x27},    // VirtualBox
                                                                  {0x50, 0x54, 0x00},    // QEMU, KVM
                                                                  {0x00, 0x15, 0x5D},    // Hyper-V
                                                                  {0x00, 0x16, 0x3E},    // Xen
                                                                  {0x00, 0x1C, 0x42}}};  // Parallels

std::uint16_t word_at(std::span<const std::uint8_t> frame, std::size_t at) {
  return static_cast<std::uint16_t>(frame[at] << 8 | frame[at + 1]);
}

}  // namespace

bool CaptureSource::add(std::span<const std::uint8_t> frame, Nanoseconds time) {
  if (frame.size() < kAddresses + kTag + 2) return true;
  const auto is_to = [&](const auto& address) { return std::equal(address.begin(), address.end(), frame.begin()); };
  if (std::ranges::any_of(kOfSwitches, is_to)) ++of_switches_;
  const bool tagged = word_at(frame, kAddresses) == kVlan;
  if (word_at(frame, tagged ? kAddresses + kTag : kAddresses) != kEtherCat) return true;
  if (tagged) ++tagged_;
  if (!before_.empty() && time - time_before_ < kTwice && std::ranges::equal(frame, before_)) {
    ++twice_;
    return false;
  }
  before_.assign(frame.begin(), frame.end());
  time_before_ = time;
  const auto source = frame.subspan(6, 6);
  const std::array<std::uint8_t, 3> maker{static_cast<std::uint8_t>(source[0] & ~kLocallyAdministered), source[1],
                                          source[2]};
  if (std::ranges::find(kOfMachines, maker) != kOfMachines.end() && virtual_++ == 0)
    std::ranges::copy(source, adapter_.begin());
  return true;
}

void CaptureSource::tell(std::vector<Finding>& findings) const {
  using words::kRecording;
  if (of_switches_ > 0)
    findings.push_back(make_finding<kRecording>("import-switch", {}, fig::count<"count">(of_switches_)));
  if (tagged_ > 0)
    findings.push_back(make_finding<kRecording>("import-switch/tagged", {}, fig::count<"count">(tagged_)));
  if (twice_ > 0) findings.push_back(make_finding<kRecording>("import-switch/twice", {}, fig::count<"count">(twice_)));
  if (virtual_ == 0) return;
  const auto& a = adapter_;
  findings.push_back(
      make_finding<kRecording>("import-virtual-machine", {}, fig::count<"count">(virtual_),
                               fig::text<"address">(fmt::format("{:02x}:{:02x}:{:02x}:{:02x}:{:02x}:{:02x}", a[0], a[1],
                                                                a[2], a[3], a[4], a[5]))));
}

}  // namespace syncline
