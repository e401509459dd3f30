// SPDX-License-Identifier: Apache-2.0
#include "ui/session/favourite_objects.h"

#include <QStringList>

#include "protocol/object_value.h"
#include "ui/models/dictionary.h"
#include "ui/session/window_memory.h"

namespace syncline::ui {
namespace {

QString keyOf(const Identity& device) {
  return QStringLiteral("favouriteObjects/%1-%2")
      .arg(device.vendor_id, 8, 16, QLatin1Char('0'))
      .arg(device.product_code, 8, 16, QLatin1Char('0'));
}

}  // namespace

std::vector<coe::ObjectAddress> FavouriteObjects::of(const Identity& device) const {
  std::vector<coe::ObjectAddress> objects;
  for (const auto& word : memory_.value(keyOf(device)).toStringList()) {
    if (const auto object = object_name(word.toStdString())) objects.push_back({object->index, object->sub_index});
  }
  return objects;
}

void FavouriteObjects::set(const Identity& device, const std::vector<coe::ObjectAddress>& objects) {
  QStringList words;
  for (const auto object : objects) words << objectText(object);
  memory_.setValue(keyOf(device), words);
}

}  // namespace syncline::ui
