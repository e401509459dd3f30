// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <memory>
#include <optional>

#include "app/cli/context.h"
#include "app/cli/duration.h"
#include "app/cli/event_text.h"
#include "app/cli/findings_text.h"
#include "app/cli/interrupt.h"
#include "app/cli/lateness.h"
#include "app/cli/run_json.h"
#include "app/composition/load_config.h"
#include "app/composition/run_network.h"
#include "trace/csv.h"

namespace syncline::cli {
namespace {

struct Options {
  std::string file, link, duration = "10s", csv, capture, state = "OP";
  bool json = false, lateness = false;
};

/// Streams the samples to FILE.part; the name appears when the run is over.
class CsvFile {
 public:
  Status open(const std::string& path) {
    path_ = path;
    out_.open(path + ".part", std::ios::binary | std::ios::trunc);
    if (!out_) return fail(Error{ErrorCode::kFileNotWritable, {}, "cannot create it", path});
    out_ << sample_csv_header();
    return {};
  }
  void add(std::span<const CycleSample> samples) {
    text_.clear();
    append_sample_csv(text_, samples);
    out_ << text_;
  }
  Status finish() {
    out_.close();
    if (out_.fail() || std::rename((path_ + ".part").c_str(), path_.c_str()) != 0) {
      return fail(Error{ErrorCode::kFileNotWritable, {}, "writing failed; is the disk full?", path_});
    }
    return {};
  }

 private:
  std::string path_, text_;
  std::ofstream out_;
};

void execute(Context& context, const Options& options) {
  const auto duration = parse_duration(options.duration);
  if (!duration) return context.fail_with(duration.error());
  const auto target = al_state_from_name(options.state);
  if (!target) return context.fail_with(Error{ErrorCode::kBadValue, "--state", "use INIT, PREOP, SAFEOP or OP"});
  const auto compiled = load_config(options.file);
  if (!compiled) return context.fail_with(compiled.error());
  print(context.console.err, compiled->findings);
  if (has_errors(compiled->findings)) {
    context.exit_code = kAnswerIsNo;
    return;
  }

  CsvFile csv;
  if (!options.csv.empty()) {
    if (auto status = csv.open(options.csv); !status) return context.fail_with(status.error());
  }
  RunRequest request;
  request.target = *target;
  request.duration = *duration;
  request.capture = options.capture;
  std::optional<Nanoseconds> first;
  Json events = Json::array();
  if (options.json) {
    request.on_event = [&events, &first](const Event& event) {
      if (!first) first = event.time;
      if (auto json = event_json(event, *first); !json.is_null()) events.push_back(std::move(json));
    };
  } else {
    request.on_event = [&context, &first](const Event& event) {
      if (!first) first = event.time;
      if (const auto line = event_text(event, *first); !line.empty()) context.console.err << line << '\n';
    };
  }
  LatenessReport lateness;
  if (!options.csv.empty() || options.lateness) {
    request.on_samples = [&](std::span<const CycleSample> samples) {
      if (!options.csv.empty()) csv.add(samples);
      lateness.add(samples);
    };
  }

  const InterruptGuard guard;
  request.stop = &guard.interrupted();
  const auto outcome = run_network(compiled->config, options.link, request);
  if (!outcome) return context.fail_with(outcome.error());
  if (!options.csv.empty()) {
    if (auto status = csv.finish(); !status) return context.fail_with(status.error());
  }
  if (options.json) {
    auto json = to_json(outcome->report);
    json["events"] = std::move(events);
    if (options.lateness) json["lateness"] = lateness.json();
    context.print(json);
  } else {
    context.console.out << to_text(outcome->report);
    if (options.lateness) context.console.out << lateness.text();
  }
  if (!is_good(outcome->report, *target)) context.exit_code = kAnswerIsNo;
  if (outcome->error) context.fail_with(*outcome->error);
}

}  // namespace

void add_run_command(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("run", "Bring a bus to OP with a project or an ENI and report how well it is in sync");
  auto options = std::make_shared<Options>();
  command->add_option("file", options->file, "Project or ENI file")->required();
  command->add_option("--link", options->link, "LINK")->required();
  command->add_option("--for", options->duration, "How long, e.g. 20s or 500ms")->capture_default_str();
  command->add_option("--state", options->state, "State to reach: INIT, PREOP, SAFEOP or OP")->capture_default_str();
  command->add_option("--csv", options->csv, "Write every cycle's sample to this file");
  command->add_option("--capture", options->capture, "Write every frame to this pcapng file");
  command->add_flag("--lateness", options->lateness, "Add how late the frames were sent, and the processor time of a cycle");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&context, options] { execute(context, *options); });
}

}  // namespace syncline::cli
