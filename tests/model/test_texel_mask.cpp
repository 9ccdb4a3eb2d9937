// Sets of texels do what sets of single texels would.
#include "model/files/head_file.h"
#include "model/tools/painting/uv_cover.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <random>

using namespace hairpaint;
using namespace hairpaint::model;

class TestTexelMask : public QObject
{
    Q_OBJECT
private:
    static constexpr int kSize = 128;

    static TexelMask scattered(unsigned seed)
    {
        std::mt19937 random(seed);
        TexelMask mask(kSize);
        for (int i = 0; i < 60; ++i)
            mask.set(static_cast<int>(random() % kSize), static_cast<int>(random() % kSize));
        for (const auto& [x, y] : {std::pair{0, 0}, {kSize - 1, 0}, {0, kSize - 1}, {63, 64}, {64, 63}})
            mask.set(x, y);
        return mask;
    }

    template<typename Wanted>
    static bool is(const TexelMask& mask, const Wanted& wanted)
    {
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x)
                if (mask.at(x, y) != wanted(x, y))
                    return false;
        return true;
    }

private Q_SLOTS:
    void runsAndWholesAreSet()
    {
        QVERIFY(is(TexelMask(kSize, true), [](int, int) { return true; }));
        for (const auto& [x0, x1] : {std::pair{0, 128}, {5, 6}, {60, 70}, {64, 128}, {63, 64}, {10, 10}}) {
            TexelMask mask(kSize);
            mask.set(7, x0, x1);
            QVERIFY(is(mask, [&, first = x0, end = x1](int x, int y) { return y == 7 && first <= x && x < end; }));
            QCOMPARE(mask.any({0, 0, kSize, kSize}), x0 < x1);
            QVERIFY(!mask.any({0, 8, kSize, kSize}));
        }
    }

    void setsAreAddedTakenAwayAndCut()
    {
        const TexelMask a = scattered(1);
        const TexelMask b = scattered(2);
        TexelMask both = a;
        both.add(b);
        QVERIFY(is(both, [&](int x, int y) { return a.at(x, y) || b.at(x, y); }));
        both.remove(a);
        QVERIFY(is(both, [&](int x, int y) { return b.at(x, y) && !a.at(x, y); }));
        const std::vector<sim::TexelRect> rects{{3, 4, 70, 90}, {80, 0, 128, 128}};
        TexelMask cut = a;
        cut.keepInside(rects);
        QVERIFY(
            is(cut, [&](int x, int y) { return a.at(x, y) && ((3 <= x && x < 70 && 4 <= y && y < 90) || x >= 80); }));
    }

    void growingTakesNeighboursInAllDirections()
    {
        const TexelMask mask = scattered(3);
        for (const int rings : {0, 1, 4}) {
            const TexelMask grown = mask.grown(rings);
            QVERIFY(is(grown, [&](int x, int y) {
                for (int ny = std::max(y - rings, 0); ny <= std::min(y + rings, kSize - 1); ++ny)
                    for (int nx = std::max(x - rings, 0); nx <= std::min(x + rings, kSize - 1); ++nx)
                        if (mask.at(nx, ny))
                            return true;
                return false;
            }));
        }
    }

    void theSkinIsWhereTexelsCentresLieInFaces_data()
    {
        QTest::addColumn<float>("middle");
        QTest::addColumn<float>("reach");
        QTest::newRow("small faces") << 0.5F << 0.05F;
        QTest::newRow("large faces") << 0.5F << 0.6F;
        QTest::newRow("faces beyond the map") << 0.5F << 20.0F;
        QTest::newRow("faces a thousand maps large") << 0.0F << 900.0F;
    }
    void theSkinIsWhereTexelsCentresLieInFaces()
    {
        QFETCH(float, middle);
        QFETCH(float, reach);
        std::mt19937 random(7);
        std::uniform_real_distribution<float> offset(-reach, reach);
        for (int round = 0; round < 100; ++round) {
            sim::HeadMesh mesh;
            const glm::vec2 at(offset(random), offset(random));
            for (int corner = 0; corner < 3; ++corner)
                mesh.uvs.push_back(middle + (reach < 0.1F ? at * 8.0F : glm::vec2(0.0F)) +
                                   glm::vec2(offset(random), offset(random)));
            if (round % 4 == 0)
                mesh.uvs[1].y = mesh.uvs[0].y; // An edge along the rows.
            mesh.triangles.emplace_back(0, 1, 2);
            const auto corner = [&](std::size_t i) {
                return glm::vec2(mesh.uvs[i].x, 1.0F - mesh.uvs[i].y) * static_cast<float>(kSize);
            };
            const auto side = [](glm::vec2 a, glm::vec2 b, glm::vec2 p) {
                return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
            };
            const float turn = side(corner(0), corner(1), corner(2)) < 0.0F ? -1.0F : 1.0F;
            QVERIFY(is(uvCover(mesh, kSize), [&](int x, int y) {
                const glm::vec2 p(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
                for (std::size_t i = 0; i < 3; ++i) {
                    const std::size_t from = turn < 0.0F ? 2 - i : i;
                    const std::size_t to = turn < 0.0F ? (4 - i) % 3 : (i + 1) % 3;
                    if (side(corner(from), corner(to), p) < 0.0F)
                        return false;
                }
                return true;
            }));
        }
    }

    void facesWithoutNumberOverTheWholeMapAreNotAllVisited()
    {
        sim::HeadMesh mesh;
        mesh.uvs = {{0.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}};
        const auto uncovered = [&](std::size_t faces) {
            mesh.triangles.assign(faces, glm::uvec3(0, 1, 2));
            return !uvCover(mesh, kSize).at(kSize - 1, 0);
        };
        QVERIFY(uncovered(10));
        // To the end this would take a minute, and hours for a large map.
        QVERIFY(!uncovered(2'000'000));
    }

    void theSkinIsAskedForOnce()
    {
        UvCover cover;
        const std::shared_ptr<const sim::Skin> skin = defaultHead()->skin;
        const TexelMask* first = &cover.of(skin, 256);
        QVERIFY(first->any({0, 0, 256, 256}));
        QCOMPARE(&cover.of(skin, 256), first);
        QCOMPARE(cover.of(skin, 512).size(), 512);
        const auto other = std::make_shared<const sim::Skin>(skin->mesh());
        QVERIFY(cover.of(other, 512).any({0, 0, 512, 512}));
    }
};

HAIRPAINT_TEST(TestTexelMask, Core)
#include "test_texel_mask.moc"
