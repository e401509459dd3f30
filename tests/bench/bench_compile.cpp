// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "bench/ratio_report.h"
#include "compile/incremental.h"
#include "eni/esi/esi_reader.h"
#include "findings/error_text.h"
#include "settings/settings_keys.h"
#include "tests/support/source_dir.h"

/// What an edit of a project with 500 slaves costs until its findings are there, against compiling the whole.
namespace syncline::bench {
namespace {

constexpr std::size_t kSlaves = 500;
constexpr double kPromiseNs = 50e6;

/// Servo drives with their dictionaries, couplers and terminals in turn.
Result<Project> large_project() {
  std::vector<DeviceDescription> devices;
  for (const char* name : {"SL-1100", "SL-SV7", "SL-XE2", "SL-2002", "SL-3002"}) {
    const auto file = eni::read_esi(fmt::format("{}/resources/esi/{}.xml", test::source_dir(), name));
    if (!file) return tl::unexpected(file.error());
    devices.push_back(file->devices.front());
  }
  Project project;
  for (std::size_t i = 0; i < kSlaves; ++i) {
    project.slaves.push_back(default_slave(devices[i % devices.size()], static_cast<std::uint16_t>(i)));
  }
  return project;
}

/// Time of an update after the same edit to and fro.
double edit_ns(const Project& project, const std::string& key, const std::string& one, const std::string& other) {
  Project edited = project;
  IncrementalCompiler compiler;
  static_cast<void>(compiler.update(edited));
  bool odd = false;
  return median_ns([&] {
    odd = !odd;
    static_cast<void>(set_setting(edited, key, odd ? one : other));
    static_cast<void>(compiler.update(edited));
  });
}

void bench_edits(RatioReport& report, const Project& project) {
  const double whole = median_ns([&] { static_cast<void>(compile(project)); });
  const std::string baseline = fmt::format("compile of {} slaves", kSlaves);
  const auto edit = [&](const std::string& what, const std::string& key, const std::string& one,
                        const std::string& other) {
    const double took = edit_ns(project, key, one, other);
    report.add(what, took, baseline, whole, 0);
    report.add(what + ", promised", took, "50 ms", kPromiseNs, 1.0);
  };
  edit("name of a slave", "slave.250.name", "Valve", "Pump");
  edit("PDOs of a slave, all behind it move", "slave.1.pdo.tx", "",
       get_setting(project, "slave.1.pdo.tx").value_or(""));
  edit("cycle time", "master.cycle_time_us", "1000", "2000");
  report.add("compile, promised too", whole, "50 ms", kPromiseNs, 0);
}

}  // namespace
}  // namespace syncline::bench

int main() {
  using namespace syncline;
  bench::RatioReport report;
  if (const auto project = bench::large_project()) {
    bench::bench_edits(report, *project);
  } else {
    report.add_failure("project", describe(project.error()));
  }
  return report.finish("compile");
}
