// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/catalogue_panel.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/models/catalogue_model.h"
#include "ui/session/device_catalogue.h"
#include "ui/text/error_text.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr std::size_t kMost = 3'000;
constexpr std::size_t kFewEnoughToOpen = 60;
constexpr int kTypingMs = 60;

QString escaped(const std::string& text) { return QString::fromStdString(text).trimmed().toHtmlEscaped(); }

}  // namespace

CataloguePanel::CataloguePanel(DeviceCatalogue& catalogue, QWidget* parent) : QWidget(parent), catalogue_(catalogue) {
  setMinimumWidth(220);
  model_ = new CatalogueModel(this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(6);
  buildSearch();
  buildTree();
  buildFoot();
  connectCatalogue();
  typing_.setSingleShot(true);
  typing_.setInterval(kTypingMs);
  connect(&typing_, &QTimer::timeout, this, &CataloguePanel::search);
  setObstacle({});
  showReading(false);
}

void CataloguePanel::buildSearch() {
  words_ = named(new QLineEdit, "catalogueSearch", tr("Search the device catalogue"));
  words_->setPlaceholderText(tr("Vendor, type, name or product code"));
  words_->setToolTip(
      tr("Beginnings of words of the vendor, group, type, name or product code; all must occur.\n"
         "A revision: #x00120000, or rev 18 as it is printed on the device; several: rev 16-18, rev 16-"));
  words_->setClearButtonEnabled(true);
  words_->installEventFilter(this);
  revisions_ = named(new QCheckBox(tr("All revisions")), "catalogueRevisions", tr("All revisions"));
  revisions_->setToolTip(tr("Show older revisions below each device, and devices that their vendor hides"));
  layout()->addWidget(words_);
  layout()->addWidget(revisions_);
  connect(words_, &QLineEdit::textChanged, this, [this] {
    take_first_ = false;
    typing_.start();
  });
  connect(revisions_, &QCheckBox::toggled, this, &CataloguePanel::search);
}

void CataloguePanel::buildTree() {
  tree_ = named(new QTreeView, "catalogueTree", tr("Devices of the catalogue"));
  tree_->setModel(model_);
  tree_->setUniformRowHeights(true);
  tree_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  tree_->setDragDropMode(QAbstractItemView::DragOnly);
  tree_->setIndentation(14);
  tree_->setFrameShape(QFrame::NoFrame);
  tree_->setTextElideMode(Qt::ElideRight);
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setSectionResizeMode(CatalogueModel::kDevice, QHeaderView::Stretch);
  tree_->header()->setSectionResizeMode(CatalogueModel::kRevision, QHeaderView::ResizeToContents);
  static_cast<QVBoxLayout*>(layout())->addWidget(tree_, 1);
  connect(tree_, &QTreeView::activated, this, &CataloguePanel::takeSelected);
  connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this, &CataloguePanel::showDevice);
  connect(model_, &QAbstractItemModel::modelReset, this, &CataloguePanel::showDevice);
}

void CataloguePanel::buildFoot() {
  details_ = named(new QLabel, "catalogueDetails", tr("The selected device"));
  details_->setTextFormat(Qt::RichText);
  details_->setWordWrap(true);
  details_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  count_ = named(new QLabel, "catalogueCount", tr("Number of devices"));
  count_->setWordWrap(true);
  count_->setForegroundRole(QPalette::PlaceholderText);
  bar_ = named(new QProgressBar, "catalogueProgress", tr("Reading of device descriptions"));
  bar_->setTextVisible(false);
  bar_->setMaximumHeight(8);
  take_ = named(new QPushButton(tr("Add to Machine")), "catalogueTake", tr("Add the device behind the selected slave"));
  add_ = named(new QPushButton(tr("Read ESI…")), "catalogueAdd", tr("Read ESI files into the catalogue"));
  add_->setToolTip(tr("Read device descriptions of vendors into the catalogue"));
  auto* menu = new QMenu(add_);
  menu->addAction(tr("Files…"), this, &CataloguePanel::addFiles)->setObjectName(QStringLiteral("catalogueAddFiles"));
  menu->addAction(tr("Folder…"), this, &CataloguePanel::addFolder)->setObjectName(QStringLiteral("catalogueAddFolder"));
  add_->setMenu(menu);
  cancel_ = named(new QPushButton(tr("Cancel")), "catalogueCancel",
                  tr("End reading; what was read is kept, the rest is read at the next start"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(take_, 1);
  buttons->addWidget(add_);
  buttons->addWidget(cancel_);
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->addWidget(details_);
  column->addWidget(count_);
  column->addWidget(bar_);
  column->addLayout(buttons);
  connect(take_, &QPushButton::clicked, this, &CataloguePanel::takeSelected);
  connect(cancel_, &QPushButton::clicked, &catalogue_, &DeviceCatalogue::cancel);
}

void CataloguePanel::connectCatalogue() {
  connect(&catalogue_, &DeviceCatalogue::progress, this, [this](int done, int files, const QString& file) {
    showReading(true);
    bar_->setRange(0, files);
    bar_->setValue(done);
    const auto shown = fileShown(file), name = QFileInfo(file).fileName();
    count_->setText(tr("Reading %1 (%2 of %3)").arg(shown).arg(done + 1).arg(files));
    count_->setToolTip(shown == name ? QString() : name);
  });
  connect(&catalogue_, &DeviceCatalogue::added, this, [this] {
    showReading(false);
    count_->setToolTip({});
    if (asked_) search();
  });
}

void CataloguePanel::begin() {
  words_->setFocus(Qt::ShortcutFocusReason);
  words_->selectAll();
}

void CataloguePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!asked_) search();
}

void CataloguePanel::search() {
  asked_ = true;
  eni::CatalogueSearch wanted;
  wanted.words = words_->text().toStdString();
  wanted.all_revisions = wanted.with_hidden = revisions_->isChecked();
  wanted.limit = kMost;
  catalogue_.search(wanted, this, [this](const Result<CatalogueAnswer>& answer) {
    if (answer) return showAnswer(*answer);
    take_first_ = false;
    count_->setText(errorText(answer.error()));
  });
}

void CataloguePanel::showAnswer(const CatalogueAnswer& answer) {
  const auto* before = model_->entry(tree_->currentIndex());
  const auto kept = before != nullptr ? before->id : -1;
  model_->setEntries(answer.entries);
  if (!answer.search.words.empty() && answer.entries.size() <= kFewEnoughToOpen) {
    tree_->expandToDepth(1);
  } else {
    tree_->expandToDepth(model_->rowCount() > 1 ? -1 : 0);
  }
  selectIn(answer, kept);
  showCount(answer);
  answered_ = QString::fromStdString(answer.search.words);
  if (take_first_ && answered_ == words_->text()) {
    take_first_ = false;
    takeSelected();
  }
}

/// What was selected stays so where it is still there; who types finds the first one selected.
void CataloguePanel::selectIn(const CatalogueAnswer& answer, std::int64_t kept) {
  QModelIndex wanted = answer.search.words.empty() ? QModelIndex() : model_->firstDevice();
  const auto found = std::ranges::find(answer.entries, kept, &eni::CatalogueEntry::id);
  if (kept >= 0 && found != answer.entries.end()) {
    const auto there =
        model_->match(model_->index(0, 0), CatalogueModel::kEntryRole, static_cast<int>(found - answer.entries.begin()),
                      1, Qt::MatchRecursive | Qt::MatchExactly);
    if (!there.isEmpty()) wanted = there.front();
  }
  if (!wanted.isValid()) return;
  tree_->setCurrentIndex(wanted);
  tree_->scrollTo(wanted);
}

void CataloguePanel::showCount(const CatalogueAnswer& answer) {
  const auto devices = static_cast<int>(answer.entries.size());
  if (answer.devices == 0) {
    count_->setText(tr("The catalogue is empty: read the ESI files of your devices."));
  } else if (devices == 0) {
    count_->setText(tr("None of the %n device(s) has all these words.", nullptr, static_cast<int>(answer.devices)));
  } else if (answer.more) {
    count_->setText(tr("The first %1 of %2 devices: type more.").arg(devices).arg(answer.devices));
  } else {
    count_->setText(tr("%1 of %2 devices and revisions").arg(devices).arg(answer.devices));
  }
}

/// A name has no place where its line could end.
QString CataloguePanel::fileShown(const QString& path) const {
  return fontMetrics().elidedText(QFileInfo(path).fileName(), Qt::ElideMiddle, count_->width());
}

void CataloguePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  layout()->activate();
  showDevice();
}

void CataloguePanel::showDevice() {
  const auto* device = model_->entry(tree_->currentIndex());
  take_->setEnabled(device != nullptr && obstacle_.isEmpty());
  if (device == nullptr) return details_->setText(tr("Select a device to see what is known of it."));
  QStringList lines{
      QStringLiteral("<b>%1</b>").arg(escaped(device->name.empty() ? device->type : device->name)),
      tr("%1, product code %2").arg(escaped(device->vendor_name), hexText(device->identity.product_code, 8)),
      tr("Revision %1, ports %2")
          .arg(hexText(device->identity.revision_no, 8),
               device->physics.empty() ? noText() : escaped(device->physics))};
  if (!device->revision_rule.empty()) lines << tr("Revision rule %1").arg(escaped(device->revision_rule));
  if (device->hidden) lines << tr("Hidden by its vendor");
  lines << fileShown(QString::fromStdString(device->file)).toHtmlEscaped();
  details_->setText(lines.join(QStringLiteral("<br>")));
  details_->setToolTip(QString::fromStdString(device->file));
}

void CataloguePanel::takeSelected() {
  const auto* device = model_->entry(tree_->currentIndex());
  if (device != nullptr && obstacle_.isEmpty()) Q_EMIT deviceWanted(*device);
}

const eni::CatalogueEntry* CataloguePanel::dragged(qint64 id) const { return model_->dragged(id); }

void CataloguePanel::setObstacle(const QString& why) {
  obstacle_ = why;
  take_->setToolTip(
      why.isEmpty() ? tr("Add the device behind the slave that is selected in the explorer (Enter, or drag it there)")
                    : why);
  showDevice();
}

void CataloguePanel::addFiles() {
  read(QFileDialog::getOpenFileNames(this, tr("Read ESI Files"), {}, tr("Device descriptions (*.xml);;All files (*)")));
}

void CataloguePanel::addFolder() {
  const auto folder = QFileDialog::getExistingDirectory(this, tr("Read a Folder of ESI Files"));
  if (!folder.isEmpty()) read({folder});
}

void CataloguePanel::read(const QStringList& paths) {
  if (paths.isEmpty()) return;
  asked_ = true;
  showReading(true);
  bar_->setRange(0, 0);
  catalogue_.add(paths);
}

void CataloguePanel::showReading(bool reading) {
  bar_->setVisible(reading);
  cancel_->setVisible(reading);
  add_->setVisible(!reading);
}

/// From the search to the devices and back without leaving the field.
bool CataloguePanel::eventFilter(QObject* object, QEvent* event) {
  if (object != words_ || event->type() != QEvent::KeyPress) return QWidget::eventFilter(object, event);
  auto* key = static_cast<QKeyEvent*>(event);
  switch (key->key()) {
    case Qt::Key_Down:
    case Qt::Key_Up:
      if (!tree_->currentIndex().isValid()) tree_->setCurrentIndex(model_->firstDevice());
      tree_->setFocus(Qt::TabFocusReason);
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      // Who types fast means what was typed, not what is still shown.
      take_first_ = answered_ != words_->text();
      if (!take_first_) takeSelected();
      return true;
    default:
      return QWidget::eventFilter(object, event);
  }
}

}  // namespace syncline::ui
