// SPDX-License-Identifier: Apache-2.0
#include "ui/models/eeprom_lines.h"

#include <QCoreApplication>
#include <iterator>
#include <utility>

#include "protocol/sii.h"
#include "ui/text/joined_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

using EepromRows = RecordModel::Lines;

class EepromLines {
  Q_DECLARE_TR_FUNCTIONS(EepromLines)

 public:
  static EepromRows of(const sii::Image& image) {
    EepromLines lines;
    lines.identity(image);
    lines.mailboxes(image);
    lines.general(image);
    lines.memory(image);
    lines.pdos(tr("Outputs"), image.rx_pdos);
    lines.pdos(tr("Inputs"), image.tx_pdos);
    lines.clocks(image);
    for (const auto& other : image.other) {
      lines.add(tr("Category %1").arg(other.type), bitsText(static_cast<std::uint32_t>(8 * other.data.size())));
    }
    return std::move(lines.lines_);
  }

 private:
  void add(const QString& what, const QString& value) { lines_.push_back({what, value}); }

  void identity(const sii::Image& image) {
    add(tr("Checksum of the configuration"), image.checksum_ok ? tr("right") : tr("WRONG: the ESC does not load it"));
    add(tr("Alias"), QString::number(image.alias));
    add(tr("Vendor"), hexText(image.vendor_id, 8));
    add(tr("Product code"), hexText(image.product_code, 8));
    add(tr("Revision"), hexText(image.revision_no, 8));
    add(tr("Serial number"), hexText(image.serial_no, 8));
    add(tr("Size"), bitsText(8 * image.size_bytes));
    add(tr("PDI control"), hexText(image.pdi_control, 4));
    add(tr("PDI configuration"), hexText(image.pdi_configuration, 4));
    add(tr("Pulse length of SYNC signals"), timeText(10 * static_cast<Nanoseconds>(image.sync_impulse_length)));
  }

  static QString area(std::uint16_t offset, std::uint16_t size) {
    return size == 0 ? noText() : QStringLiteral("%1, %2").arg(hexText(offset, 4), bitsText(8U * size));
  }

  void mailboxes(const sii::Image& image) {
    add(tr("Mailbox to the slave (SM0)"), area(image.mailbox.receive_offset, image.mailbox.receive_size));
    add(tr("Mailbox from the slave (SM1)"), area(image.mailbox.send_offset, image.mailbox.send_size));
    const auto& boot = image.bootstrap_mailbox;
    add(tr("In BOOT to the slave"), area(boot.receive_offset, boot.receive_size));
    add(tr("In BOOT from the slave"), area(boot.send_offset, boot.send_size));
    QStringList protocols;
    const std::pair<std::uint16_t, const char*> kNames[] = {{sii::kProtocolAoe, "AoE"}, {sii::kProtocolEoe, "EoE"},
                                                            {sii::kProtocolCoe, "CoE"}, {sii::kProtocolFoe, "FoE"},
                                                            {sii::kProtocolSoe, "SoE"}, {sii::kProtocolVoe, "VoE"}};
    for (const auto& [bit, name] : kNames) {
      if ((image.mailbox_protocols & bit) != 0) protocols << QLatin1String(name);
    }
    add(tr("Mailbox protocols"), protocols.isEmpty() ? noText() : joinedParts(protocols));
  }

  void general(const sii::Image& image) {
    if (!image.general) return;
    add(tr("Name"), QString::fromStdString(image.general->name));
    add(tr("Order number"), QString::fromStdString(image.general->order));
    add(tr("Group"), QString::fromStdString(image.general->group));
    add(tr("E-bus current"), QStringLiteral("%1 mA").arg(image.general->ebus_current_ma));
  }

  void memory(const sii::Image& image) {
    const QString uses[] = {noText(), tr("Outputs"), tr("Inputs"), tr("Mailbox state")};
    int number = 0;
    for (const auto use : image.fmmus) {
      add(QStringLiteral("FMMU %1").arg(number++), use < std::size(uses) ? uses[use] : noText());
    }
    number = 0;
    for (const auto& one : image.sync_managers) {
      add(QStringLiteral("SyncManager %1").arg(number++),
          tr("%1, control %2").arg(area(one.start, one.length), hexText(one.control, 2)));
    }
  }

  void pdos(const QString& direction, const std::vector<sii::Pdo>& pdos) {
    for (const auto& pdo : pdos) {
      add(QStringLiteral("%1 %2").arg(direction, hexText(pdo.index, 4)), QString::fromStdString(pdo.name));
      for (const auto& entry : pdo.entries) {
        add(QStringLiteral("    ") + objectText(entry.index, entry.sub_index),
            QStringLiteral("%1, %2").arg(QString::fromStdString(entry.name), bitsText(entry.bit_length)));
      }
    }
  }

  void clocks(const sii::Image& image) {
    for (const auto& mode : image.dc_modes) {
      add(tr("Distributed clocks: %1").arg(QString::fromStdString(mode.name)),
          tr("AssignActivate %1, SYNC0 %2, shift %3")
              .arg(hexText(mode.assign_activate, 4), cycleText(mode.cycle_time_sync0),
                   cycleText(mode.shift_time_sync0)));
    }
  }

  EepromRows lines_;
};

}  // namespace

RecordModel::Lines eepromLines(const sii::Image& image) { return EepromLines::of(image); }

QString hexView(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kLine = 16;
  QString text;
  for (std::size_t begin = 0; begin < bytes.size(); begin += kLine) {
    text += hexText(begin / 2, 4) + QStringLiteral("  ");
    QString letters;
    for (std::size_t i = begin; i < begin + kLine; ++i) {
      if (i >= bytes.size()) break;
      text += QStringLiteral("%1 ").arg(bytes[i], 2, 16, QLatin1Char('0'));
      letters += bytes[i] >= 0x20 && bytes[i] < 0x7F ? QChar(char16_t{bytes[i]}) : QChar(u'.');
    }
    text += u' ' + letters + u'\n';
  }
  return text;
}

}  // namespace syncline::ui
