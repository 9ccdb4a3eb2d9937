// The paint area's geometry: navigation, the ring's ellipse, the thinned wireframe, the baked shading.
#include "model/maps/map_colours.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"
#include "view/paint_area/head_backdrop.h"
#include "view/paint_area/map_pyramid.h"
#include "view/paint_area/skin_ring.h"
#include "view/paint_area/uv_shading.h"
#include "view/paint_area/uv_transform.h"
#include "view/paint_area/uv_wireframe.h"

#include <QTest>

#include <cmath>
#include <memory>
#include <random>

using namespace hairpaint;
using view::UvTransform;

namespace {

/// Skin whose uv is sheared and stretched: one m is 4 uv along x, 2 along y, leaning by 1.
sim::SurfacePoint leaningPoint()
{
    sim::SurfacePoint point;
    point.uv = {0.4F, 0.6F};
    point.dPduHd = {0.25F, 0.0F, 0.0F};
    point.dPdvHd = {0.1F, 0.5F, 0.0F};
    return point;
}

UvTransform someTransform(double rotationDeg, bool mirrored)
{
    UvTransform transform;
    transform.widget = {800.0, 600.0};
    transform.reset();
    transform.rotateBy(rotationDeg);
    if (mirrored)
        transform.mirror();
    return transform;
}

} // namespace

class UvGeometry : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void everyPointOfTheRingLiesAtTheRadiusOnTheSkin()
    {
        const sim::SurfacePoint point = leaningPoint();
        const QPolygonF ring = view::ringOnUv(point, 0.03F);
        QCOMPARE(ring.size(), 64);
        for (const QPointF& corner : ring) {
            const auto u = static_cast<float>(corner.x()) - point.uv.x;
            const auto v = static_cast<float>(corner.y()) - point.uv.y;
            QVERIFY(std::abs(glm::length(point.dPduHd * u + point.dPdvHd * v) - 0.03F) < 1e-5F);
        }
    }

    void aDegenerateMapHasNoRing()
    {
        sim::SurfacePoint point = leaningPoint();
        point.dPdvHd = point.dPduHd * 2.0F;
        QVERIFY(view::ringOnUv(point, 0.03F).isEmpty());
        point.dPduHd = glm::vec3(0.0F);
        QVERIFY(view::ringOnUv(point, 0.03F).isEmpty());
    }

    void zoomingKeepsWhatLiesUnderThePointer_data()
    {
        QTest::addColumn<double>("rotation");
        QTest::addColumn<bool>("mirrored");
        QTest::addColumn<double>("factor");
        QTest::newRow("in") << 0.0 << false << 1.7;
        QTest::newRow("out") << 0.0 << false << 0.6;
        QTest::newRow("turned") << 33.0 << false << 2.5;
        QTest::newRow("mirrored") << 0.0 << true << 2.5;
        QTest::newRow("turned and mirrored") << -70.0 << true << 0.8;
    }
    void zoomingKeepsWhatLiesUnderThePointer()
    {
        QFETCH(double, rotation);
        QFETCH(bool, mirrored);
        QFETCH(double, factor);
        UvTransform transform = someTransform(rotation, mirrored);
        const QPointF pointer(521.0, 243.0);
        const glm::vec2 before = transform.toUv(pointer);
        const double size = transform.pxPerPaper;
        transform.zoomAt(pointer, factor, 1024);
        QVERIFY(std::abs(transform.pxPerPaper / size - factor) < 1e-9);
        QVERIFY(glm::length(transform.toUv(pointer) - before) < 1e-5F);
        QVERIFY(QLineF(transform.toWidget(before), pointer).length() < 1e-2);
    }

    void panningMovesTheMapWithThePointer()
    {
        UvTransform transform = someTransform(20.0, true);
        const glm::vec2 held = transform.toUv({300.0, 300.0});
        transform.panBy({40.0, -25.0});
        QVERIFY(QLineF(transform.toWidget(held), QPointF(340.0, 275.0)).length() < 1e-2);
    }

    void mirroringSwapsTheSidesAboutTheMiddle()
    {
        UvTransform transform = someTransform(0.0, false);
        const glm::vec2 uv = transform.toUv({300.0, 200.0});
        transform.mirror();
        QVERIFY(QLineF(transform.toWidget(uv), QPointF(500.0, 200.0)).length() < 1e-2);
    }

    void theWireframeIsThinnedFromAfarAndWholeUpClose()
    {
        const sim::HeadMesh mesh = test::makePatchHead(128);
        view::UvWireframe wireframe(mesh);
        const std::size_t all = 128U * 129U * 2U + 128U * 128U;
        QCOMPARE(wireframe.edgeCount(4000.0), all);
        const std::size_t far = wireframe.edgeCount(400.0);
        QVERIFY2(far > 200U && far < all / 8U, qPrintable(QString::number(far)));
        QVERIFY(wireframe.edgeCount(150.0) < far);
    }

    void theShadingKnowsTheIslands()
    {
        sim::HeadMesh mesh = test::makePatchHead(8);
        for (glm::vec2& uv : mesh.uvs)
            uv = uv * 0.5F;
        const QImage shading = view::bakeUvShading(mesh, 64);
        // v runs up: the lower left quarter is covered.
        QCOMPARE(shading.pixelColor(16, 48).alpha(), 255);
        QCOMPARE(shading.pixelColor(16, 16).alpha(), 0);
        QCOMPARE(shading.pixelColor(48, 48).alpha(), 0);
        QVERIFY(shading.pixelColor(16, 48).red() > 60);
    }

    void theVeilLeavesNothingOfADarkIslandAndHidesTheOutside()
    {
        QImage shading(2, 1, QImage::Format_RGBA8888);
        shading.setPixelColor(0, 0, QColor(255, 255, 255, 255));
        shading.setPixelColor(1, 0, QColor(0, 0, 0, 0));
        const QImage night = view::shadingVeil(shading, true, QColor(30, 40, 50));
        QVERIFY(night.pixelColor(0, 0).alpha() > 20 && night.pixelColor(0, 0).alpha() < 90);
        QVERIFY(night.pixelColor(1, 0).alpha() > 120);
        const QImage white = view::shadingVeil(shading, false, QColor(30, 40, 50));
        QCOMPARE(white.pixelColor(0, 0).alpha(), 0);
    }

    void aMendedPyramidLooksLikeANewOne_data()
    {
        QTest::addColumn<int>("size");
        QTest::addColumn<double>("pxPerPaper");
        QTest::addColumn<int>("seed");
        for (const int size : {256, 1024}) {
            for (const double zoom : {200.0, 700.0, 3000.0})
                QTest::addRow("%d texels at %.0f px", size, zoom) << size << zoom << 7;
        }
    }
    void aMendedPyramidLooksLikeANewOne()
    {
        QFETCH(int, size);
        QFETCH(double, pxPerPaper);
        QFETCH(int, seed);
        const model::MapSpec& spec = model::mapSpec(model::MapKind::Length);
        std::mt19937 random(static_cast<unsigned>(seed));
        sim::TiledRaster raster(size, 1);
        UvTransform transform;
        transform.widget = {300.0, 300.0};
        transform.centrePaper = {0.45, 0.55};
        transform.pxPerPaper = pxPerPaper;
        const auto drawn = [&](view::MapPyramid& pyramid) {
            QImage image(300, 300, QImage::Format_RGB32);
            image.fill(Qt::black);
            QPainter painter(&image);
            const QRectF visible = transform.paperToWidget().inverted().mapRect(QRectF(QPointF(), transform.widget));
            pyramid.draw(painter, transform.paperToWidget(), visible, 1.0);
            return image;
        };
        view::MapPyramid mended;
        mended.setSource(std::make_shared<sim::TiledRaster>(raster), spec, true);
        static_cast<void>(drawn(mended));
        for (int step = 0; step < 12; ++step) {
            std::uniform_int_distribution<int> start(0, size - 40);
            const int x0 = start(random);
            const int y0 = start(random);
            const auto value = static_cast<std::uint16_t>(random());
            for (int y = y0; y < y0 + 40; ++y) {
                for (int x = x0; x < x0 + 40; ++x)
                    raster.setTexel(x, y, {value});
            }
            const auto snapshot = std::make_shared<sim::TiledRaster>(raster);
            QVERIFY(!mended.setSource(snapshot, spec, true).isEmpty());
            view::MapPyramid fresh;
            fresh.setSource(snapshot, spec, true);
            QCOMPARE(drawn(mended), drawn(fresh));
        }
        QVERIFY(mended.setSource(std::make_shared<sim::TiledRaster>(raster), spec, true).isEmpty());
    }

    void aLargeMapIsDrawnOfSamplesAndThenOfMeans()
    {
        constexpr int kSize = 2048;
        const model::MapSpec& spec = model::mapSpec(model::MapKind::Length);
        std::mt19937 random(7);
        // Columns of 1 texel, so that samples and means differ; patches of a tile that differ from each other.
        sim::TiledRaster raster(kSize, 1);
        for (int index = 0; index < raster.tileCount(); ++index) {
            const auto value = static_cast<std::uint16_t>(random());
            std::size_t at = 0;
            for (std::uint16_t& texel : raster.writableTile(index))
                texel = at++ % 2 == 0 ? value : 0;
        }
        UvTransform transform;
        transform.widget = {500.0, 500.0};
        transform.centrePaper = {0.5, 0.5};
        transform.pxPerPaper = 512.0;
        const auto drawn = [&](view::MapPyramid& pyramid) {
            QImage image(500, 500, QImage::Format_RGB32);
            QPainter painter(&image);
            const QRectF visible = transform.paperToWidget().inverted().mapRect(QRectF(QPointF(), transform.widget));
            pyramid.draw(painter, transform.paperToWidget(), visible, 1.0);
            return image;
        };
        const auto refined = [](view::MapPyramid& pyramid) {
            QList<QRectF> parts;
            while (pyramid.isCoarse())
                parts += pyramid.refine(0.0);
            return parts;
        };
        view::MapPyramid pyramid;
        pyramid.setSource(std::make_shared<sim::TiledRaster>(raster), spec, true);
        const QImage coarse = drawn(pyramid);
        QVERIFY(pyramid.isCoarse());
        QCOMPARE(drawn(pyramid), coarse);
        QCOMPARE(refined(pyramid).size(), 4);
        const QImage fine = drawn(pyramid);
        QVERIFY(!pyramid.isCoarse() && fine != coarse);
        // The mean of the stripes.
        const int sum = qBlue(model::shownTexel(spec, raster.texel(736, 928), true)) +
                        qBlue(model::shownTexel(spec, raster.texel(737, 928), true));
        const QPoint at = transform.paperToWidget().map(QPointF(736.5 / kSize, 928.5 / kSize)).toPoint();
        QVERIFY(std::abs(qBlue(fine.pixel(at)) - sum / 2) < 4);

        // Mended where nothing finer is there, and where it is, it looks like a new one.
        raster.setTexel(700, 900, {65535});
        pyramid.setSource(std::make_shared<sim::TiledRaster>(raster), spec, true);
        static_cast<void>(drawn(pyramid));
        refined(pyramid);
        view::MapPyramid fresh;
        fresh.setSource(std::make_shared<sim::TiledRaster>(raster), spec, true);
        static_cast<void>(drawn(fresh));
        raster.setTexel(701, 900, {65535});
        for (view::MapPyramid* one : {&pyramid, &fresh}) {
            one->setSource(std::make_shared<sim::TiledRaster>(raster), spec, true);
            static_cast<void>(drawn(*one));
            refined(*one);
        }
        QCOMPARE(drawn(pyramid), drawn(fresh));
    }

    void aHeadHasOneBackdrop()
    {
        const auto withPatch = [](int side) {
            const auto head = std::make_shared<model::Head>();
            head->skin = std::make_shared<const sim::Skin>(test::makePatchHead(side));
            return std::shared_ptr<const model::Head>(head);
        };
        const std::shared_ptr<const model::Head> head = withPatch(8);
        const view::BackdropPtr backdrop = view::headBackdrop(head);
        QCOMPARE(backdrop->wireframe.edgeCount(1e6), view::UvWireframe(head->skin->mesh()).edgeCount(1e6));
        QCOMPARE(backdrop->shading, view::bakeUvShading(head->skin->mesh(), backdrop->shading.width()));
        QCOMPARE(view::headBackdrop(head), backdrop);
        QVERIFY(view::headBackdrop(withPatch(16))->wireframe.edgeCount(1e6) > backdrop->wireframe.edgeCount(1e6));
    }
};

HAIRPAINT_TEST(UvGeometry, Widgets)
#include "test_uv_geometry.moc"
