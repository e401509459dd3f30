// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// The words of the acceptance of a run, for report, command line and window (core/reports/acceptance.h).
namespace syncline::words {

struct CriterionWords {
  std::string_view key;   // for programs
  std::string_view name;  // English
};
/// By the number of reports::Criterion::Kind.
inline constexpr CriterionWords kCriteria[] = {
    {"watched_for", "Watched for"},
    {"state", "State of the master"},
    {"slaves_in_sync", "Slaves against their reference clock"},
    {"master_in_sync", "Reference clock against the master"},
    {"sm2_missed", "SM2 events missed"},
    {"lost_frames", "Frames lost"},
    {"wkc_errors", "Cycles with another working counter than expected"},
    {"left_out_cycles", "Cycles left out by the host"},
    {"faults", "Disturbances"},
    {"findings", "Findings"},
};

/// By the number of reports::Verdict.
inline constexpr std::string_view kVerdicts[] = {"kept", "NOT KEPT", "not judged"};

/// What is required and what was found, where no figure stands for it.
inline constexpr std::string_view kAsLongAsItWas = "as long as it was";
inline constexpr std::string_view kOpAtTheEnd = "OP at the end";
inline constexpr std::string_view kInSyncThroughout = "in sync throughout";
inline constexpr std::string_view kNoErrorNoWarning = "no error, no warning";
inline constexpr std::string_view kNeverInSync = "never: it was not in sync in OP";
inline constexpr std::string_view kStateUnknown = "unknown: a slave does not answer, or it is not told";
inline constexpr std::string_view kNeverArmed = "not counted: it was never armed";
inline constexpr std::string_view kNoCounterKnown = "no slave has a counter that is known";
inline constexpr std::string_view kNotTold = "not told";
inline constexpr std::string_view kAcceptancePhrases[] = {
    kAsLongAsItWas, kOpAtTheEnd, kInSyncThroughout, kNoErrorNoWarning, kNeverInSync,
    kStateUnknown,  kNeverArmed, kNoCounterKnown,   kNotTold,
};

}  // namespace syncline::words
