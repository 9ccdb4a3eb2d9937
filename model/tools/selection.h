// The selected part of the maps: a rectangle of uv, or everything.
#pragma once

#include <QObject>
#include <QRectF>

#include <optional>

namespace hairpaint::model {

/// View state, outside undo. While a rectangle is selected, tools paint only inside it.
class Selection : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;
    /// uv, v up; none: nothing is selected and tools paint everywhere.
    [[nodiscard]] const std::optional<QRectF>& rectangle() const { return m_rectangle; }
    void setRectangle(std::optional<QRectF> rectangle);

Q_SIGNALS:
    void changed();

private:
    std::optional<QRectF> m_rectangle;
};

} // namespace hairpaint::model
