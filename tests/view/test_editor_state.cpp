// What the user works with, whichever view changes it.
#include "model/document/group_commands.h"
#include "model/document/layer_commands.h"
#include "model/files/project_file.h"
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
        state.target().setMap(MapKind::Length);
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
        model::ToolSettings settings = state.tools().settings();
        settings.value(MapKind::Length).scalar = fraction;
        state.tools().setSettings(settings);
    }
    [[nodiscard]] float lengthM() const
    {
        const model::HairGroup* group = document.project().group(state.target().group());
        return state.tools().settings().value(MapKind::Length).scalar * group->settings.greatestLengthM;
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

    /// Whatever comes last in it; a step of other maps shows the last of them.
    void anUndoneStepOfSeveralMapsLeavesTheOneThatIsShown_data()
    {
        QTest::addColumn<MapKind>("shown");
        QTest::addColumn<MapKind>("after");
        QTest::newRow("the first") << MapKind::Length << MapKind::Length;
        QTest::newRow("the last") << MapKind::Gel << MapKind::Gel;
        QTest::newRow("none") << MapKind::Density << MapKind::Gel;
    }
    void anUndoneStepOfSeveralMapsLeavesTheOneThatIsShown()
    {
        QFETCH(MapKind, shown);
        QFETCH(MapKind, after);
        model::Document document(model::newProject());
        view::EditTarget target(document);
        target.setMap(shown);
        const bool held = target.hold(true);
        model::EditSession edit = document.begin({.text = QStringLiteral("Two maps")});
        for (const MapKind map : {MapKind::Length, MapKind::Gel}) {
            const model::HairGroup& group = document.committed().groups.front();
            const model::Layer& layer = group.map(map).layers.front();
            sim::TiledRaster raster = layer.raster;
            raster.setTexel(3, 3, {1000, 65535, 0, 0});
            edit.previewTiles({group.id, map, layer.id}, {{0, raster.tile(0)}});
        }
        edit.commit();
        target.hold(held);
        QCOMPARE(document.undoStack().count(), 1);
        QCOMPARE(target.map(), shown);
        document.undo();
        QCOMPARE(target.map(), after);
        target.setMap(shown);
        document.redo();
        QCOMPARE(target.map(), after);
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
            model::ToolSettings settings = f.state.tools().settings();
            std::swap(settings.value(MapKind::Length), settings.secondValue(MapKind::Length));
            f.state.tools().setSettings(settings);
        }
        f.setGreatestLength(0.6F);
        QVERIFY(std::abs(f.lengthM() - 0.15F) < 1e-5F);
    }

    void anotherGroupsRangeLeavesTheAmount()
    {
        Fixture f;
        f.state.target().setGroup(f.document.project().groups[1].id);
        QVERIFY(std::abs(f.lengthM() - 0.15F) < 1e-5F);
        f.state.target().setGroup(f.scalp().id);
        QVERIFY(std::abs(f.lengthM() - 0.15F) < 1e-5F);
    }

    void grabbingWithCtrlNeedsTheLengthLayer()
    {
        Fixture f;
        f.state.tools().choose(model::ToolId::Grab);
        const model::MapStack& length = f.scalp().map(MapKind::Length);
        const model::LayerAddress at{.group = f.scalp().id, .map = MapKind::Length, .layer = length.layers[0].id};
        model::LayerProperties properties = propertiesOf(length.layers[0]);
        properties.locked = true;
        f.document.push(setLayerPropertiesCommand(f.document, at, properties, QStringLiteral("Lock")));
        QSignalSpy refused(&f.state, &view::EditorState::refused);
        model::ToolEvent event{.area = model::Area::Head, .uv = {0.5F, 0.5F}, .point = {}};
        f.state.tools().press(event);
        QCOMPARE(refused.count(), 0);
        f.state.tools().release(event);
        event.modifiers = Qt::ControlModifier;
        f.state.tools().press(event);
        QCOMPARE(refused.count(), 1);
        QVERIFY(refused.last().front().toString().startsWith(QStringLiteral("Length: ")));
        QVERIFY(refused.last().front().toString().contains(QStringLiteral("locked")));
        QVERIFY(!f.state.tools().stroking());
    }

    void aPartNeedsItsDensityLayerUnlessItLeavesNoGap()
    {
        Fixture f;
        const auto press = [&f] { f.state.tools().press({.uv = {0.5F, 0.5F}, .point = {}}); };
        QSignalSpy refused(&f.state, &view::EditorState::refused);
        f.state.tools().choose(model::ToolId::Part);
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
        model::ToolSettings settings = f.state.tools().settings();
        settings.partGapM = 0.0F;
        f.state.tools().setSettings(settings);
        press();
        QCOMPARE(refused.count(), 1);
        f.state.tools().choose(model::ToolId::Comb);
        press();
        QCOMPARE(refused.count(), 1);
    }

    void theMapBeforeTheCombIsTheBrushsAgain()
    {
        Fixture f;
        f.state.target().setMap(MapKind::Colour);
        f.state.tools().choose(model::ToolId::Comb);
        QCOMPARE(f.state.target().map(), MapKind::Direction);
        f.state.tools().choose(model::ToolId::Part);
        f.state.tools().choose(model::ToolId::Brush);
        QCOMPARE(f.state.target().map(), MapKind::Colour);
        // Chosen while the comb is in hand: that is the one.
        f.state.tools().choose(model::ToolId::Comb);
        f.state.target().setMap(MapKind::Curl);
        f.state.tools().choose(model::ToolId::Brush);
        QCOMPARE(f.state.target().map(), MapKind::Curl);
        f.state.tools().choose(model::ToolId::Comb);
        f.state.target().setMap(MapKind::Direction);
        f.state.tools().choose(model::ToolId::Brush);
        QCOMPARE(f.state.target().map(), MapKind::Direction);
    }
};

HAIRPAINT_TEST(TestEditorState, Widgets)
#include "test_editor_state.moc"
