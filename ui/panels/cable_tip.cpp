// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/cable_tip.h"

#include <QCoreApplication>
#include <QStringList>

#include "ui/models/cable_counters.h"
#include "ui/models/network_model.h"

namespace syncline::ui {
namespace {

struct CableTip {
  Q_DECLARE_TR_FUNCTIONS(CableTip)

 public:
  const NetworkModel& network;

  [[nodiscard]] QString nameOf(int slave) const { return network.indexOf(slave).data().toString(); }
  [[nodiscard]] NetworkModel::LinkState linkOf(int slave) const {
    return static_cast<NetworkModel::LinkState>(network.indexOf(slave).data(NetworkModel::kLinkRole).toInt());
  }
  [[nodiscard]] QString endName(const CableEnd& end) const {
    if (end.slave < 0) return nameOf(-1);
    return tr("%1 port %2").arg(nameOf(end.slave), QString(QChar(static_cast<char16_t>(u'A' + end.port))));
  }
  [[nodiscard]] QString linkText(int slave) const {
    switch (linkOf(slave)) {
      case NetworkModel::LinkState::kGood:
        return tr("The link is up.");
      case NetworkModel::LinkState::kBroken:
        return tr("The cable is broken: nothing comes back over it.");
      case NetworkModel::LinkState::kSilent:
        return tr("%1 does not answer.").arg(nameOf(slave));
      case NetworkModel::LinkState::kOffline:
        break;
    }
    return tr("Offline: the link is not known.");
  }
  [[nodiscard]] QString endText(const CableEnd& end) const {
    if (!end.reading)
      return linkOf(end.slave) == NetworkModel::LinkState::kGood
                 ? tr("%1: not read yet").arg(endName(end))
                 : tr("%1 does not answer: no counters").arg(nameOf(end.slave));
    const auto& [errors, age, growth] = *end.reading;
    const auto counted = [&errors = errors, &growth = growth](std::uint32_t count, std::size_t n) {
      return growingText(count, errors.at_least && count > 0, growth[n]);
    };
    return tr("%1, read %2:").arg(endName(end), agoText(age)) + QStringLiteral("\n  ") +
           tr("invalid frames %1, receive errors %2")
               .arg(counted(errors.invalid_frames, 0), counted(errors.receive_errors, 1)) +
           QStringLiteral("\n  ") +
           tr("forwarded errors %1, lost links %2")
               .arg(counted(errors.forwarded_errors, 2), counted(errors.lost_links, 3));
  }
  [[nodiscard]] static QString meaningOf(CableDamage damage) {
    switch (damage) {
      case CableDamage::kFirst:
        return tr("Here frames are damaged first: begin with this cable and its plugs.");
      case CableDamage::kHere:
        return tr("Frames were damaged or the link was lost on this cable.");
      case CableDamage::kForwarded:
        return tr("Only forwarded errors: the frames were damaged on another cable.");
      case CableDamage::kNone:
        break;
    }
    return {};
  }
};

}  // namespace

QString cableTip(const NetworkModel& network, const CableCounters& cables, int slave) {
  const auto ends = cables.ends(slave);
  if (ends.size() != 2) return {};
  const CableTip tip{network};
  QStringList lines{CableTip::tr("Cable: %1 to %2").arg(tip.endName(ends[0]), tip.endName(ends[1])),
                    tip.linkText(slave)};
  const bool online = tip.linkOf(slave) != NetworkModel::LinkState::kOffline;
  for (const auto& end : ends) {
    if (online && end.slave >= 0) lines << tip.endText(end);
  }
  const auto badge = cables.badge(slave);
  if (badge.damage == CableDamage::kNone) return lines.join(u'\n');
  lines << CableTip::meaningOf(badge.damage);
  lines << CableTip::tr("Click the number for the error counters of %1.").arg(tip.nameOf(badge.slave));
  return lines.join(u'\n');
}

}  // namespace syncline::ui
