// SPDX-License-Identifier: Apache-2.0
#include "ui/session/scan_controller.h"

#include <utility>

#include "eni/catalogue/esi_catalogue.h"
#include "eni/catalogue/usual_sources.h"
#include "eni/xml/file_warning.h"
#include "findings/error_text.h"
#include "ui/session/post.h"

namespace syncline::ui {

ScanController::ScanController(BusScanner scanner, SlaveDescriber describe, QStringList esi_folders, QObject* parent)
    : QObject(parent),
      scanner_(std::move(scanner)),
      describe_(std::move(describe)),
      esi_folders_(std::move(esi_folders)) {}

ScanController::~ScanController() {
  cancel();
  if (worker_.joinable()) worker_.join();
}

void ScanController::start(const QString& link, Depth depth) {
  if (running_) return;
  if (worker_.joinable()) worker_.join();
  running_ = true;
  cancelled_ = false;
  Q_EMIT started(link);
  worker_ = std::thread([this, link, depth] {
    auto result = run(link, depth);
    post(*this, [this, link, result = std::move(result)]() mutable { deliver(link, std::move(result)); });
  });
}

void ScanController::cancel() { cancelled_ = true; }

Result<ScanOutcome> ScanController::run(const QString& link, Depth depth) {
  const auto told = [this](const Event& event) { tell(event); };
  auto found = scanner_(link, depth == Depth::kLookFirst, cancelled_, told);
  if (found && found->look_only && found->running == 0 && !cancelled_) found = scanner_(link, false, cancelled_, told);
  if (!found) return tl::unexpected(found.error());
  if (cancelled_) return fail(ErrorCode::kCancelled);
  auto catalogue = eni::EsiCatalogue::open_default();  // reads only what changed since the last scan
  std::vector<std::string> folders;
  for (const auto& folder : esi_folders_) folders.push_back(folder.toStdString());
  const auto warnings = eni::add_usual_sources(catalogue, std::move(folders));
  // Slaves without an ESI tell what they are, when they may be led to PREOP.
  eni::SlaveDescriber describe;
  if (describe_ && !found->look_only) describe = [&](Project& project) { return describe_(project, link, cancelled_); };
  auto built = eni::project_from_scan(*found, catalogue, describe);
  if (!built) return tl::unexpected(built.error());
  std::vector<Finding> unusable;
  for (const auto& error : warnings) unusable.push_back(finding_of(error));
  built->warnings.insert(built->warnings.begin(), unusable.begin(), unusable.end());
  if (cancelled_) return fail(ErrorCode::kCancelled);
  return ScanOutcome{std::move(*built), found->look_only, found->running};
}

/// In the scan's thread.
void ScanController::tell(const Event& event) {
  if (const auto* now = event.as<events::ScanProgress>()) {
    const auto done = static_cast<int>(now->done), all = static_cast<int>(now->found);
    post(*this, [this, done, all] { Q_EMIT progress(done, all); });
  } else {
    post(*this, [this, event] { Q_EMIT eventArrived(event); });
  }
}

void ScanController::deliver(const QString& link, Result<ScanOutcome> result) {
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
