// The renderer's reasons: see the header.
#include "view/head_area/gl_problem.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace hairpaint::view {

namespace {

/// As view/rendering has them; a test compares.
constexpr std::array kReasons = {
    QT_TRANSLATE_NOOP("Rendering", "EGL is not installed."),
    QT_TRANSLATE_NOOP("Rendering", "EGL offers no OpenGL 4.3 context without a display."),
    QT_TRANSLATE_NOOP("Rendering", "The OpenGL driver refuses to draw."),
    QT_TRANSLATE_NOOP("Rendering", "Windows offers no OpenGL 4.3 context."),
};
constexpr const char* kTooOld = QT_TRANSLATE_NOOP("Rendering", "OpenGL 4.3 is needed; this driver has %1.");

} // namespace

QString glProblem(const std::string& english)
{
    if (std::ranges::find(kReasons, english) != kReasons.end())
        return QCoreApplication::translate("Rendering", english.c_str());
    const QString text = QString::fromStdString(english);
    const QString tooOld = QLatin1StringView(kTooOld).chopped(3);
    if (text.startsWith(tooOld))
        return QCoreApplication::translate("Rendering", kTooOld).arg(text.mid(tooOld.size()).chopped(1));
    return text;
}

} // namespace hairpaint::view
