// Tiles, wheel and keys: see the header.
#include "view/panels/style_row.h"

#include "view/look/theme.h"
#include "view/panels/style_tile.h"

#include <QApplication>
#include <QCursor>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QWheelEvent>

#include <algorithm>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr int kWheelMs = 350;
constexpr int kTremblePx = 3; ///< A hand on the wheel moves the mouse a little.

} // namespace

StyleRow::StyleRow(QWidget* parent) : QScrollArea(parent)
{
    setWidgetResizable(true);
    setFocusPolicy(Qt::NoFocus);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFrameShape(QFrame::NoFrame);
    auto* content = new QWidget(this);
    content->setObjectName(QStringLiteral("panel"));
    m_row = new QHBoxLayout(content);
    m_row->setContentsMargins(metrics::kGap, 0, metrics::kGap, 0);
    m_row->setSpacing(metrics::kGrid);
    m_row->setAlignment(Qt::AlignVCenter | Qt::AlignLeft);
    m_sign = new QWidget(content);
    auto* sign = new QHBoxLayout(m_sign);
    sign->setSpacing(metrics::kPadding);
    m_sentence = new QLabel(m_sign);
    m_signButton = new QPushButton(m_sign);
    sign->addWidget(m_sentence);
    sign->addWidget(m_signButton);
    m_sign->hide();
    setWidget(content);
    viewport()->installEventFilter(this);
    horizontalScrollBar()->setAccessibleName(tr("Styles"));
    connect(m_signButton, &QPushButton::clicked, this, &StyleRow::signButtonClicked);
    connect(horizontalScrollBar(), &QScrollBar::valueChanged, this, &StyleRow::contentMoved);
    m_wheelPause.setSingleShot(true);
    m_wheelPause.setInterval(kWheelMs);
    connect(&m_wheelPause, &QTimer::timeout, this, &StyleRow::endScrolling);
}

void StyleRow::setTiles(const std::vector<StyleTile*>& tiles)
{
    const auto* focused = qobject_cast<const StyleTile*>(QApplication::focusWidget());
    const bool hadFocus = focused != nullptr && isAncestorOf(focused);
    const QString focusedPath = hadFocus ? focused->path() : QString();
    while (QLayoutItem* item = m_row->takeAt(0))
        delete item;
    m_shown.clear();
    // First taken from the list: a tile that goes hands the keys on, which asks the others. One may be the sender of
    // what has led here.
    for (StyleTile* old : std::exchange(m_tiles, {})) {
        old->setParent(nullptr);
        old->deleteLater();
    }
    m_tiles = tiles;
    QWidget* before = this;
    for (StyleTile* one : m_tiles) {
        one->setParent(widget());
        setTabOrder(before, one); // Before what else the strip has, since keys are wanted here first.
        before = one;
        follow(one);
    }
    if (!hadFocus || m_tiles.empty())
        return;
    // The keys stay where they were: with the tile that has gone they went to whatever comes next in the window.
    StyleTile* known = tile(focusedPath);
    StyleTile* wanted = known != nullptr ? known : m_tiles.back();
    wanted->show();
    wanted->setFocus(Qt::OtherFocusReason);
}

void StyleRow::follow(StyleTile* tile)
{
    const QString path = tile->path();
    tile->installEventFilter(this);
    connect(tile, &StyleTile::chosen, this,
            [this, path](Qt::KeyboardModifiers modifiers) { Q_EMIT chosen(path, modifiers); });
    if (path.isEmpty())
        return;
    connect(tile, &StyleTile::entered, this, [this, path] {
        if (!isResting())
            pointAt(path);
    });
    connect(tile, &StyleTile::pointerMoved, this, [this, path] {
        if (m_restingAt && !isResting())
            pointAt(path);
    });
    connect(tile, &StyleTile::left, this, [this, path] { Q_EMIT pointerLeft(path); });
    connect(tile, &StyleTile::menuWanted, this,
            [this, tile](const QPoint& position) { Q_EMIT menuWanted(tile, position); });
    connect(tile, &StyleTile::favouriteWanted, this,
            [this, path](bool favourite) { Q_EMIT favouriteWanted(path, favourite); });
    connect(tile, &StyleTile::ordered, this, [this, path](StyleOrder order) { Q_EMIT ordered(path, order); });
}

StyleTile* StyleRow::tile(const QString& path) const
{
    const auto found = std::ranges::find(m_tiles, path, &StyleTile::path);
    return found != m_tiles.end() ? *found : nullptr;
}

void StyleRow::showOnly(const std::vector<QString>& paths)
{
    std::vector<StyleTile*> shown;
    for (const QString& path : paths)
        if (StyleTile* wanted = tile(path))
            shown.push_back(wanted);
    m_sign->hide();
    while (QLayoutItem* item = m_row->takeAt(0))
        delete item;
    for (StyleTile* one : m_tiles)
        if (std::ranges::find(shown, one) == shown.end())
            one->hide();
    for (StyleTile* one : shown) {
        m_row->addWidget(one);
        one->show();
    }
    if (shown != m_shown)
        horizontalScrollBar()->setValue(0);
    m_shown = std::move(shown);
    const auto* focused = qobject_cast<StyleTile*>(QApplication::focusWidget());
    const auto had = std::ranges::find(m_shown, focused);
    if (!m_shown.empty())
        letTabStopAt(had != m_shown.end() ? *had : m_shown.front());
}

std::vector<QString> StyleRow::shownPaths() const
{
    std::vector<QString> paths;
    paths.reserve(m_shown.size());
    for (const StyleTile* one : m_shown)
        paths.push_back(one->path());
    return paths;
}

void StyleRow::showSign(const QString& sentence, const QString& button)
{
    showOnly({});
    m_sentence->setText(sentence);
    m_signButton->setText(button);
    m_signButton->setVisible(!button.isEmpty());
    m_row->addWidget(m_sign);
    m_sign->show();
}

bool StyleRow::takeKeys()
{
    const auto stop = std::ranges::find(m_shown, Qt::TabFocus, &QWidget::focusPolicy);
    if (stop != m_shown.end())
        (*stop)->setFocus(Qt::ShortcutFocusReason);
    else if (m_signButton->isVisible())
        m_signButton->setFocus(Qt::ShortcutFocusReason);
    return stop != m_shown.end();
}

void StyleRow::letTabStopAt(StyleTile* tile)
{
    for (StyleTile* one : m_tiles)
        one->setFocusPolicy(one == tile ? Qt::TabFocus : Qt::NoFocus);
}

bool StyleRow::moveKeys(const StyleTile* from, int key)
{
    const auto at = std::ranges::find(m_shown, from);
    if (at == m_shown.end())
        return false;
    const bool isMirrored = layoutDirection() == Qt::RightToLeft;
    auto wanted = at;
    if (key == Qt::Key_Home)
        wanted = m_shown.begin();
    else if (key == Qt::Key_End)
        wanted = std::prev(m_shown.end());
    else if ((key == Qt::Key_Right) != isMirrored)
        wanted = std::next(at) != m_shown.end() ? std::next(at) : at;
    else
        wanted = at != m_shown.begin() ? std::prev(at) : at;
    (*wanted)->setFocus(Qt::OtherFocusReason);
    return true;
}

bool StyleRow::isResting() const
{
    return m_restingAt && (QCursor::pos() - *m_restingAt).manhattanLength() <= kTremblePx;
}

void StyleRow::stopResting()
{
    m_restingAt.reset();
    m_wheelPause.stop();
}

void StyleRow::pointAt(const QString& path)
{
    stopResting();
    Q_EMIT pointedAt(path);
}

void StyleRow::contentMoved()
{
    m_restingAt = QCursor::pos();
    Q_EMIT moved();
    for (StyleTile* one : m_tiles)
        one->refresh();
}

void StyleRow::wheel(const QWheelEvent& event)
{
    const QPoint angle = event.angleDelta();
    QScrollBar* bar = horizontalScrollBar();
    contentMoved(); // First: moving pictures are entered and left at once.
    bar->setValue(bar->value() - (angle.x() != 0 ? angle.x() : angle.y()));
    if (event.phase() == Qt::ScrollEnd)
        endScrolling();
    else
        m_wheelPause.start();
}

void StyleRow::endScrolling()
{
    m_wheelPause.stop();
    QWidget* under = childAt(mapFromGlobal(QCursor::pos()));
    while (under != nullptr && qobject_cast<StyleTile*>(under) == nullptr)
        under = under == this ? nullptr : under->parentWidget();
    const auto* found = qobject_cast<StyleTile*>(under);
    if (found == nullptr || found->path().isEmpty())
        return;
    Q_EMIT rested(found->path());
}

bool StyleRow::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == viewport() && event->type() == QEvent::Wheel) {
        wheel(*static_cast<QWheelEvent*>(event));
        return true;
    }
    auto* tile = qobject_cast<StyleTile*>(watched);
    if (tile != nullptr && event->type() == QEvent::FocusIn) {
        letTabStopAt(tile);
        ensureWidgetVisible(tile);
    } else if (tile != nullptr && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        switch (key->key()) {
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Home:
        case Qt::Key_End:
            return moveKeys(tile, key->key());
        case Qt::Key_Up:
            Q_EMIT upWanted();
            return true;
        case Qt::Key_Down:
            return true;
        default:
            break;
        }
    }
    return QScrollArea::eventFilter(watched, event);
}

} // namespace hairpaint::view
