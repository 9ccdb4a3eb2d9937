// One style of the strip.
#include "view/panels/style_tile.h"

#include "view/look/icons.h"
#include "view/look/theme.h"
#include "view/widgets/colour_math.h"

#include <QContextMenuEvent>
#include <QCursor>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr int kMenu = 22; ///< Side of the menu's button.

} // namespace

StyleTile::StyleTile(const QString& path, const QString& name, bool own, QWidget* parent)
    : QAbstractButton(parent), m_path(path), m_own(own)
{
    setText(name);
    setAccessibleName(name);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAttribute(Qt::WA_Hover);
    setMouseTracking(true);
    connect(this, &QAbstractButton::clicked, this, [this] { Q_EMIT chosen(std::exchange(m_modifiers, {})); });
    if (m_path.isEmpty())
        return;
    m_star = addCornerButton(QStringLiteral("star"), 4);
    m_star->setObjectName(QStringLiteral("styleStar"));
    connect(m_star, &QToolButton::clicked, this, [this] { Q_EMIT favouriteWanted(!m_favourite); });
    setFavourite(false);
    m_about = addCornerButton(QStringLiteral("about"), kPicture - 2 * kMenu - 4);
    m_about->setObjectName(QStringLiteral("styleAbout"));
    m_about->setToolTip(tr("About this style (Space)"));
    m_about->setAccessibleName(tr("About %1").arg(name));
    connect(m_about, &QToolButton::clicked, this, [this] { Q_EMIT ordered(StyleOrder::About); });
    m_menu = addCornerButton(QStringLiteral("chevron-down"), kPicture - kMenu - 2);
    m_menu->setObjectName(QStringLiteral("styleMenu"));
    m_menu->setToolTip(tr("Take a part of this style, and more"));
    m_menu->setAccessibleName(tr("Parts of %1").arg(name));
    connect(m_menu, &QToolButton::clicked, this,
            [this] { Q_EMIT menuWanted(m_menu->mapToGlobal(QPoint(0, m_menu->height()))); });
}

QToolButton* StyleTile::addCornerButton(const QString& icon, int left)
{
    auto* button = new QToolButton(this);
    button->setIcon(view::icon(icon));
    button->setIconSize(QSize(kMenu - 6, kMenu - 6));
    button->setFocusPolicy(Qt::NoFocus); // By key there are the context menu's and the tile's own.
    button->setGeometry(left, 6, kMenu, kMenu);
    button->hide();
    return button;
}

void StyleTile::setFavourite(bool favourite)
{
    m_favourite = favourite;
    if (m_star == nullptr)
        return;
    m_star->setIcon(view::icon(favourite ? QStringLiteral("star-on") : QStringLiteral("star")));
    const QString key = QKeySequence(kFavouriteKey).toString(QKeySequence::NativeText);
    m_star->setToolTip((favourite ? tr("No favourite any more (%1)") : tr("A favourite (%1)")).arg(key));
    m_star->setAccessibleName(favourite ? tr("%1 is a favourite").arg(text()) : tr("Make %1 a favourite").arg(text()));
    setAccessibleDescription(favourite ? tr("Favourite") : QString());
    refresh();
}

void StyleTile::setPicture(const QImage& picture)
{
    m_picture = picture;
    update();
}

void StyleTile::setBusy(bool busy)
{
    if (busy == m_busy)
        return;
    m_busy = busy;
    update();
}

void StyleTile::setShown(bool shown)
{
    m_shown = shown;
    refresh();
}

bool StyleTile::isUnderPointer() const
{
    return rect().contains(mapFromGlobal(QCursor::pos()));
}

bool StyleTile::isMarked() const
{
    return m_shown || hasFocus() || (underMouse() && isUnderPointer());
}

void StyleTile::refresh()
{
    for (QToolButton* button : {m_menu, m_about})
        if (button != nullptr)
            button->setVisible(isMarked());
    if (m_star != nullptr)
        m_star->setVisible(m_favourite || isMarked());
    update();
}

void StyleTile::mouseMoveEvent(QMouseEvent* event)
{
    Q_EMIT pointerMoved();
    QAbstractButton::mouseMoveEvent(event);
}

void StyleTile::mouseReleaseEvent(QMouseEvent* event)
{
    m_modifiers = event->modifiers();
    QAbstractButton::mouseReleaseEvent(event);
}

bool StyleTile::takesKey(const QKeyEvent& event) const
{
    return !m_path.isEmpty() &&
           (event.keyCombination() == kFavouriteKey ||
            std::ranges::find(styleOrders(), event.keyCombination(), &StyleOrderSpec::key) != styleOrders().end());
}

bool StyleTile::event(QEvent* event)
{
    // Else Delete would clear what is painted, and F2 would hide an area.
    if (event->type() == QEvent::ShortcutOverride && takesKey(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QAbstractButton::event(event);
}

void StyleTile::keyPressEvent(QKeyEvent* event)
{
    if (takesKey(*event)) {
        const QKeyCombination key = event->keyCombination();
        if (key == kFavouriteKey)
            return Q_EMIT favouriteWanted(!m_favourite);
        const auto spec = std::ranges::find(styleOrders(), key, &StyleOrderSpec::key);
        if (m_own || !spec->ofOwn)
            Q_EMIT ordered(spec->order);
        return;
    }
    if (event->key() == Qt::Key_Space && !m_path.isEmpty()) // Return puts it on.
        Q_EMIT ordered(StyleOrder::About);
    else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        Q_EMIT chosen(event->modifiers() & ~Qt::KeypadModifier);
    else
        QAbstractButton::keyPressEvent(event);
}

void StyleTile::keyReleaseEvent(QKeyEvent* event)
{
    m_modifiers = event->modifiers();
    QAbstractButton::keyReleaseEvent(event);
}

void StyleTile::contextMenuEvent(QContextMenuEvent* event)
{
    if (m_path.isEmpty())
        return;
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    Q_EMIT menuWanted(byKey ? mapToGlobal(QPoint(kPicture / 2, kPicture / 2)) : event->globalPos());
}

void StyleTile::focusInEvent(QFocusEvent* event)
{
    QAbstractButton::focusInEvent(event);
    refresh();
}

void StyleTile::focusOutEvent(QFocusEvent* event)
{
    QAbstractButton::focusOutEvent(event);
    refresh();
}

void StyleTile::enterEvent(QEnterEvent* event)
{
    refresh();
    Q_EMIT entered();
    QAbstractButton::enterEvent(event);
}

void StyleTile::leaveEvent(QEvent* event)
{
    refresh();
    Q_EMIT left();
    QAbstractButton::leaveEvent(event);
}

void StyleTile::paintEvent(QPaintEvent* /*event*/)
{
    const Theme theme = Theme::current();
    const qreal ratio = devicePixelRatioF();
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QRectF picture(2.0, 2.0, kPicture, kPicture);
    QPainterPath frame;
    frame.addRoundedRect(picture, 6.0, 6.0);
    painter.fillPath(frame, m_path.isEmpty() ? theme.panel : theme.raised);
    const auto drawIcon = [&](const QString& name, const QColor& colour) {
        painter.drawPixmap(QPointF(picture.center().x() - 16.0, picture.center().y() - 16.0),
                           iconPixmap(name, 32, colour, ratio));
    };
    if (m_path.isEmpty()) {
        drawIcon(QStringLiteral("style-add"), theme.text);
    } else if (m_picture.isNull()) {
        drawIcon(QStringLiteral("hair"), mixed(theme.raised, theme.dimText, 0.7));
    } else {
        painter.save();
        painter.setClipPath(frame);
        const QSizeF size = QSizeF(m_picture.size()).scaled(picture.size(), Qt::KeepAspectRatioByExpanding);
        painter.drawImage(QRectF(picture.center().x() - size.width() / 2.0, picture.center().y() - size.height() / 2.0,
                                 size.width(), size.height()),
                          m_picture);
        painter.restore();
    }
    const bool marked = isMarked();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(m_path.isEmpty() ? QPen(marked ? theme.accent : theme.dimText, marked ? 2.0 : 1.0, Qt::DashLine)
                                    : QPen(marked ? theme.accent : theme.line, marked ? 2.0 : 1.0));
    painter.drawPath(frame);
    painter.setFont(themeFont(TextRole::Status));
    painter.setPen(marked ? theme.text : theme.dimText);
    const QRectF caption(2.0, picture.bottom() + 4.0, kPicture, 16.0);
    const QString words = m_busy ? tr("Loading…") : text();
    painter.drawText(caption, Qt::AlignCenter,
                     painter.fontMetrics().elidedText(words, Qt::ElideRight, static_cast<int>(caption.width())));
}

} // namespace hairpaint::view
