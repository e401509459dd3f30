// SPDX-License-Identifier: Apache-2.0
#include "exports/export_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <clocale>
#include <regex>

#include "compile/compile.h"
#include "findings/recovered_words.h"
#include "findings/sentence.h"
#include "tests/support/sample_devices.h"

namespace syncline::exports {
namespace {

using testing::HasSubstr;
using testing::Not;

struct Reported {
  Project project = sample::small_machine();
  ReportFacts facts{.project = "press.syncline",
                    .date = "2026-03-01 14:05 UTC",
                    .program = "Syncline 1.2",
                    .dialect = "EC-Engineer",
                    .eni_file = "press.eni.xml",
                    .eni_bytes = 12345};
  NetworkConfig config() { return compile(project).value().config; }
  std::string report() {
    facts.source = &project;
    return export_report(config(), facts);
  }
};

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

TEST(ExportReport, DocumentsWhatWasExported) {
  Reported reported;
  reported.project.master.dc.sync_window = {true, 7, 1500};
  reported.project.slaves[3].dc.sync0.shift = 50 * kMicrosecond;
  reported.project.slaves[3].device.vendor_name = "Drives Ltd";
  reported.project.slaves[2].alias = 42;
  reported.project.master.sync_units = {{"fast", ""}};
  reported.project.slaves[1].input_unit = "fast";
  reported.facts.unsaid = {{"master.dc.burst_total", "Burst, frames", "10000 frames"}};
  const auto report = reported.report();
  for (const char* part :
       {"press.syncline", "2026-03-01 14:05 UTC", "Syncline 1.2", "press.eni.xml, 12345 bytes", "EC-Engineer",
        "Drives Ltd (0x", "<td>42</td>", "<td>0x00010002</td>", "reference clock", "<td>1 ms</td>", "<td>50 us</td>",
        "127 ns (2^7 - 1), settle time 1500 ms", "bus-shift", "BRD 0:0x092c", "Burst, frames", "10000 frames",
        "The check finds nothing", "fast", "<svg xmlns="}) {
    EXPECT_THAT(report, HasSubstr(part));
  }
  for (const auto& slave : reported.config().slaves) {
    EXPECT_THAT(report, HasSubstr("<td>" + slave.name + "</td>"));
    EXPECT_THAT(report, HasSubstr("<td>" + std::to_string(slave.station_address) + "</td>"));
  }
  EXPECT_EQ(report, reported.report()) << "the same bytes";
}

/// One file that opens anywhere: nothing is fetched, nothing runs, and each element is closed.
TEST(ExportReport, IsOneFileWithoutScripts) {
  const auto report = Reported{}.report();
  for (const char* part : {"<script", "<link", "<img", "<iframe", "@import", "url(", "src=", "href=", "<?xml"})
    EXPECT_THAT(report, Not(HasSubstr(part)));
  EXPECT_EQ(count_of(report, "http"), 1U) << "the name space of the drawing";
  // As XML but for the one element that HTML does not close.
  const auto xml = std::regex_replace(report, std::regex("<meta[^>]*>|<!DOCTYPE html>"), "");
  tinyxml2::XMLDocument parsed;
  EXPECT_EQ(parsed.Parse(xml.c_str()), tinyxml2::XML_SUCCESS) << parsed.ErrorStr();
}

TEST(ExportReport, NobodysNameBecomesMarkup) {
  Reported reported;
  const std::string hostile = "<script>alert(1)</script>\" onload=\"x & y";
  reported.project.slaves[3].name = hostile;
  reported.project.slaves[3].device.vendor_name = hostile;
  reported.project.slaves[3].device.type = hostile;
  reported.project.master.name = hostile;
  reported.facts.project = reported.facts.eni_file = reported.facts.date = hostile;
  reported.facts.program = reported.facts.dialect = hostile;
  reported.facts.unsaid = {{hostile, hostile, hostile}};
  reported.facts.findings = {make_finding<words::kRecovered>("eni-layout-kept", Place{3}, fig::text<"file">(hostile))};
  const auto report = reported.report();
  EXPECT_THAT(report, HasSubstr("<td>&lt;script&gt;alert(1)&lt;/script&gt;&quot; onload=&quot;x &amp; y</td>"));
  EXPECT_THAT(report, Not(HasSubstr("<script")));
  EXPECT_THAT(report, Not(HasSubstr("onload=\"")));
  reported.project.slaves[3].name = "a\xFF\n<b>";
  EXPECT_THAT(reported.report(), HasSubstr("<td>a? &lt;b&gt;</td>"));
}

TEST(ExportReport, OrdersFindingsBySeverity) {
  Reported reported;
  reported.facts.findings = {
      make_finding<words::kRecovered>("clock-settings-unknown", {}),
      make_finding<words::kRecovered>("project-not-compiled", {}, fig::text<"reason">("why & how")),
      make_finding<words::kRecovered>("cycle-time-unknown", {}, fig::time<"cycle">(kMillisecond))};
  const auto report = reported.report();
  EXPECT_THAT(report, HasSubstr("1 error, 1 warning, 1 note"));
  EXPECT_THAT(report, HasSubstr("why &amp; how"));
  const auto error = report.find("r-error\""), warning = report.find("r-warning\""), note = report.find("r-note\"");
  EXPECT_LT(error, warning);
  EXPECT_LT(warning, note);
  EXPECT_NE(note, std::string::npos);
}

TEST(ExportReport, SaysWhatAnEniDoesNotHold) {
  Reported reported;
  const auto report = export_report(reported.config(), reported.facts);
  EXPECT_THAT(report, HasSubstr("it was read from an ENI"));
  EXPECT_THAT(report, HasSubstr("not known"));
  EXPECT_THAT(report, Not(HasSubstr("bus-shift"))) << "an ENI does not say it";
}

TEST(ExportReport, WritesNumbersWithoutTheLocale) {
  Reported reported;
  reported.project.master.cycle_time = 1'250'500;
  const auto plain = reported.report();
  EXPECT_THAT(plain, HasSubstr("1.2505 ms"));
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "de_DE.utf8", "C.UTF-8"}) std::setlocale(LC_ALL, locale);
  EXPECT_EQ(reported.report(), plain);
  std::setlocale(LC_ALL, before.c_str());
}

TEST(ExportReport, TakesAnEmptyNetwork) { EXPECT_THAT(export_report(NetworkConfig{}, {}), HasSubstr("</html>")); }

}  // namespace
}  // namespace syncline::exports
