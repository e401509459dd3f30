// SPDX-License-Identifier: Apache-2.0
// What a recording says beside its samples: of whom it is, its documents, limits, signals, events and findings.
#include "record/recording_writer.h"

#include <fmt/format.h>

#include <string_view>

#include "record/recording_rows.h"
#include "record/recording_schema.h"
#include "record/watched_columns.h"

namespace syncline {
namespace {

using Form = SignalInfo::Form;
using Scope = SignalInfo::Scope;

constexpr std::string_view scope_name(Scope scope) {
  switch (scope) {
    case Scope::kBus:
      return "bus";
    case Scope::kSlave:
      return "slave";
    case Scope::kVariable:
      break;
  }
  return "variable";
}

constexpr std::string_view form_name(Form form) {
  switch (form) {
    case Form::kCell:
      return "cell";
    case Form::kCycles:
      return "cycles";
    case Form::kReadings:
      return "readings";
    case Form::kHeld:
      return "held";
    case Form::kDerived:
      return "derived";
    case Form::kWatched:
      return "watched";
  }
  return "cell";
}

}  // namespace

Status RecordingWriter::begin(const RecordingAbout& about) {
  auto transaction = SqlTransaction::begin(database_);
  if (!transaction) return tl::unexpected(transaction.error());
  auto status = put_meta("program", about.program);
  if (status) status = put_meta("link", about.link);
  if (status) status = put_meta("speed_counter_start", fmt::format("{}", about.speed_counter_start));
  if (status) status = put_documents(about.documents);
  if (status) status = put_limits(about.limits);
  if (status && about.armed) status = put_armed(*about.armed);
  auto slave = database_.prepare(insert_row("slave"));
  for (std::size_t i = 0; i < about.slaves.size(); ++i) {
    const auto& s = about.slaves[i];
    if (status && slave) {
      slave->bind(0, static_cast<std::int64_t>(i)).bind(1, s.name).bind(2, s.vendor_id);
      status = slave->bind(3, s.product_code).bind(4, s.revision_no).run();
      tally_.add("slave");
    }
  }
  if (status && !slave) status = tl::unexpected(slave.error());
  if (status) status = put_signals();
  if (status) status = put_watched(0, 0);
  if (status) status = tally_.write(database_);
  if (status) status = transaction->commit();
  // What was run stands in the file itself, so that a log that is lost does not take it along.
  if (status) status = database_.execute("PRAGMA wal_checkpoint(FULL);");
  return status;
}

Status RecordingWriter::put_documents(std::span<const RecordedDocument> documents) {
  auto row = database_.prepare(insert_row("document", true));
  if (!row) return tl::unexpected(row.error());
  for (const auto& document : documents) {
    auto status = row->bind(0, document.kind).bind(1, document.name).bind_blob(2, document.body).run();
    if (!status) return status;
    tally_.put("document", document.kind);
  }
  return {};
}

Status RecordingWriter::put_limits(const RunLimits& values) {
  auto limit = database_.prepare(insert_row("limits", true));
  if (!limit) return tl::unexpected(limit.error());
  const std::pair<std::string_view, std::int64_t> limits[] = {
      {"cycle_time", values.cycle_time}, {"deviation", values.deviation_ns}, {"dcm_error", values.dcm_error_ns}};
  for (const auto& [key, value] : limits) {
    if (auto status = limit->bind(0, key).bind(1, value).bind(2, std::string_view("ns")).run(); !status) return status;
    tally_.put("limits", key);
  }
  return {};
}

Status RecordingWriter::put_armed(Nanoseconds time) {
  return put_meta("armed", time == RecordingAbout::kNotArmed ? "not yet" : fmt::format("{}", time));
}

Status RecordingWriter::put_signals() {
  auto row = database_.prepare(insert_row("signal"));
  if (!row) return tl::unexpected(row.error());
  for (const auto& signal : signals()) {
    row->bind(0, static_cast<std::int64_t>(signal.id)).bind(1, signal.key).bind(2, signal.name).bind(3, signal.unit);
    row->bind(4, scope_name(signal.scope));
    row->bind(5, form_name(signal.form)).bind(6, signal.source).bind(7, signal.since);
    if (auto status = row->run(); !status) return status;
    tally_.add("signal");
  }
  return {};
}

Status RecordingWriter::add_lists(std::span<const std::vector<WatchedVariable>> lists) {
  if (lists.empty()) return {};
  const auto variables = lists_.variables().size();
  const auto known = lists_.lists().size();
  for (const auto& list : lists) (void)lists_.add(list);
  return put_watched(variables, known);
}

Status RecordingWriter::put_watched(std::size_t variables, std::size_t lists) {
  auto variable = database_.prepare(insert_row("variable"));
  if (!variable) return tl::unexpected(variable.error());
  for (auto i = variables; i < lists_.variables().size(); ++i) {
    const auto& what = lists_.variables()[i];
    variable->bind(0, static_cast<std::int64_t>(i)).bind(1, what.name);
    what.slave >= 0 ? variable->bind(2, std::int64_t{what.slave}) : variable->bind_null(2);
    variable->bind(3, what.output ? std::string_view("output") : std::string_view("input")).bind(4, what.data_type);
    variable->bind(5, std::int64_t{what.bit_offset}).bind(6, std::int64_t{what.bit_size});
    variable->bind(7, series_number(Signal::kVariable, static_cast<int>(i)));
    if (auto status = variable->run(); !status) return status;
    tally_.add("variable");
  }
  auto place = database_.prepare(insert_row("watch_list"));
  if (!place) return tl::unexpected(place.error());
  for (auto i = lists; i < lists_.lists().size(); ++i) {
    const auto& list = lists_.lists()[i];
    for (std::size_t at = 0; at < list.places.size(); ++at) {
      place->bind(0, std::int64_t{list.number}).bind(1, static_cast<std::int64_t>(at));
      if (auto status = place->bind(2, static_cast<std::int64_t>(list.places[at])).run(); !status) return status;
      tally_.add("watch_list");
    }
  }
  return {};
}

Status RecordingWriter::put_meta(std::string_view key, std::string_view value) {
  auto row = database_.prepare(insert_row("meta", true));
  if (!row) return tl::unexpected(row.error());
  tally_.put("meta", key);
  return row->bind(0, key).bind(1, value).run();
}

Status RecordingWriter::put_told(const RecordingBatch& batch) {
  Status status;
  auto event = database_.prepare(insert_row("event"));
  for (const auto& e : batch.events) {
    if (!status || !event) break;
    event->bind(0, ++events_).bind(1, e.time).bind(3, e.kind).bind(4, e.text);
    e.details.empty() ? event->bind_null(5) : event->bind_blob(5, e.details);
    status = (e.slave >= 0 ? event->bind(2, std::int64_t{e.slave}) : event->bind_null(2)).run();
  }
  tally_.add("event", static_cast<std::int64_t>(batch.events.size()));
  auto note = database_.prepare(insert_row("note"));
  for (const auto& n : batch.notes) {
    if (status && note) status = note->bind(0, ++notes_).bind(1, n.time).bind(2, n.text).run();
  }
  tally_.add("note", static_cast<std::int64_t>(batch.notes.size()));
  for (const auto* statement : {&event, &note}) {
    if (status && !*statement) status = tl::unexpected(statement->error());
  }
  if (status) status = put_documents(batch.documents);
  if (status && batch.standing) status = put_limits(batch.standing->limits);
  if (status && batch.standing) status = put_armed(batch.standing->armed.value_or(RecordingAbout::kNotArmed));
  return status && batch.findings ? put_findings(*batch.findings) : status;
}

/// In place of those that are there.
Status RecordingWriter::put_findings(std::span<const RecordedFinding> findings) {
  auto status = database_.execute("DELETE FROM finding");
  auto row = database_.prepare(insert_row("finding"));
  if (!row) return tl::unexpected(row.error());
  tally_.clear("finding");
  std::int64_t number = 0;
  for (const auto& finding : findings) {
    if (!status) break;
    row->bind(0, ++number).bind(1, finding.code).bind(2, finding.level).bind(4, finding.text);
    finding.details.empty() ? row->bind_null(5) : row->bind_blob(5, finding.details);
    status = (finding.slave >= 0 ? row->bind(3, std::int64_t{finding.slave}) : row->bind_null(3)).run();
  }
  tally_.add("finding", number);
  return status;
}

}  // namespace syncline
