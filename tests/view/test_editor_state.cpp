// What the user works with, whichever view changes it.
#include "model/document/commands.h"
#include "tests/support/test_program.h"
#include "tests/view/panel_fixture.h"

#include <QSignalSpy>
#include <QTest>

using namespace hairpaint;
using model::MapKind;

namespace {

struct Fixture : view::PanelFixture
{
    Fixture()
    {
        state.setActiveMap(MapKind::Length);
        setGreatestLength(0.3F);
        setLength(0.5F);
    }
    void setGreatestLength(float metres)
    {
        sim::GroupSettings settings = scalp().settings;
        settings.greatestLengthM = metres;
        document.push(setSettingsCommand(document, scalp().id, settings, QStringLiteral("Length")));
    }
    void setLength(float fraction)
    {
        model::ToolSettings settings = state.toolSettings();
        settings.value(MapKind::Length).scalar = fraction;
        state.setToolSettings(settings);
    }
    [[nodiscard]] float lengthM() const
    {
        const model::HairGroup* group = document.project().group(state.activeGroup());
        return state.toolSettings().value(MapKind::Length).scalar * group->settings.greatestLengthM;
    }
};

} // namespace

class TestEditorState : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aRangeThatChangesLeavesTheAmount_data()
    {
        QTest::addColumn<float>("greatestM");
        QTest::addColumn<float>("lengthM");
        QTest::newRow("half the range") << 0.15F << 0.15F;
        QTest::newRow("twice the range") << 0.6F << 0.15F;
        QTest::newRow("less than the amount") << 0.075F << 0.075F;
    }
    void aRangeThatChangesLeavesTheAmount()
    {
        QFETCH(float, greatestM);
        QFETCH(float, lengthM);
        Fixture f;
        QSignalSpy told(&f.state, &view::EditorState::told);
        f.setGreatestLength(greatestM);
        QVERIFY(std::abs(f.lengthM() - lengthM) < 1e-5F);
        QCOMPARE(told.count(), lengthM < 0.15F ? 1 : 0);
        f.document.undo();
        QVERIFY(std::abs(f.lengthM() - 0.15F) < 1e-5F);
    }

    void aStyleThatIsOnlyLookedAtLeavesTheAmountToo()
    {
        Fixture f;
        QSignalSpy told(&f.state, &view::EditorState::told);
        model::EditSession look;
        f.document.show(look, {.policy = model::EditPolicy::Drop}, {.aspect = model::Change::Aspect::GroupList},
                        [](model::Project& project) { project.groups.front().settings.greatestLengthM = 0.075F; });
        QVERIFY(std::abs(f.lengthM() - 0.075F) < 1e-5F);
        look.drop();
        QVERIFY(std::abs(f.lengthM() - 0.15F) < 1e-5F);
        QCOMPARE(told.count(), 0);
    }

    void swappingKeepsAmountsThatLieBeyondTheRange()
    {
        Fixture f;
        f.setGreatestLength(0.075F);
        for (int i = 0; i < 2; ++i) {
            model::ToolSettings settings = f.state.toolSettings();
            std::swap(settings.value(MapKind::Length), settings.secondValue(MapKind::Length));
            f.state.setToolSettings(settings);
        }
        f.setGreatestLength(0.6F);
        QVERIFY(std::abs(f.lengthM() - 0.15F) < 1e-5F);
    }

    void anotherGroupsRangeLeavesTheAmount()
    {
        Fixture f;
        f.state.setActiveGroup(f.document.project().groups[1].id);
        QVERIFY(std::abs(f.lengthM() - 0.15F) < 1e-5F);
        f.state.setActiveGroup(f.scalp().id);
        QVERIFY(std::abs(f.lengthM() - 0.15F) < 1e-5F);
    }

    void grabbingWithCtrlNeedsTheLengthLayer()
    {
        Fixture f;
        f.state.setActiveTool(model::ToolId::Grab);
        const model::MapStack& length = f.scalp().map(MapKind::Length);
        const model::LayerAddress at{.group = f.scalp().id, .map = MapKind::Length, .layer = length.layers[0].id};
        model::LayerProperties properties = propertiesOf(length.layers[0]);
        properties.locked = true;
        f.document.push(setLayerPropertiesCommand(f.document, at, properties, QStringLiteral("Lock")));
        QSignalSpy refused(&f.state, &view::EditorState::refused);
        model::ToolEvent event{.area = model::Area::Head, .uv = {0.5F, 0.5F}, .point = {}};
        f.state.press(event);
        QCOMPARE(refused.count(), 0);
        f.state.release(event);
        event.modifiers = Qt::ControlModifier;
        f.state.press(event);
        QCOMPARE(refused.count(), 1);
        QVERIFY(refused.last().front().toString().startsWith(QStringLiteral("Length: ")));
        QVERIFY(refused.last().front().toString().contains(QStringLiteral("locked")));
        QVERIFY(!f.state.stroking());
    }

    void aPartNeedsItsDensityLayerUnlessItLeavesNoGap()
    {
        Fixture f;
        const auto press = [&f] { f.state.press({.uv = {0.5F, 0.5F}, .point = {}}); };
        QSignalSpy refused(&f.state, &view::EditorState::refused);
        f.state.setActiveTool(model::ToolId::Part);
        press();
        QCOMPARE(refused.count(), 0);
        const model::MapStack& density = f.scalp().map(MapKind::Density);
        const model::LayerAddress at{.group = f.scalp().id, .map = MapKind::Density, .layer = density.layers[0].id};
        model::LayerProperties properties = propertiesOf(density.layers[0]);
        properties.locked = true;
        f.document.push(setLayerPropertiesCommand(f.document, at, properties, QStringLiteral("Lock")));
        press();
        QCOMPARE(refused.count(), 1);
        QVERIFY(refused.last().front().toString().startsWith(QStringLiteral("Density: ")));
        QVERIFY(refused.last().front().toString().contains(QStringLiteral("locked")));
        model::ToolSettings settings = f.state.toolSettings();
        settings.partGapM = 0.0F;
        f.state.setToolSettings(settings);
        press();
        QCOMPARE(refused.count(), 1);
        f.state.setActiveTool(model::ToolId::Comb);
        press();
        QCOMPARE(refused.count(), 1);
    }

    void theMapBeforeTheCombIsTheBrushsAgain()
    {
        Fixture f;
        f.state.setActiveMap(MapKind::Colour);
        f.state.setActiveTool(model::ToolId::Comb);
        QCOMPARE(f.state.activeMap(), MapKind::Direction);
        f.state.setActiveTool(model::ToolId::Part);
        f.state.setActiveTool(model::ToolId::Brush);
        QCOMPARE(f.state.activeMap(), MapKind::Colour);
        // Chosen while the comb is in hand: that is the one.
        f.state.setActiveTool(model::ToolId::Comb);
        f.state.setActiveMap(MapKind::Curl);
        f.state.setActiveTool(model::ToolId::Brush);
        QCOMPARE(f.state.activeMap(), MapKind::Curl);
        f.state.setActiveTool(model::ToolId::Comb);
        f.state.setActiveMap(MapKind::Direction);
        f.state.setActiveTool(model::ToolId::Brush);
        QCOMPARE(f.state.activeMap(), MapKind::Direction);
    }
};

HAIRPAINT_TEST(TestEditorState, Widgets)
#include "test_editor_state.moc"
