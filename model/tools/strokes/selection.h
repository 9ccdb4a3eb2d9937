// The selected part of the maps: rectangles of uv, or everything.
#pragma once

#include <QObject>
#include <QPolygonF>
#include <QRectF>

#include <optional>
#include <vector>

namespace hairpaint::model {

/// View state, outside undo. While anything is selected, tools paint only inside it.
class Selection : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;
    /// uv, v up, none overlapping another; empty: nothing is selected and tools paint everywhere.
    [[nodiscard]] const std::vector<QRectF>& rectangles() const { return m_rectangles; }
    /// Around all of them; none where nothing is selected.
    [[nodiscard]] std::optional<QRectF> rectangle() const;
    /// The borders of what is selected, closed, uv.
    [[nodiscard]] std::vector<QPolygonF> outlines() const;

    void setRectangles(std::vector<QRectF> rectangles); ///< They must not overlap.
    void setRectangle(const std::optional<QRectF>& rectangle);
    /// What is not selected becomes so, and the reverse; from nothing, everything.
    void invert();

Q_SIGNALS:
    void changed();

private:
    std::vector<QRectF> m_rectangles;
};

/// What is left of rectangles that don't overlap without another, in rectangles that don't overlap.
[[nodiscard]] std::vector<QRectF> without(const std::vector<QRectF>& rectangles, const QRectF& taken);

} // namespace hairpaint::model
