// Keys by position: see the header.
#include "app/window/physical_keys.h"

namespace hairpaint::app {

PhysicalKey physicalKey(const QKeyEvent& event)
{
    if (const quint32 code = event.nativeScanCode(); code != 0) {
#ifdef Q_OS_WIN
        constexpr quint32 kFirstDigit = 0x02;
        constexpr quint32 kBracketLeft = 0x1A;
#else
        // X11 and Wayland: evdev codes plus 8.
        constexpr quint32 kFirstDigit = 10;
        constexpr quint32 kBracketLeft = 34;
#endif
        if (code >= kFirstDigit && code < kFirstDigit + kDigits)
            return digitKey(static_cast<int>(code - kFirstDigit) + 1);
        if (code == kBracketLeft)
            return PhysicalKey::BracketLeft;
        if (code == kBracketLeft + 1)
            return PhysicalKey::BracketRight;
        return PhysicalKey::Other;
    }
    if (event.key() >= Qt::Key_1 && event.key() <= Qt::Key_9)
        return digitKey(event.key() - Qt::Key_1 + 1);
    if (event.key() == Qt::Key_0)
        return PhysicalKey::Digit0;
    if (event.key() == Qt::Key_BracketLeft)
        return PhysicalKey::BracketLeft;
    if (event.key() == Qt::Key_BracketRight)
        return PhysicalKey::BracketRight;
    return PhysicalKey::Other;
}

Qt::Key usualKey(PhysicalKey key)
{
    if (key == PhysicalKey::BracketLeft)
        return Qt::Key_BracketLeft;
    if (key == PhysicalKey::BracketRight)
        return Qt::Key_BracketRight;
    const int digit = digitOf(key);
    return digit > 0 ? static_cast<Qt::Key>(Qt::Key_0 + digit % kDigits) : Qt::Key_unknown;
}

PhysicalKey digitKey(int number)
{
    return number >= 1 && number <= kDigits
               ? static_cast<PhysicalKey>(static_cast<int>(PhysicalKey::Digit1) + number - 1)
               : PhysicalKey::Other;
}

int digitOf(PhysicalKey key)
{
    return key >= PhysicalKey::Digit1 && key <= PhysicalKey::Digit0
               ? static_cast<int>(key) - static_cast<int>(PhysicalKey::Digit1) + 1
               : 0;
}

} // namespace hairpaint::app
