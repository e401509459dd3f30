// SPDX-License-Identifier: Apache-2.0
#include "app/gui/screenshots.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QPixmap>
#include <QPushButton>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTextStream>
#include <QTreeView>
#include <algorithm>
#include <functional>
#include <utility>

#include "app/gui/picture_run.h"
#include "settings/settings_table.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/dialogs/bus_commands.h"
#include "ui/dialogs/commissioning_dialog.h"
#include "ui/dialogs/compare_dialog.h"
#include "ui/dialogs/found_dialog.h"
#include "ui/dialogs/link_chooser.h"
#include "ui/dialogs/memory_dialog.h"
#include "ui/dialogs/opening_picture.h"
#include "ui/dialogs/reading_progress.h"
#include "ui/dialogs/recording_commands.h"
#include "ui/dialogs/recovery_dialog.h"
#include "ui/machine_building.h"
#include "ui/main_window.h"
#include "ui/pages/device_editor.h"
#include "ui/panels/cycle_view.h"
#include "ui/panels/explorer_panel.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/mask_chooser.h"
#include "ui/panels/slaves_view.h"
#include "ui/panels/stability_view.h"
#include "ui/plots/bathtub_plot.h"
#include "ui/plots/cycle_plot.h"
#include "ui/session/first_pictures.h"
#include "ui/session/workspace.h"
#include "ui/text/link_text.h"
#include "ui/theme/theme.h"
#include "ui/wizard/machine_draft.h"
#include "ui/wizard/new_machine_wizard.h"

namespace syncline {
namespace {

constexpr Nanoseconds kMachineTime = 12 * kSecond;
constexpr int kMostReadingTicks = 600;  // of 50 ms of the machine

/// Names pages like "light-slave3-process-data.png" and counts what could not be written.
class Camera {
 public:
  explicit Camera(const QDir& folder) : folder_(folder) {}
  void take(QWidget& widget, const QString& name) {
    for (int round = 0; round < 3; ++round) QApplication::processEvents();  // layouts ask for another one
    if (!widget.grab().save(folder_.filePath(name + QStringLiteral(".png")))) ++failures_;
    ++taken_;
  }
  [[nodiscard]] int failures() const { return failures_; }
  [[nodiscard]] int taken() const { return taken_; }

 private:
  QDir folder_;
  int failures_ = 0, taken_ = 0;
};

QString fileName(const QString& theme, int slave, const QWidget& page) {
  const auto node = slave < 0 ? QStringLiteral("master") : QStringLiteral("slave%1").arg(slave);
  return QStringLiteral("%1-%2-%3").arg(theme, node, page.objectName());
}

/// The first that tells of itself: by objects, registers and EEPROM.
int talkativeSlave(const Project& project) {
  const auto& slaves = project.slaves;
  const auto found = std::ranges::find_if(
      slaves, [](const SlaveSettings& slave) { return slave.device.mailbox && slave.device.mailbox->coe; });
  return found == slaves.end() ? -1 : static_cast<int>(found - slaves.begin());
}

/// Lets the page in front read what it can read.
void fill(QWidget& page, ui::Workspace& workspace) {
  const auto press = [&page](const char* name) {
    auto* button = page.findChild<QPushButton*>(QLatin1String(name));
    if (button != nullptr) button->click();
    return button != nullptr;
  };
  const auto run = [&](const std::function<bool()>& done) {
    for (int i = 0; i < kMostReadingTicks && !done(); ++i) {
      workspace.live().advance(50 * kMillisecond);
      QApplication::processEvents();
    }
  };
  if (auto* source = page.findChild<QComboBox*>(QStringLiteral("objectSource"))) {
    const auto* stop = page.findChild<QPushButton*>(QStringLiteral("objectStop"));
    const auto idle = [stop] { return !stop->isVisible(); };
    source->setCurrentIndex(1);
    Q_EMIT source->activated(1);
    run(idle);
    press("objectReadShown");
    run(idle);
  }
  if (press("registerRead")) run([ticks = 20]() mutable { return --ticks < 0; });
  if (press("eepromRead"))
    run([save = page.findChild<QPushButton*>(QStringLiteral("eepromSave"))] { return save->isEnabled(); });
}

void takePages(Camera& camera, ui::MainWindow& window, ui::Workspace& workspace, const QString& theme) {
  const auto slaves = static_cast<int>(workspace.document().project().slaves.size());
  const int talkative = talkativeSlave(workspace.document().project());
  for (int slave = -1; slave < slaves; ++slave) {
    window.selectNode(slave);
    auto* tabs = window.editor().tabs();
    for (int tab = 0; tab < tabs->count(); ++tab) {
      tabs->setCurrentIndex(tab);
      static_cast<void>(waitUntil([&workspace] { return !workspace.eni().isComputing(); }));
      workspace.live().advance(50 * kMillisecond);
      if (slave == talkative) fill(*tabs->widget(tab), workspace);
      window.findChild<ui::LiveStrip*>()->refresh();  // its own tick has had no time to pass
      camera.take(window, fileName(theme, slave, *tabs->widget(tab)));
    }
  }
}

/// A machine that is one slave short, one too many and one in another revision.
ui::ScanOutcome otherBus(const Project& project) {
  ui::ScanOutcome outcome;
  outcome.built.project = project;
  auto& slaves = outcome.built.project.slaves;
  if (slaves.size() < 4) return outcome;
  slaves[3].device.identity.revision_no += 0x10000;
  slaves.erase(slaves.begin() + 2);
  slaves.push_back(slaves[1]);
  for (std::size_t i = 1; i < slaves.size(); ++i)
    slaves[i].previous = PreviousPort{static_cast<std::uint16_t>(i - 1), 1};
  return outcome;
}

/// What asks and compares, with the bar above the pages.
void takeQuestions(Camera& camera, ui::MainWindow& window, ui::Workspace& workspace, const QString& theme) {
  const auto bus = ui::linkName(workspace.link(), workspace.environment().demo_link);
  ui::FoundDialog found(workspace.document().project(), otherBus(workspace.document().project()), bus, &window);
  found.show();
  camera.take(found, theme + QStringLiteral("-scan-result"));
  const ui::KeptWork work{QStringLiteral("/home/user/press.syncline"), QDateTime::currentDateTime(),
                          QStringLiteral("SYNC0"), 9};
  ui::RecoveryDialog recovery(workspace.autosave(), {{{}, work}}, &window);
  recovery.show();
  camera.take(recovery, theme + QStringLiteral("-recovery"));
  const ui::SettingEdit cycle{&settings::row("master.cycle_time_us"), {}, settings::Value{2 * kMillisecond}};
  const ui::SettingEdit gain{&settings::row("master.dc.gain_ppt"), {}, settings::Value{std::int64_t{5}}};
  static_cast<void>(workspace.document().set({}, {cycle, gain}));
  static_cast<void>(workspace.configuration().current());
  camera.take(window, theme + QStringLiteral("-run-bar"));
  ui::CompareDialog difference(workspace, &window);
  difference.compare({ui::ComparedSide::Kind::kRunning}, {ui::ComparedSide::Kind::kProject});
  difference.show();
  static_cast<void>(waitUntil([&difference] { return !difference.isComparing(); }));
  camera.take(difference, theme + QStringLiteral("-differences"));
  workspace.document().undoStack().undo();
}

/// What stands in place of the plots, in the usual and in the smallest window. `ready`: all of it is there; it is
/// refreshed until then.
void takeBody(Camera& camera, ui::MainWindow& window, ui::LiveStrip::Body body, const QString& name,
              const std::function<bool()>& ready) {
  auto* strip = window.findChild<ui::LiveStrip*>();
  strip->showBody(body);
  const auto usual = window.size();
  for (const auto& [size, end] : {std::pair{usual, ""}, {QSize(1024, 640), "-small"}}) {
    window.resize(size);
    QApplication::processEvents();
    static_cast<void>(waitUntil([&] {
      strip->refresh();
      return ready();
    }));
    camera.take(window, name + QLatin1String(end));
  }
  window.resize(usual);
  strip->showBody(ui::LiveStrip::Body::kPlots);
}

void takeBodies(Camera& camera, ui::MainWindow& window, const QString& theme) {
  using Body = ui::LiveStrip::Body;
  const auto* strip = window.findChild<ui::LiveStrip*>();
  takeBody(camera, window, Body::kDistribution, theme + QStringLiteral("-distribution"), [] { return true; });
  takeBody(camera, window, Body::kSlaves, theme + QStringLiteral("-slaves"),
           [strip] { return strip->slaves()->complete(); });
  takeBody(camera, window, Body::kCycle, theme + QStringLiteral("-cycle"),
           [strip] { return strip->cycle()->plot()->picture().figures.count > 0; });
  strip->cycle()->setFigure(ui::CycleView::Figure::kBathtub);
  takeBody(camera, window, Body::kCycle, theme + QStringLiteral("-bathtub"),
           [strip] { return strip->cycle()->bathtub()->picture().bathtub.count > 0; });
  strip->cycle()->setFigure(ui::CycleView::Figure::kArrivals);
  takeBody(camera, window, Body::kFree, theme + QStringLiteral("-own-plots"), [] { return true; });
}

/// Each figure in place of the plots, and one of them in the smallest window.
void takeStability(Camera& camera, ui::MainWindow& window, const QString& theme) {
  using Figure = ui::StabilityView::Figure;
  auto* strip = window.findChild<ui::LiveStrip*>();
  auto* view = strip->stability();
  const auto usual = window.size();
  const auto take = [&](Figure figure, const char* name) {
    view->setFigure(figure);
    static_cast<void>(waitUntil([strip, view] {
      strip->refresh();
      return view->complete();
    }));
    camera.take(window, theme + QLatin1String(name));
  };
  strip->showBody(ui::LiveStrip::Body::kStability);
  take(Figure::kAdev, "-stability-adev");
  take(Figure::kTdev, "-stability-tdev");
  take(Figure::kMtie, "-stability-mtie");
  take(Figure::kSpectrum, "-stability-spectrum");
  view->mask()->setKind(ui::MaskChooser::Kind::kOwn);
  view->mask()->setOwn(QStringLiteral("5ms 20ns; 1s 60ns"));
  take(Figure::kMtie, "-stability-mask");
  view->mask()->setKind(ui::MaskChooser::Kind::kLimit);
  window.resize(1024, 640);
  QApplication::processEvents();
  take(Figure::kMtie, "-stability-small");
  window.resize(usual);
  strip->showBody(ui::LiveStrip::Body::kPlots);
}

/// What is seen of a long recording while its samples are read.
void takeOpening(Camera& camera, ui::MainWindow& window, const QString& path, const QString& theme) {
  auto reader = RecordingReader::open(path.toStdString());
  const auto info = reader ? reader->info() : tl::unexpected(reader.error());
  if (!info) return;
  auto* picture = new ui::OpeningPicture({info->begin, info->end, info->cycles, info->about.limits});
  ui::FirstPictures pictures;
  QObject::connect(picture, &ui::OpeningPicture::wanted, picture, [&](const std::vector<ui::FirstPicture>& wanted) {
    pictures.ask(wanted);
    if (const auto made = pictures.answer(path.toStdString())) picture->take(*made);
  });
  ui::ReadingProgress progress(window);
  progress.begin(path, "openingProgress", QCoreApplication::translate("RecordingCommands", "Open Recording"), [] {});
  progress.show(picture);
  progress.set(400);
  for (int round = 0; round < 3; ++round) {  // its tick has had no time to pass; longer numbers leave fewer columns
    QApplication::processEvents();
    picture->refresh();
  }
  camera.take(*picture->window(), theme + QStringLiteral("-opening"));
  progress.end();
}

/// The last seconds of the machine out of memory, opened again, and in the middle of its replay.
void takeRecording(Camera& camera, ui::MainWindow& window, ui::Workspace& workspace) {
  const QTemporaryDir folder;
  const auto path = folder.filePath(QStringLiteral("machine.slrec"));
  bool saved = false;
  QObject::connect(&workspace.disk(), &ui::DiskRecording::saved, &window, [&saved] { saved = true; });
  if (!workspace.disk().saveLast(8 * kSecond, path) || !waitUntil([&saved] { return saved; })) return;
  workspace.live().shutDown();
  window.recordings().open(path);
  if (!waitUntil([&workspace] { return workspace.recording().isOpen(); })) return;
  for (const auto mode : {ui::theme::Mode::kLight, ui::theme::Mode::kDark}) {
    ui::theme::apply(mode);
    QApplication::processEvents();
    window.findChild<ui::LiveStrip*>()->refresh();
    camera.take(window, ui::theme::modeName(mode) + QStringLiteral("-recording"));
    takeOpening(camera, window, path, ui::theme::modeName(mode));
    auto& replay = workspace.replay();
    replay.seek(replay.begin() / 2 + replay.end() / 2);
    window.findChild<ui::LiveStrip*>()->refresh();
    camera.take(window, ui::theme::modeName(mode) + QStringLiteral("-replay"));
    replay.leave();
  }
  workspace.recording().close();
}

/// What a machine is built with: the drawn wiring and the catalogue.
void takeBuilding(Camera& camera, ui::MainWindow& window, const QString& theme) {
  window.explorer().setView(ui::ExplorerPanel::View::kTopology);
  auto* dock = window.building().dock();
  dock->show();
  auto* devices = dock->findChild<QTreeView*>(QStringLiteral("catalogueTree"));
  static_cast<void>(waitUntil([devices] { return devices->model()->rowCount() > 0; }));
  devices->expandAll();
  devices->setCurrentIndex(devices->model()->index(0, 0, devices->model()->index(0, 0, devices->model()->index(0, 0))));
  camera.take(window, theme + QStringLiteral("-topology-and-catalogue"));
  dock->hide();
  window.explorer().setView(ui::ExplorerPanel::View::kClassic);
}

/// Each step of a new machine out of the demonstration machine's slaves, and the trigger's panel.
void takeWizardAndTrigger(Camera& camera, ui::MainWindow& window, ui::Workspace& workspace, const QString& theme) {
  constexpr int kLastStep = 5;
  ui::NewMachineWizard wizard(workspace, &window);
  wizard.draft().scan(workspace.environment().demo_link + QStringLiteral("&seed=2"));
  static_cast<void>(waitUntil([&wizard] { return !wizard.draft().isScanning(); }));
  wizard.show();
  for (int last = -1; wizard.step() != last;) {
    last = wizard.step();
    auto& eni = wizard.draft().workspace().eni();
    static_cast<void>(waitUntil([&] { return last < kLastStep || (eni.isCurrent() && eni.check() != nullptr); }));
    camera.take(wizard, QStringLiteral("%1-new-machine-%2").arg(theme).arg(last + 1));
    if (last < kLastStep) wizard.findChild<QPushButton*>(QStringLiteral("wizardNext"))->click();
  }
  window.findChild<ui::LiveStrip*>()->triggerWanted();
  camera.take(window, theme + QStringLiteral("-trigger"));
  window.findChild<QDockWidget*>(QStringLiteral("messagesDock"))->raise();
}

void takeDialogs(Camera& camera, ui::MainWindow& window, ui::Workspace& workspace, const QString& theme) {
  ui::AboutDialog about(workspace.environment().version, &window);
  about.show();
  camera.take(about, theme + QStringLiteral("-about"));
  ui::LinkChooser chooser(workspace.environment(), {}, ui::BusCommands::tr("Go Online"), &window);
  chooser.offerMachine(static_cast<int>(workspace.document().project().slaves.size()));
  chooser.show();
  camera.take(chooser, theme + QStringLiteral("-link-chooser"));
  ui::CommissioningDialog commissioning(workspace, &window);
  commissioning.show();
  camera.take(commissioning, theme + QStringLiteral("-commissioning"));
  ui::MemoryDialog memory(workspace, &window);
  memory.show();
  camera.take(memory, theme + QStringLiteral("-memory"));
}

}  // namespace

bool renderScreenshots(ui::MainWindow& window, ui::Workspace& workspace, const QString& link, const QString& folder) {
  QDir target(folder);
  QTextStream err(stderr);
  if (!target.mkpath(QStringLiteral("."))) {
    err << "cannot create " << folder << '\n';
    return false;
  }
  Camera camera(target);
  for (const auto mode : {ui::theme::Mode::kLight, ui::theme::Mode::kDark}) {
    ui::theme::apply(mode);
    camera.take(window, ui::theme::modeName(mode) + QStringLiteral("-welcome"));
  }
  const bool in_sync = runForPictures(window, workspace, link, kMachineTime) &&
                       workspace.live().snapshot().dc.state == SyncState::kInSync;
  for (const auto mode : {ui::theme::Mode::kLight, ui::theme::Mode::kDark}) {
    ui::theme::apply(mode);
    QApplication::processEvents();
    showOverview(window);
    camera.take(window, ui::theme::modeName(mode) + QStringLiteral("-overview"));
    takeBodies(camera, window, ui::theme::modeName(mode));
    takeStability(camera, window, ui::theme::modeName(mode));
    takePages(camera, window, workspace, ui::theme::modeName(mode));
    workspace.setExpert(true);
    takePages(camera, window, workspace, ui::theme::modeName(mode) + QStringLiteral("-expert"));
    workspace.setExpert(false);
    takeBuilding(camera, window, ui::theme::modeName(mode));
    takeDialogs(camera, window, workspace, ui::theme::modeName(mode));
    takeWizardAndTrigger(camera, window, workspace, ui::theme::modeName(mode));
    takeQuestions(camera, window, workspace, ui::theme::modeName(mode));
  }
  takeRecording(camera, window, workspace);
  workspace.live().shutDown();
  if (!in_sync) err << "the demonstration machine did not get in sync\n";
  if (camera.failures() > 0) err << camera.failures() << " pictures could not be written to " << folder << '\n';
  QTextStream(stdout) << camera.taken() << " pictures in " << folder << '\n';
  return in_sync && camera.failures() == 0;
}

}  // namespace syncline
