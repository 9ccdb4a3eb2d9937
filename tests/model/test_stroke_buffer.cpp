// The dab kernel against its formula, texel for texel.
#include "model/tools/strokes/stroke_buffer.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

constexpr int kLayerSize = 256;

int maskAt(const StrokeBuffer& buffer, int x, int y)
{
    const StrokeBuffer::MaskTile* tile = buffer.mask((y / 64) * (kLayerSize / 64) + x / 64);
    return tile == nullptr ? 0 : (*tile)[static_cast<std::size_t>(y % 64) * 64 + static_cast<std::size_t>(x % 64)];
}

Dab disc(float x, float y, float radius, float hardness = 0.8F, float strength = 1.0F)
{
    const float form = 1.0F / (radius * radius);
    return {.xTx = x, .yTx = y, .a = form, .b = 0.0F, .c = form, .hardness = hardness, .strength = strength};
}

double formula(const Dab& dab, int x, int y)
{
    const double dx = x + 0.5 - dab.xTx;
    const double dy = y + 0.5 - dab.yTx;
    const double q = dab.a * dx * dx + 2.0 * dab.b * dx * dy + dab.c * dy * dy;
    const double shortest = 1.0 / std::sqrt(std::max(dab.a, dab.c));
    const double fade = std::max(1.0 - static_cast<double>(dab.hardness) * dab.hardness, std::min(1.0, 2.0 / shortest));
    const double t = std::clamp((1.0 - q) / fade, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t) * dab.strength * 65535.0;
}

const sim::TexelRect kWhole{0, 0, kLayerSize, kLayerSize};

} // namespace

class TestStrokeBuffer : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aDabIsItsFormula_data();
    void aDabIsItsFormula();
    void dabsNeverAddUp();
    void theOrderOfDabsDoesNotShow();
    void eachTexelKeepsTheValueOfItsStrongestDab();
    void aDabTouchesOnlyTilesUnderIt();
    void nothingIsPaintedOutsideTheClip();
    void aReflectedDabIsReflectedToTheBit();
};

void TestStrokeBuffer::aDabIsItsFormula_data()
{
    QTest::addColumn<QList<float>>("dab"); // x, y, a, b, c, hardness, strength
    const auto row = [](const char* name, const Dab& d) {
        QTest::newRow(name) << QList<float>{d.xTx, d.yTx, d.a, d.b, d.c, d.hardness, d.strength};
    };
    row("small", disc(30.25F, 40.5F, 3.0F));
    row("over four tiles", disc(64.0F, 64.0F, 20.0F));
    row("soft", disc(100.0F, 90.0F, 40.0F, 0.0F));
    row("hard", disc(100.0F, 90.0F, 40.0F, 1.0F));
    row("faint", disc(100.0F, 90.0F, 40.0F, 0.5F, 0.3F));
    row("half outside", disc(2.0F, 250.0F, 30.0F));
    row("larger than the map", disc(128.0F, 128.0F, 500.0F));
    row("a thin slanting ellipse", {128.0F, 120.0F, 0.02F, 0.018F, 0.02F, 0.7F, 1.0F});
    row("a thin ellipse", {128.0F, 120.0F, 0.0004F, 0.0F, 0.1F, 0.9F, 1.0F});
    row("a single texel", disc(10.5F, 10.5F, 0.7F, 1.0F));
}

void TestStrokeBuffer::aDabIsItsFormula()
{
    QFETCH(QList<float>, dab);
    const Dab shape{dab[0], dab[1], dab[2], dab[3], dab[4], dab[5], dab[6]};
    StrokeBuffer buffer(kLayerSize);
    buffer.add(shape, kWhole);
    int covered = 0;
    for (int y = 0; y < kLayerSize; ++y)
        for (int x = 0; x < kLayerSize; ++x) {
            const int mask = maskAt(buffer, x, y);
            covered += mask > 0 ? 1 : 0;
            QVERIFY2(std::abs(mask - formula(shape, x, y)) <= 3.0, qPrintable(QStringLiteral("%1, %2").arg(x).arg(y)));
        }
    QVERIFY(covered > 0);
}

void TestStrokeBuffer::dabsNeverAddUp()
{
    StrokeBuffer once(kLayerSize), often(kLayerSize);
    once.add(disc(50.0F, 50.0F, 20.0F, 0.3F, 0.4F), kWhole);
    for (int i = 0; i < 10; ++i)
        often.add(disc(50.0F, 50.0F, 20.0F, 0.3F, 0.4F), kWhole);
    for (int y = 0; y < kLayerSize; ++y)
        for (int x = 0; x < kLayerSize; ++x)
            QCOMPARE(maskAt(often, x, y), maskAt(once, x, y));
}

void TestStrokeBuffer::theOrderOfDabsDoesNotShow()
{
    std::mt19937 random(5);
    std::vector<Dab> dabs;
    dabs.reserve(30);
    for (int i = 0; i < 30; ++i)
        dabs.push_back(disc(static_cast<float>(random() % 256), static_cast<float>(random() % 256),
                            static_cast<float>(1 + random() % 60), 0.5F, static_cast<float>(random() % 100) / 99.0F));
    StrokeBuffer forward(kLayerSize), backward(kLayerSize);
    for (const Dab& dab : dabs)
        forward.add(dab, kWhole);
    std::ranges::reverse(dabs);
    for (const Dab& dab : dabs)
        backward.add(dab, kWhole);
    for (int y = 0; y < kLayerSize; ++y)
        for (int x = 0; x < kLayerSize; ++x)
            QCOMPARE(maskAt(forward, x, y), maskAt(backward, x, y));
}

void TestStrokeBuffer::eachTexelKeepsTheValueOfItsStrongestDab()
{
    StrokeBuffer buffer(kLayerSize, 2);
    StrokeBuffer plain(kLayerSize);
    std::mt19937 random(11);
    std::vector<Dab> dabs;
    for (int i = 0; i < 30; ++i) {
        const auto at = [&] { return static_cast<float>(random() % 2560) / 10.0F; };
        dabs.push_back(
            disc(at(), at(), 5.0F + static_cast<float>(random() % 40), 0.5F, 0.3F + 0.02F * static_cast<float>(i)));
        const auto number = static_cast<std::uint16_t>(i);
        buffer.add(dabs.back(), kWhole, {number, static_cast<std::uint16_t>(1000 + i)});
        plain.add(dabs.back(), kWhole);
    }
    for (int y = 0; y < kLayerSize; y += 3)
        for (int x = 0; x < kLayerSize; x += 3) {
            const int mask = maskAt(buffer, x, y);
            QCOMPARE(mask, maskAt(plain, x, y));
            const int tile = (y / 64) * (kLayerSize / 64) + x / 64;
            QVERIFY(plain.values(tile) == nullptr);
            if (mask == 0)
                continue;
            const std::uint16_t* value =
                buffer.values(tile) + (static_cast<std::size_t>(y % 64) * 64 + static_cast<std::size_t>(x % 64)) * 2;
            QCOMPARE(static_cast<int>(value[1]), 1000 + value[0]);
            QVERIFY(std::abs(formula(dabs[value[0]], x, y) - mask) < 12.0);
        }
    // Where two are as strong, the later one counts.
    StrokeBuffer twice(kLayerSize, 1);
    twice.add(disc(100, 100, 20), kWhole, {1});
    twice.add(disc(100, 100, 20), kWhole, {2});
    QCOMPARE(static_cast<int>(twice.values(1 * 4 + 1)[(100 - 64) * 64 + 100 - 64]), 2);
}

void TestStrokeBuffer::aDabTouchesOnlyTilesUnderIt()
{
    StrokeBuffer buffer(kLayerSize);
    buffer.add(disc(100.0F, 30.0F, 10.0F), kWhole);
    QCOMPARE(buffer.takeDirty(), std::vector<int>{1});
    QCOMPARE(buffer.takeDirty(), std::vector<int>{});
    buffer.add(disc(64.0F, 30.0F, 10.0F), kWhole);
    QCOMPARE(buffer.takeDirty(), (std::vector<int>{0, 1}));
    // The corner of the box around this one is in tile 0, the disc is not.
    StrokeBuffer corner(kLayerSize);
    corner.add(disc(80.0F, 80.0F, 18.0F), kWhole);
    QCOMPARE(corner.takeDirty(), (std::vector<int>{1, 4, 5}));
}

void TestStrokeBuffer::nothingIsPaintedOutsideTheClip()
{
    const sim::TexelRect clip{60, 70, 90, 75};
    StrokeBuffer buffer(kLayerSize);
    buffer.add(disc(70.0F, 70.0F, 40.0F), clip);
    for (int y = 0; y < kLayerSize; ++y)
        for (int x = 0; x < kLayerSize; ++x)
            QCOMPARE(maskAt(buffer, x, y) > 0, x >= clip.x0 && x < clip.x1 && y >= clip.y0 && y < clip.y1);
}

void TestStrokeBuffer::aReflectedDabIsReflectedToTheBit()
{
    std::mt19937 random(11);
    for (int i = 0; i < 40; ++i) {
        Dab dab = disc(static_cast<float>(random() % 16384) / 64.0F, static_cast<float>(random() % 16384) / 64.0F,
                       static_cast<float>(1 + random() % 50), static_cast<float>(random() % 11) / 10.0F);
        dab.c *= 2.0F;
        dab.b = 0.6F * dab.a;
        Dab twin = dab;
        twin.xTx = kLayerSize - dab.xTx;
        twin.b = -dab.b;
        StrokeBuffer left(kLayerSize), right(kLayerSize);
        left.add(dab, kWhole);
        right.add(twin, kWhole);
        for (int y = 0; y < kLayerSize; ++y)
            for (int x = 0; x < kLayerSize; ++x)
                QCOMPARE(maskAt(left, x, y), maskAt(right, kLayerSize - 1 - x, y));
    }
}

HAIRPAINT_TEST(TestStrokeBuffer, None)
#include "test_stroke_buffer.moc"
