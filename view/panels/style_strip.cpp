// Hairstyles side by side.
#include "view/panels/style_strip.h"

#include "model/values/names.h"
#include "view/look/theme.h"
#include "view/panels/style_fitting.h"
#include "view/panels/style_question.h"
#include "view/panels/style_tile.h"

#include <QApplication>
#include <QCursor>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QWheelEvent>

#include <algorithm>
#include <utility>

namespace hairpaint::view {

using model::StylePart;

namespace {

constexpr int kHoverMs = 120;
constexpr int kWheelMs = 350;
constexpr int kTremblePx = 3; ///< A hand on the wheel moves the mouse a little.

StylePart partOf(Qt::KeyboardModifiers modifiers)
{
    return modifiers.testFlag(Qt::ShiftModifier) ? StylePart::Colour : StylePart::All;
}

} // namespace

StyleStrip::StyleStrip(EditorState& state, Loader loader, Start start, QWidget* parent)
    : QWidget(parent), m_state(state), m_shelf(state.document(), std::move(loader), std::move(start), this)
{
    setObjectName(QStringLiteral("styleStrip"));
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Styles"));
    setFixedHeight(metrics::kStyleStrip);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 1, 0, 0);
    m_scroll = new QScrollArea(this);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFrameShape(QFrame::NoFrame);
    auto* content = new QWidget(m_scroll);
    content->setObjectName(QStringLiteral("panel"));
    m_row = new QHBoxLayout(content);
    m_row->setContentsMargins(metrics::kGap, 0, metrics::kGap, 0);
    m_row->setSpacing(metrics::kGrid);
    m_row->setAlignment(Qt::AlignVCenter);
    m_scroll->setWidget(content);
    m_scroll->viewport()->installEventFilter(this);
    m_scroll->horizontalScrollBar()->setAccessibleName(tr("Styles"));
    connect(m_scroll->horizontalScrollBar(), &QScrollBar::valueChanged, this, &StyleStrip::contentMoved);
    layout->addWidget(m_scroll);
    m_question = new StyleQuestion(this);
    m_fitting = new StyleFitting(state, *m_question, this);
    connect(m_fitting, &StyleFitting::asking, this, &StyleStrip::asking);
    connect(m_fitting, &StyleFitting::failed, this, &StyleStrip::failed);
    m_pause.setSingleShot(true);
    m_pause.setInterval(kHoverMs);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        if (m_pointed)
            m_shelf.want(QString(m_pointed->path));
    });
    m_wheelPause.setSingleShot(true);
    m_wheelPause.setInterval(kWheelMs);
    connect(&m_wheelPause, &QTimer::timeout, this, &StyleStrip::endScrolling);
    connect(&m_shelf, &StyleShelf::came, this, &StyleStrip::arrived);
    connect(&m_shelf, &StyleShelf::busyChanged, this, [this](const QString& path, bool busy) {
        if (StyleTile* shown = tile(path))
            shown->setBusy(busy);
    });
    connect(&m_shelf, &StyleShelf::failed, this, [this](const QString& path, const QString& problem) {
        if (m_toCommit && m_toCommit->path == path)
            m_toCommit.reset();
        Q_EMIT failed(problem);
    });
    setEntries({});
}

void StyleStrip::setEntries(const std::vector<model::PresetEntry>& entries)
{
    endPreview();
    const auto* focused = qobject_cast<const StyleTile*>(QApplication::focusWidget());
    const bool hadFocus = focused != nullptr && isAncestorOf(focused);
    const QString focusedPath = hadFocus ? focused->path() : QString();
    while (QLayoutItem* item = m_row->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_tiles.clear();
    m_shelf.forget();
    for (const model::PresetEntry& entry : entries)
        addTile(new StyleTile(entry.path, model::shownName(entry.name), entry.folder == QLatin1String("own"), this),
                entry.picture);
    auto* save = new StyleTile({}, tr("Save style"), false, this);
    save->setToolTip(tr("Save this hair as a style of your own"));
    connect(save, &StyleTile::chosen, this, &StyleStrip::saveStyleRequested);
    m_row->addWidget(save);
    m_row->addStretch(1);
    // The keys stay where they were: with the tile that has gone they went to whatever comes next in the window.
    if (hadFocus) {
        StyleTile* known = tile(focusedPath);
        StyleTile* wanted = known != nullptr ? known : save;
        wanted->show(); // The layout would do so later.
        wanted->setFocus(Qt::OtherFocusReason);
    }
}

void StyleStrip::addTile(StyleTile* tile, const QImage& picture)
{
    tile->setPicture(picture);
    tile->setToolTip(tr("%1. Point to see it, click to keep it; Shift+click takes its colour alone").arg(tile->text()));
    m_row->addWidget(tile);
    m_tiles.push_back(tile);
    followTile(tile);
    // Queued, so that whoever fills the strip can connect first.
    if (picture.isNull())
        QMetaObject::invokeMethod(
            this, [this, path = tile->path()] { Q_EMIT pictureWanted(path); }, Qt::QueuedConnection);
}

void StyleStrip::followTile(StyleTile* tile)
{
    const QString path = tile->path();
    const auto rests = [this] {
        return m_restingAt && (QCursor::pos() - *m_restingAt).manhattanLength() <= kTremblePx;
    };
    connect(tile, &StyleTile::entered, this, [this, path, rests] {
        if (!rests())
            pointAt(path);
    });
    connect(tile, &StyleTile::pointerMoved, this, [this, path, rests] {
        if (m_restingAt && !rests())
            pointAt(path);
    });
    connect(tile, &StyleTile::left, this, [this, path] {
        if (m_pointed && m_pointed->path == path)
            endPreview();
    });
    connect(tile, &StyleTile::chosen, this,
            [this, path](Qt::KeyboardModifiers modifiers) { commitWish({.path = path, .part = partOf(modifiers)}); });
    connect(tile, &StyleTile::menuWanted, this, [this, tile](const QPoint& position) { showMenu(tile, position); });
    tile->installEventFilter(this);
}

void StyleStrip::showMenu(StyleTile* tile, const QPoint& globalPosition)
{
    const QString& path = tile->path();
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const model::StylePartSpec& part : model::styleParts()) {
        const Wish wish{.path = path, .part = part.part};
        QAction* action = menu->addAction(part.titleText());
        if (part.part == StylePart::Colour)
            action->setText(action->text() + QLatin1Char('\t') + tr("Shift+click"));
        connect(action, &QAction::hovered, this, [this, wish] { pointAt(wish); });
        connect(action, &QAction::triggered, this, [this, wish] { commitWish(wish); });
    }
    connect(menu, &QMenu::aboutToHide, this, &StyleStrip::endPreview);
    if (tile->own()) {
        menu->addSeparator();
        menu->addAction(tr("Rename style…"), this, [this, path] { Q_EMIT renameStyleRequested(path); });
        menu->addAction(tr("Delete style"), this, [this, path] { Q_EMIT deleteStyleRequested(path); });
    }
    menu->popup(globalPosition);
}

std::vector<QString> StyleStrip::paths() const
{
    std::vector<QString> all;
    for (const StyleTile* tile : m_tiles)
        all.push_back(tile->path());
    return all;
}

StyleTile* StyleStrip::tile(const QString& path) const
{
    const auto found = std::ranges::find(m_tiles, path, &StyleTile::path);
    return found != m_tiles.end() ? *found : nullptr;
}

void StyleStrip::setPicture(const QString& path, const QImage& picture)
{
    if (StyleTile* found = tile(path))
        found->setPicture(picture);
}

void StyleStrip::pointAt(const QString& path)
{
    m_restingAt.reset();
    m_wheelPause.stop();
    pointAt(Wish{.path = path, .part = partOf(QGuiApplication::keyboardModifiers())});
}

void StyleStrip::pointAt(const Wish& wish)
{
    stopPointing();
    qApp->installEventFilter(this); // Shift goes to whatever has the focus.
    m_pointed = wish;
    if (StyleTile* pointed = tile(wish.path))
        pointed->setShown(true);
    m_pause.start();
}

void StyleStrip::contentMoved()
{
    m_restingAt = QCursor::pos();
    m_pause.stop();
    const StyleTile* pointed = m_pointed ? tile(m_pointed->path) : nullptr;
    if (pointed != nullptr && !pointed->isUnderPointer())
        endPreview();
    for (StyleTile* one : m_tiles)
        one->refresh();
}

void StyleStrip::wheel(const QWheelEvent& event)
{
    const QPoint angle = event.angleDelta();
    QScrollBar* bar = m_scroll->horizontalScrollBar();
    contentMoved(); // First: moving pictures are entered and left at once.
    bar->setValue(bar->value() - (angle.x() != 0 ? angle.x() : angle.y()));
    if (event.phase() == Qt::ScrollEnd)
        endScrolling();
    else
        m_wheelPause.start();
}

void StyleStrip::endScrolling()
{
    m_wheelPause.stop();
    QWidget* under = childAt(mapFromGlobal(QCursor::pos()));
    while (under != nullptr && qobject_cast<StyleTile*>(under) == nullptr)
        under = under == this ? nullptr : under->parentWidget();
    const auto* rested = qobject_cast<StyleTile*>(under);
    const bool isShown = m_fitting->shows() && m_pointed && rested != nullptr && m_pointed->path == rested->path();
    if (rested != nullptr && !rested->path().isEmpty() && !isShown)
        pointAt(rested->path());
}

void StyleStrip::commitWish(const Wish& wish)
{
    m_pause.stop();
    m_toCommit = wish;
    m_shelf.want(wish.path);
}

void StyleStrip::arrived(const QString& path, const PresetPtr& preset)
{
    if (m_toCommit && m_toCommit->path == path)
        apply(preset, std::exchange(m_toCommit, std::nullopt)->part);
    else if (m_pointed && m_pointed->path == path)
        m_fitting->show(preset, m_pointed->part);
}

void StyleStrip::putOn(const PresetPtr& preset)
{
    apply(preset, StylePart::All);
}

void StyleStrip::apply(const PresetPtr& preset, StylePart part)
{
    m_toCommit.reset();
    stopPointing(); // What is shown is kept.
    m_fitting->putOn(preset, part);
}

void StyleStrip::stopPointing()
{
    m_pause.stop();
    const std::optional<Wish> pointed = std::exchange(m_pointed, std::nullopt);
    if (!pointed)
        return;
    qApp->removeEventFilter(this);
    if (StyleTile* left = tile(pointed->path))
        left->setShown(false);
}

void StyleStrip::endPreview()
{
    stopPointing();
    m_fitting->drop();
}

bool StyleStrip::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_scroll->viewport() && event->type() == QEvent::Wheel) {
        wheel(*static_cast<QWheelEvent*>(event));
        return true;
    }
    if (event->type() == QEvent::FocusIn) {
        if (auto* focused = qobject_cast<StyleTile*>(watched))
            m_scroll->ensureWidgetVisible(focused);
    } else if (m_pointed && (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease) &&
               static_cast<QKeyEvent*>(event)->key() == Qt::Key_Shift && QApplication::activePopupWidget() == nullptr) {
        const StylePart part = event->type() == QEvent::KeyPress ? StylePart::Colour : StylePart::All;
        if (part != m_pointed->part)
            pointAt({.path = m_pointed->path, .part = part});
    }
    return QWidget::eventFilter(watched, event);
}

void StyleStrip::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_question->setGeometry(0, height() - m_question->height(), width(), m_question->height());
}

void StyleStrip::hideEvent(QHideEvent* event)
{
    stopPointing();
    m_fitting->dismiss();
    QWidget::hideEvent(event);
}

} // namespace hairpaint::view
