// The menu of a style: see the header.
#include "view/panels/style_menu.h"

#include <QCoreApplication>

#include <array>

namespace hairpaint::view {

namespace {

constexpr std::array kOrders{
    StyleOrderSpec{.order = StyleOrder::About,
                   .title = QT_TRANSLATE_NOOP("StyleOrders", "About this style…"),
                   .key = Qt::CTRL | Qt::Key_I,
                   .ofOwn = false},
    StyleOrderSpec{.order = StyleOrder::Rename,
                   .title = QT_TRANSLATE_NOOP("StyleOrders", "Rename style…"),
                   .key = QKeyCombination(Qt::Key_F2)},
    StyleOrderSpec{.order = StyleOrder::Tag, .title = QT_TRANSLATE_NOOP("StyleOrders", "Tags…")},
    StyleOrderSpec{.order = StyleOrder::Replace,
                   .title = QT_TRANSLATE_NOOP("StyleOrders", "Replace with the hair on the head")},
    StyleOrderSpec{.order = StyleOrder::Picture,
                   .title = QT_TRANSLATE_NOOP("StyleOrders", "New picture from this view")},
    StyleOrderSpec{
        .order = StyleOrder::Export, .title = QT_TRANSLATE_NOOP("StyleOrders", "Export style…"), .ofOwn = false},
    StyleOrderSpec{.order = StyleOrder::Delete,
                   .title = QT_TRANSLATE_NOOP("StyleOrders", "Delete style"),
                   .key = QKeyCombination(Qt::Key_Delete)},
};

QString withKey(const QString& text, QKeyCombination key)
{
    return key.key() == Qt::Key{} ? text
                                  : text + QLatin1Char('\t') + QKeySequence(key).toString(QKeySequence::NativeText);
}

} // namespace

QString StyleOrderSpec::titleText() const
{
    return QCoreApplication::translate("StyleOrders", title);
}

std::span<const StyleOrderSpec> styleOrders()
{
    return kOrders;
}

StyleMenu::StyleMenu(bool own, bool favourite, QWidget* parent) : QMenu(parent)
{
    for (const model::StylePartSpec& part : model::styleParts()) {
        QString text = part.titleText();
        if (part.part == model::StylePart::Colour)
            text += QLatin1Char('\t') + tr("Shift+click");
        QAction* action = addAction(text);
        connect(action, &QAction::hovered, this, [this, part = part.part] { Q_EMIT partPointedAt(part); });
        connect(action, &QAction::triggered, this, [this, part = part.part] { Q_EMIT partChosen(part); });
    }
    addSeparator();
    QAction* mark = addAction(withKey(tr("Favourite"), kFavouriteKey));
    mark->setCheckable(true);
    mark->setChecked(favourite);
    connect(mark, &QAction::triggered, this, &StyleMenu::favouriteWanted);
    addSeparator();
    for (const StyleOrderSpec& spec : kOrders)
        if (own || !spec.ofOwn)
            connect(addAction(withKey(spec.titleText(), spec.key)), &QAction::triggered, this,
                    [this, order = spec.order] { Q_EMIT ordered(order); });
}

} // namespace hairpaint::view
