// The skin between the hairs: darker where roots are dense, in both renderers, and only looked at where paint changed.
#include "sim/base/deterministic.h"
#include "tests/rendering/renderer_fixture.h"
#include "tests/support/test_grooms.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"
#include "view/rendering/frame_constants.h"
#include "view/rendering/scalp_tint.h"
#include "view/rendering/software/software_renderer.h"

#include <QtTest>

#include <algorithm>

using namespace hairpaint;
using namespace hairpaint::testing;
using rendering::ScalpTint;

namespace {

constexpr glm::vec3 kBlack(0.05F);

/// Roots on the left half of the layout, or what `density` says; no hair that could be seen.
std::shared_ptr<const sim::StrandFrame> rootsAlone(float strength, sim::MapRaster density = test::halves(1.0F, 0.0F),
                                                   sim::MapRaster colour = test::uniformColour(kBlack))
{
    sim::GroupSettings settings = plainSettings();
    settings.greatestDensityPerM2 = 2e6F;
    settings.material.scalpTint = strength;
    std::shared_ptr<sim::StrandFrame> frame = makeFrame({}, settings);
    auto groom = std::make_shared<sim::Groom>(*frame->groups[0].groom);
    groom->density = std::move(density);
    groom->colour = std::move(colour);
    frame->groups[0].groom = groom;
    return frame;
}

/// From the front, u = 0 and 1 meet in the middle of the picture.
rendering::Scene tintedBall(float strength)
{
    rendering::Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    scene.skin.grain = 0.0F;
    scene.light.directionWo = glm::vec3(0.0F, 0.0F, 1.0F);
    scene.hair = rootsAlone(strength);
    return scene;
}

Picture inSoftware(const rendering::Scene& scene)
{
    rendering::SoftwareRenderer renderer;
    Picture picture{.width = 200, .height = 150, .pixels = {}};
    renderer.draw(scene, {}, picture.width, picture.height);
    renderer.read(picture.pixels);
    return picture;
}

} // namespace

class TestScalpTint : public RendererFixture
{
    Q_OBJECT
private Q_SLOTS:
    /// Light hair passes light on to the skin beneath it, dark hair takes it.
    void skinBeneathHairIsAsLightAsTheHairLets()
    {
        struct Hair
        {
            const char* name;
            std::uint32_t colour;
            float least, most; ///< Fraction of its light that the skin keeps.
        };
        for (const Hair& hair : {Hair{"black", 0xFF1B191EU, 0.1F, 0.2F}, Hair{"brown", 0xFF344356U, 0.2F, 0.3F},
                                 Hair{"blond", 0xFF58809AU, 0.38F, 0.45F}, Hair{"white", 0xFFFFFFFFU, 0.45F, 0.45F}}) {
            rendering::Scene scene = emptyScene();
            scene.hair = makeFrame(comb(hair.colour, 100), plainSettings());
            const float kept = rendering::frameConstants(scene, {.width = 200, .height = 150}, 0.1F).gridSize.w;
            QVERIFY2(kept >= hair.least && kept <= hair.most, hair.name);
        }
        const auto skinBehind = [](std::uint32_t colour) {
            // Skin shows in the gaps of a thick curtain before the ball.
            rendering::Scene scene = emptyScene();
            scene.head = makeBall({0.08F, 0.11F, 0.1F});
            std::vector<HandMadeStrand> curtain = comb(colour, 240, 0.06F, 120e-6F);
            for (HandMadeStrand& strand : curtain)
                for (glm::vec3& node : strand.nodesWo)
                    node.z += 0.11F;
            scene.hair = makeFrame(curtain, plainSettings());
            const Picture picture = inSoftware(scene);
            int lightest = 0;
            for (int x = picture.width / 2 - 8; x < picture.width / 2 + 8; ++x)
                lightest = std::max<int>(lightest, picture.at(x, picture.height / 2).x);
            return lightest;
        };
        const int behindBlack = skinBehind(0xFF101010U);
        const int behindWhite = skinBehind(0xFFF0F0F0U);
        QVERIFY2(behindBlack + 20 < behindWhite, qPrintable(QStringLiteral("%1 %2").arg(behindBlack).arg(behindWhite)));
    }

    void skinIsDarkerWhereRootsAreDense()
    {
        const rendering::Scene scene = tintedBall(0.6F);
        const Picture drawnOnce = draw(scene);
        const Picture soft = inSoftware(scene);
        const Picture plain = draw(tintedBall(0.0F));
        for (const Picture* picture : {&drawnOnce, &soft}) {
            QCOMPARE(picture->at(85, 75), plain.at(85, 75));
            const int darker = plain.at(115, 75).y - picture->at(115, 75).y;
            QVERIFY2(darker > 25, qPrintable(QString::number(darker)));
        }
        QVERIFY2(drawnOnce.difference(soft) < 2.0, qPrintable(QString::number(drawnOnce.difference(soft))));
    }

    void aLineWithoutRootsIsTintedAndTheSkinBeyondAnEdgeIsNot()
    {
        auto painted = std::make_shared<sim::TiledRaster>(*test::halves(1.0F, 0.0F));
        constexpr int kLine = 128; // Two texels wide, at a quarter of the layout.
        for (int y = 0; y < painted->size(); ++y)
            for (int x = kLine - 1; x <= kLine; ++x)
                painted->setTexel(x, y, {0});
        sim::HeadMesh mesh = test::makePatchHead(1);
        // On the line, just beyond the edge, within the hair.
        mesh.uvs = {{0.25F, 0.5F}, {0.502F, 0.5F}, {0.4F, 0.5F}, {0.9F, 0.5F}};
        ScalpTint tint;
        QVERIFY(tint.update(std::make_shared<const sim::HeadMesh>(mesh),
                            rendering::scalpTintSources(rootsAlone(0.8F, painted).get())));
        QVERIFY(tint.texels()[2].w > 30000);
        QCOMPARE(tint.texels()[0].w, tint.texels()[2].w);
        QCOMPARE(tint.texels()[1].w, std::uint16_t{0});
        QCOMPARE(tint.texels()[3].w, std::uint16_t{0});
    }

    /// Skin tinted before the last hairs of a soft hairline looked like dirt.
    void skinIsCleanWhereAHairlineThinsOut()
    {
        const auto mesh = std::make_shared<const sim::HeadMesh>(test::makePatchHead(100)); // Vertices 2 mm apart.
        const auto tintAt = [&](float softenM, float insideM) {
            rendering::ScalpTintSources sources = rendering::scalpTintSources(rootsAlone(0.8F).get());
            sources[0].softenM = softenM;
            ScalpTint tint;
            tint.update(mesh, {}); // The head is there before its hair.
            tint.update(mesh, sources);
            const glm::vec2 uv(0.5F - insideM / 0.2F, 0.5F); // The edge is in the middle.
            const auto nearest =
                std::ranges::min_element(mesh->uvs, {}, [&](glm::vec2 at) { return glm::distance(at, uv); });
            return tint.texels()[static_cast<std::size_t>(nearest - mesh->uvs.begin())].w;
        };
        constexpr float kSoftM = 0.008F;
        const std::uint16_t whole = tintAt(0.0F, 0.04F);
        QCOMPARE(tintAt(0.0F, 0.004F), whole);
        QCOMPARE(tintAt(kSoftM, 0.04F), whole);
        QCOMPARE(tintAt(kSoftM, 0.01F), whole);
        QVERIFY(tintAt(kSoftM, 0.002F) < 0.75 * whole);
        QVERIFY(tintAt(kSoftM, 0.002F) < tintAt(kSoftM, 0.006F));
        QVERIFY(tintAt(kSoftM, 0.006F) < whole);
    }

    /// At a seam the map is bare beside the skin, and hair is not.
    void aSeamIsNoHairline()
    {
        sim::HeadMesh mesh = test::makePatchHead(100);
        for (glm::vec2& uv : mesh.uvs)
            uv.x *= 0.5F; // The layout ends in the map's middle, where the paint does.
        rendering::ScalpTintSources sources = rendering::scalpTintSources(rootsAlone(0.8F).get());
        sources[0].softenM = 0.008F;
        ScalpTint tint;
        tint.update(std::make_shared<const sim::HeadMesh>(mesh), sources);
        const auto tintAt = [&](float u) {
            const auto nearest = std::ranges::min_element(
                mesh.uvs, {}, [&](glm::vec2 at) { return glm::distance(at, glm::vec2(u, 0.5F)); });
            return tint.texels()[static_cast<std::size_t>(nearest - mesh.uvs.begin())].w;
        };
        QCOMPARE(tintAt(0.49F), tintAt(0.3F));
    }

    void paintShowsInTheNextPicture()
    {
        rendering::Scene scene = tintedBall(0.6F);
        rendering::SoftwareRenderer renderer;
        Picture before{.width = 200, .height = 150, .pixels = {}};
        renderer.draw(scene, {}, before.width, before.height);
        renderer.read(before.pixels);
        const Picture onGpu = draw(scene);
        scene.hair = rootsAlone(0.6F, test::uniformMap(1.0F));
        Picture after = before;
        renderer.draw(scene, {}, after.width, after.height);
        renderer.read(after.pixels);
        QVERIFY(before.at(85, 75).y - after.at(85, 75).y > 25);
        QVERIFY(onGpu.at(85, 75).y - draw(scene).at(85, 75).y > 25);
        QCOMPARE(after.difference(inSoftware(scene)), 0.0);
    }

    void followingPaintGivesWhatAFreshLookGives()
    {
        const std::shared_ptr<const sim::HeadMesh> mesh = makeBall(kBall);
        sim::MapRaster density = test::uniformMap(0.4F);
        sim::MapRaster colour = test::uniformColour({0.4F, 0.2F, 0.1F});
        ScalpTint following;
        QVERIFY(following.update(mesh, rendering::scalpTintSources(rootsAlone(0.5F, density, colour).get())));
        for (std::uint64_t i = 0; i < 30; ++i) {
            const std::uint64_t hash = sim::hash64(1, i);
            const glm::vec2 centre(sim::unitFloat(hash), sim::unitFloat(hash << 32U));
            const auto channel = static_cast<std::uint16_t>(hash >> 40U);
            if (i % 3 == 0)
                colour = test::withDab(colour, centre, 0.03F, {channel, 0, 9000});
            else
                density = test::withDab(density, centre, 0.03F, {channel});
            rendering::ScalpTintSources sources = rendering::scalpTintSources(rootsAlone(0.5F, density, colour).get());
            sources[0].softenM = 0.01F;
            QVERIFY(following.update(mesh, sources));
            QVERIFY(!following.update(mesh, sources));
            ScalpTint fresh;
            fresh.update(mesh, sources);
            QVERIFY(std::ranges::equal(following.texels(), fresh.texels()));
        }
    }

    void nothingTintsWhatIsHiddenOrSetToNone()
    {
        const auto shown = rootsAlone(0.5F);
        QCOMPARE(rendering::scalpTintSources(shown.get()).size(), std::size_t{1});
        QVERIFY(rendering::scalpTintSources(rootsAlone(0.0F).get()).empty());
        auto hidden = std::make_shared<sim::StrandFrame>(*shown);
        auto groom = std::make_shared<sim::Groom>(*hidden->groups[0].groom);
        groom->visible = false;
        hidden->groups[0].groom = groom;
        QVERIFY(rendering::scalpTintSources(hidden.get()).empty());
        const std::shared_ptr<const sim::HeadMesh> mesh = makeBall(kBall);
        ScalpTint tint;
        QVERIFY(!tint.update(mesh, {}));
        QVERIFY(tint.update(mesh, rendering::scalpTintSources(shown.get())));
        QVERIFY(tint.update(mesh, {}));
        QVERIFY(tint.texels().empty());
    }
};

HAIRPAINT_TEST(TestScalpTint, None)
#include "test_scalp_tint.moc"
