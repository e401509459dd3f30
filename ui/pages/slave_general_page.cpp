// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_general_page.h"

#include <QFileInfo>
#include <QLabel>

#include "ui/editors/field_binder.h"
#include "ui/editors/text_edit.h"
#include "ui/session/running_slave.h"
#include "ui/session/workspace.h"
#include "ui/text/glossary.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

/// The user's, or else the device's.
QString timeoutText(const Project& project, int slave, const char* key) {
  const auto ms = settings::effective_value(settings::row(key), project, {.slave = static_cast<std::size_t>(slave)});
  return timeText(std::get<std::int64_t>(ms) * kMillisecond);
}

QString withDecimal(std::uint32_t value, int digits) {
  return QStringLiteral("%1 (%2)").arg(hexText(value, digits)).arg(value);
}

}  // namespace

SlaveGeneralPage::SlaveGeneralPage(Workspace& workspace) : Page(workspace, "slaveGeneralPage", tr("General")) {
  auto* columns = new CardColumns;
  buildIdentity(*columns->add(0, tr("Device")));
  buildAddresses(*columns->add(1, tr("Address")));
  buildPlace(*columns->add(0, tr("Place on the Bus")));
  auto* checks = columns->add(1, tr("Checks at Start-up"));
  fields().toggle(*checks, "checkVendor", "slave.N.check.vendor");
  fields().toggle(*checks, "checkProduct", "slave.N.check.product");
  fields().toggle(*checks, "checkRevision", "slave.N.check.revision");
  fields().keys(*checks, {"slave.N.check.revision_rule"});
  fields().toggle(*checks, "checkSerial", "slave.N.check.serial");
  fields().keys(*checks, {"slave.N.check.alias", "slave.N.check.device_id"});
  buildState(*columns->add(2, tr("State")));
  buildTimeouts(*columns->add(2, tr("Time-outs")));
  columns->addStretch();
  setWidget(columns);
}

void SlaveGeneralPage::buildIdentity(Card& card) {
  fields().text(card, "slaveName", "slave.N.name");
  type_ = card.addValue("slaveType", tr("Type"), tr("ESI Device/Type"));
  vendor_ = card.addValue("slaveVendor", tr("Vendor"), tr("SII word 0x0008, ESI Vendor/Id"));
  product_ = card.addValue("slaveProduct", tr("Product code"), tr("SII word 0x000A, ESI Type@ProductCode"));
  revision_ = card.addValue("slaveRevision", tr("Revision"), tr("SII word 0x000C, ESI Type@RevisionNo"));
  serial_ = card.addValue("slaveSerial", tr("Serial number"), tr("SII word 0x000E"));
  source_ =
      card.addValue("slaveSource", tr("Described by"), tr("File or EEPROM that the device description came from"));
  source_->setWordWrap(true);
}

void SlaveGeneralPage::buildAddresses(Card& card) {
  fields().number(card, "slaveAddress", "slave.N.station_address");
  fields().number(card, "slaveAlias", "slave.N.alias");
  auto_increment_ = card.addValue("slaveAutoIncrement", tr("Auto-increment"),
                                  tr("Position address used before the station address is set"));
}

void SlaveGeneralPage::buildPlace(Card& card) {
  auto* previous = fields().textField("slavePrevious", "slave.N.previous");
  card.addRow(previous->accessibleName(), previous, previous->toolTip());
  previous_ = card.addValue("slavePreviousName", tr("In front"), tr("Slave and port in front of this one"));
  fields().keys(card, {"slave.N.optional", "slave.N.hot_connect"});
}

void SlaveGeneralPage::buildState(Card& card) {
  state_ = named(new Pill, "slaveState", tr("Current state"));
  card.addRow(tr("Current state"), state_, tr("AL status (register 0x0130)"));
  status_code_ = card.addValue("slaveStatusCode", tr("AL status code"), tr("Register 0x0134"));
  meaning_ = new QLabel;
  meaning_->setObjectName(QStringLiteral("slaveStatusMeaning"));
  meaning_->setAccessibleName(tr("Meaning of the AL status code"));
  meaning_->setWordWrap(true);
  meaning_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  card.addWide(meaning_);
}

void SlaveGeneralPage::buildTimeouts(Card& card) {
  preop_ = card.addValue("timeoutPreop", tr("INIT to PREOP"), tr("ESI Timeout/PreopTimeout"));
  safeop_op_ = card.addValue("timeoutSafeopOp", tr("PREOP to SAFEOP to OP"), tr("ESI Timeout/SafeopOpTimeout"));
  to_init_ = card.addValue("timeoutInit", tr("Back to INIT"), tr("ESI Timeout/BackToInitTimeout"));
  to_safeop_ = card.addValue("timeoutSafeop", tr("Back to SAFEOP"), tr("ESI Timeout/BackToSafeopTimeout"));
}

void SlaveGeneralPage::refresh() {
  const auto& project = workspace().document().project();
  if (node() < 0 || static_cast<std::size_t>(node()) >= project.slaves.size()) return;
  const auto& slave = project.slaves[static_cast<std::size_t>(node())];
  const auto& device = slave.device;
  fields().refresh();
  type_->setText(QString::fromStdString(device.type));
  type_->setToolTip(QString::fromStdString(device.name));
  const auto vendor = hexText(device.identity.vendor_id, 8);
  vendor_->setText(device.vendor_name.empty()
                       ? vendor
                       : QStringLiteral("%1 %2").arg(vendor, QString::fromStdString(device.vendor_name)));
  product_->setText(hexText(device.identity.product_code, 8));
  revision_->setText(hexText(device.identity.revision_no, 8));
  serial_->setText(device.identity.serial_no == 0 ? tr("any") : withDecimal(device.identity.serial_no, 8));
  source_->setText(QFileInfo(QString::fromStdString(device.source)).fileName());
  source_->setToolTip(QString::fromStdString(device.source));
  auto_increment_->setText(hexText(Position{static_cast<std::uint16_t>(node())}.auto_increment_address(), 4));
  previous_->setText(
      slave.previous
          ? tr("%1, port %2").arg(nodeName(project, slave.previous->position)).arg(QChar(u'A' + slave.previous->port))
          : QString::fromStdString(project.master.name));
  preop_->setText(timeoutText(project, node(), "slave.N.timeout.preop_ms"));
  safeop_op_->setText(timeoutText(project, node(), "slave.N.timeout.safeop_op_ms"));
  to_init_->setText(timeoutText(project, node(), "slave.N.timeout.back_to_init_ms"));
  to_safeop_->setText(timeoutText(project, node(), "slave.N.timeout.back_to_safeop_ms"));
}

void SlaveGeneralPage::showLive(const Snapshot&) {
  const auto running = runningSlave(workspace(), node());
  if (!running || running->status == nullptr) {
    state_->setState(theme::Tone::kNeutral, tr("Offline"));
    status_code_->setText(QStringLiteral("\u2013"));
    meaning_->hide();
    return;
  }
  const auto& status = *running->status;
  const auto state = status.present ? al_state_of(status.al_status) : AlState::kNone;
  const bool failed = (status.al_status & kAlErrorFlag) != 0;
  state_->setState(failed ? theme::Tone::kBad : theme::stateTone(state),
                   failed ? tr("%1 + error").arg(stateName(state)) : stateName(state));
  status_code_->setText(hexText(status.al_status_code, 4));
  const auto text = al_status_code_text(status.al_status_code);
  meaning_->setText(QStringLiteral("%1. %2").arg(fromView(text.meaning), fromView(text.check)));
  meaning_->setVisible(status.al_status_code != 0);
}

}  // namespace syncline::ui
