// SPDX-License-Identifier: Apache-2.0
#include "ui/text/finding_text.h"

#include <QCoreApplication>

#include "ui/text/units.h"

namespace syncline::ui {
namespace {

/// Source text for lupdate's "Finding" context.
class FindingWords {
  Q_DECLARE_TR_FUNCTIONS(Finding)

 public:
  static QString of(const Figure& figure);
  static QString sentence(std::string_view text) {
    return QCoreApplication::translate("Finding", std::string(text).c_str());
  }
};

QString FindingWords::of(const Figure& figure) {
  using In = Figure::Unit;
  switch (figure.unit) {
    case In::kCount: {
      const auto count = countText(static_cast<std::uint64_t>(figure.value));
      return figure.text.empty() ? count : tr("at least %1").arg(count);
    }
    case In::kTimes: {
      if (figure.value == 1 && figure.text.empty()) return tr("once");
      const auto times = tr("%1 times").arg(countText(static_cast<std::uint64_t>(figure.value)));
      return figure.text.empty() ? times : tr("at least %1").arg(times);
    }
    case In::kNanoseconds:
      return timeText(figure.value);
    case In::kMoment:
      return timeText(figure.value / kMillisecond * kMillisecond);
    case In::kPpm:
      return ppmText(static_cast<double>(figure.value) / 1e3);
    case In::kSlave:
      if (figure.value == -1) return tr("the host");
      if (figure.value < 0) return tr("nobody in the configuration");
      return figure.other > figure.value ? tr("slaves %1 to %2").arg(figure.value).arg(figure.other)
                                         : tr("slave %1").arg(figure.value);
    case In::kText:
      return figure.text.empty() ? QString() : sentence(figure.text);
    default:
      return QString::fromStdString(figure_text(figure));
  }
}

QString fill(QString text, const RunFinding& finding) {
  for (const auto& figure : finding.figures) {
    const auto name = QLatin1Char('{') +
                      QString::fromUtf8(figure.name.data(), static_cast<qsizetype>(figure.name.size())) +
                      QLatin1Char('}');
    text.replace(name, FindingWords::of(figure));
  }
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace

QString findingText(const RunFinding& finding) {
  return fill(FindingWords::sentence(finding_words(finding.code).why), finding);
}

/// The settings that the findings' advice names; others are mended outside of the project.
QString findingKey(const RunFinding& finding) {
  const auto ofSlave = [&](const char* name) {
    return finding.slave < 0 ? QString() : QStringLiteral("slave.%1.%2").arg(finding.slave).arg(QLatin1String(name));
  };
  switch (finding.code) {
    case FindingCode::kNotMonitored:
      return QStringLiteral("master.dc.sync_window");
    case FindingCode::kMissedByLateFrames:  // send earlier
      return QStringLiteral("master.dc.set_value_us");
    case FindingCode::kSync0TooTight:
    case FindingCode::kShiftTooShort:
      return ofSlave("dc.sync0.shift_us");
    case FindingCode::kInputShiftTooShort:
      return ofSlave("sync.input_shift_us");
    case FindingCode::kGatewayCycleExceeded:
      return ofSlave("can.cycle_us");
    default:
      return {};
  }
}

QString findingAdvice(const RunFinding& finding) {
  const auto mend = finding_words(finding.code).mend;
  return mend.empty() ? QString() : fill(FindingWords::sentence(mend), finding);
}

}  // namespace syncline::ui
