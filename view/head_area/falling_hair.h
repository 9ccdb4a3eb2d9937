// Cut hair that falls and fades.
#pragma once

#include "model/tools/cutting/cut_pieces.h"
#include "view/picking/skin_depths.h"
#include "view/rendering/scene.h"

#include <QColor>
#include <QObject>
#include <QPolygonF>
#include <QSizeF>
#include <QVariantAnimation>

#include <vector>

namespace hairpaint::view {

/// A piece as it is seen at the moment.
struct FallingLine
{
    QPolygonF line; ///< px of the view.
    QColor colour;
};

/// For half a second, over the picture; the skin before it hides it. GUI thread.
class FallingHair : public QObject
{
    Q_OBJECT
public:
    explicit FallingHair(QObject* parent = nullptr);

    /// Instead of what still falls.
    void start(std::vector<model::CutPiece> pieces);
    /// None once all have fallen.
    [[nodiscard]] std::vector<FallingLine> seen(const rendering::Camera& camera, QSizeF size,
                                                const SkinDepths& skin) const;
    [[nodiscard]] bool falls() const { return !m_pieces.empty(); }

Q_SIGNALS:
    void moved();

private:
    std::vector<model::CutPiece> m_pieces;
    QVariantAnimation m_time; ///< Its value is the fraction of the fall.
};

} // namespace hairpaint::view
