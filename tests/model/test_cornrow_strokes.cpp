// Cornrows that are painted: what makes a stroke a row of its own, and rows repeated between two.
#include "model/files/head_file.h"
#include "model/files/png_codec.h"
#include "model/maps/texel_ops.h"
#include "model/tools/row_number.h"
#include "model/tools/rows/row_repeat.h"
#include "tests/model/head_studio.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

constexpr int kCornrow = static_cast<int>(sim::BraidKind::Cornrow);

struct Braider : HeadStudio
{
    explicit Braider(Project project = patchProject(256)) : HeadStudio(std::move(project))
    {
        map = MapKind::Braid;
        settings.value(MapKind::Braid).index = kCornrow;
        settings.brushSizeM = 0.012F;
        settings.hardness = 1.0F;
        settings.pressureSize = false;
    }
    void stroke(float u0, float v0, float u1, float v1, Qt::KeyboardModifiers modifiers = {})
    {
        press(kBrush, u0, v0, 1.0F, modifiers);
        move(kBrush, u1, v1);
        release(kBrush, u1, v1);
    }
    int numberAt(float u, float v) { return shown()->sampleNearest({u, v})[0]; }
    std::set<int> numbers()
    {
        std::set<int> all;
        const auto raster = shown();
        for (int y = 0; y < raster->size(); ++y)
            for (int x = 0; x < raster->size(); ++x)
                all.insert(raster->texel(x, y)[0]);
        return all;
    }
};

/// Two rows down the patch, 8 cm apart.
void paintTwo(Braider& braider)
{
    braider.stroke(0.3F, 0.9F, 0.3F, 0.2F);
    braider.stroke(0.7F, 0.9F, 0.7F, 0.2F);
}

} // namespace

class TestCornrowStrokes : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void strokesThatTouchAreTwoRows()
    {
        Braider braider;
        braider.stroke(0.3F, 0.9F, 0.3F, 0.2F);
        QCOMPARE(braider.numberAt(0.3F, 0.5F), kCornrow); // The first is as rows always were.
        braider.stroke(0.35F, 0.9F, 0.35F, 0.2F);
        QCOMPARE(braider.numberAt(0.3F, 0.5F), kCornrow);
        QCOMPARE(braider.numberAt(0.35F, 0.5F), kCornrow + 1);
        braider.stroke(0.4F, 0.9F, 0.4F, 0.2F);
        QCOMPARE(braider.numberAt(0.4F, 0.5F), kCornrow + 2);
        QCOMPARE(braider.numbers(), (std::set<int>{0, kCornrow, kCornrow + 1, kCornrow + 2}));
        braider.document.undo();
        QCOMPARE(braider.numbers(), (std::set<int>{0, kCornrow, kCornrow + 1}));
    }

    void aStrokeBegunOnARowGoesOnWithIt()
    {
        Braider braider;
        paintTwo(braider);
        braider.stroke(0.3F, 0.5F, 0.4F, 0.5F);
        QCOMPARE(braider.numberAt(0.4F, 0.5F), kCornrow);
        braider.stroke(0.7F, 0.5F, 0.6F, 0.5F);
        QCOMPARE(braider.numberAt(0.6F, 0.5F), kCornrow + 1);
        braider.stroke(0.6F, 0.1F, 0.9F, 0.1F, Qt::ShiftModifier); // A line from the last point, which is on a row.
        QCOMPARE(braider.numberAt(0.85F, 0.1F), kCornrow + 1);
        QCOMPARE(braider.numbers(), (std::set<int>{0, kCornrow, kCornrow + 1}));
    }

    void otherBraidsAreOfOneNumber()
    {
        Braider braider;
        paintTwo(braider);
        braider.settings.value(MapKind::Braid).index = 2;
        braider.stroke(0.35F, 0.9F, 0.35F, 0.2F);
        braider.stroke(0.38F, 0.9F, 0.38F, 0.2F);
        QCOMPARE(braider.numbers(), (std::set<int>{0, 2, kCornrow, kCornrow + 1}));
    }

    void shapesAndFillsAreRowsOfTheirOwnToo()
    {
        Braider braider;
        paintTwo(braider);
        const QString shape = QStringLiteral("shape");
        braider.settings.shape = ShapeKind::Rectangle;
        braider.press(shape, 0.34F, 0.9F);
        braider.move(shape, 0.4F, 0.3F);
        braider.release(shape, 0.4F, 0.3F);
        QCOMPARE(braider.numberAt(0.37F, 0.5F), kCornrow + 2);
        braider.press(QStringLiteral("fill"), 0.5F, 0.5F);
        braider.release(QStringLiteral("fill"), 0.5F, 0.5F);
        QCOMPARE(braider.numberAt(0.5F, 0.5F), kCornrow + 3);
        QCOMPARE(braider.numberAt(0.3F, 0.5F), kCornrow);
    }

    void thePickerTakesACornrowNotItsNumber()
    {
        Braider braider;
        paintTwo(braider);
        braider.settings.value(MapKind::Braid).index = 1;
        braider.press(QStringLiteral("picker"), 0.7F, 0.5F);
        QCOMPARE(braider.settings.value(MapKind::Braid).index, kCornrow);
    }

    void aNumberedRowIsCalledACornrowAndHasItsColour()
    {
        const MapSpec& spec = mapSpec(MapKind::Braid);
        const auto text = [&](int index) { return texelOps(spec).text({}, spec, {.index = index}); };
        QCOMPARE(text(kCornrow + 5), text(kCornrow));
        QCOMPARE(colourOfTexel(spec, {kCornrow + 2, 0, 0, 0}, false), colourOfTexel(spec, {kCornrow, 0, 0, 0}, false));
        const QColor other(colourOfTexel(spec, {kCornrow + 1, 0, 0, 0}, false));
        QVERIFY(other != QColor(colourOfTexel(spec, {kCornrow, 0, 0, 0}, false)));
        QCOMPARE(colourToIndex(spec, static_cast<float>(other.redF()), static_cast<float>(other.greenF()),
                               static_cast<float>(other.blueF())),
                 std::uint16_t{kCornrow});
        QCOMPARE(spec.entryOf(sim::kLastRowNumber), std::size_t{kCornrow});
        QCOMPARE(spec.entryOf(sim::kLastRowNumber + 1), std::size_t{0});
    }

    void layersKeepTheNumbersInFiles()
    {
        Braider braider;
        paintTwo(braider);
        const sim::TiledRaster& layer = braider.layer();
        const MapSpec& spec = mapSpec(MapKind::Braid);
        const auto decoded = decodeLayer(encodeLayer(layer).bytes, spec, layer.size());
        QVERIFY(decoded.has_value());
        QVERIFY(decoded->raster == layer);
    }

    void numbersThatAreUsedUpBeginAnew()
    {
        Braider braider;
        const LayerAddress at = firstLayer(braider.document, MapKind::Braid);
        Project project = braider.document.project();
        MapStack stack = project.group(at.group)->map(MapKind::Braid);
        sim::TiledRaster& raster = stack.layers.front().raster;
        raster.setUniform(0, {kCornrow, 65535, 0, 0});
        raster.setUniform(1, {sim::kLastRowNumber - 1, 65535, 0, 0});
        QCOMPARE(newRowNumbers(stack, 3),
                 (std::vector<std::uint16_t>{sim::kLastRowNumber, kCornrow + 1, kCornrow + 2}));
    }

    /// On a flat patch the lines are where anybody would draw them.
    void rowsAreRepeatedBetweenTwo()
    {
        Braider braider;
        paintTwo(braider);
        const auto before = braider.shown();
        RowRepeat repeat(braider.context(), QStringLiteral("Repeat"));
        QCOMPARE(repeat.problem(), QString());
        // 8 cm, each about 1.2 cm and its parting.
        QVERIFY2(std::abs(repeat.fittingCount() - 4.5) < 1.0, qPrintable(QString::number(repeat.fittingCount())));
        repeat.show(1);
        QCOMPARE(braider.numbers(), (std::set<int>{0, kCornrow, kCornrow + 1, kCornrow + 2}));
        repeat.show(3);
        repeat.commit();
        for (int k = 0; k < 3; ++k) {
            const float u = 0.4F + 0.1F * static_cast<float>(k);
            for (const float v : {0.25F, 0.5F, 0.85F}) {
                QCOMPARE(braider.numberAt(u, v), kCornrow + 2 + k);
                QCOMPARE(braider.numberAt(u + 0.05F, v), 0); // The partings.
            }
            QCOMPARE(braider.numberAt(u, 0.97F), 0);
        }
        QCOMPARE(braider.document.undoStack().count(), 3);
        braider.document.undo();
        QVERIFY(*braider.shown() == *before);
    }

    void crowdedRowsAreNarrowerAndLeaveTheTwoAlone()
    {
        Braider braider;
        paintTwo(braider);
        RowRepeat repeat(braider.context(), QStringLiteral("Repeat"));
        repeat.show(kMostRowsBetween);
        repeat.commit();
        QCOMPARE(braider.numbers().size(), std::size_t{kMostRowsBetween + 3});
        QCOMPARE(braider.numberAt(0.3F, 0.5F), kCornrow);
        QCOMPARE(braider.numberAt(0.7F, 0.5F), kCornrow + 1);
    }

    void theTwoPaintedLastAreRepeatedOrTheTwoSelected()
    {
        Braider braider;
        paintTwo(braider);
        braider.stroke(0.9F, 0.9F, 0.9F, 0.2F);
        {
            RowRepeat repeat(braider.context(), QStringLiteral("Repeat"));
            repeat.show(1);
            QVERIFY(braider.numberAt(0.8F, 0.5F) > kCornrow + 2);
            QCOMPARE(braider.numberAt(0.5F, 0.5F), 0);
        }
        QCOMPARE(braider.numberAt(0.8F, 0.5F), 0); // It was dropped.
        braider.selection.setRectangle(QRectF(0.2, 0.4, 0.6, 0.2));
        RowRepeat repeat(braider.context(), QStringLiteral("Repeat"));
        repeat.show(1);
        QVERIFY(braider.numberAt(0.5F, 0.5F) > kCornrow + 2);
        QCOMPARE(braider.numberAt(0.5F, 0.8F), 0); // Outside the selection nothing is painted.
    }

    void whatCannotBeRepeatedIsASentence()
    {
        Braider braider;
        const auto problem = [&] { return RowRepeat(braider.context(), QStringLiteral("Repeat")).problem(); };
        const QString none = problem();
        QVERIFY(none.contains(QStringLiteral("fewer than two cornrows")));
        braider.stroke(0.3F, 0.9F, 0.3F, 0.2F);
        QCOMPARE(problem(), none);
        braider.stroke(0.7F, 0.9F, 0.7F, 0.2F);
        QCOMPARE(problem(), QString());
        braider.stroke(0.9F, 0.9F, 0.9F, 0.2F);
        braider.selection.setRectangle(QRectF(0.2, 0.4, 0.2, 0.2));
        QVERIFY(problem().startsWith(QStringLiteral("Fewer than two")));
        braider.selection.setRectangle(QRectF(0.0, 0.4, 1.0, 0.2));
        QVERIFY(problem().startsWith(QStringLiteral("More than two")));
    }

    /// As files of older programs have them: all of one number.
    void rowsOfOneNumberAreRepeatedWhereTheyAreTwo()
    {
        Braider braider;
        braider.settings.shape = ShapeKind::Rectangle;
        paintTwo(braider);
        Project project = braider.document.project();
        MapStack stack = project.groups.front().map(MapKind::Braid);
        sim::TiledRaster& raster = stack.layers.front().raster;
        for (int index = 0; index < raster.tileCount(); ++index) {
            const std::span<std::uint16_t> pixels = raster.writableTile(index);
            for (std::size_t at = 0; at < pixels.size(); at += 2)
                pixels[at] = std::min<std::uint16_t>(pixels[at], kCornrow);
            raster.compact(index);
        }
        project.groups.front().map(MapKind::Braid) = stack;
        Braider older(std::move(project));
        QCOMPARE(RowRepeat(older.context(), QStringLiteral("Repeat")).problem(), QString());
        older.stroke(0.9F, 0.9F, 0.9F, 0.2F);
        QCOMPARE(RowRepeat(older.context(), QStringLiteral("Repeat")).problem(), QString());
    }

    /// On a head: no row leaves the skin, and each lies between its neighbours.
    void onAHeadRowsLieOnTheSkinSideBySide()
    {
        Project project = patchProject(512);
        project.head = *builtInHead(QStringLiteral("bust-1"));
        const sim::Skin& skin = *project.head->skin;
        const auto overHead = [&](float x) {
            sim::BraidRow row;
            std::vector<glm::vec3> strip;
            for (int i = 0; i < 200; ++i) {
                const float angle = 0.5F + 1.6F * static_cast<float>(i) / 199.0F;
                const auto hit = skin.pick({.originHd = glm::vec3(x, 0.5F * std::sin(angle), 0.5F * std::cos(angle)),
                                            .directionHd = -glm::vec3(0.0F, std::sin(angle), std::cos(angle))});
                if (hit)
                    strip.push_back(hit->positionHd);
            }
            return sim::rowAlong(skin, strip, {0.0F, 0.0F, -1.0F});
        };
        const sim::BraidRow one = overHead(0.0F);
        const sim::BraidRow other = overHead(0.05F);
        const auto lines = linesBetween(skin, one, other, 4);
        QCOMPARE(lines.size(), std::size_t{4});
        const auto away = [](glm::vec3 a, glm::vec3 b) { return glm::distance(a, b); };
        const bool isOpposite =
            away(one.pointsHd.front(), other.pointsHd.back()) + away(one.pointsHd.back(), other.pointsHd.front()) <
            away(one.pointsHd.front(), other.pointsHd.front()) + away(one.pointsHd.back(), other.pointsHd.back());
        for (std::size_t i = 0; i < lines.front().size(); ++i) {
            const float at = static_cast<float>(i) / static_cast<float>(lines.front().size() - 1);
            glm::vec3 last = onRow(one, at * one.lengthM, 0.0F);
            std::vector<float> gaps;
            for (const RowLine& line : lines) {
                QVERIFY(glm::distance(skin.nearest(line[i].positionHd).positionHd, line[i].positionHd) < 1e-4F);
                gaps.push_back(glm::distance(line[i].positionHd, last));
                last = line[i].positionHd;
            }
            const float there = isOpposite ? 1.0F - at : at;
            gaps.push_back(glm::distance(onRow(other, there * other.lengthM, 0.0F), last));
            const auto [least, most] = std::ranges::minmax(gaps);
            QVERIFY2(most < 1.25F * least, qPrintable(QStringLiteral("%1 %2").arg(least).arg(most)));
        }
    }

    void mirroredRowsAreRepeatedOnBothSides()
    {
        Project project = patchProject(512);
        project.head = *builtInHead(QStringLiteral("bust-1"));
        Braider braider(std::move(project));
        braider.mirror = true;
        braider.settings.brushSizeM = 0.008F;
        const auto row = [&](float x) {
            ToolContext now = braider.context();
            Tool& brush = braider.tool(kBrush);
            brush.press(braider.eventAt({x, 0.12F, 0.05F}), now);
            brush.move(braider.eventAt({x, 0.12F, 0.0F}), now);
            brush.move(braider.eventAt({x, 0.12F, -0.05F}), now);
            brush.release(braider.eventAt({x, 0.12F, -0.05F}), now);
        };
        row(0.015F);
        row(0.06F);
        RowRepeat repeat(braider.context(), QStringLiteral("Repeat"));
        QCOMPARE(repeat.problem(), QString());
        repeat.show(2);
        repeat.commit();
        const auto raster = braider.shown();
        int painted = 0;
        for (int y = 0; y < raster->size(); ++y)
            for (int x = 0; x < raster->size(); ++x) {
                QCOMPARE(raster->texel(x, y)[0], raster->texel(raster->size() - 1 - x, y)[0]);
                painted += raster->texel(x, y)[0] == kCornrow + 3 ? 1 : 0;
            }
        QVERIFY(painted > 100);
        // Between a row on the left and its own mirror image.
        braider.document.undo();
        braider.document.undo();
        RowRepeat across(braider.context(), QStringLiteral("Repeat"));
        QCOMPARE(across.problem(), QString());
        across.show(2);
        across.commit();
        QCOMPARE(braider.numbers(), (std::set<int>{0, kCornrow, kCornrow + 1, kCornrow + 2}));
    }
};

HAIRPAINT_TEST(TestCornrowStrokes, Core)
#include "test_cornrow_strokes.moc"
