// The table of a group's settings: what it says is what files, documentation and the groom do.
#include "model/files/project_file.h"
#include "model/heads/built_in_heads.h"
#include "model/project/group_schema.h"
#include "sim/groom/groom.h"
#include "sim/groom/roots.h"
#include "sim/solver/collider_set.h"
#include "sim/solver/strand_constants.h"
#include "tests/support/locations.h"
#include "tests/support/painted_ball.h"
#include "tests/support/test_program.h"

#include <QRegularExpression>
#include <QtTest>

#include <algorithm>
#include <utility>

using namespace hairpaint;
using model::GroupSetting;

namespace {

struct Anything
{
    template<typename T>
    operator T() const; // NOLINT(google-explicit-constructor): stands for whatever a member is.
};

template<typename Aggregate, std::size_t... indices>
consteval bool takes(std::index_sequence<indices...> /*members*/)
{
    return requires
    {
        Aggregate{(static_cast<void>(indices), Anything{})...};
    };
}

template<typename Aggregate, std::size_t count = 0>
consteval std::size_t countMembers()
{
    if constexpr (takes<Aggregate>(std::make_index_sequence<count + 1>{}))
        return countMembers<Aggregate, count + 1>();
    else
        return count;
}

/// What the solver has of a group's hairs, for the same rest shapes.
QByteArray solverConstants(const sim::Groom& groom, const sim::GroomInput& input)
{
    const sim::ColliderSet colliders = sim::prepareColliders(input.colliders, input.distances);
    const sim::GroupGains gains = sim::gainsOf(groom.settings.physics, groom.settings.nodesPerHair);
    sim::StrandState state;
    state.resize(groom.nodes, groom.basis->blockCount(), colliders.count);
    for (std::size_t i = 0; i < groom.basisCount; ++i)
        sim::setStrandConstants(state, groom, i, colliders);
    const auto bytesOf = [](const void* data, std::size_t size) {
        return QByteArray(static_cast<const char*>(data), static_cast<qsizetype>(size));
    };
    return bytesOf(&gains, sizeof(gains)) + bytesOf(state.lanes.data(), state.lanes.size() * sizeof(float));
}

/// How many members an aggregate has: it can be made from as many values, and no more.
template<typename Aggregate>
constexpr std::size_t kMembers = countMembers<Aggregate>();

} // namespace

class TestGroupSchema : public QObject
{
    Q_OBJECT
private:
    /// Another value of the setting, well within its range.
    static double otherValue(const GroupSetting& row)
    {
        const double now = row.read({});
        if (row.isSwitch() || !row.choices.empty())
            return now == 0.0 ? 1.0 : 0.0;
        const double lower = row.least + (now - row.least) * 0.5;
        return row.isInteger() ? std::floor(lower) : lower == now ? (now + row.greatest) * 0.5 : lower;
    }

    static void addRows()
    {
        QTest::addColumn<int>("index");
        for (int i = 0; i < static_cast<int>(model::groupSchema().size()); ++i)
            QTest::newRow(model::groupSchema()[static_cast<std::size_t>(i)].key) << i;
    }

private Q_SLOTS:
    void aSettingIsReadAsItIsWritten_data() { addRows(); }
    void aSettingIsReadAsItIsWritten()
    {
        QFETCH(int, index);
        const GroupSetting& row = model::groupSchema()[static_cast<std::size_t>(index)];
        sim::GroupSettings settings;
        row.write(settings, otherValue(row));
        QVERIFY(qFuzzyCompare(static_cast<float>(row.read(settings)), static_cast<float>(otherValue(row))));
        // And nothing else is.
        row.write(settings, row.read({}));
        QVERIFY(settings == sim::GroupSettings{});
        QVERIFY(row.read({}) >= row.least && row.read({}) <= row.greatest);
        QVERIFY(row.sliderLeast / row.shownPerSi >= row.least * 0.999);
        QVERIFY(row.sliderGreatest / row.shownPerSi <= row.greatest * 1.001);
    }

    void keysAreUniqueAndEveryMemberIsThere()
    {
        const std::span<const GroupSetting> rows = model::groupSchema();
        for (const GroupSetting& row : rows) {
            QCOMPARE(std::ranges::count_if(rows, [&](const GroupSetting& other) { return row.member == other.member; }),
                     1);
            QCOMPARE(std::ranges::count_if(rows,
                                           [&](const GroupSetting& other) { return qstrcmp(row.key, other.key) == 0; }),
                     1);
        }
        // No two rows are for one member, so equal numbers mean that each member has one; six are the parts.
        QCOMPARE(rows.size(), kMembers<sim::GroupSettings> - 6 + kMembers<sim::CurlSettings> +
                                  kMembers<sim::LockSettings> + kMembers<sim::HairlineSettings> +
                                  kMembers<sim::VariationSettings> + kMembers<sim::PhysicsSettings> +
                                  kMembers<sim::StrandMaterial>);
    }

    void strandsAreRebuiltJustWhereTheTableSaysSo_data() { addRows(); }
    void strandsAreRebuiltJustWhereTheTableSaysSo()
    {
        QFETCH(int, index);
        const GroupSetting& row = model::groupSchema()[static_cast<std::size_t>(index)];
        sim::GroomInput input = test::paintedBall(3000, 300);
        sim::GroomBuilder builder;
        QVERIFY(builder.update(input).rebuiltStrands > 0);
        row.write(input.groups.front().settings, otherValue(row));
        const sim::GroomBuilder::Report report = builder.update(input);
        QCOMPARE(report.rebuiltStrands > 0,
                 sim::affectsAny(sim::affectsOf(row.member), sim::Affects::Roots | sim::Affects::Hairs));
        QVERIFY(report.grooms.front()->settings == input.groups.front().settings);
    }

    void motionIsAnotherJustWhereTheTableSaysSo_data() { addRows(); }
    void motionIsAnotherJustWhereTheTableSaysSo()
    {
        QFETCH(int, index);
        const GroupSetting& row = model::groupSchema()[static_cast<std::size_t>(index)];
        static const sim::GroomInput input = test::paintedBall(500, 300);
        static const std::shared_ptr<const sim::Groom> groom = sim::GroomBuilder().update(input).grooms.front();
        sim::Groom other = *groom;
        row.write(other.settings, otherValue(row));
        QCOMPARE(solverConstants(other, input) != solverConstants(*groom, input),
                 sim::affectsAny(sim::affectsOf(row.member), sim::Affects::Motion));
        QCOMPARE(sim::sameFor(sim::Affects::Motion, other.settings, groom->settings),
                 !sim::affectsAny(sim::affectsOf(row.member), sim::Affects::Motion));
    }

    void basisHairsAreShownForTheScalp_data()
    {
        QTest::addColumn<double>("scalpFraction");
        QTest::newRow("the whole head") << 1.0;
        QTest::newRow("a bust") << 0.22831;
        QTest::newRow("a statue") << 0.101;
    }
    void basisHairsAreShownForTheScalp()
    {
        QFETCH(double, scalpFraction);
        const GroupSetting& row = model::groupSetting(QLatin1StringView("basis_hairs"));
        sim::GroupSettings settings = model::newGroupSettings(scalpFraction);
        QCOMPARE(row.shown(settings, scalpFraction), 4096.0);
        for (const double shown : {256.0, 257.0, 1000.0, 12'345.0, 1e6}) {
            row.writeShown(settings, shown, scalpFraction);
            QCOMPARE(row.shown(settings, scalpFraction), shown);
            QVERIFY(row.read(settings) >= shown);
        }
    }

    void aNewGroupSolves4096HairsOnTheScalp()
    {
        const model::Project project = model::newProject();
        const sim::GroupSettings& settings = project.groups.front().settings;
        const auto roots =
            sim::buildRoots(project.head->skin, 300'000, static_cast<std::size_t>(settings.basisHairs), 1);
        const heads::HeadRegions& regions = heads::headRows().front()->regions;
        const auto onScalp = std::ranges::count_if(roots->basisSlot, [&](std::uint32_t slot) {
            return regions.scalpDistance(roots->positionHd[slot]) > 0.0F;
        });
        QVERIFY2(std::abs(static_cast<double>(onScalp) - 4096.0) < 41.0, qPrintable(QString::number(onScalp)));
    }

    void theFormatsDocumentationSaysTheSame()
    {
        QFile file(test::sourcePath(u"model/files/hairpaint_format.md"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(file.readAll());
        for (const GroupSetting& row : model::groupSchema()) {
            const QRegularExpression pattern(QStringLiteral("^\\| `%1` \\| ([^|]*) \\| ([^|]*) \\|")
                                                 .arg(QRegularExpression::escape(QLatin1String(row.key))),
                                             QRegularExpression::MultilineOption);
            const QRegularExpressionMatch match = pattern.match(text);
            QVERIFY2(match.hasMatch(), row.key);
            const QString range = match.captured(1);
            const QString standard = match.captured(2);
            if (!row.choices.empty()) {
                for (const model::SettingChoice& choice : row.choices)
                    QVERIFY2(range.contains(QLatin1Char('`') + QLatin1String(choice.id) + QLatin1Char('`')), row.key);
                QCOMPARE(standard, QStringLiteral("`%1`").arg(
                                       QLatin1String(row.choices[static_cast<std::size_t>(row.read({}))].id)));
            } else if (row.isSwitch()) {
                QCOMPARE(standard, row.read({}) != 0.0 ? QStringLiteral("`true`") : QStringLiteral("`false`"));
            } else {
                QStringList ends = range.split(QStringLiteral(" .. "));
                QCOMPARE(ends.size(), 2);
                QCOMPARE(ends[0].startsWith(QStringLiteral("integer, ")), row.isInteger());
                ends[0].remove(QStringLiteral("integer, "));
                QCOMPARE(ends[0].toDouble(), row.least);
                QCOMPARE(ends[1].remove(QLatin1Char(',')).toDouble(), row.greatest);
                QCOMPARE(static_cast<float>(standard.toDouble()), static_cast<float>(row.read({})));
            }
        }
    }
};

HAIRPAINT_TEST(TestGroupSchema, Core)
#include "test_group_schema.moc"
