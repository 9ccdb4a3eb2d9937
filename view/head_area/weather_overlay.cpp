// Keys, values and look of the Weather overlay.
#include "view/head_area/weather_overlay.h"

#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QTimerEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hairpaint::view {

namespace {

constexpr float kTurnRad = std::numbers::pi_v<float> / 12.0F;
constexpr float kMostElevationRad = std::numbers::pi_v<float> / 2.0F;
constexpr float kStrengthStep = 0.5F; ///< m/s
constexpr float kGreatestStrength = 30.0F;
constexpr float kColourStep = 0.05F;
constexpr int kPadding = 12;
constexpr int kRow = 20;
constexpr int kDial = 44;
constexpr int kGap = 12;

glm::vec3 directionOf(float azimuthRad, float elevationRad)
{
    return {std::sin(azimuthRad) * std::cos(elevationRad), std::sin(elevationRad),
            std::cos(azimuthRad) * std::cos(elevationRad)};
}

QString number(float value, int decimals)
{
    return QLocale().toString(static_cast<double>(value), 'f', decimals);
}

} // namespace

WeatherOverlay::WeatherOverlay(const Theme& theme, QWidget* parent) : QWidget(parent), m_theme(theme)
{
    setObjectName(QStringLiteral("weatherOverlay"));
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Weather"));
}

void WeatherOverlay::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

QFont WeatherOverlay::bodyFont() const
{
    QFont body = font();
    body.setPixelSize(12);
    return body;
}

QList<std::pair<QString, QString>> WeatherOverlay::rows() const
{
    return {
        {tr("Arrows"), tr("turn the wind")},
        {tr("Page Up, Page Down"),
         m_wind.enabled ? tr("wind %1 m/s").arg(number(glm::length(m_wind.velocity), 1)) : tr("wind is off")},
        {tr("R  G  B"), tr("more red, green, blue light")},
        {tr("Shift+R  G  B"), tr("less")},
        {tr("Esc"), tr("leaves")},
    };
}

QSize WeatherOverlay::sizeHint() const
{
    const QFontMetrics metrics(bodyFont());
    int keys = 0;
    int meanings = 0;
    for (const auto& [key, meaning] : rows()) {
        keys = std::max(keys, metrics.horizontalAdvance(key));
        meanings = std::max(meanings, metrics.horizontalAdvance(meaning));
    }
    return {2 * kPadding + keys + kGap + meanings + kGap + kDial, 2 * kPadding + 6 * kRow + 4};
}

void WeatherOverlay::setValues(const sim::Wind& wind, const model::LightSettings& light)
{
    if (wind != m_wind) {
        m_windPending = false;
        m_wind = wind;
        const float speed = glm::length(wind.velocity);
        if (speed > 1e-4F) {
            m_windAzimuthRad = std::atan2(wind.velocity.x, wind.velocity.z);
            m_windElevationRad = std::asin(std::clamp(wind.velocity.y / speed, -1.0F, 1.0F));
        }
    }
    if (light != m_light) {
        m_lightPending = false;
        m_light = light;
    }
    update();
}

bool WeatherOverlay::isOurKey(int key)
{
    static constexpr std::array<int, 10> kKeys = {Qt::Key_Left,   Qt::Key_Right,    Qt::Key_Up, Qt::Key_Down,
                                                  Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_R,  Qt::Key_G,
                                                  Qt::Key_B,      Qt::Key_Escape};
    return std::ranges::find(kKeys, key) != kKeys.end();
}

bool WeatherOverlay::handleKey(int key, Qt::KeyboardModifiers modifiers)
{
    if (!isOurKey(key) || modifiers.testFlag(Qt::ControlModifier) || modifiers.testFlag(Qt::AltModifier))
        return false;
    if (key == Qt::Key_Escape) {
        settle();
        Q_EMIT leaveWanted();
        return true;
    }
    // One of the two is being changed at a time: a preview shows only one change.
    const bool tints = key == Qt::Key_R || key == Qt::Key_G || key == Qt::Key_B;
    if (tints ? m_windPending : m_lightPending)
        settle();
    if (tints) {
        tintLight(key, modifiers.testFlag(Qt::ShiftModifier));
        m_lightPending = true;
        Q_EMIT lightWanted(m_light, false);
    } else if (turnWind(key) || strengthenWind(key)) {
        m_windPending = true;
        Q_EMIT windWanted(m_wind, false);
    }
    m_pause.start(m_pauseMs, this);
    update();
    return true;
}

bool WeatherOverlay::turnWind(int key)
{
    const float speed = glm::length(m_wind.velocity);
    switch (key) {
    case Qt::Key_Left:
        m_windAzimuthRad -= kTurnRad;
        break;
    case Qt::Key_Right:
        m_windAzimuthRad += kTurnRad;
        break;
    case Qt::Key_Up:
        m_windElevationRad = std::min(kMostElevationRad, m_windElevationRad + kTurnRad);
        break;
    case Qt::Key_Down:
        m_windElevationRad = std::max(-kMostElevationRad, m_windElevationRad - kTurnRad);
        break;
    default:
        return false;
    }
    m_wind.velocity = directionOf(m_windAzimuthRad, m_windElevationRad) * speed;
    return true;
}

bool WeatherOverlay::strengthenWind(int key)
{
    if (key != Qt::Key_PageUp && key != Qt::Key_PageDown)
        return false;
    const float step = key == Qt::Key_PageUp ? kStrengthStep : -kStrengthStep;
    const float speed = std::clamp(glm::length(m_wind.velocity) + step, 0.0F, kGreatestStrength);
    m_wind.velocity = directionOf(m_windAzimuthRad, m_windElevationRad) * speed;
    m_wind.enabled = m_wind.enabled || key == Qt::Key_PageUp;
    return true;
}

void WeatherOverlay::tintLight(int key, bool lower)
{
    float& channel = key == Qt::Key_R ? m_light.red : key == Qt::Key_G ? m_light.green : m_light.blue;
    channel = std::clamp(channel + (lower ? -kColourStep : kColourStep), 0.0F, 1.0F);
}

void WeatherOverlay::settle()
{
    m_pause.stop();
    if (std::exchange(m_windPending, false))
        Q_EMIT windWanted(m_wind, true);
    if (std::exchange(m_lightPending, false))
        Q_EMIT lightWanted(m_light, true);
}

bool WeatherOverlay::event(QEvent* event)
{
    // B and G are tools elsewhere; while this panel has the focus they are its own.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (isOurKey(key->key()) && (key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == 0) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::FocusOut)
        settle();
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut)
        update();
    return QWidget::event(event);
}

void WeatherOverlay::keyPressEvent(QKeyEvent* event)
{
    if (!handleKey(event->key(), event->modifiers()))
        QWidget::keyPressEvent(event);
}

void WeatherOverlay::timerEvent(QTimerEvent* event)
{
    if (event->timerId() == m_pause.timerId())
        settle();
    else
        QWidget::timerEvent(event);
}

void WeatherOverlay::hideEvent(QHideEvent* event)
{
    settle();
    QWidget::hideEvent(event);
}

void WeatherOverlay::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor ground = m_theme.panel;
    ground.setAlpha(225);
    painter.setPen(QPen(m_theme.line, 1.0));
    painter.setBrush(ground);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);

    QFont titleFont = font();
    titleFont.setPixelSize(15);
    titleFont.setWeight(QFont::DemiBold);
    const QRect inner = rect().adjusted(kPadding, kPadding, -kPadding, -kPadding);
    painter.setFont(titleFont);
    painter.setPen(m_theme.text);
    painter.drawText(inner, Qt::AlignLeft | Qt::AlignTop, tr("Weather"));
    painter.setFont(bodyFont());

    const QFontMetrics metrics(bodyFont());
    int keyWidth = 0;
    for (const auto& [keys, meaning] : rows())
        keyWidth = std::max(keyWidth, metrics.horizontalAdvance(keys));
    int y = inner.top() + kRow + 4;
    for (const auto& [keys, meaning] : rows()) {
        painter.setPen(m_theme.accent);
        painter.drawText(QRect(inner.left(), y, keyWidth, kRow), Qt::AlignLeft | Qt::AlignVCenter, keys);
        painter.setPen(m_theme.text);
        painter.drawText(QRect(inner.left() + keyWidth + kGap, y, inner.width(), kRow),
                         Qt::AlignLeft | Qt::AlignVCenter, meaning);
        y += kRow;
    }
    const QRectF dial(inner.right() - kDial, inner.top(), kDial, kDial);
    paintDial(painter, dial);
    const QColor light = QColor::fromRgbF(std::sqrt(m_light.red), std::sqrt(m_light.green), std::sqrt(m_light.blue));
    painter.setPen(QPen(m_theme.line, 1.0));
    painter.setBrush(light);
    painter.drawRoundedRect(QRectF(dial.left(), dial.bottom() + 14.0, kDial, 16.0), 4.0, 4.0);
}

void WeatherOverlay::paintDial(QPainter& painter, const QRectF& bounds) const
{
    // From above, the face downward; the needle points where the wind blows to.
    painter.setPen(QPen(m_theme.line, 1.5));
    painter.setBrush(m_theme.raised);
    painter.drawEllipse(bounds);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_theme.dimText, 1.5));
    const QPointF middle = bounds.center();
    painter.drawEllipse(middle, 6.0, 7.0);
    painter.drawLine(middle + QPointF(-2.0, 6.5), middle + QPointF(0.0, 9.5));
    painter.drawLine(middle + QPointF(2.0, 6.5), middle + QPointF(0.0, 9.5));
    const bool blows = m_wind.enabled && glm::length(m_wind.velocity) > 0.0F;
    painter.setPen(QPen(blows ? m_theme.accent : m_theme.dimText, 2.0, Qt::SolidLine, Qt::RoundCap));
    const double flat = std::cos(static_cast<double>(m_windElevationRad));
    const QPointF toward(std::sin(static_cast<double>(m_windAzimuthRad)) * flat,
                         std::cos(static_cast<double>(m_windAzimuthRad)) * flat);
    const double radius = bounds.width() / 2.0 - 4.0;
    const QPointF tip = middle + toward * radius;
    const QPointF side(-toward.y(), toward.x());
    painter.drawLine(middle - toward * radius, tip);
    painter.drawLine(tip, tip - toward * 7.0 + side * 4.0);
    painter.drawLine(tip, tip - toward * 7.0 - side * 4.0);
}

} // namespace hairpaint::view
