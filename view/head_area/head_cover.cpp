// Overlays filled from the editor, and laid out.
#include "view/head_area/head_cover.h"

#include "view/editing/editor_state.h"
#include "view/head_area/head_overlay.h"
#include "view/head_area/head_scene.h"
#include "view/head_area/view_signs.h"
#include "view/head_area/weather_overlay.h"
#include "view/head_area/worn_drag.h"

#include <QElapsedTimer>

#include <algorithm>
#include <utility>

namespace hairpaint::view {

HeadCover::HeadCover(EditorState& editor, const HeadScene& scene, const Theme& theme, QWidget& area)
    : m_editor(editor), m_scene(scene), m_area(area), m_overlay(new HeadOverlay(theme, &area)),
      m_weather(new WeatherOverlay(theme, &area)), m_signs(new ViewSigns(&area)),
      m_directions(editor, *m_overlay, [this] { return shown(); })
{
    m_weather->hide();
    m_strandsSoon.setSingleShot(true);
    QObject::connect(&m_strandsSoon, &QTimer::timeout, m_overlay, [this] { refreshStrands(); });
    QObject::connect(&m_editor.tools(), &ToolBox::hairCutOff, &m_falling, &FallingHair::start);
    QObject::connect(&m_falling, &FallingHair::moved, m_overlay, [this] { m_overlay->setFalling(fallingHair()); });
}

void HeadCover::setTheme(const Theme& theme)
{
    m_overlay->setTheme(theme);
    m_weather->setTheme(theme);
}

/// What lies over the picture moves with it, not with the camera or the hair, which may be pictures ahead.
void HeadCover::follow(const Sight& sight)
{
    refreshStrandsSoon();
    if (std::exchange(m_shown, sight) == sight)
        return;
    refresh();
    m_directions.refresh();
}

Sight HeadCover::shown() const
{
    return m_shown.value_or(Sight{.camera = m_scene.camera(), .pose = m_scene.shownPose()});
}

std::vector<FallingLine> HeadCover::fallingHair() const
{
    if (!m_falling.falls())
        return {};
    const Sight sight = shown();
    const QSizeF size(m_area.size());
    return m_falling.seen(sight.camera, size,
                          SkinDepths(m_scene.skin(), sight.pose, Lens(sight.camera, size), m_area.size()));
}

void HeadCover::refresh()
{
    const Sight sight = shown();
    m_overlay->setShapes(m_editor.tools().overlay(), m_scene.skin(), sight.camera, sight.pose);
    m_overlay->setPictureLine(m_editor.tools().pictureLine());
    m_overlay->setGuides(m_editor.tools().guides(), sight.camera, sight.pose);
    const model::Id chosen = m_editor.options().chosenWorn();
    const model::Worn* held = m_editor.document().project().wornThing(chosen);
    const HeadSight from{.camera = sight.camera, .pose = sight.pose, .size = QSizeF(m_area.size())};
    m_overlay->setWorn(outlinedWorn(m_editor), chosen, held != nullptr && !isBehindHead(*held, m_scene, from), from);
    m_overlay->setGhost(m_scene.hiddenRing());
    m_directions.refreshSoon();
}

void HeadCover::refreshWorn()
{
    if (m_editor.options().collidersShown() || m_editor.options().chosenWorn() != 0 ||
        !m_overlay->wornOutlines().empty())
        refresh();
}

void HeadCover::refreshRing()
{
    m_overlay->setGhost(m_scene.hiddenRing());
    refreshStrands();
}

/// Hair that moves leaves the strands that were found before.
void HeadCover::refreshStrandsSoon()
{
    constexpr qint64 kLeastMs = 40;
    constexpr qint64 kMostMs = 500;
    constexpr qint64 kPartOfTime = 8;
    const std::optional<HoverPoint>& hover = m_editor.hover().at();
    if (hover && hover->hair && !m_strandsSoon.isActive())
        m_strandsSoon.start(static_cast<int>(std::clamp(m_strandsMs * kPartOfTime, kLeastMs, kMostMs)));
}

void HeadCover::refreshStrands()
{
    QElapsedTimer timer;
    timer.start();
    const std::optional<HoverPoint>& hover = m_editor.hover().at();
    if (!hover || !hover->hair || !m_editor.tools().active().traits().hasRing)
        return m_overlay->setStrands({}, {});
    const model::OverHair& hair = *hover->hair;
    const double radiusPx = 0.5 * m_editor.tools().settings().brushSizeM * hair.pxPerM;
    m_overlay->setStrands(m_scene.strandsUnder(hair),
                          {hair.position - QPointF(radiusPx, radiusPx), QSizeF(2.0 * radiusPx, 2.0 * radiusPx)});
    m_strandsMs = timer.elapsed();
}

void HeadCover::showSigns(bool paused, bool refining, std::size_t triangles)
{
    m_signs->show(paused, refining, triangles);
    layOut();
}

void HeadCover::setLookedAt(std::optional<model::MapKind> map)
{
    m_directions.setLookedAt(map);
}

void HeadCover::layOut()
{
    constexpr int kMargin = 12;
    const QSize size = m_area.size();
    m_overlay->setGeometry(QRect(QPoint(), size));
    const QSize panel = m_weather->sizeHint().boundedTo(size - QSize(2 * kMargin, 2 * kMargin));
    m_weather->setGeometry(QRect(QPoint(kMargin, size.height() - kMargin - panel.height()), panel));
    m_weather->raise();
    m_signs->move(size.width() - kMargin - m_signs->width(), kMargin);
    m_signs->raise();
}

} // namespace hairpaint::view
