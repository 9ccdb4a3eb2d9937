// Files that are cut short, altered, foreign or hostile give one sentence, never a crash and never half a project.
#include "model/files/archive.h"
#include "model/files/glb_writing.h"
#include "model/files/group_json.h"
#include "model/files/project_file.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

const QByteArray kMimetype = "application/x-hairpaint";

/// The entries of a good file, to be spoilt one at a time.
std::vector<test::ZipEntry> entriesOf(const QString& path)
{
    const Checked<ArchiveReader> archive = ArchiveReader::open(path);
    std::vector<test::ZipEntry> entries;
    QStringList names{QStringLiteral("mimetype"), QStringLiteral("project.json")};
    for (int layer = 2; layer < 2 + kMapKindCount; ++layer)
        names.append(QStringLiteral("groups/1/%1/%2.png")
                         .arg(QLatin1String(mapSpecs()[static_cast<std::size_t>(layer) - 2].id))
                         .arg(layer));
    for (const QString& name : names)
        entries.push_back({.name = name.toLatin1(), .bytes = archive->read(name, 1 << 24).value_or(QByteArray())});
    return entries;
}

} // namespace

class TestHostileProject : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QString m_good; ///< A small project.
    QString m_bad;  ///< Where each case is written.
    QByteArray m_bytes;

    /// Empty where opening m_bad fails with one sentence that names it.
    [[nodiscard]] QString complaint() const
    {
        const Result<Project> project = loadProject(m_bad);
        if (project)
            return QStringLiteral("it was opened");
        return test::isOneSentenceNaming(project.error().message, m_bad) ? QString() : project.error().message;
    }

    /// Writes m_bad, a project on that head, which is not looked at.
    [[nodiscard]] bool saveWithHead(const QByteArray& glb, float unitScale) const
    {
        Project project;
        auto head = std::make_shared<Head>();
        head->name = QStringLiteral("hostile");
        head->builtIn = false;
        head->unitScale = unitScale;
        head->sourceGlb = glb;
        project.head = head;
        project.groups.push_back(makeGroup(project, QStringLiteral("Scalp"), 256));
        return saveProject(project, m_bad, {}).has_value();
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_good = m_folder.filePath(QStringLiteral("good.hairpaint"));
        m_bad = m_folder.filePath(QStringLiteral("bad.hairpaint"));
        Project project;
        project.head = defaultHead();
        project.groups.push_back(makeGroup(project, QStringLiteral("Scalp"), 256));
        test::paintPattern(project.groups.front().map(MapKind::Density).layers.front().raster, false, 1);
        QVERIFY(saveProject(project, m_good, {}));
        m_bytes = test::readBytes(m_good);
        QVERIFY(m_bytes.size() > 1000);
    }

    void theGoodFileOpens()
    {
        test::writeBytes(m_bad, test::makeZip(entriesOf(m_good)));
        QCOMPARE(complaint(), QStringLiteral("it was opened"));
    }

    void aFileCutShortAnywhereIsRefused()
    {
        for (qsizetype length = 0; length < m_bytes.size(); length += 64) {
            test::writeBytes(m_bad, m_bytes.first(length));
            const QString text = complaint();
            QVERIFY2(text.isEmpty(), qPrintable(QStringLiteral("cut at %1: %2").arg(length).arg(text)));
        }
    }

    void aFlippedBitIsRefusedOrHarmless()
    {
        const Result<Project> good = loadProject(m_good);
        QVERIFY(good);
        std::mt19937 random(20260);
        for (int round = 0; round < 2000; ++round) {
            QByteArray bytes = m_bytes;
            // Half of them in the last sixteenth, where the directory lies.
            const qsizetype from = round % 2 == 0 ? 0 : bytes.size() - bytes.size() / 16;
            const qsizetype at = from + static_cast<qsizetype>(random() % static_cast<quint32>(bytes.size() - from));
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << (random() % 8)));
            test::writeBytes(m_bad, bytes);
            const Result<Project> project = loadProject(m_bad);
            const QString wrong = project ? test::difference(*good, *project)
                                  : test::isOneSentenceNaming(project.error().message, m_bad) ? QString()
                                                                                              : project.error().message;
            QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("byte %1: %2").arg(at).arg(wrong)));
        }
    }

    void randomBytesInTheMiddleAreRefused()
    {
        std::mt19937 random(7);
        for (int round = 0; round < 300; ++round) {
            QByteArray bytes = m_bytes;
            const auto at = static_cast<qsizetype>(random() % static_cast<quint32>(bytes.size() - 64));
            for (qsizetype i = at; i < at + 64; ++i)
                bytes[i] = static_cast<char>(random() & 0xFFU);
            test::writeBytes(m_bad, bytes);
            const QString text = complaint();
            QVERIFY2(text.isEmpty(), qPrintable(QStringLiteral("at %1: %2").arg(at).arg(text)));
        }
    }

    void aForeignFileIsRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("a text") << QByteArray("Dear diary,\ntoday I cut my hair.\n");
        QTest::newRow("a PNG") << test::pngSignature() + test::pngHeader(4, 4, 8, 6) + test::pngChunk("IEND", {});
        QTest::newRow("a JPEG") << QByteArray("\xFF\xD8\xFF\xE0\x00\x10JFIF\x00\x01", 13) + QByteArray(500, 'x');
        QTest::newRow("an empty archive") << test::makeZip({});
        QTest::newRow("another's archive") << test::makeZip({{.name = "a.txt", .bytes = "hello"}});
        QTest::newRow("an OpenDocument") << test::makeZip(
            {{.name = "mimetype", .bytes = "application/vnd.oasis.opendocument.text"}});
        QTest::newRow("a preset") << test::makeZip({{.name = "mimetype", .bytes = "application/x-hairpaint-preset"}});
        QTest::newRow("only PK") << QByteArray("PK");
        QTest::newRow("only an end record") << QByteArray("PK\x05\x06", 4) + QByteArray(18, '\0');
        QTest::newRow("an end record that claims 65535 entries")
            << QByteArray("PK\x05\x06\0\0\0\0\xFF\xFF\xFF\xFF\0\0\0\0\0\0\0\0\0\0", 22);
    }
    void aForeignFileIsRefused()
    {
        QFETCH(QByteArray, bytes);
        test::writeBytes(m_bad, bytes);
        QCOMPARE(complaint(), QString());
    }

    void whatIsNoFileIsRefused()
    {
        for (const QString& path : {m_folder.filePath(QStringLiteral("none.hairpaint")), m_folder.path()}) {
            const Result<Project> project = loadProject(path);
            QVERIFY(!project);
            QVERIFY2(test::isOneSentenceNaming(project.error().message, path), qPrintable(project.error().message));
        }
    }

    void aSpoiltArchiveIsRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        const std::vector<test::ZipEntry> good = entriesOf(m_good);
        const auto spoilt = [&good](const std::function<void(std::vector<test::ZipEntry>&)>& spoil) {
            std::vector<test::ZipEntry> entries = good;
            spoil(entries);
            return test::makeZip(entries);
        };
        using Entries = std::vector<test::ZipEntry>;
        QTest::newRow("no project.json") << spoilt([](Entries& e) { e.erase(e.begin() + 1); });
        QTest::newRow("a layer missing") << spoilt([](Entries& e) { e.pop_back(); });
        QTest::newRow("a layer twice") << spoilt([](Entries& e) { e.push_back(e.back()); });
        QTest::newRow("a path upward") << spoilt([](Entries& e) { e.push_back({.name = "../evil", .bytes = "x"}); });
        QTest::newRow("an absolute path") << spoilt([](Entries& e) { e.push_back({.name = "/etc/x", .bytes = "x"}); });
        QTest::newRow("a Windows path") << spoilt([](Entries& e) { e.push_back({.name = "C:\\x", .bytes = "x"}); });
        QTest::newRow("a control character") << spoilt([](Entries& e) { e.push_back({.name = "a\nb", .bytes = "x"}); });
        QTest::newRow("a long name") << spoilt(
            [](Entries& e) { e.push_back({.name = QByteArray(5000, 'n'), .bytes = "x"}); });
        QTest::newRow("encrypted") << spoilt([](Entries& e) { e[1].flags = 1; });
        QTest::newRow("an unknown method") << spoilt([](Entries& e) { e[1].method = 99; });
        QTest::newRow("a wrong checksum") << spoilt([](Entries& e) { e[1].crc = 0x12345678; });
        QTest::newRow("a stored size that is not its own") << spoilt([](Entries& e) { e[1].size = 1 << 20; });
        QTest::newRow("a claim of 4 GB") << spoilt([](Entries& e) {
            e[1] = {.name = "project.json", .bytes = test::deflated("{}"), .method = 8, .size = 0xFFFFFFF0U};
        });
        QTest::newRow("a bomb") << spoilt([](Entries& e) {
            const QByteArray zeros(64 << 20, ' ');
            e[1] = {.name = "project.json",
                    .bytes = test::deflated(zeros),
                    .method = 8,
                    .size = static_cast<quint32>(zeros.size()),
                    .crc = test::crcOf(zeros)};
        });
        QTest::newRow("more inside than it claims") << spoilt([](Entries& e) {
            const QByteArray zeros(1 << 20, ' ');
            e[1] = {.name = "project.json",
                    .bytes = test::deflated(zeros),
                    .method = 8,
                    .size = 100,
                    .crc = test::crcOf(zeros)};
        });
        QTest::newRow("too many entries") << spoilt([](Entries& e) {
            for (int i = 0; i < kMostArchiveEntries; ++i)
                e.push_back({.name = "x" + QByteArray::number(i), .bytes = "x"});
        });
        QTest::newRow("a comment") << test::makeZip(good, "hello");
        QByteArray zip64 = test::makeZip(good);
        zip64.insert(zip64.size() - 22, QByteArray("PK\x06\x07", 4) + QByteArray(16, '\xFF'));
        QTest::newRow("a ZIP64 locator") << zip64;
    }
    void aSpoiltArchiveIsRefused()
    {
        QFETCH(QByteArray, bytes);
        test::writeBytes(m_bad, bytes);
        QCOMPARE(complaint(), QString());
    }

    void anUnknownEntryIsIgnored()
    {
        std::vector<test::ZipEntry> entries = entriesOf(m_good);
        entries.push_back({.name = "notes/read me.txt", .bytes = "hello"});
        test::writeBytes(m_bad, test::makeZip(entries));
        QCOMPARE(complaint(), QStringLiteral("it was opened"));
    }

    void aSpoiltImageIsRefused_data()
    {
        QTest::addColumn<QByteArray>("png");
        const QByteArray good = entriesOf(m_good).back().bytes;
        const QByteArray pixels = qCompress(QByteArray(256 * (256 * 8 + 1), '\0'), 1).sliced(4);
        const auto made = [&pixels](const QByteArray& header) {
            return test::pngSignature() + header + test::pngChunk("IDAT", pixels) + test::pngChunk("IEND", {});
        };
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("a text") << QByteArray("not a picture");
        QTest::newRow("cut short") << good.chopped(20);
        QTest::newRow("bytes after the end") << good + "x";
        QTest::newRow("another size") << made(test::pngHeader(512, 512, 16, 6));
        QTest::newRow("a huge size") << made(test::pngHeader(0x7FFFFFFF, 0x7FFFFFFF, 16, 6));
        QTest::newRow("not square") << made(test::pngHeader(256, 512, 16, 6));
        QTest::newRow("no size") << made(test::pngHeader(0, 0, 16, 6));
        QTest::newRow("8 bits") << made(test::pngHeader(256, 256, 8, 6));
        QTest::newRow("no alpha") << made(test::pngHeader(256, 256, 16, 2));
        QTest::newRow("a palette") << made(test::pngHeader(256, 256, 8, 3));
        QTest::newRow("interlaced") << made(test::pngHeader(256, 256, 16, 6, 1));
        QTest::newRow("two headers") << made(test::pngHeader(256, 256, 16, 6) + test::pngHeader(256, 256, 16, 6));
        QTest::newRow("no header") << made({});
        QTest::newRow("no end") << made(test::pngHeader(256, 256, 16, 6)).chopped(12);
        QTest::newRow("an unknown critical chunk")
            << made(test::pngHeader(256, 256, 16, 6) + test::pngChunk("EVIL", "x"));
        QTest::newRow("no pixels") << test::pngSignature() + test::pngHeader(256, 256, 16, 6) +
                                          test::pngChunk("IEND", {});
        QByteArray longChunk = good;
        longChunk[33] = '\x7F';
        QTest::newRow("a chunk beyond the end") << longChunk;
        QByteArray wrongSum = good;
        wrongSum[29] = static_cast<char>(wrongSum[29] ^ 1);
        QTest::newRow("a chunk's wrong checksum") << wrongSum;
    }
    void aSpoiltImageIsRefused()
    {
        QFETCH(QByteArray, png);
        std::vector<test::ZipEntry> entries = entriesOf(m_good);
        entries.back().bytes = png;
        test::writeBytes(m_bad, test::makeZip(entries));
        QCOMPARE(complaint(), QString());
    }

    void aHostileHeadIsRefused_data()
    {
        QTest::addColumn<QByteArray>("glb");
        QTest::addColumn<float>("unitScale");
        sim::HeadMesh mesh = test::makeBallHead(8);
        mesh.uvs[5] = {3e38F, -3e38F};
        QTest::newRow("uvs without end") << glbFromMesh(mesh) << 1.0F;
        // Floats are so coarse out there that a million hairs stand at a few positions.
        mesh = test::makeBallHead(8);
        for (glm::vec3& p : mesh.positionsHd)
            p += 1e6F;
        QTest::newRow("vertices that coincide far away") << glbFromMesh(mesh) << 20.0F;
    }
    void aHostileHeadIsRefused()
    {
        QFETCH(QByteArray, glb);
        QFETCH(float, unitScale);
        QVERIFY(saveWithHead(glb, unitScale));
        QCOMPARE(complaint(), QString());
    }

    void aHeadThatCannotBeUsedIsNotCalledDamage_data()
    {
        QTest::addColumn<QByteArray>("glb");
        QTest::addColumn<QString>("reason");
        sim::HeadMesh mesh = test::makeBallHead(8);
        for (glm::vec3& p : mesh.positionsHd)
            p += 5000.0F;
        QTest::newRow("far away") << glbFromMesh(mesh) << QStringLiteral("1 km");
        mesh = test::makeBallHead(8, 1000.0F);
        QTest::newRow("too large") << glbFromMesh(mesh) << QStringLiteral("m large");
        mesh = test::makeBallHead(8);
        for (glm::vec3& p : mesh.positionsHd)
            p = {p.x, 0.0F, 0.0F};
        QTest::newRow("a line") << glbFromMesh(mesh) << QStringLiteral("no surface");
    }
    void aHeadThatCannotBeUsedIsNotCalledDamage()
    {
        QFETCH(QByteArray, glb);
        QFETCH(QString, reason);
        QVERIFY(saveWithHead(glb, 1.0F));
        QCOMPARE(complaint(), QString());
        const QString text = loadProject(m_bad).error().message;
        QVERIFY2(text.contains(reason) && !text.contains(QStringLiteral("damaged")), qPrintable(text));
    }

    /// Editing counts each layer in full, so a file of them could be opened and then neither edited nor saved.
    void layersThatShareOneImageCountAsWhenTheyAreEdited()
    {
        constexpr int kSize = 2048;
        constexpr std::size_t kLayers = kMostHeldBytes / (std::size_t{kSize} * kSize * 4) + 1;
        Project project;
        project.head = defaultHead();
        project.groups.push_back(makeGroup(project, QStringLiteral("Scalp"), 256));
        MapStack& length = project.groups.front().map(MapKind::Length);
        length.size = kSize;
        length.layers.clear();
        while (length.layers.size() < kLayers)
            length.layers.push_back(makeLayer(project, mapSpec(MapKind::Length), kSize, QStringLiteral("L")));
        sim::TiledRaster painted(256, 2);
        painted.setTexel(1, 1, {40'000, 65535, 0, 0});
        sim::TiledRaster& first = length.layers.front().raster;
        for (int index = 0; index < first.tileCount(); ++index)
            first.setTile(index, painted.tile(0));
        QVERIFY(saveProject(project, m_bad, {}));

        std::vector<test::ZipEntry> entries;
        {
            const Checked<ArchiveReader> archive = ArchiveReader::open(m_bad);
            const auto add = [&](const QString& name, const QString& source) {
                entries.push_back({.name = name.toLatin1(), .bytes = archive->read(source, 1 << 26).value()});
            };
            for (const char* name : {"mimetype", "project.json"})
                add(QString::fromLatin1(name), QString::fromLatin1(name));
            const HairGroup& group = project.groups.front();
            for (const MapStack& stack : group.maps)
                for (const Layer& layer : stack.layers)
                    add(layerEntryName(group, stack, layer), layerEntryName(group, stack, stack.layers.front()));
        }
        test::writeBytes(m_bad, test::makeZip(entries));
        QCOMPARE(complaint(), QString());
    }

    /// Memory runs out wherever a file's claims are believed; here where progress is told.
    void wantOfMemoryIsOneSentence()
    {
        const Progress outOfMemory = [](double) -> bool { throw std::bad_alloc(); };
        const Result<Project> project = loadProject(m_good, nullptr, outOfMemory);
        QVERIFY(!project);
        QVERIFY2(test::isOneSentenceNaming(project.error().message, m_good), qPrintable(project.error().message));
        const Result<void> saved = saveProject(*loadProject(m_good), m_bad, {}, nullptr, outOfMemory);
        QVERIFY(!saved);
        QVERIFY2(test::isOneSentenceNaming(saved.error().message, m_bad), qPrintable(saved.error().message));
        const Progress tooLong = [](double) -> bool { throw std::length_error("vector"); };
        QVERIFY(!loadProject(m_good, nullptr, tooLong));
    }

    void anImageSavedByAnotherProgramIsRead()
    {
        std::vector<test::ZipEntry> entries = entriesOf(m_good);
        QByteArray& png = entries.back().bytes;
        // Colour chunks and texts stand between the header and the pixels; nothing of them counts.
        png.insert(33, test::pngChunk("gAMA", QByteArray(4, '\1')) + test::pngChunk("tEXt", "Author\0me") +
                           test::pngChunk("iCCP", QByteArray(50, 'x')));
        test::writeBytes(m_bad, test::makeZip(entries));
        QCOMPARE(complaint(), QStringLiteral("it was opened"));
    }
};

HAIRPAINT_TEST(TestHostileProject, Core)
#include "test_hostile_project.moc"
