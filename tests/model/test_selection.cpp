// The selection: what is added to it, what inverting leaves, and that nothing happens outside of it.
#include "model/tools/live_edit.h"
#include "model/tools/selecting/clipboard.h"
#include "model/tools/strokes/selection.h"
#include "tests/model/tool_studio.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <random>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

constexpr int kSelectionSize = 256;

const sim::TiledRaster& rasterOf(const Document& document, MapKind map)
{
    const LayerAddress at = firstLayer(document, map);
    return document.project().layer(at.group, at.map, at.layer)->raster;
}

/// How many rectangles hold each texel.
std::vector<int> covered(const Selection& selection)
{
    std::vector<int> texels(std::size_t{kSelectionSize} * kSelectionSize);
    for (const sim::TexelRect& rect : selectedTexels(selection, kSelectionSize))
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x)
                ++texels[static_cast<std::size_t>(y) * kSelectionSize + static_cast<std::size_t>(x)];
    return texels;
}

/// Drags with the select tool from one corner to the other.
void drag(Studio& studio, const QRectF& rectangle, Qt::KeyboardModifiers modifiers)
{
    const QString select = QStringLiteral("select");
    const auto u0 = static_cast<float>(rectangle.left());
    const auto v0 = static_cast<float>(rectangle.top());
    const auto u1 = static_cast<float>(rectangle.right());
    const auto v1 = static_cast<float>(rectangle.bottom());
    studio.press(select, u0, v0, 1.0F, modifiers);
    studio.move(select, (u0 + u1) / 2.0F, (v0 + v1) / 2.0F, 1.0F, modifiers);
    studio.release(select, u1, v1, modifiers);
}

} // namespace

class TestSelection : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void shiftAddsARectangle()
    {
        Studio studio;
        drag(studio, {0.25, 0.25, 0.25, 0.25}, {});
        drag(studio, {0.375, 0.375, 0.375, 0.25}, Qt::ShiftModifier);
        QCOMPARE(studio.selection.rectangle(), std::optional(QRectF(0.25, 0.25, 0.5, 0.375)));
        const std::vector<int> texels = covered(studio.selection);
        QCOMPARE(std::ranges::count(texels, 1), 64 * 64 + 96 * 64 - 32 * 32);
        QCOMPARE(std::ranges::count(texels, 0), kSelectionSize * kSelectionSize - std::ranges::count(texels, 1));
        QCOMPARE(studio.selection.outlines().size(), std::size_t{1});
        QCOMPARE(studio.selection.outlines().front().size(), 8); // two rectangles that overlap at a corner
        // A click with Shift adds nothing and takes nothing away; without, it selects nothing.
        drag(studio, {0.9, 0.9, 0.0, 0.0}, Qt::ShiftModifier);
        QCOMPARE(covered(studio.selection), texels);
        drag(studio, {0.9, 0.9, 0.0, 0.0}, {});
        QVERIFY(studio.selection.rectangles().empty());
    }

    void cancellingBringsTheOldSelectionBack()
    {
        Studio studio;
        drag(studio, {0.25, 0.25, 0.25, 0.25}, {});
        const std::vector<QRectF> before = studio.selection.rectangles();
        studio.press(QStringLiteral("select"), 0.5F, 0.5F, 1.0F, Qt::ShiftModifier);
        studio.move(QStringLiteral("select"), 0.9F, 0.9F, 1.0F, Qt::ShiftModifier);
        QVERIFY(studio.selection.rectangles() != before);
        ToolContext context = studio.context();
        studio.tool(QStringLiteral("select")).cancel(context);
        QCOMPARE(studio.selection.rectangles(), before);
    }

    void anySelectionAndItsInverseCoverEachTexelOnce()
    {
        std::mt19937 random(8);
        const auto fraction = [&random] { return static_cast<double>(random() % 1000) / 1000.0; };
        for (int round = 0; round < 30; ++round) {
            Selection selection;
            std::vector<QRectF> rectangles;
            for (int i = 0; i < 4; ++i) {
                const QRectF one =
                    QRectF(QPointF(fraction(), fraction()), QPointF(fraction(), fraction())).normalized();
                rectangles = without(rectangles, one);
                rectangles.push_back(one);
            }
            selection.setRectangles(rectangles);
            std::vector<int> texels = covered(selection);
            QVERIFY(std::ranges::max(texels) == 1);
            selection.invert();
            const std::vector<int> rest = covered(selection);
            for (std::size_t i = 0; i < texels.size(); ++i)
                QCOMPARE(texels[i] + rest[i], 1);
            selection.invert();
            QCOMPARE(covered(selection), texels);
        }
    }

    void nothingInvertedIsEverything()
    {
        Selection selection;
        selection.invert();
        QCOMPARE(selection.rectangles(), std::vector<QRectF>{QRectF(0.0, 0.0, 1.0, 1.0)});
        selection.invert();
        QVERIFY(selection.rectangles().empty());
    }

    void toolsPaintInEveryRectangleAndNowhereElse_data()
    {
        QTest::addColumn<QString>("tool");
        for (const char* tool : {"brush", "fill", "gradient", "shape"})
            QTest::newRow(tool) << QString::fromLatin1(tool);
    }
    void toolsPaintInEveryRectangleAndNowhereElse()
    {
        QFETCH(QString, tool);
        Studio studio;
        studio.map = MapKind::Gel;
        studio.selection.setRectangles({QRectF(0.25, 0.25, 0.125, 0.5), QRectF(0.5, 0.25, 0.25, 0.5)});
        const sim::TiledRaster before = studio.layer();
        const std::vector<int> inside = covered(studio.selection);
        studio.settings.brushSizeM = 0.05F;
        for (const float u : {0.3F, 0.6F}) {
            studio.press(tool, u, 0.3F);
            studio.move(tool, u + 0.15F, 0.6F);
            studio.release(tool, u + 0.15F, 0.6F);
        }
        std::array<int, 2> changed{}; // in the left and in the right one
        for (int y = 0; y < kSelectionSize; ++y)
            for (int x = 0; x < kSelectionSize; ++x) {
                if (studio.layer().texel(x, y) == before.texel(x, y))
                    continue;
                QCOMPARE(inside[static_cast<std::size_t>(y) * kSelectionSize + static_cast<std::size_t>(x)], 1);
                ++changed[x < 112 ? 0 : 1];
            }
        QVERIFY2(changed[0] > 100 && changed[1] > 100,
                 qPrintable(QStringLiteral("%1 and %2").arg(changed[0]).arg(changed[1])));
    }

    void aCopyOfSeveralRectanglesLeavesOutWhatLiesBetween()
    {
        Document document(filledPatch(MapKind::Gel, 50000));
        Selection selection;
        selection.setRectangles({QRectF(0.0, 0.0, 0.25, 0.25), QRectF(0.5, 0.5, 0.25, 0.25)});
        const Clip clip = copyClip(document, firstLayer(document, MapKind::Gel), selection);
        QCOMPARE(clip.width, 192);
        QCOMPARE(clip.height, 192);
        QCOMPARE(std::ranges::count_if(clip.texels, [](const sim::Texel& t) { return t[1] != 0; }), 2 * 64 * 64);
        document.push(pasteCommand(document, firstLayer(document, MapKind::Clump), clip, {}));
        document.push(clearCommand(document, firstLayer(document, MapKind::Gel), selection, QStringLiteral("Clear")));
        const std::vector<int> inside = covered(selection);
        for (int y = 0; y < kSelectionSize; ++y)
            for (int x = 0; x < kSelectionSize; ++x) {
                const bool in = inside[static_cast<std::size_t>(y) * kSelectionSize + static_cast<std::size_t>(x)] == 1;
                QCOMPARE(rasterOf(document, MapKind::Clump).texel(x, y)[1], in ? 65535 : 0);
                QCOMPARE(rasterOf(document, MapKind::Gel).texel(x, y)[1], in ? 0 : 65535);
            }
    }

    void pastingStaysInTheSelection()
    {
        Document document(filledPatch(MapKind::Gel, 50000));
        Selection selection;
        selection.setRectangle(QRectF(0.25, 0.25, 0.5, 0.5));
        const Clip clip = copyClip(document, firstLayer(document, MapKind::Gel), selection);
        selection.setRectangle(QRectF(0.5, 0.5, 0.125, 0.25));
        document.push(pasteCommand(document, firstLayer(document, MapKind::Clump), clip, selection));
        for (int y = 0; y < kSelectionSize; ++y)
            for (int x = 0; x < kSelectionSize; ++x)
                QCOMPARE(rasterOf(document, MapKind::Clump).texel(x, y)[1],
                         x >= 128 && x < 160 && y >= 64 && y < 128 ? 65535 : 0);
    }
};

HAIRPAINT_TEST(TestSelection, Core)
#include "test_selection.moc"
