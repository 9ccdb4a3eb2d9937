// Line drawings coloured as they are rendered.
#include "view/look/icons.h"

#include "view/look/icon_drawing.h"
#include "view/look/resources.h"
#include "view/look/theme.h"

#include <QDir>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>

namespace hairpaint::view {

namespace {

QString pathOf(const QString& name)
{
    return QStringLiteral(":/icons/%1.svg").arg(name);
}

QPixmap render(const QString& name, QSize pixels, const QColor& colour)
{
    const QString key =
        QStringLiteral("hairpaint-icon/%1/%2/%3").arg(name).arg(pixels.width()).arg(colour.rgba(), 8, 16);
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap))
        return pixmap;
    initResources();
    pixmap = QPixmap(pixels);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    drawIcon(painter, hasIcon(name) ? name : QStringLiteral("dot"), colour);
    painter.end();
    QPixmapCache::insert(key, pixmap);
    return pixmap;
}

/// Asks for the theme each time it paints, so that icons need not be made anew when the theme changes.
class IconEngine : public QIconEngine
{
public:
    IconEngine(QString name, QColor Theme::*on) : m_name(std::move(name)), m_on(on) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override
    {
        const qreal ratio = painter->device() != nullptr ? painter->device()->devicePixelRatio() : 1.0;
        painter->drawPixmap(rect, pixmap((QSizeF(rect.size()) * ratio).toSize(), mode, state));
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        return render(m_name, size, colour(mode, state));
    }
    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State state, qreal /*scale*/) override
    {
        return pixmap(size, mode, state);
    }
    QIconEngine* clone() const override { return new IconEngine(m_name, m_on); }
    QString key() const override { return QStringLiteral("hairpaint"); }
    QString iconName() override { return m_name; }
    bool isNull() override { return false; }

private:
    [[nodiscard]] QColor colour(QIcon::Mode mode, QIcon::State state) const
    {
        const Theme theme = Theme::current();
        if (mode == QIcon::Disabled) {
            QColor dim = theme.dimText;
            dim.setAlphaF(0.5F);
            return dim;
        }
        return state == QIcon::On ? theme.*m_on : theme.text;
    }

    QString m_name;
    QColor Theme::*m_on; ///< The colour while it is on.
};

} // namespace

bool hasIcon(const QString& name)
{
    initResources();
    return QFile::exists(pathOf(name));
}

QIcon icon(const QString& name)
{
    return QIcon(new IconEngine(name, &Theme::onAccent));
}

QIcon switchIcon(const QString& name)
{
    return QIcon(new IconEngine(name, &Theme::accent));
}

QPixmap iconPixmap(const QString& name, int side, const QColor& colour, qreal pixelRatio)
{
    const int pixels = qRound(side * pixelRatio);
    QPixmap pixmap = render(name, QSize(pixels, pixels), colour);
    pixmap.setDevicePixelRatio(pixelRatio);
    return pixmap;
}

QStringList iconNames()
{
    initResources();
    QStringList names;
    for (const QString& file : QDir(QStringLiteral(":/icons")).entryList({QStringLiteral("*.svg")}, QDir::Files))
        names.append(file.chopped(4));
    names.sort();
    return names;
}

} // namespace hairpaint::view
