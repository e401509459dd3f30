// SPDX-License-Identifier: Apache-2.0
#include <signal.h>

#include <QApplication>
#include <QScreen>
#include <QSettings>
#include <QSocketNotifier>
#include <QStandardPaths>
#include <QStyle>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <string_view>

#include "app/gui/bus_functions.h"
#include "app/gui/fault_pictures.h"
#include "app/gui/options.h"
#include "app/gui/recording_picture.h"
#include "app/gui/screenshots.h"
#include "engine/eeprom_journal.h"
#include "engine/slave_eeprom.h"
#include "link/pcap_link.h"
#include "master/sii/sii_writer.h"
#include "reasons/because.h"
#include "support/memory_reserve.h"
#include "support/standard_streams.h"
#include "support/state_folder.h"
#include "support/stop_signals.h"
#include "ui/dialogs/bus_commands.h"
#include "ui/dialogs/file_commands.h"
#include "ui/main_window.h"
#include "ui/session/workspace.h"
#include "ui/text/translations.h"
#include "ui/theme/theme.h"
#include "ui/window_layout.h"
#include "ui/window_overlay.h"

namespace {

using namespace syncline;

constexpr int kRememberEveryMs = 5'000;
const QString kThemeSetting = QStringLiteral("theme"), kExpertSetting = QStringLiteral("expert");

/// A slave whose EEPROM is half written may not come up at its next power-on.
ui::EepromRepairs eeprom_repairs() {
  ui::EepromRepairs repairs;
  repairs.pending = [] {
    std::vector<ui::CutShortWrite> writes;
    for (const auto& journal : pending_journals()) {
      writes.push_back({QString::fromStdString(journal.link), journal.position, QString::fromStdString(journal.begun)});
    }
    return writes;
  };
  repairs.end = [](const ui::CutShortWrite& write, bool undo, const std::atomic<bool>& cancel) -> Status {
    const auto report = finish_eeprom({write.link.toStdString(), static_cast<std::uint16_t>(write.position),
                                       [](const std::string& link) { return open_link(link); }, &cancel},
                                      undo);
    return report ? Status{} : Status(tl::unexpected(report.error()));
  };
  repairs.keep = [](const QString& link, int position, const std::vector<std::uint8_t>& before,
                    const std::vector<std::uint8_t>& after) -> Status {
    const auto slave = static_cast<std::uint16_t>(position);
    if (find_journal(link.toStdString(), slave)) {
      return fail(ErrorCode::kSii, "slave " + std::to_string(position),
                  because("a write of it was cut short; go offline and end that first"));
    }
    return keep_journal({link.toStdString(), slave, {}, before, after});
  };
  repairs.drop = [](const QString& link, int position) {
    drop_journal(link.toStdString(), static_cast<std::uint16_t>(position));
  };
  return repairs;
}

Result<std::vector<ui::NetworkAdapter>> adapters() {
  const auto found = list_adapters();
  if (!found) return tl::unexpected(found.error());
  std::vector<ui::NetworkAdapter> out;
  for (const auto& adapter : *found) {
    out.push_back({QString::fromStdString(adapter.name), QString::fromStdString(adapter.driver), adapter.up});
  }
  return out;
}

ui::Environment environment() {
  ui::Environment environment;
  connect_buses(environment);
  environment.list_adapters = adapters;
  environment.eeprom_repairs = eeprom_repairs();
  environment.recovery_folder = QString::fromStdString(state_folder("unsaved"));
  environment.templates_folder =
      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/templates");
  environment.version = QStringLiteral(SYNCLINE_VERSION);
  return environment;
}

/// What a handler throws must not tear the program down while slaves drive: the loop ends, and the end is the ordinary
/// one.
class Application final : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override {
    try {
      return QApplication::notify(receiver, event);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "syncline: this should not have happened: %s\n", error.what());
    } catch (...) {
      std::fputs("syncline: this should not have happened\n", stderr);
    }
    QApplication::exit(1);
    return false;
  }
};

/// What is answered in the terminal needs no display.
bool only_asks(int argc, char* argv[]) {
  return std::any_of(argv + 1, argv + argc, [](std::string_view argument) {
    return argument == "-h" || argument == "--help" || argument == "--help-all" || argument == "-v" ||
           argument == "--version";
  });
}

/// A picture is the same with and without a display: it is drawn on none.
bool draws_a_picture(int argc, char* argv[]) {
  return std::any_of(argv + 1, argv + argc, [](std::string_view argument) {
    return argument == "--picture" || argument.starts_with("--picture=");
  });
}

/// The platform without a display has no size hints and says so for every widget, and a service has no folder of a
/// session, which a picture does not need.
void without_chatter(QtMsgType, const QMessageLogContext&, const QString& text) {
  for (const char* chatter : {"propagateSizeHints", "XDG_RUNTIME_DIR"}) {
    if (text.contains(QLatin1String(chatter))) return;
  }
  std::fprintf(stderr, "%s\n", qUtf8Printable(text));
}

void begin(const Options& options, ui::MainWindow& window, ui::Workspace& workspace) {
  if (!options.link.isEmpty()) workspace.setLink(options.link);
  window.bus().offerRepairs();
  window.files().offerRecovery(
      [options, &window, &workspace] {
        if (!options.overlay.isEmpty()) {
          QObject::connect(
              &workspace.recording(), &ui::OpenedRecording::changed, &window,
              [options, &window] { window.overlay().open(options.overlay); },
              Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
        }
        if (!options.file.isEmpty()) window.files().openAny(options.file);
        if (!options.demo) return;
        window.bus().startDemo(options.link.isEmpty() ? workspace.environment().demo_link : options.link);
      },
      options.file);
}

/// Where the usual size does not fit, its frame neither, the window takes the whole screen.
void show(ui::MainWindow& window) {
  const auto room = window.screen()->availableSize();
  const int frame = window.style()->pixelMetric(QStyle::PM_TitleBarHeight);
  if (window.width() > room.width() || window.height() + frame > room.height()) return window.showMaximized();
  window.show();
}

/// The window in the language that was chosen, in the place and with the looks of the one before; what runs goes on.
std::unique_ptr<ui::MainWindow> inItsLanguage(std::unique_ptr<ui::MainWindow> before, ui::Workspace& workspace) {
  before->panels().remember();
  const auto place = before->place();
  ui::installTranslation(workspace.memory().value(ui::kLanguageSetting).toString());
  auto window = std::make_unique<ui::MainWindow>(workspace);
  show(*window);
  window->goToPlace(place);
  return window;  // the one before goes now: without any window the program would end
}

}  // namespace

int main(int argc, char* argv[]) {
  syncline::take_closed_streams();
  syncline::hold_memory_reserve();
  ::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of that file
  if (only_asks(argc, argv)) {
    const QCoreApplication text(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("syncline"));
    QCoreApplication::setApplicationVersion(QStringLiteral(SYNCLINE_VERSION));
    static_cast<void>(parse_options(text));  // prints and ends
  }
  const bool draws = draws_a_picture(argc, argv);
  if (draws) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler(without_chatter);
  }
  Application app(argc, argv);
  QApplication::setApplicationName(QStringLiteral("syncline"));
  QApplication::setOrganizationName(QStringLiteral("syncline"));
  QApplication::setApplicationVersion(QStringLiteral(SYNCLINE_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("org.syncline.Syncline"));
  const auto options = parse_options(app);
  if (draws) {
    ui::installTranslation(options.language);
    ui::theme::apply(ui::theme::Mode::kLight);
    return writePictureOf(options.picture);
  }
  QSettings settings(QSettings::IniFormat, QSettings::UserScope, QApplication::organizationName(),
                     QApplication::applicationName());
  if (options.reset_settings) {
    settings.clear();
    settings.sync();
  }
  // Pictures are the same on every machine.
  const bool own = options.language.isEmpty() && options.screenshots.isEmpty();
  ui::installTranslation(own ? settings.value(ui::kLanguageSetting).toString() : options.language);
  ui::theme::apply(
      ui::theme::modeFromName(options.theme.isEmpty() ? settings.value(kThemeSetting).toString() : options.theme));
  auto surroundings = environment();
  if (options.screenshots.isEmpty()) {
    surroundings.settings_file = settings.fileName();
  } else {
    surroundings.recovery_folder.clear();  // its edits are nobody's work
    surroundings.templates_folder.clear();
  }
  ui::Workspace workspace(std::move(surroundings));
  auto window = std::make_unique<ui::MainWindow>(workspace);
  if (options.screenshots.isEmpty()) workspace.setExpert(settings.value(kExpertSetting).toBool());
  if (!options.screenshots.isEmpty()) {
    window->show();
    if (!options.faults.isEmpty())
      return renderFaultPictures(*window, workspace, options.faults, options.screenshots) ? 0 : 1;
    return renderScreenshots(*window, workspace, workspace.environment().demo_link, options.screenshots) ? 0 : 1;
  }
  const std::function<void()> hear_of_language = [&] {
    const auto speak_anew = [&] {
      window = inItsLanguage(std::move(window), workspace);
      hear_of_language();
    };
    QObject::connect(window.get(), &ui::MainWindow::languageChosen, &app, speak_anew, Qt::QueuedConnection);
  };
  hear_of_language();
  show(*window);
  // Asks nothing: who closes the terminal or shuts the machine down does not answer. The slaves go to INIT all the
  // same.
  const StopSignals stop;
  QSocketNotifier asked_to_end(stop.descriptor(), QSocketNotifier::Read);
  QObject::connect(&asked_to_end, &QSocketNotifier::activated, &app, [&] {
    asked_to_end.setEnabled(false);
    workspace.scan().cancel();
    QApplication::exit(0);
  });
  QTimer::singleShot(0, window.get(), [&] { begin(options, *window, workspace); });
  if (options.exit_after_ms > 0)
    QTimer::singleShot(options.exit_after_ms, &app, [] { QApplication::exit(0); });  // asks nothing, unlike quit()
  // A program that is killed has been left as it looked a moment ago.
  const auto remember = [&] {
    auto& memory = workspace.memory();
    if (options.theme.isEmpty()) memory.setValue(kThemeSetting, ui::theme::modeName(ui::theme::current()));
    memory.setValue(kExpertSetting, workspace.expert());
    window->panels().remember();
  };
  QTimer now_and_then;
  QObject::connect(&now_and_then, &QTimer::timeout, &app, remember);
  now_and_then.start(kRememberEveryMs);
  const int result = QApplication::exec();
  remember();
  workspace.runs().shutDown();
  return result;
}
