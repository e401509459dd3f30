// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QStringList>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "eni/catalogue/catalogue_entry.h"
#include "eni/xml/file_warning.h"
#include "support/result.h"

namespace syncline {
struct DeviceDescription;
}  // namespace syncline

namespace syncline::eni {
class EsiCatalogue;
}

namespace syncline::ui {

/// An answer of the catalogue.
struct CatalogueAnswer {
  eni::CatalogueSearch search;
  std::vector<eni::CatalogueEntry> entries;
  std::size_t devices = 0;  // that there are in all
  bool more = false;        // than `entries`
};

/// The catalogue of ESI files in a thread of its own; answers come in the window's thread. It begins to read when
/// somebody asks for the first time.
class DeviceCatalogue final : public QObject {
  Q_OBJECT

 public:
  /// `folders`: beside those that the user had it remember.
  explicit DeviceCatalogue(QStringList folders, QObject* parent = nullptr);
  ~DeviceCatalogue() override;

  /// Who asks again before the answer came gets that of the last question alone.
  void search(const eni::CatalogueSearch& search, QObject* context,
              std::function<void(const Result<CatalogueAnswer>&)> then);
  /// Folders and files; remembered for later starts. progress(), failed() for
  /// those that cannot be read, warned() of what they have wrong, then added().
  void add(const QStringList& paths);
  /// Ends reading folders; what was read is kept, the rest is read at the next start.
  void cancel() { cancelled_ = true; }
  /// The whole description, from its file; `then` is called unless `context` is gone.
  void read(const eni::CatalogueEntry& entry, QObject* context,
            std::function<void(const Result<DeviceDescription>&)> then);
  /// The descriptions of those that the catalogue has in exactly that revision.
  void devices(std::vector<Identity> identities, QObject* context,
               std::function<void(const std::vector<DeviceDescription>&)> then);
  /// All revisions of a product, newest first.
  void revisions(const Identity& identity, QObject* context,
                 std::function<void(const Result<std::vector<eni::CatalogueEntry>>&)> then);

 Q_SIGNALS:
  void progress(int done, int files, const QString& file);
  /// Reading ended; `devices` are new.
  void added(int devices, bool cancelled);
  /// A folder that could not be read.
  void failed(const syncline::Error& error);
  /// A file that could not be read, and what was left out of it or tolerated in it.
  void warned(const syncline::eni::FileWarning& warning);
  /// What became of the index: it was made again, or nothing is kept.
  void noted(const syncline::eni::FileWarning& note);

 private:
  using Job = std::function<void(eni::EsiCatalogue&)>;
  using LastQuestion = std::shared_ptr<std::atomic<std::uint64_t>>;
  void ask(Job job);
  void run();
  void open(eni::EsiCatalogue& catalogue);
  void addNow(eni::EsiCatalogue& catalogue, const QStringList& paths);
  void tellProblems(const eni::EsiCatalogue& catalogue, const QStringList& below);
  bool tellProgress(const eni::IndexProgress& progress);
  [[nodiscard]] LastQuestion lastQuestionOf(QObject* asker);

  QStringList folders_;
  std::thread worker_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Job> jobs_;
  bool ending_ = false;
  std::atomic<bool> cancelled_ = false;
  std::map<QObject*, LastQuestion> last_questions_;
};

}  // namespace syncline::ui
