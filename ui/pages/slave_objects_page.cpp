// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_objects_page.h"

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "support/whole_file.h"
#include "ui/dialogs/error_dialog.h"
#include "ui/models/object_filter.h"
#include "ui/models/object_model.h"
#include "ui/pages/object_write_bar.h"
#include "ui/session/dictionary_reader.h"
#include "ui/session/favourite_objects.h"
#include "ui/session/watch_list.h"
#include "ui/session/workspace.h"
#include "ui/widgets/named.h"
#include "ui/widgets/poll_choice.h"
#include "ui/widgets/tables.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr int kFromEsi = -1;

}  // namespace

SlaveObjectsPage::SlaveObjectsPage(Workspace& workspace) : OnlinePage(workspace, "slaveObjectsPage", tr("Objects")) {
  reader_ = new DictionaryReader(workspace.requests(), this);
  model_ = new ObjectModel(this);
  filter_ = new ObjectFilter(this);
  filter_->setSourceModel(model_);
  auto* layout = build();
  layout->addWidget(buildChoice());
  layout->addWidget(buildTree(), 1);
  write_ = new ObjectWriteBar;
  layout->addWidget(write_);
  layout->addWidget(buildButtons());
  connectReader();
  connect(model_, &QAbstractItemModel::modelReset, this, &SlaveObjectsPage::showSelected);
  connect(model_, &ObjectModel::watchedChanged, this, &SlaveObjectsPage::keepWatched);
  connect(write_, &ObjectWriteBar::writeWanted, this, &SlaveObjectsPage::write);
  showWork();
}

QWidget* SlaveObjectsPage::buildChoice() {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  source_ = named(new QComboBox, "objectSource", tr("Where the objects are described"));
  source_->addItem(tr("From the ESI"), kFromEsi);
  using List = coe::ObjectListType;
  const std::pair<QString, List> lists[] = {{tr("From the slave: all"), List::kAll},
                                            {tr("From the slave: RxPDO"), List::kRxPdo},
                                            {tr("From the slave: TxPDO"), List::kTxPdo},
                                            {tr("From the slave: to be stored"), List::kStored},
                                            {tr("From the slave: start-up"), List::kStartup}};
  for (const auto& [text, list] : lists) source_->addItem(text, static_cast<int>(list));
  source_->setToolTip(tr("The slave tells its objects by SDO information (ETG.1000.6, 5.6.3)"));
  words_ = named(new QLineEdit, "objectSearch", tr("Search objects"));
  words_->setPlaceholderText(tr("Index, name or value"));
  words_->setClearButtonEnabled(true);
  watched_only_ = named(new QCheckBox(tr("Watched only")), "objectWatchedOnly", tr("Show watched entries only"));
  layout->addWidget(source_);
  layout->addWidget(words_, 1);
  layout->addWidget(watched_only_);
  layout->addWidget(buildFavourites());
  connect(source_, &QComboBox::activated, this, &SlaveObjectsPage::showDictionary);
  connect(words_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filter_->setWords(text);
    if (!text.isEmpty()) tree_->expandAll();
  });
  connect(watched_only_, &QCheckBox::toggled, this, [this](bool only) {
    filter_->setWatchedOnly(only);
    if (only) tree_->expandAll();
  });
  return area;
}

QToolButton* SlaveObjectsPage::buildFavourites() {
  auto* button = named(new QToolButton, "objectFavourites", tr("Favourites"));
  button->setText(button->accessibleName());
  button->setToolTip(tr("Objects that are watched in every device of this kind, also in other projects"));
  button->setPopupMode(QToolButton::InstantPopup);
  favourites_ = new QMenu(button);
  favourites_->setObjectName(QStringLiteral("objectFavouritesMenu"));
  button->setMenu(favourites_);
  connect(favourites_, &QMenu::aboutToShow, this, &SlaveObjectsPage::fillFavourites);
  return button;
}

void SlaveObjectsPage::fillFavourites() {
  favourites_->clear();
  if (settings() == nullptr) return;
  const auto& device = settings()->device;
  const auto type = QString::fromStdString(device.type);
  const auto liked = FavouriteObjects(workspace().memory()).of(device.identity);
  auto* watch = favourites_->addAction(
      liked.empty() ? tr("No favourites of %1 yet").arg(type)
                    : tr("&Watch %n favourite(s) of %1", nullptr, static_cast<int>(liked.size())).arg(type));
  watch->setObjectName(QStringLiteral("favouritesWatch"));
  watch->setEnabled(!liked.empty());
  connect(watch, &QAction::triggered, this, [this, liked] {
    auto objects = model_->watched();
    for (const auto object : liked) {
      if (std::ranges::find(objects, object) == objects.end()) objects.push_back(object);
    }
    model_->setWatched(objects);
    keepWatched();
  });
  const auto keep = [this, identity = device.identity](const std::vector<coe::ObjectAddress>& objects) {
    FavouriteObjects(workspace().memory()).set(identity, objects);
  };
  const auto watched = model_->watched();
  auto* take = favourites_->addAction(tr("&Make the watched entries the favourites of %1").arg(type));
  take->setObjectName(QStringLiteral("favouritesTake"));
  take->setEnabled(!watched.empty() && watched != liked);
  connect(take, &QAction::triggered, this, [keep, watched] { keep(watched); });
  auto* forget = favourites_->addAction(tr("&Forget the favourites of %1").arg(type));
  forget->setObjectName(QStringLiteral("favouritesForget"));
  forget->setEnabled(!liked.empty());
  connect(forget, &QAction::triggered, this, [keep] { keep({}); });
}

QTreeView* SlaveObjectsPage::buildTree() {
  tree_ = named(new QTreeView, "objectTree", tr("Objects of the slave"));
  tree_->setModel(filter_);
  setUpTree(*tree_);
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  const std::pair<ObjectModel::Column, int> widths[] = {{ObjectModel::kObject, 116}, {ObjectModel::kName, 190},
                                                        {ObjectModel::kType, 76},    {ObjectModel::kAccess, 84},
                                                        {ObjectModel::kUnit, 52},    {ObjectModel::kValue, 130}};
  for (const auto& [column, width] : widths) tree_->setColumnWidth(column, width);
  connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this, &SlaveObjectsPage::showSelected);
  connect(tree_, &QTreeView::activated, this, &SlaveObjectsPage::readSelected);
  auto* copying = new QAction(tr("Copy"), tree_);
  copying->setObjectName(QStringLiteral("objectCopy"));
  copying->setShortcut(QKeySequence::Copy);
  copying->setShortcutContext(Qt::WidgetShortcut);
  tree_->addAction(copying);
  tree_->setContextMenuPolicy(Qt::ActionsContextMenu);
  connect(copying, &QAction::triggered, this, &SlaveObjectsPage::copy);
  return tree_;
}

QWidget* SlaveObjectsPage::buildButtons() {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  read_ = named(new QPushButton(tr("&Read")), "objectRead", tr("Read the selected objects"));
  read_shown_ = named(new QPushButton(tr("Read &All Shown")), "objectReadShown", tr("Read all entries that are shown"));
  poll_ = named(new PollChoice(tr("Watched: on demand"), tr("Watched: every %1 s"), {100, 500, 1000, 5000}),
                "objectPoll", tr("How often watched entries are read"));
  stop_ = named(new QPushButton(tr("Stop")), "objectStop", tr("Stop reading"));
  export_ =
      named(new QPushButton(tr("&CSV…")), "objectExport", tr("Export the shown objects as comma separated values"));
  for (auto* control : {read_, read_shown_}) layout->addWidget(control);
  layout->addWidget(poll_);
  layout->addWidget(buildStatus("objectStatus"), 1);
  layout->addWidget(stop_);
  layout->addWidget(export_);
  connect(read_, &QPushButton::clicked, this, &SlaveObjectsPage::readSelected);
  connect(read_shown_, &QPushButton::clicked, this, &SlaveObjectsPage::readShown);
  connect(stop_, &QPushButton::clicked, this, &SlaveObjectsPage::stop);
  connect(export_, &QPushButton::clicked, this, &SlaveObjectsPage::exportCsv);
  return area;
}

void SlaveObjectsPage::connectReader() {
  connect(reader_, &DictionaryReader::listed, this, [this](const std::vector<std::uint16_t>& indices) {
    Dictionary bare;
    for (const auto index : indices) bare.push_back({.index = index});
    model_->setDictionary(std::move(bare));
  });
  connect(reader_, &DictionaryReader::objectRead, this, [this](DictionaryObject object) {
    completeFromEsi(object, esi_);
    model_->setObject(std::move(object));
    showSelected();
  });
  connect(reader_, &DictionaryReader::progressed, this,
          [this](int done, int of) { say(tr("%1 of %2 objects").arg(done).arg(of)); });
  connect(reader_, &DictionaryReader::finished, this, [this] {
    online_[reading_] = model_->dictionary();
    say(tr("%n object(s)", nullptr, static_cast<int>(model_->dictionary().size())));
    showWork();
  });
  connect(reader_, &DictionaryReader::failed, this, [this](const QString& why) {
    say(why, true);
    showWork();
  });
}

// ---- what is shown ------------------------------------------------------------------------------

QString SlaveObjectsPage::ownObstacle(const RunningSlave& slave) const {
  if (!slave.config->mailbox || !slave.config->mailbox->coe) {
    return tr("This slave does not speak CoE: it has no objects. Its registers and EEPROM can be read all the same.");
  }
  if (has_mailbox_communication(slave.state())) return {};
  return tr("Objects can be read from PREOP on: lead the slave there first.");
}

void SlaveObjectsPage::ended() {
  reader_->cancel();
  batch_ = batch_done_ = batch_failed_ = 0;
  polling_ = 0;
}

void SlaveObjectsPage::slaveChanged() {
  model_->clearValues();
  model_->setWatched(workspace().watched().of(settings()->station_address));
  // What it has told in this run is better than the ESI.
  constexpr int kAll = static_cast<int>(coe::ObjectListType::kAll);
  const bool told = online_.contains({position(), kAll});
  source_->setCurrentIndex(told ? source_->findData(kAll) : 0);
  poll_->reset();
  esi_ = dictionaryOf(*settings());
  showDictionary();
}

void SlaveObjectsPage::projectChanged() {
  auto esi = dictionaryOf(*settings());
  const bool same = esi == esi_ && !model_->dictionary().empty();
  esi_ = std::move(esi);
  if (!same && source_->currentData().toInt() == kFromEsi) showDictionary();
}

void SlaveObjectsPage::showDictionary() {
  const int list = source_->currentData().toInt();
  reader_->cancel();
  if (list == kFromEsi) {
    model_->setDictionary(esi_);
    say(esi_.empty() ? tr("The ESI describes no objects: choose \"From the slave\" when online.") : QString());
  } else if (const auto known = online_.find({position(), list}); known != online_.end()) {
    model_->setDictionary(known->second);
  } else {
    readDictionary();
  }
  if (!words_->text().isEmpty() || watched_only_->isChecked()) tree_->expandAll();
  showWork();
  showSelected();
}

void SlaveObjectsPage::showObject(coe::ObjectAddress object) {
  words_->clear();
  watched_only_->setChecked(false);
  if (!model_->find(object).isValid()) {
    source_->setCurrentIndex(source_->findData(kFromEsi));
    showDictionary();
  }
  const auto at = filter_->mapFromSource(model_->find(object));
  if (!at.isValid()) return;
  tree_->setCurrentIndex(at);
  tree_->scrollTo(at, QAbstractItemView::PositionAtCenter);
  tree_->setFocus(Qt::OtherFocusReason);
}

void SlaveObjectsPage::readDictionary() {
  const auto slave = running();
  if (const auto why = obstacle(); !why.isEmpty() || !slave) {
    source_->setCurrentIndex(0);
    showDictionary();
    return say(why, true);
  }
  reading_ = {slave->position, source_->currentData().toInt()};
  say(tr("The slave is asked for its objects."));
  reader_->start(slave->position, static_cast<coe::ObjectListType>(reading_.second));
}

const DictionaryEntry* SlaveObjectsPage::entryOf(coe::ObjectAddress object) const {
  return model_->entry(model_->find(object));
}

void SlaveObjectsPage::showSelected() {
  const auto current = filter_->mapToSource(tree_->currentIndex()).siblingAtColumn(0);
  const auto* entry = model_->entry(current);
  const auto object = model_->address(current);
  if (entry == nullptr) return write_->setEntry({}, nullptr, {}, tr("Choose an entry to write a value."));
  const auto name = QStringLiteral("%1 %2").arg(objectText(object), entry->name);
  if (!entry->writable()) return write_->setEntry({}, nullptr, {}, tr("%1 cannot be written.").arg(name));
  write_->setEntry(object, entry, model_->value(object), {});
}

void SlaveObjectsPage::tick(std::optional<Nanoseconds> now) {
  write_->setPossible(possible());
  if (now && possible() && polling_ == 0 && poll_->due(*now)) readWatched();
  showWork();
}

void SlaveObjectsPage::showWork() {
  const bool busy = reader_->isRunning() || batch_ > 0;
  read_->setEnabled(possible());
  read_shown_->setEnabled(possible() && batch_ == 0);
  poll_->setEnabled(possible());
  stop_->setVisible(busy);
  export_->setEnabled(!model_->dictionary().empty());
}

}  // namespace syncline::ui
