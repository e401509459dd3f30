// SPDX-License-Identifier: Apache-2.0
#include "fuzz/text_targets.h"

#include "config/sim_config.h"
#include "protocol/datagram.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "sim/scenario/scenario_loader.h"
#include "sim/sim_bus.h"
#include "support/clock.h"
#include "tests/support/sample_devices.h"
#include "trace/dcm_log.h"

namespace syncline::fuzz {
namespace {

constexpr const char* kSourceName = "fuzz.toml";
constexpr std::size_t kFewSlaves = 6;

Result<sim::ScenarioDevice> some_device(const sim::DeviceQuery& query) {
  if (query.path.ends_with("servo")) return sim::ScenarioDevice{sample::servo(), {}};
  if (query.path.ends_with("output")) return sim::ScenarioDevice{sample::digital_output(), {}};
  return fail(Error{.code = ErrorCode::kFileNotFound, .subject = query.path, .file = kSourceName});
}

void run_for_a_while(const SimConfig& config) {
  constexpr auto kStart = VirtualClock::kDefaultStart;
  auto bus = sim::SimBus::create(config, kStart);
  if (!bus) return;
  FrameBuilder builder;
  (void)builder.add_zeros(Command::kBrd, 0, device_address(0, reg::kAlStatus), 2);
  const auto sent = builder.finish();
  for (Nanoseconds after = 0; after < 5 * kMillisecond; after += kMillisecond) {
    Bytes frame(sent.begin(), sent.end());
    (void)(*bus)->execute(frame, kStart + after);
    promise(frame.size() == sent.size());
  }
}

constexpr std::string_view kMachine = R"(name = "machine"
seed = 7
networks = 2
[host]
jitter = "quiet"
ppm = 12.5
[bus]
loss = 0.001
latch_noise_ns = 20
foreign_per_s = 10
[[slave]]
name = "Output"
esi = "output"
dc = "times"
ppm = -21.0
start_offset_ms = 12.0
[[slave]]
esi = "servo"
behaviour = "servo-y"
parent = 0
port = "B"
cable_m = 10.0
wander_ppm = 0.05
alias = 4
sii_read_ms = 1
[[slave]]
esi = "servo"
count = 2
spread_ppm = 30
esc = "et1100"
)";
constexpr std::string_view kFaults = R"([[slave]]
esi = "output"
[[slave]]
esi = "servo"
[[fault]]
kind = "lose-frames"
at_ms = 1
count = 3
[[fault]]
kind = "cable-break"
slave = 1
at_ms = 2
until_ms = 3
[[fault]]
kind = "clock-step"
slave = 1
at_ms = 1.5
value_ns = 1000
[[fault]]
kind = "refuse-state"
slave = 1
at_ms = 0
state = "SAFEOP"
code = 0x1e
[[latch]]
slave = 1
input = 0
at_ms = 1
period_ms = 1
width_ms = 0.1
count = 3
)";

}  // namespace

void run_scenario(std::span<const std::uint8_t> bytes) {
  const auto config = sim::parse_scenario(text_of(bytes), kSourceName, some_device);
  if (!config) return promise(!config.error().file.empty());
  promise(!config->slaves.empty());
  for (const auto& fault : config->faults) promise(fault.slave < static_cast<int>(config->slaves.size()));
  if (config->slaves.size() <= kFewSlaves) run_for_a_while(config->of_network(0));
}

std::vector<Bytes> scenarios() { return {bytes_of_text(kMachine), bytes_of_text(kFaults)}; }

void run_dcm_log(std::span<const std::uint8_t> bytes) {
  const auto written = [](const std::vector<DcmLogRow>& rows) {
    auto text = dcm_log_header();
    for (const auto& row : rows) append_dcm_log(text, row);
    return text;
  };
  const auto rows = read_dcm_log(text_of(bytes));
  if (!rows) return promise(rows.error().line >= 0);
  const auto text = written(*rows);
  const auto again = read_dcm_log(text);
  promise(again.has_value() && again->size() == rows->size());
  promise(written(*again) == text);
}

std::vector<Bytes> dcm_logs() {
  DcmLogRow row{1.5, 600'000, 820'000'000'123'456'789, 456'789, -12,  345,  300, -1.25, 0.5,
                3,   -17,     820'000'000'000'000'000, 0,       true, true, 20};
  auto text = dcm_log_header();
  append_dcm_log(text, row);
  row.system_time_difference_ns.reset();
  row.dcm_in_sync = false;
  append_dcm_log(text, row);
  auto commas = text;
  std::ranges::replace(commas, ';', ',');
  return {bytes_of_text(text), bytes_of_text(commas)};
}

}  // namespace syncline::fuzz
