// What the handles of a haircut do to the built-in styles, on the head that they were made on.
#include "model/files/head_file.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/handles/hair_handles.h"
#include "model/styles/style_use.h"
#include "sim/groom/direction_texel.h"
#include "sim/groom/strand_style.h"
#include "sim/skin/skin_frame.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <numbers>
#include <random>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

/// A new project with a style, and the handles of its scalp.
struct Styled
{
    Document document;
    const HairGroup base;
    HairHandles handles;

    explicit Styled(const QString& id)
        : document(wearing(id)), base(scalpOf(document.project())),
          handles(base, document.project().head, document.resolvedNow(base.id, MapKind::Density),
                  document.resolvedNow(base.id, MapKind::Direction))
    {}
    static Project wearing(const QString& id)
    {
        Project project = newProject();
        applyPreset(project, *loadPreset(QStringLiteral(":/presets/%1.hairpreset").arg(id)));
        return project;
    }
    static const HairGroup& scalpOf(const Project& project)
    {
        const auto grows = std::ranges::find_if(project.groups, [](const HairGroup& one) { return growsHair(one); });
        return grows != project.groups.end() ? *grows : project.groups.front();
    }
    [[nodiscard]] HandledHair with(HandleKind kind, double value)
    {
        HandleValues values;
        values[kind] = value;
        return handles.at(values);
    }
    [[nodiscard]] const sim::Skin& skin() const { return *document.project().head->skin; }
    [[nodiscard]] static float lengthM(const HandledHair& hair, glm::vec2 uv)
    {
        sim::GroupSettings settings;
        settings.greatestLengthM = hair.greatestLengthM;
        settings.shortestLengthM = hair.shortestLengthM;
        const auto texel = [&](float fraction) {
            return std::min(static_cast<int>(fraction * static_cast<float>(hair.length->size)), hair.length->size - 1);
        };
        const sim::Texel value = resolveTexel(*hair.length, texel(uv.x), texel(1.0F - uv.y));
        return sim::lengthOf(settings, static_cast<float>(value[0]) / 65535.0F);
    }
    [[nodiscard]] float lengthM(const HandledHair& hair, glm::vec3 positionHd) const
    {
        return lengthM(hair, skin().nearest(positionHd).uv);
    }
    /// As seen from the head's axis, outward.
    [[nodiscard]] glm::vec2 around(float degrees, float heightM) const
    {
        const float angle = degrees * std::numbers::pi_v<float> / 180.0F;
        return skin()
            .pick({.originHd = {0.0F, heightM, -0.01F}, .directionHd = {std::sin(angle), 0.0F, std::cos(angle)}})
            ->uv;
    }
    /// Hd, x of how hair beside the middle of the head is combed.
    [[nodiscard]] float aside(const HandledHair& hair, float leftM) const
    {
        const sim::SurfacePoint point = skin().nearest({leftM, 0.11F, 0.02F});
        const auto texel = [&](float fraction) {
            return static_cast<int>(fraction * static_cast<float>(hair.direction->size));
        };
        const sim::Texel value = resolveTexel(*hair.direction, texel(point.uv.x), texel(1.0F - point.uv.y));
        return sim::SkinFrame::at(point).toHd(sim::directionOf(value)).x;
    }
};

} // namespace

class TestHairHandles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void what_a_style_has_is_told_from_its_hair_data()
    {
        QTest::addColumn<bool>("fringe");
        QTest::addColumn<bool>("fade");
        QTest::addColumn<bool>("part");
        QTest::newRow("bob") << true << false << true;
        QTest::newRow("long-straight") << true << false << true;
        QTest::newRow("jaw-bob-with-fringe") << true << false << true;
        QTest::newRow("side-part") << true << true << true;
        QTest::newRow("quiff") << true << true << true;
        QTest::newRow("french-crop") << true << true << false;
        QTest::newRow("curly-top-with-fade") << true << true << true;
        QTest::newRow("line-up-fade") << false << true << false;
        QTest::newRow("high-top-fade") << false << true << false;
        QTest::newRow("liberty-spikes") << false << false << false;
        QTest::newRow("cornrows") << false << false << false;
        QTest::newRow("high-ponytail") << false << false << false;
        QTest::newRow("full-beard") << false << false << false;
    }
    void what_a_style_has_is_told_from_its_hair()
    {
        QFETCH(bool, fringe);
        QFETCH(bool, fade);
        QFETCH(bool, part);
        const Styled styled(QString::fromLatin1(QTest::currentDataTag()));
        QVERIFY(styled.handles.has(HandleKind::Length));
        QCOMPARE(styled.handles.has(HandleKind::Fringe), fringe);
        QCOMPARE(styled.handles.has(HandleKind::Fade), fade);
        QCOMPARE(styled.handles.has(HandleKind::Part), part);
    }

    void at_their_usual_values_the_hair_is_as_it_was()
    {
        Styled styled(QStringLiteral("side-part"));
        std::mt19937 random(20); // NOLINT(cert-msc51-cpp,cert-msc32-c)
        for (int i = 0; i < 5; ++i) {
            HandleValues values;
            for (const HandleSpec& spec : handleSpecs())
                values[spec.kind] = std::uniform_real_distribution(spec.least, spec.greatest)(random);
            const HandledHair made = styled.handles.at(values);
            QVERIFY(!(made == HandledHair::of(styled.base)));
            QVERIFY(made == styled.handles.at(values));
            QVERIFY(styled.handles.at({}) == HandledHair::of(styled.base));
        }
    }

    void all_hair_is_longer_by_the_factor()
    {
        Styled styled(QStringLiteral("bob"));
        const HandledHair before = HandledHair::of(styled.base);
        const HandledHair made = styled.with(HandleKind::Length, 1.5);
        for (const glm::vec3 rootHd : {glm::vec3(0.0F, 0.11F, 0.0F), glm::vec3(0.06F, 0.03F, 0.0F)})
            QVERIFY(std::abs(styled.lengthM(made, rootHd) - 1.5F * styled.lengthM(before, rootHd)) < 1e-4F);
        QVERIFY(made.length == before.length);
    }

    void a_fringe_changes_over_the_forehead_alone_data()
    {
        QTest::addColumn<QString>("style");
        QTest::addColumn<double>("factor");
        QTest::newRow("shorter") << QStringLiteral("jaw-bob-with-fringe") << 0.4;
        QTest::newRow("longer") << QStringLiteral("jaw-bob-with-fringe") << 1.4;
        QTest::newRow("longer than the range") << QStringLiteral("long-straight") << 2.0;
    }
    void a_fringe_changes_over_the_forehead_alone()
    {
        QFETCH(QString, style);
        QFETCH(double, factor);
        Styled styled(style);
        const HandledHair before = HandledHair::of(styled.base);
        const HandledHair made = styled.with(HandleKind::Fringe, factor);
        const glm::vec3 front(0.0F, 0.084F, 0.068F);
        const auto wanted = static_cast<float>(factor);
        QVERIFY(std::abs(styled.lengthM(made, front) / styled.lengthM(before, front) - wanted) < 0.01F);
        for (const glm::vec3 rootHd : {glm::vec3(0.0F, 0.11F, -0.02F), glm::vec3(0.07F, 0.03F, 0.0F),
                                       glm::vec3(-0.07F, 0.03F, 0.0F), glm::vec3(0.0F, 0.0F, -0.09F)})
            QVERIFY(std::abs(styled.lengthM(made, rootHd) - styled.lengthM(before, rootHd)) < 1e-4F);
    }

    void a_higher_fade_clips_more_and_leaves_the_top()
    {
        Styled styled(QStringLiteral("curly-top-with-fade"));
        const HandledHair before = HandledHair::of(styled.base);
        const HandledHair higher = styled.with(HandleKind::Fade, 0.02);
        const HandledHair lower = styled.with(HandleKind::Fade, -0.02);
        int rows = 0;
        for (const float degrees : {100.0F, 140.0F, 180.0F})
            for (const float heightM : {0.03F, 0.045F, 0.055F}) {
                const glm::vec2 uv = styled.around(degrees, heightM);
                const float wasM = Styled::lengthM(before, uv);
                QVERIFY(Styled::lengthM(higher, uv) < wasM);
                QVERIFY(Styled::lengthM(lower, uv) > wasM);
                // What stands 2 cm lower was so before.
                const float belowM = Styled::lengthM(before, styled.around(degrees, heightM - 0.02F));
                QVERIFY2(std::abs(Styled::lengthM(higher, uv) - belowM) < 0.0012F,
                         qPrintable(QString::number(1000.0F * (Styled::lengthM(higher, uv) - belowM))));
                ++rows;
            }
        QCOMPARE(rows, 9);
        for (const HandledHair& made : {higher, lower})
            for (const glm::vec3 rootHd : {glm::vec3(0.0F, 0.12F, -0.03F), glm::vec3(0.0F, 0.084F, 0.068F)})
                QVERIFY(std::abs(styled.lengthM(made, rootHd) - styled.lengthM(before, rootHd)) < 1e-4F);
    }

    void a_part_lies_where_it_is_wanted()
    {
        Styled styled(QStringLiteral("long-straight"));
        const auto value = [](PartSide side) { return static_cast<double>(side); };
        // Beside the middle hair falls away from the part: to the right of one that is at the left.
        const HandledHair left = styled.with(HandleKind::Part, value(PartSide::Left));
        QVERIFY(styled.aside(left, 0.012F) < -0.2F);
        QVERIFY(styled.aside(left, 0.05F) > 0.2F);
        const HandledHair right = styled.with(HandleKind::Part, value(PartSide::Right));
        QVERIFY(styled.aside(right, -0.012F) > 0.2F);
        QVERIFY(styled.aside(right, -0.05F) < -0.2F);
        const HandledHair middle = styled.with(HandleKind::Part, value(PartSide::Middle));
        QVERIFY(styled.aside(middle, 0.012F) > 0.2F);
        QVERIFY(styled.aside(middle, -0.012F) < -0.2F);
        QVERIFY(left.length == HandledHair::of(styled.base).length);
    }
};

HAIRPAINT_TEST(TestHairHandles, Core)
#include "test_hair_handles.moc"
