// Styles carried from head to head: what lies where, and what becomes of maps, settings and files.
#include "model/document/scene_commands.h"
#include "model/files/glb_writing.h"
#include "model/files/head_file.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/heads/built_in_heads.h"
#include "model/project/group_schema.h"
#include "model/styles/style_transfer.h"
#include "model/styles/style_use.h"
#include "model/styles/uv_correspondence.h"
#include "sim/groom/direction_texel.h"
#include "sim/skin/landmark_search.h"
#include "sim/skin/skin_frame.h"
#include "tests/model/fixtures.h"
#include "tests/support/foreign_heads.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace hairpaint;
using namespace hairpaint::model;
using sim::HeadLandmark;

namespace {

constexpr float kToleranceM = 0.010F;

/// As an import makes it, but for the file.
std::shared_ptr<const Head> importedHead(sim::HeadMesh mesh)
{
    auto head = std::make_shared<Head>();
    head->name = QStringLiteral("foreign");
    head->builtIn = false;
    head->skin = std::make_shared<const sim::Skin>(std::move(mesh));
    const Head& known = *defaultHead();
    head->landmarks = sim::findLandmarks(*head->skin, *known.skin, *known.landmarks);
    return head;
}

struct Foreign
{
    test::ForeignHead known;
    std::shared_ptr<const Head> head; ///< Imported.
};

/// A child's head or a scan, each imported once.
const Foreign& foreign(bool scan)
{
    const auto made = [](test::ForeignHead known) {
        std::shared_ptr<const Head> head = importedHead(known.mesh);
        return Foreign{.known = std::move(known), .head = std::move(head)};
    };
    const sim::HeadMesh& bust = defaultHead()->skin->mesh();
    static const Foreign child = made(test::childOf(bust));
    static const Foreign scanned = made(test::scanOf(bust));
    return scan ? scanned : child;
}

/// Points of a head that a hairdresser looks at: along the hairline, and along a parting in the middle.
std::vector<glm::vec3> hairlineAndParting()
{
    const std::shared_ptr<const Head> bust = defaultHead();
    const heads::HeadRegions& regions = heads::headRows().front()->regions;
    std::vector<glm::vec3> points;
    for (const glm::vec3& p : bust->skin->mesh().positionsHd) {
        const bool hairline = std::abs(regions.scalpDistance(p)) < 0.001F;
        const bool parting = p.x == 0.0F && regions.scalpDistance(p) > 0.0F;
        const bool behindEar = std::abs(p.x) > 0.055F && p.y < 0.03F; // Hidden, and folded.
        if ((hairline || parting) && !behindEar)
            points.push_back(p);
    }
    return points;
}

/// Hair on the built-in head: all over the scalp but for a parting a centimetre wide.
HairGroup partedHair(Project& project)
{
    HairGroup group = makeGroup(project, QStringLiteral("Scalp"), 512);
    const heads::HeadRegions& regions = heads::headRows().front()->regions;
    sim::TiledRaster& density = group.map(MapKind::Density).layers.front().raster;
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) {
            const glm::vec2 uv((static_cast<float>(x) + 0.5F) / 512.0F, 1.0F - (static_cast<float>(y) + 0.5F) / 512.0F);
            const std::optional<sim::SurfacePoint> point = defaultHead()->skin->atUv(uv);
            if (!point || regions.scalpDistance(point->positionHd) <= 0.0F)
                continue;
            const bool parting = std::abs(point->positionHd.x) < 0.005F && point->positionHd.z > 0.0F;
            density.setTexel(x, y, {static_cast<std::uint16_t>(parting ? 0 : 65535), 65535});
        }
    return group;
}

} // namespace

class TestStyleTransfer : public QObject
{
    Q_OBJECT

private:
    Project m_project;

    void foreignHeads()
    {
        QTest::addColumn<bool>("scan");
        QTest::newRow("a child's head") << false;
        QTest::newRow("a scan") << true;
    }
    static const Foreign& foreignHead()
    {
        QFETCH(bool, scan);
        return foreign(scan);
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_project = newProject();
        m_project.groups = {partedHair(m_project)};
    }

    void landmarksOfForeignHeadsAreFound_data() { foreignHeads(); }
    void landmarksOfForeignHeadsAreFound()
    {
        const auto& [foreign, head] = foreignHead();
        QVERIFY(head->landmarks.has_value());
        for (std::size_t i = 0; i < sim::kHeadLandmarkCount; ++i) {
            const glm::vec3 wanted = foreign.moved(defaultHead()->landmarks->positionsHd[i]);
            const float off = glm::distance(head->landmarks->positionsHd[i], wanted);
            qInfo("landmark %zu is %.1f mm off", i, 1000.0 * static_cast<double>(off));
            QVERIFY(off < kToleranceM);
        }
    }

    void hairlineAndPartingLieAtTheSameLandmarks_data() { foreignHeads(); }
    void hairlineAndPartingLieAtTheSameLandmarks()
    {
        const auto& [foreign, head] = foreignHead();
        const auto correspondence = UvCorrespondence::make(defaultHead(), head, 512);
        float worst = 0.0F;
        for (const glm::vec3& wanted : hairlineAndParting()) {
            const std::optional<glm::vec2> uv = correspondence->at(head->skin->nearest(foreign.moved(wanted)).uv);
            QVERIFY(uv.has_value());
            const std::optional<sim::SurfacePoint> found = defaultHead()->skin->atUv(*uv);
            QVERIFY(found.has_value());
            worst = std::max(worst, glm::distance(found->positionHd, wanted));
        }
        qInfo("worst point %.1f mm off", 1000.0 * static_cast<double>(worst));
        QVERIFY(worst < kToleranceM);
    }

    void aBallGrowsHairAboveItsForehead()
    {
        const std::shared_ptr<const Head> ball = importedHead(test::makeBallHead(96, 0.11F));
        QVERIFY(ball->landmarks.has_value());
        const sim::HeadLandmarks& marks = *ball->landmarks;
        QVERIFY(marks[HeadLandmark::Crown].y > 0.09F);
        QVERIFY(marks[HeadLandmark::NoseTip].z > 0.09F && marks[HeadLandmark::Nape].z < -0.05F);
        QVERIFY(marks[HeadLandmark::EarLeft].x > 0.09F && marks[HeadLandmark::EarRight].x < -0.09F);
        for (const HeadLandmark middle : {HeadLandmark::Hairline, HeadLandmark::NoseTip, HeadLandmark::Chin})
            QVERIFY(std::abs(marks[middle].x) < kToleranceM);
        const auto groups = carriedGroups(m_project.groups, m_project.head, ball);
        QVERIFY(groups.has_value());
        const sim::TiledRaster& density = groups->front().map(MapKind::Density).layers.front().raster;
        const auto grows = [&](const glm::vec3& positionHd) {
            return density.sampleBilinear(ball->skin->nearest(positionHd).uv).x > 0.5F;
        };
        // Down the forehead, beside the parting.
        const auto beside = [](float latitude) {
            return 0.11F * glm::vec3(0.15F, std::sin(latitude), std::cos(latitude));
        };
        float lowest = 1.5F;
        while (lowest > -1.5F && grows(beside(lowest)))
            lowest -= 0.01F;
        QVERIFY(glm::distance(beside(lowest), marks[HeadLandmark::Hairline]) < 0.015F + kToleranceM);
        QVERIFY(std::abs(beside(lowest).y - marks[HeadLandmark::Hairline].y) < kToleranceM);
        // Across the parting, in front of the crown.
        const glm::vec3 above = glm::normalize(marks[HeadLandmark::Crown] + marks[HeadLandmark::Hairline]) * 0.11F;
        QVERIFY(!grows(above));
        QVERIFY(grows(above + glm::vec3(0.012F, 0.0F, 0.0F)) && grows(above - glm::vec3(0.012F, 0.0F, 0.0F)));
    }

    void whatIsNoHeadGivesNoNonsense_data()
    {
        QTest::addColumn<int>("shape");
        QTest::newRow("a plane") << 0;
        QTest::newRow("one triangle") << 1;
        QTest::newRow("a needle") << 2;
        QTest::newRow("small and far away") << 3;
    }
    void whatIsNoHeadGivesNoNonsense()
    {
        QFETCH(int, shape);
        sim::HeadMesh mesh = shape == 0 ? test::makePatchHead(8) : test::makeBallHead(8, 0.1F);
        if (shape == 1)
            mesh.triangles.resize(1);
        for (glm::vec3& p : mesh.positionsHd)
            p = shape == 2   ? p * glm::vec3(1e-5F, 10.0F, 1e-5F)
                : shape == 3 ? 0.006F * p + glm::vec3(900.0F, -900.0F, 900.0F)
                             : p;
        const std::shared_ptr<const Head> head = importedHead(std::move(mesh));
        if (!head->landmarks)
            return;
        for (const glm::vec3& p : head->landmarks->positionsHd)
            QVERIFY(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        QVERIFY(carriedGroups(m_project.groups, m_project.head, head).has_value());
    }

    void thereAndBackIsTheSameHair()
    {
        const std::shared_ptr<const Head>& child = foreign(false).head;
        const auto there = carriedGroups(m_project.groups, m_project.head, child);
        const auto back = carriedGroups(*there, child, m_project.head);
        const sim::TiledRaster& before = m_project.groups.front().map(MapKind::Density).layers.front().raster;
        const sim::TiledRaster& after = back->front().map(MapKind::Density).layers.front().raster;
        int other = 0;
        int all = 0;
        for (int y = 0; y < before.size(); ++y)
            for (int x = 0; x < before.size(); ++x) {
                all += before.texel(x, y)[1] > 32767 ? 1 : 0;
                other += (before.texel(x, y)[0] > 32767) != (after.texel(x, y)[0] > 32767) ? 1 : 0;
            }
        qInfo("%d of %d texels differ", other, all);
        QVERIFY(all > 20'000);
        QVERIFY(other * 20 < all); // A texel along the border.
    }

    void hairIsAsLongAgainstTheOtherHead_data()
    {
        QTest::addColumn<bool>("scan");
        QTest::addColumn<float>("least");
        QTest::addColumn<float>("most");
        QTest::newRow("a child's head") << false << 0.82F << 0.92F;
        QTest::newRow("a scan") << true << 0.999F << 1.1F;
    }
    void hairIsAsLongAgainstTheOtherHead()
    {
        QFETCH(float, least);
        QFETCH(float, most);
        std::vector<HairGroup> groups = m_project.groups;
        groups.front().settings.shortestLengthM = 0.1F * groups.front().settings.greatestLengthM;
        groups.front().settings.braidSpacingM = 0.1F;
        const std::shared_ptr<const Head>& head = foreignHead().head;
        const auto there = carriedGroups(groups, m_project.head, head);
        const float lengthM = groups.front().settings.greatestLengthM;
        const float thereM = there->front().settings.greatestLengthM;
        QVERIFY2(thereM > least * lengthM && thereM < most * lengthM, qPrintable(QString::number(thereM / lengthM)));
        QCOMPARE(there->front().settings.shortestLengthM, 0.1F * thereM);
        // As many braids, as thick against the head.
        for (const char* key : {"braid_spacing_m", "braid_radius_m"}) {
            const GroupSetting& row = groupSetting(QLatin1StringView(key));
            const double ratio = row.read(there->front().settings) / row.read(groups.front().settings);
            QVERIFY2(std::abs(ratio * static_cast<double>(lengthM / thereM) - 1.0) < 1e-5, key);
        }
        QCOMPARE(carriedGroups(*there, head, m_project.head)->front().settings.greatestLengthM, lengthM);
    }

    void whatIsEvenStaysEvenAndEveryLayerIsCarried()
    {
        Project project = newProject();
        HairGroup& group = project.groups.front();
        const MapSpec& length = mapSpec(MapKind::Length);
        MapStack& stack = group.map(MapKind::Length);
        stack.layers.push_back(makeLayer(project, length, stack.size, QStringLiteral("Half")));
        stack.layers.back().opacity = 0.5F;
        for (int tile = 0; tile < stack.layers.front().raster.tileCount(); ++tile)
            stack.layers.front().raster.setUniform(tile, {12345, 65535});
        const std::shared_ptr<const Head>& child = foreign(false).head;
        const auto groups = carriedGroups(project.groups, project.head, child);
        const MapStack& carried = groups->front().map(MapKind::Length);
        QCOMPARE(carried.layers.size(), stack.layers.size());
        QCOMPARE(carried.layers.back().opacity, 0.5F);
        QCOMPARE(carried.layers.back().id, stack.layers.back().id);
        QVERIFY(carried.layers.front().raster.uniformValue() == (sim::Texel{12345, 65535}));
    }

    void hairLiesInTheSameDirectionOnTheOtherHead_data() { foreignHeads(); }
    void hairLiesInTheSameDirectionOnTheOtherHead()
    {
        const auto& [foreign, head] = foreignHead();
        Project project = newProject();
        project.groups = {makeGroup(project, QStringLiteral("Scalp"), 512)};
        sim::TiledRaster& painted = project.groups.front().map(MapKind::Direction).layers.front().raster;
        const heads::HeadRegions& regions = heads::headRows().front()->regions;
        const glm::vec3 directionHd = glm::normalize(glm::vec3(0.3F, -1.0F, -0.4F));
        std::vector<std::pair<glm::vec3, glm::vec3>> points; // And where hair there goes to.
        for (int y = 0; y < 512; ++y)
            for (int x = 0; x < 512; ++x) {
                const glm::vec2 uv((static_cast<float>(x) + 0.5F) / 512.0F,
                                   1.0F - (static_cast<float>(y) + 0.5F) / 512.0F);
                const std::optional<sim::SurfacePoint> point = defaultHead()->skin->atUv(uv);
                if (!point)
                    continue;
                const sim::SkinFrame frame = sim::SkinFrame::at(*point);
                const glm::vec2 along = frame.fromHd(directionHd);
                sim::Texel texel = sim::texelOfDirection(along * (0.8F / glm::length(along)));
                texel[2] = 65535;
                painted.setTexel(x, y, texel);
                if (x % 8 == 0 && y % 8 == 0 && glm::length(along) > 0.4F &&
                    regions.scalpDistance(point->positionHd) > 0.01F)
                    points.emplace_back(point->positionHd,
                                        point->positionHd + 0.002F * glm::normalize(frame.toHd(along)));
            }
        const auto groups = carriedGroups(project.groups, defaultHead(), head);
        const sim::TiledRaster& carried = groups->front().map(MapKind::Direction).layers.front().raster;
        std::vector<float> offDeg;
        for (const auto& [from, to] : points) {
            const sim::SurfacePoint root = head->skin->nearest(foreign.moved(from));
            const sim::SkinFrame frame = sim::SkinFrame::at(root);
            const glm::vec2 wanted = frame.fromHd(foreign.moved(to) - foreign.moved(from));
            const glm::vec2 found = sim::directionOf(carried.sampleNearest(root.uv));
            if (carried.sampleNearest(root.uv)[2] < 65535)
                continue;
            QVERIFY(std::abs(glm::length(found) - 0.8F) < 0.02F);
            offDeg.push_back(glm::degrees(
                std::acos(std::clamp(glm::dot(glm::normalize(found), glm::normalize(wanted)), -1.0F, 1.0F))));
        }
        std::ranges::sort(offDeg);
        QVERIFY(offDeg.size() > 500);
        const float most = offDeg[offDeg.size() * 95 / 100];
        qInfo("of %zu points 95 %% are under %.1f degrees off", offDeg.size(), static_cast<double>(most));
        // A scan is rough: its own skin leans by more.
        QFETCH(bool, scan);
        QVERIFY(most < (scan ? 30.0F : 5.0F));
        QVERIFY(offDeg[offDeg.size() / 2] < (scan ? 12.0F : 2.0F));
    }

    void aKindOfBraidIsNeverMixed()
    {
        Project project = newProject();
        sim::TiledRaster& braid = project.groups.front().map(MapKind::Braid).layers.front().raster;
        for (int y = 0; y < braid.size(); ++y)
            for (int x = 0; x < braid.size(); ++x)
                braid.setTexel(x, y, {static_cast<std::uint16_t>((x / 9 + y / 9) % 2 == 0 ? 3 : 0), 65535});
        const std::shared_ptr<const Head>& child = foreign(false).head;
        const auto groups = carriedGroups(project.groups, project.head, child);
        const sim::TiledRaster& carried = groups->front().map(MapKind::Braid).layers.front().raster;
        int braided = 0;
        for (int y = 0; y < carried.size(); ++y)
            for (int x = 0; x < carried.size(); ++x) {
                const std::uint16_t kind = carried.texel(x, y)[0];
                QVERIFY(kind == 0 || kind == 3);
                braided += kind == 3 ? 1 : 0;
            }
        QVERIFY(braided > 10'000);
    }

    void stoppedMidwayNothingComes()
    {
        const std::shared_ptr<const Head>& child = foreign(false).head;
        for (const double stop : {0.1, 0.7})
            QVERIFY(
                !carriedGroups(m_project.groups, m_project.head, child, [stop](double done) { return done < stop; }));
    }

    void headsWithoutLandmarksTakeMapsAsTheyLie()
    {
        const std::shared_ptr<const Head> patch = test::headOf(test::makePatchHead(), false);
        QVERIFY(!canCarry(m_project.head, patch));
        QVERIFY(carriedGroups(m_project.groups, m_project.head, patch) == m_project.groups);
    }

    void aStyleAppliedOnAForeignHeadIsCarriedThere()
    {
        const std::shared_ptr<const Head>& child = foreign(false).head;
        Project project = m_project;
        project.head = child;
        project.groups.front() = makeGroup(project, QStringLiteral("Scalp"), 256);
        const Preset style = presetFrom(m_project, QStringLiteral("Parted"));
        applyPreset(project, style);
        const std::optional<Preset> carried = carriedPreset(style, child);
        const auto density = [](const HairGroup& group) { return group.map(MapKind::Density).layers.front().raster; };
        QVERIFY(density(project.groups.front()) == density(carried->groups.front()));
        QVERIFY(!(density(project.groups.front()) == density(style.groups.front())));
    }

    void aHeadAndTheHairCarriedToItAreOneStep()
    {
        Document document(m_project);
        const std::shared_ptr<const Head>& child = foreign(false).head;
        const auto carried = carriedGroups(m_project.groups, m_project.head, child);
        document.push(setHeadCommand(document, child, {}, *carried));
        QCOMPARE(document.undoStack().count(), 1);
        QVERIFY(document.committed().head == child && document.committed().groups == *carried);
        document.undo();
        QVERIFY(test::sameProjects(document.committed(), m_project));
        document.redo();
        QVERIFY(document.committed().head == child && document.committed().groups == *carried);
    }

    void landmarksThatAFileHasWrongDoNoHarm_data()
    {
        QTest::addColumn<float>("scatterM");
        QTest::newRow("all at one point") << 0.0F;
        QTest::newRow("nearly so") << 1e-5F;
        QTest::newRow("a kilometre away") << 1000.0F;
    }
    void landmarksThatAFileHasWrongDoNoHarm()
    {
        QFETCH(float, scatterM);
        sim::HeadLandmarks wrong;
        for (std::size_t i = 0; i < sim::kHeadLandmarkCount; ++i) {
            const auto angle = static_cast<float>(i);
            wrong.positionsHd[i] =
                scatterM * glm::vec3(std::sin(angle), std::cos(2.0F * angle), std::sin(3.0F * angle));
        }
        const Checked<std::shared_ptr<const Head>> head =
            headFromGlb(QStringLiteral("ball"), glbFromMesh(test::makeBallHead(24, 0.1F)), 1.0F, UpAxis::Y, {}, wrong);
        QVERIFY(head && *head);
        for (const glm::vec3& p : (*head)->landmarks->positionsHd)
            QVERIFY(std::abs(glm::length(p) - 0.1F) < 0.002F);
        QVERIFY((*head)->scalpFraction > 0.0 && (*head)->scalpFraction <= 1.0);
        const auto correspondence = UvCorrespondence::make(defaultHead(), *head, 64);
        const std::optional<glm::vec2> uv = correspondence->at({0.5F, 0.5F});
        QVERIFY(uv && uv->x >= 0.0F && uv->x <= 1.0F && uv->y >= 0.0F && uv->y <= 1.0F);
    }

    void aStyleOnAForeignHeadKeepsThatHead()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("foreign.hairpreset"));
        const test::ForeignHead foreign = test::childOf(defaultHead()->skin->mesh());
        const auto head = makeHead(QStringLiteral("child"), glbFromMesh(foreign.mesh), 1.0F, UpAxis::Y);
        QVERIFY(head.has_value());
        Project project = m_project;
        project.head = *head;
        project.groups = *carriedGroups(m_project.groups, m_project.head, *head);
        QVERIFY(savePreset(presetFrom(project, QStringLiteral("Parted")), path));
        const Result<Preset> read = loadPreset(path);
        QVERIFY2(read, read ? "" : qPrintable(read.error().message));
        QVERIFY(read->head && !read->head->builtIn);
        QVERIFY(read->head->landmarks == (*head)->landmarks);
        // The same head from another file is no other head; on the built-in one the hair is where it was.
        QVERIFY(!canCarry(read->head, *head));
        const std::optional<Preset> carried = carriedPreset(*read, defaultHead());
        const sim::TiledRaster& density = carried->groups.front().map(MapKind::Density).layers.front().raster;
        const sim::SurfacePoint top = defaultHead()->skin->nearest({0.03F, 0.11F, 0.0F});
        QVERIFY(density.sampleBilinear(top.uv).x > 0.9F);
    }
};

HAIRPAINT_TEST(TestStyleTransfer, None)
#include "test_style_transfer.moc"
