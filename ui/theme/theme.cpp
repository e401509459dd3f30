// SPDX-License-Identifier: Apache-2.0
#include "ui/theme/theme.h"

#include <QApplication>
#include <QStyle>
#include <QStyleFactory>

#include "ui/theme/line_icon.h"

/// A static library's resources are linked in by this call; the macro must stand outside of any namespace.
static void linkResources() { Q_INIT_RESOURCE(syncline); }

namespace syncline::ui::theme {
namespace {

Mode g_mode = Mode::kSystem;

struct Colors {
  QRgb window, base, alternate, button, text, muted, disabled, outline, mid, accent, on_accent, tip, tip_text, link;
};

constexpr Colors kLight{0xFFF3F5F7, 0xFFFFFFFF, 0xFFF7F9FA, 0xFFFBFCFD, 0xFF1B2430, 0xFF5A6675, 0xFF98A2AE,
                        0xFFD3D9E0, 0xFFBCC4CD, 0xFF14648C, 0xFFFFFFFF, 0xFF1F2A37, 0xFFF2F5F8, 0xFF14648C};
constexpr Colors kDark{0xFF1E242B, 0xFF171C22, 0xFF1B2128, 0xFF2A323B, 0xFFE4E9EE, 0xFF9BA7B4, 0xFF66717D,
                       0xFF38424D, 0xFF4A5662, 0xFF2F7FA8, 0xFFFFFFFF, 0xFFE4E9EE, 0xFF1B2430, 0xFF7CC0E6};

QPalette paletteOf(const Colors& c) {
  QPalette palette;
  const auto set = [&palette](QPalette::ColorRole role, QRgb color) { palette.setColor(role, QColor::fromRgb(color)); };
  set(QPalette::Window, c.window);
  set(QPalette::WindowText, c.text);
  set(QPalette::Base, c.base);
  set(QPalette::AlternateBase, c.alternate);
  set(QPalette::Text, c.text);
  set(QPalette::Button, c.button);
  set(QPalette::ButtonText, c.text);
  set(QPalette::BrightText, c.on_accent);
  set(QPalette::Highlight, c.accent);
  set(QPalette::HighlightedText, c.on_accent);
  set(QPalette::Link, c.link);
  set(QPalette::LinkVisited, c.link);
  set(QPalette::PlaceholderText, c.muted);
  set(QPalette::ToolTipBase, c.tip);
  set(QPalette::ToolTipText, c.tip_text);
  set(QPalette::Light, c.base);
  set(QPalette::Midlight, c.alternate);
  set(QPalette::Mid, c.mid);
  set(QPalette::Dark, c.mid);
  palette.setColor(QPalette::Shadow, QColor(0, 0, 0, 60));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, QColor::fromRgb(c.disabled));
  }
  palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor::fromRgb(c.outline));
  palette.setColor(QPalette::Disabled, QPalette::HighlightedText, QColor::fromRgb(c.muted));
  return palette;
}

/// Fusion draws the frames of controls in a darkened window colour, which vanishes on a dark ground. These
/// classes paint no window of their own, so they can be given the colour whose darkening is our line.
void setControlOutlines(const QPalette& palette, const Colors& colors) {
  auto controls = palette;
  controls.setColor(QPalette::Window, QColor::fromRgb(colors.mid).lighter(140));
  for (const char* name : {"QCheckBox", "QRadioButton", "QAbstractSpinBox", "QLineEdit", "QComboBox", "QPushButton",
                           "QAbstractItemView"}) {
    QApplication::setPalette(controls, name);
  }
}

const Colors& colorsOf(const QPalette& palette) { return isDark(palette) ? kDark : kLight; }

}  // namespace

QString modeName(Mode mode) {
  switch (mode) {
    case Mode::kLight:
      return QStringLiteral("light");
    case Mode::kDark:
      return QStringLiteral("dark");
    case Mode::kSystem:
      break;
  }
  return QStringLiteral("system");
}

Mode modeFromName(const QString& name) {
  if (name == QLatin1String("light")) return Mode::kLight;
  if (name == QLatin1String("dark")) return Mode::kDark;
  return Mode::kSystem;
}

void apply(Mode mode) {
  // The desktop's palette must be asked before ours is set for the first time.
  static const bool system_dark = isDark(QApplication::palette());
  linkResources();
  g_mode = mode;
  if (QApplication::style()->name() != QLatin1String("fusion")) {
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  }
  const bool dark = mode == Mode::kDark || (mode == Mode::kSystem && system_dark);
  const auto& colors = dark ? kDark : kLight;
  const auto palette = paletteOf(colors);
  QApplication::setPalette(palette);
  setControlOutlines(palette, colors);
}

Mode current() { return g_mode; }

QPalette lightPalette() { return paletteOf(kLight); }

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

QColor toneColor(const QPalette& palette, Tone tone) {
  const bool dark = isDark(palette);
  switch (tone) {
    case Tone::kGood:
      return dark ? QColor(0x5F, 0xCF, 0x93) : QColor(0x0B, 0x6E, 0x42);
    case Tone::kBusy:
      return dark ? QColor(0x6C, 0xB8, 0xE6) : QColor(0x14, 0x64, 0x8C);
    case Tone::kWarning:
      return dark ? QColor(0xE9, 0xB3, 0x4E) : QColor(0x8F, 0x56, 0x00);
    case Tone::kBad:
      return dark ? QColor(0xF4, 0x86, 0x7C) : QColor(0xB3, 0x26, 0x1E);
    case Tone::kAccent:
      return dark ? QColor(0x6C, 0xB8, 0xE6) : QColor(0x14, 0x64, 0x8C);
    case Tone::kNeutral:
      break;
  }
  return mutedText(palette);
}

QColor toneFill(const QPalette& palette, Tone tone) {
  auto color = toneColor(palette, tone);
  color.setAlpha(isDark(palette) ? 40 : 26);
  return color;
}

Tone stateTone(AlState state) {
  switch (state) {
    case AlState::kOp:
      return Tone::kGood;
    case AlState::kSafeop:
      return Tone::kWarning;
    case AlState::kPreop:
    case AlState::kBoot:
      return Tone::kBusy;
    case AlState::kInit:
      return Tone::kNeutral;
    case AlState::kNone:
      break;
  }
  return Tone::kBad;
}

QColor mutedText(const QPalette& palette) { return QColor::fromRgb(colorsOf(palette).muted); }

QColor outline(const QPalette& palette) { return QColor::fromRgb(colorsOf(palette).outline); }

QIcon icon(const QString& name, const QPalette& palette, const QColor& color) {
  if (!LineIcon::exists(name)) return {};
  return QIcon(
      new LineIcon(name, {.normal = color.isValid() ? color : palette.color(QPalette::Active, QPalette::ButtonText),
                          .disabled = palette.color(QPalette::Disabled, QPalette::ButtonText),
                          .selected = palette.color(QPalette::HighlightedText)}));
}

}  // namespace syncline::ui::theme
