// What lies over the pictures of the 3D area, and where in it all of that stands.
#pragma once

#include "view/head_area/falling_hair.h"
#include "view/head_area/shot.h"
#include "view/head_area/shown_directions.h"
#include "view/look/theme.h"

#include <QTimer>

#include <optional>

class QWidget;

namespace hairpaint::view {

class EditorState;
class HeadOverlay;
class HeadScene;
class ViewSigns;
class WeatherOverlay;

/// Outlines, directions and signs follow the picture that is on the screen. GUI thread.
class HeadCover
{
public:
    /// Its widgets are children of `area`. All outlive it.
    HeadCover(EditorState& editor, const HeadScene& scene, const Theme& theme, QWidget& area);

    void setTheme(const Theme& theme);
    [[nodiscard]] WeatherOverlay& weather() { return *m_weather; }
    [[nodiscard]] const WeatherOverlay& weather() const { return *m_weather; }

    /// The picture on the screen is this one now.
    void follow(const Sight& sight);
    void refresh();     ///< Outlines of the tool and of what is worn.
    void refreshWorn(); ///< The same where any of what is worn is shown.
    void refreshRing(); ///< The brush's, where the head hides it; the strands under it, where they are meant.
    void showSigns(bool paused, bool refining, std::size_t triangles);
    void setLookedAt(std::optional<model::MapKind> map);
    void layOut(); ///< Once the area's size or that of a part has changed.

private:
    [[nodiscard]] std::vector<FallingLine> fallingHair() const; ///< As it is seen at the moment.
    [[nodiscard]] Sight shown() const;
    void refreshStrands();
    void refreshStrandsSoon(); ///< However fast pictures follow each other, only a part of the time goes there.

    EditorState& m_editor;
    const HeadScene& m_scene;
    QWidget& m_area;
    HeadOverlay* m_overlay; ///< Children of the area, as the next two.
    WeatherOverlay* m_weather;
    ViewSigns* m_signs;
    ShownDirections m_directions;
    FallingHair m_falling;
    std::optional<Sight> m_shown; ///< None before the first picture.
    QTimer m_strandsSoon;
    qint64 m_strandsMs = 0; ///< What finding the strands took last.
};

} // namespace hairpaint::view
