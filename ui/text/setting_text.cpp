// SPDX-License-Identifier: Apache-2.0
#include "ui/text/setting_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "settings/setting.h"
#include "settings/setting_type.h"
#include "ui/text/joined_text.h"

namespace syncline::ui {
namespace {

QString translated(const std::string& text) { return QCoreApplication::translate("Setting", text.c_str()); }
QString word(const char* text) { return QCoreApplication::translate("Setting", text); }

/// "0x09A0": a register; "0x10F1:02": an object; other things have names.
QString whereText(const settings::Words& words) {
  if (words.object.empty()) return {};
  const auto object = QString::fromStdString(words.object);
  if (!object.startsWith(QStringLiteral("0x"))) return object;
  const bool is_object = object.contains(u':') || object.startsWith(QStringLiteral("0x1C"));
  return (is_object ? word(QT_TRANSLATE_NOOP("Setting", "Object %1"))
                    : word(QT_TRANSLATE_NOOP("Setting", "Register %1")))
      .arg(object);
}

QString eniText(const settings::Words& words) {
  return words.eni.empty() ? QString() : QStringLiteral("ENI ") + QString::fromStdString(words.eni);
}

QString noEniText(const settings::Words& words) { return words.no_eni.empty() ? QString() : translated(words.no_eni); }

/// What stands for nothing set is a word of its own: "none, ident of a module ...".
QString rangeWords(const std::string& words, const std::string& unset) {
  const auto comma = words.find(", ");
  const auto first = words.substr(0, comma);
  if (comma == std::string::npos || (first != unset && first != "off" && first != "nothing")) return translated(words);
  return joinedParts({translated(first), translated(words.substr(comma + 2))});
}

/// What may be typed or chosen, in the user's words; names of formats and of objects are everywhere the same.
QString valuesText(const settings::Setting& setting) {
  if (!setting.range_words.empty()) return rangeWords(setting.range_words, setting.unset);
  QStringList values;
  if (!setting.unset.empty()) values << translated(setting.unset);
  const auto* choice = std::get_if<settings::Choice>(&setting.type);
  if (const auto* number = std::get_if<settings::Number>(&setting.type)) {
    values << QString::fromStdString(settings::range_text(*number, number->range));
  } else if (choice != nullptr) {
    for (const auto& option : choice->options) values << optionText(option);
  } else if (std::holds_alternative<settings::Switch>(setting.type)) {
    values << translated("on") << translated("off");
  } else {
    values << rangeWords(settings::range_text(setting.type), setting.unset);
  }
  return joinedParts(values);
}

/// The same of what a new project has.
QString presetText(const settings::Setting& setting) {
  const auto preset = settings::preset_text(setting);
  if (const auto* choice = std::get_if<settings::Choice>(&setting.type)) {
    const auto option = std::ranges::find(choice->options, preset, &settings::Option::word);
    if (option != choice->options.end()) return optionText(*option);
  }
  const bool a_name = std::holds_alternative<settings::Text>(setting.type) && preset != setting.unset &&
                      setting.words.preset.empty() && preset != "nothing";
  return a_name || preset.empty() ? QString::fromStdString(preset) : translated(preset);
}

}  // namespace

QString settingLabel(const settings::Setting& setting) { return translated(setting.words.label); }

QString optionText(const settings::Option& option) {
  return translated(option.text.empty() ? option.word : option.text);
}

QString settingWord(const std::string& word) { return word.empty() ? QString() : translated(word); }

QString expertText(const QString& label) { return label + QStringLiteral(" \u25C6"); }

QString settingTip(const settings::Setting& setting) {
  QStringList where{whereText(setting.words), eniText(setting.words)};
  if (!setting.words.no_eni.empty())
    where << word(QT_TRANSLATE_NOOP("Setting", "Not in the ENI: %1")).arg(noEniText(setting.words));
  where.removeAll(QString());
  auto help = translated(setting.words.help);
  if (setting.words.expert) {
    help += u'\n' + expertText(word(QT_TRANSLATE_NOOP("Setting", "Expert setting: few machines need it"))).trimmed();
  }
  return where.isEmpty() ? help : help + u'\n' + joinedParts(where);
}

QString settingHelp(const settings::Setting& setting) {
  QStringList facts;
  const auto add = [&facts](const QString& name, const QString& value) {
    if (!value.isEmpty()) facts << QStringLiteral("%1: %2").arg(name, value.toHtmlEscaped());
  };
  const auto* number = std::get_if<settings::Number>(&setting.type);
  auto values = valuesText(setting);
  if (number != nullptr && !number->unit.empty()) {
    values += u' ' + (number->unit == "us" ? QStringLiteral("\u00B5s") : translated(std::string(number->unit)));
  }
  add(word(QT_TRANSLATE_NOOP("Setting", "Values")), values);
  if (number != nullptr && !setting.unset.empty()) {
    add(word(QT_TRANSLATE_NOOP("Setting", "Emptied field")), settingWord(setting.unset));
  }
  add(word(QT_TRANSLATE_NOOP("Setting", "Default")), presetText(setting));
  add(word(QT_TRANSLATE_NOOP("Setting", "Goes to")), whereText(setting.words));
  add(word(QT_TRANSLATE_NOOP("Setting", "Changes")), eniText(setting.words));
  add(word(QT_TRANSLATE_NOOP("Setting", "Not in the ENI")), noEniText(setting.words));
  add(word(QT_TRANSLATE_NOOP("Setting", "Key")), QString::fromStdString(setting.key));
  return QStringLiteral("<p><b>%1</b></p><p>%2</p><p>%3</p>")
      .arg(settingLabel(setting).toHtmlEscaped(), translated(setting.words.help).toHtmlEscaped(),
           facts.join(QStringLiteral("<br>")));
}

}  // namespace syncline::ui
