// Keyboard focus in the window: F6 goes from area to area, Tab around within one.
#pragma once

#include <QObject>
#include <QPointer>

#include <functional>
#include <vector>

class QWidget;

namespace hairpaint::app {

/// Knows the areas of a window in their order and the widget of each that had the focus last. GUI thread.
class FocusAreas : public QObject
{
    Q_OBJECT
public:
    struct Area
    {
        QWidget* widget = nullptr;
        std::function<void()> uncover = {}; ///< Brings to the front what lies behind a tab.
        const QWidget* container = nullptr; ///< The area is left out while this is hidden; null: the widget itself.
        QPointer<QWidget> lastFocused = {};
    };

    explicit FocusAreas(std::vector<Area> areas, QObject* parent = nullptr);

    /// Gives the focus to the area after or before the one that has it.
    void step(bool forward);
    /// Gives the focus to the next or previous widget of the area that has it, round and round; from an area with a
    /// single one it goes on to the next area. False where no area has the focus.
    bool stepWithin(bool forward);

private:
    /// Index of the area that contains the widget; -1 for none.
    [[nodiscard]] std::ptrdiff_t indexOf(const QWidget* widget) const;
    bool enter(Area& area, bool forward);

    std::vector<Area> m_areas;
};

} // namespace hairpaint::app
