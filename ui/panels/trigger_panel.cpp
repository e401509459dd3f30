// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/trigger_panel.h"

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <span>

#include "config/network_config.h"
#include "findings/event_words.h"
#include "findings/run_bus_words.h"
#include "findings/run_slaves_words.h"
#include "record/run_record.h"
#include "trace/sync_overview.h"
#include "ui/session/trigger_monitor.h"
#include "ui/text/signal_text.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr int kEventSource = -1, kFindingSource = -2;
enum Condition : std::uint8_t { kRises, kFalls, kCrosses, kLeaves, kEnters };
enum EpisodeColumn : std::uint8_t { kTimeColumn, kCycleColumn, kCauseColumn, kSlaveColumn, kNameColumn, kColumns };

QString triggerSignal(Signal signal) {
  if (signal == Signal::kSm2Missed) return TriggerPanel::tr("SM2 events missed");
  if (signal == Signal::kFramesLost) return TriggerPanel::tr("Frames lost in a cycle");
  if (signal == Signal::kArrivalPhase) return TriggerPanel::tr("Arrival phase of a slave");
  if (signal == Signal::kSetpointSlips) return TriggerPanel::tr("Setpoint slips of a slave");
  if (signal == Signal::kSlaveDeviation) return TriggerPanel::tr("Deviation of a slave");
  if (signal == Signal::kVariable) return TriggerPanel::tr("A watched variable");
  return signalText(signal);
}

QString eventTitle(std::string_view code) {
  const auto* words = find_finding_words(code);
  return words == nullptr ? QString() : QCoreApplication::translate("Finding", std::string(words->title).c_str());
}

constexpr double kLargestTime = 2e9, kLargestValue = 1e12;  // of the fields

/// Of a signal it is the slave's own, of these any slave's may be wanted.
bool isTold(int source) { return source == kEventSource || source == kFindingSource; }

bool ofSlave(int source) {
  return isTold(source) || info(static_cast<Signal>(source)).scope == SignalInfo::Scope::kSlave;
}

/// In a small window the fields are scrolled; none pushes the window wider.
QWidget* scrolled(QLayout* fields) {
  auto* inside = new QWidget;
  fields->setContentsMargins(0, 0, 0, 0);
  inside->setLayout(fields);
  auto* area = new QScrollArea;
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidgetResizable(true);
  area->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
  area->setMinimumSize(180, 60);
  area->setWidget(inside);
  return area;
}

}  // namespace

TriggerPanel::TriggerPanel(TriggerMonitor& monitor, QWidget* parent) : QWidget(parent), monitor_(monitor) {
  setObjectName(QStringLiteral("triggerPanel"));
  setAccessibleName(tr("Trigger"));
  source_ = choice("triggerSource", tr("What the trigger watches"),
                   tr("A signal, in every cycle of it, an event, or a finding"), 14);
  slave_ = choice("triggerSlave", tr("Slave of the trigger"), tr("Whose signal or event"), 8);
  variable_ = choice("triggerVariable", tr("Variable of the trigger"),
                     tr("Which variable; they are watched on the page Variables"), 18);
  condition_ = choice("triggerCondition", tr("Condition of the trigger"), tr("What the signal does"), 10);
  condition_->addItems({tr("rises to"), tr("falls to"), tr("crosses"), tr("leaves"), tr("enters")});
  event_ = choice("triggerEvent", tr("Event of the trigger"), tr("Which event"), 22);
  level_ = number("triggerLevel", tr("Level of the trigger"), tr("The level, in the unit of the signal"));
  low_ = number("triggerLow", tr("Lower edge of the band"), tr("Lower edge of the band; it belongs to the band"));
  high_ = number("triggerHigh", tr("Upper edge of the band"), tr("Upper edge of the band; it belongs to the band"));
  magnitude_ = named(new QCheckBox(tr("Absolute")), "triggerMagnitude", tr("Absolute value"));
  magnitude_->setToolTip(tr("Whatever the sign of the signal is"));
  mode_ =
      choice("triggerMode", tr("Mode of the trigger"),
             tr("Automatic: the plots go on following. Normal: they move to the newest episode. Single: they stop at "
                "the first one."),
             9);
  mode_->addItems({tr("Automatic"), tr("Normal"), tr("Single")});
  pre_ = number("triggerPre", tr("Time before the trigger"), tr("What of the time before belongs to an episode"));
  post_ = number("triggerPost", tr("Time after the trigger"), tr("What of the time after belongs to an episode"));
  hold_off_ = number("triggerHoldOff", tr("Hold-off"),
                     tr("For so long after a trigger no other episode begins; those left out are counted"));
  for (auto* spin : {pre_, post_, hold_off_}) {
    spin->setRange(0, 600'000);
    spin->setDecimals(1);
    spin->setSuffix(QStringLiteral(" ms"));
  }
  arm_ = named(new QPushButton(tr("Arm")), "triggerArm", tr("Arm the trigger"));
  arm_->setCheckable(true);
  state_ = named(new ValueLabel, "triggerState", tr("State of the trigger"));
  state_->setLeastCharacters(12);

  auto* fields = new QVBoxLayout;
  fields->setSpacing(4);
  const auto addLine = [fields](std::initializer_list<QWidget*> widgets) {
    auto* line = new QHBoxLayout;
    line->setSpacing(6);
    for (auto* widget : widgets) line->addWidget(widget);
    line->addStretch(1);
    fields->addLayout(line);
  };
  const auto labelFor = [](const QString& text, QWidget* field) {
    auto* label = new QLabel(text);
    label->setBuddy(field);
    return label;
  };
  addLine({source_, slave_, variable_, magnitude_});
  addLine({condition_, event_, level_, low_, high_, labelFor(tr("Hold-off"), hold_off_), hold_off_});
  addLine({mode_, labelFor(tr("Before"), pre_), pre_, labelFor(tr("After"), post_), post_});
  fields->addStretch(1);
  save_ = named(new QToolButton, "triggerSave", tr("Save the episode"));
  save_->setText(tr("Save…"));
  csv_ = named(new QToolButton, "triggerCsv", tr("Export the episode as CSV"));
  csv_->setText(tr("CSV…"));
  csv_->setToolTip(tr("The samples of the chosen episode, before and after included, as comma-separated values"));
  auto* head = new QHBoxLayout;
  head->setSpacing(6);
  head->addWidget(arm_);
  head->addWidget(state_, 1);
  head->addWidget(save_);
  head->addWidget(csv_);

  table_ = named(new QTableWidget(0, kColumns), "triggerEpisodes", tr("Episodes of the trigger"));
  setUpTable(*table_);
  table_->setHorizontalHeaderLabels({tr("Time"), tr("Cycle"), tr("Cause"), tr("Slave"), tr("Name")});
  table_->setFrameShape(QFrame::NoFrame);
  table_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
  table_->setToolTip(tr("Enter or a double click shows the episode in the plots; F2 names it"));
  table_->setMinimumHeight(44);
  for (const auto& [column, width] : {std::pair(kTimeColumn, 84), std::pair(kCycleColumn, 64),
                                      std::pair(kSlaveColumn, 76), std::pair(kNameColumn, 66)})
    table_->setColumnWidth(column, width);
  table_->horizontalHeader()->setSectionResizeMode(kCauseColumn, QHeaderView::Stretch);

  auto* episodes = new QVBoxLayout;
  episodes->setSpacing(4);
  episodes->addLayout(head);
  episodes->addWidget(table_, 1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 0);
  layout->setSpacing(12);
  layout->addWidget(scrolled(fields));
  layout->addLayout(episodes, 1);

  connect(arm_, &QPushButton::clicked, this, [this](bool on) { on ? monitor_.arm() : monitor_.disarm(); });
  connect(magnitude_, &QCheckBox::clicked, this, &TriggerPanel::takeFields);
  connect(table_, &QTableWidget::activated, this, [this] {
    if (const auto* episode = chosen()) Q_EMIT episodeWanted(*episode);
  });
  connect(table_, &QTableWidget::itemSelectionChanged, this, &TriggerPanel::enableExports);
  connect(table_, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem* item) {
    const auto row = static_cast<std::size_t>(item->row());
    if (showing_ || item->column() != kNameColumn || row >= monitor_.episodes().size()) return;
    monitor_.setName(monitor_.episodes()[row], item->text());
  });
  connect(save_, &QToolButton::clicked, this, [this] {
    if (const auto* episode = chosen()) Q_EMIT saveWanted(episode->from, episode->to);
  });
  connect(csv_, &QToolButton::clicked, this, [this] {
    if (const auto* episode = chosen()) Q_EMIT csvWanted(episode->from, episode->to);
  });
  connect(&monitor_, &TriggerMonitor::changed, this, &TriggerPanel::showEpisodes);
  connect(&monitor_, &TriggerMonitor::triggerChanged, this, &TriggerPanel::showTrigger);
  connect(&monitor_, &TriggerMonitor::recordChanged, this, &TriggerPanel::showTrigger);
  fillSources();
  showTrigger();
  showEpisodes();
}

QComboBox* TriggerPanel::choice(const char* name, const QString& accessible, const QString& tip, int characters) {
  auto* box = named(new QComboBox, name, accessible);
  box->setToolTip(tip);
  box->setFocusPolicy(Qt::StrongFocus);
  box->installEventFilter(this);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(characters);
  connect(box, &QComboBox::activated, this, &TriggerPanel::takeFields);
  return box;
}

QDoubleSpinBox* TriggerPanel::number(const char* name, const QString& accessible, const QString& tip) {
  auto* spin = named(new QDoubleSpinBox, name, accessible);
  spin->setToolTip(tip);
  spin->setRange(-kLargestTime, kLargestTime);
  spin->setDecimals(0);
  spin->setKeyboardTracking(false);
  spin->setButtonSymbols(QAbstractSpinBox::NoButtons);
  spin->setFocusPolicy(Qt::StrongFocus);
  spin->setFixedWidth(92);
  spin->installEventFilter(this);
  connect(spin, &QDoubleSpinBox::valueChanged, this, &TriggerPanel::takeFields);
  return spin;
}

/// The wheel without the focus edits nothing.
bool TriggerPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
    event->ignore();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void TriggerPanel::fillSources() {
  for (const auto& signal : signals()) {
    const auto text = triggerSignal(signal.id);
    if (signal.form != SignalInfo::Form::kCell && !text.isEmpty()) source_->addItem(text, static_cast<int>(signal.id));
  }
  source_->addItem(tr("An event"), kEventSource);
  source_->addItem(tr("A finding"), kFindingSource);
}

void TriggerPanel::fillCodes() {
  const bool findings = source_->currentData().toInt() == kFindingSource;
  if (event_->count() > 0 && event_->property("findings").toBool() == findings) return;
  event_->clear();
  event_->setProperty("findings", findings);
  const auto add = [this](std::span<const FindingWords> rows) {
    for (const auto& words : rows)
      event_->addItem(eventTitle(words.code),
                      QString::fromUtf8(words.code.data(), static_cast<qsizetype>(words.code.size())));
  };
  if (findings) {
    add(words::kRunSlaves);
    add(words::kRunBus);
  } else {
    add(words::kEvents);
  }
  event_->model()->sort(0);
  event_->setAccessibleName(findings ? tr("Finding of the trigger") : tr("Event of the trigger"));
  event_->setToolTip(findings
                         ? tr("Which finding; it counts at the moment at which it began, and one that is of the whole "
                              "run has none")
                         : tr("Which event"));
}

QString TriggerPanel::slaveText(int slave) const {
  if (slave < 0) return noText();
  const auto number = u'#' + QString::number(slave);
  const auto* record = monitor_.record();
  if (record == nullptr || static_cast<std::size_t>(slave) >= record->config().slaves.size()) return number;
  return number + u' ' + QString::fromStdString(record->slave_name(static_cast<std::size_t>(slave)));
}

void TriggerPanel::fillSlaves() {
  slave_->clear();
  if (isTold(source_->currentData().toInt())) slave_->addItem(tr("Any slave"), -1);
  const auto* record = monitor_.record();
  const int count = record == nullptr ? 0 : static_cast<int>(record->config().slaves.size());
  for (int slave = 0; slave < count; ++slave) slave_->addItem(slaveText(slave), slave);
  // It stays as it was set, also where this run has no such slave.
  const int wanted = monitor_.trigger().slave;
  if (slave_->findData(wanted) < 0 && wanted >= 0) slave_->addItem(slaveText(wanted), wanted);
  slave_->setCurrentIndex(std::max(slave_->findData(wanted), 0));
}

void TriggerPanel::fillVariables() {
  variable_->clear();
  const auto name = [](const std::string& text) { return QString::fromStdString(text); };
  if (const auto* record = monitor_.record()) {
    for (const auto& variable : record->watched().variables()) variable_->addItem(name(variable.name));
  }
  // It stays as it was set, also where this run does not have it.
  const auto wanted = name(monitor_.trigger().variable);
  if (variable_->findText(wanted) < 0 && !wanted.isEmpty()) variable_->addItem(wanted);
  variable_->setCurrentIndex(std::max(variable_->findText(wanted), 0));
}

void TriggerPanel::showTrigger() {
  showing_ = true;
  const auto& trigger = monitor_.trigger();
  const bool finding = trigger.kind == Trigger::Kind::kFinding;
  const bool event = finding || trigger.kind == Trigger::Kind::kEvent;
  const bool band = trigger.kind == Trigger::Kind::kWindow;
  source_->setCurrentIndex(source_->findData(finding ? kFindingSource
                                             : event ? kEventSource
                                                     : static_cast<int>(trigger.signal)));
  fillCodes();
  fillSlaves();
  slave_->setVisible(ofSlave(source_->currentData().toInt()));
  fillVariables();
  const bool variable = !event && trigger.signal == Signal::kVariable;
  variable_->setVisible(variable);
  condition_->setCurrentIndex(band ? (trigger.enters ? kEnters : kLeaves) : static_cast<int>(trigger.edge));
  condition_->setVisible(!event);
  event_->setCurrentIndex(std::max(event_->findData(QString::fromStdString(trigger.code)), 0));
  event_->setVisible(event);
  const auto unit = fromView(info(trigger.signal).unit);
  for (auto* spin : {level_, low_, high_}) {
    spin->setSuffix(unit.isEmpty() ? QString() : u' ' + unit);
    spin->setDecimals(unit == QLatin1String("ppm") || variable ? 3 : 0);
    const double largest = variable ? kLargestValue : kLargestTime;
    spin->setRange(-largest, largest);
  }
  level_->setValue(trigger.level);
  low_->setValue(trigger.low);
  high_->setValue(trigger.high);
  level_->setVisible(!event && !band);
  low_->setVisible(band);
  high_->setVisible(band);
  magnitude_->setChecked(trigger.magnitude);
  magnitude_->setVisible(!event);
  mode_->setCurrentIndex(static_cast<int>(trigger.mode));
  const auto milliseconds = [](Nanoseconds time) { return static_cast<double>(time) / 1e6; };
  pre_->setValue(milliseconds(trigger.pre));
  post_->setValue(milliseconds(trigger.post));
  hold_off_->setValue(milliseconds(trigger.hold_off));
  showing_ = false;
}

Trigger TriggerPanel::fields() const {
  auto trigger = monitor_.trigger();
  const int source = source_->currentData().toInt();
  const auto condition = static_cast<Condition>(condition_->currentIndex());
  if (isTold(source)) {
    trigger.kind = source == kEventSource ? Trigger::Kind::kEvent : Trigger::Kind::kFinding;
  } else {
    trigger.signal = static_cast<Signal>(source);
    trigger.kind = condition >= kLeaves ? Trigger::Kind::kWindow : Trigger::Kind::kLevel;
  }
  if (condition < kLeaves) trigger.edge = static_cast<Trigger::Edge>(condition);
  trigger.enters = condition == kEnters;
  trigger.slave = slave_->currentIndex() < 0 ? -1 : slave_->currentData().toInt();
  if (!isTold(source) && trigger.signal == Signal::kVariable) trigger.variable = variable_->currentText().toStdString();
  // A signal is always somebody's.
  if (!isTold(source) && ofSlave(source)) trigger.slave = std::max(trigger.slave, 0);
  trigger.code = event_->currentData().toString().toStdString();
  trigger.magnitude = magnitude_->isChecked();
  trigger.level = level_->value();
  trigger.low = std::min(low_->value(), high_->value());
  trigger.high = std::max(low_->value(), high_->value());
  trigger.mode = static_cast<Trigger::Mode>(mode_->currentIndex());
  const auto time = [](const QDoubleSpinBox* spin) {
    return static_cast<Nanoseconds>(std::llround(spin->value() * 1e6));
  };
  trigger.pre = time(pre_);
  trigger.post = time(post_);
  trigger.hold_off = time(hold_off_);
  return trigger;
}

void TriggerPanel::takeFields() {
  if (showing_) return;
  fillCodes();  // the source may be another one: what is taken is what is shown
  monitor_.setTrigger(fields());
}

const TriggerEpisode* TriggerPanel::chosen() const {
  const int row = table_->currentRow();
  const auto& episodes = monitor_.episodes();
  return row < 0 || static_cast<std::size_t>(row) >= episodes.size() ? nullptr
                                                                     : &episodes[static_cast<std::size_t>(row)];
}

QString TriggerPanel::causeText(const TriggerEpisode& episode) const {
  const auto& trigger = monitor_.trigger();
  auto text = trigger.kind == Trigger::Kind::kEvent || trigger.kind == Trigger::Kind::kFinding
                  ? eventTitle(trigger.code)
                  : tr("%1 %2: %3")
                        .arg(trigger.signal == Signal::kVariable ? variable_->currentText() : source_->currentText(),
                             condition_->currentText(), signalValue(trigger.signal, episode.value));
  if (episode.left_out > 0) text += tr(" (%1 more in the hold-off)").arg(countText(episode.left_out));
  return text;
}

void TriggerPanel::enableExports() {
  const bool any = chosen() != nullptr;
  csv_->setEnabled(any);
  save_->setEnabled(any && !monitor_.isRecorded());
}

void TriggerPanel::showEpisodes() {
  showing_ = true;
  arm_->setChecked(monitor_.isArmed());
  auto state = monitor_.stateText();
  if (const auto left_out = monitor_.leftOut(); left_out > 0)
    state += tr(", %1 within the hold-off").arg(countText(left_out));
  state_->setText(state);
  const auto& episodes = monitor_.episodes();
  // Rows move up where early episodes are forgotten; who has chosen one keeps it.
  const auto* marked = table_->item(table_->currentRow(), kTimeColumn);
  const auto kept = marked == nullptr ? std::nullopt : std::optional(marked->data(Qt::UserRole).toLongLong());
  table_->setRowCount(static_cast<int>(episodes.size()));
  const auto put = [this](int row, int column, const QString& text) {
    auto* item = table_->item(row, column);
    if (item == nullptr) {
      table_->setItem(row, column, item = new QTableWidgetItem);
      if (column != kNameColumn) item->setFlags(item->flags() & ~Qt::ItemIsEditable);
    }
    if (item->text() != text) item->setText(text);
  };
  const auto origin = monitor_.record() == nullptr ? 0 : monitor_.record()->overview().begin;
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    const auto& episode = episodes[i];
    const int row = static_cast<int>(i);
    put(row, kTimeColumn,
        QLocale().toString(static_cast<double>(episode.time - origin) / 1e9, 'f', 6) + QStringLiteral(" s"));
    table_->item(row, kTimeColumn)->setData(Qt::UserRole, static_cast<qlonglong>(episode.time));
    put(row, kCycleColumn, episode.cycle ? QString::number(*episode.cycle) : noText());
    put(row, kCauseColumn, causeText(episode));
    put(row, kSlaveColumn, slaveText(episode.slave));
    put(row, kNameColumn, monitor_.name(episode));
  }
  const auto still = std::ranges::find(episodes, kept.value_or(0), &TriggerEpisode::time);
  if (!kept || still == episodes.end()) {
    table_->setCurrentCell(-1, -1);
  } else if (const int row = static_cast<int>(still - episodes.begin()); row != table_->currentRow()) {
    table_->setCurrentCell(row, table_->currentColumn());
  }
  enableExports();
  save_->setToolTip(monitor_.isRecorded() ? tr("What is shown is a recording already")
                                          : tr("A recording of the chosen episode, out of memory"));
  showing_ = false;
}

}  // namespace syncline::ui
