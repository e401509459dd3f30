// SPDX-License-Identifier: Apache-2.0
// The ENI of a thousand slaves against tinyxml2 printing the finished document.
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <tinyxml2.h>

#include "bench/ratio_report.h"
#include "compare/compare_configs.h"
#include "compile/compile.h"
#include "eni/check/eni_check.h"
#include "eni/format/eni_file.h"
#include "eni/project/line_wiring.h"
#include "findings/error_text.h"
#include "tests/support/sample_devices.h"

namespace syncline::bench {
namespace {

constexpr std::size_t kSlaves = 1'000;
constexpr double kSecondNs = 1e9, kMiB = 1024 * 1024;

/// Couplers, terminals and drives in the proportions of the small sample machine, over and over.
Project thousand_slaves() {
  auto project = sample::small_machine();
  const auto pattern = project.slaves;
  project.slaves.clear();
  for (std::size_t i = 0; i < kSlaves; ++i) {
    project.slaves.push_back(default_slave(pattern[i % pattern.size()].device, static_cast<std::uint16_t>(i)));
  }
  eni::wire_in_order(project.slaves);
  return project;
}

double peak_mib() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024 / kMiB;
}

/// As the command does: both files are read, then compared; once the same, once with something else in every slave.
void bench_compare(RatioReport& report, const NetworkConfig& config, const std::string& text, double read) {
  const auto again = eni::parse_eni(text, "bench.xml");
  if (!again) return report.add_failure("compare", describe(again.error()));
  auto other = *again;
  for (auto& slave : other.slaves) slave.alias = static_cast<std::uint16_t>(slave.alias + 1);
  const auto same = compare_configs(config, *again), different = compare_configs(config, other);
  if (!same.empty() || different.size() < kSlaves) {
    return report.add_failure("compare", fmt::format("{} and {} differences found", same.size(), different.size()));
  }
  const double equal = median_ns([&] { (void)compare_configs(config, *again); }, 3);
  const double all = median_ns([&] { (void)compare_configs(config, other); }, 3);
  report.add("read and compare two equal ones", 2 * read + equal, "a second", kSecondNs, 1);
  report.add("read and compare, every slave different", 2 * read + all, "a second", kSecondNs, 1);
}

void bench_write(RatioReport& report) {
  const auto project = thousand_slaves();
  const double peak_before = peak_mib();
  const auto compiled = compile(project);
  if (!compiled) return report.add_failure("ENI of 1000 slaves", describe(compiled.error()));
  const auto text = eni::write_eni(compiled->config);
  const double peak = peak_mib();
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
    return report.add_failure("ENI of 1000 slaves", "is no XML");

  const double print = median_ns([&] {
    tinyxml2::XMLPrinter printer;
    document.Print(&printer);
  });
  const double compile_only = median_ns([&] { (void)compile(project); });
  const double write_only = median_ns([&] { (void)eni::write_eni(compiled->config); });
  const double both = median_ns([&] { (void)eni::write_eni(compile(project)->config); });
  const auto baseline = fmt::format("tinyxml2 prints {:.1f} MiB", static_cast<double>(text.size()) / kMiB);
  report.add("compile 1000 slaves", compile_only, baseline, print, 0);
  report.add("write the ENI", write_only, baseline, print, 0);
  report.add("compile and write an ENI of 1000 slaves", both, baseline, print, 2);
  report.add_count("peak memory of it, beside the project", peak - peak_before, "MiB", peak_before, "MiB before", 0);
  const double read = median_ns([&] { (void)eni::parse_eni(text, "bench.xml"); }, 3);
  report.add("read it again", read, "a second", kSecondNs, 1);
  const auto findings = eni::check_eni_text(text, "bench.xml");
  if (!findings || !findings->understood) return report.add_failure("check", "the file was not understood");
  const double check = median_ns([&] { (void)eni::check_eni_text(text, "bench.xml"); }, 3);
  report.add(fmt::format("check it ({} findings)", findings->findings.size()), check, "a second", kSecondNs, 1);
  bench_compare(report, compiled->config, text, read);
}

}  // namespace
}  // namespace syncline::bench

int main() {
  syncline::bench::RatioReport report;
  syncline::bench::bench_write(report);
  return report.finish("ENI of a large machine");
}
