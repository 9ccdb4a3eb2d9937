// Brushes of the real window over hair that hangs: on the strands that are seen, or on the skin below.
#include "model/document/scene_commands.h"
#include "sim/groom/direction_texel.h"
#include "tests/app/long_hair_fixture.h"
#include "tests/support/test_program.h"
#include "view/head_area/head_overlay.h"

#include <algorithm>

namespace hairpaint::app {

class TestWindowStrands : public QObject, private LongHairFixture
{
    Q_OBJECT
private:
    /// Overlay of the strands that are meant by a brush of colour over hanging hair.
    [[nodiscard]] const view::HeadOverlay* restOnLongHair()
    {
        openWithLongHair();
        editor().target().setMap(MapKind::Colour);
        setTools(model::ToolId::Brush, TouchKind::Seen);
        QTest::mouseMove(m_head, m_at + QPoint(0, 1));
        QTest::mouseMove(m_head, m_at);
        return m_window->headView().findChild<view::HeadOverlay*>();
    }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void aStreakIsOfTheStrandsThatItCrosses_data()
    {
        QTest::addColumn<TouchKind>("touch");
        QTest::addColumn<bool>("mirrored");
        QTest::newRow("what is seen") << TouchKind::Seen << false;
        QTest::newRow("hair") << TouchKind::Hair << false;
        QTest::newRow("hair, mirrored") << TouchKind::Hair << true;
        QTest::newRow("skin") << TouchKind::Skin << false;
    }

    void aStreakIsOfTheStrandsThatItCrosses()
    {
        QFETCH(TouchKind, touch);
        QFETCH(bool, mirrored);
        openWithLongHair();
        editor().target().setMap(MapKind::Colour);
        editor().options().setMirror(mirrored);
        setTools(model::ToolId::Brush, touch);
        const QPoint to = m_at + QPoint(0, 20);
        const auto seen = seenHair();
        // Twice the brush: it is larger or smaller on the screen where hair is nearer or further.
        const double radiusPx = 0.01 * view::Lens(m_window->headView().camera(), QSizeF(m_head->size())).pxPerM(0.5F);
        const std::vector<model::SeenStrand> passed = seen->passed(m_at, to, radiusPx);
        const auto before = map(MapKind::Colour);
        const int steps = stack().count();

        strokeTo(to, false);
        const std::vector<QPoint> shown = differing(*before, *map(MapKind::Colour));
        const auto preview = map(MapKind::Colour);
        QTest::mouseRelease(m_head, Qt::LeftButton, {}, to);
        QCOMPARE(stack().count(), steps + 1);
        QVERIFY(differing(*preview, *map(MapKind::Colour)).empty());
        QVERIFY(!shown.empty());

        const auto skin = session().document().project().head->skin;
        const glm::vec2 below = m_window->headView().skinAt(m_at)->uv;
        const bool onSkin = map(MapKind::Colour)->sampleNearest(below) != before->sampleNearest(below);
        QCOMPARE(onSkin, touch == TouchKind::Skin);
        int strange = 0;
        for (const QPoint& texel : shown) {
            const auto size = static_cast<float>(before->size());
            glm::vec2 uv((static_cast<float>(texel.x()) + 0.5F) / size,
                         1.0F - (static_cast<float>(texel.y()) + 0.5F) / size);
            const auto isRoot = [&](glm::vec2 at) {
                const auto point = skin->atUv(at);
                return point && std::ranges::any_of(passed, [&](const model::SeenStrand& one) {
                           return glm::distance(one.rootHd, point->positionHd) < 0.006F;
                       });
            };
            strange += isRoot(uv) || (mirrored && isRoot({1.0F - uv.x, uv.y})) ? 0 : 1;
        }
        if (touch == TouchKind::Skin)
            QVERIFY(strange > 0);
        else
            QCOMPARE(strange, 0);
        session().document().undo();
        QVERIFY(differing(*before, *map(MapKind::Colour)).empty());
    }

    void combedStrandsTurnAtTheirRoots()
    {
        openWithLongHair();
        setTools(model::ToolId::Comb, TouchKind::Seen);
        const std::vector<model::SeenStrand> strands = seenHair()->under(m_at, 4.0);
        const model::SeenStrand strand = *std::ranges::min_element(strands, {}, &model::SeenStrand::apart);
        const glm::vec2 below = m_window->headView().skinAt(m_at)->uv;
        const auto before = map(MapKind::Direction);
        strokeTo(m_at + QPoint(20, 0));
        const auto after = map(MapKind::Direction);
        QVERIFY(after->sampleNearest(strand.rootUv) != before->sampleNearest(strand.rootUv));
        QCOMPARE(after->sampleNearest(below), before->sampleNearest(below));
        session().document().undo();
        QVERIFY(differing(*before, *map(MapKind::Direction)).empty());
    }

    void fingersChangeTheStrandsThatTheyMeet_data()
    {
        QTest::addColumn<model::FingerKind>("kind");
        QTest::addColumn<MapKind>("changed");
        QTest::addColumn<TouchKind>("touch");
        QTest::addColumn<bool>("mirrored");
        using enum model::FingerKind;
        QTest::newRow("puff, hair") << Puff << MapKind::Direction << TouchKind::Hair << false;
        QTest::newRow("puff, skin") << Puff << MapKind::Direction << TouchKind::Skin << false;
        QTest::newRow("pinch, hair, mirrored") << Pinch << MapKind::Clump << TouchKind::Hair << true;
        QTest::newRow("pinch, skin, mirrored") << Pinch << MapKind::Clump << TouchKind::Skin << true;
        QTest::newRow("spread, hair") << Spread << MapKind::Clump << TouchKind::Hair << false;
        QTest::newRow("spread, skin, mirrored") << Spread << MapKind::Clump << TouchKind::Skin << true;
        QTest::newRow("smooth, hair, mirrored") << Smooth << MapKind::Direction << TouchKind::Hair << true;
        QTest::newRow("smooth, skin") << Smooth << MapKind::Direction << TouchKind::Skin << false;
    }

    void fingersChangeTheStrandsThatTheyMeet()
    {
        QFETCH(model::FingerKind, kind);
        QFETCH(MapKind, changed);
        QFETCH(TouchKind, touch);
        QFETCH(bool, mirrored);
        using enum model::FingerKind;
        openWithLongHair();
        if (touch == TouchKind::Skin)
            m_at = hairyPoint();
        editor().options().setMirror(mirrored);
        const MapKind chosen = editor().target().map();
        key(Qt::Key_R);
        QCOMPARE(editor().tools().active().id(), model::ToolId::Fingers);
        setTools(model::ToolId::Fingers, touch);
        model::ToolSettings settings = editor().tools().settings();
        settings.fingers = kind;
        editor().tools().setSettings(settings);
        const auto all = [this] {
            std::vector<std::shared_ptr<const sim::TiledRaster>> maps;
            for (const model::MapSpec& spec : model::mapSpecs())
                maps.push_back(map(spec.kind));
            return maps;
        };
        const auto same = [](const auto& a, const auto& b) {
            return std::ranges::equal(a, b, [](const auto& one, const auto& other) { return *one == *other; });
        };
        const glm::vec2 below = m_window->headView().skinAt(m_at)->uv;
        const std::vector<model::SeenStrand> strands = seenHair()->under(m_at, 3.0);
        const auto before = all();
        const int steps = stack().count();
        strokeTo(m_at + QPoint(0, 20), false);
        const auto preview = all();
        QVERIFY(!same(before, preview));
        QTest::mouseRelease(m_head, Qt::LeftButton, {}, m_at + QPoint(0, 20));
        QVERIFY(same(preview, all()));
        QCOMPARE(stack().count(), steps + 1);
        const auto& was = before[sim::indexOf(changed)];
        const auto is = map(changed);
        const bool atBelow = is->sampleNearest(below) != was->sampleNearest(below);
        QCOMPARE(atBelow, touch == TouchKind::Skin);
        if (touch == TouchKind::Hair) {
            QVERIFY(!strands.empty());
            const auto turned = std::ranges::count_if(strands, [&](const model::SeenStrand& one) {
                return is->sampleNearest(one.rootUv) != was->sampleNearest(one.rootUv) &&
                       (!mirrored ||
                        is->sampleNearest(otherSide(one.rootUv)) != was->sampleNearest(otherSide(one.rootUv)));
            });
            // What is even stays.
            QVERIFY2((kind == Smooth ? 10U : 2U) * static_cast<std::size_t>(turned) > strands.size(),
                     qPrintable(QStringLiteral("%1 of %2").arg(turned).arg(strands.size())));
        }
        const auto flatness = [&](const sim::TiledRaster& direction, glm::vec2 uv) {
            return glm::length(sim::directionOf(direction.sampleNearest(uv)));
        };
        const glm::vec2 there = touch == TouchKind::Hair ? strands.front().rootUv : below;
        if (kind == Puff)
            QVERIFY(flatness(*is, there) < 0.8F * flatness(*was, there));
        if (kind == Pinch)
            QVERIFY(is->sampleScalar(there) > was->sampleScalar(there));
        if (kind == Spread)
            QVERIFY(is->sampleScalar(there) < was->sampleScalar(there));
        session().document().undo();
        QVERIFY(same(before, all()));
        // The shown map stays where the step had changed it, and the next tool goes back to the map before.
        if (changed == MapKind::Direction) {
            QCOMPARE(editor().target().map(), MapKind::Direction);
            key(Qt::Key_B);
            QCOMPARE(editor().target().map(), chosen);
        }
    }

    void guidesAreBentByTheirNodes_data()
    {
        QTest::addColumn<bool>("mirrored");
        QTest::newRow("one side") << false;
        QTest::newRow("mirrored") << true;
    }
    void guidesAreBentByTheirNodes()
    {
        QFETCH(bool, mirrored);
        openWithLongHair();
        editor().options().setMirror(mirrored);
        setTools(model::ToolId::Grab, TouchKind::Seen);
        model::ToolSettings settings = editor().tools().settings();
        settings.grab = model::GrabKind::Guides;
        settings.brushSizeM = 0.03F;
        editor().tools().setSettings(settings);
        QTest::mouseMove(m_head, m_at + QPoint(0, 1));
        QTest::mouseMove(m_head, m_at);
        const std::vector<model::GuideStrand> guides = editor().tools().guides();
        QVERIFY(guides.size() >= 6 && guides.size() <= 30);
        const auto* overlay = m_window->headView().findChild<view::HeadOverlay*>();
        QCOMPARE(overlay->guides().size(), guides.size());
        // A node in the middle of the first, wherever it is seen.
        const QPoint node = m_window->headView().positionOf(guides.front().nodesHd[4]).value().toPoint();
        const auto lengths = map(MapKind::Length);
        const auto directions = map(MapKind::Direction);
        const auto gel = map(MapKind::Gel);
        const int steps = stack().count();
        m_at = node;
        strokeTo(node + QPoint(30, -20), false);
        const std::vector<model::GuideStrand> bent = editor().tools().guides();
        const auto held = std::ranges::find_if(bent, &model::GuideStrand::held);
        QVERIFY(held != bent.end());
        const auto lengthM = [](const model::GuideStrand& guide) {
            float sumM = 0.0F;
            for (std::size_t i = 1; i < guide.nodesHd.size(); ++i)
                sumM += glm::distance(guide.nodesHd[i - 1], guide.nodesHd[i]);
            return sumM;
        };
        const auto was = std::ranges::find_if(
            guides, [&](const model::GuideStrand& one) { return one.root.positionHd == held->root.positionHd; });
        QVERIFY(was != guides.end());
        QVERIFY(std::abs(lengthM(*was) - lengthM(*held)) < 1e-4F);
        const auto preview = map(MapKind::Direction);
        QVERIFY(*preview != *directions);
        QTest::mouseRelease(m_head, Qt::LeftButton, {}, node + QPoint(30, -20));
        QVERIFY(*map(MapKind::Direction) == *preview);
        QVERIFY(*map(MapKind::Length) == *lengths);
        QVERIFY(map(MapKind::Gel)->sampleScalar(held->root.uv) > gel->sampleScalar(held->root.uv));
        const glm::vec2 root = mirrored ? otherSide(held->root.uv) : held->root.uv;
        QVERIFY(map(MapKind::Direction)->sampleNearest(root) != directions->sampleNearest(root));
        QCOMPARE(stack().count(), steps + 1);
        session().document().undo();
        QVERIFY(*map(MapKind::Direction) == *directions);
        QVERIFY(*map(MapKind::Gel) == *gel);
    }

    void theStrandsThatAreMeantAreShown()
    {
        const view::HeadOverlay* overlay = restOnLongHair();
        QVERIFY(!overlay->strands().empty());
        QVERIFY(editor().hover().ringPoints().empty());
        key(Qt::Key_T);
        QCOMPARE(editor().tools().settings().touch, TouchKind::Skin);
        QTest::mouseMove(m_head, m_at + QPoint(0, 1));
        QVERIFY(overlay->strands().empty());
        QVERIFY(!editor().hover().ringPoints().empty());
        key(Qt::Key_T);
        key(Qt::Key_T);
        QCOMPARE(editor().tools().settings().touch, TouchKind::Seen);
    }

    void theStrandsThatAreMeantFollowTheViewUnderAPointerThatRests()
    {
        const view::HeadOverlay* overlay = restOnLongHair();
        const std::vector<QPolygonF> before = overlay->strands();
        QVERIFY(!before.empty());
        QWheelEvent wheel(m_at, m_head->mapToGlobal(m_at), {}, QPoint(0, 360), Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(m_head, &wheel);
        QTRY_VERIFY_WITH_TIMEOUT(overlay->strands() != before && !overlay->strands().empty(), test::kPatienceMs);
    }

    void theStrandsThatAreMeantMoveWithTheHairUnderAPointerThatRests()
    {
        const view::HeadOverlay* overlay = restOnLongHair();
        const std::vector<QPolygonF> before = overlay->strands();
        QVERIFY(!before.empty());
        session().document().push(
            model::setWindCommand(session().document(), {.enabled = true, .velocity = {4.0F, 0.0F, 0.0F}}));
        session().document().setWindOn(true);
        QTRY_VERIFY_WITH_TIMEOUT(overlay->strands() != before && !overlay->strands().empty(), test::kPatienceMs);
        const std::vector<QPolygonF> once = overlay->strands();
        QTRY_VERIFY_WITH_TIMEOUT(overlay->strands() != once, test::kPatienceMs);
    }

    void aClickWithCtrlTakesWhatTheStrandHasAtItsRoot()
    {
        openWithLongHair();
        editor().target().setMap(MapKind::Length);
        setTools(model::ToolId::Brush, TouchKind::Hair);
        const auto strands = seenHair()->under(m_at, 4.0);
        const glm::vec2 root = std::ranges::min_element(strands, {}, &model::SeenStrand::apart)->rootUv;
        QTest::mouseClick(m_head, Qt::LeftButton, Qt::ControlModifier, m_at);
        const float expected = static_cast<float>(map(MapKind::Length)->sampleNearest(root)[0]) / 65535.0F;
        QVERIFY(expected > 0.1F);
        QVERIFY(std::abs(editor().tools().settings().value(MapKind::Length).scalar - expected) < 0.001F);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestWindowStrands, Widgets)
#include "test_window_strands.moc"
