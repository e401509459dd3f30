// SPDX-License-Identifier: Apache-2.0
// What a recording says beside its samples: of whom it is, its documents, limits, signals, events and findings.
#include "record/recording_writer.h"

#include <fmt/format.h>

#include <string_view>

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
  auto slave = database_.prepare(
      "INSERT INTO slave(position, name, vendor_id, product_code, revision_no) VALUES(?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < about.slaves.size(); ++i) {
    const auto& s = about.slaves[i];
    if (status && slave) {
      slave->bind(0, static_cast<std::int64_t>(i)).bind(1, s.name).bind(2, s.vendor_id);
      status = slave->bind(3, s.product_code).bind(4, s.revision_no).run();
    }
  }
  if (status && !slave) status = tl::unexpected(slave.error());
  if (status) status = put_signals();
  if (status) status = put_watched(0, 0);
  return status ? transaction->commit() : status;
}

Status RecordingWriter::put_documents(std::span<const RecordedDocument> documents) {
  auto row = database_.prepare("INSERT OR REPLACE INTO document(kind, name, body) VALUES(?, ?, ?)");
  if (!row) return tl::unexpected(row.error());
  for (const auto& document : documents) {
    auto status = row->bind(0, document.kind).bind(1, document.name).bind_blob(2, document.body).run();
    if (!status) return status;
  }
  return {};
}

Status RecordingWriter::put_limits(const RunLimits& values) {
  auto limit = database_.prepare("INSERT OR REPLACE INTO limits(key, value, unit) VALUES(?, ?, 'ns')");
  if (!limit) return tl::unexpected(limit.error());
  const std::pair<std::string_view, std::int64_t> limits[] = {
      {"cycle_time", values.cycle_time}, {"deviation", values.deviation_ns}, {"dcm_error", values.dcm_error_ns}};
  for (const auto& [key, value] : limits) {
    if (auto status = limit->bind(0, key).bind(1, value).run(); !status) return status;
  }
  return {};
}

Status RecordingWriter::put_armed(Nanoseconds time) {
  return put_meta("armed", time == RecordingAbout::kNotArmed ? "not yet" : fmt::format("{}", time));
}

Status RecordingWriter::put_signals() {
  auto row = database_.prepare(
      "INSERT INTO signal(id, key, name, unit, scope, form, source, since) VALUES(?, ?, ?, ?, ?, ?, ?, ?)");
  if (!row) return tl::unexpected(row.error());
  for (const auto& signal : signals()) {
    row->bind(0, static_cast<std::int64_t>(signal.id)).bind(1, signal.key).bind(2, signal.name).bind(3, signal.unit);
    row->bind(4, scope_name(signal.scope));
    row->bind(5, form_name(signal.form)).bind(6, signal.source).bind(7, signal.since);
    if (auto status = row->run(); !status) return status;
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
  auto variable = database_.prepare(
      "INSERT INTO variable(id, name, slave, direction, data_type, bit_offset, bit_size, series) VALUES(?, ?, ?, ?, ?, "
      "?, ?, ?)");
  if (!variable) return tl::unexpected(variable.error());
  for (auto i = variables; i < lists_.variables().size(); ++i) {
    const auto& what = lists_.variables()[i];
    variable->bind(0, static_cast<std::int64_t>(i)).bind(1, what.name);
    what.slave >= 0 ? variable->bind(2, std::int64_t{what.slave}) : variable->bind_null(2);
    variable->bind(3, what.output ? std::string_view("output") : std::string_view("input")).bind(4, what.data_type);
    variable->bind(5, std::int64_t{what.bit_offset}).bind(6, std::int64_t{what.bit_size});
    variable->bind(7, series_number(Signal::kVariable, static_cast<int>(i)));
    if (auto status = variable->run(); !status) return status;
  }
  auto place = database_.prepare("INSERT INTO watch_list(number, place, variable) VALUES(?, ?, ?)");
  if (!place) return tl::unexpected(place.error());
  for (auto i = lists; i < lists_.lists().size(); ++i) {
    const auto& list = lists_.lists()[i];
    for (std::size_t at = 0; at < list.places.size(); ++at) {
      place->bind(0, std::int64_t{list.number}).bind(1, static_cast<std::int64_t>(at));
      if (auto status = place->bind(2, static_cast<std::int64_t>(list.places[at])).run(); !status) return status;
    }
  }
  return {};
}

Status RecordingWriter::put_meta(std::string_view key, std::string_view value) {
  auto row = database_.prepare("INSERT OR REPLACE INTO meta(key, value) VALUES(?, ?)");
  if (!row) return tl::unexpected(row.error());
  return row->bind(0, key).bind(1, value).run();
}

Status RecordingWriter::put_told(const RecordingBatch& batch) {
  Status status;
  auto event = database_.prepare("INSERT INTO event(time_ns, slave, kind, text, details) VALUES(?, ?, ?, ?, ?)");
  for (const auto& e : batch.events) {
    if (!status || !event) break;
    event->bind(0, e.time).bind(2, e.kind).bind(3, e.text);
    e.details.empty() ? event->bind_null(4) : event->bind_blob(4, e.details);
    status = (e.slave >= 0 ? event->bind(1, std::int64_t{e.slave}) : event->bind_null(1)).run();
  }
  auto note = database_.prepare("INSERT INTO note(time_ns, text) VALUES(?, ?)");
  for (const auto& n : batch.notes) {
    if (status && note) status = note->bind(0, n.time).bind(1, n.text).run();
  }
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
  auto row = database_.prepare("INSERT INTO finding(code, level, slave, text, details) VALUES(?, ?, ?, ?, ?)");
  if (!row) return tl::unexpected(row.error());
  for (const auto& finding : findings) {
    if (!status) break;
    row->bind(0, finding.code).bind(1, finding.level).bind(3, finding.text);
    finding.details.empty() ? row->bind_null(4) : row->bind_blob(4, finding.details);
    status = (finding.slave >= 0 ? row->bind(2, std::int64_t{finding.slave}) : row->bind_null(2)).run();
  }
  return status;
}

}  // namespace syncline
