// Finds text that has less room than it needs.
#pragma once

#include "view/widgets/bar_slider.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QStringList>
#include <QTabBar>

namespace hairpaint::test {

namespace detail {

/// A text on a widget and the room that it wants; 0 where any will do.
struct Wanted
{
    QString text;
    int width = 0;
    int height = 0;
};

inline Wanted wantedBy(const QWidget& widget)
{
    if (const auto* label = qobject_cast<const QLabel*>(&widget); label != nullptr && !label->text().isEmpty()) {
        // A label that may be any width says its whole text in its tooltip.
        if (label->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored)
            return {};
        return {label->text(), label->wordWrap() ? 0 : label->sizeHint().width(),
                label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height()};
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget);
        button != nullptr && !button->text().isEmpty())
        return {button->text(), button->minimumSizeHint().width(), button->minimumSizeHint().height()};
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
        Wanted wanted;
        for (int i = 0; i < box->count(); ++i) {
            const int width = box->fontMetrics().horizontalAdvance(box->itemText(i)) + 24;
            if (width > wanted.width)
                wanted = {box->itemText(i), width, 0};
        }
        return wanted;
    }
    if (const auto* slider = qobject_cast<const view::BarSlider*>(&widget))
        return {slider->label(), slider->fontMetrics().horizontalAdvance(slider->label() + slider->valueText()) + 20,
                0};
    return {};
}

} // namespace detail

/// Visible labels, buttons, boxes, tabs and sliders that have less room than they need; wrapped labels by their height.
inline QStringList clipped(const QWidget& parent)
{
    QStringList found;
    const auto check = [&found](const detail::Wanted& wanted, QSize room) {
        if (wanted.width > room.width() || wanted.height > room.height())
            found.append(QStringLiteral("%1 (%2 x %3 of %4 x %5)")
                             .arg(wanted.text)
                             .arg(room.width())
                             .arg(room.height())
                             .arg(wanted.width)
                             .arg(wanted.height));
    };
    for (const QWidget* widget : parent.findChildren<QWidget*>()) {
        if (!widget->isVisibleTo(&parent) || widget->visibleRegion().isEmpty())
            continue;
        check(detail::wantedBy(*widget), widget->size());
        if (const auto* tabs = qobject_cast<const QTabBar*>(widget))
            for (int i = 0; i < tabs->count(); ++i)
                check({tabs->tabText(i), tabs->fontMetrics().horizontalAdvance(tabs->tabText(i)), 0},
                      tabs->tabRect(i).intersected(tabs->rect()).size());
    }
    return found;
}

} // namespace hairpaint::test
