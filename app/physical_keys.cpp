// Keys by place: see the header.
#include "app/physical_keys.h"

namespace hairpaint::app {

namespace {

PhysicalKey digit(int number)
{
    return static_cast<PhysicalKey>(static_cast<int>(PhysicalKey::Digit1) + number - 1);
}

} // namespace

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
        if (code >= kFirstDigit && code < kFirstDigit + 9)
            return digit(static_cast<int>(code - kFirstDigit) + 1);
        if (code == kBracketLeft)
            return PhysicalKey::BracketLeft;
        if (code == kBracketLeft + 1)
            return PhysicalKey::BracketRight;
        return PhysicalKey::Other;
    }
    if (event.key() >= Qt::Key_1 && event.key() <= Qt::Key_9)
        return digit(event.key() - Qt::Key_1 + 1);
    if (event.key() == Qt::Key_BracketLeft)
        return PhysicalKey::BracketLeft;
    if (event.key() == Qt::Key_BracketRight)
        return PhysicalKey::BracketRight;
    return PhysicalKey::Other;
}

int digitOf(PhysicalKey key)
{
    return key >= PhysicalKey::Digit1 && key <= PhysicalKey::Digit9
               ? static_cast<int>(key) - static_cast<int>(PhysicalKey::Digit1) + 1
               : 0;
}

} // namespace hairpaint::app
