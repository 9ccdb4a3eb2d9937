// A ball with hair in the 3D area, driven by mouse, wheel and keys; its pictures come from an off-screen context.
#pragma once

#include "model/document/paint_command.h"
#include "sim/motion/simulation.h"
#include "tests/support/view_fixture.h"
#include "view/head_area/head_view.h"

#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>

#include <cmath>

namespace hairpaint::test {

inline constexpr float kBallM = 0.1F;

struct HeadFixture
{
    HeadFixture()
        : editor(test::makeProject(test::makeBallHead())),
          area(editor.state, view::Theme::of(view::ThemeKind::Dark), view::PresenterChoice::Software)
    {
        area.resize(480, 400);
        area.setCamera(camera());
        area.show();
    }

    [[nodiscard]] static rendering::Camera camera()
    {
        rendering::Camera camera;
        camera.targetWo = glm::vec3(0.0F);
        camera.distanceM = 0.6F;
        return camera;
    }

    void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QTest::mousePress(&area, button, modifiers, from);
        for (int i = 1; i <= 5; ++i)
            move(from + (to - from) * i / 5, button, modifiers);
        QTest::mouseRelease(&area, button, modifiers, to);
    }

    /// QTest::mouseMove has neither buttons nor modifiers.
    void move(QPointF at, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers)
    {
        QMouseEvent event(QEvent::MouseMove, at, area.mapToGlobal(at), Qt::NoButton, buttons, modifiers);
        QApplication::sendEvent(&area, &event);
    }

    void wheel(QPointF at, int notches)
    {
        QWheelEvent event(at, area.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&area, &event);
    }

    [[nodiscard]] std::shared_ptr<const sim::StrandFrame> frame() const { return frameOf(editor); }

    [[nodiscard]] static std::shared_ptr<const sim::StrandFrame> frameOf(const test::Editor& editor)
    {
        sim::Simulation simulation;
        simulation.setInput(editor.document.groomInput());
        simulation.advance(1.0 / 60.0);
        auto frame = std::make_shared<sim::StrandFrame>();
        simulation.writeFrame(*frame);
        return frame;
    }

    /// The first layer of a map of the group.
    void fill(model::MapKind map, std::uint16_t value)
    {
        const model::HairGroup& group = editor.document.project().groups.front();
        sim::TiledRaster raster = group.map(map).layers.front().raster;
        model::LayerTiles tiles;
        for (int index = 0; index < raster.tileCount(); ++index) {
            raster.setUniform(index, {value, 65535, 0, 0});
            tiles.emplace_back(index, raster.tile(index));
        }
        editor.document.push(model::paintCommand(
            editor.document, {.group = group.id, .map = map, .layer = group.map(map).layers.front().id}, tiles,
            QStringLiteral("fill")));
    }

    test::Editor editor;
    view::HeadView area;
};

inline const QPoint kMiddle(240, 200);
inline const QPoint kBackground(20, 20);

inline int differingPixels(const QImage& a, const QImage& b, const QRect& rect)
{
    int count = 0;
    for (int y = rect.top(); y <= rect.bottom(); ++y) {
        for (int x = rect.left(); x <= rect.right(); ++x) {
            const QColor p = a.pixelColor(x, y);
            const QColor q = b.pixelColor(x, y);
            count += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue()) > 24;
        }
    }
    return count;
}

/// The same hair elsewhere.
inline std::shared_ptr<const sim::StrandFrame> movedBy(const sim::StrandFrame& frame, float distanceM)
{
    const auto moved = std::make_shared<sim::StrandFrame>(frame);
    for (sim::GroupFrame& group : moved->groups)
        for (float& coordinate : group.positions)
            coordinate += distanceM;
    return moved;
}

} // namespace hairpaint::test
