// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_eeprom_page.h"

#include <QFileDialog>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QSpinBox>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "support/byte_order.h"
#include "support/whole_file.h"
#include "ui/dialogs/error_dialog.h"
#include "ui/dialogs/questions.h"
#include "ui/files/save_name.h"
#include "ui/models/eeprom_lines.h"
#include "ui/session/workspace.h"
#include "ui/text/error_text.h"
#include "ui/text/glossary.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr std::uint32_t kPieceWords = 64;
constexpr std::size_t kAliasWord = 4, kChecksumWord = 7, kConfigurationBytes = 16;

}  // namespace

SlaveEepromPage::SlaveEepromPage(Workspace& workspace) : OnlinePage(workspace, "slaveEepromPage", tr("EEPROM")) {
  auto* layout = build();
  layout->addWidget(buildButtons());
  auto* parts = new QSplitter(Qt::Horizontal);
  parts->setChildrenCollapsible(false);
  lines_ = new RecordModel({tr("Part"), tr("Value")}, this);
  auto* table = named(new QTableView, "eepromTable", tr("What the EEPROM says"));
  setUpTable(*table);
  table->setModel(lines_);
  table->setColumnWidth(0, 215);
  stretchColumn(*table, 1);
  hex_ = named(new QPlainTextEdit, "eepromHex", tr("Bytes of the EEPROM"));
  hex_->setReadOnly(true);
  hex_->setTabChangesFocus(true);
  hex_->setLineWrapMode(QPlainTextEdit::NoWrap);
  hex_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  hex_->setPlaceholderText(tr("Not read yet"));
  parts->addWidget(table);
  parts->addWidget(hex_);
  layout->addWidget(parts, 1);
  layout->addWidget(buildStatus("eepromStatus"));
}

QWidget* SlaveEepromPage::buildButtons() {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  read_ = named(new QPushButton(tr("&Read")), "eepromRead", tr("Read the whole EEPROM"));
  save_ = named(new QPushButton(tr("&Save…")), "eepromSave", tr("Copy the EEPROM into a file"));
  alias_ = named(new QSpinBox, "eepromAlias", tr("New alias"));
  alias_->setRange(0, 0xFFFF);
  alias_->setFocusPolicy(Qt::StrongFocus);
  alias_write_ = named(new QPushButton(tr("&Write Alias…")), "eepromWriteAlias", tr("Write the alias into the EEPROM"));
  load_ = named(new QPushButton(tr("Write &Image…")), "eepromLoad", tr("Write a file into the EEPROM"));
  layout->addWidget(read_);
  layout->addWidget(save_);
  layout->addStretch(1);
  auto* caption = new QLabel(tr("Alias"));
  caption->setBuddy(alias_);
  layout->addWidget(caption);
  layout->addWidget(alias_);
  layout->addWidget(alias_write_);
  layout->addWidget(load_);
  connect(read_, &QPushButton::clicked, this, &SlaveEepromPage::read);
  connect(save_, &QPushButton::clicked, this, &SlaveEepromPage::save);
  connect(alias_write_, &QPushButton::clicked, this, &SlaveEepromPage::writeAlias);
  connect(load_, &QPushButton::clicked, this, &SlaveEepromPage::load);
  return area;
}

void SlaveEepromPage::ended() {
  reading_.clear();
  pieces_ = pieces_done_ = 0;
}

void SlaveEepromPage::slaveChanged() {
  image_.clear();
  alias_->setValue(settings()->alias);
  showImage();
  projectChanged();
}

void SlaveEepromPage::projectChanged() { load_->setVisible(expert()); }

void SlaveEepromPage::tick(std::optional<Nanoseconds>) {
  showProgress();
  enable();
}

void SlaveEepromPage::showProgress() {
  if (!writing_ || writing_->position != position()) return;
  const auto done = static_cast<int>(workspace().requests().progress(write_request_) / 2);
  if (done > 0) say(tr("%1 of %2 words are written.").arg(done).arg(writing_->words));
}

void SlaveEepromPage::enable() {
  const bool idle = possible() && pieces_ == 0 && !writing_;
  read_->setEnabled(idle);
  save_->setEnabled(!image_.empty());
  for (QWidget* one : {static_cast<QWidget*>(alias_write_), static_cast<QWidget*>(load_)})
    one->setEnabled(idle && !image_.empty());
}

// ---- reading ------------------------------------------------------------------------------------

void SlaveEepromPage::read() {
  const auto slave = running();
  if (!slave || !possible() || pieces_ > 0) return;
  reading_.clear();
  pieces_ = 1;
  pieces_done_ = 0;
  enable();
  readPiece(slave->position, 0);
}

void SlaveEepromPage::readPiece(std::uint16_t position, std::uint32_t word) {
  post(
      requests::EepromRead{position, word, kPieceWords},
      [this, position, word](const RequestOutcome& outcome) { takePiece(position, word, outcome); },
      RequestUrgency::kBackground);
}

/// The first piece says how large it is.
void SlaveEepromPage::takePiece(std::uint16_t position, std::uint32_t word, const RequestOutcome& outcome) {
  if (pieces_ == 0) return;
  if (!outcome.ok()) {
    stopAsking();
    enable();
    return say(outcome.why, true);
  }
  const auto& piece = outcome.answer.data;
  if (word == 0) {
    const auto bytes = sii::image_size(piece);
    reading_.assign(bytes, 0xFF);
    pieces_ = static_cast<std::uint32_t>((bytes / 2 + kPieceWords - 1) / kPieceWords);
    for (std::uint32_t next = 1; next < pieces_; ++next) readPiece(position, next * kPieceWords);
  }
  const auto room = reading_.size() - std::min(reading_.size(), std::size_t{2} * word);
  std::copy_n(piece.begin(), std::min(room, piece.size()), reading_.begin() + 2 * static_cast<std::ptrdiff_t>(word));
  ++pieces_done_;
  say(tr("%1 of %2")
          .arg(bitsText(8 * 2 * kPieceWords * pieces_done_),
               bitsText(static_cast<std::uint32_t>(8 * reading_.size()))));
  if (pieces_done_ < pieces_) return;
  pieces_ = 0;
  image_ = std::exchange(reading_, {});
  say({});
  showImage();
}

void SlaveEepromPage::showImage() {
  hex_->setPlainText(hexView(image_));
  RecordModel::Lines lines;
  if (!image_.empty()) {
    if (const auto decoded = sii::decode(image_)) {
      lines = eepromLines(*decoded);
      alias_->setValue(decoded->alias);
    } else {
      say(errorText(decoded.error()), true);
    }
  }
  lines_->setLines(lines);
  enable();
}

void SlaveEepromPage::save() {
  const auto name = QString::fromStdString(settings()->name) + QStringLiteral(".bin");
  const auto path = askSaveName(this, tr("Save EEPROM"), name, tr("EEPROM images (*.bin)"));
  if (path.isEmpty()) return;
  if (auto status = write_whole_file(path.toStdString(), image_); !status)
    showError(window(), tr("The EEPROM could not be saved."), status.error());
}

// ---- writing ------------------------------------------------------------------------------------

void SlaveEepromPage::writeAlias() {
  const auto alias = static_cast<std::uint16_t>(alias_->value());
  if (image_.size() < kConfigurationBytes) return;
  const auto question = tr("Write alias %1 into the EEPROM of %2?").arg(alias).arg(nodeName(project(), node()));
  if (!ask(*window(), "eepromQuestion", question,
           tr("It is written with its checksum and read back; the machine goes on. The slave takes it at its next "
              "power-on: until then 0x0012 shows the old one."),
           tr("Write"))) {
    return;
  }
  std::vector<std::uint8_t> bytes(image_.begin(), image_.begin() + kConfigurationBytes);
  bytes[2 * kAliasWord] = static_cast<std::uint8_t>(alias);
  bytes[2 * kAliasWord + 1] = static_cast<std::uint8_t>(alias >> 8);
  bytes[2 * kChecksumWord] = sii::checksum(std::span(bytes).first(2 * kChecksumWord));
  bytes[2 * kChecksumWord + 1] = 0;
  write(std::move(bytes),
        tr("Alias %1 is in the EEPROM and read back. The slave takes it at its next power-on.").arg(alias));
}

void SlaveEepromPage::load() {
  const auto path =
      QFileDialog::getOpenFileName(this, tr("Write EEPROM Image"), {}, tr("EEPROM images (*.bin);;All files (*)"));
  if (path.isEmpty()) return;
  const auto bytes = read_whole_file(path.toStdString());
  if (!bytes) return showError(window(), tr("The image could not be read."), bytes.error());
  writeImage({bytes->begin(), bytes->end()});
}

void SlaveEepromPage::writeImage(std::vector<std::uint8_t> image) {
  if (image.empty() || image.size() % 2 != 0 || image.size() > image_.size()) {
    return say(tr("The image does not fit: it has %1, the EEPROM %2.")
                   .arg(bitsText(static_cast<std::uint32_t>(8 * image.size())),
                        bitsText(static_cast<std::uint32_t>(8 * image_.size()))),
               true);
  }
  const auto decoded = sii::decode(image);
  if (!decoded) return say(errorText(decoded.error()), true);
  const auto& identity = settings()->device.identity;
  auto more =
      tr("Words that differ are written and read back; when one fails, all are put back. A wrong image can leave "
         "a slave that no longer comes up.");
  if (decoded->vendor_id != identity.vendor_id || decoded->product_code != identity.product_code) {
    more.prepend(tr("The image is of another device (%1, product %2).")
                     .arg(hexText(decoded->vendor_id, 8), hexText(decoded->product_code, 8)) +
                 u' ');
  }
  const auto question = tr("Write this image into the EEPROM of %1?").arg(nodeName(project(), node()));
  if (!ask(*window(), "eepromQuestion", question, more, tr("Write"))) return;
  write(std::move(image), tr("The image is in the EEPROM and read back. The slave takes it at its next power-on."));
}

/// What a killed program leaves half written is ended at the next start: the journal says how. Whoever looks at another
/// slave meanwhile does not end it.
void SlaveEepromPage::write(std::vector<std::uint8_t> bytes, const QString& done) {
  const auto slave = running();
  if (!slave) return say(obstacle(), true);
  if (writing_) return;
  Write begun{slave->position, nodeName(project(), node()), workspace().live().link(), {}, done};
  begun.before.assign(image_.begin(), image_.begin() + static_cast<std::ptrdiff_t>(bytes.size()));
  for (std::size_t at = 0; at < bytes.size(); at += 2)
    begun.words +=
        std::equal(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.begin() + static_cast<std::ptrdiff_t>(at) + 2,
                   begun.before.begin() + static_cast<std::ptrdiff_t>(at))
            ? 0
            : 1;
  auto& repair = workspace().eepromRepair();
  if (const auto kept = repair.keep(begun.link, begun.position, begun.before, bytes); !kept)
    return say(errorText(kept.error()), true);
  writing_ = begun;
  enable();
  say(tr("The EEPROM is being written."));
  write_request_ = workspace().requests().post(requests::EepromWrite{begun.position, 0, std::move(bytes)}, repair,
                                               [page = QPointer(this), begun](const RequestOutcome& outcome) {
                                                 if (page) page->settle(begun, outcome);
                                               });
}

/// The journal goes when all is written, and when what was there is there again.
void SlaveEepromPage::settle(const Write& begun, const RequestOutcome& outcome) {
  const auto why = outcome.ok() ? QString() : outcome.why;
  if (outcome.end == RequestEnd::kGone) return tellEnd(begun, why);
  const auto words = static_cast<std::uint32_t>(begun.before.size() / 2);
  workspace().requests().post(requests::EepromRead{begun.position, 0, words}, workspace().eepromRepair(),
                              [page = QPointer(this), begun, why](const RequestOutcome& now) {
                                if (page) page->verify(begun, why, now);
                              });
}

void SlaveEepromPage::verify(const Write& begun, const QString& why, const RequestOutcome& now) {
  if (now.ok() && (why.isEmpty() || now.answer.data == begun.before))
    workspace().eepromRepair().drop(begun.link, begun.position);
  if (now.ok() && position() == begun.position && now.answer.data.size() <= image_.size()) {
    std::ranges::copy(now.answer.data, image_.begin());
    showImage();
  }
  tellEnd(begun, why.isEmpty() && !now.ok() ? now.why : why);
}

/// `why`: it went wrong.
void SlaveEepromPage::tellEnd(const Write& begun, const QString& why) {
  writing_.reset();
  const auto& text = why.isEmpty() ? begun.done : why;
  workspace().inform(begun.name, text);
  if (position() == begun.position) say(text, !why.isEmpty());
  enable();
}

}  // namespace syncline::ui
