// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/csv_export.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QVBoxLayout>
#include <utility>

#include "support/output_file.h"
#include "ui/session/post.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr std::size_t kCsvPortion = 100'000;  // values: some milliseconds of the window's thread
constexpr int kWholeExport = 1000, kExportPatienceMs = 300;

}  // namespace

/// With a bar of its own: that of QProgressDialog would turn the event loop within feed().
void CsvExport::openDialog(const QString& path) {
  dialog_ = named(new QDialog(qobject_cast<QWidget*>(parent())), "csvProgress", tr("Export"));
  dialog_->setWindowTitle(tr("Export"));
  // The machine and its plots go on; what is exported must stay what it is.
  dialog_->setWindowModality(Qt::WindowModal);
  auto* layout = new QVBoxLayout(dialog_);
  layout->addWidget(new QLabel(tr("Writing %1…").arg(QFileInfo(path).fileName())));
  auto* bar = named(new QProgressBar, "csvProgressBar", tr("Export"));
  bar->setRange(0, kWholeExport);
  layout->addWidget(bar);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, dialog_, &QDialog::reject);
  connect(dialog_, &QDialog::rejected, this, &CsvExport::cancel);
  connect(this, &CsvExport::progress, bar, &QProgressBar::setValue);
  QTimer::singleShot(kExportPatienceMs, dialog_, &QWidget::show);
}

CsvExport::CsvExport(QWidget* parent) : QObject(parent) {}

CsvExport::~CsvExport() { cancel(); }

void CsvExport::start(const QString& path, CsvTable table) {
  if (isBusy()) return;
  openDialog(path);
  auto head = table.head();
  table_.emplace(std::move(table));
  portion_.reset();
  last_ = stopped_ = false;
  ++number_;
  thread_ = std::thread([this, path = path.toStdString(), head = std::move(head)] { write(path, head); });
  feed();
}

/// A portion at a time: the next one when the writing thread has taken it.
void CsvExport::feed() {
  if (!table_) return;
  auto rows = table_->next(kCsvPortion);
  const bool last = table_->complete();
  {
    const std::lock_guard lock(mutex_);
    portion_ = std::move(rows);
    last_ = last;
  }
  changed_.notify_one();
  Q_EMIT progress(table_->progress());
}

std::optional<CsvRows> CsvExport::take() {
  std::optional<CsvRows> rows;
  bool more = false;
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return portion_ || last_ || stopped_; });
    if (!stopped_) rows = std::exchange(portion_, std::nullopt);
    more = rows && !last_;
  }
  // What is told late is of an export that is over.
  if (more)
    post(*this, [this, number = number_] {
      if (number == number_) feed();
    });
  return rows;
}

void CsvExport::write(const std::string& path, const std::string& head) {
  auto file = OutputFile::create(path);
  Status status = file ? file->write(head) : Status(tl::unexpected(file.error()));
  std::string text;
  while (auto rows = take()) {
    if (!status) break;
    text.clear();
    append_csv(text, *rows);
    status = file->write(text);
  }
  bool stopped = false;
  {
    const std::lock_guard lock(mutex_);
    stopped = stopped_;
  }
  if (stopped) return;  // what is not finished is removed
  if (status) status = file->finish();
  post(*this, [this, status = std::move(status), number = number_] {
    if (number == number_) end(status);
  });
}

void CsvExport::cancel() {
  if (!table_) return;
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_one();
  end(fail(ErrorCode::kCancelled));
}

void CsvExport::end(const Status& status) {
  if (!table_) return;  // it was cancelled as it was about to end
  if (thread_.joinable()) thread_.join();
  table_.reset();
  if (dialog_) {
    dialog_->disconnect(this);
    dialog_->hide();
    dialog_->deleteLater();
  }
  if (status) {
    Q_EMIT finished();
  } else {
    Q_EMIT failed(status.error());
  }
}

}  // namespace syncline::ui
