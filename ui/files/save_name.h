// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFileDialog>
#include <QString>

class QWidget;

namespace syncline::ui {

/// Asks for the name of a file to write. Empty: the user does not want to, or it is one that is open here, which the
/// user has been told (mayWrite()).
[[nodiscard]] QString askSaveName(QWidget* parent, const QString& title, const QString& proposed, const QString& filter,
                                  QFileDialog::Options options = {});
/// A name that the user gave without a suffix gets this one (with its point). The dialog has asked about another file
/// then: of one that is there it is asked here whether it shall be replaced. Empty: it shall not.
[[nodiscard]] QString withSuffix(QWidget* parent, const QString& title, const QString& path, const QString& suffix);
/// The same as askSaveName() of a name that was asked for otherwise; false: told.
[[nodiscard]] bool mayWriteOrTell(QWidget* parent, const QString& title, const QString& path);

}  // namespace syncline::ui
