// What the flat map tells about itself: which side is which, on every map's colours, and what the colours mean.
#include "model/files/head_file.h"
#include "tests/support/test_program.h"
#include "tests/support/view_fixture.h"
#include "view/paint_area/landmarks.h"
#include "view/paint_area/map_legend.h"
#include "view/paint_area/paint_view.h"

#include <QTest>

using namespace hairpaint;

class TestMapSigns : public QObject
{
    Q_OBJECT
private:
    /// Where the skin is that a label names, x of the head's space: its own left is at +x.
    static float sideOf(const model::Head& head, const QString& name)
    {
        for (const view::Landmark& landmark : view::landmarksOf(head))
            if (landmark.name == name)
                return head.skin->atUv(landmark.uv).value().positionHd.x;
        return 0.0F;
    }

private Q_SLOTS:
    void leftAndRightAreToldApartOnEveryHead()
    {
        const std::shared_ptr<const model::Head> bust = model::defaultHead();
        QVERIFY(sideOf(*bust, QStringLiteral("left ear")) > 0.05F);
        QVERIFY(sideOf(*bust, QStringLiteral("right ear")) < -0.05F);
        model::Head ball;
        ball.builtIn = false;
        ball.skin = std::make_shared<const sim::Skin>(test::makeBallHead());
        QVERIFY(sideOf(ball, QStringLiteral("L")) > 0.09F);
        QVERIFY(sideOf(ball, QStringLiteral("R")) < -0.09F);
    }

    void labelsAreReadOnEveryMapsColours_data()
    {
        QTest::addColumn<model::MapKind>("map");
        QTest::addColumn<bool>("night");
        for (const model::MapSpec& spec : model::mapSpecs())
            for (const bool night : {false, true})
                QTest::addRow("%s, %s", spec.id, night ? "night" : "day") << spec.kind << night;
    }
    void labelsAreReadOnEveryMapsColours()
    {
        QFETCH(model::MapKind, map);
        QFETCH(bool, night);
        test::Editor editor(test::makeProject(test::makeBallHead()));
        editor.state.options().setNightPaper(night);
        editor.state.target().setMap(map);
        const model::Project& project = editor.document.project();
        view::PaintView area(editor.state, view::Theme::of(view::ThemeKind::Dark));
        area.resize(600, 600);
        const model::MapSpec& spec = model::mapSpec(map);
        for (const std::uint16_t value : {std::uint16_t{0}, std::uint16_t{65535}}) {
            model::EditSession painted;
            editor.document.show(painted, {}, {.aspect = model::Change::Aspect::Everything},
                                 [&](model::Project& shown) {
                                     const model::LayerAddress at = editor.state.target().address();
                                     sim::Texel texel{value, value, value, value};
                                     texel[static_cast<std::size_t>(spec.valueChannels)] = 65535;
                                     if (spec.texel == model::TexelKind::Index)
                                         texel[0] = value == 0 ? 0 : 1;
                                     sim::TiledRaster& raster = shown.layer(at.group, at.map, at.layer)->raster;
                                     for (int tile = 0; tile < raster.tileCount(); ++tile)
                                         raster.setUniform(tile, texel);
                                 });
            const QImage picture = area.grab().toImage();
            for (const view::Landmark& landmark : view::landmarksOf(*project.head)) {
                const QPoint at = area.positionOf(landmark.uv).toPoint();
                int darkest = 255;
                int lightest = 0;
                for (int y = at.y() + 8; y < at.y() + 19; ++y)
                    for (int x = at.x() - 3; x <= at.x() + 3; ++x) {
                        const int grey = qGray(picture.pixel(x, y));
                        darkest = std::min(darkest, grey);
                        lightest = std::max(lightest, grey);
                    }
                QVERIFY2(lightest - darkest > 60, qPrintable(QString::number(lightest - darkest)));
            }
        }
    }

    void theLegendTellsWhatTheColoursMean()
    {
        test::Editor editor(test::makeProject(test::makeBallHead()));
        view::PaintView area(editor.state, view::Theme::of(view::ThemeKind::Dark));
        area.resize(600, 600);
        area.show();
        editor.state.target().setMap(model::MapKind::Length);
        const auto* legend = area.findChild<view::MapLegend*>();
        QVERIFY(legend->isVisible());
        QCOMPARE(legend->title(), QStringLiteral("Length, cm"));
        QStringList ticks;
        for (const view::MapLegend::Tick& tick : legend->ticks())
            ticks.append(tick.text);
        QVERIFY2(ticks.startsWith(QStringLiteral("0")) && ticks.endsWith(QStringLiteral("30")) && ticks.size() > 2,
                 qPrintable(ticks.join(QLatin1Char(' '))));
        editor.state.target().setMap(model::MapKind::Colour);
        QVERIFY(!legend->isVisible());
    }

    void theLegendHidesUnderThePointer()
    {
        test::Editor editor(test::makeProject(test::makeBallHead()));
        view::PaintView area(editor.state, view::Theme::of(view::ThemeKind::Dark));
        area.resize(900, 900);
        area.show();
        editor.state.target().setMap(model::MapKind::Direction);
        auto* legend = area.findChild<view::MapLegend*>();
        QVERIFY(legend->isVisible() && !legend->folded());
        QTest::mouseMove(&area, QPoint(450, 450));
        QVERIFY(!legend->faded());
        const QImage whole = legend->grab().toImage();
        QTest::mouseMove(&area, legend->geometry().center());
        QVERIFY(legend->faded());
        auto* fading = legend->findChild<QVariantAnimation*>();
        fading->setCurrentTime(fading->duration());
        QVERIFY(legend->grab().toImage() != whole);
        QTest::mouseMove(&area, QPoint(450, 450));
        QVERIFY(!legend->faded());
    }

    void theLegendIsFoldedInASmallArea()
    {
        test::Editor editor(test::makeProject(test::makeBallHead()));
        view::PaintView area(editor.state, view::Theme::of(view::ThemeKind::Dark));
        area.resize(300, 380);
        area.show();
        editor.state.target().setMap(model::MapKind::Direction);
        const auto* legend = area.findChild<view::MapLegend*>();
        QVERIFY(legend->folded());
        QVERIFY(legend->height() < 60 && legend->geometry().bottom() < 380);
        area.resize(800, 800);
        QVERIFY(!legend->folded());
        QVERIFY(legend->geometry().bottom() > 700 && legend->geometry().bottom() < 800);
    }
};

HAIRPAINT_TEST(TestMapSigns, Widgets)
#include "test_map_signs.moc"
