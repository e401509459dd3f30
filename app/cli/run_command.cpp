// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/cli/command_files.h"
#include "app/cli/context.h"
#include "app/cli/duration.h"
#include "app/cli/event_lines.h"
#include "app/cli/event_text.h"
#include "app/cli/findings_text.h"
#include "app/cli/interrupt.h"
#include "app/cli/lateness.h"
#include "app/cli/options.h"
#include "app/cli/run_black_box.h"
#include "app/cli/run_json.h"
#include "app/cli/run_overrides.h"
#include "app/cli/run_recording.h"
#include "app/cli/terminal_reason.h"
#include "app/composition/open_link.h"
#include "channels/master_channels.h"
#include "compile/compile.h"
#include "config/watched_variable.h"
#include "engine/opened_link.h"
#include "engine/run_network.h"
#include "findings/error_text.h"
#include "protocol/object_value.h"
#include "record/dcm_log_session.h"
#include "sim/scenario/host_profile_file.h"
#include "support/counted.h"
#include "support/jitter_profile.h"
#include "support/output_file.h"
#include "support/whole_file.h"
#include "trace/csv.h"
#include "trace/host_recorder.h"
#include "trace/watch_lists.h"

namespace syncline::cli {
namespace {

struct RunOptions {
  std::string file, network, link, duration = "10s", csv, dcm_log, capture, save_host, state = "OP";
  RecordOptions record;
  BlackBoxOptions black_box;
  std::vector<std::string> overrides, sdo_reads, watched;
  bool json = false, lateness = false, every_event = false;
};

/// One table of a run. When writing fails that is said at once, and the run goes on without it.
class SideFile {
 public:
  explicit SideFile(Context& context) : context_(context) {}
  Status open(const std::string& path) {
    auto file = OutputFile::create(path);
    if (!file) return tl::unexpected(file.error());
    file_.emplace(std::move(*file));
    return {};
  }
  [[nodiscard]] bool is_open() const { return file_.has_value(); }
  void add(std::string_view text) {
    keep(file_->write(text));
    if (file_) keep(file_->flush());
  }
  void finish() {
    if (file_) keep(file_->finish());
    file_.reset();
  }

 private:
  void keep(const Status& status) {
    if (status) return;
    context_.fail_with(status.error());
    file_.reset();
  }

  Context& context_;
  std::optional<OutputFile> file_;
};

/// The tables of a run that are written while it goes on.
class RunFiles {
 public:
  RunFiles(Context& context, const WatchLists& watched) : csv_(context), log_file_(context), watched_(watched) {}
  Status open_csv(const std::string& path) {
    auto status = csv_.open(path);
    if (status) csv_.add(sample_csv_header(watched_));
    return status;
  }
  Status open_log(const std::string& path, const NetworkConfig& config) {
    auto status = log_file_.open(path);
    if (status) log_.emplace(config, [this](std::string_view text) { log_file_.add(text); });
    return status;
  }
  void add(std::span<const CycleSample> samples) {
    if (csv_.is_open()) {
      text_.clear();
      append_sample_csv(text_, samples, watched_);
      csv_.add(text_);
    }
    if (log_file_.is_open()) log_->add(samples);
  }
  void note(const Snapshot& snapshot) {
    if (log_) log_->add(snapshot);
  }
  void finish() {
    csv_.finish();
    log_file_.finish();
  }

 private:
  SideFile csv_, log_file_;
  const WatchLists& watched_;
  std::optional<DcmLogSession> log_;
  std::string text_;
};

/// One list, of all that are named.
Result<WatchLists> watched_of(const RunOptions& options, const NetworkConfig& config) {
  WatchLists watched;
  if (options.watched.empty()) return watched;
  if (options.csv.empty() && options.record.file.empty())
    return fail(ErrorCode::kBadValue, "--watch",
                in_terminal("only --csv and --record hold variables: add one of them"));
  std::vector<WatchedVariable> variables;
  for (const auto& text : options.watched) {
    auto variable = find_watchable(config, text);
    if (!variable) return fail(ErrorCode::kBadValue, "--watch " + text, variable.error().detail);
    if (std::ranges::find(variables, *variable) == variables.end()) variables.push_back(std::move(*variable));
  }
  if (!watched.add(variables)) {
    return fail(
        ErrorCode::kBadValue, "--watch",
        in_terminal(fmt::format("{} variables are named, at most {} can be watched", variables.size(), kMostWatched)));
  }
  return watched;
}

/// SLAVE:INDEX:SUB of each.
Result<std::vector<SlaveRequest>> requests_of(const RunOptions& options, std::size_t slaves) {
  std::vector<SlaveRequest> requests;
  for (const auto& text : options.sdo_reads) {
    const auto bad = [&](Reason why) { return fail(ErrorCode::kBadValue, "--sdo-read " + text, std::move(why)); };
    const auto colon = text.find(':');
    std::uint16_t slave = 0;
    const auto* const end = text.data() + std::min(colon, text.size());
    const auto [rest, failed] = std::from_chars(text.data(), end, slave);
    if (colon == std::string::npos || failed != std::errc() || rest != end)
      return bad(in_terminal("use SLAVE:INDEX:SUB, e.g. 1:0x1018:01"));
    if (slave >= slaves)
      return bad(in_terminal(fmt::format("the configuration has only {}, counted from 0", counted(slaves, "slave"))));
    const auto object = object_name(text.substr(colon + 1));
    if (!object) return bad(object.error().detail);
    requests.emplace_back(requests::SdoRead{slave, {object->index, object->sub_index}});
  }
  return requests;
}

Json answer_json(const SlaveRequest& request, const SlaveAnswer& answer) {
  Json json{{"slave", slave_of(request)}, {"subject", subject_of(request)}};
  if (answer.error) json["error"] = describe(*answer.error);
  if (!answer.error) json["bytes"] = value_text(kBytesType, answer.data);
  return json;
}

/// By their times. What is told together has the time of its first one, and comes when later ones have been told.
Json in_order(std::vector<std::pair<Nanoseconds, Json>> events) {
  std::ranges::stable_sort(events, {}, &std::pair<Nanoseconds, Json>::first);
  Json rows = Json::array();
  for (auto& event : events) rows.push_back(std::move(event.second));
  return rows;
}

/// What the run has shown of its host, for a scenario's `[host] profile`.
void save_host(Context& context, const RunOptions& options, const HostRecorder& host, const NetworkConfig& config) {
  if (host.cycles() < HostRecorder::kLeastCycles) {
    return context.fail_with_words(
        fmt::format("{} was not written: a host profile needs {} cycles with process data, the run had {}{}",
                    options.save_host, HostRecorder::kLeastCycles,
                    host.cycles() == 0 ? "none" : fmt::format("{}", host.cycles()),
                    host.cycles() == 0 ? "" : "; run longer (--for)"),
        kFailed);
  }
  const auto about = fmt::format("Measured by synclinectl run on {}: {} cycles of {} us with process data.",
                                 options.link, host.cycles(), config.cycle_time() / kMicrosecond);
  const auto status = write_whole_file(options.save_host, sim::host_profile_text(host.profile(), about));
  if (!status) context.fail_with(status.error());
}

/// The manual's name for a log that is on without another name.
constexpr const char* kUsualLog = "dcmlog0.0.csv";

Status check_files(const RunOptions& options, bool log_is_on) {
  return CommandFiles()
      .reads("file", options.file)
      .reads_link("--link", options.link)
      .writes("--csv", options.csv)
      .writes("--dcm-log", options.dcm_log)
      .writes("the setting master.dc.log (name its file with --dcm-log)", log_is_on ? kUsualLog : "")
      .writes("--capture", options.capture)
      .writes("--save-host", options.save_host)
      .writes_database("--record", options.record.file)
      .check();
}

Status open_files(RunFiles& files, const RunOptions& options, bool log_is_on, const NetworkConfig& config) {
  auto status = options.csv.empty() ? Status{} : files.open_csv(options.csv);
  const auto log = log_is_on ? kUsualLog : options.dcm_log;
  if (status && !log.empty()) status = files.open_log(log, config);
  return status;
}

void execute(Context& context, const RunOptions& options) {
  const auto duration = parse_duration(options.duration);
  if (!duration) return context.fail_with(duration.error());
  const auto target = al_state_from_name(options.state);
  if (!target)
    return context.fail_with(Error{ErrorCode::kBadValue, "--state", in_terminal("use INIT, PREOP, SAFEOP or OP")});
  const auto compiled = load_with_overrides(options.file, options.network, options.overrides);
  if (!compiled) return context.fail_with(compiled.error());
  print(context.console.err, compiled->findings);
  if (has_errors(compiled->findings)) {
    context.exit_code = kAnswerIsNo;
    if (!options.json) return;
    Json findings = Json::array();
    for (const auto& finding : compiled->findings) findings.push_back(to_json(finding));
    context.print({{"findings", std::move(findings)}});
    return context.note_error("the project has errors, so that there is nothing to run");
  }

  const bool log_is_on = options.dcm_log.empty() && compiled->config.dc.dcm.log;
  if (const auto distinct = check_files(options, log_is_on); !distinct) return context.fail_with(distinct.error());
  auto requests = requests_of(options, compiled->config.slaves.size());
  if (!requests) return context.fail_with(requests.error());
  const auto watched = watched_of(options, compiled->config);
  if (!watched) return context.fail_with(watched.error());
  auto opened = open_link(options.link);
  if (!opened) return context.fail_with(opened.error());

  const bool virtual_time = opened->clock->is_virtual();
  RunFiles files(context, *watched);
  if (const auto status = open_files(files, options, log_is_on, compiled->config); !status)
    return context.fail_with(status.error());
  const auto started = RunRecording::start(context, options.record, options.file, options.link, compiled->config,
                                           *watched, virtual_time);
  if (!started) return context.fail_with(started.error());
  auto& recording = **started;
  RunBlackBox black_box(context, options.black_box);
  RunRequest request;
  request.target = *target;
  request.duration = *duration;
  request.watch = watched->command();
  request.capture = options.capture;
  request.on_capture_lost = [&context](const Error& error) { context.fail_with(error); };
  request.on_ready = [&](MasterChannels& channels) {
    return black_box.start(channels, options.file, options.link, virtual_time);
  };
  std::optional<Nanoseconds> first;
  std::vector<std::pair<Nanoseconds, Json>> events;
  EventLines lines([&context](const std::string& line) { context.console.err << line << '\n'; }, !options.every_event);
  if (options.json) {
    request.on_event = [&events, &first, &recording, &black_box](const Event& event) {
      recording.add(event);
      black_box.add(event);
      if (!first) first = event.time;
      if (auto json = event_json(event, *first); !json.is_null()) events.emplace_back(event.time, std::move(json));
    };
  } else {
    request.on_event = [&lines, &recording, &black_box](const Event& event) {
      recording.add(event);
      black_box.add(event);
      lines.add(event);
    };
  }
  request.requests = std::move(*requests);
  Json answers = Json::array();
  request.on_answer = [&](const SlaveRequest& what, const SlaveAnswer& answer) {
    if (answer.error) context.fail_with(*answer.error);
    if (options.json) {
      answers.push_back(answer_json(what, answer));
    } else if (!answer.error) {
      context.console.out << fmt::format("slave {}, {}: {}\n", slave_of(what), subject_of(what),
                                         value_text(kBytesType, answer.data));
    }
  };
  LatenessReport lateness;
  HostRecorder host(compiled->config.cycle_time());
  request.on_snapshot = [&files, &lines, &lateness, &recording, &black_box](const Snapshot& snapshot) {
    files.note(snapshot);
    recording.add(snapshot);
    black_box.tell();
    lateness.note(snapshot.host);
    lines.tell_until(snapshot.time);
  };
  request.on_samples = [&files, &lateness, &host, &options, &recording](std::span<const CycleSample> samples) {
    files.add(samples);
    recording.add(samples);
    lateness.add(samples);
    if (!options.save_host.empty()) host.add(samples);
  };

  const InterruptGuard guard;
  request.stop = &guard.interrupted();
  const auto outcome = run_network(compiled->config, std::move(opened), request);
  lines.tell_all();
  if (!outcome) return context.fail_with(outcome.error());
  files.finish();
  recording.finish(outcome->report);
  black_box.finish();
  if (!options.save_host.empty()) save_host(context, options, host, compiled->config);
  if (options.json) {
    auto json = to_json(outcome->report);
    json["events"] = in_order(std::move(events));
    if (!answers.empty()) json["answers"] = std::move(answers);
    if (options.lateness) json["lateness"] = lateness.json();
    if (black_box.is_on()) json["black_box"] = black_box.json();
    context.print(std::move(json));
  } else {
    context.console.out << to_text(outcome->report);
    if (options.lateness) context.console.out << lateness.text();
    if (black_box.is_on()) context.console.out << black_box.text();
  }
  const bool good = is_good(outcome->report, *target);
  if (outcome->left_behind) context.fail_with(*outcome->left_behind);
  if (outcome->error) context.fail_with(*outcome->error);
  // A bus that was operated has given its answer, and the report says it.
  const bool answered = outcome->report.cycles > 0 || !(outcome->left_behind || outcome->error);
  if (answered && (!good || outcome->left_behind || outcome->error)) context.exit_code = kAnswerIsNo;
}

}  // namespace

void add_run_command(CLI::App& app, Context& context) {
  auto* command =
      app.add_subcommand("run", "Bring a bus to OP with a project or an ENI and report how well it is in sync");
  auto options = std::make_shared<RunOptions>();
  command->add_option("file", options->file, "Project or ENI file")->required();
  command->add_option("--network", options->network, "Network of a project that holds several: name or number");
  command->add_option("--link", options->link, "LINK")->required();
  command->add_option("--for", options->duration, "How long, e.g. 20s or 500ms")->capture_default_str();
  command->add_option("--state", options->state, "State to reach: INIT, PREOP, SAFEOP or OP")->capture_default_str();
  command->add_option("--csv", options->csv, "Write every cycle's sample to this file");
  command->add_option("--watch", options->watched,
                      "A variable of the process image, by its name or as SLAVE.ENTRY, e.g. \"3.Position actual "
                      "value\": --csv and --record hold it in every cycle; up to 16");
  command->add_option("--dcm-log", options->dcm_log, "Write the log of the master synchronisation to this file");
  command->add_option(
      "--set", options->overrides,
      "KEY=VALUE for this run, e.g. dcm.set_value_us=400; KEY is one of the project's, for an ENI one of those "
      "master.dc.* that are not in the file; dcm. stands for master.dc.");
  command->add_option("--capture", options->capture, "Write every frame to this pcapng file");
  add_record_options(*command, options->record);
  add_black_box_options(*command, options->black_box);
  command->add_option("--sdo-read", options->sdo_reads,
                      "SLAVE:INDEX:SUB, e.g. 1:0x1018:01: read this object while the bus runs, and print its bytes");
  command->add_flag("--lateness", options->lateness,
                    "Add how late the frames were sent, and the processor time of a cycle");
  auto* every =
      command->add_flag("--every-event", options->every_event,
                        "A line for every event; without it what happens to many slaves at one time is one line");
  command->add_option(
      "--save-host", options->save_host,
      "Write what the run showed of its host (wake-ups, send stamps, stalls) to this file, for a scenario");
  // Its events are all of them.
  command->add_flag("--json", options->json, "Print JSON")->excludes(every);
  command->callback([&context, options] { execute(context, *options); });
}

}  // namespace syncline::cli
