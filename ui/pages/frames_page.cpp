// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/frames_page.h"

#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "advice/image_report.h"
#include "config/command_text.h"
#include "ui/models/record_model.h"
#include "ui/session/workspace.h"
#include "ui/text/glossary.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {
namespace {

/// Of a table that shall not push the others out of sight.
constexpr int kMostRowsShown = 12;

/// All frames of all tasks in their order, as ImageReport::frames.
std::vector<const CyclicFrame*> framesOf(const NetworkConfig& config) {
  std::vector<const CyclicFrame*> frames;
  for (const auto& task : config.cyclic) {
    for (const auto& frame : task.frames) frames.push_back(&frame);
  }
  return frames;
}

/// As high as its rows, and no higher than kMostRowsShown of them.
void fitSome(QTableView& view) {
  const int shown = std::min(view.model()->rowCount(), kMostRowsShown);
  const int rows = shown * view.verticalHeader()->defaultSectionSize();
  view.setFixedHeight(view.horizontalHeader()->sizeHint().height() + rows + 2 * view.frameWidth());
}

}  // namespace

FramesPage::FramesPage(Workspace& workspace) : Page(workspace, "framesPage", tr("Frames and Cost")) {
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(12, 12, 12, 12);
  layout->setSpacing(6);
  summary_ = named(new QLabel, "framesSummary", tr("What a cycle costs"));
  summary_->setWordWrap(true);
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(summary_);
  frames_ = addTable(*layout, "frameTable", tr("Cyclic frames"),
                     {tr("Frame"), tr("Every"), tr("Datagrams"), tr("Bytes"), tr("Process data"), tr("Wire time")},
                     frame_table_);
  datagrams_ = addTable(*layout, "datagramTable", tr("Datagrams of the selected frame"),
                        {tr("Command"), tr("Bytes"), tr("Counter"), tr("Sent in"), tr("Comment")}, datagram_table_);
  auto& header = *datagram_table_->horizontalHeader();
  header.setSectionResizeMode(QHeaderView::Interactive);
  for (const auto& [column, width] : {std::pair{0, 150}, {1, 60}, {2, 70}, {3, 170}})
    datagram_table_->setColumnWidth(column, width);
  header.setStretchLastSection(true);
  slaves_ =
      addTable(*layout, "slaveCostTable", tr("Slaves, the costliest first"),
               {tr("Slave"), tr("Outputs"), tr("Inputs"), tr("Bytes in datagrams"), tr("Wire time")}, slave_table_);
  movable_ = addTable(*layout, "movableTable", tr("Objects that could be exchanged by SDO instead"),
                      {tr("Slave"), tr("Object"), tr("PDO"), tr("Size"), tr("Saves")}, movable_table_);
  layout->addStretch(1);
  setWidget(content);
  connect(frame_table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
    if (const auto* config = this->workspace().configuration().config()) showDatagrams(*config);
  });
}

RecordModel* FramesPage::addTable(QVBoxLayout& layout, const char* object_name, const QString& heading,
                                  const QStringList& titles, QTableView*& view) {
  auto* label = new QLabel(heading);
  auto font = label->font();
  font.setWeight(QFont::DemiBold);
  label->setFont(font);
  auto* model = new RecordModel(titles, this);
  view = named(new QTableView, object_name, heading);
  view->setModel(model);
  setUpTable(*view);
  view->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  layout.addSpacing(6);
  layout.addWidget(label);
  layout.addWidget(view);
  return model;
}

void FramesPage::showEvent(QShowEvent* event) {
  refresh();
  Page::showEvent(event);
}

void FramesPage::refresh() {
  if (!isVisible()) return;
  const auto* config = workspace().configuration().config();
  if (config != nullptr && config->slaves.size() != project().slaves.size()) return;  // is compiled in a moment
  if (config == nullptr) {
    for (auto* model : {frames_, datagrams_, slaves_, movable_}) model->setLines({});
    summary_->setText(tr("The project cannot be compiled: the messages say why."));
  } else {
    const auto report = image_report(project(), *config);
    const QLocale locale;
    auto text =
        tr("Outputs %1, inputs %2, frames in a cycle of %4: %3. They take %5 on the wire, %6 % of the bandwidth.")
            .arg(bitsText(8 * report.output_bytes), bitsText(8 * report.input_bytes),
                 locale.toString(report.frames_per_cycle, 'g', 4), cycleText(report.cycle), timeText(report.wire_time),
                 locale.toString(100 * report.bandwidth, 'f', 1));
    text += u' ' + tr("The last frame is back after about %1.").arg(timeText(report.busiest_cycle));
    if (report.busiest_cycle > report.cycle) text += u' ' + tr("That is longer than the cycle.");
    summary_->setText(text);
    showFrames(report);
    showDatagrams(*config);
    showCost(report);
  }
  for (auto* view : {frame_table_, datagram_table_, slave_table_, movable_table_}) fitSome(*view);
}

void FramesPage::showFrames(const ImageReport& report) {
  RecordModel::Lines lines;
  for (std::size_t i = 0; i < report.frames.size(); ++i) {
    const auto& one = report.frames[i];
    lines.push_back({QString::number(i), cycleText(one.cycle), QString::number(one.datagrams),
                     QString::number(one.bytes), QString::number(one.process_data_bytes), timeText(one.wire_time)});
  }
  frames_->setLines(lines);
  if (frame() < 0 && !lines.empty()) frame_table_->setCurrentIndex(frames_->index(0, 0));
}

int FramesPage::frame() const { return frame_table_->currentIndex().row(); }

void FramesPage::showDatagrams(const NetworkConfig& config) {
  const auto frames = framesOf(config);
  RecordModel::Lines lines;
  if (frame() >= 0 && std::cmp_less(frame(), frames.size())) {
    for (const auto& cmd : frames[static_cast<std::size_t>(frame())]->commands) {
      lines.push_back({QString::fromStdString(address_text(cmd)), QString::number(cmd.length()),
                       cmd.expected_wkc ? QString::number(*cmd.expected_wkc) : noText(),
                       QString::fromStdString(states_text(cmd.states)), QString::fromStdString(cmd.comment)});
    }
  }
  datagrams_->setLines(lines);
  fitSome(*datagram_table_);
}

void FramesPage::showCost(const ImageReport& report) {
  RecordModel::Lines slaves, movable;
  for (const auto& one : report.slaves) {
    if (one.bytes == 0) continue;
    slaves.push_back({nodeName(project(), static_cast<int>(one.slave)), QString::number(one.output_bytes),
                      QString::number(one.input_bytes), QString::number(one.bytes), timeText(one.wire_time)});
  }
  for (const auto& one : report.movable) {
    if (one.saved_bytes == 0) continue;
    const auto object =
        QStringLiteral("%1:%2 %3")
            .arg(hexText(one.index, 4), hexText(one.sub_index, 2).sliced(2), QString::fromStdString(one.object));
    movable.push_back({nodeName(project(), static_cast<int>(one.slave)), object, hexText(one.pdo, 4),
                       bitsText(one.bits),
                       QStringLiteral("%1, %2").arg(bitsText(8 * one.saved_bytes), timeText(one.saved_wire_time))});
  }
  slaves_->setLines(slaves);
  movable_->setLines(movable);
}

}  // namespace syncline::ui
