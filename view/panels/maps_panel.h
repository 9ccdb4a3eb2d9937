// The maps of the active group; a click makes one the map that is painted.
#pragma once

#include "view/editing/editor_state.h"

#include <QTimer>
#include <QWidget>

#include <array>

class QScrollArea;

namespace hairpaint::view {

class MapRow;

/// Thumbnails follow strokes and previews, at most some twenty times a second and only of maps that changed.
class MapsPanel : public QWidget
{
    Q_OBJECT
public:
    explicit MapsPanel(EditorState& state, QWidget* parent = nullptr);
    /// All rows.
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void onChanged(const model::Change& change);
    void markAll();
    void follow();
    void redraw();

    EditorState& m_state;
    QScrollArea* m_scroll;
    std::array<MapRow*, model::kMapKindCount> m_rows{};
    std::array<std::shared_ptr<const sim::TiledRaster>, model::kMapKindCount> m_drawn; ///< What thumbnails show.
    model::Id m_shownGroup = 0;
    model::MapKind m_shownMap = model::MapKind::Density; ///< Whose row is in sight.
    QTimer m_redraw;
};

} // namespace hairpaint::view
