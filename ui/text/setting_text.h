// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <span>
#include <string>

namespace syncline::settings {
struct Option;
struct Setting;
}  // namespace syncline::settings

/// The words of the table of settings in the user's language.
namespace syncline::ui {

[[nodiscard]] QString settingLabel(const settings::Setting& setting);
/// The words of an option of a choice.
[[nodiscard]] QString optionText(const settings::Option& option);
/// A word of the table, like "auto".
[[nodiscard]] QString settingWord(const std::string& word);
/// `label` with the mark of settings that few machines need.
[[nodiscard]] QString expertText(const QString& label);
/// What the setting means and where it goes, in two lines.
[[nodiscard]] QString settingTip(const settings::Setting& setting);
/// The same with values, default and key, as rich text for What's This.
[[nodiscard]] QString settingHelp(const settings::Setting& setting);

/// The labels and sentences that translations know.
[[nodiscard]] std::span<const char* const> translatableSettings();

}  // namespace syncline::ui
