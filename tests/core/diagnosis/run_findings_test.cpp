// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/run_findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace syncline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Three slaves in OP, everything in sync.
RunReport healthy() {
  RunReport report;
  report.state = AlState::kOp;
  for (std::uint16_t i = 0; i < 3; ++i) {
    RunReport::Slave slave;
    slave.position = i;
    slave.al_status = 8;
    slave.deviation_ns = 5;
    report.slaves.push_back(slave);
  }
  report.slaves[2].sm2_missed = Sm2MissedStatus{true, 0, 0x1C32, 0x0B};
  report.dc.enabled = report.dc.monitored = true;
  report.dc.state = SyncState::kInSync;
  report.dc.limit_ns = 127;
  report.dcm.mode = DcmMode::kBusShift;
  report.dcm.state = SyncState::kInSync;
  return report;
}

std::vector<DiagnosisCode> codes(const RunReport& report) {
  std::vector<DiagnosisCode> all;
  for (const auto& finding : diagnose(report)) all.push_back(finding.code);
  return all;
}

TEST(RunFindings, AHealthyRunHasNone) { EXPECT_THAT(diagnose(healthy()), IsEmpty()); }

TEST(RunFindings, ASlaveInErrorIsNamedWithItsCode) {
  auto report = healthy();
  report.slaves[1].al_status = 0x14;
  report.slaves[1].al_status_code = 0x001A;
  const auto findings = diagnose(report);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0], (DiagnosisFinding{DiagnosisCode::kSlaveError, DiagnosisSeverity::kError, 1, 0x14, 0x1A}));
  EXPECT_THAT(describe(findings[0]), HasSubstr("0x001A"));
}

TEST(RunFindings, ASlaveBehindTheOthersIsToldApartFromAnError) {
  auto report = healthy();
  report.slaves[0].al_status = 4;
  EXPECT_THAT(codes(report), ElementsAre(DiagnosisCode::kSlaveLeftState));
}

TEST(RunFindings, OutOfSyncNamesTheWorstSlave) {
  auto report = healthy();
  report.dc.state = SyncState::kOutOfSync;
  report.slaves[1].deviation_ns = -900;
  const auto findings = diagnose(report);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].slave, 1);
  EXPECT_EQ(findings[0].a, 900);
}

TEST(RunFindings, NotMonitoredIsANoteAndNeverInSync) {
  auto report = healthy();
  report.dc.monitored = false;
  report.dc.state = SyncState::kNotMonitored;
  const auto findings = diagnose(report);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].severity, DiagnosisSeverity::kNote);
  EXPECT_THAT(describe(findings[0]), HasSubstr("not monitored"));
}

TEST(RunFindings, AMasterThatIsNotToBeLockedIsNoFinding) {
  auto report = healthy();
  report.dcm.state = SyncState::kBusy;
  EXPECT_THAT(codes(report), ElementsAre(DiagnosisCode::kMasterNotLocked));
  report.dcm.control_off = true;
  EXPECT_THAT(codes(report), IsEmpty());
}

TEST(RunFindings, MissedSm2EventsMeanDifferentThingsLockedAndUnlocked) {
  auto report = healthy();
  report.slaves[2].sm2_missed->value = 7;
  EXPECT_THAT(codes(report), ElementsAre(DiagnosisCode::kSm2MissedLocked));
  report.dcm.state = SyncState::kBusy;
  EXPECT_THAT(codes(report), ElementsAre(DiagnosisCode::kMasterNotLocked, DiagnosisCode::kSm2MissedUnlocked))
      << "the cause comes before its consequence";
}

TEST(RunFindings, DriftBeyondBalanceReplacesNotLocked) {
  auto report = healthy();
  report.dcm.state = SyncState::kBusy;
  report.dcm.drift_ppm = -750;
  EXPECT_THAT(codes(report), ElementsAre(DiagnosisCode::kDriftTooHigh));
}

TEST(RunFindings, CountersAreWarnings) {
  auto report = healthy();
  report.wkc_errors = 1;
  report.lost_frames = 2;
  report.overruns = 3;
  EXPECT_THAT(codes(report), ElementsAre(DiagnosisCode::kWorkingCounter, DiagnosisCode::kFramesLost, DiagnosisCode::kOverruns));
}

}  // namespace
}  // namespace syncline
