// The hashes are fixed for ever, and the transcendentals are as close to the library's as promised.
#include "sim/base/deterministic.h"

#include "sim/base/rounded.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <array>
#include <bit>
#include <cmath>
#include <limits>

using namespace hairpaint::sim;
using Function = float (*)(float);

class TestDeterministic : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void hashesAreWrittenInStone_data();
    void hashesAreWrittenInStone();
    void unitFloatsLieInTheHalfOpenUnitInterval();
    void unitFloatsFillTheIntervalEvenly();
    void sineAndCosineAreWithinTwoMillionths();
    void exponentialIsWithinAMillionth();
    void absurdAnglesGiveNumbers();
    void roundedFunctionsGiveTheseBits_data();
    void roundedFunctionsGiveTheseBits();
};

void TestDeterministic::hashesAreWrittenInStone_data()
{
    QTest::addColumn<quint64>("key");
    QTest::addColumn<quint64>("counter");
    QTest::addColumn<quint64>("hash");
    // Projects on disk depend on these: a change here moves every hair ever grown.
    QTest::newRow("0, 0") << quint64{0} << quint64{0} << quint64{0xA706DD2F4D197E6FU};
    QTest::newRow("1, 0") << quint64{1} << quint64{0} << quint64{0x5E41AB087439611EU};
    QTest::newRow("1, 1") << quint64{1} << quint64{1} << quint64{0xF18D6CE93D6CF1EEU};
    QTest::newRow("large") << ~quint64{0} << ~quint64{0} << quint64{0x445018E305810B78U};
}

void TestDeterministic::hashesAreWrittenInStone()
{
    QFETCH(quint64, key);
    QFETCH(quint64, counter);
    QFETCH(quint64, hash);
    QCOMPARE(static_cast<quint64>(hash64(key, counter)), hash);
}

void TestDeterministic::unitFloatsLieInTheHalfOpenUnitInterval()
{
    QCOMPARE(unitFloat(0), 0.0F);
    QVERIFY(unitFloat(~std::uint64_t{0}) < 1.0F);
}

void TestDeterministic::unitFloatsFillTheIntervalEvenly()
{
    constexpr int kSamples = 64000;
    std::array<int, 64> counts{};
    for (std::uint64_t i = 0; i < kSamples; ++i)
        ++counts[static_cast<std::size_t>(unitFloat(hash64(7, i)) * 64.0F)];
    for (const int count : counts)
        QVERIFY2(std::abs(count - 1000) < 160, qPrintable(QString::number(count)));
}

void TestDeterministic::sineAndCosineAreWithinTwoMillionths()
{
    for (int i = -200000; i <= 200000; ++i) {
        const float x = static_cast<float>(i) * 0.0499F;
        QVERIFY2(std::abs(static_cast<double>(sinDet(x)) - std::sin(static_cast<double>(x))) < 2e-6,
                 qPrintable(QString::number(x)));
        QVERIFY(sinCosDet(x).sine == sinDet(x) && sinCosDet(x).cosine == cosDet(x));
        QVERIFY2(std::abs(static_cast<double>(cosDet(x)) - std::cos(static_cast<double>(x))) < 2e-6,
                 qPrintable(QString::number(x)));
    }
}

void TestDeterministic::exponentialIsWithinAMillionth()
{
    for (int i = -8000; i <= 8000; ++i) {
        const float x = static_cast<float>(i) * 0.01F;
        const double exact = std::exp(static_cast<double>(x));
        QVERIFY2(std::abs(static_cast<double>(expDet(x)) - exact) < 1e-6 * exact, qPrintable(QString::number(x)));
    }
    QCOMPARE(expDet(0.0F), 1.0F);
    QVERIFY(std::isfinite(expDet(1e30F)));
    QVERIFY(expDet(-1e30F) >= 0.0F && expDet(-1e30F) < 1e-30F);
}

void TestDeterministic::absurdAnglesGiveNumbers()
{
    for (const float x : {1e30F, -1e30F, std::numeric_limits<float>::infinity(), std::nanf("")}) {
        QCOMPARE(sinDet(x), 0.0F);
        QCOMPARE(cosDet(x), 1.0F);
    }
}

void TestDeterministic::roundedFunctionsGiveTheseBits_data()
{
    QTest::addColumn<Function>("function");
    QTest::addColumn<quint64>("hash");
    // Of a thousand arguments in 0..1, on every system.
    QTest::newRow("sine") << Function{[](float x) { return sinRounded(x); }} << quint64{3625038442789257585U};
    QTest::newRow("cosine") << Function{[](float x) { return cosRounded(x); }} << quint64{15402592790652033664U};
    QTest::newRow("arcsine") << Function{[](float x) { return asinRounded(x); }} << quint64{15062519861460614037U};
    QTest::newRow("arccosine") << Function{[](float x) { return acosRounded(x); }} << quint64{8916772571769135197U};
    QTest::newRow("angle") << Function{[](float x) { return atan2Rounded(x, 1.0F - x); }}
                           << quint64{7475097300408848899U};
    QTest::newRow("exponential") << Function{[](float x) { return expRounded(-x); }} << quint64{865068177515859875U};
    QTest::newRow("power") << Function{[](float x) { return powRounded(x, 2.4F); }} << quint64{5144156514688813463U};
    QTest::newRow("hypotenuse") << Function{[](float x) { return hypotRounded(x, 0.3F); }}
                                << quint64{721274037120757846U};
}

void TestDeterministic::roundedFunctionsGiveTheseBits()
{
    QFETCH(Function, function);
    QFETCH(quint64, hash);
    std::uint64_t all = 0;
    for (int i = 0; i <= 1000; ++i)
        all = hash64(all, std::bit_cast<std::uint32_t>(function(static_cast<float>(i) / 1000.0F)));
    QCOMPARE(static_cast<quint64>(all), hash);
}

HAIRPAINT_TEST(TestDeterministic, None)
#include "test_deterministic.moc"
