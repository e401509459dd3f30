// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "findings/acceptance_words.h"
#include "findings/finding.h"
#include "protocol/al_state.h"
#include "protocol/coe_abort_code.h"
#include "protocol/dcm_error.h"
#include "protocol/foe.h"
#include "reasons/reason_words.h"

namespace syncline {
namespace {

constexpr std::string_view kPhrases[] = {
    // directions and kinds in the rules of the ENI checker
    "inputs",
    "outputs",
    "nothing",
    "no SyncManager",
    "reads",
    "writes",
    "a mailbox",
    "for inputs",
    "for outputs",
    "active",
    "active for neither reading nor writing",
    "requests",
    "answers",
    "a mailbox for requests",
    "a mailbox for answers",
    "a buffer for outputs",
    "a buffer for inputs",
    "station addresses (0x0010)",
    "FMMUs (0x0600)",
    "SyncManagers (0x0800)",
    // values that an ENI's elements take
    "a decimal number from 0 to 255",
    "a decimal number from 0 to 65535",
    "a decimal number of 32 bits, negative from 2147483648 on",
    "a decimal number from -2147483648 to 2147483647",
    "a decimal number, or a hexadecimal one as #x1a00",
    "0, 1, true or false",
    "bytes of two hexadecimal digits each",
    "6 bytes of two hexadecimal digits each",
    "a transition such as IP or PS",
    "a transition on which SoE is allowed: PS, SO, SP, OP or OS",
    "INIT, PREOP, SAFEOP or OP",
    "B, C or D",
    "AoE, EoE, CoE, SoE, FoE or VoE",
    "MBoxOut, MBoxIn, Outputs or Inputs",
    "frame or cycle",
    "up to 4 of the letters Y, K and B",
    "text",
    // devices
    "drives",
    "gateways",
    "terminals",
    "none",
    "only the current loop is synchronised then, the position loop is not",
    "Interpolated position mode 1 needs SYNC0; only its mode 2 works without",
    "Cyclic synchronous position mode is executed with SYNC0 only",
    "Cyclic synchronous velocity mode is executed with SYNC0 only",
    "Cyclic synchronous torque mode is executed with SYNC0 only",
    "Cyclic synchronous position mode without SYNC0 gets its targets at no fixed distance from the servo period, and "
    "moves badly",
    "Cyclic synchronous velocity mode without SYNC0 gets its targets at no fixed distance from the servo period, and "
    "moves badly",
    "Cyclic synchronous torque mode without SYNC0 gets its targets at no fixed distance from the servo period, and "
    "moves badly",
    "Cyclic synchronous position mode needs SYNC0: without it targets come at no fixed distance from the servo period",
    "Cyclic synchronous velocity mode needs SYNC0: without it targets come at no fixed distance from the servo period",
    "Cyclic synchronous torque mode needs SYNC0: without it targets come at no fixed distance from the servo period",
    "only Sigma-X drives take it",
    "outputs count from their arrival",
    "inputs are not those of SYNC0",
    "An optional slave",
    "The first slave of a hot-connect group",
    // why slaves miss events and the master is out of sync
    "frames were lost",
    "the host left cycles out",
    "frames were held up on their way",
    "frames came behind the SYNC0 they were meant for",
    "the master was not locked to the reference clock, and frames slid through its SYNC0",
    "not seen by the master; look at its firmware and at frames that are damaged in front of it",
    "its own clock was out of its place",
    "its SYNC0 was started at another place",
    "no limit",
    "what else is told of that moment",
    "one of the slaves",
    "no reference clock leads",
    "the reference clock's time does not come",
    "the reference clock has stepped",
    "the controller reports an error",
    "the schedule is not within its limit",
    "cycles were left out, the host came too late",
    "a frame was sent later than the set value allows",
    "settling behind an interruption",
    "the reference clock is on its way to the external clock",
    "the external clock is not where the reference clock is",
    "it follows this host's clock, which a time service may have moved",
    "it was led back to this host's clock after the network adapter had been away",
    // fields of commands, in differences
    "data",
    "before slave",
    "own cycle",
    "own frame",
    "working counter",
    "retries",
    "time-out",
    "expected bytes",
    "expected mask",
    "comparison",
    "check time-out",
    "missing",
    "additional",
    // in events
    "master",
    "unknown",
    "info",
    "warning",
    "error",
};

constexpr std::uint32_t kLastFoeError = 0x8010;

}  // namespace

std::span<const std::string_view> finding_phrases() {
  static const std::vector<std::string_view> all = [] {
    std::vector<std::string_view> phrases(std::begin(kPhrases), std::end(kPhrases));
    const auto add = [&](std::string_view text) {
      if (!text.empty() && std::ranges::find(phrases, text) == phrases.end()) phrases.push_back(text);
    };
    for (unsigned code = 0; code <= 0xFFFF; ++code) {
      const auto text = al_status_code_text(static_cast<std::uint16_t>(code));
      add(text.meaning);
      add(text.check);
    }
    for (std::uint32_t code = dc::kDcmErrorUnspecific; code <= dc::kDcmErrorInvalidData; ++code) {
      add(dc::dcm_error_text(code));
    }
    for (const auto text : coe::abort_code_texts()) add(text);
    for (std::uint32_t code = foe::error::kNotDefined; code <= kLastFoeError; ++code) add(foe::error_text(code));
    for (const auto text : words::kReasons) add(text);
    for (const auto& criterion : words::kCriteria) add(criterion.name);
    for (const auto text : words::kVerdicts) add(text);
    for (const auto text : words::kAcceptancePhrases) add(text);
    return phrases;
  }();
  return all;
}

}  // namespace syncline
