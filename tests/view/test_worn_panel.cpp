// The look of what is worn, set in the panel.
#include "model/document/scene_commands.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"
#include "tests/view/panel_fixture.h"
#include "view/head_area/scene_light.h"
#include "view/panels/worn_panel.h"
#include "view/widgets/swatch.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QLabel>
#include <QUndoStack>

using namespace hairpaint;
using namespace hairpaint::view;

namespace {

/// Two balls and a collider; nothing is chosen, and no undo step is left.
struct WornPanelFixture : PanelFixture
{
    WornPanelFixture()
    {
        for (const model::WornKind kind : {model::WornKind::Ball, model::WornKind::Ellipsoid, model::WornKind::Ball})
            document.push(addWornCommand(document, makeWorn(model::wornSpec(kind), {})));
        document.undoStack().clear();
        panel.resize(260, 200);
        panel.show();
    }
    [[nodiscard]] const model::Worn& ball(std::size_t index) const { return document.project().worn.at(index + 1); }
    [[nodiscard]] QList<Swatch*> swatches() const
    {
        QList<Swatch*> shown;
        for (Swatch* swatch : panel.findChildren<Swatch*>())
            if (swatch->isCheckable() && !swatch->isHidden())
                shown.append(swatch);
        return shown;
    }
    [[nodiscard]] Swatch& colour() const { return *panel.findChild<Swatch*>(QStringLiteral("wornColour")); }
    [[nodiscard]] BarSlider& slider(const char* label) const { return *sliderNamed(panel, QString::fromLatin1(label)); }
    void choose(std::size_t index) { QTest::mouseClick(swatches().at(static_cast<qsizetype>(index)), Qt::LeftButton); }

    WornPanel panel{state};
};

} // namespace

class TestWornPanel : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void eachDrawnThingHasASwatch()
    {
        WornPanelFixture f;
        QCOMPARE(f.swatches().size(), 2);
        QVERIFY(!f.colour().isVisible()); // Nothing is chosen.
        f.choose(1);
        QCOMPARE(f.state.options().chosenWorn(), f.ball(1).id);
        QVERIFY(f.colour().isVisible() && f.swatches()[1]->isChecked() && !f.swatches()[0]->isChecked());
        QCOMPARE(f.panel.findChild<QLabel*>(QStringLiteral("wornName"))->text(), QStringLiteral("Ball"));
        f.choose(1);
        QVERIFY(f.swatches()[1]->isChecked());
        for (std::size_t i = 2; i-- > 0;)
            f.document.push(removeWornCommand(f.document, f.ball(i).id));
        QVERIFY(!f.panel.isVisible());
        f.document.undo();
        QVERIFY(f.panel.isVisible());
        QCOMPARE(f.swatches().size(), 1);
    }

    void aSliderIsOneStepOfTheChosenOne_data()
    {
        QTest::addColumn<QString>("label");
        QTest::addColumn<QString>("step");
        QTest::newRow("sheen") << QStringLiteral("Sheen") << QStringLiteral("Change look of ball");
        QTest::newRow("radius") << QStringLiteral("Radius") << QStringLiteral("Size ball");
    }
    void aSliderIsOneStepOfTheChosenOne()
    {
        QFETCH(QString, label);
        QFETCH(QString, step);
        WornPanelFixture f;
        const std::vector<model::Worn> before = f.document.committed().worn;
        f.choose(0);
        BarSlider& slider = f.slider(qPrintable(label));
        holdAt(slider, 0.25);
        QVERIFY(!(f.document.project().worn == before)); // Seen while it moves.
        QCOMPARE(f.steps(), 0);
        letGo(slider);
        QCOMPARE(f.steps(), 1);
        QCOMPARE(f.document.undoStack().text(0), step);
        QVERIFY(!(f.ball(0) == before[1]));
        QVERIFY(f.ball(1) == before[2]);
        const bool isLook = label == QStringLiteral("Sheen");
        QCOMPARE(f.ball(0).shape == before[1].shape, isLook);
        QCOMPARE(f.ball(0).sheen == before[1].sheen, !isLook);
        f.document.undo();
        QVERIFY(f.document.committed().worn == before);
    }

    void aColourIsSeenWhileItIsChosenAndKeptOrTakenBack_data()
    {
        QTest::addColumn<bool>("isKept");
        QTest::newRow("kept") << true;
        QTest::newRow("taken back") << false;
    }
    void aColourIsSeenWhileItIsChosenAndKeptOrTakenBack()
    {
        QFETCH(bool, isKept);
        const QColor blue(10, 20, 230);
        WornPanelFixture f;
        const std::vector<model::Worn> before = f.document.committed().worn;
        f.choose(1);
        QTest::mouseClick(&f.colour(), Qt::LeftButton);
        auto* dialog = f.panel.findChild<QColorDialog*>();
        QVERIFY(dialog != nullptr);
        dialog->setCurrentColor(blue);
        QCOMPARE(f.ball(1).colour, blue.rgb());
        // Which renderers draw it in, and how it shines.
        const std::vector<rendering::Solid> solids = sceneSolids(f.document.project().worn, nullptr);
        QVERIFY(solids.at(1).colour == linearColour(blue.rgb()) && solids.at(1).sheen == f.ball(1).sheen);
        isKept ? dialog->accept() : dialog->reject();
        QCOMPARE(f.steps(), isKept ? 1 : 0);
        QCOMPARE(f.ball(1).colour == blue.rgb(), isKept);
        if (isKept)
            f.document.undo();
        QVERIFY(f.document.committed().worn == before);
    }

    /// A solid for each of its materials, all of them in its colour.
    void anOwnMeshIsDrawnInItsMaterials()
    {
        auto texture = std::make_shared<const sim::MeshTexture>(
            sim::MeshTexture{.width = 1, .height = 1, .rgba = {255, 0, 0, 255}});
        auto own = std::make_shared<model::OwnMesh>();
        own->glb = "x";
        for (const bool isMasked : {false, true}) {
            model::OwnSurface& surface = own->surfaces.emplace_back();
            surface.part.mesh = std::make_shared<const sim::HeadMesh>(test::makeBallHead(8, 1.0F));
            surface.mirrored = surface.part.mesh;
            surface.part.colour = glm::vec3(1.0F, 0.5F, 0.25F);
            surface.part.texture = isMasked ? texture : nullptr;
            surface.part.alpha = isMasked ? sim::TextureAlpha::Blend : sim::TextureAlpha::Opaque;
        }
        std::vector<model::Worn> worn{{.kind = model::WornKind::Mesh, .colour = qRgb(0, 255, 255), .sheen = 0.3F}};
        worn.front().ownMesh.own = own;
        const std::vector<rendering::Solid> solids = sceneSolids(worn, nullptr);
        QCOMPARE(solids.size(), surfaceCount(worn.front()));
        for (std::size_t i = 0; i < solids.size(); ++i) {
            QVERIFY(solids[i].mesh == own->surfaces[i].part.mesh && solids[i].shape == worn.front().shape);
            QVERIFY(glm::distance(solids[i].colour, glm::vec3(0.0F, 0.5F, 0.25F)) < 1e-5F);
            QVERIFY(solids[i].sheen == 0.3F && solids[i].open);
            QVERIFY(solids[i].texture == own->surfaces[i].part.texture && solids[i].masked == (i == 1));
        }
    }

    void hairGoesThroughAnOwnMeshThatSaysSo()
    {
        WornPanelFixture f;
        f.document.push(addWornCommand(f.document, makeWorn(model::wornSpec(model::WornKind::Mesh), {})));
        f.document.undoStack().clear();
        auto* box = f.panel.findChild<QCheckBox*>(QStringLiteral("wornPassable"));
        f.choose(0);
        QVERIFY(!box->isVisible());
        f.choose(2);
        QVERIFY(box->isVisible() && !box->isChecked());
        const std::size_t before = f.document.groomInput().colliders.size();
        box->click();
        QCOMPARE(f.steps(), 1);
        QVERIFY(f.document.committed().worn.back().passable && box->isChecked());
        QCOMPARE(f.document.groomInput().colliders.size(), before - 1);
        f.document.undo();
        QVERIFY(!box->isChecked());
    }

    void aTieIsMadeOfWhatIsChosen()
    {
        WornPanelFixture f;
        f.document.push(addWornCommand(f.document, makeWorn(model::wornSpec(model::WornKind::Bun), {})));
        f.document.undoStack().clear();
        auto* box = f.panel.findChild<QComboBox*>(QStringLiteral("wornMake"));
        f.choose(0);
        QVERIFY(!box->isVisible() && !f.slider("Tightness").isVisible());
        f.choose(2);
        QVERIFY(box->isVisible() && f.slider("Tightness").isVisible() && f.slider("Bun radius").isVisible());
        QCOMPARE(box->count(), 4);
        const std::vector<model::Worn> before = f.document.committed().worn;
        QTest::keyClick(box, Qt::Key_End);
        QCOMPARE(f.steps(), 1);
        const model::Worn& bun = f.document.project().worn.back();
        QCOMPARE(static_cast<int>(bun.make), 3);
        QCOMPARE(bun.sheen, 1.0F); // It is of metal now.
        QVERIFY(sceneSolids(f.document.project().worn, nullptr).back().mesh !=
                sceneSolids(before, nullptr).back().mesh);
        for (const char* label : {"Tightness", "Bun radius", "Tie radius"}) {
            const model::Worn was = f.document.project().worn.back();
            holdAt(f.slider(label), 0.25);
            letGo(f.slider(label));
            QVERIFY(!(f.document.committed().worn.back() == was));
        }
        QCOMPARE(f.steps(), 4);
        for (int i = 0; i < 4; ++i)
            f.document.undo();
        QVERIFY(f.document.committed().worn == before);
    }
};

HAIRPAINT_TEST(TestWornPanel, Widgets)
#include "test_worn_panel.moc"
