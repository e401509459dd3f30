// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/pdo_mapping_editor.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "config/module_slots.h"
#include "protocol/object_value.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/object_picker.h"
#include "ui/editors/page.h"
#include "ui/editors/record_form.h"
#include "ui/models/pdo_model.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr const char* kMapping = "slave.N.pdo.map.0xIIII";
constexpr const char* kPadding = "0x0000:00:8";
constexpr int kLowestMapping = 110, kLeastTitle = 60;

// "0x6040:00:16"
QString objectOf(const std::string& entry) { return QString::fromStdString(entry.substr(0, entry.rfind(':'))); }
QString bitsOf(const std::string& entry) { return QString::fromStdString(entry.substr(entry.rfind(':') + 1)); }
std::string entryText(const QString& object, const QString& bits) {
  return QStringLiteral("%1:%2").arg(object, bits).toStdString();
}
/// As the list of the entries writes it.
QString shownObject(const std::string& entry) {
  const auto text = objectOf(entry);
  const auto object = object_name(text.toStdString());
  return object ? objectText(object->index, object->sub_index) : text;
}

Records split(const std::string& mapping) {
  Records entries;
  for (const auto& part : QString::fromStdString(mapping).split(u',', Qt::SkipEmptyParts))
    entries.push_back(part.toStdString());
  return entries;
}

std::string join(const Records& entries) {
  std::string text;
  for (const auto& entry : entries) text += (text.empty() ? "" : ",") + entry;
  return text;
}

/// The entries as they are now, with their names.
std::vector<PdoEntry> entriesOf(const SlaveSettings& slave, std::uint16_t index) {
  const auto changed = std::ranges::find(slave.changed_pdos, index, &Pdo::index);
  if (changed != slave.changed_pdos.end()) return changed->entries;
  const auto pdo = pdo_of(slave, index);
  return pdo ? pdo->entries : std::vector<PdoEntry>{};
}

}  // namespace

PdoMappingEditor::PdoMappingEditor(Page& page) : page_(page) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  title_ = new ValueLabel(tr("Entries"), this);
  title_->setMinimumWidth(kLeastTitle);  // PDOs have long names
  auto font = title_->font();
  font.setWeight(QFont::DemiBold);
  title_->setFont(font);
  form_ = new RecordForm(page, list(), parts(), [this] { return row(); });
  auto* row_area = new QHBoxLayout;
  row_area->addWidget(title_, 1);
  row_area->addWidget(form_->makeButtons(QStringLiteral("mapping")));
  layout->addLayout(row_area);
  model_ = new PdoEntryModel(this);
  view_ = named(new QTableView, "pdoEntries", tr("Entries of the selected PDO"));
  setUpTable(*view_);
  view_->setModel(model_);
  view_->setMinimumHeight(kLowestMapping);
  view_->setColumnWidth(PdoEntryModel::kOffset, 56);
  view_->setColumnWidth(PdoEntryModel::kObject, 88);
  view_->setColumnWidth(PdoEntryModel::kType, 72);
  view_->setColumnWidth(PdoEntryModel::kLength, 64);
  stretchColumn(*view_, PdoEntryModel::kName);
  view_->setDragDropMode(QAbstractItemView::InternalMove);
  view_->setDragDropOverwriteMode(false);
  connect(model_, &PdoEntryModel::moveWanted, this, [this](int from, int to) {
    if (page_.fields().commit()) form_->moveTo(from, to);
  });
  form_->takeKeysOf(*view_);
  layout->addWidget(view_, 1);
  refusal_ = new QLabel;
  refusal_->setObjectName(QStringLiteral("mappingRefusal"));
  refusal_->setWordWrap(true);
  refusal_->setForegroundRole(QPalette::PlaceholderText);
  layout->addWidget(refusal_);
  card_ = new Card(tr("Selected Entry"));
  form_->addFields(*card_);
  choose_ = named(new QPushButton(tr("Choose Object…")), "mappingChoose", tr("Choose an object of the device"));
  connect(static_cast<QPushButton*>(choose_), &QPushButton::clicked, this, &PdoMappingEditor::chooseObject);
  card_->addWide(choose_);
  layout->addWidget(card_);
  connect(form_, &RecordForm::rowWanted, this, &PdoMappingEditor::selectRow);
  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
    if (showing_) return;
    page_.fields().revert();
    Q_EMIT rowChanged();
  });
}

RecordList PdoMappingEditor::list() {
  RecordList list{
      .key = kMapping, .item = tr("PDO entry"), .ordered = true, .read = {}, .edits = {}, .fresh = {}, .place = {}};
  const auto place = [this] { return settings::Place{static_cast<std::size_t>(page_.node()), pdo_, 0}; };
  list.read = [this, place] {
    if (slave() == nullptr || pdo_ == 0) return Records{};
    return split(settings::text_of(settings::row(kMapping), page_.project(), place()));
  };
  list.edits = [place](const Records&, const Records& after) {
    return std::vector<SettingEdit>{{&settings::row(kMapping), place(), settings::Value{join(after)}}};
  };
  list.fresh = [](const Records&) { return std::string(kPadding); };
  list.place = [this, place](int row) -> std::optional<settings::Place> {
    return slave() != nullptr && pdo_ != 0 && row >= 0 ? std::optional(place()) : std::nullopt;
  };
  list.refusal = [this] { return refusal(); };
  return list;
}

std::vector<RecordPart> PdoMappingEditor::parts() {
  return {{.object_name = "mappingObject",
           .label = tr("Object"),
           .tip = tr("Index and sub-index, hexadecimal: 0x6040:00; 0x0000:00 is padding"),
           .text = [](const Records& records, std::size_t row) { return shownObject(records[row]); },
           .put = [](const std::string& record, const QString& typed) -> Result<std::string> {
             const auto object = object_name(typed.trimmed().toStdString());
             if (!object) {
               return settings::bad_value(
                   Reason::verbatim(tr("\"%1\" is no object like 0x6040:00").arg(typed).toStdString()));
             }
             return entryText(objectText(object->index, object->sub_index), bitsOf(record));
           }},
          {.object_name = "mappingBits",
           .label = tr("Bits"),
           .tip = tr("Length of the entry, 1 to 255 bits"),
           .text = [](const Records& records, std::size_t row) { return bitsOf(records[row]); },
           .put = [](const std::string& record, const QString& typed) -> Result<std::string> {
             return entryText(objectOf(record), typed.trimmed());
           }}};
}

const SlaveSettings* PdoMappingEditor::slave() const {
  const auto& slaves = page_.project().slaves;
  const int node = page_.node();
  return node >= 0 && std::cmp_less(node, slaves.size()) ? &slaves[static_cast<std::size_t>(node)] : nullptr;
}

/// As the row of the mapping refuses it.
QString PdoMappingEditor::refusal() const {
  const auto* of = slave();
  const auto pdo = of != nullptr && pdo_ != 0 ? pdo_of(*of, pdo_) : std::nullopt;
  if (!pdo) return tr("No PDO is selected.");
  if (pdo->fixed) return tr("The device does not let this PDO be changed (Fixed in the ESI).");
  if (!of->device.mailbox || !of->device.mailbox->coe || !of->device.mailbox->coe->pdo_config) {
    return tr("The device takes no other mapping (CoE PdoConfig in its ESI).");
  }
  return {};
}

bool PdoMappingEditor::outputs() const {
  const auto pdos = pdos_of(*slave(), PdoDirection::kRx);
  return std::ranges::find(pdos, pdo_, &Pdo::index) != pdos.end();
}

void PdoMappingEditor::showPdo(std::uint16_t pdo, const QString& title) {
  if (pdo != pdo_) page_.fields().revert();
  pdo_ = pdo;
  title_->setText(title);
  showEntries();
  showing_ = true;
  view_->setCurrentIndex(model_->index(0, 0));
  showing_ = false;
}

int PdoMappingEditor::row() const { return view_->currentIndex().row(); }

void PdoMappingEditor::selectRow(int row) { view_->setCurrentIndex(row < 0 ? QModelIndex() : model_->index(row, 0)); }

void PdoMappingEditor::showEntries() {
  const int before = row();
  const auto* of = slave();
  showing_ = true;
  model_->setEntries(of != nullptr && pdo_ != 0 ? entriesOf(*of, pdo_) : std::vector<PdoEntry>{});
  if (row() < 0) selectRow(std::min(std::max(before, 0), model_->rowCount() - 1));
  showing_ = false;
}

void PdoMappingEditor::refreshButtons() {
  form_->refresh();
  const auto why = refusal();
  const bool free = why.isEmpty();
  model_->setMovable(free);
  refusal_->setText(why);
  refusal_->setVisible(!free && pdo_ != 0);
  card_->setVisible(free);
  choose_->setVisible(free && !slave()->device.dictionary.empty());
  choose_->setEnabled(row() >= 0);
}

void PdoMappingEditor::chooseObject() {
  const auto use = outputs() ? ObjectUse::kMapOutputs : ObjectUse::kMapInputs;
  auto* picker = new ObjectPicker(pickableObjects(slave()->device, use), this);
  picker->setAttribute(Qt::WA_DeleteOnClose);
  connect(picker, &ObjectPicker::picked, this, [this](const PickableObject& object) {
    form_->replace(entryText(objectText(object.index, object.sub_index), QString::number(object.bits)));
  });
  picker->open();
}

}  // namespace syncline::ui
