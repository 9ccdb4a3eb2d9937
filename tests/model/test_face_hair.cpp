// Where eyebrows and eyelashes grow.
#include "model/document/document.h"
#include "model/document/group_commands.h"
#include "model/files/head_file.h"
#include "model/files/project_file.h"
#include "model/growth/face_hair.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <set>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

/// The first value, 0..1, of the map's lowest layer at the skin nearest to a position; 0 where nothing is painted.
float valueAt(const HairGroup& group, MapKind map, const Head& head, const glm::vec3& positionHd)
{
    const sim::TiledRaster& raster = group.map(map).layers.front().raster;
    const glm::vec2 uv = head.skin->nearest(positionHd).uv;
    const auto side = static_cast<float>(raster.size());
    const sim::Texel texel = raster.texel(static_cast<int>(uv.x * side), static_cast<int>((1.0F - uv.y) * side));
    return texel[1] > 0 ? static_cast<float>(texel[0]) / 65535.0F : 0.0F;
}

/// Greatest density within 4 mm of a position.
float densityNear(const HairGroup& group, const Head& head, const glm::vec3& positionHd)
{
    float greatest = 0.0F;
    for (int y = -8; y <= 8; ++y)
        for (int x = -8; x <= 8; ++x)
            greatest = std::max(greatest,
                                valueAt(group, MapKind::Density, head, positionHd + 0.0005F * glm::vec3(x, y, 0.0F)));
    return greatest;
}

} // namespace

class TestFaceHair : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void itGrowsOnBrowsAndLidsAlone_data()
    {
        QTest::addColumn<QString>("head");
        QTest::newRow("the new bust") << QStringLiteral("bust-2");
        QTest::newRow("the older one, carried") << QStringLiteral("bust-1");
    }
    void itGrowsOnBrowsAndLidsAlone()
    {
        QFETCH(QString, head);
        const std::shared_ptr<const Head> on = *builtInHead(head);
        const std::optional<std::vector<HairGroup>> groups = faceHair(on);
        QVERIFY(groups && groups->size() == 2);
        const HairGroup& brows = groups->at(0);
        const HairGroup& lashes = groups->at(1);
        QCOMPARE(brows.name, QStringLiteral("Brows"));
        QCOMPARE(lashes.name, QStringLiteral("Lashes"));
        for (const float side : {-1.0F, 1.0F}) {
            const glm::vec3 brow(side * 0.030F, 0.027F, 0.09F);
            const glm::vec3 eye(side * 0.0314F, -0.0059F, 0.0756F); // Where the lids meet.
            QVERIFY(densityNear(brows, *on, brow) > 0.9F && densityNear(lashes, *on, brow) == 0.0F);
            QVERIFY(densityNear(lashes, *on, eye) > 0.5F && densityNear(brows, *on, eye) == 0.0F);
            for (const glm::vec3& bare : {glm::vec3(side * 0.03F, 0.05F, 0.09F), glm::vec3(side * 0.04F, -0.04F, 0.09F),
                                          glm::vec3(side * 0.03F, 0.10F, 0.0F), glm::vec3(0.0F, 0.024F, 0.1F)})
                for (const HairGroup& group : *groups)
                    QCOMPARE(densityNear(group, *on, bare), 0.0F);
        }
    }

    void aBeardGrowsWhereItIsAskedFor_data() { itGrowsOnBrowsAndLidsAlone_data(); }
    void aBeardGrowsWhereItIsAskedFor()
    {
        QFETCH(QString, head);
        const std::shared_ptr<const Head> on = *builtInHead(head);
        const auto kinds = hairKinds();
        const auto isBeard = [](const HairKind& kind) {
            return QLatin1StringView(kind.name) == QLatin1StringView("Beard");
        };
        const std::optional<HairGroup> beard = grownHair(*std::ranges::find_if(kinds, isBeard), on);
        QVERIFY(beard && !isFaceHair(*beard));
        for (const float side : {-1.0F, 1.0F}) {
            // Thickest on lip and chin.
            for (const glm::vec3& grows :
                 {glm::vec3(side * 0.005F, -0.095F, 0.1F), glm::vec3(side * 0.010F, -0.054F, 0.105F)})
                QVERIFY2(densityNear(*beard, *on, grows) > 0.9F,
                         qPrintable(QStringLiteral("%1: %2").arg(grows.y).arg(densityNear(*beard, *on, grows))));
            const float cheek = densityNear(*beard, *on, glm::vec3(side * 0.045F, -0.07F, 0.07F));
            QVERIFY2(cheek > 0.7F && cheek < 0.85F, qPrintable(QString::number(cheek)));
            for (const glm::vec3& bare :
                 {glm::vec3(side * 0.03F, 0.027F, 0.09F), glm::vec3(side * 0.01F, 0.06F, 0.1F),
                  glm::vec3(side * 0.03F, 0.10F, 0.0F), glm::vec3(side * 0.004F, -0.01F, 0.115F)})
                QCOMPARE(densityNear(*beard, *on, bare), 0.0F);
        }
        QVERIFY(grownHair(*std::ranges::find_if(kinds, [](const HairKind& kind) { return *kind.name == '\0'; }), on) ==
                std::nullopt);
    }

    void aHeadOfHairLeavesTheFaceAlone_data() { itGrowsOnBrowsAndLidsAlone_data(); }
    void aHeadOfHairLeavesTheFaceAlone()
    {
        QFETCH(QString, head);
        const std::shared_ptr<const Head> on = *builtInHead(head);
        const std::optional<HairGroup> hair = grownHair(hairKinds().front(), on);
        QVERIFY(hair && !isFaceHair(*hair));
        for (const float side : {-1.0F, 1.0F}) {
            for (const glm::vec3& grows :
                 {glm::vec3(side * 0.03F, 0.10F, 0.0F), glm::vec3(side * 0.03F, 0.03F, -0.09F)})
                QVERIFY2(densityNear(*hair, *on, grows) > 0.9F, qPrintable(QString::number(grows.y)));
            for (const glm::vec3& bare :
                 {glm::vec3(side * 0.03F, 0.027F, 0.09F), glm::vec3(side * 0.005F, -0.095F, 0.1F),
                  glm::vec3(side * 0.12F, -0.2F, 0.0F)})
                QCOMPARE(densityNear(*hair, *on, bare), 0.0F);
        }
    }

    void aHeadWithoutLandmarksGetsNone()
    {
        auto bare = std::make_shared<Head>(*defaultHead());
        bare->builtIn = false;
        bare->landmarks.reset();
        const auto groups = faceHair(bare);
        QVERIFY(groups && groups->empty());
        Document document(newProject());
        QVERIFY(addFaceHairCommand(document, *groups) == nullptr);
    }

    void itStopsWhereItIsToldTo()
    {
        QVERIFY(!faceHair(*builtInHead(QStringLiteral("bust-1")), [](double) { return false; }));
    }

    void itIsAddedWithItsOwnIdsAndHidden()
    {
        Document document(newProject());
        const std::vector<HairGroup> before = document.committed().groups;
        document.push(addFaceHairCommand(document, *faceHair(document.committed().head)));
        const std::vector<HairGroup>& groups = document.committed().groups;
        QCOMPARE(groups.size(), before.size() + 2);
        std::set<Id> ids;
        std::size_t count = 0;
        for (const HairGroup& group : groups) {
            ids.insert(group.id);
            ++count;
            for (const MapStack& stack : group.maps)
                for (const Layer& layer : stack.layers) {
                    ids.insert(layer.id);
                    ++count;
                }
        }
        QCOMPARE(ids.size(), count);
        QVERIFY(*ids.rbegin() < document.committed().nextId);
        document.push(showFaceHairCommand(document, false));
        QVERIFY(groups.front().visible && !groups.at(1).visible && !groups.at(2).visible);
        document.undo();
        QVERIFY(groups.at(1).visible);
        document.undo();
        QVERIFY(document.committed().groups == before);
    }
};

HAIRPAINT_TEST(TestFaceHair, Gui)
#include "test_face_hair.moc"
