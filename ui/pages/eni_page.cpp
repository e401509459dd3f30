// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/eni_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QHideEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <memory>
#include <utility>

#include "settings/settings_table.h"
#include "ui/models/eni_finding_model.h"
#include "ui/models/eni_model.h"
#include "ui/pages/eni_text_view.h"
#include "ui/session/eni_preview.h"
#include "ui/session/workspace.h"
#include "ui/text/error_text.h"
#include "ui/text/event_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/glossary.h"
#include "ui/text/setting_text.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

const QString kDialectKey = QStringLiteral("eni/dialect"), kReportKey = QStringLiteral("eni/report");
constexpr int kNoSection = -1;

QString sectionName(const eni::EniSection& section, const Project& project) {
  switch (section.part) {
    case eni::EniPart::kMaster:
      return masterWord();
    case eni::EniPart::kSlave:
      return section.slave < static_cast<int>(project.slaves.size()) ? nodeName(project, section.slave) : QString();
    case eni::EniPart::kCyclic:
      return EniPage::tr("Cyclic");
    case eni::EniPart::kProcessImage:
      return EniPage::tr("Process image");
    case eni::EniPart::kOther:
      break;
  }
  return EniPage::tr("Other");
}

/// The line of another text that stands where `line` did: as far from the beginning of the same section.
std::size_t sameLine(const EniLines& from, std::size_t line, const EniLines& to) {
  for (std::size_t i = 0; i < from.sections.size(); ++i) {
    const auto& section = from.sections[i];
    if (line < section.first || line >= section.first + section.count) continue;
    const auto found = std::ranges::find_if(to.sections, [&](const eni::EniSection& other) {
      return other.part == section.part && other.slave == section.slave;
    });
    if (found == to.sections.end()) break;
    return found->first + std::min(line - section.first, found->count - 1);
  }
  return line;
}

}  // namespace

EniPage::EniPage(Workspace& workspace)
    : Page(workspace, "eniPage", tr("ENI")),
      preview_(workspace.eni()),
      model_(new EniModel(this)),
      findings_(new EniFindingModel(this)) {
  preview_.setDialect(static_cast<EniDialect>(workspace.memory().value(kDialectKey).toInt() != 0));
  preview_.setReported(workspace.memory().value(kReportKey).toBool());
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(12, 8, 12, 8);
  layout->setSpacing(6);
  layout->addWidget(buildChoices());
  layout->addWidget(buildSearch());
  trouble_ = named(new QLabel, "eniTrouble", tr("What stands against the ENI"));
  trouble_->setWordWrap(true);
  trouble_->hide();
  layout->addWidget(trouble_);
  layout->addWidget(buildTrial());
  auto* split = named(new QSplitter(Qt::Vertical), "eniSplitter", tr("ENI and what the checker says of it"));
  text_ = new EniTextView(*model_);
  split->addWidget(text_);
  found_ = buildFindings();
  split->addWidget(found_);
  split->setStretchFactor(0, 3);
  split->setStretchFactor(1, 1);
  split->setChildrenCollapsible(false);
  layout->addWidget(split, 1);
  auto* bottom = new QHBoxLayout;
  summary_ = named(new ValueLabel, "eniSummary", tr("Lines that changed"));
  summary_->setLeastCharacters(20);
  checked_ = named(new ValueLabel, "eniChecked", tr("Whether the ENI is up to date, and what the checker says of it"));
  checked_->setLeastCharacters(16);
  checked_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  bottom->addWidget(summary_, 1);
  bottom->addWidget(checked_, 1);
  layout->addLayout(bottom);
  setWidget(content);
  buildShortcuts();
  connect(&preview_, &EniPreview::changed, this, &EniPage::showView);
  connect(&preview_, &EniPreview::progressed, this, &EniPage::showProgress);
  showProgress();
}

QWidget* EniPage::buildChoices() {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  dialect_ = named(new QComboBox, "eniDialect", tr("Dialect of the ENI"));
  dialect_->addItem(QStringLiteral("EC-Engineer"), static_cast<int>(EniDialect::kEcEngineer));
  dialect_->addItem(QStringLiteral("TwinCAT"), static_cast<int>(EniDialect::kTwinCat));
  dialect_->setCurrentIndex(static_cast<int>(preview_.dialect()));
  dialect_->setWhatsThis(
      tr("How the ENI is laid out and spelled, here and when it is exported: as EC-Engineer does, or "
         "as TwinCAT 3 does."));
  since_ = named(new QComboBox, "eniSince", tr("Since when changes are shown"));
  since_->addItem(tr("Changes since saved"), static_cast<int>(EniPreview::Since::kSaved));
  since_->addItem(tr("Changes since exported"), static_cast<int>(EniPreview::Since::kExported));
  since_->addItem(tr("Changes since opened here"), static_cast<int>(EniPreview::Since::kOpened));
  since_->addItem(tr("The last change"), static_cast<int>(EniPreview::Since::kLastEdit));
  since_->setCurrentIndex(static_cast<int>(preview_.since()));
  change_up_ = stepButton("eniChangeUp", tr("Previous change"), Qt::UpArrow, QKeySequence(Qt::ALT | Qt::Key_Up));
  change_down_ = stepButton("eniChangeDown", tr("Next change"), Qt::DownArrow, QKeySequence(Qt::ALT | Qt::Key_Down));
  only_changes_ = named(new QCheckBox(tr("&Only changes")), "eniOnlyChanges", tr("Show only the lines around changes"));
  layout->addWidget(dialect_);
  layout->addWidget(since_);
  layout->addWidget(change_up_);
  layout->addWidget(change_down_);
  layout->addWidget(only_changes_);
  layout->addStretch(1);
  connect(dialect_, &QComboBox::activated, this, [this] {
    preview_.setDialect(static_cast<EniDialect>(dialect_->currentData().toInt()));
    this->workspace().memory().setValue(kDialectKey, dialect_->currentData().toInt());
  });
  connect(since_, &QComboBox::activated, this, [this] {
    since_chosen_ = true;
    preview_.setSince(static_cast<EniPreview::Since>(since_->currentData().toInt()));
  });
  connect(change_up_, &QToolButton::clicked, this, [this] { stepChange(false); });
  connect(change_down_, &QToolButton::clicked, this, [this] { stepChange(true); });
  connect(only_changes_, &QCheckBox::toggled, this, [this](bool only) {
    const auto line = model_->lineAt(text_->currentIndex().row());
    model_->setOnlyChanges(only);
    goToLine(line);
  });
  return area;
}

QToolButton* EniPage::stepButton(const char* name, const QString& what, Qt::ArrowType arrow, const QKeySequence& keys) {
  auto* button = named(new QToolButton, name, what);
  button->setArrowType(arrow);
  button->setAutoRaise(true);
  button->setToolTip(QStringLiteral("%1 (%2)").arg(what, keys.toString(QKeySequence::NativeText)));
  auto* shortcut = new QShortcut(keys, this);
  shortcut->setContext(Qt::WidgetWithChildrenShortcut);
  connect(shortcut, &QShortcut::activated, button, &QToolButton::click);
  return button;
}

QWidget* EniPage::buildSearch() {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  section_ = named(new QComboBox, "eniSection", tr("Part of the ENI to go to"));
  section_->setMinimumContentsLength(16);
  section_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  section_->setPlaceholderText(tr("Go to"));
  words_ = named(new QLineEdit, "eniWords", tr("Search the ENI"));
  words_->setPlaceholderText(tr("Search (Ctrl+F)"));
  words_->setClearButtonEnabled(true);
  found_up_ = stepButton("eniFoundUp", tr("Previous place"), Qt::UpArrow, QKeySequence(Qt::SHIFT | Qt::Key_F3));
  found_down_ = stepButton("eniFoundDown", tr("Next place"), Qt::DownArrow, QKeySequence(Qt::Key_F3));
  report_ = named(new QCheckBox(tr("&Report")), "eniReport", tr("Write a report beside each ENI that is exported"));
  report_->setToolTip(
      tr("An HTML file beside the ENI: slaves, clocks, frames, findings and the drawing of the wiring"));
  report_->setChecked(preview_.reported());
  layout->addWidget(section_);
  layout->addWidget(words_, 1);
  layout->addWidget(found_up_);
  layout->addWidget(found_down_);
  layout->addSpacing(8);
  auto* compare = named(new QPushButton(tr("Co&mpare…")), "eniCompare", tr("Compare the project with a file"));
  auto* write = named(new QPushButton(tr("E&xport…")), "eniExport", tr("Write the ENI to a file"));
  layout->addWidget(compare);
  layout->addWidget(write);
  layout->addWidget(report_);
  connect(compare, &QPushButton::clicked, this, &EniPage::compareWanted);
  connect(write, &QPushButton::clicked, this, &EniPage::exportWanted);
  connect(report_, &QCheckBox::toggled, &preview_, &EniPreview::setReported);
  connect(&preview_, &EniPreview::reportedChanged, this, [this] {
    report_->setChecked(preview_.reported());
    this->workspace().memory().setValue(kReportKey, preview_.reported());
  });
  connect(section_, &QComboBox::activated, this, [this] {
    const auto line = static_cast<std::size_t>(section_->currentData().toULongLong());
    text_->goToRow(model_->rowOf(line), EniTextView::PositionAtTop);
  });
  connect(words_, &QLineEdit::returnPressed, this, [this] { stepFound(true); });
  connect(found_up_, &QToolButton::clicked, this, [this] { stepFound(false); });
  connect(found_down_, &QToolButton::clicked, this, [this] { stepFound(true); });
  return area;
}

QWidget* EniPage::buildTrial() {
  trial_bar_ = new QWidget;
  auto* layout = new QHBoxLayout(trial_bar_);
  layout->setContentsMargins(0, 0, 0, 0);
  trial_ = named(new ValueLabel, "eniTrial", tr("What depends on a setting"));
  trial_->setLeastCharacters(30);
  auto* end = named(new QPushButton(tr("Show &Changes")), "eniTrialEnd", tr("Show changes in place of what depends"));
  layout->addWidget(trial_, 1);
  layout->addWidget(end);
  connect(end, &QPushButton::clicked, this, [this] {
    text_->setFocus();
    preview_.showDependents({});
  });
  trial_bar_->hide();
  return trial_bar_;
}

QTableView* EniPage::buildFindings() {
  auto* table = named(new QTableView, "eniFindings", tr("What the checker says of the ENI"));
  setUpTable(*table);
  table->setModel(findings_);
  table->setColumnWidth(EniFindingModel::kSeverity, 92);
  table->setColumnWidth(EniFindingModel::kLine, 72);
  table->setColumnWidth(EniFindingModel::kRule, 120);
  stretchColumn(*table, EniFindingModel::kFinding);
  table->setMinimumHeight(3 * table->verticalHeader()->defaultSectionSize());
  const auto go = [this](const QModelIndex& index) {
    const int line = index.data(EniFindingModel::kLineRole).toInt();
    if (line > 0) goToLine(static_cast<std::size_t>(line) - 1);
  };
  connect(table, &QTableView::clicked, this, go);
  connect(table, &QTableView::activated, this, go);
  table->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(table, &QWidget::customContextMenuRequested, this, &EniPage::openFindingMenu);
  table->hide();
  return table;
}

/// What the messages offer for a finding, here too.
void EniPage::openFindingMenu(const QPoint& at) {
  const auto index = found_->indexAt(at);
  if (!index.isValid()) return;
  const auto& finding = findings_->finding(index.row());
  if (finding.place.key.empty() && finding.place.slave < 0) return;  // there is nothing to go to
  auto message = messageOf(finding, project());
  message.finding = std::make_shared<const Finding>(finding);
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("eniFindingMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  Q_EMIT findingMenuOpens(*menu, message);
  menu->popup(found_->viewport()->mapToGlobal(at));
}

void EniPage::buildShortcuts() {
  auto* search = new QShortcut(QKeySequence::Find, this);
  search->setContext(Qt::WidgetWithChildrenShortcut);
  connect(search, &QShortcut::activated, this, [this] {
    words_->setFocus(Qt::ShortcutFocusReason);
    words_->selectAll();
  });
}

bool EniPage::appliesTo(int) const { return true; }

void EniPage::showLive(const Snapshot&) {}

void EniPage::refresh() {
  if (node() != gone_to_) goToNode();
}

void EniPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  if (!since_chosen_) {
    const bool file = !workspace().document().path().isEmpty();
    preview_.setSince(file ? EniPreview::Since::kSaved : EniPreview::Since::kOpened);
    since_->setCurrentIndex(static_cast<int>(preview_.since()));
  }
  came_back_ = true;
  preview_.setWatched(true);
  goToNode();
}

void EniPage::hideEvent(QHideEvent* event) {
  left_ = preview_.view();
  preview_.setWatched(false);
  if (!event->spontaneous()) preview_.showDependents({});
  Page::hideEvent(event);
}

void EniPage::goToNode() {
  const auto* view = model_->view();
  if (view == nullptr || !isVisible() || !preview_.isCurrent() || preview_.view().get() != view) return;
  const bool edited = std::exchange(came_back_, false) && preview_.view() != left_;
  if (node() == gone_to_ && !edited) return;
  gone_to_ = node();
  const auto found = std::ranges::find_if(view->text->sections, [this](const eni::EniSection& section) {
    return node() < 0 ? section.part == eni::EniPart::kMaster : section.slave == node();
  });
  if (found == view->text->sections.end()) return;
  section_->setCurrentIndex(static_cast<int>(found - view->text->sections.begin()));
  const int row = model_->rowOf(found->first);
  // To what changed of it: whoever comes after an edit comes for that. Of the master's node that is the whole file.
  const int end = node() < 0 ? model_->rowCount() : row + static_cast<int>(found->count);
  const int change = model_->changeFrom(node() < 0 ? -1 : row, true);
  if (change >= (node() < 0 ? 0 : row) && change < end) return text_->goToRow(change, EniTextView::PositionAtCenter);
  text_->goToRow(row, EniTextView::PositionAtTop);
}

void EniPage::showDependents(const QString& key) {
  first_wanted_ = true;
  preview_.showDependents(key.toStdString());
  showProgress();
  goToFirst();
}

/// Once for each setting that is asked for, when it is its lines that are shown.
void EniPage::goToFirst() {
  const auto* view = model_->view();
  if (!first_wanted_ || !preview_.isCurrent() || view == nullptr || !view->trial) return;
  if (view->trial->key != preview_.dependentsOf()) return;
  first_wanted_ = false;
  if (!view->changes.empty()) text_->goToRow(model_->changeFrom(-1, true));
}

void EniPage::goToLine(std::size_t line) { text_->goToRow(model_->rowOf(line)); }

void EniPage::stepChange(bool forward) { text_->goToRow(model_->changeFrom(text_->currentIndex().row(), forward)); }

void EniPage::stepFound(bool forward) {
  const int row = model_->find(words_->text(), text_->currentIndex().row(), forward);
  if (row >= 0) return text_->goToRow(row);
  if (!words_->text().isEmpty()) summary_->setText(tr("\"%1\" is not in it").arg(words_->text()));
}

/// Another text: what was looked at stays where it is.
void EniPage::showView() {
  const auto& view = preview_.view();
  if (view.get() != model_->view() && view != nullptr) {
    const bool first = model_->view() == nullptr;
    const auto place = [&](int row) {
      return first ? 0 : sameLine(*model_->view()->text, model_->lineAt(row), *view->text);
    };
    const auto top = place(text_->verticalScrollBar()->value());
    const auto current = place(text_->currentIndex().row());
    const bool had_current = text_->currentIndex().isValid();
    model_->setView(view);
    text_->adaptColumns();
    if (had_current)
      text_->selectionModel()->setCurrentIndex(model_->index(model_->rowOf(current), EniModel::kText),
                                               QItemSelectionModel::NoUpdate);
    text_->verticalScrollBar()->setValue(model_->rowOf(top));
    fillSections();
  }
  goToNode();
  since_->setCurrentIndex(static_cast<int>(preview_.since()));
  showProgress();
  goToFirst();
}

void EniPage::fillSections() {
  const auto& sections = model_->view()->text->sections;
  const auto chosen = section_->currentIndex();
  const auto count = static_cast<int>(sections.size());
  while (section_->count() > count) section_->removeItem(section_->count() - 1);
  for (int i = 0; i < count; ++i) {
    const auto& section = sections[static_cast<std::size_t>(i)];
    if (i == section_->count()) section_->addItem(QString());
    const auto name = sectionName(section, project());
    if (section_->itemText(i) != name) section_->setItemText(i, name);
    section_->setItemData(i, QVariant::fromValue<qulonglong>(section.first));
  }
  section_->setCurrentIndex(chosen < count ? chosen : kNoSection);
}

void EniPage::showProgress() {
  goToNode();
  showFindings();
  showSummary();
  showTrial();
  text_->setOutdated(preview_.failure().has_value());
  QString trouble;
  if (preview_.failure()) {
    trouble = tr("The project cannot be compiled: %1").arg(errorText(*preview_.failure()));
    if (preview_.view() != nullptr)
      trouble += u' ' + tr("What stands here is old: it was made at %1.")
                            .arg(QLocale().toString(preview_.time().time(), QLocale::ShortFormat));
  } else if (const auto* view = model_->view()) {
    const auto worst = std::ranges::find(view->findings, Severity::kError, &Finding::severity);
    const auto errors = static_cast<int>(std::ranges::count(view->findings, Severity::kError, &Finding::severity));
    if (errors > 0)
      trouble = tr("%n error(s) of the project stand against this ENI.", nullptr, errors) + u' ' + findingWhole(*worst);
  }
  trouble_->setText(trouble);
  trouble_->setVisible(!trouble.isEmpty());
}

void EniPage::showSummary() {
  const auto* view = model_->view();
  const bool any = view != nullptr && !view->changes.empty();
  for (auto* button : {change_up_, change_down_}) button->setEnabled(any);
  only_changes_->setEnabled(any || only_changes_->isChecked());
  if (view == nullptr || (view->trial && !any)) return summary_->setText({});
  if (view->before == nullptr)
    return summary_->setText(since_->currentData().toInt() == static_cast<int>(EniPreview::Since::kLastEdit)
                                 ? tr("Nothing has been changed yet")
                             : since_->currentData().toInt() == static_cast<int>(EniPreview::Since::kExported)
                                 ? tr("Not exported yet: nothing to compare with")
                                 : tr("Not saved yet: nothing to compare with"));
  if (!any) return summary_->setText(tr("No line differs"));
  summary_->setText(QStringLiteral("%1, %2, %3")
                        .arg(tr("%n line(s) added", nullptr, static_cast<int>(view->added)),
                             tr("%n removed", nullptr, static_cast<int>(view->removed)),
                             tr("%n altered", nullptr, static_cast<int>(view->altered))));
}

void EniPage::showTrial() {
  const auto& key = preview_.dependentsOf();
  trial_bar_->setVisible(!key.empty());
  if (key.empty()) return;
  const auto ref = settings::find(project(), key, false);
  if (!ref) return trial_->setText({});
  const auto label = settingLabel(*ref->setting);
  const auto node = nodeName(project(), ref->setting->of_slave() ? static_cast<int>(ref->place.slave) : -1);
  const auto* view = model_->view();
  const bool known = preview_.isCurrent() && view != nullptr && view->trial && view->trial->key == key;
  if (!known) return trial_->setText(tr("Looking for what depends on \"%1\" of %2…").arg(label, node));
  if (!view->trial->tried)
    return trial_->setText(
        tr("No other value of \"%1\" of %2 can be tried, so what depends on it is not known.").arg(label, node));
  trial_->setText(
      view->changes.empty()
          ? tr("\"%1\" of %2 does not change the ENI: it is used by the master at run time.").arg(label, node)
          : tr("Marked is what depends on \"%1\" of %2; struck out, how it would be with %3.")
                .arg(label, node, QString::fromStdString(view->trial->value)));
}

void EniPage::showFindings() {
  const auto& check = preview_.check();
  if (preview_.isComputing()) return checked_->setText(tr("Computing…"));
  if (preview_.failure()) return checked_->setText(tr("Out of date"));
  if (preview_.view() == nullptr) return checked_->setText({});
  if (check == nullptr) return checked_->setText(tr("Being checked…"));
  findings_->setFindings(eni::findings_of_export(*check));
  const bool any = findings_->rowCount() > 0;
  found_->setVisible(any);
  checked_->setText(any ? QStringLiteral("%1, %2, %3")
                              .arg(tr("%n error(s)", nullptr, findings_->count(Severity::kError)),
                                   tr("%n warning(s)", nullptr, findings_->count(Severity::kWarning)),
                                   tr("%n note(s)", nullptr, findings_->count(Severity::kNote)))
                        : tr("The checker finds nothing"));
}

}  // namespace syncline::ui
