#include "view/look/title_bar.h"

#include <QtGlobal>

#ifdef Q_OS_WIN

#include "view/look/theme.h"

#include <QApplication>
#include <QEvent>
#include <QPointer>
#include <QWidget>

#include <windows.h>

#include <dwmapi.h>

namespace hairpaint::view {

namespace {

void darken(const QWidget& window, bool dark)
{
    constexpr DWORD kUseImmersiveDarkMode = 20; // DWMWA_USE_IMMERSIVE_DARK_MODE, which older headers lack.
    const BOOL value = dark ? TRUE : FALSE;
    // Windows before 10 20H1 refuses it, and keeps its light bar.
    DwmSetWindowAttribute(reinterpret_cast<HWND>(window.winId()), kUseImmersiveDarkMode, &value, sizeof value);
}

/// Windows are told when they are shown: before that the system has none.
class TitleBars : public QObject
{
public:
    using QObject::QObject;

    void setDark(bool dark)
    {
        m_isDark = dark;
        const QWidgetList windows = QApplication::topLevelWidgets();
        for (const QWidget* window : windows)
            if (window->isVisible())
                darken(*window, dark);
    }

    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::Show && watched->isWidgetType())
            if (const auto* widget = static_cast<QWidget*>(watched); widget->isWindow())
                darken(*widget, m_isDark);
        return false;
    }

private:
    bool m_isDark = false;
};

} // namespace

void matchTitleBars(QApplication& application, ThemeKind kind)
{
    static QPointer<TitleBars> bars;
    if (!bars) {
        bars = new TitleBars(&application);
        application.installEventFilter(bars);
    }
    bars->setDark(kind == ThemeKind::Dark);
}

} // namespace hairpaint::view

#else

namespace hairpaint::view {

void matchTitleBars(QApplication& /*application*/, ThemeKind /*kind*/) {}

} // namespace hairpaint::view

#endif
