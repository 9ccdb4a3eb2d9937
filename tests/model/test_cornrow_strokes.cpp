// Cornrows that are painted: what makes a stroke a row of its own.
#include "model/files/png_codec.h"
#include "model/maps/texel_ops.h"
#include "model/tools/row_number.h"
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
};

HAIRPAINT_TEST(TestCornrowStrokes, Core)
#include "test_cornrow_strokes.moc"
