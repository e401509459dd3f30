// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_counters_page.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

#include "ui/models/record_model.h"
#include "ui/session/workspace.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {
namespace {

std::vector<std::uint32_t> totalsOf(const SlaveEvidence& evidence) {
  auto all = portTotals(evidence.ports);
  all.push_back(evidence.processing_unit_errors.total);
  all.push_back(evidence.pdi_errors.total);
  all.push_back(evidence.process_data_watchdog.total);
  all.push_back(evidence.pdi_watchdog.total);
  return all;
}

QTableView* tableOf(RecordModel& model, const char* object_name, const QString& name) {
  auto* table = named(new QTableView, object_name, name);
  setUpTable(*table);
  table->setModel(&model);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  return table;
}

}  // namespace

SlaveCountersPage::SlaveCountersPage(Workspace& workspace)
    : OnlinePage(workspace, "slaveCountersPage", tr("Counters")) {
  ports_ = new RecordModel(
      {tr("Port"), tr("Invalid frames"), tr("Receive errors"), tr("Forwarded errors"), tr("Lost links")}, this);
  others_ = new RecordModel({tr("Counter"), tr("Total"), tr("Register"), tr("Read")}, this);
  auto* layout = build();
  port_table_ = tableOf(*ports_, "portCounters", tr("Error counters of the ports"));
  layout->addWidget(port_table_);
  age_ = new QLabel;
  age_->setObjectName(QStringLiteral("portCountersAge"));
  layout->addWidget(age_);
  other_table_ = tableOf(*others_, "otherCounters", tr("Other counters"));
  layout->addWidget(other_table_);
  means_ =
      new QLabel(tr("Counts since going online, or since the statistics were cleared. Invalid frames at a port: the "
                    "fault is on the cable or the plug at this port. Forwarded errors alone: it is further in front."));
  means_->setObjectName(QStringLiteral("countersHelp"));
  means_->setWordWrap(true);
  layout->addWidget(means_);
  layout->addStretch(1);
}

void SlaveCountersPage::slaveChanged() {
  history_.clear();
  last_.reset();
  ports_->setLines({});
  others_->setLines({});
  age_->clear();
}

QString SlaveCountersPage::ageText(Nanoseconds time, std::optional<Nanoseconds> now) const {
  if (time == 0) return tr("not yet");
  if (!now) return tr("in the last run");
  return agoText(*now - time);
}

void SlaveCountersPage::tick(std::optional<Nanoseconds> now) {
  const auto slave = running();
  if (now && slave && slave->status != nullptr) {
    last_ = slave->status->evidence;
    history_.add(*now, totalsOf(*last_));
  } else if (!now) {
    history_.clear();  // what has ended grows no more
  }
  if (!last_) return;
  showPorts(*last_);
  age_->setText(tr("Read: %1 (registers 0x0300 to 0x0313)").arg(ageText(last_->ports_time, now)));
  showOthers(*last_, now);
  for (auto* table : {port_table_, other_table_}) fitRows(*table);
}

void SlaveCountersPage::showPorts(const SlaveEvidence& evidence) {
  RecordModel::Lines lines;
  for (std::size_t port = 0; port < evidence.ports.size(); ++port) {
    const auto& one = evidence.ports[port];
    const std::uint32_t counts[kCountersOfPort] = {one.invalid_frames, one.receive_errors, one.forwarded_errors,
                                                   one.lost_links};
    QStringList line{tr("Port %1 (%2)").arg(port).arg(QChar(static_cast<char16_t>(u'A' + port)))};
    for (std::size_t i = 0; i < kCountersOfPort; ++i) {
      const bool known = evidence.ports_time != 0;
      line << (known
                   ? growingText(counts[i], one.at_least && counts[i] > 0, history_.growth(kCountersOfPort * port + i))
                   : noText());
    }
    lines.push_back(line);
  }
  ports_->setLines(lines);
}

void SlaveCountersPage::showOthers(const SlaveEvidence& evidence, std::optional<Nanoseconds> now) {
  const auto first = kCountersOfPort * evidence.ports.size();
  const auto& process_data = evidence.process_data_watchdog;
  const auto& pdi = evidence.pdi_watchdog;
  const auto counted = [&](const EvidenceCount& count, std::size_t n) {
    return count.valid() ? growingText(count.total, count.at_least, history_.growth(n)) : noText();
  };
  const auto& processing = evidence.processing_unit_errors;
  const auto& interface = evidence.pdi_errors;
  others_->setLines(
      {{tr("Processing unit errors"), counted(processing, first), hexText(0x030C, 4), ageText(processing.time, now)},
       {tr("PDI errors"), counted(interface, first + 1), hexText(0x030D, 4), ageText(interface.time, now)},
       {tr("Process data watchdog expired"), counted(process_data, first + 2), hexText(0x0442, 4),
        ageText(process_data.time, now)},
       {tr("PDI watchdog expired"), counted(pdi, first + 3), hexText(0x0443, 4), ageText(pdi.time, now)}});
}

}  // namespace syncline::ui
