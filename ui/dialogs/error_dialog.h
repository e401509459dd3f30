// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace syncline {
struct Error;
}  // namespace syncline

namespace syncline::ui {

/// Says why something the user asked for could not be done. Does not block; only for direct answers
/// to an action, never from the running master.
void showError(QWidget* parent, const QString& what, const Error& error);
/// The same with a button `way` that closes it and leads on by `then`.
void showError(QWidget* parent, const QString& what, const Error& error, const QString& way,
               const std::function<void()>& then);

}  // namespace syncline::ui
