// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_startup_page.h"

#include <QPushButton>
#include <QVBoxLayout>

#include "protocol/coe_data_type.h"
#include "protocol/object_value.h"
#include "settings/predicates.h"
#include "settings/startup_text.h"
#include "ui/editors/choice_edit.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/object_picker.h"
#include "ui/editors/record_editor.h"
#include "ui/editors/record_form.h"
#include "ui/pages/startup_parts.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr const char *kCoeKey = "slave.N.startup.K", *kSoeKey = "slave.N.soe.K";
constexpr int kAsDictionary = -1;

/// What Add appends sends nothing before the user says what.
constexpr const char *kFreshCoe = "PS 0x2000:00=00 off", *kFreshSoe = "PS 0:S-0-0001=0000 off";

}  // namespace

SlaveStartupPage::SlaveStartupPage(Workspace& workspace) : Page(workspace, "slaveStartupPage", tr("Start-up")) {
  auto coe = listOf(kCoeKey, tr("start-up command"));
  coe.nothing = tr("None: the slave starts with what it has.");
  coe.fresh = [](const Records&) { return std::string(kFreshCoe); };
  auto soe = listOf(kSoeKey, tr("SoE start-up command"));
  soe.nothing = coe.nothing;
  soe.fresh = [](const Records&) { return std::string(kFreshSoe); };
  coe_ = new RecordEditor(*this, "startup", tr("Objects (CoE)"), std::move(coe),
                          coeParts([this](const StartupCommand& command) { return typeOf(command); }), true);
  soe_ = new RecordEditor(*this, "soe", tr("Parameters (SoE)"), std::move(soe), soeParts(), true);
  addTypes();
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(12, 10, 12, 10);
  layout->setSpacing(14);
  layout->addWidget(coe_, 1);
  layout->addWidget(soe_, 1);
  setWidget(content);
}

RecordList SlaveStartupPage::listOf(const char* key, const QString& item) {
  const auto& setting = settings::row(key);
  const auto at = [this] { return static_cast<std::size_t>(node()); };
  RecordList list{.key = key, .item = item, .ordered = true, .read = {}, .edits = {}, .fresh = {}, .place = {}};
  list.read = [this, &setting, at] {
    Records records;
    if (slave() == nullptr) return records;
    for (const auto& place : setting.items(project(), at()))
      records.push_back(settings::text_of(setting, project(), place));
    return records;
  };
  list.edits = [key, at](const Records& before, const Records& after) { return itemEdits(key, at(), before, after); };
  list.place = [this, &setting, at](int row) -> std::optional<settings::Place> {
    if (slave() == nullptr || row < 0 || std::cmp_greater_equal(row, setting.items(project(), at()).size())) return {};
    return settings::Place{at(), static_cast<std::uint32_t>(row)};
  };
  return list;
}

/// How the value is written is a matter of looking: it is no setting.
void SlaveStartupPage::addTypes() {
  type_ = named(new ChoiceEdit, "coeType", tr("Data type"));
  type_->setToolTip(tr("As what the value is written; the command holds its bytes"));
  coe_->card().form()->insertRow(3, tr("Data type"), type_);
  connect(type_, &QComboBox::activated, this, [this] {
    const auto command = selected();
    if (!command) return;
    const std::tuple key{node(), command->index, command->sub_index};
    const int code = type_->currentData().toInt();
    if (code == kAsDictionary) {
      wanted_types_.erase(key);
    } else {
      wanted_types_[key] = static_cast<std::uint16_t>(code);
    }
    refresh();
  });
  choose_ = named(new QPushButton(tr("Choose Object…")), "coeChoose", tr("Choose an object of the device"));
  connect(static_cast<QPushButton*>(choose_), &QPushButton::clicked, this, &SlaveStartupPage::chooseObject);
  coe_->card().addWide(choose_);
}

const SlaveSettings* SlaveStartupPage::slave() const {
  const auto& slaves = project().slaves;
  return node() >= 0 && std::cmp_less(node(), slaves.size()) ? &slaves[static_cast<std::size_t>(node())] : nullptr;
}

std::uint16_t SlaveStartupPage::typeOf(const StartupCommand& command) const {
  const auto wanted = wanted_types_.find({node(), command.index, command.sub_index});
  if (wanted != wanted_types_.end()) return wanted->second;
  return slave() != nullptr ? usualType(slave()->device, command) : kBytesType;
}

std::optional<StartupCommand> SlaveStartupPage::selected() const {
  const auto* of = slave();
  const int row = coe_->row();
  if (of == nullptr || row < 0 || std::cmp_greater_equal(row, of->startup.size())) return {};
  return of->startup[static_cast<std::size_t>(row)];
}

void SlaveStartupPage::showTypes() {
  const auto command = selected();
  type_->clear();
  type_->setEnabled(command.has_value());
  if (!command) return;
  const auto usual = usualType(slave()->device, *command);
  type_->addItem(tr("As described (%1)").arg(QString::fromStdString(data_type_name(usual))), kAsDictionary);
  type_->addItem(QStringLiteral("BYTES"), kBytesType);
  for (const auto& type : coe::data_types()) {
    if (type.code != 0)
      type_->addItem(QString::fromUtf8(type.name.data(), static_cast<int>(type.name.size())), type.code);
  }
  const auto wanted = wanted_types_.find({node(), command->index, command->sub_index});
  type_->setCurrentIndex(wanted == wanted_types_.end() ? 0 : type_->findData(wanted->second));
}

/// Object, comment and default value of the dictionary, in one step.
void SlaveStartupPage::chooseObject() {
  const auto command = selected();
  if (!command) return;
  auto* picker = new ObjectPicker(pickableObjects(slave()->device, ObjectUse::kWrite), this);
  picker->setAttribute(Qt::WA_DeleteOnClose);
  connect(picker, &ObjectPicker::picked, this, [this](const PickableObject& object) {
    auto changed = selected();
    if (!changed) return;
    changed->index = object.index;
    changed->sub_index = object.sub_index;
    changed->complete_access = false;
    changed->comment = object.name.simplified().toStdString();
    changed->data = object.default_data;
    changed->data.resize(std::max<std::size_t>((object.bits + 7U) / 8U, 1));
    coe_->form().replace(settings::format_startup(*changed));
  });
  picker->open();
}

bool SlaveStartupPage::appliesTo(int position) const {
  const auto& slaves = project().slaves;
  if (position < 0 || std::cmp_greater_equal(position, slaves.size())) return false;
  const auto& of = slaves[static_cast<std::size_t>(position)];
  return settings::has_coe(of) || settings::has_soe(of) || !of.startup.empty() || !of.soe_startup.empty();
}

void SlaveStartupPage::showPlace(const settings::Setting& setting, const settings::Place& place) {
  if (setting.key == kCoeKey) coe_->select(static_cast<int>(place.item));
  if (setting.key == kSoeKey) soe_->select(static_cast<int>(place.item));
}

void SlaveStartupPage::refresh() {
  const auto* of = slave();
  if (of == nullptr) return;
  coe_->setVisible(settings::has_coe(*of) || !of->startup.empty());
  soe_->setVisible(settings::has_soe(*of) || !of->soe_startup.empty());
  choose_->setVisible(!of->device.dictionary.empty());
  coe_->showRecords();
  soe_->showRecords();
  showTypes();
  fields().refresh();
  coe_->refreshButtons();
  soe_->refreshButtons();
  choose_->setEnabled(selected().has_value());
}

}  // namespace syncline::ui
