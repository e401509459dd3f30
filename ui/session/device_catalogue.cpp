// SPDX-License-Identifier: Apache-2.0
#include "ui/session/device_catalogue.h"

#include <QFileInfo>
#include <QPointer>
#include <algorithm>
#include <utility>

#include "config/device_description.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/catalogue/usual_sources.h"
#include "ui/session/post.h"

namespace syncline::ui {
namespace {

std::vector<std::string> pathsOf(const QStringList& list) {
  std::vector<std::string> paths;
  for (const auto& one : list) paths.push_back(one.toStdString());
  return paths;
}

}  // namespace

DeviceCatalogue::DeviceCatalogue(QStringList folders, QObject* parent)
    : QObject(parent), folders_(std::move(folders)) {}

DeviceCatalogue::~DeviceCatalogue() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    jobs_.clear();
  }
  cancelled_ = true;
  wake_.notify_one();
  if (worker_.joinable()) worker_.join();
  for (const auto& [asker, last] : last_questions_) disconnect(asker, nullptr, this, nullptr);
}

void DeviceCatalogue::ask(Job job) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  if (!worker_.joinable()) {
    cancelled_ = false;
    worker_ = std::thread([this] { run(); });
  }
  wake_.notify_one();
}

/// In the worker, as all that takes a catalogue.
void DeviceCatalogue::run() {
  auto catalogue = eni::EsiCatalogue::open_default();
  open(catalogue);
  while (true) {
    Job job;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return ending_ || !jobs_.empty(); });
      if (ending_) return;
      job = std::move(jobs_.front());
      jobs_.pop_front();
    }
    job(catalogue);
  }
}

bool DeviceCatalogue::tellProgress(const eni::IndexProgress& now) {
  const auto done = static_cast<int>(now.files_done), files = static_cast<int>(now.files);
  post(*this, [this, done, files, file = QString::fromStdString(now.file)] { Q_EMIT progress(done, files, file); });
  return !cancelled_;
}

void DeviceCatalogue::open(eni::EsiCatalogue& catalogue) {
  const auto errors = eni::add_usual_sources(catalogue, pathsOf(folders_),
                                             [this](const eni::IndexProgress& now) { return tellProgress(now); });
  for (const auto& error : errors) post(*this, [this, error] { Q_EMIT failed(error); });
  for (const auto& note : catalogue.notes()) post(*this, [this, note] { Q_EMIT noted(note); });
  const bool cancelled = cancelled_;
  post(*this, [this, cancelled] { Q_EMIT added(0, cancelled); });
}

void DeviceCatalogue::add(const QStringList& paths) {
  cancelled_ = false;
  ask([this, paths](eni::EsiCatalogue& catalogue) { addNow(catalogue, paths); });
}

void DeviceCatalogue::addNow(eni::EsiCatalogue& catalogue, const QStringList& paths) {
  const auto before = catalogue.device_count();
  for (const auto& path : pathsOf(paths)) {
    const auto report =
        eni::add_source(catalogue, path, [this](const eni::IndexProgress& now) { return tellProgress(now); });
    // What was read before somebody had enough is found at later starts, too, where the folder is looked into again.
    const auto kept = report ? catalogue.remember_folder(path) : Status(tl::unexpected(report.error()));
    if (!kept) post(*this, [this, error = kept.error()] { Q_EMIT failed(error); });
    for (const auto& error : report ? eni::unreadable_folders(*report) : std::vector<Error>{})
      post(*this, [this, error] { Q_EMIT failed(error); });
    if (cancelled_) break;
  }
  tellProblems(catalogue, paths);
  const auto devices = catalogue.device_count();
  const auto fresh = static_cast<int>(devices - std::min(before, devices));
  const bool cancelled = cancelled_;
  post(*this, [this, fresh, cancelled] { Q_EMIT added(fresh, cancelled); });
}

/// What the files that were just added have wrong.
void DeviceCatalogue::tellProblems(const eni::EsiCatalogue& catalogue, const QStringList& below) {
  for (const auto& warning : catalogue.warnings()) {
    const auto file = QString::fromStdString(warning.file);
    const bool ours = std::ranges::any_of(below, [&](const QString& path) {
      const auto canonical = QFileInfo(path).canonicalFilePath();
      return file == canonical || file.startsWith(canonical + u'/');
    });
    if (!ours) continue;
    post(*this, [this, warning] { Q_EMIT warned(warning); });
  }
}

DeviceCatalogue::LastQuestion DeviceCatalogue::lastQuestionOf(QObject* asker) {
  auto& last = last_questions_[asker];
  if (!last) {
    last = std::make_shared<std::atomic<std::uint64_t>>(0);
    connect(asker, &QObject::destroyed, this, [this, asker] { last_questions_.erase(asker); });
  }
  return last;
}

void DeviceCatalogue::search(const eni::CatalogueSearch& search, QObject* context,
                             std::function<void(const Result<CatalogueAnswer>&)> then) {
  const auto last = lastQuestionOf(context);
  const auto number = ++*last;
  ask([this, last, number, search, here = QPointer<QObject>(context),
       then = std::move(then)](eni::EsiCatalogue& catalogue) {
    if (number != *last) return;  // somebody types on
    auto wanted = search;
    ++wanted.limit;
    Result<CatalogueAnswer> answer = catalogue.search(wanted).map([&](std::vector<eni::CatalogueEntry> entries) {
      const bool more = entries.size() > search.limit;
      if (more) entries.resize(search.limit);
      return CatalogueAnswer{search, std::move(entries), catalogue.device_count(), more};
    });
    post(*this, [last, number, here, then, answer = std::move(answer)] {
      if (here && number == *last) then(answer);
    });
  });
}

void DeviceCatalogue::devices(std::vector<Identity> identities, QObject* context,
                              std::function<void(const std::vector<DeviceDescription>&)> then) {
  ask([this, identities = std::move(identities), here = QPointer<QObject>(context),
       then = std::move(then)](eni::EsiCatalogue& catalogue) {
    std::vector<DeviceDescription> found;
    for (const auto& identity : identities) {
      const auto match = catalogue.find(identity);
      if (match && match->exact_revision) found.push_back(*match->device);
    }
    post(*this, [here, then, found = std::move(found)] {
      if (here) then(found);
    });
  });
}

void DeviceCatalogue::read(const eni::CatalogueEntry& entry, QObject* context,
                           std::function<void(const Result<DeviceDescription>&)> then) {
  ask([this, entry, here = QPointer<QObject>(context), then = std::move(then)](eni::EsiCatalogue& catalogue) {
    const auto device = catalogue.device(entry);
    Result<DeviceDescription> copy = device ? Result<DeviceDescription>(**device) : tl::unexpected(device.error());
    post(*this, [here, then, copy = std::move(copy)] {
      if (here) then(copy);
    });
  });
}

void DeviceCatalogue::revisions(const Identity& identity, QObject* context,
                                std::function<void(const Result<std::vector<eni::CatalogueEntry>>&)> then) {
  ask([this, identity, here = QPointer<QObject>(context), then = std::move(then)](eni::EsiCatalogue& catalogue) {
    eni::CatalogueSearch search;
    search.vendor_id = identity.vendor_id;
    search.product_code = identity.product_code;
    search.all_revisions = true;
    search.with_hidden = true;
    search.limit = 500;
    const auto entries = catalogue.search(search);
    post(*this, [here, then, entries] {
      if (here) then(entries);
    });
  });
}

}  // namespace syncline::ui
