// The column at the right edge: maps on top, under them layers or hair.
#pragma once

#include "view/panels/hair_panel.h"
#include "view/panels/layers_panel.h"
#include "view/panels/maps_panel.h"

class QTabWidget;

namespace hairpaint::view {

/// 280 px wide, usable from 430 px of height.
class Sidebar : public QWidget
{
    Q_OBJECT
public:
    explicit Sidebar(EditorState& state, QWidget* parent = nullptr);
    [[nodiscard]] MapsPanel& maps() const { return *m_maps; }
    [[nodiscard]] LayersPanel& layers() const { return *m_layers; }
    [[nodiscard]] HairPanel& hair() const { return *m_hair; }
    void showLayers();
    void showHair();
    void askWhatGrows(); ///< Shows the hair panel and its list of kinds of hair.
    [[nodiscard]] QSize sizeHint() const override { return {280, 640}; }

private:
    MapsPanel* m_maps;
    LayersPanel* m_layers;
    HairPanel* m_hair;
    QTabWidget* m_tabs;
};

} // namespace hairpaint::view
