// The layers of the active map.
#pragma once

#include "model/document/layer_commands.h"
#include "view/editing/editor_state.h"

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <map>

class QComboBox;
class QToolButton;

namespace hairpaint::view {

class BarSlider;
class LayerList;

/// Topmost first. Opacity and blend mode are the active layer's. Every change is one undo step.
class LayersPanel : public QWidget
{
    Q_OBJECT
public:
    explicit LayersPanel(EditorState& state, QWidget* parent = nullptr);

    void addLayer();
    void removeLayer();
    void duplicateLayer();
    void moveLayer(int steps); ///< Upward when positive.

    /// Small pictures drawn so far: only those of layers whose texels changed.
    [[nodiscard]] int drawnThumbnails() const { return m_drawnThumbnails; }

private:
    /// A layer's small picture and what it was drawn from.
    struct Thumbnail
    {
        sim::TiledRaster raster;
        model::MapKind map;
        bool nightPaper;
        int side;
        QImage image;
    };

    void connectList();
    void connectProperties();
    void onChanged(const model::Change& change);
    void showMenu(QPoint position);
    void moveTo(model::Id layer, int position);
    void rebuild();
    void refreshThumbnails();
    void followActive();
    [[nodiscard]] const model::MapStack* stack() const;
    [[nodiscard]] const model::Layer* activeLayer() const;
    void change(model::Id layer, const QString& text, const std::function<void(model::LayerProperties&)>& edit);

    EditorState& m_state;
    model::EditSession m_opacityEdit;
    model::LayerAddress m_opacityTarget; ///< The layer that is edited, also when another one becomes active meanwhile.
    model::LayerAddress m_shownTarget;   ///< The layer that m_opacity stands for.
    LayerList* m_list = nullptr;
    BarSlider* m_opacity = nullptr;
    QComboBox* m_blend = nullptr;
    QToolButton* m_duplicate = nullptr;
    QToolButton* m_remove = nullptr;
    QToolButton* m_up = nullptr;
    QToolButton* m_down = nullptr;
    QTimer m_thumbnails;
    std::map<model::Id, Thumbnail> m_thumbnailOf; ///< By the ids of the listed layers.
    int m_drawnThumbnails = 0;
    bool m_filling = false;
};

} // namespace hairpaint::view
