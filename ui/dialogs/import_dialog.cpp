// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/import_dialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <cmath>
#include <limits>

#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

constexpr double kLongestCapture = 1e6;  // s of a capture
constexpr int kImportDigits = 3;
constexpr int kNameCharacters = 40;  // of a file's name
constexpr double kNanosecondsInMicrosecond = 1e3;

QDoubleSpinBox* importSeconds(const char* name, const QString& label) {
  auto* box = named(new QDoubleSpinBox, name, label);
  box->setRange(0, kLongestCapture);
  box->setDecimals(kImportDigits);
  box->setSuffix(QStringLiteral(" s"));
  return box;
}

/// 0 stands for none.
QDoubleSpinBox* importLimit(const char* name, const QString& label) {
  constexpr double kMost = 1e6;
  auto* box = named(new QDoubleSpinBox, name, label);
  box->setRange(0, kMost);
  box->setDecimals(kImportDigits);
  box->setSuffix(QStringLiteral(" \u00B5s"));
  box->setSpecialValueText(ImportDialog::tr("none"));
  return box;
}

Nanoseconds nanosecondsOf(double seconds) { return static_cast<Nanoseconds>(std::llround(seconds * 1e9)); }

}  // namespace

ImportDialog::ImportDialog(const QString& capture, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("importDialog"));
  setWindowTitle(tr("Import a Capture"));
  auto* layout = new QVBoxLayout(this);
  // A name has no place where its line could end.
  const auto name = QFileInfo(capture).fileName();
  const auto shown =
      fontMetrics().elidedText(name, Qt::ElideMiddle, kNameCharacters * fontMetrics().averageCharWidth());
  auto* words = new QLabel(tr("Times count from the first frame of %1.").arg(shown));
  words->setWordWrap(true);
  words->setToolTip(capture);
  layout->addWidget(words);
  auto* form = new QFormLayout;
  from_ = importSeconds("importFrom", tr("From"));
  until_ = importSeconds("importUntil", tr("Until"));
  until_->setSpecialValueText(tr("end of the file"));
  frames_ = named(new QSpinBox, "importFrames", tr("At most"));
  frames_->setRange(0, std::numeric_limits<int>::max());
  frames_->setSingleStep(1000);
  frames_->setSpecialValueText(tr("all frames"));
  frames_->setSuffix(tr(" frames"));
  deviation_ = importLimit("importDeviationLimit", tr("Limit of the slaves' deviation"));
  error_ = importLimit("importErrorLimit", tr("Limit of the master's error"));
  form->addRow(tr("&From"), from_);
  form->addRow(tr("&Until"), until_);
  form->addRow(tr("At &most"), frames_);
  form->addRow(tr("Limit of the slaves' &deviation"), deviation_);
  form->addRow(tr("Limit of the master's &error"), error_);
  layout->addLayout(form);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  named(buttons->button(QDialogButtonBox::Ok), "importAccept", tr("OK"));
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  for (auto* box : {from_, until_}) connect(box, &QDoubleSpinBox::valueChanged, this, &ImportDialog::keepInOrder);
}

/// An end before the begin would leave nothing: OK waits.
void ImportDialog::keepInOrder() {
  const bool ordered = until_->value() == 0 || until_->value() > from_->value();
  findChild<QPushButton*>(QStringLiteral("importAccept"))->setEnabled(ordered);
  until_->setToolTip(ordered ? QString() : tr("The end comes before the begin."));
}

ImportLimits ImportDialog::limits() const {
  ImportLimits limits;
  limits.from = nanosecondsOf(from_->value());
  limits.until = nanosecondsOf(until_->value());
  limits.most_frames = static_cast<std::uint64_t>(frames_->value());
  limits.deviation_ns = static_cast<std::uint32_t>(std::lround(deviation_->value() * kNanosecondsInMicrosecond));
  limits.dcm_error_ns = std::lround(error_->value() * kNanosecondsInMicrosecond);
  return limits;
}

}  // namespace syncline::ui
