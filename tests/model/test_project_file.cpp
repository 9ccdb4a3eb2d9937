// Projects survive being saved and opened; saving again writes the same bytes and costs what changed.
#include "model/files/archive.h"
#include "model/files/encoded_layers.h"
#include "model/files/group_json.h"
#include "model/files/layer_files.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/files/project_json.h"
#include "sim/base/parallel.h"
#include "sim/groom/direction_texel.h"
#include "sim/groom/groom.h"
#include "sim/skin/skin_frame.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <array>

using namespace hairpaint;
using namespace hairpaint::model;

class TestProjectFile : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    /// The project as it comes back; fails the test where it does not.
    static Project opened(const QString& path, EncodedLayers* cache = nullptr)
    {
        Result<Project> project = loadProject(path, cache);
        if (project)
            return std::move(*project);
        qWarning("%s", qPrintable(project.error().message));
        return newProject();
    }

private Q_SLOTS:
    void aNewProjectStandsOnTheBuiltInHeadWithOneEmptyGroup()
    {
        const Project project = newProject();
        QVERIFY(project.head->builtIn);
        QCOMPARE(project.head->name, QStringLiteral("bust-2"));
        QCOMPARE(project.groups.size(), std::size_t{1});
        QCOMPARE(project.groups.front().maps.size(), std::size_t{kMapKindCount});
        QVERIFY(!project.worn.empty() && shapesOfHead(project.worn) == builtInEllipsoids());
        QCOMPARE(project.seed, std::uint64_t{1});
    }

    void everythingInAProjectComesBack_data()
    {
        QTest::addColumn<bool>("imported");
        QTest::newRow("the built-in head") << false;
        QTest::newRow("an imported head, nothing as by default") << true;
    }
    void everythingInAProjectComesBack()
    {
        QFETCH(bool, imported);
        const Project project = imported ? test::makeSampleProject() : newProject();
        const Result<void> saved = saveProject(project, path("a.hairpaint"), {});
        QVERIFY2(saved, saved ? "" : qPrintable(saved.error().message));
        QCOMPARE(test::difference(project, opened(path("a.hairpaint"))), QString());
    }

    void everyBraidComesBackAsItsNumberInTheFile()
    {
        // The numbers stand in files, so they stay what they are.
        const MapSpec& spec = mapSpec(MapKind::Braid);
        constexpr std::uint16_t kCount = 8;
        const std::array<const char*, kCount> ids = {"none",   "plait",  "twist",    "loc",
                                                     "plait4", "plait5", "fishtail", "cornrow"};
        QCOMPARE(spec.palette.size(), std::size_t{kCount});
        Project project = newProject();
        sim::TiledRaster& painted = project.groups.front().map(MapKind::Braid).layers.front().raster;
        for (std::uint16_t i = 0; i < kCount; ++i) {
            QCOMPARE(QByteArray(spec.palette[i].id), QByteArray(ids[i]));
            painted.setTexel(i, 7, {i, 65535, 0, 0});
            painted.setUniform(i + 1, {i, 40'000, 0, 0});
        }
        QVERIFY(saveProject(project, path("braids.hairpaint"), {}));
        const Project back = opened(path("braids.hairpaint"));
        QCOMPARE(test::difference(project, back), QString());
        const sim::TiledRaster& read = back.groups.front().map(MapKind::Braid).layers.front().raster;
        for (std::uint16_t i = 0; i < kCount; ++i)
            QCOMPARE(read.texel(i, 7), (sim::Texel{i, 65535, 0, 0}));

        // Further numbers are rows of cornrow; beyond the last, a number of a later program is no braid.
        painted.setTexel(1, 9, {kCount, 65535, 0, 0});
        painted.setTexel(2, 9, {sim::kLastRowNumber, 65535, 0, 0});
        painted.setTexel(0, 9, {sim::kLastRowNumber + 1, 65535, 0, 0});
        QVERIFY(saveProject(project, path("later.hairpaint"), {}));
        const Project later = opened(path("later.hairpaint"));
        const sim::TiledRaster& rows = later.groups.front().map(MapKind::Braid).layers.front().raster;
        QCOMPARE(rows.texel(0, 9), (sim::Texel{0, 65535, 0, 0}));
        QCOMPARE(rows.texel(1, 9), (sim::Texel{kCount, 65535, 0, 0}));
        QCOMPARE(rows.texel(2, 9), (sim::Texel{sim::kLastRowNumber, 65535, 0, 0}));
    }

    void savingWhatWasOpenedWritesTheSameBytes()
    {
        EncodedLayers cache;
        QVERIFY(saveProject(test::makeSampleProject(), path("a.hairpaint"), {}));
        const Project project = opened(path("a.hairpaint"), &cache);
        QVERIFY(saveProject(project, path("b.hairpaint"), {}, &cache));
        QVERIFY(saveProject(project, path("c.hairpaint"), {}));
        QVERIFY(test::readBytes(path("a.hairpaint")) == test::readBytes(path("b.hairpaint")));
        QVERIFY(test::readBytes(path("a.hairpaint")) == test::readBytes(path("c.hairpaint")));
    }

    void unchangedLayersAreNotEncodedAgain()
    {
        EncodedLayers cache;
        QVERIFY(saveProject(test::makeSampleProject(), path("a.hairpaint"), {}));
        Project project = opened(path("a.hairpaint"), &cache);
        QCOMPARE(cache.misses(), 0);
        QVERIFY(saveProject(project, path("b.hairpaint"), {}, &cache));
        QCOMPARE(cache.misses(), 0);
        project.groups.front().map(MapKind::Curl).layers.front().raster.setTexel(7, 9, {1, 2, 0, 0});
        QVERIFY(saveProject(project, path("b.hairpaint"), {}, &cache));
        QCOMPARE(cache.misses(), 1);
        QVERIFY(saveProject(project, path("b.hairpaint"), {}, &cache));
        QCOMPARE(cache.misses(), 1);
        QVERIFY(saveProject(project, path("c.hairpaint"), {}));
        QVERIFY(test::readBytes(path("b.hairpaint")) == test::readBytes(path("c.hairpaint")));
        QCOMPARE(test::difference(project, opened(path("b.hairpaint"))), QString());
    }

    void aLargeImageIsWorkedOnAlone()
    {
        const auto threads = static_cast<std::size_t>(sim::threadCount());
        const std::vector<int> small(100, 2048);
        QCOMPARE(batchLength(small), std::min(threads, small.size()));
        QCOMPARE(batchLength(std::vector<int>{8192, 256, 256}), std::size_t{1});
        QCOMPARE(batchLength(std::vector<int>{256, 8192, 256}), std::size_t{1});
        QCOMPARE(batchLength(std::vector<int>{256, 256, 4096}), std::min(threads, std::size_t{2}));
    }

    void onlyTheThumbnailDistinguishesTwoFilesOfOneProject()
    {
        const Project project = newProject();
        QImage picture(320, 200, QImage::Format_ARGB32);
        picture.fill(Qt::red);
        QVERIFY(saveProject(project, path("a.hairpaint"), {}));
        QVERIFY(saveProject(project, path("b.hairpaint"), picture));
        QVERIFY(readThumbnail(*ArchiveReader::open(path("a.hairpaint"))).isNull());
        const QImage thumbnail = readThumbnail(*ArchiveReader::open(path("b.hairpaint")));
        QCOMPARE(thumbnail.size(), picture.size());
        QCOMPARE(thumbnail.pixelColor(5, 5), QColor(Qt::red));
        QVERIFY(test::readBytes(path("b.hairpaint")).size() > test::readBytes(path("a.hairpaint")).size());
        QCOMPARE(test::difference(opened(path("a.hairpaint")), opened(path("b.hairpaint"))), QString());
    }

    void theFileSaysWhatItIsAtByte38()
    {
        QVERIFY(saveProject(newProject(), path("a.hairpaint"), {}));
        const QByteArray bytes = test::readBytes(path("a.hairpaint"));
        QCOMPARE(bytes.sliced(30, 8), QByteArray("mimetype"));
        QCOMPARE(bytes.sliced(38, 25), QByteArray("application/x-hairpaintPK"));
    }

    void layersLieInTheArchiveAsOrdinaryImages()
    {
        const Project project = test::makeSampleProject();
        QVERIFY(saveProject(project, path("a.hairpaint"), {}));
        const Checked<ArchiveReader> archive = ArchiveReader::open(path("a.hairpaint"));
        QVERIFY(archive);
        const Layer& layer = project.groups.front().map(MapKind::Length).layers.front();
        const Checked<QByteArray> png = archive->read(
            QStringLiteral("groups/%1/length/%2.png").arg(project.groups.front().id).arg(layer.id), 1 << 24);
        QVERIFY(png);
        const QImage image = QImage::fromData(*png, "png");
        QCOMPARE(image.format(), QImage::Format_RGBA64);
        for (int at = 0; at < 256; at += 17) {
            const sim::Texel texel = layer.raster.texel(at, at / 2);
            const QRgba64 pixel = image.pixelColor(at, at / 2).rgba64();
            QCOMPARE(pixel.red(), texel[0]);
            QCOMPARE(pixel.green(), texel[0]);
            QCOMPARE(pixel.blue(), texel[0]);
            QCOMPARE(pixel.alpha(), texel[1]);
        }
    }

    void aMapThatTheFileLacksIsEmpty()
    {
        Project project = test::makeSampleProject();
        std::vector<SharedStack>& maps = project.groups.front().maps; // Nor any behind gel.
        maps.erase(maps.begin() + static_cast<std::ptrdiff_t>(sim::indexOf(MapKind::Gel)), maps.end());
        QVERIFY(saveProject(project, path("a.hairpaint"), {}));
        const Project back = opened(path("a.hairpaint"));
        const MapStack& gel = back.groups.front().map(MapKind::Gel);
        QCOMPARE(gel.layers.size(), std::size_t{1});
        QVERIFY(gel.layers.front().id >= project.nextId && gel.layers.front().id < back.nextId);
        QCOMPARE(gel.layers.front().raster.size(), gel.size);
        QCOMPARE(gel.layers.front().raster.texel(3, 3), (sim::Texel{0, 0, 0, 0}));
    }

    void valuesThatNoFileMayHoldAreMovedIntoTheirRange()
    {
        Project project = newProject();
        project.wind.velocity = {std::numeric_limits<float>::quiet_NaN(), 1e30F, -1e30F};
        project.light.intensity = std::numeric_limits<float>::infinity();
        project.groups.front().settings.nodesPerHair = 1000;
        QVERIFY(saveProject(project, path("a.hairpaint"), {}));
        const Project back = opened(path("a.hairpaint"));
        QCOMPARE(back.wind.velocity, glm::vec3(0.0F, 100.0F, -100.0F));
        QCOMPARE(back.light.intensity, 4.0F);
        QCOMPARE(back.groups.front().settings.nodesPerHair, 32);
    }

    void whatCannotBeWrittenLeavesTheOldFile_data()
    {
        QTest::addColumn<QString>("path");
        QTest::newRow("a folder that is not there") << m_folder.filePath(QStringLiteral("none/a.hairpaint"));
        QTest::newRow("a folder at its path") << m_folder.path();
    }
    void whatCannotBeWrittenLeavesTheOldFile()
    {
        QFETCH(QString, path);
        const Result<void> saved = saveProject(newProject(), path, {});
        QVERIFY(!saved);
        QVERIFY2(test::isOneSentenceNaming(saved.error().message, path), qPrintable(saved.error().message));
        QVERIFY(!QFileInfo(path).isFile());
    }

    void cancellingChangesNothing()
    {
        const Progress never = [](double) { return false; };
        QVERIFY(saveProject(newProject(), path("a.hairpaint"), {}));
        const QByteArray before = test::readBytes(path("a.hairpaint"));
        const Result<void> saved = saveProject(test::makeSampleProject(), path("a.hairpaint"), {}, nullptr, never);
        QVERIFY(!saved && test::isOneSentenceNaming(saved.error().message, path("a.hairpaint")));
        QVERIFY(before == test::readBytes(path("a.hairpaint")));
        const Result<Project> loaded = loadProject(path("a.hairpaint"), nullptr, never);
        QVERIFY(!loaded && test::isOneSentenceNaming(loaded.error().message, path("a.hairpaint")));
    }

    void progressRunsFromZeroTowardOne()
    {
        std::vector<double> fractions;
        const Progress collect = [&fractions](double fraction) {
            fractions.push_back(fraction);
            return true;
        };
        QVERIFY(saveProject(test::makeSampleProject(), path("a.hairpaint"), {}, nullptr, collect));
        QVERIFY(fractions.size() > 1);
        QVERIFY(std::ranges::is_sorted(fractions) && fractions.front() == 0.0 && fractions.back() < 1.0);
    }

    void theSampleOfEveryReleasedVersionOpens_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<std::vector<MapKind>>("maps");
        using enum sim::MapSlot;
        QTest::newRow("version 1") << test::dataPath(u"format/v1.hairpaint")
                                   << std::vector{Density, Length, Curl, Braid, Colour, Clump, Gel};
    }
    void theSampleOfEveryReleasedVersionOpens()
    {
        QFETCH(QString, file);
        QFETCH(std::vector<MapKind>, maps);
        std::vector<MapKind> lacking;
        for (const MapSpec& spec : mapSpecs())
            if (std::ranges::find(maps, spec.kind) == maps.end())
                lacking.push_back(spec.kind);
        const Result<Project> project = loadProject(file);
        QVERIFY2(project, project ? "" : qPrintable(project.error().message));
        constexpr float kReleasedHeadCm = 10.0F;
        Project expected = test::makeSampleProject(256, lacking, kReleasedHeadCm);
        expected.skin = SkinTone::Clay; // Version 0.1 knew no other.
        const LightSettings standard;   // It knew the key light and the ambient light alone.
        expected.light.temperatureK = standard.temperatureK;
        expected.light.fill = standard.fill;
        expected.light.rim = standard.rim;
        expected.light.surroundings = standard.surroundings;
        expected.light.scattering = standard.scattering;
        for (std::size_t g = 0; g < expected.groups.size(); ++g) {
            // What its parting and sweep back did has been painted.
            const MapStack& direction = project->groups[g].map(MapKind::Direction);
            QCOMPARE(direction.size, 512);
            QCOMPARE(direction.layers.size(), std::size_t{1});
            QCOMPARE(direction.layers.front().name, QStringLiteral("Parting and sweep back"));
            QCOMPARE(direction.layers.front().id, expected.groups[g].map(MapKind::Direction).layers.front().id);
            expected.groups[g].map(MapKind::Direction) = direction;
            // 33 % of body stands as a fibre does that carries itself over 9 cm; as all numbers, to seven digits.
            const float stiffnessM = project->groups[g].settings.physics.stiffnessM;
            QVERIFY(std::abs(stiffnessM - 0.05F * std::pow(2.2F, 0.73F)) < 1e-6F);
            expected.groups[g].settings.physics.stiffnessM = stiffnessM;
            // It knew neither coils in real units nor locks.
            expected.groups[g].settings.lengthAsCut = false;
            expected.groups[g].settings.curl = {};
            expected.groups[g].settings.locks = {};
        }
        QCOMPARE(test::difference(expected, *project), QString());
    }

    /// Both were given a ramp as every map, v3 also a ball; as programs that knew no later keys wrote them.
    void theSamplesOfLaterVersionsOpen_data()
    {
        QTest::addColumn<int>("version");
        QTest::addColumn<std::size_t>("balls");
        QTest::newRow("version 2") << 2 << std::size_t{0};
        QTest::newRow("version 3") << 3 << std::size_t{1};
    }
    void theSamplesOfLaterVersionsOpen()
    {
        QFETCH(int, version);
        QFETCH(std::size_t, balls);
        const QString file = test::dataPath(u"format/v%1.hairpaint").arg(version);
        const Result<Project> project = loadProject(file);
        QVERIFY2(project, project ? "" : qPrintable(project.error().message));
        QCOMPARE(project->seed, std::uint64_t{77});
        QCOMPARE(formatVersionOf(*project), version);
        QCOMPARE(project->groups.size(), std::size_t{1});
        const HairGroup& group = project->groups.front();
        QVERIFY(group.settings.variation == sim::VariationSettings{}); // There was none.
        constexpr int kTexel = 100;
        for (const MapKind kind :
             {MapKind::Density, MapKind::Length, MapKind::Curl, MapKind::CurlSize, MapKind::Clump, MapKind::Gel}) {
            const MapStack& stack = group.map(kind);
            QCOMPARE(stack.size, 256);
            const sim::Texel texel = stack.layers.front().raster.texel(kTexel, 7);
            QCOMPARE(texel[0], static_cast<std::uint16_t>(kTexel * 257));
            QCOMPARE(texel[1], std::uint16_t{65535});
        }
        QCOMPARE(shapesOfHead(project->worn), builtInEllipsoids());
        QCOMPARE(countOf(project->worn, WornKind::Ball), balls);
        for (const Worn& worn : project->worn)
            QVERIFY(worn.id > 0 && worn.id < project->nextId && !worn.anchor && worn.group == 0);
        if (balls > 0) {
            const Worn& ball = project->worn.back();
            QVERIFY(ball.shape.centreHd == glm::vec3(0.0F, 0.12F, 0.03F));
            QCOMPARE(ball.colour, QRgb{0xFF1E90FF});
            QCOMPARE(ball.sheen, wornSpec(WornKind::Ball).sheen);
        }
    }

    void partingAndSweepBackOfOldFilesArePainted_data()
    {
        QTest::addColumn<double>("parting");
        QTest::addColumn<double>("sweepBack");
        QTest::addColumn<glm::vec3>("positionHd");
        QTest::addColumn<glm::vec3>("direction");
        QTest::newRow("parted, on top, left") << 1.0 << 0.0 << glm::vec3(0.2F, 1.0F, 0.0F) << glm::vec3(1, 0, 0);
        QTest::newRow("parted, on top, right") << 1.0 << 0.0 << glm::vec3(-0.2F, 1.0F, 0.0F) << glm::vec3(-1, 0, 0);
        QTest::newRow("swept back, on top") << 0.0 << 1.0 << glm::vec3(0.2F, 1.0F, 0.0F) << glm::vec3(0, 0, -1);
        QTest::newRow("at the side all falls") << 1.0 << 1.0 << glm::vec3(1.0F, 0.0F, 0.0F) << glm::vec3(0, -1, 0);
        QTest::newRow("at the back too") << 0.3 << 0.9 << glm::vec3(0.05F, 0.0F, -1.0F) << glm::vec3(0, -1, 0);
    }
    void partingAndSweepBackOfOldFilesArePainted()
    {
        QFETCH(double, parting);
        QFETCH(double, sweepBack);
        QFETCH(glm::vec3, positionHd);
        QFETCH(glm::vec3, direction);
        QByteArray json = R"({"format": "hairpaint project", "format_version": 1, "next_id": 5,
            "head": {"name": "bust-1"}, "groups": [{"id": 1, "settings": {"greatest_length_m": 0.5,
            "physics": {"body": 0.25, "parting": %1, "sweep_back": %2}}}]})";
        json.replace("%1", QByteArray::number(parting)).replace("%2", QByteArray::number(sweepBack));
        Checked<ProjectManifest> manifest = projectFromJson(json);
        QVERIFY(manifest);
        QCOMPARE(manifest->formerCombing.size(), std::size_t{1});
        Project& project = manifest->project;
        auto head = std::make_shared<Head>();
        head->skin = std::make_shared<const sim::Skin>(test::makeBallHead(96, 0.1F));
        project.head = head;
        QVERIFY(paintFormerCombing(project, manifest->formerCombing));
        const sim::SurfacePoint root = head->skin->nearest(0.1F * glm::normalize(positionHd));
        const sim::TiledRaster& raster = project.groups.front().map(MapKind::Direction).layers.front().raster;
        const glm::vec3 laid = sim::SkinFrame::at(root).toHd(sim::directionOf(raster.sampleNearest(root.uv)));
        QVERIFY(std::abs(glm::length(laid) - 0.976F * 0.75F) < 0.002F);
        QVERIFY2(glm::dot(glm::normalize(laid), direction) > 0.95F,
                 qPrintable(QStringLiteral("%1 %2 %3").arg(laid.x).arg(laid.y).arg(laid.z)));
        QCOMPARE(raster.sampleNearest(root.uv)[2], std::uint16_t{65535});
    }

    void aFileOfThisVersionIsNotCombed()
    {
        QVERIFY(saveProject(newProject(), path("a.hairpaint"), {}));
        const Project back = opened(path("a.hairpaint"));
        QVERIFY(back.groups.front().map(MapKind::Direction).layers.front().raster.uniformValue() ==
                (sim::Texel{32768, 32768, 0, 0}));
    }

    /// The counter has come to its end: the next layer still can be saved, and the file opens.
    void aDocumentThatHasUsedUpItsIdsIsSavedWithNewOnes()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("many.hairpaint"));
        Project project = newProject();
        project.nextId = kGreatestNextId;
        QVERIFY(saveProject(project, path, {}));
        Result<Project> opened = loadProject(path);
        QVERIFY(opened);
        QCOMPARE(opened->nextId, kGreatestNextId);

        const HairGroup& group = opened->groups.front();
        opened->groups.front()
            .map(MapKind::Length)
            .layers.push_back(
                makeLayer(*opened, mapSpec(MapKind::Length), group.map(MapKind::Length).size, QStringLiteral("Last")));
        QVERIFY(saveProject(*opened, path, {}));
        const Result<Project> again = loadProject(path);
        QVERIFY2(again, again ? "" : qPrintable(again.error().message));
        QVERIFY(again->nextId < 100);
        QCOMPARE(again->groups.front().map(MapKind::Length).layers.back().name, QStringLiteral("Last"));

        const QString presetPath = folder.filePath(QStringLiteral("many.hairpreset"));
        Preset preset = presetFrom(*again, QStringLiteral("Many"));
        preset.groups.front().id = kGreatestNextId;
        QVERIFY(savePreset(preset, presetPath));
        const Result<Preset> style = loadPreset(presetPath);
        QVERIFY2(style, style ? "" : qPrintable(style.error().message));
    }
};

HAIRPAINT_TEST(TestProjectFile, Core)
#include "test_project_file.moc"
