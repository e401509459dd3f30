// SPDX-License-Identifier: Apache-2.0
#include "ui/text/finding_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <string>
#include <utility>

#include "findings/fold.h"
#include "protocol/al_state.h"
#include "reasons/placeholder.h"
#include "reasons/reason.h"
#include "ui/text/joined_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

/// Source text for lupdate's "Finding" context.
class FindingSentences {
  Q_DECLARE_TR_FUNCTIONS(Finding)

 public:
  static QString of(const Figure& figure);
  static QString ranges(const std::string& text) {
    return QString::fromStdString(text).replace(QStringLiteral(" to "), tr(" to "));
  }
  static QString slaves(const std::string& text) { return tr("Slaves %1").arg(ranges(text)); }
  static QString reason(const Reason& reason);
  static QString said(const Figure& figure) {
    return figure.reason.empty() ? sentence(figure.text) : FindingSentences::reason(figure.reason);
  }
  static QString sentence(std::string_view text) {
    return QCoreApplication::translate("Finding", std::string(text).c_str());
  }
};

/// The sign of micro, as all of the window has it: files and terminals do without.
QString withMicro(QString text) {
  static const QRegularExpression kMicroseconds(QStringLiteral("(?<=\\d) us\\b"));
  return text.replace(kMicroseconds, QStringLiteral(" \u00B5s"));
}

/// The figure's text, or the words that it chooses with it.
QString placed(const Placeholder& placeholder, const QString& text, bool is_one) {
  if (placeholder.one.empty()) return text;
  return fromView(placeholder.words_for(is_one)).replace(QLatin1Char('#'), text);
}

/// A language may give the placeholders another order: each is found by its name.
QString FindingSentences::reason(const Reason& reason) {
  auto words = reason.words();
  if (words.empty()) return QString::fromStdString(reason.text());
  const auto text = sentence(words);
  if (reason.given().empty()) return text;
  std::vector<std::pair<std::string_view, const Reason*>> given;
  for (const Reason& one : reason.given()) {
    const auto place = next_place(words);
    given.emplace_back(place.in(words).name, &one);
    words.remove_prefix(place.end);
  }
  QString out;
  const auto translated = text.toStdString();
  std::string_view rest = translated;
  for (auto place = next_place(rest); place.end > place.open; place = next_place(rest)) {
    const auto placeholder = place.in(rest);
    const auto found = std::ranges::find(given, placeholder.name, &std::pair<std::string_view, const Reason*>::first);
    const auto as_it_is = rest.substr(place.open, place.end - place.open);
    out += fromView(rest.substr(0, place.open));
    out += found == given.end()
               ? fromView(as_it_is)
               : placed(placeholder, FindingSentences::reason(*found->second), found->second->text() == "1");
    rest.remove_prefix(place.end);
  }
  return out += fromView(rest);
}

QString FindingSentences::of(const Figure& figure) {
  using In = Figure::Unit;
  switch (figure.unit) {
    case In::kCount: {
      const auto count = QLocale().toString(static_cast<qlonglong>(figure.value));
      return figure.text.empty() ? count : tr("at least %1").arg(count);
    }
    case In::kTimes: {
      const auto times =
          figure.value == 1 ? tr("once") : tr("%1 times").arg(countText(static_cast<std::uint64_t>(figure.value)));
      return figure.text.empty() ? times : tr("at least %1").arg(times);
    }
    case In::kNanoseconds:
      return timeText(figure.value);
    case In::kMoment:
      return timeText(figure.value / kMillisecond * kMillisecond);
    case In::kPpm:
      return ppmText(static_cast<double>(figure.value) / 1e3);
    case In::kTime:
      return QString::fromStdString(figure_text(figure))
          .replace(QLatin1Char('.'), QLocale().decimalPoint())
          .replace(QStringLiteral(" us"), QStringLiteral(" \u00B5s"))
          .replace(u' ', QChar(0x00A0));
    case In::kSlave: {
      if (figure.value == -1) return tr("the host");
      if (figure.value < 0) return tr("nobody in the configuration");
      if (figure.other > figure.value) return tr("slaves %1 to %2").arg(figure.value).arg(figure.other);
      const auto slave = tr("slave %1").arg(figure.value);
      return figure.text.empty() ? slave : QStringLiteral("%1 (%2)").arg(slave, QString::fromStdString(figure.text));
    }
    case In::kSlaves:
      return tr("each of slaves %1").arg(ranges(figure.text));
    case In::kAlCode: {
      const auto code = static_cast<std::uint16_t>(figure.value);
      return QStringLiteral("%1 (%2)").arg(hexText(code, 4), sentence(al_status_code_text(code).meaning));
    }
    case In::kPhrase:
      return said(figure);
    case In::kAside: {
      const auto text = said(figure);
      return text.isEmpty() ? text : QStringLiteral(": ") + text;
    }
    default:
      return QString::fromStdString(figure_text(figure));
  }
}

/// As fill_finding_template(), in the user's language.
QString fill(const QString& text, const Finding& finding) {
  QString out;
  qsizetype from = 0;
  for (qsizetype open = text.indexOf(QLatin1Char('{')); open >= 0; open = text.indexOf(QLatin1Char('{'), from)) {
    const auto close = text.indexOf(QLatin1Char('}'), open);
    if (close < 0) break;
    const auto inside = text.mid(open + 1, close - open - 1).toStdString();
    const Placeholder placeholder{std::string_view(inside)};
    const auto found = std::ranges::find(finding.figures, placeholder.name, &Figure::name);
    out += QStringView(text).mid(from, open - from);
    out += found == finding.figures.end() ? text.mid(open, close - open + 1)
                                          : placed(placeholder, FindingSentences::of(*found), found->value == 1);
    from = close + 1;
  }
  out += QStringView(text).mid(from);
  if (!out.isEmpty() && !begins_with_own_text(text.toStdString(), finding)) out[0] = out[0].toUpper();
  return withMicro(out.replace(QStringLiteral("->"), QStringLiteral("\u2192")));
}

}  // namespace

QString findingText(const Finding& finding) {
  return fill(FindingSentences::sentence(facts_template(finding)), finding);
}

QString findingTextWithoutSubject(const Finding& finding) {
  static const QRegularExpression kSubject(QStringLiteral("^\\{subject\\}[:\uFF1A]\\s*"));
  auto text = FindingSentences::sentence(facts_template(finding));
  return fill(text.remove(kSubject), finding);
}

QString findingAdvice(const Finding& finding) {
  const FindingWords* words = find_finding_words(finding.code);
  return words == nullptr || words->mend.empty() ? QString() : fill(FindingSentences::sentence(words->mend), finding);
}

QString findingWhole(const Finding& finding) {
  const auto text = findingText(finding), advice = findingAdvice(finding);
  return advice.isEmpty() ? text : joinedSentences({text, advice});
}

QString reasonText(const Reason& reason) { return withMicro(FindingSentences::reason(reason)); }

QString findingKey(const Finding& finding) {
  if (!finding.place.key.empty()) return QString::fromStdString(finding.place.key);
  const FindingWords* words = find_finding_words(finding.code);
  return words == nullptr ? QString() : QString::fromStdString(setting_at(words->setting, finding.place.slave));
}

QString phraseText(std::string_view phrase) { return FindingSentences::sentence(phrase); }
QString slavesText(std::span<const int> positions) { return FindingSentences::slaves(ranges_text(positions)); }

std::vector<std::string_view> translatableFindings() {
  std::vector<std::string_view> texts;
  for (const FindingWords& words : all_finding_words()) {
    for (const auto text : {words.title, words.why, words.mend}) texts.push_back(text);
    for (const auto& facts : words.facts) texts.push_back(facts.text);
  }
  const auto phrases = finding_phrases();
  texts.insert(texts.end(), phrases.begin(), phrases.end());
  std::erase_if(texts, [](std::string_view text) { return text.empty(); });
  std::ranges::sort(texts);
  texts.erase(std::unique(texts.begin(), texts.end()), texts.end());
  return texts;
}

}  // namespace syncline::ui
