// What would take more time, memory or disk than anyone has is refused before it is begun.
#include "model/files/project_file.h"
#include "tests/app/program.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace hairpaint;
using namespace hairpaint::test;

class TestBounds : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    static void fill(model::Project& project, model::MapKind kind, std::uint16_t value)
    {
        sim::TiledRaster& raster = project.groups.front().map(kind).layers.front().raster;
        for (int tile = 0; tile < raster.tileCount(); ++tile)
            raster.setUniform(tile, {value, 65'535, 0, 0});
    }

private Q_SLOTS:
    void curvesThatWouldFillADiskAreNotBegun()
    {
        model::Project project = model::newProject();
        for (const model::MapKind kind : {model::MapKind::Density, model::MapKind::Length, model::MapKind::Curl})
            fill(project, kind, 65'535);
        fill(project, model::MapKind::Braid, 1);
        sim::GroupSettings& settings = project.groups.front().settings;
        settings.greatestDensityPerM2 = 1e6F;
        settings.greatestLengthM = 2.0F;
        settings.nodesPerHair = 32;
        settings.braidSpacingM = 0.005F;
        settings.braidRadiusM = 0.0005F;
        QVERIFY(model::saveProject(project, path("braids.hairpaint"), {}));
        QVERIFY(QFileInfo(path("braids.hairpaint")).size() < 600'000);
        const Outcome whole =
            runProgram({QStringLiteral("export"), path("braids.hairpaint"), QStringLiteral("-o"), path("b.hair")});
        QCOMPARE(whole.code, 1);
        QVERIFY2(whole.error.contains(QStringLiteral("b.hair")) && whole.error.contains(QStringLiteral("is the most")),
                 qPrintable(whole.error));
        QVERIFY(!QFile::exists(path("b.hair")) && whole.peakBytes < kMostBytes);
        const Outcome fewer = runProgram({QStringLiteral("export"), path("braids.hairpaint"), QStringLiteral("-o"),
                                          path("b.hair"), QStringLiteral("--hairs"), QStringLiteral("100")});
        QCOMPARE(fewer.code, 0);
        QCOMPARE(readHair(path("b.hair")).size(), std::size_t{100});
    }

    void aPictureInLinearLightIsNotLargerThanMemory()
    {
        QVERIFY(model::saveProject(model::newProject(), path("a.hairpaint"), {}));
        const Outcome large = runProgram({QStringLiteral("render"), path("a.hairpaint"), QStringLiteral("-o"),
                                          path("o.exr"), QStringLiteral("--size"), QStringLiteral("8192x8192")});
        QCOMPARE(large.code, 2);
        QVERIFY2(large.error.contains(QStringLiteral("million pixels")), qPrintable(large.error));
        QVERIFY(!QFile::exists(path("o.exr")));
    }
};

HAIRPAINT_TEST(TestBounds, Core)
#include "test_bounds.moc"
