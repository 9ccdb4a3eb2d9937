// Each tool alone: what it selects, takes, fills and covers.
#include "tests/model/tool_studio.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

class TestToolResults : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theSelectToolSelects();
    void theEyedropperTakesTheValue();
    void aFillStopsWhereValuesDiffer();
    void aGradientRunsFromTheFirstValueToTheSecond();
    void aGradientOfOneValueFadesOut();
    void shapesCoverTheirArea_data();
    void shapesCoverTheirArea();
    void polygonsAreClickedCornerByCorner();
};

void TestToolResults::theSelectToolSelects()
{
    Studio studio;
    const QString select = QStringLiteral("select");
    studio.press(select, 0.75F, 0.25F);
    studio.move(select, 0.25F, 0.5F);
    studio.release(select, 0.25F, 0.5F);
    QCOMPARE(studio.selection.rectangle(), std::optional(QRectF(0.25, 0.25, 0.5, 0.25)));
    studio.press(select, 0.5F, 0.5F);
    studio.move(select, 1.5F, 0.75F);
    QCOMPARE(studio.selection.rectangle(), std::optional(QRectF(0.5, 0.5, 0.5, 0.25))); // Not past the map.
    ToolContext context = studio.context();
    studio.tool(select).cancel(context);
    QCOMPARE(studio.selection.rectangle(), std::optional(QRectF(0.25, 0.25, 0.5, 0.25)));
    studio.press(select, 0.5F, 0.5F);
    studio.move(select, 0.75F, 0.625F, 1.0F, Qt::ShiftModifier);
    studio.release(select, 0.75F, 0.625F, Qt::ShiftModifier);
    QCOMPARE(studio.selection.rectangle(), std::optional(QRectF(0.5, 0.5, 0.25, 0.25)));
    studio.press(select, 0.5F, 0.5F);
    studio.release(select, 0.5F, 0.5F);
    QVERIFY(!studio.selection.rectangle());
    QCOMPARE(studio.document.undoStack().count(), 0);
}

void TestToolResults::theEyedropperTakesTheValue()
{
    Studio studio;
    studio.settings.value(MapKind::Length).scalar = 0.75F;
    studio.settings.hardness = 1.0F;
    studio.press(kBrush, 0.25F, 0.25F);
    studio.release(kBrush, 0.25F, 0.25F);
    studio.settings.value(MapKind::Length).scalar = 0.1F;
    studio.press(QStringLiteral("picker"), 0.25F, 0.25F);
    studio.release(QStringLiteral("picker"), 0.25F, 0.25F);
    QVERIFY(std::abs(studio.settings.value(MapKind::Length).scalar - 0.75F) < 1e-4F);
    for (const auto& tool : studio.tools) { // Ctrl+click with any tool.
        studio.settings.value(MapKind::Length).scalar = 0.1F;
        const QString id = QString::fromLatin1(tool->name());
        studio.press(id, 0.25F, 0.25F, 1.0F, Qt::ControlModifier);
        studio.release(id, 0.25F, 0.25F);
        QVERIFY2(std::abs(studio.settings.value(MapKind::Length).scalar - 0.75F) < 1e-4F, qPrintable(id));
    }
    QCOMPARE(studio.document.undoStack().count(), 1);
}

void TestToolResults::aFillStopsWhereValuesDiffer()
{
    Project project = patchProject();
    sim::TiledRaster& raster = project.groups.front().map(MapKind::Length).layers.front().raster;
    for (int i = 0; i < 256; ++i)
        raster.setTexel(100, i, {65535, 65535, 0, 0}); // A wall.
    Studio studio(std::move(project));
    studio.settings.value(MapKind::Length).scalar = 0.25F;
    studio.press(QStringLiteral("fill"), 0.1F, 0.5F);
    studio.release(QStringLiteral("fill"), 0.1F, 0.5F);
    QCOMPARE(studio.document.undoStack().undoText(), QStringLiteral("Fill on Length"));
    for (const int x : {0, 50, 99})
        QCOMPARE(static_cast<int>(studio.shown()->texel(x, 128)[0]), 16384);
    QCOMPARE(static_cast<int>(studio.shown()->texel(100, 128)[0]), 65535);
    for (const int x : {101, 255})
        QCOMPARE(static_cast<int>(studio.shown()->texel(x, 128)[0]), 32768);
    studio.settings.fillTolerance = 1.0F; // All alike now.
    studio.press(QStringLiteral("fill"), 0.1F, 0.5F);
    studio.release(QStringLiteral("fill"), 0.1F, 0.5F);
    for (const int x : {0, 100, 255})
        QCOMPARE(static_cast<int>(studio.shown()->texel(x, 128)[0]), 16384);
}

void TestToolResults::aGradientRunsFromTheFirstValueToTheSecond()
{
    Studio studio;
    studio.settings.value(MapKind::Length).scalar = 1.0F;
    studio.settings.secondValue(MapKind::Length).scalar = 0.0F;
    const QString gradient = QStringLiteral("gradient");
    studio.press(gradient, 0.25F, 0.5F);
    studio.move(gradient, 0.75F, 0.5F);
    studio.release(gradient, 0.75F, 0.5F);
    const auto at = [&](int x, int y) { return static_cast<int>(studio.shown()->texel(x, y)[0]); };
    QCOMPARE(at(10, 10), 65535);
    QCOMPARE(at(250, 200), 0);
    for (const int x : {70, 100, 128, 180}) {
        const double expected = 65535.0 * (1.0 - (x + 0.5 - 64.0) / 128.0);
        QVERIFY(std::abs(at(x, 30) - expected) <= 1.0);
        QCOMPARE(at(x, 30), at(x, 220));
    }
    studio.settings.gradient = GradientKind::Radial;
    studio.press(gradient, 0.5F, 0.5F);
    studio.release(gradient, 0.75F, 0.5F);
    QCOMPARE(at(128 + 64, 128 + 64), 0);
    QVERIFY(std::abs(at(128 + 32, 128) - at(128, 128 + 32)) <= 1);
    QVERIFY(std::abs(at(128 + 32, 128) - 65535 * (1.0 - std::hypot(32.5, 0.5) / 64.0)) <= 2.0);
}

void TestToolResults::aGradientOfOneValueFadesOut()
{
    Studio studio;
    studio.settings.value(MapKind::Length) = studio.settings.secondValue(MapKind::Length);
    studio.press(QStringLiteral("gradient"), 0.0F, 0.5F);
    studio.release(QStringLiteral("gradient"), 1.0F, 0.5F);
    QVERIFY(studio.layer().texel(0, 9)[1] > 65000);
    QVERIFY(std::abs(studio.layer().texel(128, 9)[1] - 32640) <= 1);
    QVERIFY(studio.layer().texel(255, 9)[1] < 300);
}

void TestToolResults::shapesCoverTheirArea_data()
{
    QTest::addColumn<int>("shape");
    QTest::addColumn<int>("modifiers");
    QTest::addColumn<double>("areaTx");
    QTest::newRow("rectangle") << static_cast<int>(ShapeKind::Rectangle) << 0 << 128.0 * 64.0;
    QTest::newRow("square") << static_cast<int>(ShapeKind::Rectangle) << static_cast<int>(Qt::ShiftModifier)
                            << 128.0 * 128.0;
    QTest::newRow("ellipse") << static_cast<int>(ShapeKind::Ellipse) << 0 << 3.14159265 * 64.0 * 32.0;
    QTest::newRow("circle") << static_cast<int>(ShapeKind::Ellipse) << static_cast<int>(Qt::ShiftModifier)
                            << 3.14159265 * 64.0 * 64.0;
}

void TestToolResults::shapesCoverTheirArea()
{
    QFETCH(int, shape);
    QFETCH(int, modifiers);
    QFETCH(double, areaTx);
    Studio studio;
    studio.settings.shape = static_cast<ShapeKind>(shape);
    const QString id = QStringLiteral("shape");
    const Qt::KeyboardModifiers held(QFlag{modifiers});
    studio.press(id, 0.25F, 0.75F);
    studio.move(id, 0.9F, 0.1F); // Larger than in the end.
    studio.move(id, 0.75F, 0.5F, 1.0F, held);
    QVERIFY(!studio.tool(id).overlay().empty());
    studio.release(id, 0.75F, 0.5F, held);
    double covered = 0.0;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            covered += studio.layer().texel(x, y)[1] / 65535.0;
    QVERIFY2(std::abs(covered / areaTx - 1.0) < 0.005, qPrintable(QString::number(covered)));
    QCOMPARE(studio.document.undoStack().undoText(), QStringLiteral("Shape on Length"));
}

void TestToolResults::polygonsAreClickedCornerByCorner()
{
    Studio studio;
    studio.settings.shape = ShapeKind::Polygon;
    const QString id = QStringLiteral("shape");
    const auto click = [&](float u, float v) {
        studio.press(id, u, v);
        studio.release(id, u, v);
    };
    click(0.25F, 0.25F);
    click(0.75F, 0.25F);
    click(0.25F, 0.75F);
    QVERIFY(studio.tool(id).active());
    click(0.252F, 0.252F);
    QVERIFY(!studio.tool(id).active());
    QCOMPARE(studio.document.undoStack().count(), 1);
    QCOMPARE(static_cast<int>(studio.layer().texel(80, 170)[1]), 65535);
    QCOMPARE(static_cast<int>(studio.layer().texel(180, 80)[1]), 0);
    studio.press(id, 0.1F, 0.1F); // Drawn in one go.
    studio.move(id, 0.2F, 0.1F);
    studio.move(id, 0.2F, 0.2F);
    studio.release(id, 0.1F, 0.2F);
    QVERIFY(!studio.tool(id).active());
    QCOMPARE(studio.document.undoStack().count(), 2);
}

HAIRPAINT_TEST(TestToolResults, Gui)
#include "test_tool_results.moc"
