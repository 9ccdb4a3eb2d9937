// Styles keep their outline on other heads than the one that they were made on.
#include "app/background/heads.h"
#include "model/files/glb_writing.h"
#include "model/files/head_file.h"
#include "model/files/part_selection.h"
#include "model/files/preset_file.h"
#include "model/styles/style_transfer.h"
#include "tests/app/exported_hair.h"
#include "tests/app/outlines.h"
#include "tests/support/foreign_heads.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <array>
#include <limits>
#include <map>
#include <memory>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

constexpr std::size_t kOutlineHairs = 6000;
constexpr std::array kSides{OutlineSide::Front, OutlineSide::Left};

struct WornHead
{
    std::shared_ptr<const model::Head> head;
    std::vector<sim::Ellipsoid> ellipsoids;
};

WornHead builtIn(const QString& name)
{
    return {.head = *model::builtInHead(name), .ellipsoids = model::builtInEllipsoids(name)};
}

/// As an import makes it.
WornHead imported(const sim::HeadMesh& mesh)
{
    const auto made = app::remakeHead(QStringLiteral("foreign"), model::glbFromMesh({mesh}), {});
    return made ? WornHead{.head = made->head, .ellipsoids = made->ellipsoids} : WornHead();
}

WornHead newHead(const QString& name)
{
    const sim::HeadMesh& bust = model::defaultHead()->skin->mesh();
    if (name == QLatin1StringView("own"))
        return builtIn(model::defaultHead()->name);
    if (name == QLatin1StringView("former"))
        return builtIn(QStringLiteral("bust-1"));
    if (name == QLatin1StringView("child"))
        return imported(childOf(bust).mesh);
    if (name == QLatin1StringView("broad"))
        return imported(broadOf(bust).mesh);
    if (name == QLatin1StringView("scan"))
        return imported(scanOf(bust).mesh);
    model::Result<model::RiggedMesh> mesh = model::ImporterClient(importProgram()).readMesh(name);
    if (!mesh)
        return {};
    const model::HeadGuess guess = model::guessHead(*mesh);
    if (!model::choosePartsBy(*mesh, {}, guess))
        return {};
    const auto file = app::headOf(name, *mesh, false, guess);
    return file ? WornHead{.head = file->head, .ellipsoids = file->ellipsoids} : WornHead();
}

/// Made once; of a name that is not known above the file's.
const WornHead& wornHead(const QString& name)
{
    static std::map<QString, WornHead> heads;
    const auto found = heads.find(name);
    return found != heads.end() ? found->second : heads.emplace(name, newHead(name)).first->second;
}

/// Height against the ears down to which an outline tells of the style: on a head without shoulders hair hangs
/// elsewhere below the chin.
float lowestM(const model::Head& head)
{
    const sim::HeadLandmarks& marks = *head.landmarks;
    const float ears = marks[sim::HeadLandmark::EarLeft].y;
    const float chin = marks[sim::HeadLandmark::Chin].y;
    float lowest = chin;
    for (const glm::uvec3& t : head.skin->mesh().triangles)
        lowest = std::min(lowest, head.skin->mesh().positionsHd[t.x].y);
    const bool hasShoulders = chin - lowest > ears - chin;
    return hasShoulders ? std::numeric_limits<float>::lowest() : chin - ears;
}

using Outlines = std::array<HairOutline, kSides.size()>;

Outlines outlinesOn(const WornHead& on, const QString& style)
{
    const model::Result<model::Preset> preset = app::loadPresetNamed(style);
    model::Project project = model::newProject();
    project.head = on.head;
    project.setShapesOfHead(on.ellipsoids);
    project.wind.enabled = false;
    model::applyPreset(project, *model::carriedPreset(*preset, on.head));
    const app::SettledHair hair(std::move(project), 2.0);
    model::CurveOptions options{.groups = {}, .hairs = kOutlineHairs};
    for (const model::HairGroup& group : hair.project().groups)
        options.groups.push_back({.id = group.id, .name = group.name});
    const auto curves = model::CurveSet::of(hair.frame(), options);
    Outlines outlines;
    std::ranges::transform(kSides, outlines.begin(),
                           [&](OutlineSide side) { return outlineOf(*on.head, *curves, side); });
    return outlines;
}

} // namespace

class TestStyleOutlines : public QObject
{
    Q_OBJECT
private:
    std::map<QString, Outlines> m_own;

private Q_SLOTS:
    void aStyleKeepsItsOutline_data();
    void aStyleKeepsItsOutline();
};

void TestStyleOutlines::aStyleKeepsItsOutline_data()
{
    QTest::addColumn<QString>("style");
    QTest::addColumn<QString>("head");
    const auto add = [](const QString& style, const QString& head) {
        QTest::newRow(qPrintable(style + QStringLiteral(", ") + head)) << style << head;
    };
    // HAIRPAINT_OUTLINE_HEADS: all styles on heads by name or file, with commas between; takes minutes.
    const QStringList heads =
        qEnvironmentVariable("HAIRPAINT_OUTLINE_HEADS").split(QLatin1Char(','), Qt::SkipEmptyParts);
    for (const model::PresetEntry& entry : model::listPresets({}))
        for (const QString& head : heads)
            add(entry.name, head);
    if (!heads.empty())
        return;
    // What falls over shoulders, stands off, or is tied.
    add(QStringLiteral("Hime cut"), QStringLiteral("former"));
    add(QStringLiteral("Two plaits"), QStringLiteral("child"));
    add(QStringLiteral("Liberty spikes"), QStringLiteral("child"));
    add(QStringLiteral("Box braids"), QStringLiteral("broad"));
    add(QStringLiteral("Curly bob"), QStringLiteral("scan"));
}

void TestStyleOutlines::aStyleKeepsItsOutline()
{
    QFETCH(QString, style);
    QFETCH(QString, head);
    const WornHead& own = wornHead(QStringLiteral("own"));
    const WornHead& other = wornHead(head);
    QVERIFY(other.head && other.head->landmarks);
    if (!m_own.contains(style))
        m_own.emplace(style, outlinesOn(own, style));
    const Outlines there = outlinesOn(other, style);
    const float lowest = lowestM(*other.head);
    QString found;
    bool keeps = true;
    for (std::size_t i = 0; i < kSides.size(); ++i) {
        const Overlap overlap = fittedOverlap(m_own.at(style)[i], there[i], lowest);
        found += QStringLiteral(" %1 (%2)").arg(overlap.all, 0, 'f', 2).arg(overlap.hair, 0, 'f', 2);
        keeps = keeps && overlap.all >= 0.85F;
    }
    qInfo("%s", qPrintable(found));
    QVERIFY2(keeps, qPrintable(found));
}

HAIRPAINT_TEST(TestStyleOutlines, Core)
#include "test_style_outlines.moc"
