// Files that are missing, cut short, foreign, hostile or too large, given to every verb, and helpers that misbehave:
// one line on standard error names the file, the code is 1, nothing is written, and it takes neither 20 s nor 2 GB.
#include "model/files/archive.h"
#include "model/files/glb_writing.h"
#include "model/files/head_file.h"
#include "model/files/project_file.h"
#include "tests/app/program.h"
#include "tests/model/archive_maker.h"
#include "tests/support/locations.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <functional>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

using Entries = std::vector<ZipEntry>;

/// A zlib stream of rows of differing bytes, each row with filter 0 before it.
QByteArray packedNumbers(qint64 count, qint64 rowBytes)
{
    QByteArray numbers(count, '\0');
    for (qint64 i = 0; i < count; ++i)
        numbers[i] = i % rowBytes == 0 ? '\0' : static_cast<char>((i * i / 7) & 0xFF);
    return qCompress(numbers, 1).sliced(4);
}

QByteArray withByteFlipped(QByteArray bytes, qsizetype at)
{
    bytes[at] = static_cast<char>(bytes[at] ^ 0x55);
    return bytes;
}

} // namespace

class TestBrokenFiles : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QString m_good; ///< A small project with a head of its own.

    [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }
    [[nodiscard]] static Entries entriesOf(const QString& path)
    {
        const auto archive = model::ArchiveReader::open(path);
        Entries entries;
        for (const char* name : {"mimetype", "project.json", "head.glb"})
            entries.push_back(
                {.name = name, .bytes = archive->read(QLatin1String(name), 1 << 24).value_or(QByteArray())});
        for (int layer = 2; layer < 2 + model::kMapKindCount; ++layer) {
            const QString name = QStringLiteral("groups/1/%1/%2.png")
                                     .arg(QLatin1String(model::mapSpecs()[static_cast<std::size_t>(layer) - 2].id))
                                     .arg(layer);
            entries.push_back({.name = name.toLatin1(), .bytes = archive->read(name, 1 << 24).value_or(QByteArray())});
        }
        return entries;
    }

    [[nodiscard]] QStringList verb(const char* name, const QString& file) const
    {
        const QString out = path(QStringLiteral("never"));
        const QByteArray verb(name);
        if (verb == "info")
            return {QStringLiteral("info"), file};
        if (verb == "export")
            return {QStringLiteral("export"), file, QStringLiteral("-o"), out + QStringLiteral(".hair")};
        if (verb == "render")
            return {QStringLiteral("render"), file, QStringLiteral("-o"), out + QStringLiteral(".png")};
        if (verb == "film")
            return {QStringLiteral("render"),   file,
                    QStringLiteral("-o"),       out + QStringLiteral(".png"),
                    QStringLiteral("--frames"), QStringLiteral("0-3")};
        QStringList arguments{QStringLiteral("new"), QStringLiteral("-o"), out + QStringLiteral(".hairpaint")};
        if (verb == "new --map")
            arguments << QStringLiteral("--map") << QStringLiteral("density=") + file;
        else if (verb == "new --head")
            arguments << QStringLiteral("--head") << file;
        else
            arguments << QStringLiteral("--preset") << file;
        return arguments;
    }

    static void addFile(const char* name, const QString& ending, const QByteArray& bytes, const QByteArray& verbs)
    {
        QTest::newRow(name) << ending << bytes << verbs;
    }

private Q_SLOTS:
    void initTestCase()
    {
        model::Project project;
        const sim::HeadMesh mesh = makePatchHead(8);
        project.head =
            model::makeHead(QStringLiteral("patch"), model::glbFromMesh(mesh), 1.0F, model::UpAxis::Y).value();
        project.groups.push_back(model::makeGroup(project, QStringLiteral("Scalp"), 256));
        m_good = path(QStringLiteral("good.hairpaint"));
        QVERIFY(model::saveProject(project, m_good, {}));
        QCOMPARE(runProgram({QStringLiteral("info"), m_good}).code, 0);
    }

    void cleanup()
    {
        qunsetenv("HAIRPAINT_IMPORT");
        qunsetenv("HAIRPAINT_IMPORT_MS");
    }

    void aFileThatCantBeReadEndsWithOneSentence_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QByteArray>("verbs");
        const QByteArray projects = "info,export,render";
        const QString project = QStringLiteral("hairpaint");
        addFile("empty", project, {}, "info,export,render,film,new --map,new --head");
        addFile("empty preset", QStringLiteral("hairpreset"), {}, "new --preset");
        addFile("a text", project, "not a project at all", "info,export,render,film,new --map,new --head");
        addFile("zeros", project, QByteArray(100'000, '\0'), "info,export,render,film,new --map,new --head");
        addFile("an archive's first bytes", project, QByteArray("PK\x03\x04 and no more", 17),
                "info,export,render,film");
        addFile("a project for a preset", QStringLiteral("hairpreset"), contentOf(m_good), "new --preset");
        addFile("a project for an image", project, contentOf(m_good), "new --map,new --head");

        const Entries good = entriesOf(m_good);
        const auto spoilt = [&good](const std::function<void(Entries&)>& spoil) {
            Entries entries = good;
            spoil(entries);
            return makeZip(entries);
        };
        // Quotation marks are written as apostrophes.
        const auto json = [&spoilt](QByteArray from, QByteArray to) {
            return spoilt([&](Entries& e) { e[1].bytes.replace(from.replace('\'', '"'), to.replace('\'', '"')); });
        };
        addFile("cut short", project, contentOf(m_good).chopped(300), projects);
        addFile("an image missing", project, spoilt([](Entries& e) { e.pop_back(); }), projects);
        addFile("an image twice", project, spoilt([](Entries& e) { e.push_back(e.back()); }), projects);
        addFile("NaN in the JSON", project, json("'seed': '1'", "'seed': NaN"), projects);
        addFile("a number beyond all", project, json("'id': 2,", "'id': 1e999,"), projects);
        addFile("a negative id", project, json("'id': 2,", "'id': -2,"), projects);
        addFile("an id twice", project, json("'id': 2,", "'id': 3,"), projects);
        addFile("maps said to be huge", project, json("'size': 256", "'size': 8192"), projects);
        addFile("maps of no size", project, json("'size': 256", "'size': -1"), projects);
        addFile("JSON nested without end", project, spoilt([](Entries& e) { e[1].bytes = QByteArray(200'000, '['); }),
                projects);
        addFile("an endless list of groups", project, spoilt([](Entries& e) {
                    e[1].bytes.replace(R"("groups": [)", R"("groups": [)" + QByteArray("{},").repeated(100'000));
                }),
                projects);
        addFile("a bomb for its JSON", project, spoilt([](Entries& e) {
                    const QByteArray blanks(200 << 20, ' ');
                    e[1] = {.name = "project.json",
                            .bytes = deflated(blanks),
                            .method = 8,
                            .size = static_cast<quint32>(blanks.size()),
                            .crc = 1};
                }),
                projects);
        addFile("a bomb for its head", project, spoilt([](Entries& e) {
                    const QByteArray zeros(300 << 20, '\0');
                    e[2] = {.name = "head.glb",
                            .bytes = deflated(zeros),
                            .method = 8,
                            .size = static_cast<quint32>(zeros.size()),
                            .crc = 1};
                }),
                projects);

        // libpng would tell of these on standard error, in lines of its own.
        constexpr qint64 kPixels = 256 * (256 * 8 + 1);
        const QByteArray packed = packedZeros(kPixels);
        const auto image = [&](const QByteArray& pixels) {
            return spoilt([&](Entries& e) { e.back().bytes = pngOf(256, 256, 16, 6, pixels); });
        };
        const QByteArray packedRamp = packedNumbers(kPixels, 256 * 8 + 1);
        addFile("an image's stream broken", project, image(withByteFlipped(packedRamp, packedRamp.size() / 2)),
                projects);
        addFile("an image's stream cut short", project, image(packed.chopped(20)), projects);
        addFile("an image's checksum wrong", project, image(withByteFlipped(packed, packed.size() - 1)), projects);
        addFile("an image of too few rows", project, image(packedZeros(kPixels - 1)), projects);
        addFile("an image of too many rows", project, image(packedZeros(kPixels + 1)), projects);
        addFile("an image of no known filter", project, image(qCompress(QByteArray(kPixels, '\7')).sliced(4)),
                projects);
        addFile("an image that is no stream", project, image(QByteArray(5000, 'x')), projects);
        addFile("an image said to be huge", project,
                spoilt([&](Entries& e) { e.back().bytes = pngOf(100'000, 100'000, 16, 6, packed); }), projects);

        const QByteArray glb = good[2].bytes;
        const auto head = [&](const QByteArray& bytes) { return spoilt([&](Entries& e) { e[2].bytes = bytes; }); };
        const auto glbJson = [&](const QByteArray& from, const QByteArray& to) {
            Q_ASSERT(from.size() == to.size() && glb.contains(from));
            QByteArray changed = glb;
            return head(changed.replace(from, to));
        };
        addFile(
            "a head's index out of range", project,
            [&] {
                QByteArray changed = glb;
                const auto jsonBytes = static_cast<qsizetype>(qFromLittleEndian<quint32>(glb.constData() + 12));
                changed.replace(20 + jsonBytes + 8, 4, QByteArray("\xFF\xFF\xFF\x7F", 4));
                return head(changed);
            }(),
            projects);
        addFile("a head of more vertices than bytes", project, glbJson(R"("count":81,)", R"("count":99,)"), projects);
        addFile("a head cut short", project, head(glb.chopped(40)), projects);
        addFile("a head that is none", project, head("glTF and no more"), projects);

        const QString pngEnding = QStringLiteral("png");
        const QByteArray map = "new --map";
        addFile("an image of 100000 x 100000", pngEnding, pngOf(100'000, 100'000, 8, 2, packedZeros(5000)), map);
        addFile("an image larger than maps are", pngEnding, pngOf(9000, 9000, 8, 2, packedZeros(9000 * 27'001LL)), map);
        addFile("a PNG cut short", pngEnding, pngOf(256, 256, 8, 2, packedZeros(256 * 769)).chopped(40), map);
        addFile("a PNG's stream broken", pngEnding,
                pngOf(256, 256, 8, 2, withByteFlipped(packedNumbers(256 * 769, 769), 3000)), map);
        addFile("a JPEG's first bytes", QStringLiteral("jpg"), QByteArray("\xFF\xD8\xFF\xE0\0\x10JFIF\0", 11), map);
        addFile("an OpenEXR's first bytes", QStringLiteral("exr"),
                QByteArray("\x76\x2F\x31\x01\2\0\0\0", 8) + QByteArray(900, '\xEE'), map);
        addFile("a TIFF of nonsense", QStringLiteral("tif"),
                QByteArray("II*\0\x08\0\0\0\xFF\xFF", 10) + QByteArray(900, '\xEE'), map);

        const QString obj = QStringLiteral("obj");
        const QByteArray mesh = "new --head";
        addFile("a mesh without faces", obj, "v 0 0 0\nv 1 0 0\n", mesh);
        addFile("a mesh without uvs", obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", mesh);
        addFile("a mesh's index out of range", obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 999999999/1\n", mesh);
        addFile("a mesh of NaN", obj, "v nan 0 0\nv 1 nan 0\nv 0 1 nan\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n", mesh);
        addFile("a mesh as large as the sky", obj,
                "v 0 0 0\nv 1e30 0 0\nv 0 1e30 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n", mesh);
        addFile("a mesh without area", obj, "v 0 0 0\nv 0 0 0\nv 0 0 0\nvt 0 0\nf 1/1 2/1 3/1\n", mesh);
        addFile("a glTF of nonsense", QStringLiteral("glb"),
                QByteArray("glTF\2\0\0\0\xFF\xFF\xFF\x7F", 12) + QByteArray(5000, '\xEE'), mesh);
        QByteArray many = "vt 0 0\n";
        for (int i = 0; i < 2'500'000; ++i)
            many += "v " + QByteArray::number(i) + " 0 0\n";
        for (int i = 1; i < 2'499'998; ++i)
            many += "f " + QByteArray::number(i) + "/1 " + QByteArray::number(i + 1) + "/1 " +
                    QByteArray::number(i + 2) + "/1\n";
        addFile("a mesh too large", obj, many, mesh);
    }

    void aFileThatCantBeReadEndsWithOneSentence()
    {
        QFETCH(QString, ending);
        QFETCH(QByteArray, content);
        QFETCH(QByteArray, verbs);
        const QString file = path(QStringLiteral("broken.") + ending);
        writeBytes(file, content);
        for (const QByteArray& name : verbs.split(','))
            QCOMPARE(faultOf(m_folder.path(), verb(name.constData(), file), QStringLiteral("broken.") + ending),
                     QString());
        QVERIFY(contentOf(file) == content);
        QFile::remove(file);
    }

    void whatIsNoFileEndsWithOneSentence_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("missing") << path(QStringLiteral("missing.hairpaint"));
        QTest::newRow("a folder") << m_folder.path();
#ifdef Q_OS_UNIX
        QTest::newRow("without end") << QStringLiteral("/dev/zero");
        const QString pipe = path(QStringLiteral("a-pipe"));
        mkfifo(pipe.toLocal8Bit().constData(), 0600);
        QTest::newRow("a pipe") << pipe;
#endif
    }

    void whatIsNoFileEndsWithOneSentence()
    {
        QFETCH(QString, file);
        for (const char* name : {"info", "export", "render", "film", "new --map", "new --head", "new --preset"})
            QCOMPARE(faultOf(m_folder.path(), verb(name, file), QFileInfo(file).fileName()), QString());
    }

    void aMisbehavingHelperCostsOneSentence_data()
    {
        QTest::addColumn<QByteArray>("mode");
        for (const char* mode : {"abort", "silent", "hang", "spin", "endless garbage", "huge length", "endless body",
                                 "image of wrong size", "good, then abort"})
            QTest::newRow(mode) << QByteArray(mode);
#if !defined(HAIRPAINT_ASAN)
        QTest::newRow("allocate") << QByteArray("allocate");
#endif
    }

    void aMisbehavingHelperCostsOneSentence()
    {
        QFETCH(QByteArray, mode);
        const QString image = path(QStringLiteral("any.png"));
        writeBytes(image, pngOf(1, 1, 8, 2, packedZeros(4)));
        const QString head = path(QStringLiteral("any.glb"));
        writeBytes(head, model::glbFromMesh(makeBallHead(8)));
        qputenv("HAIRPAINT_IMPORT", test::fakeHelper().toLocal8Bit());
        qputenv("HAIRPAINT_FAKE_HELPER", mode);
        // Helpers that never answer are given up soon; the others may take their time on a busy machine.
        if (mode == "hang" || mode == "spin")
            qputenv("HAIRPAINT_IMPORT_MS", "500");
        QCOMPARE(faultOf(m_folder.path(), verb("new --map", image), QStringLiteral("any.png")), QString());
        QCOMPARE(faultOf(m_folder.path(), verb("new --head", head), QStringLiteral("any.glb")), QString());
    }
};

HAIRPAINT_TEST(TestBrokenFiles, Core)
#include "test_broken_files.moc"
