// SPDX-License-Identifier: Apache-2.0
#include "plain_words.h"

#include <QAbstractScrollArea>
#include <QAccessible>
#include <QApplication>
#include <QCoreApplication>
#include <QHelpEvent>
#include <QPointer>
#include <QRegularExpression>
#include <QToolTip>
#include <QWidget>
#include <QXmlStreamReader>
#include <algorithm>
#include <utility>

#include "config/project.h"
#include "drawn_words.h"
#include "eni/project/project_file.h"

namespace syncline::test {
namespace {

/// The same in every language.
const QSet<QString>& units() {
  static const QSet<QString> kUnits{QStringLiteral("ns"),  QStringLiteral("us"),  QStringLiteral("ms"),
                                    QStringLiteral("ppm"), QStringLiteral("Hz"),  QStringLiteral("kHz"),
                                    QStringLiteral("MHz"), QStringLiteral("min"), QStringLiteral("dB"),
                                    QStringLiteral("KiB"), QStringLiteral("MiB"), QStringLiteral("GiB"),
                                    QStringLiteral("nan"), QStringLiteral("inf"), QStringLiteral("Engineer")};
  return kUnits;
}

QStringList plainWords(QString text) {
  // What an ellipsis has cut; tags and entities; paths of files; numbers; elements of ENI, with their path; keys and
  // names of files; other names in capitals, or with one inside.
  static const QRegularExpression kNoWords(QStringLiteral(
      R"(\w*…\w*|<[^>]*>|&[a-z]+;|(\w+:)?/[\w./?-]+|0x[0-9A-Fa-f]+|#x?[0-9A-Fa-f]+|\b[A-Z]\w*(/[A-Z]\w*)+|[\w-]+([._:][\w-]+)+|\b[A-Z0-9]{2,}\b|\b[A-Za-z]*[a-z][A-Z]\w*)"));
  static const QRegularExpression kWord(QStringLiteral("(?<![^\\W\\d_])[A-Za-z]{2,}(?![^\\W\\d_])"),
                                        QRegularExpression::UseUnicodePropertiesOption);
  text.replace(kNoWords, QStringLiteral(" ")).remove(u'&');
  QStringList words;
  for (auto found = kWord.globalMatch(text); found.hasNext();) words << found.next().captured();
  return words;
}

bool isMarked(const QString& text) {
  return std::ranges::any_of(text, [](QChar letter) { return letter.isLetter() && letter.unicode() > 0xBF; });
}

QString nameOf(const QWidget& widget) {
  const QWidget* named = &widget;
  while (named->parentWidget() != nullptr &&
         (named->objectName().isEmpty() || named->objectName().startsWith(QLatin1String("qt_"))))
    named = named->parentWidget();
  return named->objectName();
}

/// Its words are those of the ENI file and of the registers' table, which have one language; or it is a tip that an
/// earlier question left behind.
bool isForeign(const QWidget& widget) {
  static const QSet<QString> kForeign{QStringLiteral("eniText"), QStringLiteral("initCommandTable"),
                                      QStringLiteral("datagramTable"), QStringLiteral("registerTree")};
  if (widget.objectName() == QLatin1String("qtooltip_label")) return true;
  const auto* area = qobject_cast<const QAbstractScrollArea*>(widget.parentWidget());
  return area != nullptr && area->viewport() == &widget && kForeign.contains(area->objectName());
}

/// At once, and not after a while: its text would be taken for the next widget's.
void dropTip() {
  QToolTip::hideText();
  for (auto* widget : QApplication::topLevelWidgets()) {
    if (widget->objectName() == QLatin1String("qtooltip_label")) delete widget;
  }
}

}  // namespace

void PlainWords::addName(const QString& name) {
  for (const auto& word : plainWords(name)) names_.insert(word);
}

void PlainWords::addNames(const Project& project) {
  QXmlStreamReader xml(QString::fromStdString(eni::write_project(project)));
  for (const auto& slave : project.slaves) addName(QString::fromStdString(slave.device.vendor_name));
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.isCharacters()) addName(xml.text().toString());
  }
}

QStringList PlainWords::in(const QString& text) const {
  auto words = plainWords(text);
  words.removeIf([this](const QString& word) { return units().contains(word) || names_.contains(word); });
  return words;
}

void PlainWords::look(const QString& text, const QString& where) {
  if (text.isEmpty()) return;
  ++seen_;
  const auto words = in(text);
  if (words.isEmpty() || told_.contains(words.join(u' ') + where)) return;
  told_.insert(words.join(u' ') + where);
  found_ << QStringLiteral("%1 shows \"%2\": not translated: %3").arg(where, text, words.join(QStringLiteral(", ")));
}

void PlainWords::look(QWidget& root) {
  auto parts = root.findChildren<QWidget*>();
  parts.prepend(&root);
  // Asking may delete a tip that was shown before, which is a child, too.
  for (const auto& part : QList<QPointer<QWidget>>(parts.begin(), parts.end())) {
    if (!part || !part->isVisible() || isForeign(*part)) continue;
    const auto where = nameOf(*part);
    const auto drawn = drawnWords(*part);
    marked_ += static_cast<int>(std::ranges::count_if(drawn, isMarked));
    for (const auto& text : drawn) look(text, where);
    look(part->toolTip(), where);
    if (auto* spoken = QAccessible::queryAccessibleInterface(part)) {
      for (const auto kind : {QAccessible::Name, QAccessible::Value, QAccessible::Description})
        look(spoken->text(kind), where);
    }
  }
}

void PlainWords::lookAtTips(QWidget& widget) {
  if (isForeign(widget)) return;
  constexpr int kAcross = 12, kDown = 5;
  for (int i = 0; i < kAcross * kDown; ++i) {
    const QPoint at((i % kAcross) * widget.width() / kAcross + 4, (i / kAcross) * widget.height() / kDown + 4);
    dropTip();
    QHelpEvent asks(QEvent::ToolTip, at, widget.mapToGlobal(at));
    QCoreApplication::sendEvent(&widget, &asks);
    look(QToolTip::text(), nameOf(widget));
  }
  dropTip();
}

QStringList PlainWords::takeFound() { return std::exchange(found_, {}); }

}  // namespace syncline::test
