// SPDX-License-Identifier: Apache-2.0
#include "record/dcm_log_session.h"

#include <utility>

#include "channels/cycle_sample.h"
#include "channels/snapshot.h"
#include "config/network_config.h"

namespace syncline {
namespace {

Nanoseconds set_value_of(const NetworkConfig& config) {
  return effective_set_value(config.dc.dcm, config.cycle_time());
}

}  // namespace

DcmLogSession::DcmLogSession(const NetworkConfig& config, Write write)
    : set_value_(set_value_of(config)),
      cycle_time_(config.cycle_time()),
      log_(set_value_, cycle_time_),
      write_(std::move(write)) {
  write_(dcm_log_header());
}

bool DcmLogSession::suits(const NetworkConfig& config) const {
  return set_value_ == set_value_of(config) && cycle_time_ == config.cycle_time();
}

void DcmLogSession::add(std::span<const CycleSample> samples) {
  text_.clear();
  for (const auto& sample : samples) {
    if (const auto row = log_.row(sample)) append_dcm_log(text_, *row);
  }
  if (!text_.empty()) write_(text_);
}

/// Of a master that is silent nothing is known, its start time neither.
void DcmLogSession::add(const Snapshot& snapshot) {
  if (snapshot.online) log_.set_start_time(snapshot.dc.start_time);
}

}  // namespace syncline
