// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace syncline {
struct Error;
}  // namespace syncline

namespace syncline::eni {
struct FileWarning;
}  // namespace syncline::eni

namespace syncline::ui {

/// The sentences of an error in the user's language: what happened, where, and what to do.
[[nodiscard]] QString errorText(const Error& error);
/// What was tolerated in a file or left out of it, and where, in the user's language.
[[nodiscard]] QString warningText(const eni::FileWarning& warning);

}  // namespace syncline::ui
