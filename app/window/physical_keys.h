// Keys by their position on the keyboard, whatever the layout types with them.
#pragma once

#include <QKeyEvent>

namespace hairpaint::app {

enum class PhysicalKey
{
    Other,
    Digit1,
    Digit2,
    Digit3,
    Digit4,
    Digit5,
    Digit6,
    Digit7,
    Digit8,
    Digit9,
    Digit0,
    BracketLeft,
    BracketRight
};

/// By scan code where the platform gives one, else by what the key types.
[[nodiscard]] PhysicalKey physicalKey(const QKeyEvent& event);
/// What the key types on most keyboards.
[[nodiscard]] Qt::Key usualKey(PhysicalKey key);
inline constexpr int kDigits = 10;
/// The key of 1..9, and the 0 beside it of 10; Other for a number beyond.
[[nodiscard]] PhysicalKey digitKey(int number);
/// 1..10, or 0 for any other key.
[[nodiscard]] int digitOf(PhysicalKey key);

} // namespace hairpaint::app
