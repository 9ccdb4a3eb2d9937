// A map's letter on its colour, with its icon: readable without seeing colours.
#pragma once

#include "model/project/map_spec.h"

#include <QPixmap>
#include <QWidget>

namespace hairpaint::view {

class MapBadge : public QWidget
{
    Q_OBJECT
public:
    explicit MapBadge(model::MapKind map, QWidget* parent = nullptr);
    void setMap(model::MapKind map);
    [[nodiscard]] QSize sizeHint() const override { return {44, 20}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }
    /// Draws one into a row of another widget.
    static void paint(QPainter& painter, const QRect& rect, const model::MapSpec& spec, bool strong);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    model::MapKind m_map;
};

} // namespace hairpaint::view
