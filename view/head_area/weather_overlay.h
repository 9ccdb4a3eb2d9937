// The paper's keys for wind and light, as a translucent panel in the 3D area that says what they do.
#pragma once

#include "model/project/project.h"
#include "view/look/theme.h"

#include <QBasicTimer>
#include <QWidget>

namespace hairpaint::view {

/// Arrows turn the wind, Page Up and Page Down strengthen it, R, G and B raise the light's colour, with Shift they
/// lower it, Esc leaves. Keys for one of the two, pressed within a second of each other, are one undo step; leaving the
/// panel ends it.
class WeatherOverlay : public QWidget
{
    Q_OBJECT
public:
    explicit WeatherOverlay(const Theme& theme, QWidget* parent);

    void setTheme(const Theme& theme);
    /// The document's present values. Others than those of an unfinished change end it: somebody took it back.
    void setValues(const sim::Wind& wind, const model::LightSettings& light);
    /// Handles a key of ours; false leaves it to others.
    bool handleKey(int key, Qt::KeyboardModifiers modifiers);
    [[nodiscard]] static bool isOurKey(int key);
    /// Ends an unfinished change.
    void settle();
    /// How long no key is pressed until a change ends by itself; a second unless set.
    void setPause(int milliseconds) { m_pauseMs = milliseconds; }
    [[nodiscard]] bool pausing() const { return m_pause.isActive(); } ///< Whether that time is running.

    [[nodiscard]] QSize sizeHint() const override;

Q_SIGNALS:
    /// Slots may call setValues(), so the values are the slots' own.
    void windWanted(hairpaint::sim::Wind wind, bool done);
    void lightWanted(hairpaint::model::LightSettings light, bool done);
    void leaveWanted();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void timerEvent(QTimerEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    bool turnWind(int key);
    bool strengthenWind(int key);
    void tintLight(int key, bool lower);
    [[nodiscard]] QFont bodyFont() const;
    [[nodiscard]] QList<std::pair<QString, QString>> rows() const; ///< Keys and what they do.
    void paintDial(QPainter& painter, const QRectF& bounds) const;

    Theme m_theme;
    sim::Wind m_wind;
    model::LightSettings m_light;
    float m_windAzimuthRad = 1.5708F; ///< Where it blows to: around y from +z toward +x; kept while there is no wind.
    float m_windElevationRad = 0.0F;
    bool m_windPending = false;
    bool m_lightPending = false;
    int m_pauseMs = 1000;
    QBasicTimer m_pause;
};

} // namespace hairpaint::view
