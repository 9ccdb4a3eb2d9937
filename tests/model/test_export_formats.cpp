// Hair in every format, read by the formats' own definitions.
#include "model/formats/export_format.h"
#include "tests/model/archive_maker.h"
#include "tests/model/exported_hair.h"
#include "tests/model/sample_project.h"
#include "tests/support/test_program.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include <algorithm>
#include <cstring>

using namespace hairpaint;
using namespace hairpaint::model;
using test::exported;
using test::exportedAs;
using test::frameOf;
using test::hairGroup;

namespace {

/// The text between a name and what ends its value.
QString valueOf(const QString& text, const QString& name, qsizetype from = 0)
{
    const qsizetype at = text.indexOf(name + QLatin1String(" = ["), from);
    if (at < 0)
        return {};
    const qsizetype begin = at + name.size() + 4;
    return text.mid(begin, text.indexOf(QLatin1Char(']'), begin) - begin);
}

std::vector<float> numbersIn(const QString& list)
{
    std::vector<float> numbers;
    QString plain = list;
    plain.remove(QLatin1Char('(')).remove(QLatin1Char(')'));
    for (const QString& word : plain.split(QLatin1Char(','), Qt::SkipEmptyParts))
        numbers.push_back(word.toFloat());
    return numbers;
}

std::vector<glm::vec3> vectorsIn(const QString& list)
{
    const std::vector<float> numbers = numbersIn(list);
    std::vector<glm::vec3> vectors;
    vectors.reserve(numbers.size() / 3);
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
        vectors.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    return vectors;
}

struct Points
{
    std::vector<std::uint32_t> counts;
    std::vector<glm::vec3> positions;
};

/// What is to be in the files.
Points writtenPoints(const std::shared_ptr<const sim::StrandFrame>& frame)
{
    const std::optional<CurveSet> set = CurveSet::of(frame, test::allOf(*frame));
    Points points;
    CurveScratch scratch;
    for (const Curve& curve : set->curves()) {
        points.counts.push_back(curve.points);
        for (const glm::vec3& point : set->points(curve, scratch))
            points.positions.push_back(point);
    }
    return points;
}

struct Glb
{
    QJsonObject json;
    QByteArray bin;
};

Glb readGlb(const QByteArray& bytes)
{
    const auto word = [&bytes](qsizetype at) { return qFromLittleEndian<quint32>(bytes.constData() + at); };
    if (bytes.size() < 28 || word(8) != bytes.size())
        return {};
    const qsizetype json = word(12);
    return {.json = QJsonDocument::fromJson(bytes.sliced(20, json)).object(), .bin = bytes.sliced(28 + json)};
}

} // namespace

class TestExportFormats : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    [[nodiscard]] QString path(const char* suffix) const
    {
        return m_folder.filePath(QStringLiteral("hair.") + QLatin1StringView(suffix));
    }
    [[nodiscard]] QString text(const char* suffix) const { return QString::fromUtf8(test::readBytes(path(suffix))); }
    static void formats()
    {
        QTest::addColumn<int>("number");
        for (const ExportFormat& format : exportFormats())
            QTest::newRow(format.id) << static_cast<int>(&format - exportFormats().data());
    }

private Q_SLOTS:
    void usdTextHoldsEveryCurveWithItsAttributes()
    {
        const auto frame = frameOf({hairGroup(1, 65535, 65535, 0), hairGroup(2, 30'000, 40'000, 30'000)});
        QVERIFY(exported(frame, path("usda"), {}, "unreal"));
        const QString usd = text("usda");
        QVERIFY(usd.startsWith(QLatin1String("#usda 1.0\n")));
        QVERIFY(usd.contains(QLatin1String("upAxis = \"Z\"")) && usd.contains(QLatin1String("metersPerUnit = 0.01\n")));
        QVERIFY(usd.contains(QLatin1String("def Xform \"Group_1\"")) &&
                usd.contains(QLatin1String("def Xform \"Group_2\"")));
        QCOMPARE(usd.count(QLatin1Char('{')), usd.count(QLatin1Char('}')));
        QCOMPARE(usd.count(QLatin1Char('[')), usd.count(QLatin1Char(']')));
        QCOMPARE(usd.count(QLatin1String("def BasisCurves \"Strands\"")), 2);
        QCOMPARE(usd.count(QLatin1String("def BasisCurves \"Guides\"")), 2);

        const Points points = writtenPoints(frame);
        std::vector<std::uint32_t> counts;
        std::vector<glm::vec3> positions;
        for (qsizetype at = usd.indexOf(QLatin1String("\"Strands\"")); at >= 0;
             at = usd.indexOf(QLatin1String("\"Strands\""), at + 1)) {
            for (const float count : numbersIn(valueOf(usd, QStringLiteral("curveVertexCounts"), at)))
                counts.push_back(static_cast<std::uint32_t>(count));
            for (const glm::vec3& point : vectorsIn(valueOf(usd, QStringLiteral("points"), at)))
                positions.push_back(point);
            const std::size_t curves = numbersIn(valueOf(usd, QStringLiteral("curveVertexCounts"), at)).size();
            const std::size_t own = vectorsIn(valueOf(usd, QStringLiteral("points"), at)).size();
            QCOMPARE(numbersIn(valueOf(usd, QStringLiteral("float[] widths"), at)).size(), own);
            QCOMPARE(vectorsIn(valueOf(usd, QStringLiteral("primvars:displayColor"), at)).size(), own);
            QCOMPARE(vectorsIn(valueOf(usd, QStringLiteral("primvars:groom_color"), at)).size(), own);
            QCOMPARE(numbersIn(valueOf(usd, QStringLiteral("primvars:groom_id"), at)).size(), curves);
            QCOMPARE(numbersIn(valueOf(usd, QStringLiteral("primvars:groom_root_uv"), at)).size(), 2 * curves);
            QCOMPARE(valueOf(usd, QStringLiteral("primvars:groom_guide"), at), QStringLiteral("0"));
        }
        QCOMPARE(counts, points.counts);
        QCOMPARE(positions.size(), points.positions.size());
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const glm::vec3 own = points.positions[i];
            QVERIFY(positions[i] == 100.0F * glm::vec3(own.x, -own.z, own.y));
        }
        const qsizetype guides = usd.indexOf(QLatin1String("\"Guides\""));
        QCOMPARE(valueOf(usd, QStringLiteral("primvars:groom_guide"), guides), QStringLiteral("1"));
        // Widths in the stage's unit, which for Unreal is the centimetre.
        const float width = numbersIn(valueOf(usd, QStringLiteral("float[] widths"))).front();
        QVERIFY(width > 0.002F && width < 0.02F);
    }

    void usdTextHasTheRoughnessOfEachHairWhereGlossIsPainted()
    {
        const auto roughness = [&](sim::Texel gloss) {
            sim::GroomInput::Group input = hairGroup(1, 65535, 65535, 0);
            auto map = std::make_shared<sim::TiledRaster>(256, 1, sim::Texel{32768});
            map->setUniform(0, gloss);
            input.maps[sim::MapSlot::Gloss] = map;
            if (!exported(frameOf({input}), path("usda"), {}, "unreal"))
                return std::vector<float>{};
            return numbersIn(valueOf(text("usda"), QStringLiteral("primvars:groom_roughness")));
        };
        const std::vector<float> alike = roughness({32768});
        QCOMPARE(alike, std::vector<float>{sim::StrandMaterial{}.roughness});
        const std::vector<float> painted = roughness({65535});
        QCOMPARE(painted.size(), numbersIn(valueOf(text("usda"), QStringLiteral("curveVertexCounts"))).size());
        const auto [least, most] = std::ranges::minmax(painted);
        QCOMPARE(most, sim::StrandMaterial{}.roughness);
        QVERIFY(least < 0.5F * most);
    }

    /// At its default is what a format does not take, on what it implies.
    void aFormatHasOfTheWishesWhatItTakes()
    {
        ExportRequest wanted;
        wanted.curves.toleranceM = 0.002F;
        wanted.cards = {.triangles = 2000, .atlasPx = 1024, .levels = 3};
        wanted.author = QStringLiteral("Ann");
        for (const ExportFormat& format : exportFormats()) {
            const ExportRequest got = format.requestFor(wanted);
            QCOMPARE(got.format, &format);
            QCOMPARE(got.curves.toleranceM, 0.002F);
            QCOMPARE(got.author, format.isAvatar ? wanted.author : QString());
            CardSettings cards = format.hasCards ? wanted.cards : CardSettings{};
            if (format.isAvatar)
                cards = {.triangles = 2000, .atlasPx = 1024, .levels = 1, .springBones = true, .withHead = true};
            QVERIFY2(got.cards == cards, format.id);
        }
    }

    void namesOfGroupsBecomePrimsThatAreThere()
    {
        const auto frame =
            frameOf({hairGroup(1, 9000, 65535, 0), hairGroup(2, 9000, 65535, 0), hairGroup(3, 9000, 65535, 0)});
        const ExportRequest request{.format = findExportFormat(path("usda")),
                                    .target = &exportTargets().front(),
                                    .curves = {.groups = {{.id = 1, .name = QStringLiteral("Bärt \"2\"")},
                                                          {.id = 2, .name = QStringLiteral("1 Bärt")},
                                                          {.id = 3, .name = QStringLiteral("B_rt__2_")}},
                                               .hairs = {}}};
        QVERIFY(exportHair(frame, request, path("usda")));
        const QString usd = text("usda");
        for (const char* name : {"\"B_rt__2_\"", "\"Group_1_B_rt\"", "\"B_rt__2__2\""})
            QVERIFY2(usd.contains(QStringLiteral("def Xform ") + QLatin1StringView(name)), name);
        QVERIFY(usd.contains(QStringLiteral("[\"Bärt \\\"2\\\"\"]")));
    }

    void aUsdArchiveHoldsTheTextAlignedAndWhole()
    {
        const auto frame = frameOf({hairGroup(1, 20'000, 65535, 0)});
        QVERIFY(exported(frame, path("usda")) && exported(frame, path("usdz")));
        const QByteArray plain = test::readBytes(path("usda"));
        const QByteArray packed = test::readBytes(path("usdz"));
        QVERIFY(packed.startsWith("PK\x03\x04"));
        const auto half = [&packed](qsizetype at) { return qFromLittleEndian<quint16>(packed.constData() + at); };
        const auto word = [&packed](qsizetype at) { return qFromLittleEndian<quint32>(packed.constData() + at); };
        QCOMPARE(half(8), quint16{0});
        const qsizetype data = 30 + half(26) + half(28);
        QCOMPARE(data % 64, qsizetype{0});
        QCOMPARE(packed.sliced(30, half(26)), QByteArray("hair.usda"));
        QCOMPARE(qsizetype{word(18)}, plain.size());
        QCOMPARE(qsizetype{word(22)}, plain.size());
        QVERIFY(packed.sliced(data, plain.size()) == plain);
        QCOMPARE(word(14), test::crcOf(plain));
        // The directory repeats it, and the end tells where that is.
        const qsizetype end = packed.size() - 22;
        QVERIFY(packed.sliced(end).startsWith("PK\x05\x06"));
        const qsizetype directory = word(end + 16);
        QCOMPARE(directory, data + plain.size());
        QVERIFY(packed.sliced(directory).startsWith("PK\x01\x02"));
        QCOMPARE(qsizetype{word(directory + 24)}, plain.size());
        QCOMPARE(word(directory + 16), test::crcOf(plain));
    }

    void objLinesAreTheSegments()
    {
        const auto frame = frameOf({hairGroup(1, 20'000, 65535, 0), hairGroup(2, 9000, 30'000, 0)});
        QVERIFY(exported(frame, path("obj"), {}, "maya"));
        const Points points = writtenPoints(frame);
        std::vector<glm::vec3> vertices;
        std::size_t lines = 0;
        int objects = 0;
        bool wellFormed = true;
        for (const QString& line : text("obj").split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
            const QStringList words = line.split(QLatin1Char(' '));
            if (words[0] == QLatin1String("o"))
                ++objects;
            if (words[0] == QLatin1String("v")) {
                vertices.emplace_back(words[1].toFloat(), words[2].toFloat(), words[3].toFloat());
                wellFormed = wellFormed && words.size() == 7 && words[4].toFloat() <= 1.0F;
            }
            if (words[0] == QLatin1String("l")) {
                ++lines;
                wellFormed = wellFormed && words.size() == 3 && words[2].toInt() == words[1].toInt() + 1;
            }
        }
        QVERIFY(wellFormed);
        QCOMPARE(objects, 2);
        QCOMPARE(vertices.size(), points.positions.size());
        QCOMPARE(lines, points.positions.size() - points.counts.size());
        for (std::size_t i = 0; i < vertices.size(); ++i)
            QVERIFY(vertices[i] == 100.0F * points.positions[i]);
    }

    void ribbonsLieAlongTheirStrands()
    {
        const auto frame = frameOf({hairGroup(1, 20'000, 65535, 0), hairGroup(2, 9000, 30'000, 20'000)});
        QVERIFY(exported(frame, path("glb"), {}, "unreal")); // glTF has a space of its own.
        const Points points = writtenPoints(frame);
        const Glb glb = readGlb(test::readBytes(path("glb")));
        QCOMPARE(glb.json[QLatin1String("meshes")].toArray().size(), 2);
        QCOMPARE(glb.json[QLatin1String("buffers")][0][QLatin1String("byteLength")].toInteger(), glb.bin.size());
        std::size_t at = 0;
        std::size_t triangles = 0;
        const QJsonArray accessors = glb.json[QLatin1String("accessors")].toArray();
        const QJsonArray views = glb.json[QLatin1String("bufferViews")].toArray();
        for (const QJsonValue mesh : glb.json[QLatin1String("meshes")].toArray()) {
            const QJsonValue primitive = mesh[QLatin1String("primitives")][0];
            const QJsonValue position =
                accessors[primitive[QLatin1String("attributes")][QLatin1String("POSITION")].toInt()];
            const qint64 offset =
                views[position[QLatin1String("bufferView")].toInt()][QLatin1String("byteOffset")].toInteger();
            const qint64 count = position[QLatin1String("count")].toInteger();
            glm::vec3 least(1e9F);
            for (qint64 i = 0; i < count; i += 2) {
                glm::vec3 left;
                glm::vec3 right;
                std::memcpy(&left, glb.bin.constData() + offset + i * 36, sizeof(left));
                std::memcpy(&right, glb.bin.constData() + offset + (i + 1) * 36, sizeof(right));
                least = glm::min(least, glm::min(left, right));
                QVERIFY(glm::distance(0.5F * (left + right), points.positions[at]) < 1e-6F);
                QVERIFY(glm::distance(left, right) < 2e-4F);
                ++at;
            }
            QCOMPARE(position[QLatin1String("min")][1].toDouble(), static_cast<double>(least.y));
            triangles +=
                static_cast<std::size_t>(
                    accessors[primitive[QLatin1String("indices")].toInt()][QLatin1String("count")].toInteger()) /
                3;
        }
        QCOMPARE(at, points.positions.size());
        QCOMPARE(triangles, 2 * (points.positions.size() - points.counts.size()));
    }

    void fewerRibbonsAreWider()
    {
        const auto frame = frameOf({hairGroup(1, 65535, 65535, 0)});
        CurveOptions few = test::allOf(*frame);
        few.hairs = frame->groups.front().groom->drawnCount / 10;
        QVERIFY(exportHair(frame,
                           {.format = findExportFormat(path("glb")), .target = &exportTargets().front(), .curves = few},
                           path("glb")));
        const Glb glb = readGlb(test::readBytes(path("glb")));
        glm::vec3 left;
        glm::vec3 right;
        std::memcpy(&left, glb.bin.constData(), sizeof(left));
        std::memcpy(&right, glb.bin.constData() + 36, sizeof(right));
        QVERIFY(glm::distance(left, right) > 5e-4F && glm::distance(left, right) < 1.5e-3F);
    }

    void noHairIsAFileToo_data() { formats(); }
    void noHairIsAFileToo()
    {
        QFETCH(int, number);
        const ExportFormat& format = exportFormats()[static_cast<std::size_t>(number)];
        const QString suffix = QString::fromLatin1(format.suffix);
        const QString file = m_folder.filePath(QStringLiteral("bald.") + suffix);
        QVERIFY(exportedAs(format, frameOf({hairGroup(1, 0, 65535, 0)}), file));
        QVERIFY(!test::readBytes(file).isEmpty());
    }

    void theSameFrameGivesTheSameBytes_data() { formats(); }
    void theSameFrameGivesTheSameBytes()
    {
        QFETCH(int, number);
        const ExportFormat& format = exportFormats()[static_cast<std::size_t>(number)];
        const QString suffix = QString::fromLatin1(format.suffix);
        const QString file = m_folder.filePath(QStringLiteral("same.") + suffix);
        const std::vector<sim::GroomInput::Group> groups = {hairGroup(1, 20'000, 50'000, 30'000)};
        QVERIFY(exportedAs(format, frameOf(groups), file));
        const QByteArray once = test::readBytes(file);
        QVERIFY(exportedAs(format, frameOf(groups), file));
        QVERIFY(once == test::readBytes(file) && once.size() > 128);
    }

    void writingStopsWhereverItIsAsked_data() { formats(); }
    void writingStopsWhereverItIsAsked()
    {
        QFETCH(int, number);
        const ExportFormat& format = exportFormats()[static_cast<std::size_t>(number)];
        const QString suffix = QString::fromLatin1(format.suffix);
        const QString file = m_folder.filePath(QStringLiteral("stopped.") + suffix);
        const auto frame = frameOf({hairGroup(1, 20'000, 65535, 0)});
        std::vector<double> told;
        QVERIFY(exportedAs(format, frame, file, [&told](double fraction) {
            told.push_back(fraction);
            return true;
        }));
        QVERIFY(std::ranges::is_sorted(told));
        QCOMPARE(told.front(), 0.0);
        QCOMPARE(told.back(), 1.0);
        const QByteArray before = test::readBytes(file);
        for (std::size_t stopAt = 1; stopAt <= told.size(); ++stopAt) {
            std::size_t count = 0;
            QVERIFY(!exportedAs(format, frame, file, [&](double) { return ++count < stopAt; }));
            QVERIFY(test::readBytes(file) == before);
        }
        QCOMPARE(QDir(m_folder.path())
                     .entryList({QStringLiteral("stopped.") + suffix + QLatin1Char('*')}, QDir::Files)
                     .size(),
                 1);
    }

    void whereItCannotBeWrittenNothingIs_data() { formats(); }
    void whereItCannotBeWrittenNothingIs()
    {
        QFETCH(int, number);
        const ExportFormat& format = exportFormats()[static_cast<std::size_t>(number)];
        const QString suffix = QString::fromLatin1(format.suffix);
        const auto frame = frameOf({hairGroup(1, 9000, 65535, 0)});
        const QString long300(300, QLatin1Char('x'));
        for (const QString& nowhere :
             {m_folder.filePath(QStringLiteral("none/a.")), m_folder.filePath(long300 + QLatin1Char('.'))}) {
            const Result<void> result = exportedAs(format, frame, nowhere + suffix);
            QVERIFY(!result);
            QVERIFY2(test::isOneSentenceNaming(result.error().message, nowhere + suffix),
                     qPrintable(result.error().message));
        }
        QVERIFY(QDir(m_folder.path()).entryList({QStringLiteral("xxx*")}, QDir::Files).isEmpty());
    }

    void endingsTellTheFormat()
    {
        QCOMPARE(findExportFormat(QStringLiteral("a/b.USDA"))->suffix, "usda");
        QVERIFY(findExportFormat(QStringLiteral("a/b.fbx")) == nullptr);
        QCOMPARE(findExportFormat(QStringLiteral("a/b.glb"))->id, "ribbons");
        QCOMPARE(findExportFormat(QStringLiteral("a/b.glb"), &cardFormat())->id, "cards");
        QCOMPARE(findExportFormat(QStringLiteral("a/b.obj"), &cardFormat())->id, "obj");
        QCOMPARE(findExportFormat(QStringLiteral("a/b.vrm"), &cardFormat())->id, "vrm");
        QCOMPARE(exportSuffixes().count(QStringLiteral("glb")), 1);
        QVERIFY(findExportTarget(QStringLiteral("cinema")) == nullptr);
    }
};

HAIRPAINT_TEST(TestExportFormats, Core)
#include "test_export_formats.moc"
