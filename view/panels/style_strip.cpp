// Hairstyles side by side.
#include "view/panels/style_strip.h"

#include "model/values/names.h"
#include "view/look/theme.h"
#include "view/panels/handle_panel.h"
#include "view/panels/style_bar.h"
#include "view/panels/style_fitting.h"
#include "view/panels/style_notice.h"
#include "view/panels/style_question.h"
#include "view/panels/style_row.h"
#include "view/panels/style_tile.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QVBoxLayout>

#include <utility>

namespace hairpaint::view {

using model::StyleFolder;
using model::StylePart;

namespace {

constexpr int kHoverMs = 120;

} // namespace

StyleStrip::StyleStrip(EditorState& state, Loader loader, Start start, QWidget* parent)
    : QWidget(parent), m_state(state), m_shelf(state.document(), std::move(loader), std::move(start), this)
{
    setObjectName(QStringLiteral("styleStrip"));
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Styles"));
    setFixedHeight(metrics::kStyleStrip);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 1, 0, 0);
    layout->setSpacing(0);
    m_row = new StyleRow(this); // First: the keys begin at the pictures.
    m_bar = new StyleBar(this);
    layout->addWidget(m_bar);
    auto* below = new QHBoxLayout;
    below->setSpacing(0);
    below->addWidget(m_row, 1);
    below->addWidget(new HandlePanel(state, this));
    layout->addLayout(below, 1);
    followRow();
    m_notice = new StyleNotice(this);
    connect(m_notice, &StyleNotice::undoChosen, this, &StyleStrip::undoWanted);
    m_question = new StyleQuestion(this);
    m_fitting = new StyleFitting(state, *m_question, this);
    connect(m_bar, &StyleBar::fractionMoved, this, [this] {
        stopPointing();
        m_fitting->setFraction(m_bar->fraction());
    });
    connect(m_bar, &StyleBar::partChosen, m_fitting, &StyleFitting::letGo);
    connect(m_bar, &StyleBar::fractionSet, m_fitting, &StyleFitting::keepFraction);
    connect(m_bar, &StyleBar::fractionTakenBack, this, [this] { m_fitting->takeFractionBack(m_bar->fraction()); });
    connect(m_fitting, &StyleFitting::asking, this, &StyleStrip::asking);
    connect(m_fitting, &StyleFitting::failed, this, &StyleStrip::failed);
    connect(m_fitting, &StyleFitting::kept, this, [this] {
        if (m_putOn.isEmpty())
            return;
        m_list.marks().addRecent(m_putOn);
        Q_EMIT marksChanged(m_list.marks());
    });
    m_pause.setSingleShot(true);
    m_pause.setInterval(kHoverMs);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        if (m_pointed)
            m_shelf.want(QString(m_pointed->path));
    });
    connect(&m_shelf, &StyleShelf::came, this, &StyleStrip::arrived);
    connect(&m_shelf, &StyleShelf::busyChanged, this, [this](const QString& path, bool busy) {
        if (StyleTile* shown = m_row->tile(path))
            shown->setBusy(busy);
    });
    connect(&m_shelf, &StyleShelf::failed, this, [this](const QString& path, const QString& problem) {
        if (m_toCommit && m_toCommit->path == path)
            m_toCommit.reset();
        Q_EMIT failed(problem);
    });
    setEntries({});
}

void StyleStrip::followRow()
{
    connect(m_row, &StyleRow::pointedAt, this, qOverload<const QString&>(&StyleStrip::pointAt));
    connect(m_row, &StyleRow::rested, this, [this](const QString& path) {
        if (!m_fitting->shows() || !m_pointed || m_pointed->path != path)
            pointAt(path);
    });
    connect(m_row, &StyleRow::pointerLeft, this, [this](const QString& path) {
        if (m_pointed && m_pointed->path == path)
            endPreview();
    });
    connect(m_row, &StyleRow::moved, this, &StyleStrip::contentMoved);
    connect(m_row, &StyleRow::chosen, this, [this](const QString& path, Qt::KeyboardModifiers modifiers) {
        if (path.isEmpty())
            Q_EMIT saveStyleRequested();
        else
            commitWish({.path = path, .part = partOf(modifiers)});
    });
    connect(m_row, &StyleRow::menuWanted, this, &StyleStrip::showMenu);
    connect(m_row, &StyleRow::favouriteWanted, this, &StyleStrip::setFavourite);
    connect(m_row, &StyleRow::ordered, this, &StyleStrip::ordered);
    connect(m_row, &StyleRow::upWanted, m_bar, &StyleBar::takeKeys);
    connect(m_row, &StyleRow::signButtonClicked, this, [this] {
        m_bar->widen();
        m_row->takeKeys();
    });
    connect(m_bar, &StyleBar::downWanted, m_row, &StyleRow::takeKeys);
    connect(m_bar, &StyleBar::filterChanged, this, &StyleStrip::filter);
}

void StyleStrip::setMarks(const StyleMarks& marks)
{
    m_list.marks() = marks;
    for (StyleTile* tile : m_row->tiles())
        tile->setFavourite(marks.favourites.contains(tile->path()));
    filter();
}

void StyleStrip::setFavourite(const QString& path, bool favourite)
{
    m_list.marks().setFavourite(path, favourite);
    if (StyleTile* tile = m_row->tile(path))
        tile->setFavourite(favourite); // Among the favourites it stays until they are shown anew: to be marked again.
    Q_EMIT marksChanged(m_list.marks());
}

StylePart StyleStrip::partOf(Qt::KeyboardModifiers modifiers) const
{
    return modifiers.testFlag(Qt::ShiftModifier) ? StylePart::Colour : m_bar->part();
}

void StyleStrip::setEntries(const std::vector<model::PresetEntry>& entries)
{
    endPreview();
    m_list.setEntries(entries);
    m_shelf.forget();
    std::vector<StyleTile*> tiles;
    tiles.reserve(entries.size() + 1);
    for (const model::PresetEntry& entry : entries)
        tiles.push_back(makeTile(entry));
    auto* save = new StyleTile({}, tr("Save style"), false, this);
    save->setToolTip(tr("Save this hair as a style of your own"));
    tiles.push_back(save);
    m_row->setTiles(tiles);
    filter();
}

StyleTile* StyleStrip::makeTile(const model::PresetEntry& entry)
{
    auto* tile = new StyleTile(entry.path, model::shownName(entry.name), StyleList::isOwn(entry), this);
    tile->setPicture(entry.picture);
    tile->setFavourite(m_list.marks().favourites.contains(entry.path));
    tile->setToolTip(tr("%1. Point to see it, click to keep it; Shift+click takes its colour alone").arg(tile->text()));
    // Queued, so that whoever fills the strip can connect first.
    if (entry.picture.isNull())
        QMetaObject::invokeMethod(
            this, [this, path = entry.path] { Q_EMIT pictureWanted(path); }, Qt::QueuedConnection);
    return tile;
}

void StyleStrip::filter()
{
    endPreview();
    const StyleFolder& folder = m_bar->folder();
    std::vector<QString> shown = m_list.shown(folder, m_bar->words());
    const bool isOfUser = folder.kind == StyleFolder::Kind::All || folder.kind == StyleFolder::Kind::Own;
    if (isOfUser && m_bar->words().isEmpty())
        shown.emplace_back(); // "Save style"
    if (!shown.empty())
        return m_row->showOnly(shown);
    const StyleSign sign = signOf(folder, m_bar->words());
    m_row->showSign(sign.sentence, sign.button);
}

void StyleStrip::showMenu(StyleTile* tile, const QPoint& globalPosition)
{
    const QString& path = tile->path();
    m_menu = std::make_unique<StyleMenu>(tile->own(), tile->isFavourite(), this);
    const StyleMenu* menu = m_menu.get();
    connect(menu, &StyleMenu::partPointedAt, this,
            [this, path](StylePart part) { pointAt({.path = path, .part = part}); });
    connect(menu, &StyleMenu::partChosen, this,
            [this, path](StylePart part) { commitWish({.path = path, .part = part}); });
    connect(menu, &StyleMenu::favouriteWanted, this, [this, path](bool favourite) { setFavourite(path, favourite); });
    connect(menu, &StyleMenu::ordered, this, [this, path](StyleOrder order) { Q_EMIT ordered(path, order); });
    connect(menu, &QMenu::aboutToHide, this, &StyleStrip::endPreview);
    m_menu->popup(globalPosition);
}

std::vector<QString> StyleStrip::paths() const
{
    std::vector<QString> all;
    for (const model::PresetEntry& entry : m_list.entries())
        all.push_back(entry.path);
    return all;
}

std::vector<QString> StyleStrip::shownPaths() const
{
    std::vector<QString> shown = m_row->shownPaths();
    std::erase(shown, QString());
    return shown;
}

void StyleStrip::startSearch()
{
    m_bar->startSearch();
}

void StyleStrip::setPicture(const QString& path, const QImage& picture)
{
    if (StyleTile* found = m_row->tile(path))
        found->setPicture(picture);
}

void StyleStrip::offerUndo(const QString& sentence)
{
    if (m_notice->isAncestorOf(QApplication::focusWidget()))
        m_row->takeKeys();
    m_notice->tell(sentence);
}

void StyleStrip::pointAt(const QString& path)
{
    pointAt(Wish{.path = path, .part = partOf(QGuiApplication::keyboardModifiers())});
}

void StyleStrip::pointAt(const Wish& wish)
{
    stopPointing();
    qApp->installEventFilter(this); // Shift goes to whatever has the focus.
    m_pointed = wish;
    if (StyleTile* pointed = m_row->tile(wish.path))
        pointed->setShown(true);
    m_pause.start();
}

void StyleStrip::contentMoved()
{
    m_pause.stop();
    const StyleTile* pointed = m_pointed ? m_row->tile(m_pointed->path) : nullptr;
    if (pointed != nullptr && !pointed->isUnderPointer())
        endPreview();
}

void StyleStrip::commitWish(const Wish& wish)
{
    m_pause.stop();
    m_toCommit = wish;
    m_shelf.want(wish.path);
}

void StyleStrip::arrived(const QString& path, const PresetPtr& preset)
{
    if (m_toCommit && m_toCommit->path == path) {
        m_putOn = path;
        apply(preset, m_toCommit->part);
    } else if (m_pointed && m_pointed->path == path) {
        m_fitting->show(preset, m_pointed->part);
    }
}

void StyleStrip::choose(const QString& path)
{
    commitWish({.path = path, .part = m_bar->part()});
}

void StyleStrip::putOn(const PresetPtr& preset)
{
    m_putOn.clear();
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
    if (StyleTile* left = m_row->tile(pointed->path))
        left->setShown(false);
}

void StyleStrip::endPreview()
{
    stopPointing();
    m_fitting->drop();
}

bool StyleStrip::eventFilter(QObject* watched, QEvent* event)
{
    if (m_pointed && (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease) &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Shift && QApplication::activePopupWidget() == nullptr) {
        const StylePart part = event->type() == QEvent::KeyPress ? StylePart::Colour : m_bar->part();
        if (part != m_pointed->part)
            pointAt({.path = m_pointed->path, .part = part});
    }
    return QWidget::eventFilter(watched, event);
}

void StyleStrip::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_notice->settle();
    m_question->setGeometry(0, height() - m_question->height(), width(), m_question->height());
}

void StyleStrip::hideEvent(QHideEvent* event)
{
    stopPointing();
    m_fitting->dismiss();
    QWidget::hideEvent(event);
}

} // namespace hairpaint::view
