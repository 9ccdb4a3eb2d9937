// Hair written as `.hair` is the hair that is drawn.
#include "model/formats/export_format.h"
#include "sim/groom/strand_curve.h"
#include "sim/motion/simulation.h"
#include "tests/model/archive_maker.h"
#include "tests/model/exported_hair.h"
#include "tests/model/sample_project.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cstring>

using namespace hairpaint;
using namespace hairpaint::model;
using test::flat;
using test::frameOf;
using test::hairGroup;

namespace {

/// The file, read by the format's definition.
struct HairFile
{
    bool whole = false;
    quint32 flags = 0;
    QByteArray text;
    std::vector<quint16> segments;
    std::vector<glm::vec3> points;
    std::vector<float> thickness;
    std::vector<float> transparency;
    std::vector<glm::vec3> colours;
};

HairFile parse(const QByteArray& bytes)
{
    HairFile file;
    if (bytes.size() < 128 || !bytes.startsWith("HAIR"))
        return file;
    const auto strands = qFromLittleEndian<quint32>(bytes.constData() + 4);
    const auto points = qFromLittleEndian<quint32>(bytes.constData() + 8);
    file.flags = qFromLittleEndian<quint32>(bytes.constData() + 12);
    file.text = bytes.sliced(40, 88);
    qsizetype at = 128;
    const auto take = [&](auto& values, quint32 count) {
        values.resize(count);
        if (count == 0)
            return true;
        const auto length = static_cast<qsizetype>(count) * qsizetype{sizeof(values[0])};
        if (bytes.size() - at < length)
            return false;
        std::memcpy(values.data(), bytes.constData() + at, static_cast<std::size_t>(length));
        at += length;
        return true;
    };
    file.whole = take(file.segments, strands) && take(file.points, points) && take(file.thickness, points) &&
                 take(file.transparency, points) && take(file.colours, points) && at == bytes.size();
    return file;
}

} // namespace

class TestHairFile : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    [[nodiscard]] QString path() const { return m_folder.filePath(QStringLiteral("a.hair")); }
    [[nodiscard]] HairFile written(const std::shared_ptr<const sim::StrandFrame>& frame) const
    {
        return test::exported(frame, path()) ? parse(test::readBytes(path())) : HairFile{};
    }

private Q_SLOTS:
    void theHeaderSaysWhatFollows()
    {
        const HairFile file = written(frameOf({hairGroup(1, 65535, 65535, 0)}));
        QVERIFY(file.whole);
        QCOMPARE(file.flags, 31U);
        QVERIFY(file.text.contains("metres") && file.text.contains("y up"));
    }

    void everyDrawnHairIsWritten_data()
    {
        QTest::addColumn<int>("density");
        QTest::addColumn<int>("length");
        QTest::newRow("all") << 65535 << 65535;
        QTest::newRow("half") << 32768 << 65535;
        QTest::newRow("none") << 0 << 65535;
        QTest::newRow("too short to draw") << 65535 << 10;
    }
    void everyDrawnHairIsWritten()
    {
        QFETCH(int, density);
        QFETCH(int, length);
        const auto frame =
            frameOf({hairGroup(1, static_cast<std::uint16_t>(density), static_cast<std::uint16_t>(length), 0)});
        const HairFile file = written(frame);
        QVERIFY(file.whole);
        QCOMPARE(file.segments.size(), frame->groups.front().groom->drawnCount);
        std::size_t points = 0;
        for (const quint16 segments : file.segments)
            points += segments + 1U;
        QCOMPARE(file.points.size(), points);
    }

    void aStraightHairHasTheLengthOfItsMap()
    {
        const HairFile file = written(frameOf({hairGroup(1, 65535, 16384, 0)}));
        QVERIFY(file.whole && !file.segments.empty());
        std::size_t at = 0;
        for (const quint16 segments : file.segments) {
            float length = 0.0F;
            for (std::size_t i = at; i < at + segments; ++i)
                length += glm::distance(file.points[i], file.points[i + 1]);
            QVERIFY(std::abs(length - 0.05F) < 0.0005F);
            // Roots stand on the ball, tips do not lie inside.
            QVERIFY(std::abs(glm::length(file.points[at]) - 0.1F) < 0.001F);
            QVERIFY(glm::length(file.points[at + segments]) > 0.099F);
            at += segments + 1U;
        }
    }

    void curlsHaveMorePointsThanStraightHair()
    {
        const HairFile straight = written(frameOf({hairGroup(1, 65535, 65535, 0)}));
        const HairFile curled = written(frameOf({hairGroup(1, 65535, 65535, 65535)}));
        QVERIFY(straight.whole && curled.whole && !straight.segments.empty());
        QCOMPARE(straight.segments.size(), curled.segments.size());
        QVERIFY(curled.segments.front() >= 8 * 16);
    }

    void thicknessTransparencyAndColourRunFromRootToTip()
    {
        sim::GroomInput::Group input = hairGroup(1, 65535, 65535, 0);
        input.settings.material.widthM = 70e-6F;
        input.settings.material.rootAlpha = 0.75F;
        input.settings.material.tipAlpha = 0.25F;
        const HairFile file = written(frameOf({input}));
        QVERIFY(file.whole && !file.segments.empty());
        const std::size_t tip = file.segments.front();
        QCOMPARE(file.thickness[0], 0.75F * 70e-6F);
        QCOMPARE(file.thickness[tip], 0.25F * 70e-6F);
        QCOMPARE(file.transparency[0], 0.25F);
        QCOMPARE(file.transparency[tip], 0.75F);
        // By the square of the distance to the tip, as the shader has it.
        const float middle = 0.75F - 0.5F * 0.25F;
        QCOMPARE(tip % 2, std::size_t{0});
        QCOMPARE(file.transparency[tip / 2], 1.0F - middle);
        QCOMPARE(file.thickness[tip / 2], middle * 70e-6F);
        QVERIFY(glm::distance(file.colours[0], glm::vec3(1.0F, 128.0F / 255.0F, 0.0F)) < 0.01F);
    }

    void taperWidthMapAndTipColourAreWritten()
    {
        sim::GroomInput::Group input = hairGroup(1, 65535, 65535, 0);
        input.settings.material.widthM = 70e-6F;
        input.settings.material.tipAlpha = 0.25F;
        input.settings.material.taperM = 0.05F; // A quarter of the length.
        input.settings.material.tipFrom = 0.5F;
        input.maps[sim::MapSlot::Width] = flat(1, {65535});
        input.maps[sim::MapSlot::Colour] = flat(3, {65535, 32896, 0});
        input.maps[sim::MapSlot::TipColour] = flat(3, {0, 32896, 65535});
        const HairFile file = written(frameOf({input}));
        QVERIFY(file.whole && !file.segments.empty());
        const std::size_t tip = file.segments.front();
        const float whole = 1.7F * 70e-6F;
        for (std::size_t point = 0; point <= tip; ++point) {
            const float s = static_cast<float>(point) / static_cast<float>(tip);
            const float t = std::max(4.0F * s - 3.0F, 0.0F);
            QVERIFY(std::abs(file.thickness[point] - whole * (1.0F - 0.75F * t * t)) < 1e-8F);
            QCOMPARE(file.colours[point].b > 0.0F, s > 0.5F);
        }
        QVERIFY(std::abs(file.thickness[tip] - 0.25F * whole) < 1e-8F);
        QVERIFY(std::abs(file.colours[tip].b - 1.0F) < 1e-4F);
    }

    void coloursMixInLightAsOnTheScreen()
    {
        sim::GroomInput::Group input = hairGroup(1, 65535, 65535, 0);
        input.maps[sim::MapSlot::Colour] = flat(3, {65535, 32896, 0});
        input.maps[sim::MapSlot::TipColour] = flat(3, {0, 32896, 65535});
        const HairFile file = written(frameOf({input}));
        QVERIFY(file.whole && !file.segments.empty());
        const std::size_t tip = file.segments.front();
        QCOMPARE(tip % 2, std::size_t{0});
        QVERIFY(glm::distance(file.colours[0], glm::vec3(1.0F, 128.0F / 255.0F, 0.0F)) < 1e-4F);
        QVERIFY(glm::distance(file.colours[tip], glm::vec3(0.0F, 128.0F / 255.0F, 1.0F)) < 1e-4F);
        // Half of the light is 188 of 255 as encoded.
        const glm::vec3 middle = file.colours[tip / 2];
        QVERIFY(std::abs(middle.r - 0.735357F) < 1e-4F && std::abs(middle.b - 0.735357F) < 1e-4F);
        // What does not change from root to tip is written as it is.
        for (std::size_t point = 0; point <= tip; ++point)
            QVERIFY(file.colours[point].g == 128.0F / 255.0F);
    }

    void groupsFollowEachOtherAndHiddenOnesAreLeftOut()
    {
        sim::GroomInput::Group hidden = hairGroup(2, 65535, 65535, 0);
        hidden.visible = false;
        const HairFile both = written(frameOf({hairGroup(1, 65535, 65535, 0), hairGroup(3, 65535, 32768, 0)}));
        const HairFile shown = written(frameOf({hairGroup(1, 65535, 65535, 0), hidden, hairGroup(3, 65535, 32768, 0)}));
        QVERIFY(both.whole && shown.whole);
        QCOMPARE(shown.segments.size(), both.segments.size());
        const auto lengthOf = [&both](std::size_t begin, std::size_t segments) {
            float lengthM = 0.0F;
            for (std::size_t point = begin; point < begin + segments; ++point)
                lengthM += glm::distance(both.points[point], both.points[point + 1]);
            return lengthM;
        };
        const float first = lengthOf(0, both.segments.front());
        const float last = lengthOf(both.points.size() - 1 - both.segments.back(), both.segments.back());
        QVERIFY(std::abs(first - 0.2F) < 0.002F && std::abs(last - 0.1F) < 0.001F);
    }

    void theSameFrameGivesTheSameBytes()
    {
        const std::vector<sim::GroomInput::Group> groups = {hairGroup(1, 40'000, 50'000, 30'000)};
        QVERIFY(test::exported(frameOf(groups), path()));
        const QByteArray once = test::readBytes(path());
        QVERIFY(test::exported(frameOf(groups), path()));
        QVERIFY(once == test::readBytes(path()) && once.size() > 128);
    }

    void writingStopsWhereverItIsAsked()
    {
        const auto frame = frameOf({hairGroup(1, 65535, 65535, 0)});
        int asked = 0;
        QVERIFY(test::exported(frame, path(), [&asked](double) { return ++asked > 0; }));
        // Before each of the four arrays, and before the file takes its name.
        QVERIFY(asked >= 5);
        const QByteArray before = test::readBytes(path());
        for (int stopAt = 1; stopAt <= asked; ++stopAt) {
            int count = 0;
            QVERIFY(!test::exported(frame, path(), [&](double) { return ++count < stopAt; }));
            QVERIFY(test::readBytes(path()) == before);
        }
    }

    void progressGoesFromNothingToAllAndNeverBack()
    {
        std::vector<double> told;
        QVERIFY(test::exported(frameOf({hairGroup(1, 65535, 65535, 0)}), path(), [&told](double fraction) {
            told.push_back(fraction);
            return true;
        }));
        QVERIFY(std::ranges::is_sorted(told));
        QCOMPARE(told.front(), 0.0);
        QCOMPARE(told.back(), 1.0);
    }

    void whereItCannotBeWrittenNothingIs()
    {
        const QString nowhere = m_folder.filePath(QStringLiteral("none/a.hair"));
        const Result<void> result = test::exported(frameOf({hairGroup(1, 65535, 65535, 0)}), nowhere);
        QVERIFY(!result);
        QVERIFY2(test::isOneSentenceNaming(result.error().message, nowhere), qPrintable(result.error().message));
    }
};

HAIRPAINT_TEST(TestHairFile, Core)
#include "test_hair_file.moc"
