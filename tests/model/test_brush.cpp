// The brush on the skin: its size and shape in texels, its path, its seams.
#include "model/tools/brush_path.h"
#include "model/tools/strokes/dab_shape.h"
#include "model/tools/tool_list.h"
#include "tests/model/fixtures.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

/// A patch whose uv is stretched and slanted: P = (0.1 u + 0.05 v, 0.4 v, 0) m.
sim::HeadMesh slantedPatch()
{
    sim::HeadMesh mesh = makePatchHead(8, 1.0F);
    for (std::size_t i = 0; i < mesh.uvs.size(); ++i) {
        const glm::vec2 uv = mesh.uvs[i];
        mesh.positionsHd[i] = {0.1F * uv.x + 0.05F * uv.y, 0.4F * uv.y, 0.0F};
    }
    return mesh;
}

Project projectOn(sim::HeadMesh mesh, int mapSize = 256, bool builtIn = true)
{
    Project project = patchProject(mapSize);
    project.head = headOf(std::move(mesh), builtIn);
    return project;
}

struct Painter
{
    Document document;
    std::vector<std::unique_ptr<Tool>> tools = makeTools();
    ToolSettings settings;
    Selection selection;
    bool mirror = false;

    explicit Painter(Project project) : document(std::move(project))
    {
        settings.hardness = 1.0F;
        settings.pressureSize = false;
        settings.brushSizeM = 0.04F;
    }
    ToolContext context()
    {
        return {.document = document,
                .target = firstLayer(document, MapKind::Gel),
                .settings = settings,
                .selection = selection,
                .mirror = mirror};
    }
    Tool& brush() { return *tools.front(); }
    void stroke(const std::vector<ToolEvent>& events)
    {
        ToolContext now = context();
        brush().press(events.front(), now);
        for (const ToolEvent& event : events)
            brush().move(event, now);
        brush().release(events.back(), now);
    }
    void uvStroke(const std::vector<glm::vec2>& uvs, Qt::KeyboardModifiers modifiers = {})
    {
        std::vector<ToolEvent> events;
        events.reserve(uvs.size());
        for (const glm::vec2& uv : uvs)
            events.push_back(paintEvent(document, uv.x, uv.y, 1.0F, modifiers));
        stroke(events);
    }
    const sim::TiledRaster& layer()
    {
        const LayerAddress at = context().target;
        return document.project().layer(at.group, at.map, at.layer)->raster;
    }
    double coverage(int x, int y) { return layer().texel(x, y)[1] / 65535.0; }
};

ToolEvent headEvent(const Document& document, glm::vec3 positionHd)
{
    ToolEvent event{.area = Area::Head, .point = document.project().head->skin->nearest(positionHd)};
    event.uv = event.point->uv;
    return event;
}

} // namespace

class TestBrush : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theRingOnTheSkinIsTheBrushSizeInTexels_data();
    void theRingOnTheSkinIsTheBrushSizeInTexels();
    void aDabIsNeverThinnerThanATexel();
    void howALineIsCutIntoEventsDoesNotShow();
    void aFastStrokeHasNoGaps();
    void overlappingDabsDoNotExceedTheOpacity();
    void pressureSetsTheSize();
    void shiftClickDrawsALineFromTheLastPoint();
    void bothAreasPaintTheSame();
    void aStrokeAcrossASeamDoesNotSmear();
    void aPointerThatLeavesTheHeadStartsAnew();
    void onOtherHeadsTheSkinReflects();
    void paintBleedsPastTheIslands();
};

void TestBrush::theRingOnTheSkinIsTheBrushSizeInTexels_data()
{
    QTest::addColumn<bool>("slanted");
    QTest::addColumn<int>("mapSize");
    for (const int mapSize : {256, 512})
        for (const bool slanted : {false, true})
            QTest::addRow("%s, %d", slanted ? "slanted" : "square", mapSize) << slanted << mapSize;
}

void TestBrush::theRingOnTheSkinIsTheBrushSizeInTexels()
{
    QFETCH(bool, slanted);
    QFETCH(int, mapSize);
    Painter painter(projectOn(slanted ? slantedPatch() : makePatchHead(), mapSize));
    painter.settings.brushSizeM = slanted ? 0.03F : 0.05F;
    painter.uvStroke({{0.5F, 0.5F}});
    const sim::Skin& skin = *painter.document.project().head->skin;
    const glm::vec3 centreHd = skin.atUv({0.5F, 0.5F})->positionHd;
    const float radiusM = 0.5F * painter.settings.brushSizeM;
    double covered = 0.0;
    for (int y = 0; y < mapSize; ++y)
        for (int x = 0; x < mapSize; ++x) {
            const glm::vec2 uv((static_cast<float>(x) + 0.5F) / static_cast<float>(mapSize),
                               1.0F - (static_cast<float>(y) + 0.5F) / static_cast<float>(mapSize));
            const float distanceM = glm::length(skin.atUv(uv)->positionHd - centreHd);
            const double mask = painter.coverage(x, y);
            covered += mask;
            if (distanceM > radiusM * 1.001F)
                QCOMPARE(mask, 0.0);
            if (distanceM < radiusM * 0.7F)
                QVERIFY(mask > 0.9);
        }
    // The disc's area on the skin, over a texel's: 0.04 m2 for the whole map of either patch.
    const double texelM2 = 0.04 / mapSize / mapSize;
    const double discTx = std::numbers::pi * radiusM * radiusM / texelM2;
    QVERIFY2(covered < discTx && covered > 0.8 * discTx, qPrintable(QString::number(covered / discTx)));
}

void TestBrush::aDabIsNeverThinnerThanATexel()
{
    Painter painter(projectOn(makePatchHead()));
    painter.settings.brushSizeM = 0.0001F; // An eighth of a texel.
    painter.uvStroke({{(100.0F + 0.5F) / 256.0F, (100.0F + 0.5F) / 256.0F}});
    QVERIFY(painter.coverage(100, 155) > 0.9);
}

void TestBrush::howALineIsCutIntoEventsDoesNotShow()
{
    const std::vector<glm::vec2> corners{{0.125F, 0.25F}, {0.75F, 0.5F}, {0.5F, 0.875F}};
    for (const bool slanted : {false, true}) {
        std::vector<sim::TiledRaster> results;
        for (const int pieces : {1, 2, 16, 256}) {
            std::vector<glm::vec2> path;
            for (std::size_t leg = 0; leg + 1 < corners.size(); ++leg)
                for (int i = 0; i < pieces; ++i)
                    path.push_back(
                        glm::mix(corners[leg], corners[leg + 1], static_cast<float>(i) / static_cast<float>(pieces)));
            path.push_back(corners.back());
            Painter painter(projectOn(slanted ? slantedPatch() : makePatchHead()));
            painter.settings.hardness = 0.5F;
            painter.uvStroke(path);
            results.push_back(painter.layer());
        }
        for (const sim::TiledRaster& result : results)
            QVERIFY(result == results.front());
    }
}

void TestBrush::aFastStrokeHasNoGaps()
{
    Painter painter(projectOn(makePatchHead()));
    painter.settings.brushSizeM = 0.01F; // 12.8 texels.
    painter.uvStroke({{0.1F, 0.5F}, {0.9F, 0.5F}});
    for (int x = 30; x < 226; ++x)
        for (int y = 124; y < 132; ++y)
            QCOMPARE(painter.coverage(x, y), 1.0);
}

void TestBrush::overlappingDabsDoNotExceedTheOpacity()
{
    Painter painter(projectOn(makePatchHead()));
    painter.settings.opacity = 0.5F;
    painter.uvStroke({{0.2F, 0.5F}, {0.8F, 0.5F}, {0.2F, 0.5F}});
    for (int x = 60; x < 200; ++x)
        QCOMPARE(static_cast<int>(painter.layer().texel(x, 128)[1]), 32768);
    painter.uvStroke({{0.5F, 0.5F}}); // Another stroke adds to it.
    QCOMPARE(static_cast<int>(painter.layer().texel(128, 128)[1]), 49152);
}

void TestBrush::pressureSetsTheSize()
{
    const auto covered = [](float pressure, bool sizes, bool fades) {
        Painter painter(projectOn(makePatchHead()));
        painter.settings.pressureSize = sizes;
        painter.settings.pressureOpacity = fades;
        painter.stroke({paintEvent(painter.document, 0.5F, 0.5F, pressure)});
        double sum = 0.0;
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x)
                sum += painter.coverage(x, y);
        return sum;
    };
    const double full = covered(1.0F, true, false);
    QVERIFY(std::abs(covered(0.5F, true, false) / full - 0.25) < 0.03);
    QVERIFY(std::abs(covered(0.5F, false, true) / full - 0.5) < 0.001);
    QCOMPARE(covered(0.5F, false, false), full);
}

void TestBrush::shiftClickDrawsALineFromTheLastPoint()
{
    Painter painter(projectOn(makePatchHead()));
    painter.uvStroke({{0.2F, 0.5F}});
    QCOMPARE(painter.coverage(128, 128), 0.0);
    painter.uvStroke({{0.8F, 0.5F}}, Qt::ShiftModifier);
    for (int x = 52; x < 204; ++x)
        QCOMPARE(painter.coverage(x, 128), 1.0);
    QCOMPARE(painter.document.undoStack().count(), 2);
}

void TestBrush::bothAreasPaintTheSame()
{
    Painter flat(projectOn(makePatchHead())), head(projectOn(makePatchHead()));
    std::vector<ToolEvent> flatStroke, headStroke;
    for (const float u : {0.25F, 0.5F, 0.625F}) {
        ToolEvent event = paintEvent(flat.document, u, 0.5F * u + 0.25F);
        flatStroke.push_back(event);
        event.area = Area::Head;
        headStroke.push_back(event);
    }
    flat.stroke(flatStroke);
    head.stroke(headStroke);
    QVERIFY(flat.layer() == head.layer());
}

void TestBrush::aStrokeAcrossASeamDoesNotSmear()
{
    Painter painter(projectOn(makeBallHead(), 512)); // The seam is at the back, u = 0 and 1.
    painter.settings.brushSizeM = 0.02F;
    std::vector<ToolEvent> path;
    for (int i = -3; i <= 3; ++i)
        path.push_back(headEvent(painter.document, glm::vec3(0.01F * static_cast<float>(i), 0.0F, -0.1F)));
    painter.stroke(path);
    QVERIFY(painter.coverage(2, 256) > 0.9);
    QVERIFY(painter.coverage(509, 256) > 0.9);
    for (int x = 60; x < 450; ++x) // The face and the sides were not touched.
        for (int y = 200; y < 300; ++y)
            QCOMPARE(painter.coverage(x, y), 0.0);
}

void TestBrush::aPointerThatLeavesTheHeadStartsAnew()
{
    Painter painter(projectOn(makePatchHead()));
    ToolEvent left = paintEvent(painter.document, 0.2F, 0.5F);
    ToolEvent right = paintEvent(painter.document, 0.8F, 0.5F);
    left.area = right.area = Area::Head;
    const ToolEvent off{.area = Area::Head};
    painter.stroke({left, off, right});
    QVERIFY(painter.coverage(51, 128) > 0.9);
    QVERIFY(painter.coverage(204, 128) > 0.9);
    QCOMPARE(painter.coverage(128, 128), 0.0);
    QCOMPARE(painter.document.undoStack().count(), 1);
}

void TestBrush::onOtherHeadsTheSkinReflects()
{
    // u no longer runs symmetrically: u' = u^2.
    sim::HeadMesh mesh = makePatchHead(32);
    for (glm::vec2& uv : mesh.uvs)
        uv.x *= uv.x;
    Painter painter(projectOn(std::move(mesh), 256, false));
    painter.mirror = true;
    painter.settings.brushSizeM = 0.01F;
    const sim::Skin& skin = *painter.document.project().head->skin;
    const auto point = skin.nearest({0.05F, 0.0F, 0.0F});
    painter.uvStroke({point.uv});
    const auto other = skin.nearest({-0.05F, 0.0F, 0.0F});
    const auto at = [&](glm::vec2 uv) {
        return painter.coverage(static_cast<int>(uv.x * 256.0F), static_cast<int>((1.0F - uv.y) * 256.0F));
    };
    QCOMPARE(at(point.uv), 1.0);
    QCOMPARE(at(other.uv), 1.0);
    QCOMPARE(at({1.0F - point.uv.x, 0.5F}), 0.0);
}

void TestBrush::paintBleedsPastTheIslands()
{
    sim::HeadMesh mesh = makePatchHead();
    for (glm::vec2& uv : mesh.uvs)
        uv = uv * 0.5F + 0.25F; // An island in the middle.
    Painter painter(projectOn(std::move(mesh)));
    painter.settings.brushSizeM = 0.04F; // 25.6 texels.
    painter.uvStroke({{0.26F, 0.5F}});
    QVERIFY(painter.coverage(70, 128) > 0.9);
    QVERIFY(painter.coverage(58, 128) > 0.9);
    painter.uvStroke({{0.1F, 0.1F}}); // Beside the island: the average size.
    QVERIFY(painter.coverage(25, 230) > 0.9);
    QVERIFY(painter.coverage(25 + 10, 230) > 0.5);
    QCOMPARE(painter.coverage(25 + 15, 230), 0.0);
}

HAIRPAINT_TEST(TestBrush, None)
#include "test_brush.moc"
