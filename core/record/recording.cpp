// SPDX-License-Identifier: Apache-2.0
#include "record/recording.h"

#include <algorithm>
#include <iterator>

#include "findings/recording_words.h"
#include "record/run_record.h"
#include "record/typed_values.h"

namespace syncline {

RecordingAbout about_run(const NetworkConfig& config) {
  RecordingAbout about;
  about.limits = limits_of(config);
  about.speed_counter_start = speed_counter_start_of(config);
  about.sync0 = sync0_slaves(config);
  for (const auto& slave : config.slaves) {
    const auto& id = slave.identity;
    about.slaves.push_back({slave.name, id.vendor_id, id.product_code, id.revision_no});
  }
  return about;
}

RecordingAbout about_run(const RunRecord& run) {
  auto about = about_run(run.config());
  const auto standing = run.standing();
  about.limits = standing.limits;
  about.armed = standing.armed.value_or(RecordingAbout::kNotArmed);
  about.watched = run.watched();
  return about;
}

bool is_about_file(const Finding& finding) {
  return std::ranges::find(words::kRecording, finding.code, &FindingWords::code) != std::end(words::kRecording);
}

std::vector<RecordedFinding> recorded(std::span<const Finding> findings) {
  std::vector<RecordedFinding> result;
  for (const auto& finding : findings) {
    result.push_back({std::string(finding.code), std::string(severity_name(finding.severity)), finding.place.slave,
                      describe(finding), encode_finding(finding)});
  }
  return result;
}

}  // namespace syncline
