// Damaged projects: whatever is whole in them comes back, and what does not is said.
#include "model/files/archive.h"
#include "model/files/group_json.h"
#include "model/files/project_file.h"
#include "model/repair/project_repair.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace hairpaint;
using namespace hairpaint::model;
using test::EntrySpan;
using test::spansOf;

namespace {

/// From the top down as it was, then nothing painted.
bool isCutFromBelow(const sim::TiledRaster& left, const sim::TiledRaster& was, const MapSpec& spec)
{
    const sim::Texel empty = emptyTexel(spec);
    bool isCut = false;
    for (int y = 0; y < was.size(); ++y) {
        const auto isRow = [&](const auto& wanted) {
            for (int x = 0; x < was.size(); ++x)
                if (left.texel(x, y) != wanted(x))
                    return false;
            return true;
        };
        isCut = isCut || !isRow([&](int x) { return was.texel(x, y); });
        if (isCut && !isRow([&](int) { return empty; }))
            return false;
    }
    return true;
}

/// The layer with that id in a map of that kind. Ids alone do not tell it: where the settings are cut off, the ids
/// beyond are given anew, also to layers of other maps.
const Layer* layerOf(const Project& project, MapKind kind, Id id)
{
    for (const HairGroup& group : project.groups)
        for (const Layer& layer : group.map(kind).layers)
            if (layer.id == id)
                return &layer;
    return nullptr;
}

} // namespace

class TestRepair : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QString m_path;
    Project m_project;
    QByteArray m_bytes;
    std::vector<EntrySpan> m_spans;

    void save(Project project)
    {
        m_project = std::move(project);
        QVERIFY(saveProject(m_project, m_path, {}));
        m_project = loadProject(m_path).value(); // Heads come back in other objects.
        m_bytes = test::readBytes(m_path);
        m_spans = spansOf(m_bytes);
    }

    /// Two groups on a built-in head, several maps painted, two layers in one.
    [[nodiscard]] static Project smallProject()
    {
        Project project = test::makeSampleProject();
        project.head = defaultHead();
        for (HairGroup& group : project.groups)
            for (const MapKind kind : {MapKind::Colour, MapKind::TipColour, MapKind::Direction, MapKind::Gel})
                for (Layer& layer : group.map(kind).layers)
                    layer.raster = emptyRaster(mapSpec(kind), group.map(kind).size);
        return project;
    }

    [[nodiscard]] const EntrySpan& spanOf(const QString& name) const
    {
        return *std::ranges::find(m_spans, name, &EntrySpan::name);
    }

    [[nodiscard]] Result<RepairedProject> repair(const QByteArray& damaged) const
    {
        test::writeBytes(m_path, damaged);
        Result<RepairedProject> repaired = repairProject(m_path);
        return test::readBytes(m_path) == damaged ? repaired : failure(QStringLiteral("The file has changed."));
    }

    /// What is wrong with a repair of `damaged`; empty where nothing is. `isHit`: whether damage touches those bytes.
    [[nodiscard]] QString faultOf(const QByteArray& damaged,
                                  const std::function<bool(qsizetype from, qsizetype to)>& isHit) const
    {
        const Result<RepairedProject> repaired = repair(damaged);
        const auto isWhole = [&](const EntrySpan& span) { return !isHit(span.at, span.end); };
        const auto isWholeLayer = [&](const EntrySpan& span) {
            return span.name.startsWith(QLatin1String("groups/")) && isWhole(span);
        };
        const bool jsonIsWhole = isWhole(spanOf(QStringLiteral("project.json")));
        if (!repaired) {
            const bool nothingIsLeft = !jsonIsWhole && std::ranges::none_of(m_spans, isWholeLayer);
            return nothingIsLeft && test::isOneSentenceNaming(repaired.error().message, m_path)
                       ? QString()
                       : repaired.error().message;
        }
        const Project& project = repaired->project;
        const QString said = repaired->losses.join(QLatin1Char('\n'));
        Project comparable = project;
        comparable.nextId = m_project.nextId; // Found anew, as the ids of what is worn are.
        for (std::size_t i = 0; i < std::min(comparable.worn.size(), m_project.worn.size()); ++i)
            comparable.worn[i].id = m_project.worn[i].id;
        const QString differs = test::difference(m_project, comparable);
        if (!differs.isEmpty() && said.isEmpty())
            return QStringLiteral("differs in '%1' and does not say so").arg(differs);
        // Damage to headers alone may keep the settings from being proven.
        const bool isUnproven = said.count(QLatin1Char('\n')) == 0 && said.contains(QStringLiteral("checksum"));
        const bool contentIsWhole = jsonIsWhole && std::ranges::all_of(m_spans, [&](const EntrySpan& span) {
                                        return !span.name.startsWith(QLatin1String("groups/")) || isWhole(span);
                                    });
        if (contentIsWhole && !said.isEmpty() && !isUnproven)
            return QStringLiteral("nothing is lost, and it said '%1'").arg(said);
        for (const EntrySpan& span : m_spans) {
            if (!span.name.startsWith(QLatin1String("groups/")))
                continue;
            const Id id = span.name.section(QLatin1Char('/'), 3).section(QLatin1Char('.'), 0, 0).toInt();
            const MapSpec& spec = *findMapSpec(span.name.section(QLatin1Char('/'), 2, 2));
            const Layer* left = layerOf(project, spec.kind, id);
            const Layer* was = layerOf(m_project, spec.kind, id);
            const bool isSame = left != nullptr && left->raster == was->raster;
            if (isWhole(span) && !isSame)
                return QStringLiteral("%1 is whole and was lost; said '%2'").arg(span.name, said);
            if (left != nullptr && !isSame && left->raster.channels() == was->raster.channels() &&
                left->raster.size() == was->raster.size() && !isCutFromBelow(left->raster, was->raster, spec))
                return QStringLiteral("%1 is made up").arg(span.name);
            if (jsonIsWhole && (left == nullptr || left->name != was->name || left->blend != was->blend ||
                                left->opacity != was->opacity))
                return QStringLiteral("%1 lost its properties").arg(span.name);
        }
        if (jsonIsWhole && (project.seed != m_project.seed || project.wind != m_project.wind ||
                            project.light != m_project.light || project.groups.size() != m_project.groups.size() ||
                            project.groups.front().settings != m_project.groups.front().settings))
            return QStringLiteral("settings were lost");
        return {};
    }

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        m_path = m_folder.filePath(QStringLiteral("damaged.hairpaint"));
        save(smallProject());
        QVERIFY(m_bytes.size() > 10'000);
    }

    void aWholeFileHasLostNothing()
    {
        const Result<RepairedProject> repaired = repair(m_bytes);
        QVERIFY(repaired);
        QCOMPARE(repaired->losses, QStringList());
        QCOMPARE(test::difference(m_project, repaired->project), QString());
    }

    void aFileCutShortAnywhereGivesWhatStandsBefore()
    {
        const qsizetype step = std::max<qsizetype>(1, m_bytes.size() / 60);
        for (qsizetype length = m_bytes.size() - 1; length > 0; length -= length < 4000 ? 97 : step) {
            const QString fault =
                faultOf(m_bytes.first(length), [length](qsizetype, qsizetype to) { return to > length; });
            QVERIFY2(fault.isEmpty(), qPrintable(QStringLiteral("cut at %1: %2").arg(length).arg(fault)));
        }
    }

    void aFlippedByteTakesOnlyWhatItHits()
    {
        std::mt19937 random(11);
        const EntrySpan& json = spanOf(QStringLiteral("project.json"));
        for (int round = 0; round < 120; ++round) {
            // A third where the directory lies, a third in the JSON and about it.
            const qsizetype from = round % 3 == 0 ? m_spans.back().end : 0;
            const qsizetype to = round % 3 == 1 ? json.end : m_bytes.size();
            const qsizetype at = from + static_cast<qsizetype>(random() % static_cast<quint32>(to - from));
            QByteArray bytes = m_bytes;
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << (random() % 8)));
            const QString fault = faultOf(bytes, [at](qsizetype a, qsizetype b) { return at >= a && at < b; });
            QVERIFY2(fault.isEmpty(), qPrintable(QStringLiteral("byte %1: %2").arg(at).arg(fault)));
        }
    }

    void aHoleTakesOnlyWhatItHits()
    {
        std::mt19937 random(5);
        for (int round = 0; round < 40; ++round) {
            const auto length = static_cast<qsizetype>(random() % 8000);
            const auto at = static_cast<qsizetype>(random() % static_cast<quint32>(m_bytes.size() - length));
            QByteArray bytes = m_bytes;
            bytes.replace(at, length, QByteArray(length, '\0'));
            const QString fault =
                faultOf(bytes, [at, length](qsizetype a, qsizetype b) { return a < at + length && b > at; });
            QVERIFY2(fault.isEmpty(), qPrintable(QStringLiteral("%1 at %2: %3").arg(length).arg(at).arg(fault)));
        }
    }

    void withoutItsSettingsAllPaintComesBack()
    {
        const EntrySpan json = spanOf(QStringLiteral("project.json"));
        QByteArray bytes = m_bytes;
        bytes.replace(json.at, json.end - json.at, QByteArray(json.end - json.at, '\x7F'));
        const Result<RepairedProject> repaired = repair(bytes);
        QVERIFY2(repaired, qPrintable(repaired ? QString() : repaired.error().message));
        QCOMPARE(repaired->project.groups.size(), m_project.groups.size());
        for (std::size_t group = 0; group < m_project.groups.size(); ++group)
            for (const MapSpec& spec : mapSpecs()) {
                const MapStack& was = m_project.groups[group].map(spec.kind);
                const MapStack& is = repaired->project.groups[group].map(spec.kind);
                QCOMPARE(is.layers.size(), was.layers.size());
                for (std::size_t layer = 0; layer < was.layers.size(); ++layer)
                    QVERIFY(is.layers[layer].raster == was.layers[layer].raster);
            }
        QVERIFY(!repaired->losses.isEmpty());
        QVERIFY(saveProject(repaired->project, m_folder.filePath(QStringLiteral("again.hairpaint")), {}));
        QVERIFY(loadProject(m_folder.filePath(QStringLiteral("again.hairpaint"))));
    }

    void aLayerWithoutPaintIsSaidOnce()
    {
        QByteArray bytes = m_bytes;
        const auto spoil = [&bytes](const EntrySpan& span, qsizetype from) {
            bytes.replace(span.at + from, span.end - span.at - from, QByteArray(span.end - span.at - from, '\x7F'));
        };
        spoil(spanOf(QStringLiteral("project.json")), 0);
        const auto png = std::ranges::find_if(
            m_spans, [](const EntrySpan& span) { return span.name.contains(QStringLiteral("/density/")); });
        QVERIFY(png != m_spans.end());
        spoil(*png, 40); // Its size can be read.
        const Result<RepairedProject> repaired = repair(bytes);
        QVERIFY(repaired);
        const QString begin = QStringLiteral("The paint of the ");
        const QStringList paint = repaired->losses.filter(begin);
        QCOMPARE(paint.size(), qsizetype{1});
        const QString layer = paint.front().section(begin, 1).section(QStringLiteral(" is lost"), 0, 0);
        QVERIFY2(repaired->losses.filter(layer).size() == 1, qPrintable(repaired->losses.join(QLatin1Char('\n'))));
        // Words of the window, not of the file.
        for (const QString& loss : repaired->losses)
            QVERIFY2(!loss.contains(QLatin1Char('_')), qPrintable(loss));
    }

    void anImportedHeadThatIsLostIsSaid()
    {
        const Project small = m_project;
        save(test::makeSampleProject());
        const EntrySpan head = spanOf(QStringLiteral("head.glb"));
        QByteArray bytes = m_bytes;
        bytes.replace(head.at, 200, QByteArray(200, '\0'));
        const Result<RepairedProject> repaired = repair(bytes);
        QVERIFY(repaired);
        QCOMPARE(repaired->losses.size(), 1);
        QVERIFY2(repaired->losses.front().contains(QStringLiteral("Kugel")), qPrintable(repaired->losses.front()));
        QVERIFY(repaired->project.head->builtIn);
        QCOMPARE(shapesOfHead(repaired->project.worn), builtInEllipsoids());
        // With the settings gone its mesh is still there.
        const EntrySpan json = spanOf(QStringLiteral("project.json"));
        bytes = m_bytes;
        bytes.replace(json.at, json.end - json.at, QByteArray(json.end - json.at, '\x7F'));
        const Result<RepairedProject> without = repair(bytes);
        QVERIFY(without);
        QVERIFY(!without->project.head->builtIn);
        QCOMPARE(without->project.head->sourceGlb, m_project.head->sourceGlb);
        save(small);
    }

    void wrongValuesInTheSettingsTakeOnlyThemselves_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("named");
        const auto row = [](const char* name, QString from, QString to, const char* named) {
            QTest::newRow(name) << from.replace(QLatin1Char('\''), QLatin1Char('"'))
                                << to.replace(QLatin1Char('\''), QLatin1Char('"')) << QString::fromLatin1(named);
        };
        row("a seed of letters", QStringLiteral("'seed': '1844"), QStringLiteral("'seed': 'x844"), "seed");
        row("wind of text", QStringLiteral("'gustiness': 0.7"), QStringLiteral("'gustiness': 'much'"), "wind");
        row("an unknown skin", QStringLiteral("'skin': 'olive'"), QStringLiteral("'skin': 'purple'"), "skin");
        row("an unknown blending", QStringLiteral("'blend': 'multiply'"), QStringLiteral("'blend': 'glue'"),
            "Obere Lage");
        row("a size that is none", QStringLiteral("'size': 256"), QStringLiteral("'size': 255"), "");
        row("friction of text", QStringLiteral("'friction': 0.66"), QStringLiteral("'friction': 'some'"), "Friction");
        row("a limit that is a list", QStringLiteral("'max_hairs': "), QStringLiteral("'max_hairs': [], 'x': "),
            "hair candidates");
    }

    void wrongValuesInTheSettingsTakeOnlyThemselves()
    {
        QFETCH(const QString, from);
        QFETCH(const QString, to);
        QFETCH(const QString, named);
        test::writeBytes(m_path, m_bytes);
        std::vector<test::ZipEntry> entries;
        {
            const auto archive = ArchiveReader::open(m_path);
            QVERIFY(archive);
            for (const EntrySpan& span : m_spans)
                entries.push_back({.name = span.name.toLatin1(), .bytes = archive->read(span.name, 1 << 24).value()});
        }
        QVERIFY(entries[1].bytes.contains(from.toLatin1()));
        entries[1].bytes.replace(entries[1].bytes.indexOf(from.toLatin1()), from.size(), to.toLatin1());
        test::writeBytes(m_path, test::makeZip(entries));
        QVERIFY(!loadProject(m_path));
        const Result<RepairedProject> repaired = repairProject(m_path);
        QVERIFY2(repaired, qPrintable(repaired ? QString() : repaired.error().message));
        if (named.isEmpty()) {
            QCOMPARE(repaired->losses, QStringList());
            QCOMPARE(test::difference(m_project, repaired->project), QString());
            return;
        }
        QVERIFY2(!repaired->losses.isEmpty() && repaired->losses.size() <= 2,
                 qPrintable(repaired->losses.join(QLatin1Char('\n'))));
        for (const QString& loss : repaired->losses)
            QVERIFY2(loss.contains(named), qPrintable(loss));
    }

    void whatIsNoProjectIsRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("a text") << QByteArray("Dear diary,\ntoday I cut my hair.\n");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("zeros") << QByteArray(10'000, '\0');
        QTest::newRow("another's archive") << test::makeZip({{.name = "a.txt", .bytes = "hello"}});
        QTest::newRow("a preset") << test::makeZip({{.name = "mimetype", .bytes = "application/x-hairpaint-preset"}});
        QTest::newRow("headers without end") << QByteArray("PK\x03\x04", 4).repeated(100'000);
        QTest::newRow("a newer file") << test::makeZip(
            {{.name = "mimetype", .bytes = "application/x-hairpaint"},
             {.name = "project.json", .bytes = R"({"format": "hairpaint project", "format_version": 99})"}});
    }

    void whatIsNoProjectIsRefused()
    {
        QFETCH(const QByteArray, bytes);
        const Result<RepairedProject> repaired = repair(bytes);
        QVERIFY(!repaired);
        QVERIFY2(test::isOneSentenceNaming(repaired.error().message, m_path), qPrintable(repaired.error().message));
        QVERIFY(!repaired.error().isDamage); // Else it would be offered again.
    }

    void itCanBeStopped()
    {
        test::writeBytes(m_path, m_bytes.chopped(500));
        int asked = 0;
        QVERIFY(!repairProject(m_path, [&asked](double) { return ++asked < 3; }));
        const Result<RepairedProject> never = repairProject(m_path, [](double) { return false; });
        QVERIFY(!never);
        QVERIFY2(never.error().message.contains(QStringLiteral("cancelled")), qPrintable(never.error().message));
    }

    void itTellsHowFarItIs()
    {
        test::writeBytes(m_path, m_bytes.chopped(500));
        std::vector<double> told;
        QVERIFY(repairProject(m_path, [&told](double done) {
            told.push_back(done);
            return true;
        }));
        QVERIFY(std::ranges::is_sorted(told));
        QVERIFY(told.back() > 0.8 && told.back() <= 1.0);
    }
};

HAIRPAINT_TEST(TestRepair, Gui)
#include "test_repair.moc"
