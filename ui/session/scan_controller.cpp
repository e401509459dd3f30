// SPDX-License-Identifier: Apache-2.0
#include "ui/session/scan_controller.h"

#include <QMetaObject>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "eni/catalogue/esi_catalogue.h"

namespace syncline::ui {

ScanController::ScanController(MasterOpener opener, SlaveDescriber describe, QStringList esi_folders, QObject* parent)
    : QObject(parent), opener_(std::move(opener)), describe_(std::move(describe)), esi_folders_(std::move(esi_folders)) {}

ScanController::~ScanController() {
  cancel();
  if (worker_.joinable()) worker_.join();
}

void ScanController::start(const QString& link) {
  if (running_) return;
  if (worker_.joinable()) worker_.join();
  running_ = true;
  cancelled_ = false;
  Q_EMIT started(link);
  worker_ = std::thread([this, link] {
    auto result = run(link);
    QMetaObject::invokeMethod(
        this, [this, link, result = std::move(result)]() mutable { deliver(link, std::move(result)); },
        Qt::QueuedConnection);
  });
}

void ScanController::cancel() { cancelled_ = true; }

Result<eni::BuiltProject> ScanController::run(const QString& link) {
  const auto found = scan(link);
  if (!found) return tl::unexpected(found.error());
  if (cancelled_) return fail(ErrorCode::kCancelled);
  auto catalogue = eni::EsiCatalogue::open_default();  // reads only what changed since the last scan
  std::vector<Error> warnings;
  for (const auto& folder : esi_folders_) {
    if (auto status = catalogue.add_folder(folder.toStdString()); !status) warnings.push_back(status.error());
  }
  auto built = eni::project_from_scan(*found, catalogue);
  built.warnings.insert(built.warnings.begin(), warnings.begin(), warnings.end());
  // Slaves without an ESI tell what they are.
  if (describe_) {
    if (auto status = describe_(built, link, cancelled_); !status) return tl::unexpected(status.error());
  }
  if (cancelled_) return fail(ErrorCode::kCancelled);
  return built;
}

Result<BusScan> ScanController::scan(const QString& link) {
  const auto master = opener_(link);
  if (!master) return tl::unexpected(master.error());
  auto& channels = (*master)->channels();
  // The scan runs to its end inside step(); its own thread watches it, passes the progress on and
  // carries the user's cancel.
  std::optional<Result<BusScan>> outcome;
  const auto look = [&] {
    if (cancelled_) channels.cancel = true;
    for (const auto& event : channels.events.drain()) {
      if (const auto* now = event.as<events::ScanProgress>()) {
        const auto done = static_cast<int>(now->done), all = static_cast<int>(now->found);
        QMetaObject::invokeMethod(this, [this, done, all] { Q_EMIT progress(done, all); }, Qt::QueuedConnection);
      } else if (const auto* end = event.as<events::ScanFinished>()) {
        outcome = *end->scan;
      } else if (event.is<events::ScanTouchesRunning>()) {
        QMetaObject::invokeMethod(this, [this, event] { Q_EMIT eventArrived(event); }, Qt::QueuedConnection);
      } else if (const auto* failure = event.as<events::Failure>()) {
        outcome = tl::unexpected(failure->error);
      }
    }
  };
  channels.commands.push(ScanCommand{});
  std::atomic<bool> done{false};
  std::thread runner([&] {
    (*master)->step();
    done = true;
  });
  while (!done) {
    look();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  runner.join();
  look();
  if (outcome) return *outcome;
  return fail(cancelled_ ? ErrorCode::kCancelled : ErrorCode::kNoResponse, link.toStdString());
}

void ScanController::deliver(const QString& link, Result<eni::BuiltProject> result) {
  if (worker_.joinable()) worker_.join();
  running_ = false;
  if (cancelled_) {
    Q_EMIT failed(link, Error{ErrorCode::kCancelled});
  } else if (result) {
    Q_EMIT finished(link, *result);
  } else {
    Q_EMIT failed(link, result.error());
  }
}

}  // namespace syncline::ui
