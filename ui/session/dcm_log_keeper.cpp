// SPDX-License-Identifier: Apache-2.0
#include "ui/session/dcm_log_keeper.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <condition_variable>
#include <mutex>
#include <string>
#include <utility>

#include "support/output_file.h"
#include "ui/session/network_run.h"
#include "ui/session/post.h"
#include "ui/session/run_file_name.h"

namespace syncline::ui {
namespace {

/// Beside the project; one that has no file has no folder either. No log is written over.
QString logPath(const QString& project, const QString& name) {
  const QDir folder(project.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                                      : QFileInfo(project).absolutePath());
  const auto base = folder.filePath(
      QStringLiteral("%1-dcmlog-%2")
          .arg(runFileName(name), QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HH-mm-ss"))));
  auto path = base + QStringLiteral(".csv");
  for (int i = 2; QFileInfo::exists(path); ++i) path = QStringLiteral("%1-%2.csv").arg(base).arg(i);
  return path;
}

}  // namespace

/// Takes text from the window's thread and writes it in another one; a slow disk delays nobody.
class DcmLogKeeper::Writer {
 public:
  explicit Writer(OutputFile file) : file_(std::move(file)), thread_([this] { run(); }) {}
  ~Writer() { end(); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void add(std::string_view text) {
    const std::scoped_lock lock(mutex_);
    pending_ += text;
    more_.notify_one();
  }
  /// Waits until all of it lies on the disk.
  Status end() {
    if (thread_.joinable()) {
      {
        const std::scoped_lock lock(mutex_);
        ended_ = true;
        more_.notify_one();
      }
      thread_.join();
    }
    return status_;
  }
  [[nodiscard]] QString path() const { return QString::fromStdString(file_.path()); }

 private:
  void run() {
    std::string text;
    for (bool last = false; !last;) {
      {
        std::unique_lock lock(mutex_);
        more_.wait(lock, [this] { return ended_ || !pending_.empty(); });
        last = ended_;
        text.clear();
        std::swap(text, pending_);
      }
      if (status_) status_ = file_.write(text);
      if (status_ && !last) status_ = file_.flush();
    }
    if (status_) status_ = file_.finish();
  }

  OutputFile file_;
  std::mutex mutex_;
  std::condition_variable more_;
  std::string pending_;
  bool ended_ = false;
  Status status_;  // the thread's, until it has ended
  std::thread thread_;
};

DcmLogKeeper::DcmLogKeeper(NetworkRun& run, std::function<QString()> name, QObject* parent)
    : QObject(parent), run_(run), name_(std::move(name)) {
  connect(&run_, &NetworkRun::recordChanged, this, [this] {
    stop();
    follow();
  });
  connect(&run_, &NetworkRun::applied, this, &DcmLogKeeper::follow);
  connect(&run_, &NetworkRun::phaseChanged, this, [this] {
    if (run_.phase() == NetworkRun::Phase::kOffline) stop();
  });
  connect(&run_, &NetworkRun::snapshotChanged, this, [this] {
    if (log_) log_->add(run_.snapshot());
  });
  connect(&run_, &NetworkRun::samplesArrived, this, &DcmLogKeeper::add);
}

DcmLogKeeper::~DcmLogKeeper() {
  blockSignals(true);  // whoever listens may be half gone
  finish();
}

/// Parameters that were applied may switch it on or off, or be others than those that a log is made with.
void DcmLogKeeper::follow() {
  const auto& config = run_.origin().config;
  if (config.dc.dcm.log && log_ && log_->suits(config)) return;
  stop();
  if (config.dc.dcm.log) start(config);
}

void DcmLogKeeper::start(const NetworkConfig& config) {
  const auto path = logPath(run_.origin().path, name_());
  QDir().mkpath(QFileInfo(path).path());
  auto file = OutputFile::create(path.toStdString());
  if (!file) {
    Q_EMIT ended(path, file.error());
    return;
  }
  writer_ = std::make_unique<Writer>(std::move(*file));
  log_.emplace(config, [writer = writer_.get()](std::string_view text) { writer->add(text); });
  Q_EMIT began(path);
}

void DcmLogKeeper::add(const std::vector<CycleSample>& samples) {
  if (log_) log_->add(samples);
}

void DcmLogKeeper::stop() {
  if (!writer_) return;
  waitForDisk();
  log_.reset();
  ending_ = std::move(writer_);
  ender_ = std::thread([this, writer = ending_.get()] {
    (void)writer->end();
    post(*this, [this, writer] { onFinished(writer); });
  });
}

void DcmLogKeeper::waitForDisk() {
  if (ending_) onFinished(ending_.get());
}

void DcmLogKeeper::onFinished(const Writer* of) {
  if (!ending_ || of != ending_.get()) return;  // somebody has waited for it
  ender_.join();
  const auto writer = std::move(ending_);
  const auto status = writer->end();
  Q_EMIT ended(writer->path(), status ? std::nullopt : std::optional(status.error()));
}

void DcmLogKeeper::finish() {
  stop();
  waitForDisk();
}

}  // namespace syncline::ui
