// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace syncline::ui {

/// The LINK of the simulated bus that a project itself describes: as it is wired there, with the devices of its ESI.
inline constexpr QLatin1String kMachineItself{"sim:"};

/// A LINK as the user knows it: "Demonstration machine", "Network card eth0", the scenario's file name.
[[nodiscard]] QString linkName(const QString& link, const QString& demo_link);
/// It is a network card, which one master has for itself; whoever opens a simulated bus gets one of his own.
[[nodiscard]] bool isAdapter(const QString& link);

}  // namespace syncline::ui
